//! `M_H`: the largest `‖D²H(x)[v, v]‖` over unit vectors `v`.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_scalar::Interval;

use super::{
    biquadratic::{Vanishing, flattened},
    eigenvalue_bound::eigen,
    gram::{At, Gram},
    lifted::Variable,
    spectral::{Direction, Spectral, alternating, form, greatest, square},
};
use crate::patch::Point;

/// `‖D²H(x)‖`, or an upper bound on it: the largest `|Σ vₖ vₗ uᵀ∂ₖ∂ₗH u|` over unit vectors `u` and
/// `v`. (`D²H` is a symmetric bilinear form, so two different vectors in place of `v` give no
/// larger value.)
///
/// The sum is the value at the vector `v ⊗ u` of the form of the `D² × D²` matrix `B`, with the
/// entry `∂ₖ∂ₗHᵢⱼ` at `(k, i), (l, j)`. It therefore lies between the least and the largest
/// eigenvalue of `B`. Multiples of
///
/// `2 zₖᵢ zₗⱼ − 2 zₖⱼ zₗᵢ`, `k < l`, `i < j`,
///
/// vanish at `z = v ⊗ u`. They may be added to `B`, with different factors for the two eigenvalues.
///
/// # The choice
///
/// Let the form have its maximum at `v = u = e₁`. For the largest eigenvalue to equal this maximum,
/// `e₁ ⊗ e₁` must be an eigenvector of the matrix, so the other entries of the row `(1, 1)` must
/// vanish. Those at `(1, 1), (1, j)` and `(1, 1), (l, 1)` vanish because
/// `u` and `v` are stationary; those at `(1, 1), (l, j)` are made to vanish. For any other `u` and
/// `v` the coordinates are rotated. In two dimensions this is exact: a nonnegative biquadratic form
/// in two by two variables is a sum of squares (Calderón), and one that vanishes at `e₁ ⊗ e₁` has
/// zeros in that row.
///
/// If `H` is a multiple of the identity, `‖D²H‖ = ‖D²φ‖`.
pub(super) struct SecondDerivative<'a, const D: usize>(pub(super) Gram<'a, D>);

impl<const D: usize> Spectral<D> for SecondDerivative<'_, D> {
    /// The matrices added to `B` and to `−B`.
    type Choice = [Option<Vanishing<D>>; 2];

    fn gram(&self) -> Gram<'_, D> {
        self.0
    }

    fn choice(&self, x: &Point) -> Self::Choice {
        if self.0.isotropic || D == 1 {
            return [None, None];
        }
        let b = self.0.second(x.into());
        [1.0, -1.0].map(|sign| {
            let b = b.map(|row| row.map(|matrix| matrix * sign));
            let vanishing = Vanishing::for_maximum(&b, &maximum(&b)?);
            // Even without an added matrix the bound is too large by a factor of at most D, and it
            // may be smaller than with one.
            let plain = flattened(&b);
            let mut added = plain.clone();
            vanishing.add_to(&mut added);
            let [with, without] =
                [added, plain].map(|matrix| Some(eigen(&matrix)?.eigenvalues.max()));
            (with? <= without?).then_some(vanishing)
        })
    }

    fn matrices<T: Variable>(&self, at: At<'_, T, D>, choice: &Self::Choice) -> Vec<DMatrix<T>> {
        let b = self.0.second(at);
        if self.0.isotropic {
            let hessian = DMatrix::from_fn(D, D, |k, l| b[k][l][(0, 0)]);
            return vec![hessian.map(|entry| -entry), hessian];
        }
        let b = flattened(&b);
        let mut both = [b.map(|entry| -entry), b];
        for (matrix, vanishing) in both.iter_mut().rev().zip(choice) {
            if let Some(vanishing) = vanishing {
                vanishing.add_to(matrix);
            }
        }
        both.into()
    }

    fn wanted(&self, at: At<'_, f64, D>) -> f64 {
        direction(&self.0.second(at)).map_or(f64::NAN, |found| found.norm)
    }

    fn witness(&self, x: &SVector<f64, D>) -> f64 {
        let Some(Direction { u, v, .. }) = direction(&self.0.second(At::Space(x))) else {
            return f64::NAN;
        };
        let b = self.0.second(At::Space(&x.map(Interval::point)));
        let sum = form(|k, l| form(|i, j| b[k][l][(i, j)], &u), &v);
        (Interval::point(sum.mignitude()) / (square(&v) * square(&u))).lo()
    }
}

/// Maximises `Σ vₖ vₗ uᵀ∂ₖ∂ₗH u` over unit vectors `v` and `u`, alternately.
pub(super) fn maximum<const D: usize>(b: &[[SMatrix<f64, D, D>; D]; D]) -> Option<Direction<D>> {
    alternating(|v| {
        let (_, u) = greatest::<D>(|i, j| form(|k, l| b[k][l][(i, j)], v))?;
        let (norm, next) = greatest::<D>(|k, l| form(|i, j| b[k][l][(i, j)], &u))?;
        // An eigenvector has two signs.
        let next = if next.dot(v) < 0.0 { -next } else { next };
        Some((Direction { norm, u, v: next }, next))
    })
}

/// The larger of the maxima of the form and of its negative.
fn direction<const D: usize>(b: &[[SMatrix<f64, D, D>; D]; D]) -> Option<Direction<D>> {
    let [up, down] = [1.0, -1.0].map(|sign| maximum(&b.map(|row| row.map(|matrix| matrix * sign))));
    let (up, down) = (up?, down?);
    Some(if up.norm >= down.norm { up } else { down })
}
