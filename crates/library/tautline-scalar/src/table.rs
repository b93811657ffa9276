//! `Table`: a function of a few numbers that is no formula, such as a spline through samples.

use std::{
    any::Any,
    fmt::Debug,
    hash::{Hash, Hasher},
    sync::Arc,
};

/// A function of one to three numbers that is known by its values, with continuous second derivatives.
///
/// A formula calls it by [`Scalar::tabulated`](crate::Scalar::tabulated).
pub trait Table: Any + Debug + Send + Sync {
    /// Returns the number of arguments, 1 to 3.
    fn axes(&self) -> usize;

    /// Returns the partial derivative of these orders at `u`, which has a number for each axis. Orders
    /// beyond the last axis are 0. NaN where it is undefined.
    fn value(&self, u: &[f64], orders: [u8; 3]) -> f64;

    /// Returns proved bounds on the partial derivative over a box, given the ends of its sides, which
    /// may be infinite. `None` if there are no bounds.
    ///
    /// The derivatives of third order may jump; where they do, the bounds are on both values. A box in
    /// which a derivative jumps has no bounds on the next one, which is no function there.
    fn bounds(&self, sides: &[(f64, f64)], orders: [u8; 3]) -> Option<(f64, f64)>;

    /// Returns `g` and `k` with `f(u) = g(ku)` if a recorded formula calls the table `g` instead of this
    /// table `f`. `None` if the formula calls `f` itself.
    fn base(&self) -> Option<(Arc<dyn Table>, f64)> {
        None
    }

    /// Returns 64 bits that depend on the function. Equal functions have the same.
    fn fingerprint(&self) -> u64;

    /// Returns whether this is the same function.
    fn is_same(&self, other: &dyn Table) -> bool;
}

impl PartialEq for dyn Table {
    fn eq(&self, other: &Self) -> bool {
        self.is_same(other)
    }
}

impl Eq for dyn Table {}

impl Hash for dyn Table {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.fingerprint());
    }
}

/// Returns the orders of the derivative of a partial derivative along an axis.
pub(crate) fn raised(mut orders: [u8; 3], axis: usize) -> [u8; 3] {
    orders[axis] = orders[axis].saturating_add(1);
    orders
}
