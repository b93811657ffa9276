//! `Magnitude`: the scale of a problem.

use tautline_discretizations::QuadraticModel;

/// The energy of a curve and the size of the metric along it, which set the scale of everything
/// else.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Magnitude {
    /// The discrete energy, in `m²`.
    pub(crate) energy: f64,
    /// The mean `c` of `tr H / D` over the nodes, in `m²/ℓ²`.
    pub(crate) mean_gram: f64,
}

impl Magnitude {
    /// Returns the magnitude at the expansion point of a model.
    pub(crate) fn of(model: &QuadraticModel) -> Self {
        Self { energy: model.energy, mean_gram: model.mean_gram }
    }

    /// Returns a decrement relative to the energy, or 0 if the energy is 0.
    pub(crate) fn relative(self, decrement: f64) -> f64 {
        if self.energy > 0.0 { decrement / self.energy } else { 0.0 }
    }

    /// Returns the momentum `(c E)^{1/2}`, in `m²/ℓ`.
    pub(crate) fn momentum(self) -> f64 {
        // The roots are taken first, since the product may overflow or underflow.
        self.mean_gram.sqrt() * self.energy.sqrt()
    }

    /// Returns the `τ` of an [`EndFrame`](crate::newton::end_frame::EndFrame) on a grid of `n`
    /// chords. It is the inverse of the Hessian with respect to one end.
    pub(crate) fn tau(self, n: usize) -> f64 {
        1.0 / (2.0 * n as f64 * self.mean_gram)
    }
}

#[cfg(test)]
mod tests {
    use super::Magnitude;

    #[test]
    fn a_momentum_is_in_range_if_its_square_is_not() {
        for (energy, mean_gram, expected) in
            [(9.0, 4.0, 6.0), (4e200, 1e200, 2e200), (1e-200, 4e-200, 2e-200), (0.0, 1.0, 0.0)]
        {
            let momentum = Magnitude { energy, mean_gram }.momentum();
            assert!((momentum - expected).abs() <= 1e-15 * expected, "{momentum:e}");
        }
    }

    #[test]
    fn a_decrement_is_relative_to_a_positive_energy() {
        assert_eq!(Magnitude { energy: 0.0, mean_gram: 1.0 }.relative(0.0), 0.0);
        assert_eq!(Magnitude { energy: 4.0, mean_gram: 1.0 }.relative(1.0), 0.25);
    }
}
