//! `M_H`: the largest `‖D²H(x)[v, v]‖` over unit vectors `v`.

use nalgebra::DMatrix;
use tautline_scalar::Interval;

use super::{
    biquadratic::{Vanishing, flattened},
    eigenvalue_bound::eigen,
    expansion::Expansion,
    gram::{At, Gram, points},
    lifted::Variable,
    rows::Order,
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
pub(super) struct SecondDerivative<'a>(pub(super) Gram<'a>);

impl SecondDerivative<'_> {
    fn expansion<T: Variable>(&self, at: At<'_, T>) -> Expansion<T> {
        self.0.expansion(at, Order::Second)
    }
}

impl Spectral for SecondDerivative<'_> {
    /// The matrices added to `B` and to `−B`.
    type Choice = [Option<Vanishing>; 2];

    fn gram(&self) -> Gram<'_> {
        self.0
    }

    fn choice(&self, x: &Point) -> Self::Choice {
        if self.0.isotropic || self.0.dimension() == 1 {
            return [None, None];
        }
        let h = self.expansion(x.into());
        [1.0, -1.0].map(|sign| {
            let b = Second::of(&h, sign);
            let vanishing = Vanishing::for_maximum(&b, &maximum(&b)?);
            // Even without an added matrix the bound is too large by a factor of at most D, and it
            // may be smaller than with one.
            let plain = flattened(|k, l, i, j| b.at(k, l, i, j), b.d);
            let mut added = plain.clone();
            vanishing.add_to(&mut added);
            let [with, without] =
                [added, plain].map(|matrix| Some(eigen(&matrix)?.eigenvalues.max()));
            (with? <= without?).then_some(vanishing)
        })
    }

    fn matrices<T: Variable>(&self, at: At<'_, T>, choice: &Self::Choice) -> Vec<DMatrix<T>> {
        let (h, d) = (self.expansion(at), self.0.dimension());
        if self.0.isotropic {
            let hessian = DMatrix::from_fn(d, d, |k, l| h.second(k, l, 0, 0));
            return vec![hessian.map(|entry| -entry), hessian];
        }
        let b = flattened(|k, l, i, j| h.second(k, l, i, j), d);
        let mut both = [b.map(|entry| -entry), b];
        for (matrix, vanishing) in both.iter_mut().rev().zip(choice) {
            if let Some(vanishing) = vanishing {
                vanishing.add_to(matrix);
            }
        }
        both.into()
    }

    fn wanted(&self, at: At<'_, f64>) -> f64 {
        direction(&self.expansion(at)).map_or(f64::NAN, |found| found.norm)
    }

    fn witness(&self, x: &[f64]) -> f64 {
        let Some(Direction { u, v, .. }) = direction(&self.expansion(At::Space(x))) else {
            return f64::NAN;
        };
        let h = self.expansion(At::Space(&points(x)));
        let sum = form(|k, l| form(|i, j| h.second(k, l, i, j), &u), &v);
        (Interval::point(sum.mignitude()) / (square(&v) * square(&u))).lo()
    }
}

/// The form `Σ vₖ vₗ uᵀ∂ₖ∂ₗH u`, or its negative.
pub(super) struct Second {
    pub(super) d: usize,
    /// The entries `∂ₖ∂ₗHᵢⱼ`, the last index first.
    entries: Vec<f64>,
}

impl Second {
    /// Returns `sign` times the form.
    fn of(h: &Expansion<f64>, sign: f64) -> Self {
        Self::from_fn(h.dimension(), |k, l, i, j| h.second(k, l, i, j) * sign)
    }

    /// Returns the form with these entries.
    pub(super) fn from_fn(d: usize, entry: impl Fn(usize, usize, usize, usize) -> f64) -> Self {
        let mut entries = Vec::with_capacity(d.pow(4));
        for (k, l) in (0..d).flat_map(|k| (0..d).map(move |l| (k, l))) {
            for (i, j) in (0..d).flat_map(|i| (0..d).map(move |j| (i, j))) {
                entries.push(entry(k, l, i, j));
            }
        }
        Self { d, entries }
    }

    /// Returns `∂ₖ∂ₗHᵢⱼ`.
    pub(super) fn at(&self, k: usize, l: usize, i: usize, j: usize) -> f64 {
        self.entries[((k * self.d + l) * self.d + i) * self.d + j]
    }
}

/// Maximises the form over unit vectors `v` and `u`, alternately.
pub(super) fn maximum(b: &Second) -> Option<Direction> {
    alternating(b.d, |v| {
        let (_, u) = greatest(b.d, |i, j| form(|k, l| b.at(k, l, i, j), v))?;
        let (norm, next) = greatest(b.d, |k, l| form(|i, j| b.at(k, l, i, j), &u))?;
        // An eigenvector has two signs.
        let next = if next.dot(v) < 0.0 { -next } else { next };
        Some((Direction { norm, u, v: next.clone() }, next))
    })
}

/// The larger of the maxima of the form and of its negative.
fn direction(h: &Expansion<f64>) -> Option<Direction> {
    let [up, down] = [1.0, -1.0].map(|sign| maximum(&Second::of(h, sign)));
    let (up, down) = (up?, down?);
    Some(if up.norm >= down.norm { up } else { down })
}
