//! Bounds on `d²` from a computed line, and the `N` that a tolerance requires.

use std::num::NonZeroUsize;

use nalgebra::DVectorView;
use tautline_bounds::{
    BetweenPoints, BoundError, Computed, Constants, DiscreteMinimum, Enclosure, PaperRule, Setting,
    Theorem, convex_excess_outward, enclose_outward, strict_convexity_outward, suggest_n,
};
use tautline_certify::{AdmissibleCurve, Polygon};
use tautline_discretizations::LinearModel;
use tautline_formula::Prepare;
use tautline_metrics::{Bounded, Metric};
use tautline_scalar::{Interval, Scalar};

use crate::{Competitors, TautLine};

/// Numbers of subintervals for which `L(γᵖˡ)² − d²` is within a tolerance.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct SuggestedN {
    /// The proven `N` for a global minimiser, with the theorem that proves it; `None` if no theorem
    /// applies up to `N = 2⁴⁰`, or if the length of the line has no proved bound.
    pub proven: Option<(NonZeroUsize, Theorem)>,
    /// The expected `N`, based on an excess over the extrapolated `d²` that falls like `1/N²`.
    /// `None` if there are too few grids, or if the excess is within the noise.
    pub expected: Option<NonZeroUsize>,
}

/// What the theorems need of a curve and of its points: upper bounds, unless their names say otherwise.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    /// The energy, in `m²`.
    pub(crate) energy: f64,
    /// A lower bound on the energy, in `m²`.
    pub(crate) energy_at_least: f64,
    /// The length, in `m`.
    pub(crate) length: f64,
    /// The squared length, in `m²`.
    pub(crate) length_squared: f64,
    /// The discrete energy `E_N`, in `m²`.
    pub(crate) discrete_energy: f64,
    /// A lower bound on the discrete energy, in `m²`.
    pub(crate) discrete_energy_at_least: f64,
    /// A lower bound on the Euclidean distance between the ends, in `ℓ`; 0 if the ends are no points.
    pub(crate) gap_at_least: f64,
    /// How far the points are from stationary ones; `None` if the ends are no points.
    pub(crate) stationarity: Option<Stationarity>,
}

/// How far points between fixed ends are from stationary ones, from above.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stationarity {
    /// `max |βₙ|`, in `ℓ`.
    greatest_difference: f64,
    /// `((1/N) Σ |ρₙ|²)^{1/2}`, in `m²/ℓ`.
    residual: f64,
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns the bounds by quadrature, with its estimated errors added, and what is computed of the
    /// points in doubles.
    pub(crate) fn extent(&self) -> Extent {
        let (length, energy) = (self.length(), self.energy());
        let length = length.value + length.error;
        let sequence = self.sequence();
        let n = sequence.n().get();
        let fixed = self.any_ends().are_points();
        let point =
            |k: usize| -> Vec<_> { sequence.row(k).iter().map(|&x| Interval::point(x)).collect() };
        Extent {
            energy: energy.value + energy.error,
            energy_at_least: energy.value - energy.error,
            length,
            length_squared: length * length,
            discrete_energy: self.discrete_energy(),
            discrete_energy_at_least: self.discrete_energy(),
            gap_at_least: if fixed { gap(&point(0), &point(n)) } else { 0.0 },
            stationarity: fixed.then(|| {
                let (nodes, d) = (self.rule().nodes(), sequence.dimension());
                let LinearModel { slopes, .. } =
                    LinearModel::by_batches(nodes, M::plain(self.prepared()), sequence);
                let squares: f64 = slopes[d..n * d].chunks_exact(d).map(norm_squared).sum();
                let difference = |k: usize| {
                    let both = sequence.row(k).iter().zip(sequence.row(k + 1));
                    let beta: Vec<f64> = both.map(|(x, y)| (y - x) * n as f64).collect();
                    norm_squared(&beta).sqrt()
                };
                Stationarity {
                    greatest_difference: (0..n).map(difference).fold(0.0, f64::max),
                    // The root of the mean (1/N) Σ |ρₙ|², where ρₙ = ½N ∂E/∂xₙ.
                    residual: 0.5 * (n as f64 * squares).sqrt(),
                }
            }),
        }
    }

    /// Returns proved bounds, given the proved curve of this line.
    pub(crate) fn proved_extent(&self, curve: &AdmissibleCurve<'_, D>) -> Extent {
        let polygon = curve.polygon();
        let fixed = self.any_ends().are_points();
        let formula = self.formula().map(|formula| formula.clone().into_any());
        let formula = formula.as_ref();
        let discrete_energy = |polygon: &Polygon<'_, D>| {
            let energy = |formula| polygon.discrete_energy_by_formula(self.rule(), formula);
            formula.map_or(Interval::UNDEFINED, energy)
        };
        // The ends are moved into their sets, by a few roundings. The minimum that was found is that of
        // the points before, and both are sequences that competitors are compared with.
        let found = Polygon::new(self.sequence());
        let discrete_energy = discrete_energy(polygon).hull(discrete_energy(&found));
        Extent {
            energy: curve.energy().hi(),
            energy_at_least: curve.energy().lo(),
            length: curve.length().hi(),
            length_squared: curve.distance_squared_at_most(),
            discrete_energy: discrete_energy.hi(),
            discrete_energy_at_least: discrete_energy.lo(),
            gap_at_least: if fixed { gap(polygon.first(), polygon.last()) } else { 0.0 },
            stationarity: fixed.then(|| Stationarity {
                greatest_difference: polygon.greatest_difference().hi(),
                residual: formula
                    .map_or(Interval::UNDEFINED, |formula| {
                        polygon.residual_by_formula(self.rule(), formula)
                    })
                    .hi(),
            }),
        }
    }
}

/// Returns the sum of the squares.
fn norm_squared(x: &[f64]) -> f64 {
    DVectorView::from_slice(x, x.len()).norm_squared()
}

/// Returns a lower bound on the Euclidean distance between two points, or 0 if it overflows.
fn gap(first: &(impl AsRef<[Interval]> + ?Sized), last: &(impl AsRef<[Interval]> + ?Sized)) -> f64 {
    let squares = first.as_ref().iter().zip(last.as_ref()).map(|(&x, &y)| (y - x).sqr());
    let gap = squares.fold(Interval::constant(0.0), |sum, square| sum + square).sqrt().lo();
    if gap.is_finite() { gap } else { 0.0 }
}

impl<M: Bounded<D>, const D: usize> TautLine<M, D> {
    /// Returns bounds on `d²`, in `m²`, from this line and the constants of the metric.
    ///
    /// - The upper bound is the squared length of the line plus the quadrature error. It needs no
    ///   assumption.
    /// - The lower bound follows from the theorems. Between two points nothing is assumed if the
    ///   discrete energy is strictly convex where the line and the minimal geodesics are
    ///   (Proposition S.9), or where all competitors are (Proposition S.7). Otherwise a global
    ///   minimum is assumed, and [`Enclosure::assumes_global_minimum`] is set.
    ///
    /// Needs: the metric satisfies its constants. The discrete energy and its residual are computed in
    /// `f64`, and the quadrature has an estimated error, so that the bounds are not certified to the last
    /// digits. Those of [`prove`](TautLine::prove) are.
    ///
    /// # Errors
    ///
    /// [`BoundError::OtherRule`] if the rule is not one of the paper;
    /// [`BoundError::LocalConstants`] if the constants only hold on a region; another
    /// [`BoundError`] if an energy is not finite.
    pub fn enclosure(&self) -> Result<Enclosure, BoundError> {
        self.enclosure_by(global(self.metric().constants())?, self.extent())
    }

    /// Suggests an `N` for which `L(γᵖˡ)² − d²` is at most `tolerance`, in `m²`. The proven `N`
    /// follows from the theorems with a proved upper bound on the length of this line for `d`; the
    /// expected `N` follows from extrapolation over the grids of this line.
    ///
    /// # Errors
    ///
    /// [`BoundError::OtherRule`] if the rule is not one of the paper;
    /// [`BoundError::LocalConstants`] if the constants only hold on a region; another
    /// [`BoundError`] if the length is not finite.
    pub fn suggest_n(&self, tolerance: f64) -> Result<SuggestedN, BoundError> {
        self.suggest_n_by(global(self.metric().constants())?, tolerance)
    }
}

/// Rejects constants that only hold on a region.
fn global(constants: Constants) -> Result<Constants, BoundError> {
    if constants.is_local() { Err(BoundError::LocalConstants) } else { Ok(constants) }
}

impl<M: Metric<D>, const D: usize> TautLine<M, D> {
    /// Returns bounds on `d²`, in `m²`, like [`enclosure`](TautLine::enclosure), by constants that
    /// hold where all [competitors](TautLine::competitors) of this line are. A global minimum
    /// then means a minimum among the sequences in that ball.
    ///
    /// Needs: the competitors are those of a line under the same metric.
    ///
    /// # Errors
    ///
    /// [`BoundError::OtherRule`] if the rule is not one of the paper;
    /// [`BoundError::LeavesTheBall`] if a competitor of this line might be outside the ball, which
    /// then belongs to another line; [`BoundError::Contradiction`] if the constants do not hold;
    /// another [`BoundError`] if an energy is not finite.
    pub fn enclosure_among(&self, competitors: &Competitors<D>) -> Result<Enclosure, BoundError> {
        let extent = self.extent();
        competitors.hold_those_of(self, extent)?;
        self.enclosure_by(competitors.constants, extent)
    }

    /// Suggests an `N` like [`suggest_n`](TautLine::suggest_n), by constants that hold where all
    /// [competitors](TautLine::competitors) of this line are. The proven `N` is at least the `N` of
    /// this line. From there on no sequence with as little energy leaves the ball, since the bounds
    /// of Lemma S.4 fall with `N`.
    ///
    /// # Errors
    ///
    /// [`BoundError::OtherRule`] and [`BoundError::LeavesTheBall`] as for
    /// [`enclosure_among`](TautLine::enclosure_among); another [`BoundError`] if the length is not
    /// finite.
    pub fn suggest_n_among(
        &self,
        competitors: &Competitors<D>,
        tolerance: f64,
    ) -> Result<SuggestedN, BoundError> {
        competitors.hold_those_of(self, self.extent())?;
        let suggested = self.suggest_n_by(competitors.constants, tolerance)?;
        let n = self.sequence().n();
        let proven = suggested.proven.map(|(least, theorem)| (least.max(n), theorem));
        Ok(SuggestedN { proven, ..suggested })
    }

    fn suggest_n_by(&self, constants: Constants, tolerance: f64) -> Result<SuggestedN, BoundError> {
        let rule = self.rule().paper_rule()?;
        let length = self.length();
        let proven = match self.admissible_curve() {
            Ok(curve) => {
                let setting = Setting::new(constants, curve.length().hi(), D)?;
                suggest_n(setting, rule, tolerance)
            }
            Err(_) => None,
        };
        let expected = self.distance_squared_estimate().and_then(|estimate| {
            let excess = length.value * length.value - estimate.value;
            let noise = estimate.error + 2.0 * length.value * length.error;
            let count = self.sequence().n().get() as f64 * (excess / tolerance).sqrt();
            let is_known = excess > noise && count.is_finite() && count < 2_f64.powi(40);
            NonZeroUsize::new(if is_known { count.ceil() as usize } else { 0 })
        });
        Ok(SuggestedN { proven, expected })
    }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns bounds on `d²`, in `m²`, like [`enclosure`](TautLine::enclosure), by constants that
    /// you claim for this metric on all of `R^D`. They count as
    /// [isotropic](Constants::is_isotropic) if the formula shows that `H` is a multiple of the
    /// identity.
    ///
    /// With the [proved curve](TautLine::admissible_curve) of this line, energies and lengths are
    /// enclosed, and if the claims hold, so do the bounds to the last digit. Without it they rest on
    /// the estimated errors of quadrature.
    ///
    /// Needs: the curve is that of this line.
    ///
    /// # Errors
    ///
    /// As for [`enclosure`](TautLine::enclosure).
    pub fn enclosure_given(
        &self,
        constants: Constants,
        curve: Option<&AdmissibleCurve<'_, D>>,
    ) -> Result<Enclosure, BoundError> {
        let is_isotropic = self.formula().is_some_and(tautline_certify::is_isotropic);
        let constants = if is_isotropic { constants.isotropic() } else { constants };
        let extent = curve.map_or_else(|| self.extent(), |curve| self.proved_extent(curve));
        self.enclosure_by(global(constants)?, extent)
    }

    /// Returns bounds on `d²`, given constants that hold and bounds on the curve.
    pub(crate) fn enclosure_by(
        &self,
        constants: Constants,
        extent: Extent,
    ) -> Result<Enclosure, BoundError> {
        self.enclosure_unless_convex(constants, extent, DiscreteMinimum::Assumed)
    }

    /// Does the same. `otherwise` is what is known of the discrete minimum if no convexity proves it
    /// to be global.
    pub(crate) fn enclosure_unless_convex(
        &self,
        constants: Constants,
        extent: Extent,
        otherwise: DiscreteMinimum,
    ) -> Result<Enclosure, BoundError> {
        let (rule, d) = (self.rule().paper_rule()?, self.sequence().dimension());
        let Extent { energy, energy_at_least, length_squared, .. } = extent;
        let least = extent.discrete_energy_at_least;
        let between = self.between_points(rule, extent);
        let certified =
            between.and_then(|between| strict_convexity_outward(constants, d, &between, least));
        let computed = Computed {
            rule,
            n: self.sequence().n(),
            discrete_energy: least,
            energy,
            length_squared,
            minimum: certified.map_or(otherwise, DiscreteMinimum::AtLeast),
            // Between two sets the gap is unknown.
            gap: extent.gap_at_least,
        };
        let enclosure = enclose_outward(constants, d, &computed)?;
        match between.and_then(|between| convex_excess_outward(constants, d, &between)) {
            Some(excess) => {
                let lower = Interval::point(energy_at_least) - Interval::point(excess);
                enclosure.with_convexity(lower.lo())
            }
            None => Ok(enclosure),
        }
    }

    /// Returns what convexity needs of this line between two points.
    fn between_points(&self, rule: PaperRule, extent: Extent) -> Option<BetweenPoints> {
        let Stationarity { greatest_difference, residual } = extent.stationarity?;
        Some(BetweenPoints {
            rule,
            n: self.sequence().n(),
            discrete_energy: extent.discrete_energy,
            length: extent.length,
            greatest_difference,
            residual,
        })
    }
}

#[cfg(test)]
mod tests;
