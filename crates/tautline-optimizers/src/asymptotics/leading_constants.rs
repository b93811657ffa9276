//! `LeadingConstants`: the predicted leading errors of both rules on smooth data.

use nalgebra::SVector;
use tautline_discretizations::{
    LeftEndpoint, Node, QuadraticModel, Rule, Trapezoidal, energy_gradient,
};
use tautline_metrics::Metric;
use tautline_sets::{ClosedSet, Ends};

use crate::{
    AsymptoticsError, Minimum, Stop,
    asymptotics::geodesic_means::GeodesicMeans,
    newton::{reduced_system::ReducedSystem, rounding::margin},
};

/// The limits, as `N → ∞`, of the errors of the discrete minimisers times `N` or `N²`, in `m²`.
///
/// Here `γ` is a minimal geodesic between the sets, `w = DH[γ̇](γ̇, γ̇) = −2 γ̇ᵀHγ̈` is the growth
/// rate of the metric along it, and integrals are over `t ∈ [0, 1]`:
///
/// | field | limit of | is |
/// | --- | --- | --- |
/// | `trapezoidal` | `N² (E_tra,N − d²)` | `(1/12) ∫ γ̈ᵀHγ̈ − (1/24) ∫ D²H[γ̇, γ̇](γ̇, γ̇)` |
/// | `left` | `N (E_l,N − d²)` | `−½ ∫ w` |
/// | `energy_trapezoidal` | `N² (E(γᵖˡ) − d²)` | `(1/12) ∫ γ̈ᵀHγ̈` |
/// | `length_trapezoidal` | `N² (L(γᵖˡ)² − d²)` | `(1/12) ∫ (γ̈ᵀHγ̈ − w²/4d²)` |
/// | `energy_left` | `N² (E(γᵖˡ) − d²)` | `(1/12) ∫ γ̈ᵀHγ̈ + ½ E″[η, η]` |
/// | `length_left` | `N² (L(γᵖˡ)² − d²)` | `(1/12) ∫ (γ̈ᵀHγ̈ − w²/4d²) + ½ E″[η, η] − V` |
///
/// To first order, the points of the left rule lie on `γ + η/N`, where `η` minimises
/// `½ E″[η, η] + F′[η]` with `F = −½ ∫ DH[γ̇](γ̇, γ̇)`. `E″` is the second variation of the energy
/// among the curves between the sets, and includes the curvature of the sets. The variance
/// `V = (∫ w² − (∫ w)²) / 4d²` is the part of `½ E″[η, η]` that shifts points along `γ`, which
/// costs energy but no length.
///
/// For the derivation see [`leading_constants`]. The limits are computed, not proved.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[doc(alias = "asymptotics")]
#[non_exhaustive]
pub struct LeadingConstants {
    /// The limit of `N² (E_tra,N − d²)`. It may have either sign.
    pub trapezoidal: f64,
    /// The limit of `N (E_l,N − d²)`. It may have either sign. It is 0 if `w` has mean 0, for
    /// example by symmetry; then `E_l,N − d²` is of second order. For `H = φ I`, and in one
    /// dimension, it is `−(d²/2) log (φ(γ(1))/φ(γ(0)))`.
    pub left: f64,
    /// The limit of `N² (E(γᵖˡ) − d²) ≥ 0` for the trapezoidal rule.
    pub energy_trapezoidal: f64,
    /// The limit of `N² (L(γᵖˡ)² − d²) ≥ 0` for the trapezoidal rule. It is 0 in one dimension.
    pub length_trapezoidal: f64,
    /// The limit of `N² (E(γᵖˡ) − d²) ≥ 0` for the left rule.
    pub energy_left: f64,
    /// The limit of `N² (L(γᵖˡ)² − d²) ≥ 0` for the left rule. It is 0 in one dimension, and equals
    /// `length_trapezoidal` for `H = φ I`.
    pub length_left: f64,
}

/// The relative decrement of the trapezoidal energy up to which a sequence counts as its minimiser.
/// A search has converged there even if rounding stops it.
const STATIONARY: f64 = 1e-10;

/// Returns the leading constants of the errors of both rules, in `m²`, along a minimiser of the
/// [`Trapezoidal`] energy. The minimiser should be computed with a large `N`. All constants are 0
/// if the sets touch.
///
/// - `ends`: the sets between which `minimum` was computed. Only the constants of the left rule's
///   curve use them.
///
/// # Derivation
///
/// For the points of a smooth curve the energies have the expansions `E_tra,N = E + N⁻² F₂ + …` and
/// `E_l,N = E + N⁻¹ F + …`. To leading order a minimum changes by the value of the perturbation at
/// the minimiser. With integration by parts and the geodesic equation, this gives the first two
/// limits. The curve `γᵖˡ` differs from the smooth curve through its points by an `r` that vanishes
/// at the points, with `∫ ṙᵀHṙ = N⁻² (1/12) ∫ γ̈ᵀHγ̈`. The points of the trapezoidal rule are off
/// by `N⁻²`, which is negligible; the points of the left rule are off by `η/N`. `E − L²` is the
/// variance of the speed. For the trapezoidal rule the speed varies only within a chord, by `w/2dN`
/// from end to end. For the left rule `E + F/N` conserves `γ̇ᵀHγ̇ − w/N`, so that the squared speed
/// also varies from chord to chord, like `w/N`: this gives `V`.
///
/// Needs: `H` is three times continuously differentiable; the minimal geodesic is unique and
/// nondegenerate (otherwise the limits hold for sequences near this one, or fail); each end is free
/// along a smooth face of its set, or fixed by a nonzero force. The derivation is formal: the
/// limits are computed and agree with measurements, but they are not proved.
///
/// Accuracy: the constants are computed to second order. The error is `(c/N)²` times the two
/// integrals, where `c` is the size of the curve divided by the scale of the metric. If a sum
/// cancels, as `left` does by symmetry, only this error remains.
///
/// # Errors
///
/// [`AsymptoticsError`] if the metric is not positive definite along the curve, or if the sequence
/// is not a nondegenerate minimiser of the trapezoidal energy between these sets.
pub fn leading_constants<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    minimum: &Minimum<D>,
) -> Result<LeadingConstants, AsymptoticsError> {
    if !minimum.is_local_minimum() {
        return Err(AsymptoticsError::Degenerate);
    }
    if minimum.stop == Stop::EndsTouch {
        return Ok(LeadingConstants::default());
    }
    let displacement = displacement_energy(metric, ends, minimum)?;
    let means = GeodesicMeans::along(metric, minimum)?;
    let shift = (means.growth_squared - means.growth.powi(2)) / (4.0 * minimum.energy);
    Ok(LeadingConstants {
        trapezoidal: means.bending / 12.0 - means.second / 24.0,
        left: -0.5 * means.growth,
        energy_trapezoidal: means.bending / 12.0,
        length_trapezoidal: means.turning / 12.0,
        energy_left: means.bending / 12.0 + displacement,
        length_left: means.turning / 12.0 + displacement - shift,
    })
}

/// The left-endpoint rule for the reversed curve.
#[derive(Clone, Copy, Debug)]
struct RightEndpoint;

impl Rule for RightEndpoint {
    const NODES: &'static [Node] = &[Node { fraction: 1.0, weight: 1.0 }];
    const ERROR_EXPONENT: i32 = 1;
}

/// Returns `½ E″[η, η]`, in `m²`. It is half the square of the Newton decrement of
/// `E_tra,N + N⁻¹ F` at the minimiser of `E_tra,N`, times `N²`. Here `(N/2) (E_l,N − E_r,N)`
/// approximates `F` to second order, unlike `N (E_l,N − E_tra,N)`.
fn displacement_energy<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    minimum: &Minimum<D>,
) -> Result<f64, AsymptoticsError> {
    let sequence = &minimum.sequence;
    let (points, n) = (sequence.points(), sequence.n().get());
    // Selects the pieces of the sets in which the curve begins and ends.
    let gap = |set: &dyn ClosedSet<D>, x: &SVector<f64, D>| (set.project(x) - x).norm();
    let pairs = ends.pairs().map(|(first, second)| {
        (gap(&*first, sequence.first()) + gap(&*second, sequence.last()), [first, second])
    });
    let nearest = pairs.min_by(|a, b| a.0.total_cmp(&b.0));
    let (_, [first, second]) = nearest.ok_or(AsymptoticsError::Degenerate)?;
    let model = QuadraticModel::new(Trapezoidal, metric, sequence);
    // The system subtracts the margin. With the margin as the shift, the Hessian is unchanged.
    let system = ReducedSystem::new(&model, [&*first, &*second], points, margin(n));
    let factorization = system.factorize().ok_or(AsymptoticsError::Degenerate)?;
    let decrement = system.newton_step(&factorization).decrement / model.energy;
    if !(decrement <= STATIONARY) {
        return Err(AsymptoticsError::NotStationary { decrement });
    }
    let (_, left) = energy_gradient(LeftEndpoint, metric, sequence);
    let (_, right) = energy_gradient(RightEndpoint, metric, sequence);
    let half = 0.5 * n as f64;
    let gradient: Vec<_> = left.iter().zip(&right).map(|(l, r)| (l - r) * half).collect();
    Ok(system.decrement_of(&factorization, &gradient))
}

#[cfg(test)]
mod tests {
    use std::f64::consts::PI;

    use approx::assert_relative_eq;
    use nalgebra::matrix;
    use tautline_discretizations::{Interpolation, LeftEndpoint, Rule, Trapezoidal};
    use tautline_metrics::{
        KnownDistance, Metric,
        gallery::{Constant, Lens, Ramp, Shear, Valleys},
        quadrature::integrate,
    };
    use tautline_sets::{Ball, Ends, FiniteSet, HalfSpace, Point, Sphere};

    use super::{LeadingConstants, leading_constants};
    use crate::{AsymptoticsError, Minimum, Options, extrapolate, minimise};

    const N: usize = 4096;

    /// `(c/N)²` with `c = 4π`, the length of the longest curve here in units of the scale of its
    /// metric.
    const SECOND_ORDER: f64 = 1e-5;

    fn solve<R: Rule, const D: usize>(
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        rule: R,
        n: usize,
    ) -> Minimum<D> {
        minimise(metric, ends, rule, n, &Options::default()).expect("a metric")
    }

    fn constants<const D: usize>(metric: &impl Metric<D>, ends: &Ends<D>) -> LeadingConstants {
        let minimum = solve(metric, ends, Trapezoidal, N);
        leading_constants(metric, ends, &minimum).expect("a minimum")
    }

    fn values(c: &LeadingConstants) -> [f64; 6] {
        [
            c.trapezoidal,
            c.left,
            c.energy_trapezoidal,
            c.length_trapezoidal,
            c.energy_left,
            c.length_left,
        ]
    }

    /// Compares the constants up to an error of second order relative to the largest of the six,
    /// since some sums cancel.
    #[track_caller]
    fn assert_values(computed: &LeadingConstants, expected: [f64; 6]) {
        let scale = expected.iter().fold(0.0_f64, |scale, value| scale.max(value.abs()));
        for (computed, expected) in values(computed).into_iter().zip(expected) {
            let error = (computed - expected).abs();
            assert!(error <= SECOND_ORDER * scale, "{computed} is not {expected}");
        }
    }

    #[test]
    fn under_a_constant_metric_there_is_no_error() {
        let metric = Constant::new(matrix![1.0, 0.6; 0.6, 2.0]).expect("definite");
        let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
        let wall = HalfSpace::at_least([1.0, 0.3], 3.0).expect("a normal");
        let ends = Ends::new(ball, wall).expect("one bounded");
        assert_eq!(values(&constants(&metric, &ends)), [0.0; 6]);
    }

    #[test]
    fn between_sets_that_touch_there_is_no_error() {
        let ball = Ball::new([0.0, 0.0], 1.0).expect("a radius");
        let ends = Ends::new(ball, Point::new([0.5, 0.0]).expect("finite")).expect("bounded");
        assert_eq!(values(&constants(&Valleys, &ends)), [0.0; 6]);
    }

    /// With `φ = f²` and `dt = f dx/d`, the geodesic satisfies `γ̈ = −f′ γ̇²/f`. So
    /// `∫ γ̈ᵀHγ̈ = d³ ∫ f′²/f³ dx`, `D²H[γ̇, γ̇](γ̇, γ̇) = 2 (f′² + f f″) γ̇⁴` and `w = 2d³ f′/f²`.
    /// The curve `γᵖˡ` is the segment.
    #[test]
    fn in_one_dimension_everything_is_explicit() {
        let ramp = Ramp::new(0.5, 1.0).expect("a ramp");
        let f = |x: f64| 1.0 + 0.5 * x.tanh();
        let first = |x: f64| 0.5 * x.cosh().powi(-2);
        let second = |x: f64| -x.cosh().powi(-2) * x.tanh();
        let (a, b) = (-1.0, 2.0);
        let d = ramp.distance(&[a].into(), &[b].into()).expect("all pairs");
        let bending = d.powi(3) * integrate(|x| first(x).powi(2) / f(x).powi(3), a, b, 1e-13).value;
        let bent = d.powi(3) * integrate(|x| second(x) / f(x).powi(2), a, b, 1e-13).value;
        // −(d²/2) log (φ(γ(1))/φ(γ(0))).
        let left = -0.5 * d * d * (f(b).powi(2) / f(a).powi(2)).ln();
        let energy_left = 13.0 / 12.0 * bending - left * left / (d * d);
        let computed = constants(&ramp, &Ends::points([a], [b]).expect("finite"));
        let expected = [-bent / 12.0, left, bending / 12.0, 0.0, energy_left, 0.0];
        assert_values(&computed, expected);
        // For the reversed curve the error of the left rule changes sign.
        let back = constants(&ramp, &Ends::points([b], [a]).expect("finite"));
        assert_values(&back, [-bent / 12.0, -left, bending / 12.0, 0.0, energy_left, 0.0]);
    }

    /// For the trapezoidal rule the constants are `−(8π)³ π/9√3` and minus half of it, by
    /// `∫₀^{2π} sin² x (2 − cos x)⁻³ dx = π/3√3`. For the left rule the constant is `13` times that
    /// half, with `∫ w = 0` by symmetry.
    #[test]
    fn over_the_valleys_the_constants_are_explicit() {
        let ends = Ends::points([0.0, 0.0], [4.0 * PI, 0.0]).expect("finite");
        let half = (8.0 * PI).powi(3) * PI / (18.0 * 3_f64.sqrt());
        let computed = constants(&Valleys, &ends);
        assert_values(&computed, [-2.0 * half, 0.0, half, 0.0, 13.0 * half, 0.0]);
        // The sums that cancel satisfy a tighter tolerance.
        assert!(computed.left.abs() < 1e-9 && computed.length_trapezoidal.abs() < 1e-9);
    }

    /// In the flat coordinates `u` the geodesic is `u = (s, 3) t` with `s = 2 + ½ sin 3`, so that
    /// `γ̈ = (9/2 sin 3t, 0)` and `w = −9 s sin 3t`. There `E″[ζ, ζ] = 2 ∫ |ζ̇|²` and
    /// `F = ½ ∫ u̇₁ sin u₂ u̇₂²`. The minimiser has `ζ̇ = −¾ (3, s) (sin 3t − mean)`.
    #[test]
    fn on_a_shear_the_constants_are_explicit() {
        let s = 2.0 + 0.5 * 3_f64.sin();
        let d2 = s * s + 9.0;
        let (mean, square) = ((1.0 - 3_f64.cos()) / 3.0, 0.5 - 6_f64.sin() / 12.0);
        let variance = square - mean * mean;
        let bending = 81.0 / 4.0 * square;
        // D²H[v, v](v, v) = 2 |DJ[v] v|² + 2 Jv · D²J[v, v] v, where J v₁ = v₁ + ½ cos(x₂) v₂.
        let wave = 3_f64.sin() / 3.0;
        let second = 2.0 * bending - 27.0 * s * wave;
        let turning = bending * 9.0 / d2;
        let displacement = 9.0 / 16.0 * d2 * variance;
        let shift = 81.0 * s * s * variance / (4.0 * d2);
        let ends = Ends::points([0.0, 0.0], [2.0, 3.0]).expect("finite");
        let computed = constants(&Shear::new(0.5, 1.0).expect("a wave number"), &ends);
        let expected = [
            bending / 12.0 - second / 24.0,
            4.5 * s * mean,
            bending / 12.0,
            turning / 12.0,
            bending / 12.0 + displacement,
            turning / 12.0 + displacement - shift,
        ];
        assert_values(&computed, expected);
    }

    /// Under `φ I` the error of the left rule depends only on `log φ` at the ends. To first order
    /// its curve follows the geodesic, at another speed.
    #[test]
    fn under_a_conformal_metric_both_rules_have_the_same_length() {
        let (a, b) = ([0.0, 0.0], [2.0, 1.5]);
        let computed = constants(&Valleys, &Ends::points(a, b).expect("finite"));
        assert!(computed.length_trapezoidal > 0.5);
        let tolerance = SECOND_ORDER * computed.energy_left;
        assert!((computed.length_left - computed.length_trapezoidal).abs() <= tolerance);
        let d = Valleys.distance(&a.into(), &b.into()).expect("no turning point");
        let log = 2.0 * (2.0 - 2_f64.cos()).ln();
        assert_relative_eq!(computed.left, -0.5 * d * d * log, max_relative = SECOND_ORDER);
    }

    /// Both ends of the left rule's curve slide along circles. Extrapolation over grids of 512 and
    /// 1024 chords eliminates two terms of the expansion in `1/N`, which leaves an error of up to
    /// `(10/N)²`.
    #[test]
    fn between_curved_sets_the_left_curve_is_as_predicted() {
        let lens = Lens::new(1.0, 1.0).expect("a lens");
        let ball = |x: [f64; 2], r: f64| Ball::new(x, r).expect("a radius");
        let ends = Ends::new(ball([-1.5, 0.4], 0.5), ball([1.5, 0.9], 0.25)).expect("bounded");
        let fine = solve(&lens, &ends, Trapezoidal, N);
        let d2 = extrapolate(&fine.levels, 2).expect("five grids").value;
        let scaled = |n: usize| {
            let line = solve(&lens, &ends, LeftEndpoint, n).sequence;
            (n * n) as f64 * (Interpolation::new(&line).energy(&lens).value - d2)
        };
        let measured = 2.0 * scaled(1024) - scaled(512);
        let computed = leading_constants(&lens, &ends, &fine).expect("a minimum");
        assert_relative_eq!(computed.energy_left, measured, max_relative = 1e-4);
        // If the ends are fixed, the number is different.
        let line = &fine.sequence;
        let fixed = Ends::points(*line.first(), *line.last()).expect("finite");
        let fixed = leading_constants(&lens, &fixed, &fine).expect("a minimum");
        assert!(fixed.energy_left < 0.99 * computed.energy_left);
    }

    #[test]
    fn only_the_pieces_that_the_curve_joins_count() {
        let (a, b) = ([0.0, 0.0], [2.0, 1.5]);
        let points = Ends::points(a, b).expect("finite");
        let several = |x| FiniteSet::new([[9.0, 9.0], x, [-7.0, 3.0]]).expect("finite");
        let [start, goal] = [a, b].map(|x| Point::new(x).expect("finite"));
        let minimum = solve(&Valleys, &points, Trapezoidal, 256);
        let computed =
            |ends: &Ends<2>| leading_constants(&Valleys, ends, &minimum).expect("a minimum");
        for ends in [
            Ends::new(start, several(b)),
            Ends::new(several(a), goal),
            Ends::new(several(a), several(b)),
        ] {
            let ends = ends.expect("bounded");
            assert_eq!(computed(&ends), computed(&points));
        }
    }

    #[test]
    fn a_minimiser_of_another_problem_is_refused() {
        let ends = Ends::points([0.0, 0.0], [2.0, 1.5]).expect("finite");
        let elsewhere = Ends::points([0.1, 0.0], [2.0, 1.5]).expect("finite");
        let left = solve(&Valleys, &ends, LeftEndpoint, 256);
        let right = solve(&Valleys, &ends, Trapezoidal, 256);
        for (ends, minimum) in [(&ends, &left), (&elsewhere, &right)] {
            let refused = leading_constants(&Valleys, ends, minimum);
            let Err(AsymptoticsError::NotStationary { decrement }) = refused else {
                panic!("{refused:?}")
            };
            assert!(decrement > 1e-8, "{decrement:e}");
        }
    }

    #[test]
    fn a_minimiser_in_a_continuum_is_refused() {
        let metric = Constant::new(matrix![1.0, 0.0; 0.0, 1.0]).expect("definite");
        let sphere = |r: f64| Sphere::new([0.0, 0.0], r).expect("a radius");
        let ends = Ends::new(sphere(1.0), sphere(2.0)).expect("bounded");
        let minimum = solve(&metric, &ends, Trapezoidal, 64);
        let refused = leading_constants(&metric, &ends, &minimum);
        assert_eq!(refused, Err(AsymptoticsError::Degenerate));
    }
}
