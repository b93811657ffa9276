//! Directions along which a formula does not change.

use nalgebra::DMatrix;
use tautline_formula::Formula;
use tautline_scalar::ANY;

use super::dependence::is_constant_along;
use crate::constants::{Expansion, Order};

/// Returns which coordinates can be set to 0 without loss. For each of them, the Gram matrix does
/// not change along some direction that moves this coordinate and none of the other superfluous
/// ones.
///
/// The directions are guessed from derivatives at a few points, as multiples of small fractions.
/// [`is_constant_along`] then proves that the formula does not change along them. For example,
/// `cos(x₁ − x₂)` needs only one coordinate. A direction that is not guessed or not proved only
/// costs more boxes.
pub(crate) fn superfluous(formula: &Formula<ANY>) -> Vec<bool> {
    let d = formula.dimension();
    let mut rows = gradients(formula);
    let pivots = reduce(&mut rows);
    let mut superfluous = vec![false; d];
    for free in (0..d).filter(|i| !pivots.contains(i)) {
        // The direction that has 1 at the free coordinate and that every row annihilates.
        let mut direction = vec![0.0; d];
        direction[free] = 1.0;
        for (row, &pivot) in pivots.iter().enumerate() {
            direction[pivot] = -fraction(rows[(row, free)]);
        }
        superfluous[free] = is_constant_along(formula, &direction);
    }
    superfluous
}

/// More gradients than these are not looked at: in many dimensions a point has thousands.
const ENOUGH: usize = 4096;

/// Returns the gradients of the entries of `H` at a few generic points, one gradient in each row. Entries
/// that do not change have none, and a multiple of the identity has one at each point.
fn gradients(formula: &Formula<ANY>) -> DMatrix<f64> {
    let d = formula.dimension();
    let mut rows: Vec<f64> = Vec::new();
    for point in 1..=2 * d {
        // The coordinates are fractional parts of multiples of irrational numbers, spread over the
        // unit cube.
        let coordinate = |i: usize| (point as f64 * (i as f64 + 2.0).sqrt()).fract();
        let x: Vec<f64> = (0..d).map(coordinate).collect();
        let gram = Expansion::of(formula, &x, Order::First);
        for (i, j) in (0..d).flat_map(|j| (0..=j).map(move |i| (i, j))) {
            let gradient = (0..d).map(|k| gram.first(k, i, j));
            let is_new = gradient.clone().any(|g| g != 0.0)
                && !gradient.clone().eq(rows[rows.len().saturating_sub(d)..].iter().copied());
            if is_new && gradient.clone().all(|g| g.is_finite()) {
                rows.extend(gradient);
            }
        }
        if rows.len() > ENOUGH * d {
            break;
        }
    }
    DMatrix::from_row_iterator(rows.len() / d.max(1), d, rows)
}

/// Brings the rows into reduced echelon form, with the largest pivot in each column, and returns
/// the columns of the pivots. Entries below `10⁻⁹` of the largest entry count as rounding errors.
fn reduce(rows: &mut DMatrix<f64>) -> Vec<usize> {
    let least = 1e-9 * rows.amax();
    let mut pivots = Vec::new();
    for column in 0..rows.ncols() {
        let next = pivots.len();
        let Some(best) = (next..rows.nrows())
            .max_by(|&a, &b| rows[(a, column)].abs().total_cmp(&rows[(b, column)].abs()))
            .filter(|&best| rows[(best, column)].abs() > least)
        else {
            continue;
        };
        rows.swap_rows(next, best);
        let pivot = rows[(next, column)];
        for entry in rows.row_mut(next).iter_mut() {
            *entry /= pivot;
        }
        for row in (0..rows.nrows()).filter(|&row| row != next) {
            let factor = rows[(row, column)];
            for j in 0..rows.ncols() {
                let change = factor * rows[(next, j)];
                rows[(row, j)] -= change;
            }
        }
        pivots.push(column);
    }
    pivots
}

/// Returns the nearest multiple of `1/64`. Its products with most coefficients of formulas are
/// exact.
fn fraction(x: f64) -> f64 {
    (64.0 * x).round() / 64.0
}

#[cfg(test)]
mod tests {
    use tautline_formula::Formula;
    use tautline_metrics::{
        Metric,
        gallery::{CoupledCosines, EggCrate, RotatingAnisotropy, Shear, Valleys},
    };

    use crate::testing::parsed;

    fn superfluous<const D: usize>(metric: &impl Metric<D>) -> Vec<bool> {
        super::superfluous(&Formula::record(metric).expect("no comparison").into_any())
    }

    #[test]
    fn a_formula_in_differences_needs_one_coordinate_less() {
        assert_eq!(superfluous(&CoupledCosines), [false, false, true]);
        let anisotropy = RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]).expect("eigenvalues");
        assert_eq!(superfluous(&anisotropy), [false, true]);
        assert_eq!(superfluous::<3>(&Valleys), [false, true, true]);
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        assert_eq!(superfluous(&shear), [true, false]);
    }

    #[test]
    fn a_coordinate_that_matters_is_kept() {
        let eggs = EggCrate::new(1.0, 1.0).expect("a wave number");
        assert_eq!(superfluous(&eggs), [false, false]);
        for (text, expected) in [
            // The function depends almost only on `x₁`.
            ("cos(x1 + x2*2^-20) + 2 I", [false, false]),
            // The function is constant to within rounding at the points that are tried, but not
            // elsewhere.
            ("tanh(x2*40 - 400) + 2 I", [true, false]),
            // The same function occurs off the diagonal, and in a product.
            ("far = tanh(x2*40 - 400); [2, far; far, 2]", [true, false]),
            ("cos(x1) + x1*x2*2^-40 + 3 I", [false, false]),
        ] {
            assert_eq!(superfluous(&parsed::<2>(text)), expected, "{text}");
        }
    }
}
