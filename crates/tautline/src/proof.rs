//! `Proof`: bounds on `d²` that follow from the formula of the metric alone.

use std::{ops::ControlFlow, sync::Arc};

use tautline_bounds::{
    BoundError, Constants, DiscreteMinimum, Enclosure, LocalityError, PaperRule,
};
use tautline_certify::{
    Accuracy, AdmissibleCurve, CertifiedConstants, CertifyError, CurveError, Domain,
    LocallyCertified, Progress, Watch,
};
use tautline_distance::Found;
use tautline_formula::Prepared;
use tautline_metrics::{LocalError, LocallyBounded, Metric};
use tautline_sets::Ball;

use crate::{RuleOfThePaper, SMatrix, SVector, Scalar, TautLine, certificate::Extent};

/// Bounds on `d²` that are proved from the formula of the metric.
#[derive(Clone, Debug)]
pub struct Proof<'a, const D: usize> {
    /// A curve from set to set, with rigorous bounds on its energy and length.
    pub curve: AdmissibleCurve<'a, D>,
    /// The constants, proved from the formula.
    pub constants: Constants,
    /// The region where the constants hold; `None` if it is all of `R^D`.
    pub within: Option<Ball<D>>,
    /// The bounds on `d²`. The upper bound is the rigorous bound on the curve.
    /// [`from_below`](Enclosure::from_below) says where the lower one is from. That of a certificate
    /// is rigorous. That of a theorem has rigorous constants and a rigorous length, but it is
    /// evaluated in doubles with the discrete energy and its residual, so that its last digits are
    /// not certified. Neither bound uses a quadrature.
    pub enclosure: Enclosure,
    /// The certificate, where the theorems would assume that the minimum is global; `None` if they
    /// assume nothing, or if there is no certificate.
    pub found: Option<Found<D>>,
}

/// The reason why a line has no proof.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProofError {
    /// The curve is not proved to join the sets, or it leaves the domain of the metric.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// The metric has no constants on all of `R^D`.
    #[error(transparent)]
    Constants(#[from] CertifyError),
    /// The metric has no constants on any ball that contains all competitors.
    #[error(transparent)]
    Competitors(#[from] LocalityError<LocalError>),
    /// The theorems do not apply.
    #[error(transparent)]
    Bound(#[from] BoundError),
}

impl<M: Metric<D>, R: RuleOfThePaper, const D: usize> TautLine<M, R, D> {
    /// Returns a curve that certainly joins the two sets, with rigorous bounds on its energy and
    /// its length. They bound `d²` from above.
    ///
    /// # Errors
    ///
    /// [`CurveError`] if a set of your own does not implement
    /// [`ClosedSet::member_near`](crate::ClosedSet::member_near), if the metric is undefined on the
    /// curve, or if its formula cannot be recorded.
    pub fn admissible_curve(&self) -> Result<AdmissibleCurve<'_, D>, CurveError> {
        AdmissibleCurve::new(self.metric(), self.sequence(), self.ends())
    }

    /// Returns bounds on `d²`, in `m²`, like [`enclosure`](TautLine::enclosure), from the formula
    /// of the metric alone. The constants are proved on all of `R^D` if the formula is periodic.
    /// Otherwise they are proved on a ball that contains all [competitors](TautLine::competitors).
    /// If the budget is spent before a constant is as close as wanted, a wider one serves. `M_H` is
    /// proved only where it can make the bounds closer; without a bound on it, those theorems count
    /// that do not need it.
    ///
    /// Where the theorems would assume that the minimum found is the global one, a
    /// [certificate](TautLine::certificate) is searched for instead, with about the same gap. The
    /// enclosure has its lower bound, which assumes nothing: if this line is not the shortest, the
    /// distance is in the enclosure all the same. Only where there is no certificate,
    /// [`Enclosure::assumes_global_minimum`] may be set. The search takes up to two seconds in the plane,
    /// for a gap of 10⁻³ or down to 10⁻⁴, and some seconds for 10⁻² in space: ask for a smaller one by
    /// [`certificate`](TautLine::certificate).
    ///
    /// ```
    /// use tautline::{Ends, Metric, Problem, SMatrix, SVector, Scalar, Trapezoidal, certify};
    ///
    /// struct Dent; // (1 + e^{−|x|²})² I, without constants
    /// impl Metric<2> for Dent {
    ///     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
    ///         let square = x[0].sqr() + x[1].sqr();
    ///         SMatrix::from_diagonal_element(((-square).exp() + 1.0).sqr())
    ///     }
    /// }
    ///
    /// let ends = Ends::points([-0.5, 0.2], [0.5, 0.2])?;
    /// let line = Problem::new(Dent, ends).solve(Trapezoidal, 512)?;
    /// let proof = line.prove(certify::Accuracy::default())?;
    /// let d_squared = proof.enclosure;
    /// assert!(d_squared.width() < 1e-2 * d_squared.upper && proof.within.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ProofError`], which names the missing part. A formula that cannot be
    /// [recorded](tautline_formula::Formula::record) has no proof.
    pub fn prove(&self, accuracy: Accuracy) -> Result<Proof<'_, D>, ProofError> {
        let go_on = &mut |_| ControlFlow::Continue(());
        self.prove_watched(accuracy, &|_: Progress| true, go_on)
    }

    /// Does the same as [`prove`](TautLine::prove), and tells `watch` of the progress of each search
    /// for a constant, and `observe` of every level of a certificate. If one of them ends a search,
    /// what was found so far serves.
    ///
    /// # Errors
    ///
    /// Those of [`prove`](TautLine::prove).
    pub fn prove_watched(
        &self,
        accuracy: Accuracy,
        watch: &dyn Watch,
        observe: &mut dyn FnMut(tautline_distance::Progress) -> ControlFlow<()>,
    ) -> Result<Proof<'_, D>, ProofError> {
        let accuracy = accuracy.checked()?;
        let curve = self.admissible_curve()?;
        let extent = Extent {
            energy: curve.energy().hi(),
            energy_at_least: curve.energy().lo(),
            length: curve.length().hi(),
            length_squared: curve.distance_squared_at_most(),
        };
        // The left-endpoint rule needs M_H only to prove a minimum between two points global.
        let m_h = R::OF_THE_PAPER == PaperRule::Trapezoidal || self.ends().are_points();
        let watch = Needed { m_h, watch };
        let space = Domain::space(self.metric());
        let (constants, within) = if space.is_one_period() {
            let metric = self.metric();
            let proved =
                CertifiedConstants::within_budget_watched(metric, &space, accuracy, &watch)?;
            (proved.constants()?, None)
        } else {
            // Constants on a ball are closer than those on all of space, if there are any.
            let proved = LocallyCertified::new(self.metric(), accuracy);
            let metric = Arc::new(Prepared::new(Watched { proved, watch }));
            let (ends, minimum) = (self.ends().clone(), self.minimum().clone());
            let line = TautLine::new(metric, self.rule(), ends, minimum);
            let competitors = line.competitors_by(extent)?;
            competitors.hold_those_of(&line, extent)?;
            (competitors.constants, Some(competitors.within))
        };
        let mut enclosure = self.enclosure_by(constants, extent)?;
        let found = self.instead_of_an_assumption(&enclosure, observe);
        if let Some(found) = &found {
            let is_not_global = enclosure.is_not_global;
            let without =
                self.enclosure_unless_convex(constants, extent, DiscreteMinimum::Unknown)?;
            // The square may be rounded up to the next double.
            let least = (found.proved.lower * found.proved.lower).next_down();
            enclosure = Enclosure { is_not_global, ..without.with_certificate(least)? };
        }
        Ok(Proof { curve, constants, within, enclosure, found })
    }
}

/// Watches the searches for those constants that are needed.
struct Needed<'w> {
    m_h: bool,
    watch: &'w dyn Watch,
}

impl Watch for Needed<'_> {
    fn goes_on(&self, progress: Progress) -> bool {
        self.watch.goes_on(progress)
    }

    fn needs_m_h(&self) -> bool {
        self.m_h && self.watch.needs_m_h()
    }
}

/// A metric whose constants on balls are proved by searches that are watched.
struct Watched<'w, M> {
    proved: LocallyCertified<M>,
    watch: Needed<'w>,
}

impl<M: Metric<D>, const D: usize> Metric<D> for Watched<'_, M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        self.proved.gram(x)
    }
}

impl<M: Metric<D>, const D: usize> LocallyBounded<D> for Watched<'_, M> {
    fn constants_within(
        &self,
        centre: &SVector<f64, D>,
        radius: f64,
    ) -> Result<Constants, LocalError> {
        self.proved.constants_within_watched(centre, radius, &self.watch)
    }
}

#[cfg(test)]
mod tests {
    use std::{ops::ControlFlow, sync::Mutex};

    use tautline_bounds::LocalityError;
    use tautline_certify::{Accuracy, CurveError, Progress, Quantity};
    use tautline_formula::RecordError;
    use tautline_metrics::gallery::{GaussianFisher, Hyperbolic, Shear, Sphere, Valleys};
    use tautline_metrics::{Bounded, KnownDistance, LocalError, Metric};
    use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace};

    use super::ProofError;
    use crate::{
        Interval, LeftEndpoint, Problem, RuleOfThePaper, SMatrix, SVector, Scalar, Trapezoidal,
    };

    /// Every known distance lies between the bounds.
    #[test]
    fn distances_are_enclosed_by_the_formula_alone() {
        fn check<M: KnownDistance<2>>(metric: M, a: [f64; 2], b: [f64; 2], width: f64) {
            let d = metric.distance(&a.into(), &b.into()).expect("known");
            let ends = Ends::points(a, b).expect("finite");
            let line = Problem::new(metric, ends).solve(Trapezoidal, 256).expect("solved");
            let proof = line.prove(Accuracy::default()).expect("proved");
            let (lower, upper) = (proof.enclosure.lower, proof.enclosure.upper);
            assert!(lower <= d * d && d * d <= upper, "{lower} {} {upper}", d * d);
            assert!(upper - lower <= width * d * d, "{lower} {upper}");
            assert!(!proof.enclosure.assumes_global_minimum);
            assert_eq!(proof.constants.is_local(), proof.within.is_some());
            assert_eq!(upper, proof.curve.distance_squared_at_most());
        }
        let shear = Shear::new(0.3, 1.0).expect("a wave number");
        check(shear, [0.0, 0.0], [0.3, 0.2], 1e-2);
        check(Sphere, [0.3, 0.1], [0.45, 0.2], 1e-2);
        check(Hyperbolic, [0.1, 0.0], [0.15, 0.1], 1e-2);
        check(GaussianFisher, [0.0, 0.0], [0.1, 0.1], 1e-2);
    }

    /// The upper bound agrees with a quadrature, which is not rigorous.
    #[test]
    fn the_upper_bound_is_that_of_the_curve() {
        let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
        let ends = Ends::new(ball, wall).expect("bounded");
        let line = Problem::new(Valleys, ends).solve(Trapezoidal, 64).expect("solved");
        let proof = line.prove(Accuracy::default()).expect("proved");
        let length = line.length().value;
        assert!((proof.enclosure.upper / (length * length) - 1.0).abs() < 1e-12);
        assert_eq!(proof.enclosure.upper, proof.curve.distance_squared_at_most());
        let stated = Bounded::<2>::constants(&Valleys);
        assert!(proof.constants.l_h() >= stated.l_h() && proof.within.is_none());
        assert!(line.admissible_curve().is_ok_and(|curve| curve.length().contains(length)));
    }

    /// The line runs from the pole of the sphere, where the derivative vanishes, to a wall. The
    /// ball is centred at the pole.
    #[test]
    fn a_line_from_a_point_where_the_derivative_vanishes_is_proved() {
        let pole = Ball::new([0.0, 0.0], 0.0).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.0], 0.1).expect("a normal");
        let ends = Ends::new(pole, wall).expect("bounded");
        let line = Problem::new(Sphere, ends).solve(Trapezoidal, 64).expect("solved");
        let proof = line.prove(Accuracy::default()).expect("proved");
        let (lower, upper) = (proof.enclosure.lower, proof.enclosure.upper);
        // H = 4 / (1 + |x|²)², so d = 2 arctan 0.1, attained by the straight line along x₁.
        let square = (2.0 * 0.1_f64.atan()).powi(2);
        assert!(lower <= square && square <= upper, "{lower} {square} {upper}");
        assert!(proof.within.is_some() && proof.enclosure.is_local);
    }

    /// The nodes of two chords lie in valleys, with ridges between them, so that the discrete
    /// energy is a quarter of the squared length. A competitor may be as long as the curve.
    #[test]
    fn the_ball_reaches_as_far_as_the_curve_is_long() {
        struct Ridges;
        impl Metric<1> for Ridges {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                let ridges = (x[0] * (4.0 * std::f64::consts::PI)).cos() + 2.0;
                // The metric is not periodic, and therefore has constants on balls only.
                SMatrix::from_element(ridges.sqr() + x[0].sqr() * 1e-3)
            }
        }
        let ends = Ends::points([0.0], [1.0]).expect("finite");
        let line = Problem::new(Ridges, ends).solve(Trapezoidal, 2).expect("solved");
        let proof = line.prove(Accuracy::default()).expect("proved");
        let ball = proof.within.expect("no constants on all of space");
        let length = proof.curve.length().hi();
        assert!(line.discrete_energy() < 0.3 * length * length);
        assert!(ball.r() >= length / proof.constants.c1().sqrt(), "{ball:?} for {length}");
        assert_eq!(proof.enclosure.upper, proof.curve.distance_squared_at_most());
    }

    /// The set knows its point only to within 1/20. Every claim holds for the longest possible
    /// curve.
    #[test]
    fn the_longest_possible_curve_counts() {
        #[derive(Debug)]
        struct About(SVector<f64, 2>);
        impl ClosedSet<2> for About {
            fn project(&self, _: &SVector<f64, 2>) -> SVector<f64, 2> {
                self.0
            }
            fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
                SMatrix::zeros()
            }
            fn radius(&self) -> Option<f64> {
                Some(self.0.norm())
            }
            fn enclosing_ball(&self) -> Option<(SVector<f64, 2>, f64)> {
                Some((self.0, 0.0))
            }
            fn member_near(&self, _: &SVector<f64, 2>) -> Option<SVector<Interval, 2>> {
                Some(self.0.map(|c| Interval::new(c - 0.05, c + 0.05).expect("in order")))
            }
        }
        let points = [[0.3, 0.1], [0.45, 0.1]].map(|x| About(x.into()));
        let [first, second] = points;
        let ends = Ends::new(first, second).expect("bounded");
        let line = Problem::new(Sphere, ends).solve(Trapezoidal, 16).expect("solved");
        let proof = line.prove(Accuracy::default()).expect("proved");
        let length = proof.curve.length();
        assert!(length.hi() > 1.5 * length.lo() && length.contains(line.length().value));
        let upper = proof.enclosure.upper;
        assert!(upper >= length.hi() * length.hi() * (1.0 - 1e-15));
        let ball = proof.within.expect("no constants on all of space");
        let half = 0.5 * length.hi() / proof.constants.c1().sqrt();
        assert!(ball.r() >= half, "{ball:?} for {length:?}");
    }

    #[test]
    fn an_impossible_proof_is_an_error() {
        let ends = Ends::points([0.1, 0.0], [0.2, 0.1]).expect("finite");
        let near = Problem::new(Sphere, ends).solve(Trapezoidal, 8).expect("solved");
        let error =
            near.prove(Accuracy { budget: 0, ..Accuracy::default() }).expect_err("no boxes");
        assert!(error.to_string().contains("after 0 boxes"), "{error}");
        let error =
            near.prove(Accuracy { tolerance: 0.0, ..Accuracy::default() }).expect_err("exact");
        assert!(error.to_string().contains("tolerance of 0"), "{error}");
        // Across the sphere, competitors may pass through infinity.
        let ends = Ends::points([1.0, 0.0], [-1.5, 0.3]).expect("finite");
        let line = Problem::new(Sphere, ends).solve(Trapezoidal, 64).expect("solved");
        let accuracy = Accuracy { budget: 2_000, ..Accuracy::default() };
        let error = line.prove(accuracy).expect_err("no ball");
        let expected = matches!(
            error,
            ProofError::Competitors(
                LocalityError::Escapes { .. }
                    | LocalityError::NoConstants { reason: LocalError::NotProved { .. }, .. }
            )
        );
        assert!(expected, "{error}");
        // This line leaves the domain of the metric.
        struct Left;
        impl Metric<1> for Left {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                // Within 0.0006 of 0.1 this is the logarithm of a negative number. From 0.006 on it
                // is 1 up to rounding. Nodes and quadrature points stay 0.04 away.
                let dip = 1.5 * (-((x[0] - 0.1) * 1e3).sqr()).exp();
                SMatrix::from_element(1.0 + (1.0 - dip).ln())
            }
        }
        let ends = Ends::points([0.0], [1.0]).expect("finite");
        let line = Problem::new(Left, ends).solve(Trapezoidal, 2).expect("solved");
        let error = line.prove(accuracy).expect_err("undefined");
        assert!(matches!(error, ProofError::Curve(CurveError::Undefined { .. })), "{error}");
    }

    /// In interval arithmetic, only one of several branches would be followed.
    #[test]
    fn a_formula_with_branches_has_no_proof() {
        struct Branch;
        impl Metric<1> for Branch {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                SMatrix::from_element(if x[0].is_zero() { S::one() } else { x[0].cos() + 3.0 })
            }
        }
        let ends = Ends::points([0.1], [1.0]).expect("finite");
        let line = Problem::new(Branch, ends).solve(Trapezoidal, 8).expect("solved");
        let refused = ProofError::Curve(CurveError::NotRecorded(RecordError::Compares));
        assert_eq!(line.prove(Accuracy::default()).map(|_| ()), Err(refused));
    }

    /// The left-endpoint rule does not need `M_H` between two sets: it is not searched for, and the
    /// bounds are the same.
    #[test]
    fn m_h_is_proved_only_where_it_is_used() {
        fn check<M: Metric<2>, R: RuleOfThePaper>(
            metric: M,
            ends: Ends<2>,
            rule: R,
            needs_m_h: bool,
        ) {
            let line = Problem::new(metric, ends).solve(rule, 64).expect("solved");
            let seen = Mutex::new(Vec::new());
            let watch = |progress: Progress| {
                seen.lock().expect("no panic").push(progress.quantity);
                true
            };
            let accuracy = Accuracy { tolerance: 1e-4, ..Accuracy::default() };
            let proof = line
                .prove_watched(accuracy, &watch, &mut |_| ControlFlow::Continue(()))
                .expect("proved");
            assert_eq!(proof.constants.m_h().is_some(), needs_m_h);
            let seen = seen.into_inner().expect("no panic");
            assert!(seen.contains(&Quantity::LH));
            assert!(needs_m_h || !seen.contains(&Quantity::MH));
            // Any M_H leaves the bounds as they are.
            let extent = line.extent();
            let with = proof.constants.with_m_h(proof.constants.m_h().unwrap_or(0.0));
            let [with, without] = [with.expect("a constant"), proof.constants]
                .map(|constants| line.enclosure_by(constants, extent));
            assert_eq!(with, without);
        }
        let ball = |x: f64| Ball::new([x, 0.1], 0.01).expect("a radius");
        let sets = || Ends::new(ball(0.3), ball(0.45)).expect("bounded");
        let points = || Ends::points([0.3, 0.1], [0.4, 0.1]).expect("finite");
        let shear = || Shear::new(0.3, 1.0).expect("a wave number");
        check(Sphere, sets(), LeftEndpoint, false);
        check(Sphere, sets(), Trapezoidal, true);
        check(Sphere, points(), LeftEndpoint, true);
        check(shear(), sets(), LeftEndpoint, false);
        check(Valleys, sets(), LeftEndpoint, false);
    }

    /// A search that is ended counts with what it has found.
    #[test]
    fn a_proof_that_is_ended_has_wider_bounds() {
        let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(Trapezoidal, 64).expect("solved");
        let accuracy = Accuracy { tolerance: 1e-9, budget: 100_000 };
        let stop = &mut |_| ControlFlow::Break(());
        let ended = line.prove_watched(accuracy, &|_: Progress| false, stop).expect("proved");
        let close = line.prove(accuracy).expect("proved");
        assert!(ended.constants.l_h() > close.constants.l_h());
        assert!(ended.constants.c1() <= close.constants.c1());
        assert!(0.0 < ended.enclosure.lower && ended.enclosure.lower < close.enclosure.lower);
    }

    /// The budget is spent long before the tolerance is reached, on all of space and on a ball.
    #[test]
    fn a_small_budget_gives_wider_bounds() {
        let check = |wide: Result<_, ProofError>, close: Result<_, ProofError>| {
            let [wide, close]: [super::Proof<'_, 2>; 2] =
                [wide, close].map(|proof| proof.expect("proved"));
            assert_eq!(wide.within.is_some(), close.within.is_some());
            assert!(wide.constants.c1() <= close.constants.c1());
            assert!(wide.constants.l_h() > close.constants.l_h());
            // A certificate does not depend on the constants.
            assert!(wide.enclosure.lower < close.enclosure.lower || wide.found.is_some());
            assert_eq!(wide.enclosure.upper, close.enclosure.upper);
        };
        let few = Accuracy { tolerance: 1e-9, budget: 300 };
        let ends = Ends::points([0.3, 0.1], [0.45, 0.2]).expect("finite");
        let line = Problem::new(Sphere, ends).solve(Trapezoidal, 64).expect("solved");
        check(line.prove(few), line.prove(Accuracy::default()));
        let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(Trapezoidal, 64).expect("solved");
        let few = Accuracy { tolerance: 1e-9, budget: 30 };
        check(line.prove(few), line.prove(Accuracy::default()));
    }
}
