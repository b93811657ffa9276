//! What a newcomer writes (a formula, its constants, and one line), and what the kit shows if one
//! of these is wrong.
//!
//! From `use` to `metric_suite!` these are twelve lines of code. The formula, which is the body of
//! `gram`, is not counted; imports and closing braces are.

use tautline_kit::prelude::*;

struct Egg; // H(x) = diag(2 + cos x₁, 3 + sin x₂)
impl Metric<2> for Egg {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal(&[2.0 + x[0].cos(), 3.0 + x[1].sin()].into())
    }
}
impl Bounded<2> for Egg {
    fn constants(&self) -> Constants {
        Constants::new(1.0, 4.0, 1.0).expect("c1 ≤ c2")
    }
}
metric_suite!(egg: Egg, dimension 2, in Region::cell([0.0, 0.0], [6.3, 6.3]));

mod mistakes;
