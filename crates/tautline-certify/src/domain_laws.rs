//! Domains in doubt: points at the rim of a ball, and metrics that may not settle.

use crate::{Cell, CertifyError, Domain, testing::parsed};

/// A metric of the plane that still changes has not settled: along the second coordinate, in the
/// second diagonal entry, or beside the diagonal.
#[test]
fn each_coordinate_and_each_entry_must_settle() {
    let settled = |entries: &str| {
        let parts = "f1 = tanh(x1*2^-100)*1e-3; f2 = tanh(x2*2^-100)*1e-3;
            near1 = exp(-sqr(x1)); near2 = exp(-sqr(x2));";
        Domain::<2>::settled_space(&parsed(&format!("{parts} {entries}")))
    };
    for (entries, along) in [
        // Far out along the other coordinate there is no change.
        ("diag(1, near2*f1 + 1)", 0),
        ("diag(1, near1*f2 + 1)", 1),
        ("[1, near1*f2; near1*f2, 1]", 1),
        ("diag(f2 + 1, 1)", 1),
        // Small compared to one entry, not to the other.
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

/// The sign of `x − c − r`, exactly, for an `x` near `c + r`: the first difference with its
/// rounding, and the second, which has none (Sterbenz).
fn beyond(x: f64, c: f64, r: f64) -> f64 {
    let difference = x - c;
    let back = difference - x;
    let rounding = (x - (difference - back)) - (c + back);
    (difference - r) + rounding
}

/// Only exact arithmetic can tell whether a double near the rim belongs to a ball: a point that may
/// belong is not missed, one that may not is not taken.
#[test]
fn in_doubt_a_point_is_not_missed_and_not_taken() {
    let (mut inside, mut outside) = (0, 0);
    for i in 1..400 {
        let (c, r) = (f64::from(i % 20) * 0.1, f64::from(i) * 0.37);
        let ball = Domain::ball([c], r).expect("a radius");
        let mut x = (c + r).next_down().next_down();
        for _ in 0..5 {
            let cell = Cell::new([x], [x]).expect("in order");
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
