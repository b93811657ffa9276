//! `TautLine`: a computed shortest curve.

use std::sync::{Arc, OnceLock};

use nalgebra::SVector;
use tautline_certify::is_metric_at;
use tautline_discretizations::{Integral, Interpolation, PointSequence, Rule, SequenceError};
use tautline_formula::{AnyBatches, Formula, Prepare, RecordError};
use tautline_metrics::Metric;
use tautline_optimizers::{
    Estimate, Minimum, Options, SolveError, Stop, Workspace, extrapolate, minimise_any,
};
use tautline_sets::{AnyEnds, Ends, proved_common_point_of};

use crate::both_ends::BothEnds;

/// A computed discrete minimiser and the curve `γᵖˡ` that joins its points.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`](tautline_scalar::ANY) and the metric is
/// [`Known`](tautline_formula::Known).
#[derive(Debug)]
pub struct TautLine<M: Prepare<D>, const D: usize> {
    metric: Arc<M::Prepared>,
    rule: Rule,
    ends: BothEnds<D>,
    minimum: Minimum<D>,
    energy: OnceLock<Integral>,
    length: OnceLock<Integral>,
}

/// The largest difference between the energy of the curve and the discrete energy, relative to the
/// former, if the chords resolve the metric. Both differ from `d²` by a term that falls with `N`,
/// usually far below this.
const RESOLVED: f64 = 0.1;

/// If the difference is more than `DOUBTFUL`, it should be one of these terms, and thus comparable
/// to the change of the discrete energy since the coarser grid. If it is `SPREAD` times as large, the
/// rule sees the same wrong metric on both grids.
const DOUBTFUL: f64 = 0.01;
const SPREAD: f64 = 10.0;

impl<M: Prepare<D>, const D: usize> Clone for TautLine<M, D> {
    fn clone(&self) -> Self {
        let Self { metric, rule, ends, minimum, energy, length } = self;
        Self {
            metric: Arc::clone(metric),
            rule: *rule,
            ends: ends.clone(),
            minimum: minimum.clone(),
            energy: energy.clone(),
            length: length.clone(),
        }
    }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    pub(crate) fn new(
        metric: Arc<M::Prepared>,
        rule: Rule,
        ends: impl Into<BothEnds<D>>,
        minimum: Minimum<D>,
    ) -> Self {
        let (energy, length) = Default::default();
        Self { metric, rule, ends: ends.into(), minimum, energy, length }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        M::metric(&self.metric)
    }

    /// Returns the metric, ready for batches.
    pub(crate) fn prepared(&self) -> &Arc<M::Prepared> {
        &self.metric
    }

    /// Returns the formula of the metric, or `None` if it could not be recorded.
    #[must_use]
    pub fn formula(&self) -> Option<&Formula<D>> {
        self.recorded().ok()
    }

    /// Returns the formula of the metric, or why it could not be recorded.
    pub(crate) fn recorded(&self) -> Result<&Formula<D>, RecordError> {
        M::formula(&self.metric)
    }

    /// Returns the rule.
    #[must_use]
    pub fn rule(&self) -> Rule {
        self.rule
    }

    /// Returns the line that another rule finds between the same sets, with as many chords, from automatic
    /// starts.
    ///
    /// # Errors
    ///
    /// As for [`Problem::solve`](crate::Problem::solve).
    pub fn by_rule(&self, rule: Rule) -> Result<Self, SolveError> {
        let (metric, n) = (Arc::clone(&self.metric), self.sequence().n().get());
        let (mut workspace, options) = (Workspace::default(), Options::default());
        let found =
            minimise_any(&mut workspace, &*metric, self.any_ends(), rule, n, &options, None)?;
        Ok(Self::new(metric, rule, self.ends.clone(), found))
    }

    /// Returns the two sets that the line joins, in a dimension that is a value.
    #[must_use]
    pub fn any_ends(&self) -> &AnyEnds {
        self.ends.any()
    }

    pub(crate) fn both_ends(&self) -> &BothEnds<D> {
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
    /// estimate. If the sets [touch](Stop::EndsTouch) up to rounding, the error contains the square of
    /// what the rounding may be worth.
    #[must_use]
    pub fn energy(&self) -> Integral {
        *self.energy.get_or_init(|| {
            let energy = self.curve().energy_by_batches(&*self.metric);
            Integral { error: energy.error + self.contact().powi(2), ..energy }
        })
    }

    /// Returns the length `L(γᵖˡ) ≥ d` of the curve, in `m`, computed by quadrature with an error
    /// estimate. If the sets [touch](Stop::EndsTouch) up to rounding, the error contains what the
    /// rounding may be worth.
    #[must_use]
    pub fn length(&self) -> Integral {
        *self.length.get_or_init(|| {
            let length = self.curve().length_by_batches(&*self.metric);
            Integral { error: length.error + self.contact(), ..length }
        })
    }

    /// Returns how long a curve from set to set may be, in `m`, if the ends are members of both sets up
    /// to rounding only; 0 for other ends, and for a [proved common point](TautLine::proved_contact).
    ///
    /// The nearest points of both sets agree with the ends to within `(D + 4) ε max |xᵢ|` in every
    /// coordinate ([`common_point`](tautline_sets::common_point())), so that they are at most
    /// `√D (D + 4) ε max |xᵢ|` away from each end, and the metric is at most its trace.
    fn contact(&self) -> f64 {
        if self.minimum.stop != Stop::EndsTouch || self.proved_contact().is_some() {
            return 0.0;
        }
        let dimension = self.sequence().dimension();
        let mut gram = vec![0.0; dimension * dimension];
        let mut away = |x: &[f64]| {
            let largest = x.iter().fold(0.0, |most: f64, x| most.max(x.abs()));
            let rounding = (dimension + 4) as f64 * f64::EPSILON * largest;
            self.metric.gram_into(x, &mut gram);
            let trace: f64 = gram.iter().step_by(dimension + 1).sum();
            rounding * (dimension as f64 * trace).sqrt()
        };
        self.end_points().into_iter().map(&mut away).sum()
    }

    /// Returns both ends of the curve, in `ℓ`.
    pub(crate) fn end_points(&self) -> [&[f64]; 2] {
        [0, self.sequence().n().get()].map(|k| self.sequence().row(k))
    }

    /// Returns a point that is proved to be a member of both sets, where the metric is proved to be positive
    /// definite, in `ℓ`.
    /// Then the distance is 0.
    ///
    /// The result is `None` if the search did not end where the sets
    /// [touch](Stop::EndsTouch); and also if they touch up to rounding, but no double near by is a member
    /// of both. Then the distance may be positive: under a metric with a large scale a rounding is a long
    /// way.
    #[must_use]
    pub fn proved_contact(&self) -> Option<Vec<f64>> {
        if self.minimum.stop != Stop::EndsTouch {
            return None;
        }
        let shared = self.any_ends().pairs().iter().find_map(|[a, b]| {
            let near = self.end_points().into_iter();
            near.filter_map(|x| proved_common_point_of(&**a, &**b, x)).next()
        });
        shared.filter(|x| self.formula().is_some_and(|formula| is_metric_at(formula, x)))
    }

    /// Returns `n + 1` points on the curve at constant speed, in `ℓ`: the length under the metric is
    /// the same between any two neighbours, [along this curve](Interpolation::resampled).
    ///
    /// # Errors
    ///
    /// [`SequenceError`], for an `n` that is out of range.
    pub fn resampled(&self, n: usize) -> Result<PointSequence<D>, SequenceError> {
        self.curve().resampled(&*self.metric, n)
    }

    /// Returns the speeds of the chords, in `m`. They are nearly equal for a minimiser.
    #[must_use]
    pub fn speeds(&self) -> Vec<f64> {
        self.rule.speeds_by_batches(&*self.metric, self.sequence())
    }

    /// Returns the relative residual of the discrete geodesic equation (see [`Minimum`]).
    #[must_use]
    pub fn residual(&self) -> f64 {
        self.minimum.residual
    }

    /// Returns whether the chords resolve the metric: whether the energy of the curve and the discrete
    /// energy differ by at most a hundredth, or by at most a tenth if that is not far more than the
    /// change of the discrete energy since the coarser grid. Otherwise the metric changes between the
    /// nodes of the rule, and more chords are needed.
    ///
    /// Where the metric is infinite at an end, the energy of the curve may be infinite and its length finite. The
    /// square of the length, the energy at constant speed, then takes its place.
    #[must_use]
    pub fn is_resolved(&self) -> bool {
        let Integral { value, error } = self.energy();
        let energy = match value {
            f64::INFINITY => self.length().value.powi(2),
            energy if error > RESOLVED * energy => return false,
            energy => energy,
        };
        let difference = (energy - self.discrete_energy()).abs();
        let is_explained = match self.minimum.levels[..] {
            [.., coarse, fine] => difference <= SPREAD * (fine.energy - coarse.energy).abs(),
            _ => true,
        };
        difference <= DOUBTFUL * energy || difference <= RESOLVED * energy && is_explained
    }

    /// Returns an estimate of `d²`, in `m²`, by Richardson extrapolation over the grids of this
    /// line. It is not a bound. The result is `None` if there is a single grid: for `N ≤ 32`, for
    /// `N ≤ 64` with given starts only, if a grid of up to 512 chords led to another minimiser than
    /// the coarser ones, if the search did not converge, if the chords do not
    /// [resolve](TautLine::is_resolved) the metric, or if the ends touch.
    #[must_use]
    pub fn distance_squared_estimate(&self) -> Option<Estimate> {
        let is_known = self.minimum.stop == Stop::Converged && self.is_resolved();
        let estimate =
            extrapolate(&self.minimum.levels, self.rule.error_exponent()).filter(|_| is_known)?;
        // The estimate is wrong at least by what it exceeds an upper bound on `d²`.
        let above = estimate.value - (self.length().value + self.length().error).powi(2);
        Some(Estimate { error: estimate.error.max(above), ..estimate })
    }
}

impl<M: Metric<D>, const D: usize> TautLine<M, D> {
    /// Returns the two sets that the line joins.
    #[must_use]
    pub fn ends(&self) -> &Ends<D> {
        self.ends.typed()
    }

    /// Returns a [proved common point](TautLine::proved_contact) of both sets, in `ℓ`.
    #[must_use]
    pub fn common_point(&self) -> Option<SVector<f64, D>> {
        self.proved_contact().map(|x| SVector::from_column_slice(&x))
    }
}

#[cfg(test)]
mod tests {
    use tautline_discretizations::Rule;
    use tautline_metrics::gallery::{Bump, Constant};
    use tautline_sets::{Ball, Ends};

    use tautline_optimizers::Stop;

    use crate::{Options, Problem};

    /// No node is on the bump until the chords are shorter than it is wide. The rule then sees the
    /// Euclidean plane, and all grids agree on a wrong distance.
    #[test]
    fn a_bump_between_the_nodes_is_not_resolved() {
        let bump = Bump::new(1000.0, 7e-4).expect("a bump");
        let ends = || Ends::points([-2.0031, 0.0], [1.9969, 0.0]).expect("finite");
        let line = Problem::new(bump, ends()).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
        let [discrete, energy] = [line.discrete_energy(), line.energy().value];
        assert!((discrete - 16.0).abs() < 1e-4 && energy > 20.0, "{discrete} {energy}");
        assert!(!line.is_resolved());
        assert_eq!(line.distance_squared_estimate(), None);
        // A twentieth of the energy is no error of the rule if the grids agree to far less.
        let low = Bump::new(12.0, 7e-4).expect("a bump");
        let line = Problem::new(low, ends()).solve(Rule::TRAPEZOIDAL, 256).expect("solved");
        let difference = line.energy().value / line.discrete_energy() - 1.0;
        assert!((0.01..0.1).contains(&difference), "{difference}");
        assert!(!line.is_resolved());
        let ends = Ends::points([-2.0, 0.1], [2.0, 0.0]).expect("finite");
        let wide = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
        let line = wide.solve(Rule::TRAPEZOIDAL, 256).expect("solved");
        assert!(line.is_resolved() && line.distance_squared_estimate().is_some());
    }

    /// Balls whose surfaces are `2⁻⁵¹` apart touch up to rounding. The nearest points of both are at most
    /// `√2 · 6 ε max |xᵢ|` away from each of the two ends, and `H` is at most its trace, 16.
    #[test]
    fn what_a_rounding_may_be_worth_is_in_the_errors_of_both_integrals() {
        let metric = Constant::<2>::new([[4.0, 0.0], [0.0, 12.0]].into()).expect("definite");
        let line = |gap: f64| {
            let [first, second] =
                [0.0, 2.0 + gap].map(|x| Ball::new([x, 0.0], 1.0).expect("a ball"));
            let ends = Ends::new(first, second).expect("bounded");
            Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved")
        };
        let nearly = line(0.5_f64.powi(51));
        assert_eq!((nearly.minimum().stop, nearly.common_point()), (Stop::EndsTouch, None));
        let exact = 2.0 * (2.0_f64.sqrt() * 6.0 * f64::EPSILON) * 4.0;
        for (error, exact) in
            [(nearly.length().error, exact), (nearly.energy().error, exact * exact)]
        {
            // The ends are at 1 up to rounding.
            assert!(error >= exact * (1.0 - 1e-12) && error < 2.0 * exact, "{error:e} {exact:e}");
        }
        // A proved common point leaves nothing open.
        let touching = line(0.0);
        assert!(touching.common_point().is_some());
        assert_eq!([touching.length().error, touching.energy().error], [0.0, 0.0]);
    }

    #[test]
    fn a_search_that_failed_leads_to_no_estimate() {
        let ends = || Ends::points([-2.0, 0.1], [2.0, 0.0]).expect("finite");
        let wide = || Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends());
        let no_steps = Options { iterations: 0, ..Options::default() };
        let line = wide().solve_with(Rule::TRAPEZOIDAL, 63, &no_steps).expect("a line");
        assert!(line.minimum().levels.len() > 1 && line.minimum().stop == Stop::IterationLimit);
        assert_eq!(line.distance_squared_estimate(), None);
    }

    /// A thin wall under half of the chords: the grids agree on more than the length of the curve.
    #[test]
    fn an_estimate_beyond_the_length_is_wrong_by_the_difference() {
        let ends = Ends::points([-2.0031], [1.9969]).expect("finite");
        let wall = Bump::new(5.0, 0.007).expect("a bump");
        let line = Problem::new(wall, ends).solve(Rule::TRAPEZOIDAL, 512).expect("solved");
        let estimate = line.distance_squared_estimate().expect("several grids");
        let above = estimate.value - line.length().value.powi(2);
        assert!(above > 1e-2 && estimate.error >= 0.99 * above, "{estimate:?} {above}");
    }

    /// The only node of the left-endpoint rule is the top of the hill, so that the discrete energy
    /// is far above that of the curve.
    #[test]
    fn a_bump_under_the_only_node_is_not_resolved() {
        let ends = Ends::points([0.0, 0.0], [4.0, 0.0]).expect("finite");
        let bump = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
        let line = bump.solve(Rule::LEFT_ENDPOINT, 1).expect("solved");
        assert!(line.discrete_energy() > 1.5 * line.energy().value && !line.is_resolved());
    }
}
