//! Wrong constants are refused, on the whole gallery.

use Claim::{C1, C2, LH, MH};
use tautline::gallery::{CoupledCosines, SineProjections, Valleys};
use tautline_kit::{Claim, Fault, MetricCase, Outcome, metric, prelude::*};

use super::{
    composition::{beside, product, pullback, scaled, sum},
    fault,
    gallery::{
        anisotropy, arm, bump, channels, checkerboard, corrugated, cube, decoder, egg_crate,
        fisher, hill, hyperbolic_patch, lens, period, ramp, separable, shear, sphere_patch, swirl,
    },
    with_wrong,
};

/// An attained constant that is wrong by this much is refused. Measured: `10⁻⁶` is enough for every
/// constant below.
const SMALL: f64 = 1e-4;

/// The law about one constant, for the metric with that constant multiplied by a factor.
fn law<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: Region<D>,
    constant: Claim,
    factor: f64,
) -> Outcome {
    let metric = with_wrong(metric, constant, factor);
    let case = MetricCase::new(metric, region, Effort::default());
    match constant {
        C1 => metric::c1_is_a_lower_bound(&case),
        C2 => metric::c2_is_an_upper_bound(&case),
        LH => metric::l_h_bounds_the_derivative(&case),
        MH => metric::m_h_bounds_the_second_derivative(&case),
    }
}

/// Makes every constant wrong in turn, by a little if it is attained, else by a little more than
/// its overestimation, which is given for the `loose` ones.
#[track_caller]
fn assert_refused<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: Region<D>,
    loose: &[(Claim, f64)],
) {
    for constant in Claim::ALL {
        let known = loose.iter().find(|(which, _)| *which == constant);
        let overestimation = known.map_or(1.0, |(_, known)| *known);
        let truth = law(metric, region, constant, 1.0);
        // Known to its last printed digit.
        assert!((truth.overestimation - overestimation).abs() <= 1e-3, "{truth}");
        let size = overestimation * (1.0 + SMALL + 1e-3 * f64::from(u8::from(known.is_some())));
        let factor = if constant == C1 { size } else { 1.0 / size };
        let Fault::Lie(lie) = fault(law(metric, region, constant, factor)) else {
            panic!("{constant} × {factor}")
        };
        let claimed = constant.of(&metric.constants()).expect("claimed") * factor;
        assert_eq!((lie.constant, lie.point.len(), lie.direction.len()), (constant, D, D));
        // One rounding of the product.
        assert!((lie.claimed - claimed).abs() <= 1e-15 * claimed, "{lie}");
        let beyond = if constant == C1 { lie.found < claimed } else { lie.found > claimed };
        assert!(beyond, "{lie}");
    }
}

/// One test per metric: the metric, its region, and the claims that are not attained.
macro_rules! wrong_constants {
    ($($(#[$doc:meta])* $name:ident: $metric:expr, in $region:expr, loose $loose:expr;)*) => {
        $($(#[$doc])* #[test] fn $name() { assert_refused(&$metric, $region, &$loose); })*
    };
}

wrong_constants! {
    of_the_valleys_are_refused: Valleys, in period::<2>(), loose [];
    /// The claimed `M_H` is a bound that is not attained.
    of_a_ramp_are_refused: ramp(), in cube::<1>(8.0), loose [(MH, 1.4219)];
    of_a_separable_metric_are_refused: separable(), in cube::<3>(3.2), loose [];
    of_a_shear_are_refused: shear(), in period::<2>(), loose [];
    of_a_lens_are_refused: lens(), in cube::<2>(3.0), loose [];
    /// The claimed `L_H` is a bound that is not attained.
    of_a_bump_are_refused: bump(), in cube::<2>(3.0), loose [(LH, 1.0302)];
    of_a_hill_are_refused: hill(), in cube::<2>(3.0), loose [];
    of_rotating_anisotropy_are_refused: anisotropy(), in cube::<2>(2.0), loose [];
    of_a_two_link_arm_are_refused: arm(), in period::<2>(), loose [];
    of_coupled_cosines_are_refused: CoupledCosines, in period::<3>(), loose [(MH, 1.3813)];
    /// Eight dimensions, and three claims that are bounds.
    of_sine_projections_are_refused:
        SineProjections::benchmark(), in cube::<8>(1.5),
        loose [(C2, 1.0154), (LH, 1.2389), (MH, 1.4397)];
    /// Two claims bound a sum by the bounds of its parts.
    of_a_swirl_are_refused: swirl(), in cube::<2>(3.0), loose [(LH, 1.0113), (MH, 1.0094)];
    of_an_egg_crate_are_refused: egg_crate(), in period::<2>(), loose [];
    of_a_corrugated_sheet_are_refused: corrugated(), in period::<2>(), loose [];
    of_a_checkerboard_are_refused: checkerboard(), in cube::<2>(1.5), loose [];
    /// `c₂` is attained in the limit: at the edge of the region, four widths from a channel, it is
    /// missed by `2 · 10⁻⁴`.
    of_two_channels_are_refused:
        channels(), in cube::<2>(3.0), loose [(C2, 1.0002), (LH, 1.0022), (MH, 1.1432)];
    /// `M_H` in the transition of a patch is bounded by branch and bound, to `10⁻⁴`.
    of_a_patch_of_the_sphere_are_refused: sphere_patch(), in cube::<2>(2.0), loose [(MH, 1.0001)];
    of_a_patch_of_hyperbolic_space_are_refused:
        hyperbolic_patch(), in cube::<2>(1.0), loose [(MH, 1.0001)];
    of_normal_distributions_are_refused:
        fisher(), in Region::cell([-2.0, -1.5], [2.0, 1.5]), loose [(MH, 1.0001)];
    /// The neurons are steepest at different places and in different directions.
    of_a_tanh_decoder_are_refused:
        decoder(), in cube::<2>(6.0), loose [(C2, 1.2080), (LH, 1.4576), (MH, 1.5689)];
    /// The smaller and the larger of two attained constants are attained.
    of_a_product_are_refused: product(), in beside(), loose [];
    /// The two metrics attain their constants near each other, but not all at one point.
    of_a_sum_are_refused:
        sum(), in period::<2>(), loose [(C2, 1.0016), (LH, 1.0124), (MH, 1.0080)];
    of_a_multiple_are_refused: scaled(), in cube::<2>(3.0), loose [];
    /// The matrix stretches most in another direction than the one where the shear is steepest, so
    /// that powers of that ratio are lost.
    of_an_affine_pullback_are_refused:
        pullback(), in cube::<2>(4.0),
        loose [(C1, 1.3617), (C2, 1.3617), (LH, 2.3774), (MH, 3.9979)];
}

/// A shear is no multiple of the identity and must not claim to be one; the valleys are.
#[test]
fn a_false_claim_of_isotropy_is_refused() {
    let metric = shear();
    let constants = metric.constants().isotropic();
    let wrong = WithConstants { metric, constants };
    let outcome =
        metric::is_isotropic_if_it_says_so(&MetricCase::new(wrong, period(), Effort::default()));
    let failure = outcome.failure.expect("refused");
    assert!(failure.sample.is_some(), "{failure:?}");
    let honest = MetricCase::new(Valleys, period(), Effort::default());
    let outcome = metric::is_isotropic_if_it_says_so::<_, 2>(&honest);
    outcome.assert();
    assert!(outcome.note.is_none(), "{outcome}");
}
