//! Constants that are not those of the metric, on the whole gallery.

use Claim::{C1, C2, LH, MH};
use tautline::gallery::{CoupledCosines, SineProjections, Valleys};
use tautline_kit::{Claim, Fault, MetricCase, Outcome, metric, prelude::*};
use tautline_statements::WithConstants;

use super::{
    composition::{beside, product, pullback, scaled, sum},
    gallery::{
        anisotropy, arm, bump, channels, checkerboard, corrugated, cube, decoder, egg_crate,
        fisher, hill, hyperbolic_patch, lens, period, ramp, separable, shear, sphere_patch, swirl,
    },
};

/// A lie of this size about an attained constant is refused. Measured: one of `10⁻⁶` is, for every
/// constant below.
const SMALL: f64 = 1e-4;

/// The metric with one of its constants multiplied by a factor, put to the law about that constant.
fn put<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: Region<D>,
    constant: Claim,
    factor: f64,
) -> Outcome {
    let claimed = metric.constants();
    let by = |which| if which == constant { factor } else { 1.0 };
    let [c1, c2] = [claimed.c1() * by(C1), claimed.c2() * by(C2)];
    let constants = Constants::new(c1, c2, claimed.l_h() * by(LH));
    let m_h = claimed.m_h().expect("claimed") * by(MH);
    let constants = constants.and_then(|constants| constants.with_m_h(m_h)).expect("in order");
    let liar = MetricCase::new(WithConstants { metric, constants }, region, Effort::default());
    match constant {
        C1 => metric::c1_is_a_lower_bound(&liar),
        C2 => metric::c2_is_an_upper_bound(&liar),
        LH => metric::l_h_bounds_the_derivative(&liar),
        MH => metric::m_h_bounds_the_second_derivative(&liar),
    }
}

/// Tells a small lie about every constant that is attained, and one of twice its looseness about
/// every other.
#[track_caller]
fn liars_are_refused<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: Region<D>,
    loose: &[(Claim, f64)],
) {
    for constant in Claim::ALL {
        let known = loose.iter().find(|(which, _)| *which == constant);
        let looseness = known.map_or(1.0, |(_, looseness)| *looseness);
        let truth = put(metric, region, constant, 1.0);
        // The looseness is known to its last printed digit.
        assert!((truth.overestimation - looseness).abs() <= 1e-3, "{truth}");
        let size = looseness * (1.0 + SMALL + 1e-3 * f64::from(u8::from(known.is_some())));
        let factor = if constant == C1 { size } else { 1.0 / size };
        let outcome = put(metric, region, constant, factor);
        let failure = outcome.failure.unwrap_or_else(|| panic!("{constant} × {factor} passes"));
        let Fault::Lie(lie) = failure.fault else { panic!("{failure}") };
        let claimed = constant.of(&metric.constants()).expect("claimed") * factor;
        assert_eq!((lie.constant, lie.point.len(), lie.direction.len()), (constant, D, D));
        // One rounding of the product.
        assert!((lie.claimed - claimed).abs() <= 1e-15 * claimed, "{lie}");
        let beyond = if constant == C1 { lie.found < claimed } else { lie.found > claimed };
        assert!(beyond, "{lie}");
    }
}

#[test]
fn liars_about_the_valleys_are_refused() {
    liars_are_refused(&Valleys, period::<2>(), &[]);
}

/// The claim `M_H` of a ramp is a bound that is not attained.
#[test]
fn liars_about_a_ramp_are_refused() {
    liars_are_refused(&ramp(), cube::<1>(8.0), &[(MH, 1.4219)]);
}

#[test]
fn liars_about_a_separable_metric_are_refused() {
    liars_are_refused(&separable(), cube::<3>(3.2), &[]);
}

#[test]
fn liars_about_a_shear_are_refused() {
    liars_are_refused(&shear(), period::<2>(), &[]);
}

#[test]
fn liars_about_a_lens_are_refused() {
    liars_are_refused(&lens(), cube::<2>(3.0), &[]);
}

/// The claim `L_H` of a bump is a bound that is not attained.
#[test]
fn liars_about_a_bump_are_refused() {
    liars_are_refused(&bump(), cube::<2>(3.0), &[(LH, 1.0302)]);
}

#[test]
fn liars_about_a_hill_are_refused() {
    liars_are_refused(&hill(), cube::<2>(3.0), &[]);
}

#[test]
fn liars_about_rotating_anisotropy_are_refused() {
    liars_are_refused(&anisotropy(), cube::<2>(2.0), &[]);
}

#[test]
fn liars_about_a_two_link_arm_are_refused() {
    liars_are_refused(&arm(), period::<2>(), &[]);
}

#[test]
fn liars_about_coupled_cosines_are_refused() {
    liars_are_refused(&CoupledCosines, period::<3>(), &[(MH, 1.3813)]);
}

/// Eight dimensions, and three claims that are bounds.
#[test]
fn liars_about_sine_projections_are_refused() {
    let loose = [(C2, 1.0154), (LH, 1.2389), (MH, 1.4397)];
    liars_are_refused(&SineProjections::benchmark(), cube::<8>(1.5), &loose);
}

/// Both claims are bounds of a sum by the two of its parts.
#[test]
fn liars_about_a_swirl_are_refused() {
    liars_are_refused(&swirl(), cube::<2>(3.0), &[(LH, 1.0113), (MH, 1.0094)]);
}

#[test]
fn liars_about_an_egg_crate_are_refused() {
    liars_are_refused(&egg_crate(), period::<2>(), &[]);
}

#[test]
fn liars_about_a_corrugated_sheet_are_refused() {
    liars_are_refused(&corrugated(), period::<2>(), &[]);
}

#[test]
fn liars_about_a_checkerboard_are_refused() {
    liars_are_refused(&checkerboard(), cube::<2>(1.5), &[]);
}

/// `c₂` is attained in the limit: at the edge of the region, four widths from a channel, it is
/// missed by `2 · 10⁻⁴`.
#[test]
fn liars_about_two_channels_are_refused() {
    let loose = [(C2, 1.0002), (LH, 1.0022), (MH, 1.1432)];
    liars_are_refused(&channels(), cube::<2>(3.0), &loose);
}

/// `M_H` in the transition is bounded by branch and bound: `10⁻⁴` of it are left.
#[test]
fn liars_about_patches_are_refused() {
    liars_are_refused::<_, 2>(&sphere_patch(), cube(2.0), &[(MH, 1.0001)]);
    liars_are_refused::<_, 2>(&hyperbolic_patch(), cube(1.0), &[(MH, 1.0001)]);
    liars_are_refused(&fisher(), Region::cell([-2.0, -1.5], [2.0, 1.5]), &[(MH, 1.0001)]);
}

/// Neurons that are not steepest at one place, nor in one direction.
#[test]
fn liars_about_a_tanh_decoder_are_refused() {
    let loose = [(C2, 1.2080), (LH, 1.4576), (MH, 1.5689)];
    liars_are_refused(&decoder(), cube::<2>(6.0), &loose);
}

/// The lesser and the greater of constants that are attained are attained.
#[test]
fn liars_about_a_product_are_refused() {
    liars_are_refused(&product(), beside(), &[]);
}

/// The two metrics attain theirs near each other, but not all at one point.
#[test]
fn liars_about_a_sum_are_refused() {
    let loose = [(C2, 1.0016), (LH, 1.0124), (MH, 1.0080)];
    liars_are_refused(&sum(), period::<2>(), &loose);
}

#[test]
fn liars_about_a_multiple_are_refused() {
    liars_are_refused(&scaled(), cube::<2>(3.0), &[]);
}

/// The matrix stretches most in another direction than the one where the shear is steepest: the
/// powers of that ratio are lost.
#[test]
fn liars_about_an_affine_pullback_are_refused() {
    let loose = [(C1, 1.3617), (C2, 1.3617), (LH, 2.3774), (MH, 3.9979)];
    liars_are_refused(&pullback(), cube::<2>(4.0), &loose);
}

/// A shear is no multiple of the identity, and may not say so; the valleys are.
#[test]
fn a_metric_may_not_call_itself_isotropic_if_it_is_not() {
    let metric = shear();
    let constants = metric.constants().isotropic();
    let liar = WithConstants { metric, constants };
    let outcome =
        metric::is_isotropic_if_it_says_so(&MetricCase::new(liar, period(), Effort::default()));
    let failure = outcome.failure.expect("refused");
    assert!(failure.sample.is_some(), "{failure:?}");
    let honest = MetricCase::new(Valleys, period(), Effort::default());
    let outcome = metric::is_isotropic_if_it_says_so::<_, 2>(&honest);
    outcome.assert();
    assert!(outcome.note.is_none(), "{outcome}");
}
