//! `GeodesicMeans`: averages of the bending of a geodesic and of the change of the metric along it.

use nalgebra::SVector;
use tautline_metrics::{Jet2, Metric, MetricError, christoffel, norm_squared};

use crate::Minimum;

/// Integrals over `t ∈ [0, 1]` along a computed minimiser `γ`, in `m²` (the last one in `m⁴`),
/// where `w = DH[γ̇](γ̇, γ̇)`. The midpoint rule on the chords computes them to second order.
#[derive(Default)]
pub(crate) struct GeodesicMeans {
    /// `∫ γ̈ᵀHγ̈`.
    pub(crate) bending: f64,
    /// `∫ (γ̈ᵀHγ̈ − w²/4γ̇ᵀHγ̇)`, which is the bending due to the component of `γ̈` across `γ̇`.
    pub(crate) turning: f64,
    /// `∫ D²H[γ̇, γ̇](γ̇, γ̇)`.
    pub(crate) second: f64,
    /// `∫ w`.
    pub(crate) growth: f64,
    /// `∫ w²`.
    pub(crate) growth_squared: f64,
}

impl GeodesicMeans {
    /// Sums over the chords. It fails if the metric is not positive definite at the middle of a
    /// chord.
    pub(crate) fn along<const D: usize>(
        metric: &impl Metric<D>,
        minimum: &Minimum<D>,
    ) -> Result<Self, MetricError> {
        let weight = 1.0 / minimum.sequence.n().get() as f64;
        let mut means = Self::default();
        for (x, d) in minimum.sequence.chords() {
            let (middle, velocity) = (x + d * 0.5, d / weight);
            // γ̈ follows from the geodesic equation, since second differences would multiply
            // rounding by N².
            let gamma = christoffel(metric, &middle)?;
            let acceleration =
                SVector::<f64, D>::from_fn(|k, _| -velocity.dot(&(gamma[k] * velocity)));
            // This is the metric along the line through the chord, as a function of time.
            let [t] = Jet2::variables(&[0.0]);
            let line = SVector::<_, D>::from_fn(|i, _| t * velocity[i] + middle[i]);
            let square: Jet2<f64, 1> = norm_squared(metric, &line, &velocity);
            let growth = square.first(0);
            let bending: f64 = norm_squared(metric, &middle, &acceleration);
            means.bending += weight * bending;
            // Dividing by the squared speed on this chord instead of d² makes the difference a
            // square, which vanishes if the curve does not turn.
            means.turning += weight * (bending - growth * growth / (4.0 * square.value()));
            means.second += weight * square.second(0, 0);
            means.growth += weight * growth;
            means.growth_squared += weight * growth * growth;
        }
        Ok(means)
    }
}
