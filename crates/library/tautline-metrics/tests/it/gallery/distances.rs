//! The exact distances are distances, belong to their metric, and agree with independently computed
//! values.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, matrix, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    Bounded, Jet1, KnownDistance, Metric, check_gram,
    gallery::{
        Bump, Constant, Corrugated, Hill, Hyperbolic, Lens, Ramp, Separable, Shear, Sphere, Swirl,
        TwoChannels, Valleys,
    },
    norm_squared,
    quadrature::integrate,
};

use crate::measure::runner;

pub(crate) fn distance<const D: usize>(
    g: &impl KnownDistance<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) -> f64 {
    g.distance(x, y).expect("a pair whose distance is known")
}

/// Returns the length of the chord.
pub(crate) fn chord<const D: usize>(
    g: &impl Metric<D>,
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) -> f64 {
    let v = y - x;
    integrate(|t| norm_squared(g, &(x + v * t), &v).sqrt(), 0.0, 1.0, 1e-14).value
}

/// Checks `d(x, y) = d(y, x)`, `d(x, x) = 0`, the triangle inequality, and that `d` is at most the
/// length of the chord.
///
/// Each `d` has about ten roundings of numbers below 10, the size of the coordinates; 1e-13 is
/// about a hundred ulps of these.
pub(crate) fn is_distance<const D: usize>(
    g: &impl KnownDistance<D>,
    [x, y, z]: [SVector<f64, D>; 3],
) -> Result<(), TestCaseError> {
    let d = distance(g, &x, &y);
    prop_assert_eq!(d, distance(g, &y, &x));
    prop_assert_eq!(distance(g, &x, &x), 0.0);
    let detour = distance(g, &x, &z) + distance(g, &z, &y);
    prop_assert!(d <= detour + 1e-13, "{d} > {detour}");
    let chord = chord(g, &x, &y);
    prop_assert!(d <= chord * (1.0 + 1e-12) + 1e-13, "{d} > the chord, {chord}");
    Ok(())
}

/// Checks `√c₁ |x − y| ≤ d(x, y) ≤ √c₂ |x − y|`, with the roundings of [`is_distance`].
pub(crate) fn is_bounded<const D: usize>(
    g: &(impl Bounded<D> + KnownDistance<D>),
    x: &SVector<f64, D>,
    y: &SVector<f64, D>,
) -> Result<(), TestCaseError> {
    let (d, euclidean) = (distance(g, x, y), (x - y).norm());
    let (low, high) = (g.constants().c1().sqrt(), g.constants().c2().sqrt());
    prop_assert!(low * euclidean <= d + 1e-13, "{low} {euclidean} > {d}");
    prop_assert!(d <= high * euclidean + 1e-13, "{d} > {high} {euclidean}");
    Ok(())
}

/// Draws three points of `[−reach, reach]^D`.
fn triple<const D: usize>(reach: f64) -> impl Strategy<Value = [SVector<f64, D>; 3]> {
    uniform(uniform(-reach..reach).prop_map(SVector::from))
}

pub(crate) fn run<P: std::fmt::Debug>(
    seed: u64,
    cases: impl Strategy<Value = P>,
    law: impl Fn(P) -> Result<(), TestCaseError>,
) {
    if let Err(error) = runner(seed).run(&cases, law) {
        panic!("{error}");
    }
}

/// Makes one test per line: the distance of `$build(parameters)` is a distance and lies within its
/// bounds.
macro_rules! distances_are_distances {
    ($($test:ident, seed $seed:literal: $parameters:expr, $build:expr;)*) => {$(
        #[test]
        fn $test() {
            run($seed, ($parameters, triple(4.0)), |(parameters, points)| {
                let g = $build(parameters);
                is_distance(&g, points)?;
                is_bounded(&g, &points[0], &points[1])
            });
        }
    )*};
}

distances_are_distances! {
    constant_has_a_distance, seed 31: Just(()), |()| {
        let a = matrix![2.0, 1.0, 0.3; 1.0, 2.0, -0.5; 0.3, -0.5, 1.0];
        Constant::new(a).expect("positive definite")
    };
    ramp_has_a_distance, seed 32: (-0.95..0.95_f64, 0.2..4.0_f64), |(a, k)| {
        Ramp::new(a, k).expect("|a| < 1")
    };
    shear_has_a_distance, seed 33: (-2.0..2.0_f64, 0.2..3.0_f64), |(a, k)| {
        Shear::new(a, k).expect("k > 0")
    };
    separable_has_a_distance, seed 34:
        (uniform::<_, 3>(-0.95..0.95_f64), uniform::<_, 3>(0.2..3.0_f64)),
        |(a, k)| Separable::<3>::new(a, k).expect("|a| < 1");
    swirl_has_a_distance, seed 45: (-5.0..5.0_f64, 0.3..3.0_f64), |(angle, s)| {
        Swirl::new(angle, s).expect("s > 0")
    };
}

#[test]
fn corrugated_has_a_distance() {
    run(46, (-2.0..2.0_f64, 0.2..3.0_f64, triple::<3>(4.0)), |(a, k, points)| {
        let g = Corrugated::new(a, k).expect("k > 0");
        is_distance(&g, points)?;
        is_bounded(&g, &points[0], &points[1])?;
        // Arc length is additive, however many whole waves each part contains.
        let mut ends = points.map(|x| 10.0 * x[0]);
        ends.sort_by(f64::total_cmp);
        let [low, middle, high] = ends;
        let whole = g.arc_length(low, high);
        let parts = g.arc_length(low, middle) + g.arc_length(middle, high);
        prop_assert!((parts - whole).abs() <= 1e-13 * whole, "{parts} {whole}");
        prop_assert!(whole >= high - low);
        Ok(())
    });
}

#[test]
fn hyperbolic_and_sphere_have_a_distance() {
    // The points satisfy |x| ≤ √3/2.
    run(35, triple::<3>(0.5), |points| is_distance(&Hyperbolic, points));
    run(36, triple::<3>(2.0), |points| is_distance(&Sphere, points));
}

/// Checks `d(x, x + εv)² / ε² = vᵀ H(x) v + O(ε)`, with slope 1 for `ε` from 2⁻⁶ to 2⁻¹².
///
/// The next term is `O(ε)` times the first, about 1/64 at the largest `ε`. It changes the slope
/// over 6 octaves by less than 0.02. Rounding, `2 · 10⁻¹⁶ / ε`, is negligible.
fn is_local<const D: usize>(g: &impl KnownDistance<D>, x: SVector<f64, D>, v: SVector<f64, D>) {
    let speed2 = norm_squared(g, &x, &v);
    let error = |octave: i32| {
        let eps = 0.5_f64.powi(octave);
        ((distance(g, &x, &(x + v * eps)) / eps).powi(2) - speed2).abs()
    };
    assert!(error(12) < 1e-2 * speed2, "{} of {speed2}", error(12));
    let slope = (error(6) / error(12)).log2() / 6.0;
    assert!((slope - 1.0).abs() < 0.05, "{slope}");
}

#[test]
fn distances_of_near_points_are_lengths_of_chords() {
    is_local(&Ramp::new(-0.6, 1.3).expect("|a| < 1"), vector![0.4], vector![0.9]);
    let shear = Shear::new(0.5, 1.7).expect("k > 0");
    is_local(&shear, vector![0.4, 0.8], vector![0.6, -0.7]);
    let separable = Separable::new(vector![0.5, -0.8, 0.1], vector![1.0, 2.0, 0.7]);
    is_local(&separable.expect("|a| < 1"), vector![0.4, 0.8, -0.3], vector![0.6, -0.7, 0.2]);
    is_local(&Lens::new(2.0, 0.7).expect("positive"), vector![0.3, 0.4], vector![0.6, 0.8]);
    is_local(&Bump::new(4.0, 0.5).expect("positive"), vector![0.3, 0.4], vector![0.6, 0.8]);
    is_local(&Hill::new(1.5, 0.8).expect("positive"), vector![0.3, 0.4], vector![0.6, 0.8]);
    is_local(&Hyperbolic, vector![0.3, 0.4, 0.2], vector![0.6, -0.7, 0.2]);
    is_local(&Sphere, vector![0.3, 0.4, 0.2], vector![0.6, -0.7, 0.2]);
    is_local(&Valleys, vector![0.3, 0.4], vector![0.6, 0.7]);
    is_local(&Swirl::new(1.5, 0.8).expect("s > 0"), vector![0.3, 0.4], vector![0.6, -0.7]);
    let corrugated = Corrugated::new(0.6, 2.0).expect("k > 0");
    is_local(&corrugated, vector![0.3, 0.4, 0.2], vector![0.6, -0.7, 0.2]);
    let channels = TwoChannels::new(4.0, 1.0, 0.5).expect("positive");
    is_local(&channels, vector![0.3, 0.4], vector![0.2, 0.7]);
}

/// The Jacobian `J` of `flatten` satisfies `JᵀJ = H`.
#[test]
fn shear_separable_and_swirl_are_pullbacks() {
    fn pullback<const D: usize>(flat: SVector<Jet1<f64, D>, D>) -> SMatrix<f64, D, D> {
        let jacobian = SMatrix::<f64, D, D>::from_fn(|i, j| flat[i].first(j));
        jacobian.transpose() * jacobian
    }
    fn jets<const D: usize>(x: SVector<f64, D>) -> SVector<Jet1<f64, D>, D> {
        SVector::from(Jet1::variables(&x.into()))
    }
    run(43, (-2.0..2.0_f64, 0.2..3.0_f64, triple::<2>(4.0)), |(a, k, [x, ..])| {
        let g = Shear::new(a, k).expect("k > 0");
        // The entries are at most 1 + S² = 37, and the tolerance is a few ulps of this number.
        prop_assert!((pullback(g.flatten(&jets(x))) - g.gram(&x)).amax() < 1e-13);
        prop_assert!((g.unflatten(&g.flatten(&x)) - x).amax() < 1e-14);
        prop_assert_eq!(g.flatten(&x)[1], x[1]);
        Ok(())
    });
    let parameters = (uniform::<_, 3>(-0.95..0.95_f64), uniform::<_, 3>(0.2..3.0_f64));
    run(44, (parameters, triple(4.0)), |((a, k), [x, ..])| {
        let g = Separable::<3>::new(a, k).expect("|a| < 1");
        prop_assert!((pullback(g.flatten(&jets(x))) - g.gram(&x)).amax() < 1e-14);
        prop_assert_eq!(g.flatten(&vector![0.0, 0.0, 0.0]), vector![0.0, 0.0, 0.0]);
        Ok(())
    });
    run(47, (-5.0..5.0_f64, 0.3..3.0_f64, triple::<2>(4.0)), |(angle, s, [x, ..])| {
        let g = Swirl::new(angle, s).expect("s > 0");
        // The entries are at most 1 + T² < 15, with phases up to 5.
        prop_assert!((pullback(g.flatten(&jets(x))) - g.gram(&x)).amax() < 1e-13);
        prop_assert!((g.unflatten(&g.flatten(&x)) - x).amax() < 1e-14);
        prop_assert!((g.flatten(&x).norm() - x.norm()).abs() < 1e-14);
        Ok(())
    });
}

/// Two circles about the centre have the distance `R − r`, which is attained from every point.
#[test]
fn swirl_keeps_circles_about_its_centre() {
    let g = Swirl::new(2.0, 0.8).expect("s > 0");
    let point = |r: f64, angle: f64| vector![angle.cos(), angle.sin()] * r;
    let (x, r, far) = (point(0.5, 0.7), 0.5, 1.3);
    let nearest = (0..1000).map(|i| distance(&g, &x, &point(far, f64::from(i) * 0.002 * PI)));
    let nearest = nearest.fold(f64::INFINITY, f64::min);
    // The grid misses the nearest point by at most half a step, θ = 0.0032. This changes the
    // distance by less than θ² r R / 2(R − r) < 5e-6.
    assert!((0.0..5e-6).contains(&(nearest - (far - r))), "{nearest}");
    let nearest_point = g.unflatten(&(g.flatten(&x) * (far / r)));
    assert_relative_eq!(distance(&g, &x, &nearest_point), far - r, max_relative = 1e-14);
}

/// For close points of the hyperbolic ball the distance keeps its digits:
/// `d / |x − y| → 2 / (1 − |x|²)`.
#[test]
fn hyperbolic_does_not_cancel() {
    let (x, y) = (vector![0.5, 0.0], vector![0.5, 2_f64.powi(-40)]);
    let d = distance(&Hyperbolic, &x, &y) * 2_f64.powi(40);
    assert_relative_eq!(d, 2.0 / 0.75, max_relative = 1e-15);
}

/// Outside the ball `(1 − |x|²)²` is positive again, but must not pass for a metric.
#[test]
fn hyperbolic_is_nothing_outside_the_ball() {
    let outside = vector![1.0, 0.5];
    assert!(check_gram(&Hyperbolic, &outside).is_err());
    let h = Hyperbolic.gram(&SVector::from(Jet1::<f64, 2>::variables(&outside.into())))[(0, 0)];
    assert!(h.value().is_nan() && h.first(0).is_nan());
    assert!(check_gram(&Hyperbolic, &vector![0.6, 0.8]).is_err());
    for inside in [vector![0.0, 0.0], vector![0.3, 0.2]] {
        assert_eq!(Hyperbolic.distance(&inside, &outside), None);
        assert_eq!(Hyperbolic.distance(&outside, &inside), None);
        assert_eq!(Hyperbolic.distance(&inside, &vector![f64::NAN, 0.0]), None);
        // The boundary is infinitely far away.
        assert_eq!(Hyperbolic.distance(&inside, &vector![1.0, 0.0]), None);
        assert_eq!(Hyperbolic.distance(&vector![0.0, 1.0], &inside), None);
        let h = check_gram(&Hyperbolic, &inside).expect("inside the ball");
        let exact = 4.0 / (1.0 - inside.norm_squared()).powi(2);
        assert_relative_eq!(h[(1, 1)], exact, max_relative = 1e-15);
    }
}
