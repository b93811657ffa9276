//! `Verdict`: what a certificate proves, in words.

use std::fmt::{self, Display, Formatter};

use tautline_scalar::{Interval, decimal::up_to};

use crate::{AnyCertificate, Certificate, CheckError, Proved};

/// What a certificate proves, whatever its dimension.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Verdict {
    /// The metric, the sets, and the length below which curves were followed, as in the file.
    pub statement: String,
    /// A lower bound on the distance, in `m`.
    pub lower: f64,
    /// An upper bound on the length of the curve, in `m`, if there is one.
    pub upper: Option<f64>,
    /// `(upper − lower)/upper`.
    pub gap: Option<f64>,
    /// `H ≥ c₁ I`, if that is a hypothesis and not proved.
    pub declared: Option<f64>,
    /// The number of cubes of the corridor, and their side, in `ℓ`.
    pub corridor: (usize, f64),
    /// For each level, the number of cubes and the lower bound so far.
    pub levels: Vec<(usize, f64)>,
}

impl<const D: usize> Certificate<D> {
    /// Returns what was proved of this certificate, in words.
    #[must_use]
    pub fn verdict(&self, proved: &Proved<D>) -> Verdict {
        Verdict {
            statement: self.statement(),
            lower: proved.lower,
            upper: proved.upper,
            gap: proved.gap(),
            declared: proved.declared,
            corridor: (proved.corridor.places().len(), proved.corridor.side()),
            levels: proved.levels.clone(),
        }
    }

    fn judged(&self, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Verdict, CheckError> {
        Ok(self.verdict(&self.check_while(go_on)?))
    }
}

impl AnyCertificate {
    /// Proves what the certificate claims, like [`Certificate::check`].
    ///
    /// # Errors
    ///
    /// As for [`Certificate::check`].
    pub fn check(&self) -> Result<Verdict, CheckError> {
        self.check_while(&|| true)
    }

    /// Does the same as long as `go_on`, which is often asked, returns true.
    ///
    /// # Errors
    ///
    /// As for [`Certificate::check_while`].
    pub fn check_while(&self, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Verdict, CheckError> {
        match self {
            Self::Line(certificate) => certificate.judged(go_on),
            Self::Plane(certificate) => certificate.judged(go_on),
            Self::Space(certificate) => certificate.judged(go_on),
            Self::Four(certificate) => certificate.judged(go_on),
        }
    }
}

impl Display for Verdict {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let lower = not_above(self.lower);
        writeln!(f, "lower bound  {lower:.17e}  no curve between the sets is shorter")?;
        if let Some(upper) = self.upper {
            writeln!(f, "upper bound  {:.17e}  the length of the curve", not_below(upper))?;
            let gap = match upper {
                0.0 => 0.0,
                _ => ((Interval::point(upper) - self.lower) / Interval::point(upper)).hi(),
            };
            let gap = up_to(gap, 3);
            writeln!(f, "gap          {gap}  (upper - lower)/upper")?;
            let (cubes, side) = self.corridor;
            writeln!(f, "corridor     {cubes} cubes of side {side:e} hold every shortest curve")?;
        }
        if let Some(c1) = self.declared {
            writeln!(f, "hypothesis   H >= {c1:e} I everywhere, declared and not proved")?;
        }
        writeln!(f, "hypotheses   the formula is the one that is meant; numbers are binary values")
    }
}

/// Returns a number that is at most `x` when it is rounded to 18 digits: a double is farther from the
/// next one than these digits can be from it.
fn not_above(x: f64) -> f64 {
    if x > 0.0 { x.next_down() } else { x }
}

/// Returns a number that is at least `x` when it is rounded to 18 digits.
fn not_below(x: f64) -> f64 {
    if x > 0.0 { x.next_up() } else { x }
}

#[cfg(test)]
mod tests {
    use super::Verdict;

    /// All digits of `1 + 2⁻¹⁹` are 1.0000019073486328125, and 18 of them are less.
    #[test]
    fn printed_bounds_are_bounds() {
        let exact = 1.0 + 0.5_f64.powi(19);
        let verdict = Verdict {
            statement: String::new(),
            lower: exact,
            upper: Some(exact),
            gap: Some(0.0),
            declared: None,
            corridor: (1, 0.5),
            levels: Vec::new(),
        };
        let text = verdict.to_string();
        let number = |line: &str| line.split_whitespace().nth(2).expect("a number").to_owned();
        let [lower, upper] = [0, 1].map(|n| number(text.lines().nth(n).expect("a line")));
        // Decimals of equal length are in the order of their digits.
        assert!(lower.as_str() < "1.0000019073486328125", "{lower}");
        assert!(upper.as_str() > "1.0000019073486328125", "{upper}");
        assert!(lower.starts_with("1.00000190734863") && upper.starts_with("1.00000190734863"));
        assert!(text.contains("\ngap          0.00e0  "), "{text}");
    }

    /// To nearest it would be 1.23e-4, less than the gap.
    #[test]
    fn a_printed_gap_is_rounded_up() {
        let verdict = Verdict {
            statement: String::new(),
            lower: 1.0 - 1.234e-4,
            upper: Some(1.0),
            gap: Some(1.234e-4),
            declared: None,
            corridor: (1, 0.5),
            levels: Vec::new(),
        };
        assert!(verdict.to_string().contains("\ngap          1.24e-4  "), "{verdict}");
    }
}
