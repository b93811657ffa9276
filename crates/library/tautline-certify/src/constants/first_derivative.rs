//! `L_H`: the largest `‖DH(x)[v]‖` over unit vectors `v`.

use nalgebra::{DMatrix, DVector};
use num_traits::Zero;
use tautline_scalar::{Interval, Scalar};

use super::{
    expansion::Expansion,
    gram::{At, Gram, points},
    lifted::Variable,
    quartic::{Vanishing, flattened},
    rows::Order,
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
pub(super) struct FirstDerivative<'a>(pub(super) Gram<'a>);

impl FirstDerivative<'_> {
    fn expansion<T: Variable>(&self, at: At<'_, T>) -> Expansion<T> {
        self.0.expansion(at, Order::First)
    }
}

impl Spectral for FirstDerivative<'_> {
    /// The factors of the vanishing forms.
    type Choice = Option<Vanishing>;

    fn gram(&self) -> Gram<'_> {
        self.0
    }

    fn choice(&self, x: &Point) -> Option<Vanishing> {
        let d = self.0.dimension();
        if self.0.isotropic || d == 1 {
            return None;
        }
        let h = self.expansion(x.into());
        let a = |k: usize, i: usize, j: usize| h.first(k, i, j);
        let found = direction(&a, d)?;
        let guess = Vanishing::for_maximum(&a, &found.u);
        Some(guess.improved(&flattened(&a, d), found.norm * found.norm))
    }

    fn matrices<T: Variable>(&self, at: At<'_, T>, choice: &Option<Vanishing>) -> Vec<DMatrix<T>> {
        let (h, d) = (self.expansion(at), self.0.dimension());
        if self.0.isotropic {
            let square = (0..d).fold(T::zero(), |sum, k| sum + h.first(k, 0, 0).sqr());
            return vec![DMatrix::from_element(1, 1, square)];
        }
        let mut sum = flattened(&|k, i, j| h.first(k, i, j), d);
        if let Some(vanishing) = choice {
            vanishing.add_to(&mut sum);
        }
        vec![sum]
    }

    fn wanted(&self, at: At<'_, f64>) -> f64 {
        let h = self.expansion(at);
        let found = direction(&|k, i, j| h.first(k, i, j), h.dimension());
        found.map_or(f64::NAN, |found| found.norm * found.norm)
    }

    fn witness(&self, x: &[f64]) -> f64 {
        let (h, d) = (self.expansion(At::Space(x)), self.0.dimension());
        let Some(Direction { u, v, .. }) = direction(&|k, i, j| h.first(k, i, j), d) else {
            return f64::NAN;
        };
        let h = self.expansion(At::Space(&points(x)));
        let sum =
            (0..d).fold(Interval::zero(), |sum, k| sum + form(|i, j| h.first(k, i, j), &u) * v[k]);
        (Interval::point(sum.mignitude()) / (square(&v).sqrt() * square(&u))).lo()
    }
}

/// Maximises `Σ vₖ uᵀAₖu` over unit vectors `v` and `u`, alternately. For fixed `v` the best `u` is
/// an eigenvector; for fixed `u` the best `v` is a normalized gradient. `a(k, i, j)` is an entry of `Aₖ`.
pub(super) fn direction(a: &impl Fn(usize, usize, usize) -> f64, d: usize) -> Option<Direction> {
    alternating(d, |v| {
        let (norm, u) = extreme(d, |i, j| (0..d).map(|k| v[k] * a(k, i, j)).sum())?;
        let gradient = DVector::from_fn(d, |k, _| form(|i, j| a(k, i, j), &u));
        let next = gradient.try_normalize(0.0).unwrap_or_else(|| v.clone());
        Some((Direction { norm, u, v: v.clone() }, next))
    })
}
