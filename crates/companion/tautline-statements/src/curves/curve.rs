//! `Curve`: a curve on `[0, 1]` with its first two derivatives.

use tautline::{PointSequence, SequenceError};

use super::Motion;

/// A continuous, piecewise twice differentiable curve on `[0, 1]`.
pub trait Curve<const D: usize> {
    /// Returns position, velocity and acceleration at the time `t ∈ [0, 1]`. At a corner, the
    /// derivatives are taken from the right.
    fn motion(&self, t: f64) -> Motion<D>;

    /// Returns the times in `(0, 1)` at which velocity or acceleration may jump, in increasing
    /// order.
    fn corners(&self) -> Vec<f64> {
        Vec::new()
    }

    /// Returns the pieces `[t, t′]` between consecutive corners.
    fn pieces(&self) -> Vec<[f64; 2]> {
        let ends = self.corners().into_iter().chain([1.0]);
        let mut from = 0.0;
        ends.map(|to| [std::mem::replace(&mut from, to), to]).collect()
    }

    /// Returns times at which to check the curve: eight inside each piece.
    fn times(&self) -> Vec<f64> {
        let inside = |[from, to]: [f64; 2]| {
            (0..8).map(move |k| from + (to - from) * (f64::from(k) + 0.5) / 8.0)
        };
        self.pieces().into_iter().flat_map(inside).collect()
    }

    /// Returns the samples `γ(n/N)` for `n = 0, …, N`.
    ///
    /// # Errors
    ///
    /// [`SequenceError`] if `n` is 0.
    fn sample(&self, n: usize) -> Result<PointSequence<D>, SequenceError> {
        let times = (0..=n).map(|k| if n == 0 { 0.0 } else { k as f64 / n as f64 });
        PointSequence::new(times.map(|t| self.motion(t).position).collect())
    }
}

impl<const D: usize, C: Curve<D>> Curve<D> for &C {
    fn motion(&self, t: f64) -> Motion<D> {
        (**self).motion(t)
    }

    fn corners(&self) -> Vec<f64> {
        (**self).corners()
    }
}

/// A curve with known bounds.
pub trait BoundedCurve<const D: usize>: Curve<D> {
    /// Returns bounds on `|γ|`, `|γ̇|` and `|γ̈|` over `[0, 1]`, each in `ℓ`.
    ///
    /// They are sums over coefficients, not maxima over samples, so that pointwise statements may
    /// use them. They also bound the numbers that are rounded in [`motion`](Curve::motion).
    fn suprema(&self) -> [f64; 3];
}

impl<const D: usize, C: BoundedCurve<D>> BoundedCurve<D> for &C {
    fn suprema(&self) -> [f64; 3] {
        (**self).suprema()
    }
}
