//! Tests properties that hold in every case, on random metrics and random ends, for `N` from 1 to
//! 200 and both rules.

use nalgebra::{SVector, vector};
use proptest::prelude::*;
use tautline_discretizations::{Interpolation, Rule};
use tautline_metrics::{
    KnownDistance, Metric,
    gallery::{Bump, Lens, Ramp, Separable, Shear, Valleys},
};
use tautline_optimizers::{Minimum, Options, Starts, Stop, minimise};
use tautline_sets::{AxisBox, ClosedSet, Ends, Segment, Sphere};

use crate::setup::{ball, between, from_to, half_space, lowest, only, point, sequence, straight};

fn vector<const D: usize>(size: f64) -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-size..size).prop_map(SVector::from)
}

/// The ends are two points, or a bounded set of any kind about `−3e₁` and a set of any kind about
/// `3e₁`.
fn ends<const D: usize>() -> impl Strategy<Value = Ends<D>> {
    let points = (vector::<D>(4.0), vector::<D>(4.0)).prop_map(|(a, b)| from_to(a, b));
    let sets = (0..4_usize, 0..5_usize, vector::<D>(1.0), vector::<D>(1.0), 0.0..0.8_f64);
    let sets = sets.prop_map(|(first, second, a, b, size)| {
        let on_axis = |x: f64| SVector::from_fn(|i, _| if i == 0 { x } else { 0.0 });
        let (a, b) = (a + on_axis(-3.0), b + on_axis(3.0));
        let bounded = |kind: usize, c: SVector<f64, D>| -> std::sync::Arc<dyn ClosedSet<D>> {
            match kind {
                0 => std::sync::Arc::new(ball(c, size)),
                1 => std::sync::Arc::new(
                    AxisBox::new(c, SVector::repeat(size)).expect("half-widths"),
                ),
                2 => std::sync::Arc::new(Sphere::new(c, size).expect("a radius")),
                3 => std::sync::Arc::new(
                    Segment::new(c - SVector::repeat(size), c + on_axis(size)).expect("finite"),
                ),
                _ => std::sync::Arc::new(half_space(SVector::repeat(size) + on_axis(1.0), 3.0)),
            }
        };
        between(bounded(first, a), bounded(second, b))
    });
    prop_oneof![1 => points, 2 => sets]
}

/// Most cases have few chords, for which discrete minima are odd.
fn chords() -> impl Strategy<Value = usize> {
    prop_oneof![1_usize..12, 12_usize..200]
}

/// Checks both rules. `sine` is a phase of the perturbations.
fn check<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    n: usize,
    sine: f64,
) -> Result<(), TestCaseError> {
    check_rule(metric, ends, Rule::TRAPEZOIDAL, n, sine)?;
    check_rule(metric, ends, Rule::LEFT_ENDPOINT, n, sine)
}

fn check_rule<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    sine: f64,
) -> Result<(), TestCaseError> {
    let solve = |starts| {
        let options = Options { starts, ..Options::default() };
        minimise(metric, ends, rule, n, &options).expect("a metric everywhere")
    };
    let minimum = solve(Starts::Automatic);
    stops_well(&minimum)?;
    if minimum.stop == Stop::EndsTouch {
        prop_assert_eq!(minimum.energy, 0.0);
        return Ok(());
    }
    // The start is the straight line between nearest points, which alternating projections find.
    let mut a = ends.first().project(&SVector::zeros());
    let mut b = ends.second().project(&a);
    for _ in 0..50 {
        a = ends.first().project(&b);
        b = ends.second().project(&a);
    }
    let straight = straight(a, b, n);
    let energy = rule.energy(metric, &straight);
    prop_assert!(minimum.energy <= energy * (1.0 + 1e-12), "{} {energy}", minimum.energy);
    // This search begins from that start alone.
    let alone = solve(Starts::Only(vec![straight]));
    stops_well(&alone)?;
    prop_assert!(alone.energy <= energy * (1.0 + 1e-12), "{} {energy}", alone.energy);
    prop_assert!(
        minimum.energy <= alone.energy * (1.0 + 1e-9),
        "{} {}",
        minimum.energy,
        alone.energy
    );
    not_lowered(metric, ends, rule, &minimum, sine)
}

fn stops_well<const D: usize>(minimum: &Minimum<D>) -> Result<(), TestCaseError> {
    let good = matches!(minimum.stop, Stop::Converged | Stop::EndsTouch);
    prop_assert!(good, "{:?} {:?}", minimum.stop, minimum.curvature);
    for value in [minimum.energy, minimum.decrement, minimum.residual, minimum.residual_floor] {
        prop_assert!((0.0..f64::INFINITY).contains(&value), "{value}");
    }
    prop_assert!(minimum.decrement <= 1e-18, "decrement {:e}", minimum.decrement);
    Ok(())
}

/// No perturbation with its ends in the sets lowers the energy. The perturbations are waves and
/// single points. Their sizes decrease from `1e-3`, which stays near a shallow minimum, down to
/// rounding.
fn not_lowered<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    rule: Rule,
    minimum: &Minimum<D>,
    sine: f64,
) -> Result<(), TestCaseError> {
    let points = minimum.sequence.points();
    let n = points.len() - 1;
    for trial in 0..24 {
        let size = 1e-3 * 0.1_f64.powi(trial % 4) * if trial % 2 == 0 { 1.0 } else { -1.0 };
        let phase = |i: usize| sine + 1.7 * i as f64 + 0.9 * f64::from(trial);
        let moved = |k: usize| {
            let t = k as f64 / n as f64;
            let wave = SVector::<f64, D>::from_fn(|i, _| {
                (phase(i) + f64::from(trial % 5) * std::f64::consts::PI * t).sin()
            });
            let single = k == (trial as usize * 7919 + 1) % (n + 1);
            points[k] + wave * if trial < 16 || single { size } else { 0.0 }
        };
        let mut perturbed: Vec<_> = (0..=n).map(moved).collect();
        perturbed[0] = ends.first().project(&perturbed[0]);
        perturbed[n] = ends.second().project(&perturbed[n]);
        let perturbed = sequence(perturbed);
        let energy = rule.energy(metric, &perturbed);
        // No step lowers the energy by more than the decrement, 1e-18. Each term of the sum is
        // rounded, by 1e-14 in eight dimensions.
        prop_assert!(energy >= minimum.energy * (1.0 - 3e-14), "{energy} below at {trial}");
    }
    Ok(())
}

/// Checks that `d² ≤ E(γᵖˡ)`, up to the errors of the quadrature and of the reference.
fn not_below<const D: usize>(
    metric: &impl KnownDistance<D>,
    a: SVector<f64, D>,
    b: SVector<f64, D>,
    n: usize,
) -> Result<(), TestCaseError> {
    let ends = from_to(a, b);
    let Some(d) = metric.distance(&a, &b) else { return Ok(()) };
    for minimum in
        [lowest(metric, &ends, Rule::LEFT_ENDPOINT, n), lowest(metric, &ends, Rule::TRAPEZOIDAL, n)]
    {
        stops_well(&minimum)?;
        let energy = Interpolation::new(&minimum.sequence).energy(metric);
        // Each primitive is at most 10 and has an error of about 4e-15; the sum of squares has a
        // similar error.
        let error = energy.error + 2e-14 * d + 1e-13 * d * d;
        prop_assert!(d * d <= energy.value + error, "{} below {}", energy.value, d * d);
    }
    Ok(())
}

proptest! {
    #![proptest_config(tautline_chance::config(17, 400))]

    #[test]
    fn shear(
        (amplitude, k) in (-0.8..0.8_f64, 0.3..2.0_f64),
        ends in ends::<2>(), n in chords(), sine in 0.0..6.0_f64,
        (a, b) in (vector::<2>(4.0), vector::<2>(4.0)),
    ) {
        let shear = Shear::new(amplitude, k).expect("k > 0");
        check(&shear, &ends, n, sine)?;
        not_below(&shear, a, b, n)?;
    }

    #[test]
    fn separable(
        (amplitudes, k) in (vector::<3>(0.8), 0.3..2.0_f64),
        ends in ends::<3>(), n in chords(), sine in 0.0..6.0_f64,
        (a, b) in (vector::<3>(4.0), vector::<3>(4.0)),
    ) {
        let metric = Separable::new(amplitudes, vector![k, 1.0, 0.5]).expect("below one");
        check(&metric, &ends, n, sine)?;
        not_below(&metric, a, b, n)?;
    }

    #[test]
    fn ramp(
        (amplitude, k) in (-0.9..0.9_f64, 0.3..3.0_f64),
        ends in ends::<1>(), n in chords(), sine in 0.0..6.0_f64,
        (a, b) in (vector::<1>(4.0), vector::<1>(4.0)),
    ) {
        let ramp = Ramp::new(amplitude, k).expect("below one");
        check(&ramp, &ends, n, sine)?;
        not_below(&ramp, a, b, n)?;
    }

    #[test]
    fn valleys(
        ends in ends::<2>(), n in chords(), sine in 0.0..6.0_f64,
        (a, b) in (vector::<2>(4.0), vector::<2>(4.0)),
    ) {
        check(&Valleys, &ends, n, sine)?;
        not_below(&Valleys, a, b, n)?;
    }

    #[test]
    fn lens(
        (height, width) in (0.0..8.0_f64, 0.3..1.5_f64),
        ends in ends::<2>(), n in chords(), sine in 0.0..6.0_f64,
    ) {
        check(&Lens::new(height, width).expect("positive"), &ends, n, sine)?;
    }

    #[test]
    fn bump(
        (height, width) in (0.0..4.0_f64, 0.3..1.5_f64),
        ends in ends::<2>(), n in chords(), sine in 0.0..6.0_f64,
    ) {
        check(&Bump::new(height, width).expect("positive"), &ends, n, sine)?;
    }
}

/// A random start ends in a minimum that is not lower than the minimum from the automatic starts.
#[test]
fn random_starts_find_nothing_lower() {
    let bump = crate::setup::bump();
    let ends = between(point([-2.0, 0.2]), ball([2.0, 0.0], 0.4));
    let automatic = lowest(&bump, &ends, Rule::TRAPEZOIDAL, 64);
    let mut same = 0;
    for k in 0..40 {
        let phase = |i: f64, j: f64| (12.9 * i + 78.2 * j + 3.7 * f64::from(k)).sin() * 1.2;
        let points = (0..=16).map(|j| {
            let t = f64::from(j);
            vector![t / 4.0 - 2.0 + phase(1.0, t), phase(2.0, t)]
        });
        let start = sequence(points.collect());
        let options = only(start);
        let minimum = minimise(&bump, &ends, Rule::TRAPEZOIDAL, 64, &options).expect("a metric");
        assert!(minimum.is_local_minimum(), "{:?} {:?}", minimum.stop, minimum.curvature);
        assert!(automatic.energy <= minimum.energy * (1.0 + 1e-13));
        same += usize::from(minimum.energy <= automatic.energy * (1.0 + 1e-12));
    }
    assert!((10..40).contains(&same), "{same} of 40: there are two sides");
}
