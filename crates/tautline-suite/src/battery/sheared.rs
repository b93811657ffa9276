//! The geodesic of a shear that several counterexamples begin with.

use tautline::gallery::Shear;
use tautline_statements::{Known, curves::Geodesic};

/// The known geodesic of a shear from `(0, 0)` to `(2, 3)`.
pub(super) fn sheared() -> (Known<Shear, 2>, Geodesic<Shear, 2>) {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    let ends = [[0.0, 0.0].into(), [2.0, 3.0].into()];
    let known = Known::joined(shear, ends).expect("finite").expect("known");
    (known, Geodesic::between(shear, ends))
}
