//! `Curve`: a computed curve whose dimension is known when the program runs.

use core::ops::ControlFlow;
use std::{fmt::Debug, sync::Arc};

use tautline::{
    CertificateError, LeftEndpoint, Rule, TautLine, Trapezoidal, TrueTrapezoid,
    distance::{Progress, Wanted},
};

use super::known::Known;
use crate::{
    CertifiedAnswer, Estimated, Search,
    file::request::RuleName,
    solve::{estimated, extrapolated, search},
};

/// A computed discrete minimiser, and the curve that joins its points.
pub trait Curve: Debug + Send + Sync {
    /// Returns the dimension.
    fn dimension(&self) -> usize;

    /// Returns the rule.
    fn rule(&self) -> RuleName;

    /// Returns the points, one after the other, from the first set to the second, in `ℓ`.
    fn points(&self) -> Vec<f64>;

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

    /// Returns the speeds of the chords, in `m`.
    fn speeds(&self) -> Vec<f64>;

    /// Returns other local minima that were met, shortest first.
    fn other_minima(&self) -> Vec<Arc<dyn Curve>>;

    /// Searches for a certificate of the distance, as
    /// [`TautLine::certificate_with`](tautline::TautLine::certificate_with) does.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    fn certificate(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<CertifiedAnswer, CertificateError>;
}

/// A rule with a name in files.
pub(super) trait NamedRule: Rule + 'static {
    const NAME: RuleName;
}

impl NamedRule for Trapezoidal {
    const NAME: RuleName = RuleName::Trapezoidal;
}

impl NamedRule for LeftEndpoint {
    const NAME: RuleName = RuleName::LeftEndpoint;
}

impl NamedRule for TrueTrapezoid {
    const NAME: RuleName = RuleName::TrueTrapezoid;
}

impl<R: NamedRule, const D: usize> Curve for TautLine<Known<D>, R, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn rule(&self) -> RuleName {
        R::NAME
    }

    fn points(&self) -> Vec<f64> {
        self.sequence().points().iter().flatten().copied().collect()
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
        search(self.minimum())
    }

    fn is_resolved(&self) -> bool {
        TautLine::is_resolved(self)
    }

    fn speeds(&self) -> Vec<f64> {
        TautLine::speeds(self)
    }

    fn other_minima(&self) -> Vec<Arc<dyn Curve>> {
        let held = |line| -> Arc<dyn Curve> { Arc::new(line) };
        TautLine::other_minima(self).into_iter().map(held).collect()
    }

    fn certificate(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<CertifiedAnswer, CertificateError> {
        CertifiedAnswer::of(self, wanted, observe)
    }
}
