//! `L_H`: the largest `‖DH(x)[v]‖` over unit vectors `v`.

use nalgebra::{DMatrix, SMatrix, SVector};
use num_traits::Zero;
use tautline_scalar::{Interval, Scalar};

use super::{
    gram::{At, Gram},
    lifted::Variable,
    quartic::{Vanishing, flattened},
    spectral::{Direction, Spectral, alternating, extreme, form, square},
};
use crate::patch::Point;

/// `‖DH(x)‖²`, or an upper bound on it. With `Aₖ = ∂ₖH`, it is the largest value over unit vectors
/// `u` of
///
/// `f(u) = Σₖ (uᵀAₖu)²`,
///
/// a form of degree four. It is the quadratic form of `Σ aₖaₖᵀ` in the coordinates of the matrix
/// `uuᵀ`, which has norm 1: `zᵢᵢ = uᵢ²`, and `zᵢⱼ = √2 uᵢuⱼ` for `i < j`. Symmetric matrices whose
/// form vanishes on all these `z` may be added. These are the multiples of
///
/// * `2 zᵢᵢ zⱼⱼ − zᵢⱼ²`, and
/// * `2 zᵢᵢ zⱼₖ − √2 zᵢⱼ zᵢₖ`.
///
/// For each choice, the largest eigenvalue bounds `f`. For `D ≤ 3` the best choice is exact, since
/// a nonnegative form of degree four in three variables is a sum of squares (Hilbert).
///
/// # The choice
///
/// Let `f` have its maximum at `u = e₁`. The eigenvector must be `e₁₁`, so the other entries of its
/// row must vanish. Those at `(11, 1j)` vanish because `u` is stationary; those at `(11, jj)` and
/// `(11, jk)` are made to vanish. In two dimensions this is exact. In higher dimensions all entries
/// at `(ii, jj)` and `(ii, jk)` are made to vanish, which is a good start for subgradient steps.
/// For any other `u` the coordinates are rotated.
///
/// If `H` is a multiple of the identity, `‖DH‖² = |∇φ|²`.
pub(super) struct FirstDerivative<'a, const D: usize>(pub(super) Gram<'a, D>);

impl<const D: usize> Spectral<D> for FirstDerivative<'_, D> {
    /// The factors of the vanishing forms.
    type Choice = Option<Vanishing<D>>;

    fn gram(&self) -> Gram<'_, D> {
        self.0
    }

    fn choice(&self, x: &Point) -> Option<Vanishing<D>> {
        if self.0.isotropic || D == 1 {
            return None;
        }
        let a = self.0.first(x.into());
        let found = direction(&a)?;
        let guess = Vanishing::for_maximum(&a, &found.u);
        Some(guess.improved(&flattened(&a), found.norm * found.norm))
    }

    fn matrices<T: Variable>(
        &self,
        at: At<'_, T, D>,
        choice: &Option<Vanishing<D>>,
    ) -> Vec<DMatrix<T>> {
        let a = self.0.first(at);
        if self.0.isotropic {
            let square = a.iter().fold(T::zero(), |sum, a| sum + a[(0, 0)].sqr());
            return vec![DMatrix::from_element(1, 1, square)];
        }
        let mut sum = flattened(&a);
        if let Some(vanishing) = choice {
            vanishing.add_to(&mut sum);
        }
        vec![sum]
    }

    fn wanted(&self, at: At<'_, f64, D>) -> f64 {
        direction(&self.0.first(at)).map_or(f64::NAN, |found| found.norm * found.norm)
    }

    fn witness(&self, x: &SVector<f64, D>) -> f64 {
        let Some(Direction { u, v, .. }) = direction(&self.0.first(At::Space(x))) else {
            return f64::NAN;
        };
        let a = self.0.first(At::Space(&x.map(Interval::point)));
        let sum =
            (0..D).fold(Interval::zero(), |sum, k| sum + form(|i, j| a[k][(i, j)], &u) * v[k]);
        (Interval::point(sum.mignitude()) / (square(&v).sqrt() * square(&u))).lo()
    }
}

/// Maximises `Σ vₖ uᵀAₖu` over unit vectors `v` and `u`, alternately. For fixed `v` the best `u` is
/// an eigenvector; for fixed `u` the best `v` is a normalized gradient.
pub(super) fn direction<const D: usize>(a: &[SMatrix<f64, D, D>; D]) -> Option<Direction<D>> {
    alternating(|v| {
        let (norm, u) = extreme(|i, j| (0..D).map(|k| v[k] * a[k][(i, j)]).sum())?;
        let gradient = SVector::<f64, D>::from_fn(|k, _| form(|i, j| a[k][(i, j)], &u));
        Some((Direction { norm, u, v: *v }, gradient.try_normalize(0.0).unwrap_or(*v)))
    })
}
