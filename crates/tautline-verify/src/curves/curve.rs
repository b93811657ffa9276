//! `Curve`: a curve over `[0, 1]` with its first two derivatives.

use nalgebra::SVector;
use tautline::{PointSequence, SequenceError};

/// A continuous curve over `[0, 1]` that is smooth but for finitely many kinks.
///
/// # Laws
///
/// [`jet`](Curve::jet) is finite on `[0, 1]`, and [`suprema`](Curve::suprema) bounds it there.
pub trait Curve<const D: usize> {
    /// Returns `γ(t)`, `γ̇(t)` and `γ̈(t)`, each in `ℓ`; at a kink the derivatives from the right.
    fn jet(&self, t: f64) -> [SVector<f64, D>; 3];

    /// Returns bounds of `|γ|`, `|γ̇|` and `|γ̈|` over `[0, 1]`, each in `ℓ`.
    ///
    /// Sums over coefficients, not samples: they are what pointwise statements may use, and the
    /// size of the numbers that are rounded on the way to [`jet`](Curve::jet).
    fn suprema(&self) -> [f64; 3];

    /// Returns the times in `(0, 1)` where `γ̇` may jump, in increasing order.
    fn kinks(&self) -> &[f64] {
        &[]
    }

    /// Returns the largest jump of `γ̇`, in `ℓ`: 0 exactly if `γ` is in `H²`.
    fn largest_jump(&self) -> f64 {
        0.0
    }

    /// Returns the samples `γ(n/N)` for `n = 0, …, N`.
    ///
    /// # Errors
    ///
    /// [`SequenceError`] if `n` is 0.
    fn sample(&self, n: usize) -> Result<PointSequence<D>, SequenceError> {
        let points = (0..=n).map(|k| if n == 0 { 0.0 } else { k as f64 / n as f64 });
        PointSequence::new(points.map(|t| self.jet(t)[0]).collect())
    }
}

impl<const D: usize, C: Curve<D>> Curve<D> for &C {
    fn jet(&self, t: f64) -> [SVector<f64, D>; 3] {
        (**self).jet(t)
    }

    fn suprema(&self) -> [f64; 3] {
        (**self).suprema()
    }

    fn kinks(&self) -> &[f64] {
        (**self).kinks()
    }

    fn largest_jump(&self) -> f64 {
        (**self).largest_jump()
    }
}
