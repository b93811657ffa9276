//! Certificates of the distance: the length of a line, and a bound below it that anybody can check.

use std::{ops::ControlFlow, sync::Arc};

use nalgebra::SVector;
use tautline_bounds::{Enclosure, FromBelow};
use tautline_check::{CheckError, length_above};
use tautline_discretizations::Rule;
use tautline_distance::{DistanceError, Found, Progress, Wanted, search};
use tautline_formula::{Formula, RecordError};
use tautline_metrics::Metric;
use tautline_optimizers::{Options, SolveError, Starts, Stop, Workspace, minimise_any};
use tautline_sets::Shape;

use crate::TautLine;

/// Why a line has no certificate.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum CertificateError {
    /// The wanted gap is not between 0 and 1.
    #[error("a gap of {gap:e}, which is not between 0 and 1")]
    Gap {
        /// The gap.
        gap: f64,
    },
    /// The sets have a [proved common point](TautLine::common_point).
    #[error("the sets touch: the distance is 0, and has no certificate")]
    Touching,
    /// The sets touch up to rounding, but no common point is proved, and the cubes of a certificate
    /// would be too small.
    #[error(
        "the sets touch up to rounding: the distance is at most {upper:e}, and may be any smaller number"
    )]
    NearlyTouching {
        /// The proved length of a curve between the sets, in `m`.
        upper: f64,
    },
    /// The formula of the metric cannot be written into a certificate.
    #[error(transparent)]
    NotRecorded(#[from] RecordError),
    /// A set cannot be written into a certificate.
    #[error("the {end} set is no point, ball, box, half-space or union of these")]
    NoShape {
        /// Which set: `first` or `second`.
        end: &'static str,
    },
    /// The line could not be refined.
    #[error(transparent)]
    Solve(#[from] SolveError),
    /// Nothing could be proved.
    #[error(transparent)]
    Distance(#[from] DistanceError),
}

/// The part of the gap that the polygon may take: a polygon is longer than the geodesic.
const OF_THE_POLYGON: f64 = 0.02;

/// The most chords of a polygon in a certificate.
const MOST_CHORDS: usize = 1 << 17;

/// Other minima that are longer than the line by a larger factor are of no use.
const NEARLY: f64 = 1.1;

/// The smallest and the largest gap that a [proof](TautLine::prove) looks for on a line or in the
/// plane.
const GAPS_IN_THE_PLANE: [f64; 2] = [1e-4, 1e-3];

/// The gap that a proof looks for in more dimensions, where a small one costs more.
const GAP_IN_SPACE: f64 = 1e-2;

/// The most cubes in a certificate that a proof looks for: two seconds in the plane.
const MOST_CUBES: usize = 60_000;

impl<M: Metric<D>, const D: usize> TautLine<M, D> {
    /// Searches for a certificate of the distance `d`, in `m`, with a gap of at most `gap` between its
    /// two bounds, relative to the upper one. That is the proved length of this line, or of a shorter
    /// one of its [other minima](TautLine::other_minima), refined if it has too few chords. No curve
    /// between the sets is shorter than the lower one: nothing is assumed about global minima.
    ///
    /// ```
    /// use tautline::{Ends, Formula, Problem, Rule};
    ///
    /// // A hill at the origin, with a way around it on either side.
    /// let hill = Formula::<2>::parse("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", &[])?;
    /// let ends = Ends::points([-1.5, 0.05], [1.5, -0.1])?;
    /// let line = Problem::new(hill, ends).solve(Rule::TRAPEZOIDAL, 256)?;
    /// let found = line.certificate(1e-2)?;
    /// // Anybody can check it, for example from a file.
    /// let proved = found.certificate.check()?;
    /// assert!(proved.lower > 4.62 && proved.upper.is_some_and(|upper| upper < 4.676));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// A search that cannot make the gap small enough returns what it has:
    /// [`Found::ended`](tautline_distance::Found::ended) tells why.
    ///
    /// Needs: 1 to 4 dimensions; points, balls, boxes, half-spaces or unions of these.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    pub fn certificate(&self, gap: f64) -> Result<Found<D>, CertificateError> {
        self.certificate_with(Wanted::gap(gap), &mut |_| ControlFlow::Continue(()))
    }

    /// Does the same as [`certificate`](TautLine::certificate), with a limit on the number of cubes.
    /// `observe` is told about every level, and may stop the search.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    pub fn certificate_with(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Found<D>, CertificateError> {
        if !(wanted.gap > 0.0 && wanted.gap < 1.0) {
            return Err(CertificateError::Gap { gap: wanted.gap });
        }
        if self.common_point().is_some() {
            return Err(CertificateError::Touching);
        }
        // The compiler decides.
        if const { D == 0 || D > tautline_check::LARGEST_DIMENSION } {
            let dimension = CheckError::Dimension { dimension: D };
            return Err(DistanceError::Refused(dimension).into());
        }
        let formula = match self.formula() {
            Some(formula) => formula.clone(),
            None => Formula::record(self.metric())?,
        };
        formula.symmetric()?;
        let shape = |end, set: &Arc<dyn tautline_sets::ClosedSet<D>>| {
            let shape = set.shape().and_then(tautline_sets::Shape::into_elementary);
            shape.ok_or(CertificateError::NoShape { end })
        };
        let sets = [shape("first", self.ends().first())?, shape("second", self.ends().second())?];
        if self.minimum().stop == Stop::EndsTouch {
            let (curve, upper) = self.between_members(&formula, &sets)?;
            // A chord without length is a common point.
            if upper == 0.0 {
                return Err(CertificateError::Touching);
            }
            // Under a metric with a large scale there may be cubes that are small enough.
            let found = search(&formula, &sets, &[curve], wanted, observe);
            return found.map_err(|_| CertificateError::NearlyTouching { upper });
        }
        let length = self.length().value;
        let mut curves: Vec<(f64, Vec<SVector<f64, D>>)> =
            vec![(length, self.refined(wanted.gap)?)];
        for other in self.other_minima() {
            let length = other.length().value;
            if length < NEARLY * self.length().value {
                let place = curves.partition_point(|(shorter, _)| *shorter <= length);
                curves.insert(place, (length, other.refined(wanted.gap)?));
            }
        }
        let curves: Vec<_> = curves.into_iter().map(|(_, curve)| curve).collect();
        Ok(search(&formula, &sets, &curves, wanted, observe)?)
    }

    /// Returns a chord from a member of the first set to one of the second next to the ends of this line,
    /// and its proved length.
    fn between_members(
        &self,
        formula: &Formula<D>,
        [first, second]: &[Shape<D>; 2],
    ) -> Result<(Vec<SVector<f64, D>>, f64), CertificateError> {
        let ends = [self.sequence().first(), self.sequence().last()];
        let pairs = ends.into_iter().flat_map(|x| {
            let (a, b) = (first.proved_member(x), second.proved_member(x));
            let there = a.and_then(|a| Some([a, second.proved_member(&a)?]));
            let back = b.and_then(|b| Some([first.proved_member(&b)?, b]));
            [there, back, a.zip(b).map(|(a, b)| [a, b])]
        });
        let (mut curves, mut reason) = (Vec::new(), CheckError::CurveEnd { end: "first" });
        for pair in pairs.flatten() {
            match length_above(formula, [first, second], &pair) {
                Ok(length) => curves.push((pair.to_vec(), length)),
                Err(error) => reason = error,
            }
        }
        // An infinite length is no bound.
        let finite = curves.into_iter().filter(|(_, length)| length.is_finite());
        let shortest = finite.min_by(|(_, a), (_, b)| a.total_cmp(b));
        shortest.ok_or_else(|| DistanceError::Curve(reason).into())
    }

    /// Searches for a certificate that proves about as much as this enclosure does under the
    /// assumption of a global minimum. The result is `None` if nothing is assumed and the enclosure is
    /// narrow or its lower bound more than that of Euclid, or if there is no certificate.
    pub(crate) fn instead_of_an_assumption(
        &self,
        enclosure: &Enclosure,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Option<Found<D>> {
        let gap = 1.0 - (enclosure.lower / enclosure.upper).sqrt();
        let is_trivial = matches!(enclosure.from_below, FromBelow::Nothing | FromBelow::Euclidean);
        if !(enclosure.assumes_global_minimum || is_trivial && gap > GAP_IN_SPACE) {
            return None;
        }
        let [least, most] = GAPS_IN_THE_PLANE;
        let gap = if D <= 2 { gap.clamp(least, most) } else { GAP_IN_SPACE };
        self.certificate_with(Wanted { gap, cubes: MOST_CUBES }, observe).ok()
    }

    /// Returns the points of this line, or of a finer one from the same start, if this one is too long
    /// for the gap.
    fn refined(&self, gap: f64) -> Result<Vec<SVector<f64, D>>, SolveError> {
        let n = self.sequence().n().get();
        let square = self.length().value.powi(2);
        if !(square > 0.0) {
            return Ok(self.sequence().points().to_vec());
        }
        // The excess of a polygon falls like N⁻². Without an estimate it is about N⁻².
        let excess = match self.distance_squared_estimate() {
            Some(estimate) => ((square - estimate.value).abs() + estimate.error) / square,
            None => 1.0 / (n as f64).powi(2),
        };
        let factor = (0.5 * excess / (OF_THE_POLYGON * gap)).sqrt();
        let finer = (n as f64 * factor).ceil().min(MOST_CHORDS as f64) as usize;
        if finer <= n {
            return Ok(self.sequence().points().to_vec());
        }
        let starts = Starts::Only(vec![self.sequence().clone()]);
        let options = Options { starts, ..Options::default() };
        let mut workspace = Workspace::default();
        let (metric, ends) = (&**self.prepared(), self.any_ends());
        let found =
            minimise_any(&mut workspace, metric, ends, Rule::TRAPEZOIDAL, finer, &options, None)?;
        Ok(found.sequence.points().to_vec())
    }
}
