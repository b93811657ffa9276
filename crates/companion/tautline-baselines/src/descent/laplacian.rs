//! `Laplacian`: second differences of the inner points, factorised.

use nalgebra::SVector;

/// The matrix `T` of second differences, with 2 on the diagonal and −1 beside it, for each
/// coordinate of the inner points `x₁, …, x_{N−1}`, and its factor `T = L Lᵀ`.
///
/// `δᵀTδ = Σ |δₙ₊₁ − δₙ|²` for a displacement `δ` that vanishes at both ends. The factor is
/// `Lₖₖ = lₖ = ((k+1)/k)^{1/2}` and `Lₖ,ₖ₋₁ = −1/lₖ₋₁`: indeed `lₖ² + lₖ₋₁⁻² = 2`.
pub(crate) struct Laplacian {
    /// The reciprocals `1/lₖ`.
    reciprocals: Vec<f64>,
}

impl Laplacian {
    /// Returns the second differences on `n` chords.
    pub(crate) fn new(n: usize) -> Self {
        let reciprocals = (1..n).map(|k| (k as f64 / (k as f64 + 1.0)).sqrt()).collect();
        Self { reciprocals }
    }

    /// Overwrites `g` with `L⁻¹ g`.
    pub(crate) fn forward<const D: usize>(&self, g: &mut [SVector<f64, D>]) {
        let mut carried = SVector::zeros();
        for (g, r) in g.iter_mut().zip(&self.reciprocals) {
            *g = (*g + carried) * *r;
            carried = *g * *r;
        }
    }

    /// Overwrites `z` with `L⁻ᵀ z`.
    pub(crate) fn backward<const D: usize>(&self, z: &mut [SVector<f64, D>]) {
        let mut next = SVector::zeros();
        for (z, r) in z.iter_mut().zip(&self.reciprocals).rev() {
            *z = (*z + next * *r) * *r;
            next = *z;
        }
    }

    /// Overwrites `z` with `L z`.
    pub(crate) fn multiply<const D: usize>(&self, z: &mut [SVector<f64, D>]) {
        let mut carried = SVector::zeros();
        for (z, r) in z.iter_mut().zip(&self.reciprocals) {
            let own = *z;
            *z = own / *r - carried;
            carried = own * *r;
        }
    }

    /// Overwrites `g` with `T⁻¹ g`.
    pub(crate) fn solve<const D: usize>(&self, g: &mut [SVector<f64, D>]) {
        self.forward(g);
        self.backward(g);
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};

    use super::Laplacian;

    #[test]
    fn the_factor_undoes_second_differences() {
        for n in [2, 3, 8, 50] {
            let inner: Vec<_> =
                (1..n).map(|k| vector![(k as f64).sin(), 1.0 / k as f64, -1.0]).collect();
            let at = |k: isize| {
                usize::try_from(k).ok().and_then(|k| inner.get(k)).copied().unwrap_or_default()
            };
            let second = |k: isize| at(k) * 2.0 - at(k - 1) - at(k + 1);
            let mut found: Vec<SVector<f64, 3>> = (0..n - 1).map(|k| second(k as isize)).collect();
            let laplacian = Laplacian::new(n);
            let mut factor = found.clone();
            laplacian.forward(&mut factor);
            laplacian.multiply(&mut factor);
            laplacian.solve(&mut found);
            for (k, x) in inner.iter().enumerate() {
                // The condition number is at most (2n/π)², about a thousand.
                assert!((found[k] - x).amax() < 1e-12);
                assert!((factor[k] - second(k as isize)).amax() < 1e-13);
            }
        }
    }
}
