//! `Spline` as a [`Table`], which formulas call.

use std::any::Any;

use tautline_scalar::Table;

use super::Spline;

impl Table for Spline {
    fn axes(&self) -> usize {
        self.shape().len()
    }

    fn value(&self, u: &[f64], orders: [u8; 3]) -> f64 {
        Self::value(self, u, orders)
    }

    fn bounds(&self, sides: &[(f64, f64)], orders: [u8; 3]) -> Option<(f64, f64)> {
        let is_box = sides.len() == self.shape().len() && sides.iter().all(|(lo, hi)| lo <= hi);
        let order: u32 = orders.iter().map(|&order| u32::from(order)).sum();
        // Third derivatives jump from cell to cell, and are smooth in each.
        let is_function = order <= 3 || sides.iter().zip(self.shape()).all(is_in_one_cell);
        (is_box && is_function).then(|| self.bounds_over(sides, orders))
    }

    fn fingerprint(&self) -> u64 {
        Self::fingerprint(self)
    }

    fn is_same(&self, other: &dyn Table) -> bool {
        (other as &dyn Any).downcast_ref::<Self>().is_some_and(|other| self == other)
    }
}

/// Returns whether a side lies in one cell, or beyond the border, where the spline is constant.
fn is_in_one_cell((&(lo, hi), &n): (&(f64, f64), &usize)) -> bool {
    hi <= lo.floor() + 1.0 || hi <= -1.0 || lo >= n as f64
}
