//! `TautLine`: a computed shortest curve.

use std::sync::Arc;

use tautline_discretizations::{Integral, Interpolation, PointSequence, Rule};
use tautline_formula::{Formula, Prepared};
use tautline_metrics::Metric;
use tautline_optimizers::{Estimate, Minimum, extrapolate};
use tautline_sets::Ends;

/// A computed discrete minimiser and the curve `γᵖˡ` that joins its points.
#[derive(Clone, Debug)]
pub struct TautLine<M, R, const D: usize> {
    metric: Arc<Prepared<M, D>>,
    rule: R,
    ends: Ends<D>,
    minimum: Minimum<D>,
}

impl<M: Metric<D>, R: Rule, const D: usize> TautLine<M, R, D> {
    pub(crate) fn new(
        metric: Arc<Prepared<M, D>>,
        rule: R,
        ends: Ends<D>,
        minimum: Minimum<D>,
    ) -> Self {
        Self { metric, rule, ends, minimum }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        self.metric.metric()
    }

    /// Returns the metric, ready for batches.
    pub(crate) fn prepared(&self) -> &Arc<Prepared<M, D>> {
        &self.metric
    }

    /// Returns the formula of the metric, or `None` if it could not be recorded.
    pub(crate) fn formula(&self) -> Option<&Formula<D>> {
        self.metric.formula()
    }

    /// Returns the rule.
    pub(crate) fn rule(&self) -> R {
        self.rule
    }

    /// Returns the two sets that the line joins.
    #[must_use]
    pub fn ends(&self) -> &Ends<D> {
        &self.ends
    }

    /// Returns the discrete minimiser, and how it was found.
    #[must_use]
    pub fn minimum(&self) -> &Minimum<D> {
        &self.minimum
    }

    /// Returns the point sequence, in `ℓ`.
    #[must_use]
    pub fn sequence(&self) -> &PointSequence<D> {
        &self.minimum.sequence
    }

    /// Returns the curve through the points.
    #[must_use]
    pub fn curve(&self) -> Interpolation<'_, D> {
        Interpolation::new(self.sequence())
    }

    /// Returns the discrete energy of the rule, in `m²`.
    #[must_use]
    pub fn discrete_energy(&self) -> f64 {
        self.minimum.energy
    }

    /// Returns the energy `E(γᵖˡ) ≥ d²` of the curve, in `m²`, computed by quadrature with an error
    /// estimate.
    #[must_use]
    pub fn energy(&self) -> Integral {
        self.curve().energy_by_batches(&*self.metric)
    }

    /// Returns the length `L(γᵖˡ) ≥ d` of the curve, in `m`, computed by quadrature with an error
    /// estimate.
    #[must_use]
    pub fn length(&self) -> Integral {
        self.curve().length_by_batches(&*self.metric)
    }

    /// Returns the speeds of the chords, in `m`. They are nearly equal for a minimiser.
    #[must_use]
    pub fn speeds(&self) -> Vec<f64> {
        self.rule.speeds(self.metric(), self.sequence())
    }

    /// Returns the relative residual of the discrete geodesic equation (see [`Minimum`]).
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.minimum.residual
    }

    /// Returns an estimate of `d²`, in `m²`, by Richardson extrapolation over the grids of this
    /// line. It is not a bound. The result is `None` if there is a single grid: for `N ≤ 32`, for
    /// `N ≤ 64` with given starts only, if a grid of up to 512 chords led to another minimiser than
    /// the coarser ones, or if the ends touch.
    #[must_use]
    pub fn distance_squared_estimate(&self) -> Option<Estimate> {
        extrapolate(&self.minimum.levels, R::ERROR_EXPONENT)
    }
}
