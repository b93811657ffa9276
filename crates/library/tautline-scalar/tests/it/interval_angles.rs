//! Sine, cosine and tangent of intervals: crests, poles and the largest angles.

use std::f64::consts::PI;

use tautline_scalar::{Interval, Scalar};

use crate::{ends, interval};

#[test]
fn a_tangent_across_a_pole_is_undefined() {
    assert!(interval(1.5, 1.6).tan().is_undefined());
    assert!(interval(-20.0, 20.0).tan().is_undefined());
    assert!(interval(4.7, 4.72).tan().is_undefined());
    // The doubles nearest to π/2 lie on either side of the pole.
    let (below, above) = (PI / 2.0, (PI / 2.0).next_up());
    assert!(interval(below, above).tan().is_undefined());
    assert!(Interval::point(below).tan().lo() > 1e16);
    assert!(Interval::point(above).tan().hi() < -1e15);
    assert!(interval(-1.5, 1.5).tan().is_finite());
    // Beyond the largest angle nothing is known.
    assert!(Interval::point(1e12).tan().is_undefined());
}

#[test]
fn waves_reach_one_exactly_where_a_crest_is_inside() {
    for turn in [0.0, 1.0, -3.0, 1000.0, 3e5, -1e9] {
        let shift = turn * 2.0 * PI;
        let x = |lo: f64, hi: f64| interval(lo + shift, hi + shift);
        assert_eq!(x(-0.1, 0.1).cos().hi(), 1.0);
        assert_eq!(x(3.1, 3.2).cos().lo(), -1.0);
        assert_eq!(x(1.5, 1.6).sin().hi(), 1.0);
        assert_eq!(x(4.7, 4.8).sin().lo(), -1.0);
        assert!(x(0.1, 3.0).cos().hi() < 0.996 && x(0.1, 3.0).cos().lo() > -0.9901);
        assert!(x(1.6, 4.7).sin().hi() < 1.0 && x(1.6, 4.7).sin().lo() > -1.0);
        assert_eq!(ends(x(0.0, 7.0).sin()), (-1.0, 1.0));
    }
    // This angle is beyond the largest one.
    assert_eq!(ends(Interval::point(1e22).sin()), (-1.0, 1.0));
    assert_eq!(ends(interval(0.0, 1e12).cos()), (-1.0, 1.0));
}

/// The limit is `2³⁸`, inclusive, for either sign. If only one end is larger, nothing is known.
#[test]
fn angles_of_either_sign_have_the_same_limit() {
    const LARGEST: f64 = 274_877_906_944.0;
    let (last, beyond) = (LARGEST, LARGEST.next_up());
    for sign in [1.0, -1.0] {
        let x = Interval::point(sign * last);
        for y in [x.sin(), x.cos(), x.sin_cos().0, x.sin_cos().1, x.tan()] {
            assert!(y.width() < 1e-14, "{y:?}");
        }
        let half = |far: f64| if sign > 0.0 { interval(0.0, far) } else { interval(-far, 0.0) };
        for x in [Interval::point(sign * beyond), half(beyond), half(1e12), half(1e300)] {
            for y in [x.sin(), x.cos(), x.sin_cos().0, x.sin_cos().1] {
                assert_eq!(ends(y), (-1.0, 1.0), "{x:?}");
            }
            assert!(x.tan().is_undefined());
        }
    }
}

/// Beyond `2²⁰` angles are reduced in another way. Where both meet, the bounds agree.
#[test]
fn both_reductions_of_angles_agree_where_they_meet() {
    let x = 1_048_576.0_f64;
    for (below, above) in [(x, x.next_up()), (-x, (-x).next_down())] {
        let step = Interval::point(above) - Interval::point(below);
        let ((s, c), (t, d)) = (Interval::point(below).sin_cos(), Interval::point(above).sin_cos());
        let (sin, cos) = step.sin_cos();
        // The addition theorems.
        for (one, other) in [(t, s * cos + c * sin), (d, c * cos - s * sin)] {
            assert!(one.intersection(other).is_some() && one.width() < 1e-14, "{one:?} {other:?}");
        }
    }
}

/// Angles close to multiples of `π/2`, where a value rounds to ±1.
#[test]
fn enclosures_of_waves_stay_within_one() {
    for quarter in -3000..3000 {
        let mut angle = f64::from(quarter) * std::f64::consts::FRAC_PI_2;
        for _ in 0..3 {
            let x = Interval::point(angle);
            let (sin, cos) = x.sin_cos();
            for y in [sin, cos, x.sin(), x.cos(), x.tanh()] {
                assert!(-1.0 <= y.lo() && y.hi() <= 1.0, "{angle}: {y:?}");
            }
            angle = angle.next_up();
        }
    }
}
