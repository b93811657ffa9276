//! Balls, periods, and metrics that settle or do not settle.

use std::f64::consts::TAU;

use nalgebra::{SMatrix, vector};
use tautline_formula::Formula;
use tautline_metrics::{
    Metric,
    gallery::{
        Constant, CoupledCosines, GaussianFisher, GaussianFisherPatch, HyperbolicPatch, Lens, Ramp,
        Sphere, SpherePatch, Swirl,
    },
};
use tautline_scalar::{ANY, Interval};

use super::Domain;
use crate::{
    CertifyError,
    constants::recorded,
    patch::{Patch, Point, Region},
    testing::parsed,
};

fn patch<const D: usize>(lo: [f64; D], hi: [f64; D]) -> Patch {
    let side = |i: usize| Interval::new(lo[i], hi[i]).expect("in order");
    Patch { sides: (0..D).map(side).collect(), chart: 0 }
}

fn point<const D: usize>(at: [f64; D]) -> Option<Point> {
    Some(Point { at: at.into(), chart: 0 })
}

/// Returns the formula of a metric in the plane.
fn any(metric: &impl Metric<2>) -> Formula<ANY> {
    recorded(metric).expect("no comparison")
}

#[test]
fn a_ball_contains_its_points_and_misses_the_corners_of_its_box() {
    let ball = Domain::ball([1.0, 0.0], 2.0).expect("a radius");
    assert!(ball.misses(&patch([2.9, 1.9], [3.0, 2.0])));
    assert!(!ball.misses(&patch([2.0, 1.0], [3.0, 2.0])));
    // The cell meets the ball only in the point (3, 0).
    assert!(!ball.misses(&patch([3.0, -1.0], [4.0, 1.0])));
    assert_eq!(ball.point_in(&ball.patches()[0]), point([1.0, 0.0]));
    let x = ball.point_in(&patch([2.0, 1.0], [3.0, 2.0])).expect("they meet").at;
    let x = vector![x[0], x[1]];
    assert!((x - vector![1.0, 0.0]).norm() <= 2.0 && x[0] >= 2.0 && x[1] >= 1.0, "{x}");
    assert_eq!(ball.point_in(&patch([2.9, 1.9], [3.0, 2.0])), None);
    let alone = Domain::ball([1.0], 0.0).expect("a radius");
    assert_eq!(alone.point_in(&alone.patches()[0]), point([1.0]));
}

#[test]
fn a_ball_without_a_radius_or_a_centre_is_refused() {
    for radius in [-1.0, f64::NAN, f64::INFINITY] {
        let error = Domain::ball([0.0], radius).expect_err("no radius");
        assert!(matches!(error, CertifyError::NotARadius { .. }), "{error}");
    }
    assert!(Domain::ball([f64::NAN], 1.0).is_err());
}

#[test]
fn space_is_a_period_where_the_formula_has_one() {
    let space = Domain::space(&CoupledCosines);
    assert!(space.is_all_of_space());
    let [x, y, z] = space.bounding_cell().sides()[..] else { panic!("{space:?}") };
    for side in [x, y] {
        // 2π lies between its nearest double and the next one.
        assert!(side.contains(TAU.next_up()) && side.hi() < TAU * (1.0 + 1e-14));
    }
    // The coordinates occur only in differences.
    assert_eq!(z.width(), 0.0);
    let space = Domain::space(&GaussianFisher);
    let [x, t] = space.bounding_cell().sides() else { panic!("{space:?}") };
    assert!(!space.is_all_of_space() && x.width() == 0.0 && t.hi() == Domain::REACH);
}

#[test]
fn a_metric_with_gaussian_or_saturated_parts_settles() {
    let lens = Lens::new(1.0, 1.0).expect("a width");
    assert!(Domain::settled_space::<2>(&lens).is_ok_and(|space| space.is_all_of_space()));
    assert!(Domain::settled_space(&Ramp::new(0.5, 1.0).expect("a slope")).is_ok());
    assert!(Domain::settled_space(&Swirl::new(1.0, 1.0).expect("a width")).is_ok());
    assert!(Domain::settled_space(&GaussianFisherPatch::new(1.0).expect("a rim")).is_ok());
    let sphere = SpherePatch::new(1.0).expect("a radius");
    assert!(Domain::settled_space::<2>(&sphere).is_ok());
    let hyperbolic = HyperbolicPatch::new(0.5).expect("a radius");
    assert!(Domain::settled_space::<2>(&hyperbolic).is_ok());
}

#[test]
fn a_metric_that_keeps_changing_does_not_settle() {
    let error = Domain::settled_space(&GaussianFisher).expect_err("it grows");
    assert!(matches!(error, CertifyError::NotSettled { coordinate: 1, .. }), "{error}");
    // The sphere's metric tends to 0, so its relative change does not become small.
    assert!(Domain::settled_space::<2>(&Sphere).is_err());
}

/// A small change on the last octave that shows only in the first derivative, only in the second,
/// or only on one side.
#[test]
fn a_small_change_is_detected() {
    for text in [
        "x1*2^-100/sqrt(1 + sqr(x1*2^-100))*1e-3 + 1",
        "sin(x1*2^-80 + x1/(1 + sqr(x1)))*1e-17 + 1",
        "exp(x1*-2^-95)*1e-6 + 1",
        "exp(x1*2^-95)*1e-6 + 1",
    ] {
        let error = Domain::settled_space::<1>(&parsed(&format!("{text} I")));
        let error = error.expect_err("it changes");
        assert!(matches!(error, CertifyError::NotSettled { .. }), "{text}: {error}");
    }
}

#[test]
fn a_domain_represents_space_for_its_own_metric() {
    let constant = Constant::new(SMatrix::<f64, 2, 2>::identity()).expect("definite");
    let bump = parsed::<2>("1 + 1/(sqr(x1) + sqr(x2) + 1) I");
    let point = Domain::space(&constant);
    assert!(
        point.represents_space_for(&any(&constant)) && !point.represents_space_for(&any(&bump))
    );
    let settled = Domain::settled_space(&bump).expect("it settles");
    assert!(settled.represents_space_for(&any(&bump)));
    assert!(!settled.represents_space_for(&any(&Sphere)));
    assert!(!Domain::space(&bump).represents_space_for(&any(&bump)));
    // Both domains have the same box.
    let lens = Lens::new(1.0, 1.0).expect("a width");
    let lifted = Domain::space::<2>(&lens);
    assert_eq!(lifted.bounding_cell(), settled.bounding_cell());
    assert!(lifted.represents_space_for(&any(&lens)) && !lifted.represents_space_for(&any(&bump)));
}

/// The centre plus the radius is rounded, but the box must not become too small.
#[test]
fn the_box_of_a_ball_holds_its_ends() {
    for i in 1..200 {
        let (c, r) = (f64::from(i) * 0.1, f64::from(i * i) * 0.37);
        let ball = Domain::ball([c], r).expect("a radius");
        let [side] = ball.bounding_cell().sides() else { panic!("{ball:?}") };
        let (c, r) = (Interval::point(c), Interval::point(r));
        assert!(side.contains_interval(c - r) && side.contains_interval(c + r), "{side:?}");
    }
}

/// A metric in the plane that still changes has not settled. Here it changes along the second
/// coordinate, in the second diagonal entry, or off the diagonal.
#[test]
fn each_coordinate_and_each_entry_must_settle() {
    let settled = |entries: &str| {
        let parts = "u1 = x1*2^-100; u2 = x2*2^-100;
            f1 = u1/sqrt(1 + sqr(u1))*1e-3; f2 = u2/sqrt(1 + sqr(u2))*1e-3;
            near1 = exp(-sqr(x1)); near2 = exp(-sqr(x2));";
        Domain::settled_space::<2>(&parsed(&format!("{parts} {entries}")))
    };
    for (entries, along) in [
        // There is no change far out along the other coordinate.
        ("diag(1, near2*f1 + 1)", 0),
        ("diag(1, near1*f2 + 1)", 1),
        ("[1, near1*f2; near1*f2, 1]", 1),
        ("diag(f2 + 1, 1)", 1),
        // The change is small compared with one diagonal entry, but not with the other.
        ("diag(1e20, f1 + 1)", 0),
        ("diag(f2 + 1, 1e20)", 1),
    ] {
        match settled(entries) {
            Err(CertifyError::NotSettled { coordinate, .. }) => assert_eq!(coordinate, along),
            other => panic!("{entries}: {other:?}"),
        }
    }
    let bump = settled("b = near1*near2; [b + 1, b*0.1; b*0.1, 1]");
    assert!(bump.is_ok_and(|space| space.is_all_of_space()));
}

/// Only what changes along the coordinate that grows must settle.
#[test]
fn a_metric_may_change_along_other_coordinates() {
    for text in ["3 + 1/(1 + sqr(x1)) + sin(x2) I", "diag(3 + sin(x2), 2 + 1/(1 + x1^4) + cos(x2))"]
    {
        let settled = Domain::settled_space::<2>(&parsed(text));
        assert!(settled.is_ok_and(|space| space.is_all_of_space()), "{text}");
    }
    // The amplitude of the wave does not settle.
    let error = Domain::settled_space::<2>(&parsed("3 + x1/sqrt(1 + sqr(x1*2^-100))*sin(x2) I"));
    assert!(matches!(error, Err(CertifyError::NotSettled { coordinate: 0, .. })), "{error:?}");
}

/// Far out along one coordinate, the wave along the other falls like `1/R`, and the mixed second
/// derivative like `1/R²`: `R² |∂ₖ∂ₗH|` does not become small, unlike all else. It does if the wave falls
/// like `1/R²`.
#[test]
fn mixed_second_derivatives_must_settle() {
    for (far, wave, coordinate) in [("x1", "x2", 0), ("x2", "x1", 1)] {
        let settled = |fall: &str| {
            let text = format!("3 + sin({wave})/({fall}) I").replace("far", far);
            Domain::settled_space::<2>(&parsed(&text))
        };
        match settled("sqrt(1 + sqr(far))") {
            Err(CertifyError::NotSettled { coordinate: along, change }) => {
                assert!(along == coordinate && change > 0.1 && change < 100.0, "{change}");
            }
            other => panic!("{far}: {other:?}"),
        }
        assert!(settled("1 + sqr(far)").is_ok_and(|space| space.is_all_of_space()), "{far}");
    }
}

/// Returns the exact sign of `x − c − r`, for an `x` near `c + r`. It uses the first difference
/// with its rounding error, and the second difference, which is exact (Sterbenz).
fn beyond(x: f64, c: f64, r: f64) -> f64 {
    let difference = x - c;
    let back = difference - x;
    let rounding = (x - (difference - back)) - (c + back);
    (difference - r) + rounding
}

/// Only exact arithmetic can decide whether a double near the rim belongs to a ball. A point that
/// may belong to the ball is not missed, and a point that may not belong to it is not taken.
#[test]
fn in_doubt_a_point_is_not_missed_and_not_taken() {
    let (mut inside, mut outside) = (0, 0);
    for i in 1..400 {
        let (c, r) = (f64::from(i % 20) * 0.1, f64::from(i) * 0.37);
        let ball = Domain::ball([c], r).expect("a radius");
        let mut x = (c + r).next_down().next_down();
        for _ in 0..5 {
            let cell = patch([x], [x]);
            if beyond(x, c, r) <= 0.0 {
                assert!(!ball.misses(&cell), "{x} is within {r} of {c}");
                inside += 1;
            } else {
                assert_eq!(ball.point_in(&cell), None, "{x} is beyond {r} of {c}");
                outside += 1;
            }
            x = x.next_up();
        }
    }
    assert!(inside > 500 && outside > 500, "{inside} {outside}");
}

/// A bump anywhere on the last octave, which has vanished at both of its ends, is a change.
#[test]
fn the_whole_octave_must_have_settled() {
    for place in ["0.55", "0.75", "0.95"] {
        for sign in ["-", "+"] {
            // At the ends of the octave the bump and its changes are below 10⁻³ (5 · 10⁴)⁻⁴ · 10³.
            let text = format!("1 + 1e-3/(1 + sqr(sqr((x1*2^-100 {sign} {place})*1e6))) I");
            match Domain::settled_space::<1>(&parsed(&text)) {
                Err(CertifyError::NotSettled { coordinate: 0, .. }) => {}
                other => panic!("{text}: {other:?}"),
            }
        }
    }
    let without = Domain::settled_space::<1>(&parsed("1 + 1e-3/(1 + sqr(sqr(x1))) I"));
    assert!(without.is_ok_and(|space| space.is_all_of_space()));
}
