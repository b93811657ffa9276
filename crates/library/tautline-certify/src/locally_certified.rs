//! `LocallyCertified`: a metric with constants on balls that are proved from its formula.

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::{Constants, LocalError, LocallyBounded, Metric};
use tautline_scalar::{ANY, Scalar};

use crate::{
    Accuracy, CertifiedConstants, CertifyError, Domain, Watch, constants::recorded,
    progress::unwatched,
};

/// A metric whose constants on a ball are proved from its formula on demand. The competitors of a
/// computed line need only these constants, and the metric may have none on all of `R^D`.
///
/// The constants are within the tolerance of the best ones, or wider if the budget is spent first.
///
/// ```
/// use tautline_certify::{Accuracy, LocallyCertified};
/// use tautline_metrics::{LocallyBounded, gallery::Sphere};
///
/// let proved = LocallyCertified::new(Sphere, Accuracy::default());
/// let ball = proved.constants_within(&[0.0, 0.0].into(), 1.0)?;
/// assert!(ball.c1() <= 1.0 && ball.c1() > 0.998 && ball.c2() >= 4.0 && ball.c2() < 4.01);
/// # Ok::<(), tautline_metrics::LocalError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocallyCertified<M> {
    metric: M,
    accuracy: Accuracy,
}

impl<M> LocallyCertified<M> {
    /// Wraps a metric, and sets the accuracy of the constants on each ball.
    #[must_use]
    pub fn new(metric: M, accuracy: Accuracy) -> Self {
        Self { metric, accuracy }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        &self.metric
    }
}

impl<M: Metric<D>, const D: usize> Metric<D> for LocallyCertified<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.metric.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> LocallyBounded<D> for LocallyCertified<M> {
    /// # Errors
    ///
    /// Those of [`constants_within`].
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        LocalError::check_ball(centre.as_slice(), radius)?;
        let formula = recorded(&self.metric).map_err(|why| not_proved(radius, &why))?;
        constants_within(&formula, centre.as_slice(), radius, self.accuracy, &unwatched)
    }
}

/// Proves constants on a ball from the formula, in a dimension that is a value, and tells `watch` of the
/// progress.
///
/// # Errors
///
/// Those of [`LocalError::check_ball`], and [`LocalError::NotProved`] with the reason: the metric is undefined
/// or indefinite somewhere on the ball, or the budget was spent before `c₁` was known to be positive.
pub fn constants_within(
    formula: &Formula<ANY>,
    centre: &[f64],
    radius: f64,
    accuracy: Accuracy,
    watch: &dyn Watch,
) -> Result<Constants, LocalError> {
    LocalError::check_ball(centre, radius)?;
    let proved = Domain::ball(centre, radius).and_then(|ball| {
        CertifiedConstants::within_budget_by_formula(formula, &ball, accuracy, watch)?.constants()
    });
    // The constants hold only on the ball, even if the formula shows more.
    proved.map(Constants::on_a_region).map_err(|why| not_proved(radius, &why))
}

fn not_proved(radius: f64, why: &CertifyError) -> LocalError {
    let budget_spent = matches!(why, CertifyError::BudgetSpent { .. });
    LocalError::NotProved { radius, reason: why.to_string(), budget_spent }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_metrics::{
        LocalError, LocallyBounded,
        gallery::{GaussianFisher, Hyperbolic, Sphere},
    };

    use super::LocallyCertified;
    use crate::{
        Accuracy,
        testing::{Branch, parsed},
    };

    #[test]
    fn proved_constants_agree_with_closed_forms() {
        fn check(metric: impl LocallyBounded<2>, centre: [f64; 2], radius: f64) {
            let centre = centre.into();
            let accuracy = Accuracy { tolerance: 1e-2, budget: 200_000 };
            let known = metric.constants_within(&centre, radius).expect("closed form");
            let proved = LocallyCertified::new(metric, accuracy);
            let proved = proved.constants_within(&centre, radius).expect("proved");
            assert!(proved.is_local());
            // For balls off the origin, the closed forms may overestimate by more than the
            // tolerance.
            assert!(proved.c1() >= known.c1() * 0.99 && proved.c2() <= known.c2() * 1.01);
            assert!(proved.l_h() <= known.l_h() * 1.01, "{proved:?} {known:?}");
            let (Some(proved), Some(known)) = (proved.m_h(), known.m_h()) else { panic!("M_H") };
            assert!(proved <= known * 1.01, "{proved} {known}");
        }
        check(Sphere, [0.0, 0.0], 0.7);
        check(Sphere, [1.0, -0.5], 0.5);
        check(Hyperbolic, [0.2, 0.1], 0.5);
        check(GaussianFisher, [3.0, 0.5], 0.4);
    }

    /// The constants hold on all of the ball, not on a slightly smaller one.
    #[test]
    fn the_constants_hold_up_to_the_rim() {
        let (centre, accuracy) = (vector![0.0], Accuracy { tolerance: 1e-6, budget: 100_000 });
        let proved = LocallyCertified::new(Hyperbolic, accuracy).constants_within(&centre, 0.5);
        let (proved, known) = (proved.expect("proved"), Hyperbolic.constants_within(&centre, 0.5));
        let known = known.expect("closed form");
        let within = |small: f64, large: f64| small <= large && large <= small * (1.0 + 2e-6);
        assert!(within(known.c2(), proved.c2()) && within(known.l_h(), proved.l_h()));
        assert!(within(proved.c1(), known.c1()), "{proved:?} {known:?}");
    }

    /// The slope of the sphere vanishes at its pole and is positive one double farther. A point is
    /// a ball too, and it is the first ball that competitors need.
    #[test]
    fn a_point_has_constants() {
        let proved = LocallyCertified::new(Sphere, Accuracy::default());
        let pole = proved.constants_within(&vector![0.0, 0.0], 0.0).expect("proved");
        assert_eq!(pole.l_h(), 0.0);
        // H = 4 there, up to rounding.
        assert!(pole.c1() <= 4.0 && 4.0 <= pole.c2() && pole.c2() - pole.c1() < 1e-14, "{pole:?}");
    }

    #[test]
    fn a_ball_that_leaves_the_domain_has_no_constants() {
        let proved = LocallyCertified::new(Hyperbolic, Accuracy::default());
        let error = proved.constants_within(&vector![0.0, 0.0], 1.5).expect_err("it leaves");
        match error {
            LocalError::NotProved { radius: 1.5, reason, .. } => {
                assert!(reason.contains("may be undefined at"), "{reason}");
            }
            other => panic!("{other}"),
        }
        let error = proved.constants_within(&vector![0.0, 0.0], -1.0).expect_err("no radius");
        assert_eq!(error, LocalError::NotARadius { radius: -1.0 });
    }

    /// More boxes help where the budget was spent, and nowhere else.
    #[test]
    fn an_error_tells_whether_a_larger_budget_may_help() {
        // Its factor is at least 0.95, but intervals know less on a large box.
        let hollow = parsed::<2>("1.2 - x1*(1 - x1) I");
        let of = |centre: [f64; 2], radius, budget| {
            let accuracy = Accuracy { tolerance: 1e-3, budget };
            let hollow = LocallyCertified::new(hollow.clone(), accuracy);
            hollow.constants_within(&centre.into(), radius)
        };
        match of([0.5, 0.0], 1.0, 1) {
            Err(LocalError::NotProved { radius: 1.0, reason, budget_spent: true }) => {
                assert!(reason.contains("after 1 boxes"), "{reason}");
            }
            other => panic!("{other:?}"),
        }
        assert!(of([0.5, 0.0], 1.0, 100_000).is_ok());
        // A metric that is undefined, indefinite or not recorded stays so.
        let few = Accuracy { tolerance: 1e-3, budget: 10_000 };
        let left = LocallyCertified::new(Hyperbolic, few).constants_within(&vector![0.0, 0.0], 1.5);
        let pocket = LocallyCertified::new(parsed::<2>("x1 I"), few);
        let pocket = pocket.constants_within(&vector![0.0, 0.0], 1.0);
        let branch = LocallyCertified::new(Branch, few).constants_within(&vector![0.3], 0.1);
        for refused in [left, pocket, branch] {
            let is_final =
                matches!(refused, Err(LocalError::NotProved { budget_spent: false, .. }));
            assert!(is_final, "{refused:?}");
        }
    }

    /// Intervals would follow only one branch.
    #[test]
    fn a_formula_with_branches_has_no_constants() {
        let proved = LocallyCertified::new(Branch, Accuracy::default());
        match proved.constants_within(&vector![0.3], 0.1) {
            Err(LocalError::NotProved { radius: 0.1, reason, .. }) => {
                assert!(reason.contains("it has branches"), "{reason}");
            }
            other => panic!("{other:?}"),
        }
    }
}
