//! Certificates of the distance: the length of a line, and a bound below it that anybody can check.

use std::{ops::ControlFlow, sync::Arc};

use tautline_bounds::{Enclosure, FromBelow};
use tautline_check::{CheckError, LARGEST_DIMENSION};
use tautline_discretizations::Rule;
use tautline_distance::{
    AnyFound, DistanceError, Found, Progress, Wanted, search_any, shortest_chord,
};
use tautline_formula::{Prepare, RecordError};
use tautline_metrics::Metric;
use tautline_optimizers::{Options, SolveError, Starts, Stop, Workspace, minimise_any};
use tautline_sets::{AnySet, Shape};

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
        let found = self.any_certificate(wanted, observe)?;
        Ok(found
            .into_dimension()
            .ok_or(DistanceError::Refused(CheckError::Dimension { dimension: D }))?)
    }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Does the same as [`certificate_with`](TautLine::certificate_with). The certificate lies in a
    /// dimension that is a value.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    pub fn any_certificate(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<AnyFound, CertificateError> {
        if !(wanted.gap > 0.0 && wanted.gap < 1.0) {
            return Err(CertificateError::Gap { gap: wanted.gap });
        }
        if self.proved_contact().is_some() {
            return Err(CertificateError::Touching);
        }
        let dimension = self.any_ends().dimension();
        if dimension > LARGEST_DIMENSION {
            return Err(DistanceError::Refused(CheckError::Dimension { dimension }).into());
        }
        let formula = self.recorded()?.clone().into_any();
        formula.symmetric()?;
        let shape = |end, set: &Arc<dyn AnySet>| {
            let shape = set.shape().and_then(Shape::into_elementary);
            shape.ok_or(CertificateError::NoShape { end })
        };
        let ends = self.any_ends();
        let sets = [shape("first", ends.first())?, shape("second", ends.second())?];
        if self.minimum().stop == Stop::EndsTouch {
            let (chord, upper) = shortest_chord(&formula, &sets, self.end_points())?;
            // A chord without length is a common point.
            if upper == 0.0 {
                return Err(CertificateError::Touching);
            }
            // Under a metric with a large scale there may be cubes that are small enough.
            let found = search_any(&formula, &sets, &[chord], wanted, observe);
            return found.map_err(|_| CertificateError::NearlyTouching { upper });
        }
        let length = self.length().value;
        let mut curves: Vec<(f64, Vec<f64>)> = vec![(length, self.refined(wanted.gap)?)];
        for other in self.other_minima() {
            let length = other.length().value;
            if length < NEARLY * self.length().value {
                let place = curves.partition_point(|(shorter, _)| *shorter <= length);
                curves.insert(place, (length, other.refined(wanted.gap)?));
            }
        }
        let curves: Vec<_> = curves.into_iter().map(|(_, curve)| curve).collect();
        Ok(search_any(&formula, &sets, &curves, wanted, observe)?)
    }

    /// Searches for a certificate that proves about as much as this enclosure does under the
    /// assumption of a global minimum. The result is `None` if nothing is assumed and the enclosure is
    /// narrow or its lower bound more than that of Euclid, or if there is no certificate.
    pub(crate) fn instead_of_an_assumption(
        &self,
        enclosure: &Enclosure,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Option<AnyFound> {
        let gap = 1.0 - (enclosure.lower / enclosure.upper).sqrt();
        let is_trivial = matches!(enclosure.from_below, FromBelow::Nothing | FromBelow::Euclidean);
        if !(enclosure.assumes_global_minimum || is_trivial && gap > GAP_IN_SPACE) {
            return None;
        }
        self.quick_certificate(gap, observe).ok()
    }

    /// Searches for a certificate for some seconds: with a gap of `gap`, but at least 10⁻⁴ and at most 10⁻³,
    /// on a line or in the plane, and of 10⁻² in more dimensions. A [proof](TautLine::prove) does so where
    /// the theorems would assume something.
    ///
    /// # Errors
    ///
    /// As for [`any_certificate`](TautLine::any_certificate).
    pub fn quick_certificate(
        &self,
        gap: f64,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<AnyFound, CertificateError> {
        let [least, most] = GAPS_IN_THE_PLANE;
        let is_flat = self.any_ends().dimension() <= 2;
        let gap = if is_flat { gap.clamp(least, most) } else { GAP_IN_SPACE };
        self.any_certificate(Wanted { gap, cubes: MOST_CUBES }, observe)
    }

    /// Returns the coordinates of the points of this line, or of a finer one from the same start, if this one
    /// is too long for the gap.
    fn refined(&self, gap: f64) -> Result<Vec<f64>, SolveError> {
        let n = self.sequence().n().get();
        let square = self.length().value.powi(2);
        if !(square > 0.0) {
            return Ok(self.sequence().coordinates().to_vec());
        }
        // The excess of a polygon falls like N⁻². Without an estimate it is about N⁻².
        let excess = match self.distance_squared_estimate() {
            Some(estimate) => ((square - estimate.value).abs() + estimate.error) / square,
            None => 1.0 / (n as f64).powi(2),
        };
        let factor = (0.5 * excess / (OF_THE_POLYGON * gap)).sqrt();
        let finer = (n as f64 * factor).ceil().min(MOST_CHORDS as f64) as usize;
        if finer <= n {
            return Ok(self.sequence().coordinates().to_vec());
        }
        let starts = Starts::Only(vec![self.sequence().clone()]);
        let options = Options { starts, ..Options::default() };
        let mut workspace = Workspace::default();
        let (metric, ends) = (&**self.prepared(), self.any_ends());
        let found =
            minimise_any(&mut workspace, metric, ends, Rule::TRAPEZOIDAL, finer, &options, None)?;
        Ok(found.sequence.coordinates().to_vec())
    }
}
