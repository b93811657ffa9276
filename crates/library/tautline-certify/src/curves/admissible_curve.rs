//! `AdmissibleCurve`: a curve between two sets, and the bound on their distance that it proves.

use tautline_discretizations::PointSequence;
use tautline_formula::{Formula, RecordError};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Interval, Scalar};
use tautline_sets::{AnyEnds, AnySet, Ends};
use thiserror::Error;

use super::{Polygon, chord::is_positive_definite, polygon::NotEnclosed};

/// A polygon that provably runs from the first end set to the second, with its energy and length.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`].
///
/// ```
/// use tautline_certify::AdmissibleCurve;
/// use tautline_discretizations::PointSequence;
/// use tautline_metrics::gallery::Valleys;
/// use tautline_sets::{Ball, Ends, HalfSpace};
///
/// let ball = Ball::new([0.0, 0.0], 0.5)?;
/// let ends = Ends::new(ball, HalfSpace::at_least([1.0, 0.0], 3.0)?)?;
/// let line = PointSequence::straight([0.5, 0.0], [3.0, 0.0], 1000)?;
/// let curve = AdmissibleCurve::new(&Valleys, &line, &ends)?;
/// // d = 5 − sin 3 + sin ½ is the length of this line; its square is proved to 13 digits.
/// let d_squared = 28.497_505_937_440_242;
/// let bound = curve.distance_squared_at_most();
/// assert!(bound >= d_squared && bound <= d_squared * (1.0 + 1e-13));
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Clone, Debug)]
#[doc(alias = "competitor")]
pub struct AdmissibleCurve<'a, const D: usize> {
    polygon: Polygon<'a, D>,
    energy: Interval,
    length: Interval,
}

/// Why a point sequence yields no bound on the distance.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CurveError {
    /// A set cannot prove that it has a member near the end of the curve.
    #[error(
        "the {end} end set proves no member near the point at distance {distance:e} from its \
         projection: implement ClosedSet::member_near"
    )]
    NoMember {
        /// Which end: `first` or `second`.
        end: &'static str,
        /// The Euclidean distance between the curve's end and its projection onto the set, in `ℓ`.
        distance: f64,
    },
    /// The metric is undefined somewhere on a chord, or so close to it that 8192 parts cannot
    /// decide.
    #[error("the metric is undefined somewhere on chord {chord} of {chords}, counted from 0")]
    Undefined {
        /// The index of the chord, from 0.
        chord: usize,
        /// The number of chords.
        chords: usize,
    },
    /// The metric is not positive definite somewhere on a chord, or so nearly indefinite that 8192 parts
    /// cannot decide. A curve has a length only where the metric is one.
    #[error("H is not proved to be positive definite on chord {chord} of {chords}, counted from 0")]
    Indefinite {
        /// The index of the chord, from 0.
        chord: usize,
        /// The number of chords.
        chords: usize,
    },
    /// The formula of the metric cannot be recorded: it has too many steps, or it has branches, of
    /// which intervals would follow only one. Or its halves are not known to be equal.
    #[error("nothing is proved of this formula: {0}")]
    NotRecorded(#[source] RecordError),
}

impl<'a, const D: usize> AdmissibleCurve<'a, D> {
    /// Replaces the ends of `sequence` by members of the two sets, and encloses the energy and
    /// length.
    ///
    /// An end that provably belongs to its set stays. Otherwise the new end lies in a box, a few
    /// roundings wide, around the nearest point of the set. The ends of the sequence may lie far
    /// from the sets, but the farther they lie, the longer the curve becomes.
    ///
    /// # Errors
    ///
    /// [`CurveError::NoMember`] if a set cannot prove a member, which is the default for your own
    /// sets; [`CurveError::Undefined`] if the metric is undefined somewhere on the curve;
    /// [`CurveError::Indefinite`] if it is not proved to be positive definite there;
    /// [`CurveError::NotRecorded`] if its formula cannot be recorded or is not known to be symmetric.
    pub fn new(
        metric: &impl Metric<D>,
        sequence: &'a PointSequence<D>,
        ends: &Ends<D>,
    ) -> Result<Self, CurveError> {
        let formula = Formula::record(metric).map_err(CurveError::NotRecorded)?;
        Self::by_formula(&formula.into_any(), sequence, &ends.in_any())
    }

    /// Does the same as [`new`](AdmissibleCurve::new), in a dimension that is a value.
    ///
    /// # Errors
    ///
    /// Those of [`new`](AdmissibleCurve::new).
    ///
    /// # Panics
    ///
    /// If the formula, the sequence and the sets do not lie in the same dimension.
    pub fn by_formula(
        formula: &Formula<ANY>,
        sequence: &'a PointSequence<D>,
        ends: &AnyEnds,
    ) -> Result<Self, CurveError> {
        let chords = sequence.n().get();
        let first = member("first", &**ends.first(), sequence.row(0))?;
        let last = member("second", &**ends.second(), sequence.row(chords))?;
        let polygon = Polygon::new(sequence).with_ends(first, last);
        let (energy, length) = polygon.enclosures_of_a_curve(formula).map_err(|why| match why {
            NotEnclosed::NotRecorded(error) => CurveError::NotRecorded(error),
            NotEnclosed::Undefined { chord } => CurveError::Undefined { chord, chords },
            NotEnclosed::Indefinite { chord } => CurveError::Indefinite { chord, chords },
        })?;
        Ok(Self { polygon, energy, length })
    }

    /// Returns the polygon.
    #[must_use]
    pub fn polygon(&self) -> &Polygon<'a, D> {
        &self.polygon
    }

    /// Returns an enclosure of its energy, in `m²`.
    #[must_use]
    pub fn energy(&self) -> Interval {
        self.energy
    }

    /// Returns an enclosure of its length, in `m`.
    #[must_use]
    pub fn length(&self) -> Interval {
        self.length
    }

    /// Returns an upper bound on `d²`, the squared distance between the sets, in `m²`. It is the
    /// smaller of the upper ends of the energy and of the squared length, or `∞` if both overflow.
    ///
    /// Needs: only that the formula of the metric is the one you mean.
    ///
    /// Overestimation: rounding, and the excess of the curve over a minimal geodesic. In exact
    /// arithmetic `L² ≤ E`, so the energy decides only if the length is enclosed less sharply.
    #[must_use]
    pub fn distance_squared_at_most(&self) -> f64 {
        self.energy.hi().min(self.length.sqr().hi())
    }
}

/// Returns a box that contains a member of an end set near `x`.
fn member(end: &'static str, set: &dyn AnySet, x: &[f64]) -> Result<Vec<Interval>, CurveError> {
    set.member_near(x).ok_or_else(|| {
        let mut nearest = x.to_vec();
        set.project(&mut nearest);
        let squares = nearest.iter().zip(x).map(|(y, x)| (y - x) * (y - x));
        CurveError::NoMember { end, distance: squares.sum::<f64>().sqrt() }
    })
}

/// Returns whether a formula is proved to give a metric at a point: a matrix that is symmetric, defined and
/// positive definite.
#[must_use]
pub fn is_metric_at<const D: usize>(formula: &Formula<D>, x: &[f64]) -> bool {
    let place: Vec<Interval> = x.iter().map(|&x| Interval::point(x)).collect();
    formula.symmetric().is_ok() && is_positive_definite(&mut formula.gram_at(&place), x.len())
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::{SMatrix, SVector, vector};
    use tautline_chance::Random;
    use tautline_discretizations::{PointSequence, Rule};
    use tautline_formula::{Formula, RecordError, spline::Spline};
    use tautline_metrics::gallery::{Constant, Hyperbolic, Valleys};
    use tautline_scalar::{Interval, Scalar, Table};
    use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace, Point, Sphere};

    use super::{AdmissibleCurve, CurveError, Polygon};
    use crate::testing::Branch;

    /// A set that never proves a member.
    #[derive(Debug)]
    struct Origin;

    impl ClosedSet<2> for Origin {
        fn project(&self, _: &SVector<f64, 2>) -> SVector<f64, 2> {
            SVector::zeros()
        }
        fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
            SMatrix::zeros()
        }
        fn radius(&self) -> Option<f64> {
            Some(0.0)
        }
    }

    fn line(a: [f64; 2], b: [f64; 2], n: usize) -> PointSequence<2> {
        PointSequence::straight(a, b, n).expect("finite")
    }

    #[test]
    fn a_set_that_proves_nothing_is_reported() {
        let goal = Point::new([1.0, 0.0]).expect("finite");
        let curve = line([0.0, 3.0], [1.0, 0.0], 2);
        let ends = Ends::new(Origin, goal.clone()).expect("bounded");
        let error = AdmissibleCurve::new(&Valleys, &curve, &ends).expect_err("nothing proved");
        assert_eq!(error, CurveError::NoMember { end: "first", distance: 3.0 });
        let ends = Ends::new(goal, Origin).expect("bounded");
        let error = AdmissibleCurve::new(&Valleys, &curve, &ends).expect_err("nothing proved");
        assert_eq!(error, CurveError::NoMember { end: "second", distance: 1.0 });
    }

    #[test]
    fn a_chord_with_an_undefined_metric_is_reported() {
        let curve = line([0.0, 0.0], [2.0, 0.0], 4);
        let ends = Ends::points([0.0, 0.0], [2.0, 0.0]).expect("finite");
        let error = AdmissibleCurve::new(&Hyperbolic, &curve, &ends).expect_err("leaves the ball");
        // The boundary is at 1, where the second chord ends.
        assert_eq!(error, CurveError::Undefined { chord: 1, chords: 4 });
    }

    /// Along the chord `dᵀHd` is 0.1 and more, but at the origin `H₂₂ = −2`.
    #[test]
    fn a_chord_through_a_pocket_where_the_metric_is_indefinite_is_reported() {
        let text = "b = exp(-50*(x1^2 + x2^2)); [1 - 0.9*b, 0; 0, 1 - 3*b]";
        let pocket = Formula::<2>::parse(text, &[]).expect("a formula");
        let through = line([-1.0, 0.0], [1.0, 0.0], 4);
        let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
        let error = AdmissibleCurve::new(&pocket, &through, &ends).expect_err("no metric");
        assert_eq!(error, CurveError::Indefinite { chord: 1, chords: 4 });
        // The pocket has the radius √(ln 3/50) = 0.1482. Chords that touch it come nearer than their ends.
        let tent = |height: f64| {
            let points = vec![vector![-1.0, 0.0], vector![0.0, height], vector![1.0, 0.0]];
            PointSequence::new(points).expect("finite")
        };
        let error = AdmissibleCurve::new(&pocket, &tent(0.149), &ends).expect_err("no metric");
        assert_eq!(error, CurveError::Indefinite { chord: 0, chords: 2 });
        let above = tent(0.151);
        let proved = AdmissibleCurve::new(&pocket, &above, &ends).expect("a metric");
        // No curve on which H is a metric is shorter than 1.935.
        assert!((1.935..2.0).contains(&proved.length().hi()), "{:?}", proved.length());
        // A constant curve has a length only where the metric is one.
        let rest = line([0.0, 0.0], [0.0, 0.0], 2);
        let ends = Ends::points([0.0, 0.0], [0.0, 0.0]).expect("finite");
        let error = AdmissibleCurve::new(&pocket, &rest, &ends).expect_err("no metric");
        assert_eq!(error, CurveError::Indefinite { chord: 0, chords: 2 });
    }

    /// Every pivot counts, also one that is only known to be positive or negative.
    #[test]
    fn a_metric_that_degenerates_at_a_point_of_the_curve_is_reported() {
        let of = |text: &str| Formula::<2>::parse(text, &[]).expect("a formula");
        let ends = Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite");
        let curve = line([-1.0, 0.0], [1.0, 0.0], 3);
        for text in ["[1, 0; 0, x1^2]", "[1, 1; 1, 1 + x1]", "[2 - x2, 0; 0, sqr(x1 - 0.1)]"] {
            let error = AdmissibleCurve::new(&of(text), &curve, &ends).expect_err("no metric");
            assert!(matches!(error, CurveError::Indefinite { .. }), "{text}: {error}");
        }
        let pole = "p = 0*x2/(x1 + 0.5); [1, p; p, 1]";
        let error = AdmissibleCurve::new(&of(pole), &curve, &ends).expect_err("undefined");
        assert!(matches!(error, CurveError::Undefined { chord: 0, .. }), "{error:?}");
    }

    /// Intervals prove `sin²a + cos²a > 0.9` only on parts on which `a` changes by less than about 0.1.
    /// A chord of 2000 radians has more than 8192 of them. They are taken from its end, so its start is
    /// never reached, and along the chord `dᵀHd` is 1. Of eight chords each is decided.
    #[test]
    fn a_chord_with_too_many_parts_is_reported() {
        let of = |dip: f64| {
            let square = format!("sqr(sin(a)) + sqr(cos(a)) - 0.9 - {dip}*exp(-sqr(100*x1))");
            Formula::<2>::parse(&format!("a = 2000*x1; [1, 0; 0, {square}]"), &[])
                .expect("a formula")
        };
        let ends = Ends::points([0.0, 0.0], [1.0, 0.0]).expect("finite");
        let report = |dip: f64, chords: usize| {
            let curve = line([0.0, 0.0], [1.0, 0.0], chords);
            AdmissibleCurve::new(&of(dip), &curve, &ends).map(|curve| curve.length().hi())
        };
        // At the start H₂₂ is −0.1, or it is 0.1 everywhere.
        for dip in [0.2, 0.0] {
            assert_eq!(
                report(dip, 1),
                Err(CurveError::Indefinite { chord: 0, chords: 1 }),
                "{dip}"
            );
        }
        assert_eq!(report(0.2, 8), Err(CurveError::Indefinite { chord: 0, chords: 8 }));
        assert!(report(0.0, 8).is_ok_and(|length| (1.0..1.0 + 1e-14).contains(&length)));
    }

    /// The second derivative of a table is no function's second derivative at a knot, where a chord may
    /// end.
    #[test]
    fn a_chord_that_ends_at_a_knot_of_a_table_lies_in_one_cell() {
        let table = Arc::new(Spline::new(&[4], vec![0.0, 1.0, 0.0, 1.0]).expect("a table"));
        let tables: [(&str, Arc<dyn Table>); 1] = [("t", table)];
        let metric = Formula::<1>::parse_with("[1 + 0.05*t_2(x1)]", &[], &tables);
        let metric = metric.expect("a formula");
        // The ends of chords are rounded, and 1 is a knot.
        let points: Vec<_> = [0.1, 0.7, 1.0, 1.3].map(|x| vector![x]).to_vec();
        let curve = PointSequence::new(points).expect("finite");
        let ends = Ends::points([0.1], [1.3]).expect("finite");
        let proved = AdmissibleCurve::new(&metric, &curve, &ends).expect("a metric");
        assert!(proved.length().width() < 1e-12, "{:?}", proved.length());
    }

    /// Intervals would follow only one branch.
    #[test]
    fn a_formula_with_branches_encloses_nothing() {
        let ends = Ends::points([0.0], [1.0]).expect("finite");
        let curve = PointSequence::straight([0.0], [1.0], 4).expect("finite");
        let error = AdmissibleCurve::new(&Branch, &curve, &ends).expect_err("nothing proved");
        assert_eq!(error, CurveError::NotRecorded(RecordError::Compares));
        let polygon = Polygon::new(&curve);
        let (energy, length) = polygon.energy_and_length(&Branch);
        assert!(energy.is_undefined() && length.is_undefined(), "{energy:?} {length:?}");
        let discrete = polygon.discrete_energy(Rule::LEFT_ENDPOINT, &Branch);
        assert!(discrete.is_undefined(), "{discrete:?}");
    }

    /// A bound on the length under one half would say nothing of the other one.
    #[test]
    fn a_matrix_with_two_halves_encloses_nothing() {
        let metric = Formula::<2>::parse("[2, 0; x2, 2]", &[]).expect("a formula");
        let ends = Ends::points([0.0, 0.0], [1.0, 0.0]).expect("finite");
        let curve = PointSequence::straight([0.0, 0.0], [1.0, 0.0], 4).expect("finite");
        let error = AdmissibleCurve::new(&metric, &curve, &ends).expect_err("nothing proved");
        let halves = RecordError::Halves { row: 0, column: 1 };
        assert_eq!(error, CurveError::NotRecorded(halves));
    }

    /// The ends of the sequence are not known to be members, but those of the polygon are.
    #[test]
    fn the_ends_are_moved_into_the_sets() {
        let sphere = Sphere::new([0.0, 0.0], 0.1).expect("finite");
        let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
        let ends = Ends::new(sphere, wall).expect("bounded");
        let curve = line([0.03, 0.04], [2.0, 0.0], 1);
        let euclidean = Constant::new(SMatrix::identity()).expect("definite");
        let curve = AdmissibleCurve::new(&euclidean, &curve, &ends).expect("proved");
        let first = curve.polygon().first();
        assert!((first[0].midpoint() - 0.06).abs() < 1e-16 && !first[0].contains(0.03));
        assert_eq!(curve.polygon().last(), &[3.0, 0.0].map(Interval::point));
        // The squared distance from 0.1 (0.6, 0.8) to (3, 0) is 2.94² + 0.08².
        let square = 2.94_f64 * 2.94 + 0.08 * 0.08;
        let bound = curve.distance_squared_at_most();
        assert!((bound / square - 1.0).abs() < 1e-14 && bound >= square * (1.0 - 1e-15));
        // The distance between the sets is 2.9.
        assert!(bound >= 2.9 * 2.9);
    }

    /// The bound is the smaller of the two, rounded up.
    #[test]
    fn the_bound_is_not_below_the_square_of_the_length() {
        let euclidean = Constant::new(SMatrix::identity()).expect("definite");
        let ends = Ends::points([0.0, 0.0], [0.3, 0.0]).expect("finite");
        // The chords are unequal: the energy is 2 (0.01 + 0.04), the squared length 0.09.
        let points = vec![vector![0.0, 0.0], vector![0.1, 0.0], vector![0.3, 0.0]];
        let curve = PointSequence::new(points).expect("finite");
        let curve = AdmissibleCurve::new(&euclidean, &curve, &ends).expect("proved");
        assert!((curve.energy().midpoint() - 0.1).abs() < 1e-15);
        let bound = curve.distance_squared_at_most();
        let square = Interval::point(0.3).sqr();
        assert!(square.lo() < square.hi(), "0.3² would be a double");
        assert!(square.hi() <= bound && bound < 0.09 * (1.0 + 1e-14), "{bound}");
    }

    /// On the line, under `H = 1`, the length of an increasing sequence is the difference between
    /// its ends. No bound is below the exact square of this length.
    #[test]
    fn no_rounding_puts_the_bound_below_the_square_of_the_length() {
        let euclidean = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
        for k in 1..200 {
            let far = 0.1 * f64::from(k);
            // The chords are unequal, so that the energy does not decide.
            let points = [0.0, 0.3 * far, far].map(|x| vector![x]).to_vec();
            let curve = PointSequence::new(points).expect("finite");
            let ends = Ends::points([0.0], [far]).expect("finite");
            let curve = AdmissibleCurve::new(&euclidean, &curve, &ends).expect("proved");
            let bound = curve.distance_squared_at_most();
            // The difference is rounded once, which keeps its sign.
            assert!(far.mul_add(far, -bound) <= 0.0 && bound < far * far * (1.0 + 1e-14), "{far}");
        }
    }

    /// The bound is the lesser of the two upper ends as exact numbers, and no double below it is one.
    #[test]
    fn the_bound_is_the_upper_end_of_the_energy_or_of_the_squared_length() {
        let euclidean = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
        let (mut by_length, mut by_energy) = (0, 0);
        for k in 1..200 {
            let far = 0.1 * f64::from(k);
            let ends = Ends::points([0.0], [far]).expect("finite");
            for middle in [0.3 * far, 0.5 * far] {
                let points = [0.0, middle, far].map(|x| vector![x]).to_vec();
                let curve = PointSequence::new(points).expect("finite");
                let curve = AdmissibleCurve::new(&euclidean, &curve, &ends).expect("proved");
                let (bound, length) = (curve.distance_squared_at_most(), curve.length().hi());
                // The difference is rounded once, which keeps its sign.
                let is_at_least = |bound: f64| length.mul_add(length, -bound) <= 0.0;
                if bound == curve.energy().hi() {
                    by_energy += 1;
                } else {
                    by_length += 1;
                    assert!(is_at_least(bound), "{length}² > {bound}");
                }
                let below = bound.next_down();
                assert!(below < curve.energy().hi() && !is_at_least(below), "{below} suffices");
            }
        }
        assert!(by_length >= 199 && by_energy > 20, "{by_length} {by_energy}");
    }

    /// A square that overflows is no bound, and the energy of chords as long overflows too.
    #[test]
    fn a_length_whose_square_overflows_bounds_nothing() {
        let euclidean = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
        for (far, is_finite) in [(1e150, true), (1e160, false)] {
            let points = [0.0, 0.3 * far, far].map(|x| vector![x]).to_vec();
            let curve = PointSequence::new(points).expect("finite");
            let ends = Ends::points([0.0], [far]).expect("finite");
            let curve = AdmissibleCurve::new(&euclidean, &curve, &ends).expect("proved");
            let bound = curve.distance_squared_at_most();
            assert!(bound >= far * far && bound.is_finite() == is_finite, "{far}: {bound}");
        }
    }

    /// If the point lies in the ball, it is not moved, and a constant curve has length zero.
    #[test]
    fn a_constant_curve_proves_distance_zero() {
        let ball = Ball::new([0.1, 0.2], 0.5).expect("finite");
        let ends = Ends::new(ball.clone(), ball).expect("bounded");
        let curve = line([0.3, 0.4], [0.3, 0.4], 3);
        let points = curve.points();
        assert!(points.iter().all(|x| x == &points[0]), "{points:?}");
        let curve = AdmissibleCurve::new(&Valleys, &curve, &ends).expect("proved");
        assert_eq!(curve.distance_squared_at_most(), 0.0);
    }

    /// Returns the determinant of the first `n` rows and columns.
    fn minor(a: &[Vec<i64>], n: usize) -> i64 {
        fn determinant(a: &[Vec<i64>]) -> i64 {
            let Some(first) = a.first() else { return 1 };
            let without = |j: usize| -> Vec<Vec<i64>> {
                let row = |row: &Vec<i64>| [&row[..j], &row[j + 1..]].concat();
                a[1..].iter().map(row).collect()
            };
            let term = |j: usize| if j.is_multiple_of(2) { first[j] } else { -first[j] };
            (0..first.len()).map(|j| term(j) * determinant(&without(j))).sum()
        }
        let part: Vec<Vec<i64>> = a[..n].iter().map(|row| row[..n].to_vec()).collect();
        determinant(&part)
    }

    /// Symmetric matrices of small integers, whose leading minors are computed exactly. A curve has a
    /// length if all of them are positive, and none otherwise. Pivots are quotients of minors, far
    /// from 0 unless they are 0.
    #[test]
    fn a_constant_matrix_is_a_metric_if_its_leading_minors_are_positive() {
        fn check<const D: usize>(random: &mut Random) -> [usize; 2] {
            let mut seen = [0, 0];
            let below = |n: u64, random: &mut Random| (random.bits() % n) as i64;
            for _ in 0..300 {
                let mut a = vec![vec![0_i64; D]; D];
                for i in 0..D {
                    a[i][i] = 2 + below(6, random);
                    for j in 0..i {
                        a[i][j] = below(7, random) - 3;
                        a[j][i] = a[i][j];
                    }
                }
                let row = |row: &Vec<i64>| {
                    row.iter().map(|entry| entry.to_string()).collect::<Vec<_>>().join(", ")
                };
                let text = a.iter().map(row).collect::<Vec<_>>().join("; ");
                let metric = Formula::<D>::parse(&format!("[{text}]"), &[]).expect("a formula");
                let mut to = [0.0; D];
                to[D - 1] = 1.0;
                let curve = PointSequence::straight([0.0; D], to, 1).expect("finite");
                let ends = Ends::points([0.0; D], to).expect("finite");
                let found = AdmissibleCurve::new(&metric, &curve, &ends);
                let is_metric = (1..=D).all(|n| minor(&a, n) > 0);
                assert_eq!(found.is_ok(), is_metric, "{a:?}: {found:?}");
                seen[usize::from(is_metric)] += 1;
            }
            seen
        }
        let mut random = Random(tautline_chance::seed(81));
        let seen =
            [check::<2>(&mut random), check::<3>(&mut random), check::<4>(&mut random)].concat();
        assert!(seen.iter().all(|&count| count > 5), "{seen:?}");
    }

    /// The third derivative of a spline jumps at its knots. A chord crosses two of them; no part of it
    /// has a knot at an end. Over the cell from `i` to `i + 1` the integral of the spline is
    /// `(c₋₁ + 11 c₀ + 11 c₁ + c₂)/24`, with the coefficients around the cell.
    #[test]
    fn the_energy_across_the_knots_of_a_table_is_enclosed() {
        let points = [1.0, 4.0].map(|x| vector![x]).to_vec();
        let curve = PointSequence::new(points).expect("finite");
        for coefficients in [
            [0, 1, 0, 0, 1, 0],
            [0, 90, -70, 40, 80, -60],
            [3, 0, 0, 96, 0, 0],
            [0, 0, 64, -64, 0, 1],
        ] {
            let numbers = coefficients.map(f64::from).to_vec();
            let table = Arc::new(Spline::new(&[6], numbers).expect("a table"));
            let tables: [(&str, Arc<dyn Table>); 1] = [("t", table)];
            let metric = Formula::<1>::parse_with("[1000 + t(x1)]", &[], &tables);
            let energy = Polygon::new(&curve).energy(&metric.expect("a formula"));
            // The step is 3, so that E = 3 ∫ H = 3 (3000 + Σ/24), where Σ/8 is a double.
            let weights = [1, 12, 23, 23, 12, 1];
            let sum: i32 = coefficients.iter().zip(weights).map(|(c, w)| c * w).sum();
            let exact = 9000.0 + f64::from(sum) / 8.0;
            assert!(energy.contains(exact), "{coefficients:?}: {energy:?} misses {exact}");
            assert!(energy.width() < 2e-8, "{coefficients:?}: {energy:?}");
        }
    }
}
