//! What a domain takes for itself, and for all of space: in doubt, and in every coordinate.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

use crate::{Cell, CertifyError, Domain};

/// A metric of the plane that goes on changing, be it along the second coordinate, in the second
/// entry of the diagonal, or beside it, has not settled.
#[test]
fn each_coordinate_and_each_entry_has_to_settle() {
    struct Still(usize);
    impl Metric<2> for Still {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let changes = |x: S| (x * 2.0_f64.powi(-100)).tanh() * 1e-3;
            // Nothing, unless x is near 0.
            let near = |x: S| (-x.sqr()).exp();
            let (zero, one) = (S::zero(), S::one());
            let [a, b, c] = match self.0 {
                // Far out along the other coordinate there is no change.
                0 => [one, zero, near(x[1]) * changes(x[0]) + 1.0],
                1 => [one, zero, near(x[0]) * changes(x[1]) + 1.0],
                2 => [one, near(x[0]) * changes(x[1]), one],
                3 => [changes(x[1]) + 1.0, zero, one],
                // Small beside one entry, and not beside the other.
                4 => [S::constant(1e20), zero, changes(x[0]) + 1.0],
                5 => [changes(x[1]) + 1.0, zero, S::constant(1e20)],
                _ => [near(x[0]) * near(x[1]) + 1.0, near(x[0]) * near(x[1]) * 0.1, one],
            };
            SMatrix::from_fn(|i, j| [a, b, c][i + j])
        }
    }
    for (k, along) in [0, 1, 1, 1, 0, 1].into_iter().enumerate() {
        match Domain::settled_space(&Still(k)) {
            Err(CertifyError::NotSettled { coordinate, .. }) => assert_eq!(coordinate, along),
            other => panic!("{k}: {other:?}"),
        }
    }
    assert!(Domain::settled_space(&Still(6)).is_ok_and(|space| space.is_all_of_space()));
}

/// The sign of `x − c − r`, exactly, for an `x` near `c + r`: the first difference with its
/// rounding, and the second, which has none (Sterbenz).
fn beyond(x: f64, c: f64, r: f64) -> f64 {
    let difference = x - c;
    let back = difference - x;
    let rounding = (x - (difference - back)) - (c + back);
    (difference - r) + rounding
}

/// Whether a double just inside or outside of a ball belongs to it is known in exact arithmetic
/// only: what may belong to it is not missed, and what may not is not taken.
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
