//! `Proof`: bounds on `d²` that follow from the formula of the metric alone.

use std::ops::ControlFlow;

use tautline_bounds::{
    BoundError, Constants, DiscreteMinimum, Enclosure, LocalityError, PaperRule,
};
use tautline_certify::{
    Accuracy, AdmissibleCurve, CertifiedConstants, CertifyError, CurveError, Domain, Progress,
    Watch, constants_within,
};
use tautline_distance::AnyFound;
use tautline_formula::Prepare;
use tautline_metrics::LocalError;
use tautline_sets::Ball;

use crate::{TautLine, competitors::Search};

/// Bounds on `d²` that are proved from the formula of the metric.
#[derive(Clone, Debug)]
pub struct Proof<'a, const D: usize> {
    /// A curve from set to set, with rigorous bounds on its energy and length.
    pub curve: AdmissibleCurve<'a, D>,
    /// The constants, proved from the formula.
    pub constants: Constants,
    /// The region where the constants hold; `None` if it is all of `R^D`.
    pub within: Option<Ball<D>>,
    /// The bounds on `d²`. The upper bound is the rigorous bound on the curve.
    /// [`from_below`](Enclosure::from_below) says where the lower one is from: a certificate, or a
    /// theorem, which is evaluated in intervals, with proved constants and with enclosures of the
    /// length, of the discrete energy and of its residual. Both bounds hold to the last digit, and
    /// neither uses a quadrature.
    pub enclosure: Enclosure,
    /// The certificate, where the theorems would assume that the minimum is global; `None` if they
    /// assume nothing, or if there is no certificate.
    pub found: Option<AnyFound>,
}

/// The reason why a line has no proof.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum ProofError {
    /// The curve is not proved to join the sets, or it leaves the domain of the metric.
    #[error(transparent)]
    Curve(#[from] CurveError),
    /// The metric has no constants on all of `R^D`.
    #[error(transparent)]
    Constants(#[from] CertifyError),
    /// The metric has no constants on any ball that contains all competitors.
    #[error(transparent)]
    Competitors(#[from] LocalityError<LocalError>),
    /// The theorems do not apply.
    #[error(transparent)]
    Bound(#[from] BoundError),
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns a curve that certainly joins the two sets, with rigorous bounds on its energy and
    /// its length. They bound `d²` from above.
    ///
    /// # Errors
    ///
    /// [`CurveError`] if a set of your own does not implement
    /// [`ClosedSet::member_near`](crate::ClosedSet::member_near), if the metric is undefined on the
    /// curve, or if its formula cannot be recorded or is not known to be symmetric.
    pub fn admissible_curve(&self) -> Result<AdmissibleCurve<'_, D>, CurveError> {
        let formula = self.recorded().map_err(CurveError::NotRecorded)?.clone().into_any();
        AdmissibleCurve::by_formula(&formula, self.sequence(), self.any_ends())
    }

    /// Returns bounds on `d²`, in `m²`, like [`enclosure`](TautLine::enclosure), from the formula
    /// of the metric alone. The constants are proved on all of `R^D` if the formula is periodic.
    /// Otherwise they are proved on a ball that contains all [competitors](TautLine::competitors).
    /// If the budget is spent before a constant is as close as wanted, a wider one serves. `M_H` is
    /// proved only where it can make the bounds closer; without a bound on it, those theorems count
    /// that do not need it.
    ///
    /// Where the theorems would assume that the minimum found is the global one, a
    /// [certificate](TautLine::certificate) is searched for instead, with about the same gap. The
    /// enclosure has its lower bound, which assumes nothing: if this line is not the shortest, the
    /// distance is in the enclosure all the same. Only where there is no certificate,
    /// [`Enclosure::assumes_global_minimum`] may be set. The search takes up to two seconds in the plane,
    /// for a gap of 10⁻³ or down to 10⁻⁴, and some seconds for 10⁻² in space: ask for a smaller one by
    /// [`certificate`](TautLine::certificate).
    ///
    /// ```
    /// use tautline::{Ends, Metric, Problem, Rule, SMatrix, SVector, Scalar, certify};
    ///
    /// struct Dent; // (1 + e^{−|x|²})² I, without constants
    /// impl Metric<2> for Dent {
    ///     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
    ///         let square = x[0].sqr() + x[1].sqr();
    ///         SMatrix::from_diagonal_element(((-square).exp() + 1.0).sqr())
    ///     }
    /// }
    ///
    /// let ends = Ends::points([-0.5, 0.2], [0.5, 0.2])?;
    /// let line = Problem::new(Dent, ends).solve(Rule::TRAPEZOIDAL, 512)?;
    /// let proof = line.prove(certify::Accuracy::default())?;
    /// let d_squared = proof.enclosure;
    /// assert!(d_squared.width() < 1e-2 * d_squared.upper && proof.within.is_some());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// # Errors
    ///
    /// [`ProofError`], which names the missing part. A formula that cannot be
    /// [recorded](tautline_formula::Formula::record) has no proof, nor has a rule that is not one of
    /// the paper.
    pub fn prove(&self, accuracy: Accuracy) -> Result<Proof<'_, D>, ProofError> {
        let go_on = &mut |_| ControlFlow::Continue(());
        self.prove_watched(accuracy, &|_: Progress| true, go_on)
    }

    /// Does the same as [`prove`](TautLine::prove), and tells `watch` of the progress of each search
    /// for a constant, and `observe` of every level of a certificate. If one of them ends a search,
    /// what was found so far serves.
    ///
    /// # Errors
    ///
    /// Those of [`prove`](TautLine::prove).
    pub fn prove_watched(
        &self,
        accuracy: Accuracy,
        watch: &dyn Watch,
        observe: &mut dyn FnMut(tautline_distance::Progress) -> ControlFlow<()>,
    ) -> Result<Proof<'_, D>, ProofError> {
        let accuracy = accuracy.checked()?;
        let rule = self.rule().paper_rule()?;
        let curve = self.admissible_curve()?;
        let extent = self.proved_extent(&curve);
        // The left-endpoint rule needs M_H only to prove a minimum between two points global.
        let m_h = rule == PaperRule::Trapezoidal || self.any_ends().are_points();
        let watch = Needed { m_h, watch };
        let formula = self.recorded().map_err(CertifyError::NotRecorded)?.clone().into_any();
        let space = Domain::space_by_formula(&formula);
        let (constants, within) = if space.is_one_period() {
            let proved =
                CertifiedConstants::within_budget_by_formula(&formula, &space, accuracy, &watch)?;
            (proved.constants()?, None)
        } else {
            // Constants on a ball are closer than those on all of space, if there are any.
            let constants_within = &|centre: &[f64], radius: f64| {
                constants_within(&formula, centre, radius, accuracy, &watch)
            };
            let search = Search { rule, n: self.sequence().n(), extent, constants_within };
            let competitors = search.about_ends(self.any_ends())?;
            competitors.hold_those_of(self, extent)?;
            (competitors.constants, Some(competitors.into_dimension().within))
        };
        let mut enclosure = self.enclosure_by(constants, extent)?;
        let found = self.instead_of_an_assumption(&enclosure, observe);
        if let Some(found) = &found {
            let is_not_global = enclosure.is_not_global;
            let without =
                self.enclosure_unless_convex(constants, extent, DiscreteMinimum::Unknown)?;
            // The square may be rounded up to the next double.
            let least = (found.lower() * found.lower()).next_down();
            enclosure = Enclosure { is_not_global, ..without.with_certificate(least)? };
        }
        Ok(Proof { curve, constants, within, enclosure, found })
    }
}

/// Watches the searches for those constants that are needed.
struct Needed<'w> {
    m_h: bool,
    watch: &'w dyn Watch,
}

impl Watch for Needed<'_> {
    fn goes_on(&self, progress: Progress) -> bool {
        self.watch.goes_on(progress)
    }

    fn needs_m_h(&self) -> bool {
        self.m_h && self.watch.needs_m_h()
    }
}

#[cfg(test)]
mod tests;
