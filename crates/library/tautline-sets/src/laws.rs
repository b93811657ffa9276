//! The laws of a closed set, as one property test that runs for every set, and a bare set for
//! tests.

use std::fmt;

use nalgebra::{SMatrix, SVector};
use proptest::prelude::*;
use proptest::test_runner::{TestError, TestRunner};
use tautline_scalar::Interval;

use crate::numerics::norm::on_axis;
use crate::{AnySet, ClosedSet, InAny, Shape};

/// The seed of every property test in this crate, printed when a test fails.
const SEED: u64 = 0x7A07_11E5;

/// A bound on all coordinates at scale 1: data are at most 3 + 2, samples at most 8.
const SIZE: f64 = 8.0;

/// The accuracy of a coordinate or a distance at scale 1.
///
/// A projection, a membership formula and the comparison together incur about 4 D ≤ 20 roundings of
/// ε/2 each, in numbers up to `SIZE` √D. This number is more than twice the bound that results.
const ROUNDING: f64 = 64.0 * SIZE * f64::EPSILON;

/// The step of the central difference at scale 1. It is a power of two, so that `x ± h` is exact.
const STEP: f64 = 1.0 / 131_072.0;

/// The distance from the kinks of `P` that a sample must have to be differentiated at.
const CLEARANCE: f64 = 1.0 / 16.0;

/// The accuracy of a central difference of `P`.
///
/// The truncation error is `h²/6 · |D³P|`. For ball and sphere `|D³P| ≤ 15 r/|x − c|³`, where
/// `r ≤ 2` and `|x − c|` is at least 1/4 for the sphere and `r + 1/16` for the ball. So `|D³P|` is
/// at most 1920, and the error is below `320 h² < 2e-8`. All other maps are piecewise affine. The
/// rounding error is `8 ε SIZE / h < 2e-9`.
const DIFFERENCE: f64 = 4e-8;

/// A function of a point at scale 1.
type Of<const D: usize, T> = Box<dyn Fn(&SVector<f64, D>) -> T>;

/// A predicate of a box at scale 1.
type Held<const D: usize> = Box<dyn Fn(&SVector<Interval, D>) -> bool>;

/// A set, and properties of it that follow from its formula without its projection.
///
/// The properties are at scale 1; the set is `scale` times as large.
pub(crate) struct Case<const D: usize> {
    pub(crate) set: Box<dyn ClosedSet<D>>,
    pub(crate) scale: f64,
    /// A member for each `w` of the cube `[−1, 1]^D`.
    pub(crate) member: Of<D, SVector<f64, D>>,
    /// Zero for members; otherwise about the distance from the set.
    pub(crate) defect: Of<D, f64>,
    /// Returns whether a box contains a member, by the formula of the set in exact arithmetic.
    pub(crate) held: Held<D>,
    /// A lower bound on the distance to the nearest place where `P` is not smooth.
    pub(crate) kink: Of<D, f64>,
    /// A member farthest from the origin, if there is one.
    pub(crate) farthest: Option<SVector<f64, D>>,
}

impl<const D: usize> Case<D> {
    /// Evaluates `P` at scale 1.
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        self.set.project(&(x * self.scale)) / self.scale
    }

    /// Evaluates `DP`, which has no scale.
    fn derivative(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        self.set.projection_derivative(&(x * self.scale))
    }
}

impl<const D: usize> fmt::Debug for Case<D> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{:?} at scale {:e}", self.set, self.scale)
    }
}

/// A set with the required methods only, and a derivative of zero.
pub(crate) struct Bare<P> {
    pub(crate) project: P,
    pub(crate) radius: Option<f64>,
}

impl<P> fmt::Debug for Bare<P> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "a set of radius {:?}", self.radius)
    }
}

impl<const D: usize, P: Fn(&SVector<f64, D>) -> SVector<f64, D> + Send + Sync> ClosedSet<D>
    for Bare<P>
{
    fn project(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        (self.project)(x)
    }

    fn projection_derivative(&self, _: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        SMatrix::zeros()
    }

    fn radius(&self) -> Option<f64> {
        self.radius
    }
}

/// Samples coordinates in `[−bound, bound]`.
pub(crate) fn vector_in<const D: usize>(bound: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-bound..bound).prop_map(SVector::from)
}

/// Samples a radius or half-width, which is often 0 and otherwise at most 2.
pub(crate) fn extent() -> impl Strategy<Value = f64> {
    prop_oneof![1 => Just(0.0), 4 => 0.1..2.0_f64]
}

/// Powers of two, so that scaling is exact. They include two whose squares overflow or underflow.
pub(crate) fn scale() -> impl Strategy<Value = f64> {
    prop_oneof![
        3 => Just(1.0),
        1 => Just(2.0_f64.powi(-700)),
        1 => Just(2.0_f64.powi(700)),
    ]
}

/// Returns a runner that writes no files. Its seed is fixed unless the environment sets another.
pub(crate) fn runner() -> TestRunner {
    TestRunner::new(tautline_chance::config(SEED, 512))
}

/// Panics with the shrunk sample and the seed if a run failed.
pub(crate) fn unwrap<T: fmt::Debug>(result: Result<(), TestError<T>>) {
    if let Err(error) = result {
        panic!("seed {SEED:#x}: {error}");
    }
}

/// Checks every law of [`ClosedSet`] on random sets of one kind and random points.
pub(crate) fn check<const D: usize>(cases: impl Strategy<Value = Case<D>>) {
    let samples = (cases, vector_in::<D>(8.0), vector_in::<D>(8.0), vector_in::<D>(1.0));
    unwrap(runner().run(&samples, |(case, x, y, w)| {
        nearest(&case, &x, &w)?;
        nearest(&case, &(case.member)(&w), &w)?;
        proved(&case, &x)?;
        proved(&case, &(case.member)(&w))?;
        proved(&case, &case.project(&x))?;
        bounded(&case, &w)?;
        differentiable(&case, &x)?;
        same_in_any(&case, &x)?;
        if case.set.is_convex() {
            convex(&case, &x, &y, &w)?;
        }
        Ok(())
    }));
}

/// Checks that the edges of a set belong to it: at a member, even at a kink of `P`, the derivative
/// preserves the directions along the set. This check is for convex sets with edges on which
/// samples can lie without rounding.
pub(crate) fn check_edges<const D: usize>(cases: impl Strategy<Value = Case<D>>) {
    let samples = (cases, vector_in::<D>(8.0), vector_in::<D>(1.0));
    unwrap(runner().run(&samples, |(case, x, w)| {
        let p = case.project(&x);
        let along = (case.member)(&w) - p;
        // The member is off by ROUNDING, and the product by D roundings of numbers up to SIZE.
        let off = (case.derivative(&p) * along - along).amax();
        prop_assert!(off <= 2.0 * ROUNDING, "DP({p:?}) moves {along:?} by {off:e}");
        Ok(())
    }));
}

/// Checks that points that are inside according to the derivative stay in place, to the last bit.
/// So `P` agrees with `DP` on the boundary, where `P(x)` often lies. This check is for sets with an
/// interior in which nothing rounds.
pub(crate) fn check_inside<const D: usize>(cases: impl Strategy<Value = Case<D>>) {
    unwrap(runner().run(&(cases, vector_in::<D>(8.0)), |(case, x)| {
        for y in [x, case.project(&x), case.project(&case.project(&x))] {
            if case.derivative(&y) == SMatrix::<f64, D, D>::identity() {
                prop_assert_eq!(y, case.project(&y), "inside, but moved");
            }
        }
        Ok(())
    }));
}

/// `P(x)` is a member, `P` leaves it in place, and no member is nearer to `x`.
fn nearest<const D: usize>(
    case: &Case<D>,
    x: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let p = case.project(x);
    let defect = (case.defect)(&p);
    prop_assert!(defect <= ROUNDING, "P({x:?}) misses the set by {defect:e}");
    let moved = (case.project(&p) - p).norm();
    prop_assert!(moved <= ROUNDING, "P moves P({x:?}) by {moved:e}");
    let member = (case.member)(w);
    let (left, right) = ((x - p).norm(), (x - member).norm());
    prop_assert!(left <= right + ROUNDING, "{left} to P(x), {right} to the member {member:?}");
    // If several members are nearest, the same one is always returned.
    prop_assert_eq!(p, case.project(x));
    Ok(())
}

/// The box about `P(x)` contains a member, and a point that is clearly inside is proved to be a
/// member.
fn proved<const D: usize>(case: &Case<D>, x: &SVector<f64, D>) -> Result<(), TestCaseError> {
    let near = case.set.member_near(&(x * case.scale));
    let Some(near) = near else {
        return Err(TestCaseError::fail(format!("nothing proved near {x:?}")));
    };
    // The scales are powers of two, so nothing rounds.
    let side = |i: usize| [near[i].lo(), near[i].hi()].map(|end| end / case.scale);
    let member = SVector::from_fn(|i, _| {
        let [lo, hi] = side(i);
        Interval::new(lo, hi).expect("bounded")
    });
    prop_assert!((case.held)(&member), "no member in {member:?} near {x:?}");
    let p = case.project(x);
    for i in 0..D {
        let far = (member[i].lo() - p[i]).abs().max((member[i].hi() - p[i]).abs());
        prop_assert!(far <= ROUNDING, "{:?} for coordinate {i} of P({x:?}) = {p:?}", member[i]);
    }
    let inside = p == *x && case.derivative(x) == SMatrix::<f64, D, D>::identity();
    if inside && (case.kink)(x) > ROUNDING {
        prop_assert_eq!(member, x.map(Interval::point));
    }
    Ok(())
}

/// The farthest member attains the radius, no member exceeds it, and seeds are members.
fn bounded<const D: usize>(case: &Case<D>, w: &SVector<f64, D>) -> Result<(), TestCaseError> {
    let radius = case.set.radius().map(|radius| radius / case.scale);
    prop_assert_eq!(radius.is_some(), case.farthest.is_some());
    if let (Some(radius), Some(farthest)) = (radius, case.farthest) {
        prop_assert!(
            (case.defect)(&farthest) <= ROUNDING,
            "the farthest point of the test is not a member"
        );
        prop_assert!((farthest.norm() - radius).abs() <= ROUNDING, "radius {radius} not met");
        let member = (case.member)(w).norm();
        prop_assert!(member <= radius + ROUNDING, "a member of length {member} > {radius}");
    }
    let ball = case.set.enclosing_ball();
    prop_assert_eq!(ball.is_some(), radius.is_some());
    if let Some((centre, radius)) = ball {
        let (centre, radius) = (centre / case.scale, radius / case.scale);
        for member in [(case.member)(w), case.project(&(case.member)(w))] {
            let away = (member - centre).norm();
            prop_assert!(away <= radius + ROUNDING, "{away} from the centre of a ball of {radius}");
        }
    }
    for seed in case.set.seeds() {
        let defect = (case.defect)(&(seed / case.scale));
        prop_assert!(defect <= ROUNDING, "the seed {seed:?} misses the set by {defect:e}");
    }
    Ok(())
}

/// The set is the same to the last bit where its dimension is a value.
fn same_in_any<const D: usize>(case: &Case<D>, x: &SVector<f64, D>) -> Result<(), TestCaseError> {
    let shape = case.set.shape().map(Shape::into_any);
    let Some(shape) = shape else { return Err(TestCaseError::fail("no data")) };
    let (x, set) = (x * case.scale, InAny(&*case.set));
    prop_assert_eq!(shape.clone().into_dimension().ok(), case.set.shape());
    prop_assert_eq!((shape.dimension(), set.dimension()), (D, D));
    let results = [&shape as &dyn AnySet, &set].map(|set| {
        let (mut nearest, mut derivative) = (x.as_slice().to_vec(), vec![f64::NAN; D * D]);
        set.project(&mut nearest);
        set.projection_derivative(x.as_slice(), &mut derivative);
        let about = (set.radius(), set.enclosing_ball(), set.is_convex(), set.seeds());
        (nearest, derivative, about, set.member_near(x.as_slice()), set.pieces().len())
    });
    prop_assert_eq!(&results[0], &results[1]);
    let nearest = case.set.project(&x);
    prop_assert_eq!(&results[0].0[..], nearest.as_slice());
    Ok(())
}

/// The derivative is symmetric, and it agrees with differences of `P` where `P` is smooth.
fn differentiable<const D: usize>(
    case: &Case<D>,
    x: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let derivative = case.derivative(x);
    prop_assert!(derivative.iter().all(|entry| entry.is_finite()), "{derivative}");
    prop_assert_eq!(derivative, derivative.transpose());
    if !((case.kink)(x) > CLEARANCE) {
        return Ok(());
    }
    for j in 0..D {
        let h = on_axis(j, STEP);
        let difference = (case.project(&(x + h)) - case.project(&(x - h))) / (2.0 * STEP);
        let error = (derivative.column(j) - difference).amax();
        prop_assert!(error <= DIFFERENCE, "column {j} of {derivative} is off by {error:e}");
    }
    Ok(())
}

/// Neither `P` nor its derivative expands, and `x − P(x)` makes obtuse angles with the set.
fn convex<const D: usize>(
    case: &Case<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
    w: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let (p, q) = (case.project(x), case.project(y));
    let (left, right) = ((p - q).norm(), (x - y).norm());
    prop_assert!(left <= right + ROUNDING, "|P(x) - P(y)| = {left}, |x - y| = {right}");
    let angle = (x - p).dot(&((case.member)(w) - p));
    // Each factor is off by ROUNDING, and the other factor is at most 4 SIZE √D < 16 SIZE.
    prop_assert!(angle <= 16.0 * SIZE * ROUNDING, "(x - P(x))·(member - P(x)) = {angle:e}");
    let derivative = case.derivative(x);
    // The quotients vᵀ DP v are taken for v = e₁, … and for a random direction, without an
    // eigenvalue routine.
    for v in (0..D).map(|i| on_axis(i, 1.0)).chain(w.try_normalize(0.0)) {
        let quotient = v.dot(&(derivative * v));
        // The entries are at most 1, and there are about 2 D² ≤ 50 roundings.
        let range = -64.0 * f64::EPSILON..=1.0 + 64.0 * f64::EPSILON;
        prop_assert!(range.contains(&quotient), "vᵀ DP v = {quotient} for v = {v:?}");
    }
    Ok(())
}
