//! `Curve`: a computed curve whose dimension is known when the program runs.

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    ANY, CertificateError, PointSequence, Rule,
    certify::Watch,
    distance::{Progress, Wanted},
};

use crate::{
    Bounds, CertifiedAnswer, Estimated, Line, Proofs, Search,
    answer::{extrapolated, search},
    bounds::bounds,
};

/// Is told of every level of a certificate, and may end the search.
pub type Observe<'o> = &'o mut dyn FnMut(Progress) -> ControlFlow<()>;

/// A computed discrete minimiser, and the curve that joins its points.
#[derive(Debug)]
pub struct Curve(Line);

impl From<Line> for Curve {
    fn from(line: Line) -> Self {
        Self(line)
    }
}

impl Curve {
    /// Returns the points, in `ℓ`.
    pub(super) fn sequence(&self) -> &PointSequence<ANY> {
        self.0.sequence()
    }

    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.0.sequence().dimension()
    }

    /// Returns the rule.
    #[must_use]
    pub fn rule(&self) -> Rule {
        self.0.rule()
    }

    /// Returns the points, one after the other, from the first set to the second, in `ℓ`.
    #[must_use]
    pub fn points(&self) -> Vec<f64> {
        self.sequence().coordinates().to_vec()
    }

    /// Returns the point of the curve at `t`, clamped to `[0, 1]`, in `ℓ`.
    #[must_use]
    pub fn at(&self, t: f64) -> Vec<f64> {
        self.0.curve().coordinates_at(t).collect()
    }

    /// Returns the energies of the local minima on the coarsest grid, in `m²`, lowest first.
    #[must_use]
    pub fn local_minima(&self) -> Vec<f64> {
        self.0.minimum().local_minima.clone()
    }

    /// Returns the length of the curve, in `m`: an upper bound on the distance up to the error of its
    /// quadrature.
    #[must_use]
    pub fn length(&self) -> Estimated {
        self.0.length().into()
    }

    /// Returns the energy of the curve, in `m²`.
    #[must_use]
    pub fn energy(&self) -> Estimated {
        self.0.energy().into()
    }

    /// Returns the discrete energy, in `m²`.
    #[must_use]
    pub fn discrete_energy(&self) -> f64 {
        self.0.discrete_energy()
    }

    /// Returns the distance by extrapolation over several grids, in `m`: an estimate, not a bound.
    #[must_use]
    pub fn extrapolated(&self) -> Option<Estimated> {
        extrapolated(&self.0)
    }

    /// Returns how the search ended.
    #[must_use]
    pub fn search(&self) -> Search {
        search(&self.0)
    }

    /// Returns whether the chords resolve the metric.
    #[must_use]
    pub fn is_resolved(&self) -> bool {
        self.0.is_resolved()
    }

    /// Returns whether the relative error of the length, as a distance, is at most `tolerance`, by
    /// extrapolation: an estimate, not a bound.
    #[must_use]
    pub fn is_within(&self, tolerance: f64) -> bool {
        self.0.is_within(tolerance)
    }

    /// Returns the speeds of the chords, in `m`.
    #[must_use]
    pub fn speeds(&self) -> Vec<f64> {
        self.0.speeds()
    }

    /// Returns other local minima that were met, shortest first.
    #[must_use]
    pub fn other_minima(&self) -> Vec<Arc<Self>> {
        self.0.other_minima().into_iter().map(|line| Arc::new(Self(line))).collect()
    }

    /// Returns the length of another local minimum that was met, in `m`, if it is
    /// [shorter](tautline::TautLine::shorter_minimum) than this curve.
    #[must_use]
    pub fn shorter_minimum(&self) -> Option<f64> {
        Some(self.0.shorter_minimum()?.length().value)
    }

    /// Returns why the curve may not be a shortest one, in words; empty if no reason is known.
    #[must_use]
    pub fn doubts(&self) -> Vec<String> {
        self.0.doubts().iter().map(ToString::to_string).collect()
    }

    /// Proves bounds on the distance, as [`TautLine::prove`](tautline::TautLine::prove) does, or
    /// takes them from constants that you claim. The search calls `watch` and `observe` as it goes
    /// on; either of them may end it.
    ///
    /// # Errors
    ///
    /// A sentence that says why there are none.
    pub fn bounds(
        &self,
        proofs: &Proofs,
        watch: &dyn Watch,
        observe: Observe<'_>,
    ) -> Result<Bounds, String> {
        self.0.metric().formula().map_err(|error| error.to_string())?;
        let proving = proofs.proving(self.dimension());
        bounds(proving, &self.0, &self.0.other_minima(), watch, observe)
    }

    /// Searches for a certificate of the distance, as
    /// [`TautLine::certificate_with`](tautline::TautLine::certificate_with) does.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    pub fn certificate(
        &self,
        wanted: Wanted,
        observe: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError> {
        self.0.metric().formula()?;
        CertifiedAnswer::of(&self.0, wanted, observe)
    }
}
