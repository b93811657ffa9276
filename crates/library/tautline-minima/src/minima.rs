//! `Minima`: what a search found, and which of it is proved to be the shortest.

use nalgebra::SVector;
use tautline::{
    CertificateError, GraphPathError, Integral, Metric, Punctures, SolveError, TautLine, Word,
    distance::{Found, Wanted},
    grid::EikonalError,
};

/// The local minima that a search found, each along another curve.
#[derive(Clone, Debug)]
pub struct Minima<M: Metric<D>, const D: usize> {
    pub(crate) minima: Vec<LocalMinimum<M, D>>,
    pub(crate) punctures: Punctures,
    pub(crate) starts: usize,
    pub(crate) refused: Vec<Refused>,
}

/// A local minimum.
#[derive(Clone, Debug)]
pub struct LocalMinimum<M: Metric<D>, const D: usize> {
    /// The line. Its [minimum](TautLine::minimum) has the energy and the curvature: positive definite, or
    /// degenerate.
    pub line: TautLine<M, D>,
    /// On which sides it passes the punctures.
    pub word: Word,
    /// The first start that led to it.
    pub origin: Origin<D>,
    /// How many starts led to it.
    pub hits: usize,
}

/// Where a start came from.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Origin<const D: usize> {
    /// The straight line, lines that are bent, or nearest points of the sets.
    Automatic,
    /// The shortest lattice path with this word. The minimum may have another one.
    Class(Word),
    /// A curve through this pass between two distance fields, in `ℓ`.
    Pass(SVector<f64, D>),
    /// Continuation from a flat metric, since this share of the metric.
    Continuation {
        /// The share.
        since: f64,
    },
}

/// What a search could not do, and why.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Refused {
    /// There are no lattice paths.
    #[error("no homotopy classes: {0}")]
    Classes(#[source] GraphPathError),
    /// There are no distance fields.
    #[error("no passes between distance fields: {0}")]
    Passes(#[source] EikonalError),
    /// Nothing could be followed from a flat metric.
    #[error("no continuation: {0}")]
    Continuation(#[source] SolveError),
}

/// How a local minimum stands to a proved enclosure of the distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Standing {
    /// No curve is shorter than it by more than this part of its length, up to the error of its length, which
    /// is estimated. Several minima may stand so.
    Shortest {
        /// `(length + error − lower)/(length + error)`, a pure number.
        gap: f64,
    },
    /// It is longer than a curve whose length is proved, by at least this part of the length of that, up
    /// to the error of its own length, which is estimated.
    Longer {
        /// `(length − error − upper)/upper`, a pure number.
        by: f64,
    },
}

impl Standing {
    /// Returns how a length stands to a proved enclosure of the distance.
    fn new(length: Integral, [lower, upper]: [f64; 2]) -> Self {
        let by = (length.value - length.error - upper) / upper;
        if by > 0.0 {
            return Standing::Longer { by };
        }
        let longest = length.value + length.error;
        Standing::Shortest { gap: ((longest - lower) / longest).max(0.0) }
    }
}

/// Local minima beside a certificate of the distance.
#[derive(Clone, Debug)]
pub struct Ranked<const D: usize> {
    /// The certificate, and the enclosure of the distance that it proves.
    pub found: Found<D>,
    /// How each minimum stands to it, in their order.
    pub standings: Vec<Standing>,
}

impl<M: Metric<D>, const D: usize> Minima<M, D> {
    /// Returns the minima, lowest energy first. There is at least one.
    #[must_use]
    pub fn minima(&self) -> &[LocalMinimum<M, D>] {
        &self.minima
    }

    /// Returns the lowest of the minima.
    #[must_use]
    pub fn lowest(&self) -> &TautLine<M, D> {
        &self.minima[0].line
    }

    /// Returns the punctures that the words of the minima are about.
    #[must_use]
    pub fn punctures(&self) -> &Punctures {
        &self.punctures
    }

    /// Returns the number of starts.
    #[must_use]
    pub fn starts(&self) -> usize {
        self.starts
    }

    /// Returns what could not be done, and why.
    #[must_use]
    pub fn refused(&self) -> &[Refused] {
        &self.refused
    }

    /// Searches for a [certificate](TautLine::certificate) of the distance, and tells how each minimum
    /// stands to it. If all but one are longer, that one is the shortest of all curves up to its gap,
    /// whatever the search may have missed.
    ///
    /// # Errors
    ///
    /// Those of [`TautLine::certificate_with`].
    pub fn ranked(&self, wanted: Wanted) -> Result<Ranked<D>, CertificateError> {
        let go_on = &mut |_| std::ops::ControlFlow::Continue(());
        let found = self.lowest().certificate_with(wanted, go_on)?;
        let (lower, upper) = (found.proved.lower, found.proved.upper.unwrap_or(f64::INFINITY));
        let standing =
            |minimum: &LocalMinimum<M, D>| Standing::new(minimum.line.length(), [lower, upper]);
        let standings = self.minima.iter().map(standing).collect();
        Ok(Ranked { found, standings })
    }
}

#[cfg(test)]
mod tests {
    use tautline::Integral;

    use super::Standing::{self, Longer, Shortest};

    /// Its error counts against a length on both sides. All numbers are exact in binary.
    #[test]
    fn a_length_stands_where_its_error_allows() {
        let of = |value, error| Standing::new(Integral { value, error }, [3.0, 4.0]);
        assert_eq!(of(6.0, 0.0), Longer { by: 0.5 });
        assert_eq!(of(6.0, 1.0), Longer { by: 0.25 });
        assert_eq!(of(6.0, 2.0), Shortest { gap: 0.625 });
        assert_eq!(of(4.0, 0.0), Shortest { gap: 0.25 });
        // Below what is proved there is no curve: the length is too short by more than its error.
        assert_eq!(of(2.0, 0.5), Shortest { gap: 0.0 });
        let unproved = Standing::new(Integral { value: 4.0, error: 0.0 }, [3.0, f64::INFINITY]);
        assert_eq!(unproved, Shortest { gap: 0.25 });
    }
}
