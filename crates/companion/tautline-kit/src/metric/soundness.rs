//! Checks whether a formula is sound, before problems are solved with it.

use nalgebra::SVector;
use tautline::{Bounded, check_gram};

use super::{
    Case,
    claims::{lipschitz, search},
    formula,
};
use crate::{
    Claim, Failure, Fault,
    report::{LawResult, Tried},
};

/// A value counts as grossly wrong if it exceeds both the claimed constant and the size of `H` over
/// the region by this factor.
const GROSS: f64 = 1e3;

/// The number of parts of each chord that are searched for a NaN.
const BETWEEN: u32 = 64;

/// A law of metrics.
type Law<const D: usize> = fn(&Case<'_, D>) -> LawResult;

impl<const D: usize> Case<'_, D> {
    /// Fails at once if a law of the formula fails. On a discontinuous metric the solver stalls for
    /// minutes, and the failures of statements would show nothing.
    ///
    /// Wrong constants do not make this check fail unless they are grossly wrong; the statements
    /// that rest on them report the error.
    pub(super) fn solvable(&self) -> Result<(), Failure> {
        let Some(law) = *self.solved.broken.get_or_init(|| self.broken()) else { return Ok(()) };
        Err(self.effort.failure(Fault::NotTried { law }))
    }

    /// Returns the name of a law of the formula that fails.
    fn broken(&self) -> Option<&'static str> {
        let laws: [(_, Law<D>); 6] = [
            ("is_finite_and_symmetric", formula::finite_and_symmetric),
            ("is_positive_definite", formula::positive_definite),
            ("jets_agree_with_differences", formula::jets),
            ("l_h_bounds_differences", continuous),
            ("c2_is_an_upper_bound", |case| case.bounded(Claim::C2)),
            ("l_h_bounds_the_derivative", |case| case.bounded(Claim::LH)),
        ];
        laws.into_iter().find_map(|(name, law)| law(self).is_err().then_some(name))
    }

    /// Fails if an ascent reaches a value a thousand times the claimed one, as it does at a pole.
    fn bounded(&self, claim: Claim) -> LawResult {
        let c2 = self.metric.constants().c2();
        let size = if claim == Claim::LH { c2 / self.region.size() } else { c2 };
        match search(self, claim) {
            Err(Failure { fault: Fault::Lie(lie), sample, seed })
                if !(lie.found <= GROSS * lie.claimed.max(size)) =>
            {
                Err(Failure { fault: lie.into(), sample, seed })
            }
            _ => Ok(Tried::cases(0)),
        }
    }

    /// If a side of the fault is NaN, replaces it by a fault of `H` at these points or on the
    /// chords between them, or otherwise by the law of the formula that fails.
    pub(super) fn explained(&self, fault: Fault, points: &[SVector<f64, D>]) -> Fault {
        if !fault.is_nan() {
            return fault;
        }
        let between = points.windows(2).flat_map(|ends| {
            let part = (ends[1] - ends[0]) / f64::from(BETWEEN);
            (1..BETWEEN).map(move |k| ends[0] + part * f64::from(k))
        });
        let mut all = points.iter().copied().chain(between);
        if let Some(error) = all.find_map(|x| check_gram(&self.metric, &x).err()) {
            return Fault::Metric(error);
        }
        // Only a quadrature met the NaN, or it lies next to a jump.
        self.solvable().map_or_else(|failure| failure.fault, |()| fault)
    }
}

/// Checks that `H` is continuous. By the mean value theorem, a bound on the derivatives also bounds
/// the difference quotients. So if a difference quotient beyond `L_H` was found, but no derivative
/// beyond it, then `H` jumps.
fn continuous<const D: usize>(case: &Case<'_, D>) -> LawResult {
    lipschitz(case).or_else(|failure| match search(case, Claim::LH) {
        Ok(_) => Err(failure),
        Err(_) => Ok(Tried::cases(0)),
    })
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline::{Constants, Metric, MetricError, Scalar};
    use tautline_statements::{Inequality, Source, Statement, Unit, WithConstants};

    use crate::{Effort, Fault, MetricCase, Region, metric};

    /// `H = 3 + sin x₂` plus a jump by `½` at `x₁ = 1`, plus `0 · √(x₁ − 1)`, or plus a pole at
    /// `x₁ = 1`.
    #[derive(Clone, Copy, PartialEq)]
    enum Odd {
        Jump,
        Domain,
        Pole,
        Neither,
    }

    impl Metric<2> for Odd {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let t = x[0] - 1.0;
            let more = match self {
                Odd::Jump => t / t.sqr().sqrt() * 0.25,
                Odd::Domain => t.sqrt() * 0.0,
                Odd::Pole => t.sqr().recip() * 1e-3,
                Odd::Neither => S::constant(0.0),
            };
            SMatrix::from_diagonal_element(more + x[1].sin() + 3.0)
        }
    }

    fn case(metric: Odd) -> MetricCase<WithConstants<Odd>, 2> {
        let constants = Constants::new(1.75, 4.25, 1.0).expect("c1 ≤ c2");
        let region = Region::cell([-3.0, -3.0], [3.0, 3.0]);
        MetricCase::new(WithConstants { metric, constants }, region, Effort::default())
    }

    #[test]
    fn nothing_is_solved_for_a_metric_that_jumps_or_is_not_finite() {
        for (odd, law) in [
            (Odd::Jump, "l_h_bounds_differences"),
            (Odd::Domain, "is_finite_and_symmetric"),
            (Odd::Pole, "c2_is_an_upper_bound"),
        ] {
            let case = case(odd);
            for outcome in [metric::theorem_1_3(&case), metric::left_rule_has_order_1(&case)] {
                let failure = outcome.failure.expect("it fails");
                assert_eq!(failure.fault, Fault::NotTried { law });
                assert_eq!(failure.fault.to_string(), format!("not tried: {law} fails"));
            }
        }
        assert_eq!(case(Odd::Neither).erased().solvable(), Ok(()));
        // The derivative of a jump is 0 on either side of it.
        assert!(metric::l_h_bounds_the_derivative(&case(Odd::Jump)).holds());
    }

    #[test]
    fn a_nan_is_explained_by_the_entry_and_the_point() {
        let fault = |observed| Fault::Statement {
            statement: Statement::Theorem1_1,
            hypothesis: false,
            inequality: Inequality {
                claim: "a ≤ b",
                source: Source::Stated,
                unit: Unit::ENERGY,
                observed,
                bound: 1.0,
                granted: 0.0,
            },
        };
        let points = [vector![1.5, 0.0], vector![0.0, 0.5], vector![2.0, 0.0]];
        let case = case(Odd::Domain);
        let case = case.erased();
        let Fault::Metric(MetricError::NotFinite { point, row: 0, column: 0, .. }) =
            case.explained(fault(f64::NAN), &points)
        else {
            panic!("an entry")
        };
        assert_eq!(point, [0.0, 0.5]);
        let chord = [vector![1.5, 0.0], vector![1.5, 0.5]];
        let law = "is_finite_and_symmetric";
        assert_eq!(case.explained(fault(f64::NAN), &chord), Fault::NotTried { law });
        assert_eq!(case.explained(fault(2.0), &points), fault(2.0));
    }
}
