//! `Curve`: a computed curve whose dimension is known when the program runs.

use core::ops::ControlFlow;
use std::{fmt::Debug, sync::Arc};

use tautline::{
    CertificateError, Interpolation, Rule, TautLine,
    certify::Watch,
    distance::{Progress, Wanted},
};

use super::Proofs;
use crate::{
    Bounds, CertifiedAnswer, Estimated, Search,
    answer::is_shorter,
    bounds::bounds,
    known::Known,
    solve::{estimated, extrapolated, finer_grid, search},
};

/// How much more energy another minimum may have, and be shorter.
const NEAR: f64 = 1.02;

/// The same, where the chords do not resolve the metric.
const NOT_RESOLVED: f64 = 1.2;

/// Is told of every level of a certificate, and may end the search.
pub type Observe<'o> = &'o mut dyn FnMut(Progress) -> ControlFlow<()>;

/// A computed discrete minimiser, and the curve that joins its points.
pub trait Curve: Debug + Send + Sync {
    /// Returns the dimension.
    fn dimension(&self) -> usize;

    /// Returns the rule.
    fn rule(&self) -> Rule;

    /// Returns the points, one after the other, from the first set to the second, in `ℓ`.
    fn points(&self) -> Vec<f64>;

    /// Returns the point of the curve at `t`, clamped to `[0, 1]`, in `ℓ`.
    fn at(&self, t: f64) -> Vec<f64>;

    /// Returns the energies of the local minima on the coarsest grid, in `m²`, lowest first.
    fn local_minima(&self) -> Vec<f64>;

    /// Returns the length of the curve, in `m`: an upper bound on the distance up to the error of its
    /// quadrature.
    fn length(&self) -> Estimated;

    /// Returns the energy of the curve, in `m²`.
    fn energy(&self) -> Estimated;

    /// Returns the discrete energy, in `m²`.
    fn discrete_energy(&self) -> f64;

    /// Returns the distance by extrapolation over several grids, in `m`: an estimate, not a bound.
    fn extrapolated(&self) -> Option<Estimated>;

    /// Returns how the search ended.
    fn search(&self) -> Search;

    /// Returns whether the chords resolve the metric.
    fn is_resolved(&self) -> bool;

    /// Returns whether the relative error of the length, as a distance, is at most `tolerance`, by
    /// extrapolation: an estimate, not a bound.
    fn is_within(&self, tolerance: f64) -> bool;

    /// Returns the speeds of the chords, in `m`.
    fn speeds(&self) -> Vec<f64>;

    /// Returns other local minima that were met, shortest first.
    fn other_minima(&self) -> Vec<Arc<dyn Curve>>;

    /// Returns the length of another local minimum that was met, in `m`, if it is shorter than this curve
    /// by more than 10⁻⁵ of it. Those whose energy is far higher are not looked at.
    fn shorter_minimum(&self) -> Option<f64>;

    /// Proves bounds on the distance, as [`TautLine::prove`](tautline::TautLine::prove) does, or
    /// takes them from constants that you claim. The search calls `watch` and `observe` as it goes
    /// on; either of them may end it.
    ///
    /// # Errors
    ///
    /// A sentence that says why there are none.
    fn bounds(
        &self,
        proofs: &Proofs,
        watch: &dyn Watch,
        observe: Observe<'_>,
    ) -> Result<Bounds, String>;

    /// Searches for a certificate of the distance, as
    /// [`TautLine::certificate_with`](tautline::TautLine::certificate_with) does.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    fn certificate(
        &self,
        wanted: Wanted,
        observe: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError>;
}

impl<const D: usize> Curve for TautLine<Known<D>, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn rule(&self) -> Rule {
        TautLine::rule(self)
    }

    fn points(&self) -> Vec<f64> {
        self.sequence().points().iter().flatten().copied().collect()
    }

    fn at(&self, t: f64) -> Vec<f64> {
        TautLine::curve(self).at(t).as_slice().to_vec()
    }

    fn local_minima(&self) -> Vec<f64> {
        self.minimum().local_minima.clone()
    }

    fn length(&self) -> Estimated {
        estimated(TautLine::length(self))
    }

    fn energy(&self) -> Estimated {
        estimated(TautLine::energy(self))
    }

    fn discrete_energy(&self) -> f64 {
        TautLine::discrete_energy(self)
    }

    fn extrapolated(&self) -> Option<Estimated> {
        extrapolated(self)
    }

    fn search(&self) -> Search {
        search(self)
    }

    fn is_resolved(&self) -> bool {
        TautLine::is_resolved(self)
    }

    fn is_within(&self, tolerance: f64) -> bool {
        // NaN is no tolerance.
        tolerance > 0.0 && finer_grid(self, tolerance).is_none()
    }

    fn speeds(&self) -> Vec<f64> {
        TautLine::speeds(self)
    }

    fn other_minima(&self) -> Vec<Arc<dyn Curve>> {
        let held = |line| -> Arc<dyn Curve> { Arc::new(line) };
        TautLine::other_minima(self).into_iter().map(held).collect()
    }

    fn shorter_minimum(&self) -> Option<f64> {
        let others = &self.minimum().others;
        if others.is_empty() {
            return None;
        }
        let energy = TautLine::discrete_energy(self).max(TautLine::energy(self).value);
        let length = || TautLine::length(self).value;
        if TautLine::is_resolved(self) {
            // Their polygons are curves too. To follow them to the grid of this one takes as long as to
            // find it.
            let near = others.iter().filter(|other| other.energy <= NEAR * energy);
            let mut lengths =
                near.map(|other| Interpolation::new(&other.sequence).length(self.metric()).value);
            return lengths.find(|&other| is_shorter(other, length()));
        }
        if others.iter().all(|other| other.energy > NOT_RESOLVED * energy) {
            return None;
        }
        let length = length();
        let others = TautLine::other_minima(self);
        let lengths = others.iter().map(|other| TautLine::length(other).value);
        lengths.into_iter().find(|&other| is_shorter(other, length))
    }

    fn bounds(
        &self,
        proofs: &Proofs,
        watch: &dyn Watch,
        observe: Observe<'_>,
    ) -> Result<Bounds, String> {
        self.metric().formula().map_err(|error| error.to_string())?;
        bounds(proofs.proving(D), self, &TautLine::other_minima(self), watch, observe)
    }

    fn certificate(
        &self,
        wanted: Wanted,
        observe: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError> {
        self.metric().formula()?;
        CertifiedAnswer::of(self, wanted, observe)
    }
}
