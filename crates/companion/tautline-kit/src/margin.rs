//! `Margin`: how close one sample comes to violating a law.

/// How close a sample comes to violating a law, and the hypotheses that were assumed for it.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Margin {
    /// The overestimation; NaN if the sample could not have violated the law.
    pub(crate) overestimation: f64,
    /// The hypotheses that were assumed without a check, each listed once.
    pub(crate) assumed: Vec<&'static str>,
}

/// The overestimation of a sample that could not have violated the law.
pub(crate) const IDLE: f64 = f64::NAN;

impl Margin {
    /// Returns the margin of a sample that could not have violated the law.
    pub(crate) fn idle() -> Self {
        IDLE.into()
    }

    /// Returns whether the sample could not have violated the law.
    pub(crate) fn is_idle(&self) -> bool {
        self.overestimation.is_nan()
    }

    /// Combines two margins of one sample: takes the smaller overestimation, and the hypotheses of
    /// both.
    pub(crate) fn and(mut self, other: Self) -> Self {
        merge(&mut self.assumed, &other.assumed);
        // `min` prefers a number to NaN, because a sample can violate the law if one of its parts
        // can.
        Self { overestimation: self.overestimation.min(other.overestimation), ..self }
    }
}

impl From<f64> for Margin {
    /// Makes a margin that rests on no assumption.
    fn from(overestimation: f64) -> Self {
        Self { overestimation, assumed: Vec::new() }
    }
}

/// Appends the entries that are missing, in order.
pub(crate) fn merge(all: &mut Vec<&'static str>, more: &[&'static str]) {
    for claim in more {
        if !all.contains(claim) {
            all.push(claim);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{IDLE, Margin};

    #[test]
    fn combined_margins_keep_the_smaller_overestimation_and_all_assumptions() {
        let margin = |overestimation, assumed: &[&'static str]| Margin {
            overestimation,
            assumed: assumed.to_vec(),
        };
        let both = margin(3.0, &["a", "b"]).and(margin(2.0, &["b", "c"]));
        assert_eq!(both, margin(2.0, &["a", "b", "c"]));
        for (one, other) in [(IDLE, 2.0), (2.0, IDLE)] {
            assert_eq!(Margin::from(one).and(other.into()), 2.0.into());
        }
        assert!(Margin::idle().and(IDLE.into()).is_idle());
    }
}
