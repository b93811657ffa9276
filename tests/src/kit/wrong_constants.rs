//! The kit refuses wrong constants, on the whole gallery.

use Claim::{C1, C2, LH, MH};
use tautline::gallery::*;
use tautline_kit::{Claim, Fault, MetricCase, Outcome, metric, prelude::*};

use super::{
    composition::{beside, product, pullback, scaled, shear, sum},
    fault,
    gallery::{cube, period, separable_in_space},
    with_wrong,
};

/// The relative error at which a wrong constant must be refused if the true one is attained. An
/// error of `10⁻⁶` would be enough for every constant below, as measured.
const SMALL: f64 = 1e-4;

/// Evaluates the law about one constant, for the metric with that constant multiplied by a factor.
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

/// Makes each constant wrong, one at a time. An attained constant is made wrong by a little. A
/// constant listed in `loose` is made wrong by a little more than its overestimation.
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
        // If the constant is 0, any multiple of it is correct too.
        if constant.of(&metric.constants()) == Some(0.0) {
            assert!(truth.holds(), "{truth}");
            continue;
        }
        // The overestimations are given to their last printed digit.
        assert!((truth.overestimation - overestimation).abs() <= 1e-3, "{truth}");
        let size = overestimation * (1.0 + SMALL + 1e-3 * f64::from(u8::from(known.is_some())));
        let factor = if constant == C1 { size } else { 1.0 / size };
        let Fault::Lie(lie) = fault(law(metric, region, constant, factor)) else {
            panic!("{constant} × {factor}")
        };
        let claimed = constant.of(&metric.constants()).expect("claimed") * factor;
        assert_eq!((lie.constant, lie.point.len(), lie.direction.len()), (constant, D, D));
        // The product has one rounding.
        assert!((lie.claimed - claimed).abs() <= 1e-15 * claimed, "{lie}");
        let beyond = if constant == C1 { lie.found < claimed } else { lie.found > claimed };
        assert!(beyond, "{lie}");
    }
}

/// Returns the constants that a sample does not attain in its cell, each with bound ÷ observed
/// there, correct to the last digit. The two channels miss `c₂` by `2 · 10⁻⁴`, since the cell
/// reaches only four widths from a channel.
fn loose(sample: &str) -> &'static [(Claim, f64)] {
    match sample {
        "a_ramp" => &[(MH, 1.4219)],
        "a_bump" => &[(LH, 1.0302)],
        "soft_obstacles" => &[(C2, 1.2740), (LH, 1.2881), (MH, 1.2134)],
        "a_swirl" => &[(LH, 1.0113), (MH, 1.0094)],
        "two_channels" => &[(C2, 1.0002), (LH, 1.0022), (MH, 1.1432)],
        "coupled_cosines" => &[(MH, 1.3813)],
        "sine_projections" => &[(LH, 1.2968), (MH, 1.5001)],
        "a_patch_of_the_sphere" | "a_patch_of_hyperbolic_space" | "normal_distributions" => {
            &[(MH, 1.0001)]
        }
        "a_tanh_decoder" => &[(C2, 1.2080), (LH, 1.4576), (MH, 1.5689)],
        _ => &[],
    }
}

macro_rules! wrong_constants_are_refused {
    ($(
        $id:ident: $name:literal, $metric:expr, dimension $D:literal, in [$low:expr, $high:expr],
        exact $exact:expr $(, with $distances:ident)?;
    )*) => {$(
        mod $id {
            use super::*;

            #[test]
            fn wrong_constants_are_refused() {
                let metric = $metric.expect("in range");
                assert_refused::<_, $D>(
                    &metric, Region::cell($low, $high), loose(stringify!($id)),
                );
            }
        }
    )*};
}

for_each_sample!(wrong_constants_are_refused);

/// Generates the tests of single metrics from the metric, its region, and the claims that are not
/// attained.
macro_rules! wrong_constants {
    ($($(#[$doc:meta])* $name:ident: $metric:expr, in $region:expr, loose $loose:expr;)*) => {
        $($(#[$doc])* #[test] fn $name() { assert_refused(&$metric, $region, &$loose); })*
    };
}

wrong_constants! {
    of_rotating_anisotropy_against_an_axis_are_refused:
        RotatingAnisotropy::new([1.0, 4.0], [0.7, -1.1]).expect("eigenvalues"),
        in cube::<2>(2.0), loose [];
    of_a_separable_metric_in_space_are_refused: separable_in_space(), in cube::<3>(3.2), loose [];
    /// The metric has eight dimensions, and three of its constants are bounds that are not
    /// attained.
    of_sine_projections_in_eight_dimensions_are_refused:
        SineProjections::benchmark(), in cube::<8>(1.5),
        loose [(C2, 1.0154), (LH, 1.2389), (MH, 1.4397)];
    /// The constants of a product are the smaller and the larger of two attained constants, so they
    /// are attained.
    of_a_product_are_refused: product(), in beside(), loose [];
    /// The two metrics attain their constants near each other, but not all of them at one point.
    of_a_sum_are_refused:
        sum(), in period::<2>(), loose [(C2, 1.0016), (LH, 1.0124), (MH, 1.0080)];
    of_a_multiple_are_refused: scaled(), in cube::<2>(3.0), loose [];
    /// The direction in which the matrix stretches most is not the direction in which the shear is
    /// steepest, so that powers of the ratio of the stretches are lost.
    of_an_affine_pullback_are_refused:
        pullback(), in cube::<2>(4.0),
        loose [(C1, 1.3617), (C2, 1.3617), (LH, 2.3774), (MH, 3.9979)];
}

/// A shear is no multiple of the identity, so it must not claim isotropy; the valleys are
/// isotropic.
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
