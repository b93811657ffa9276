//! `Request`: how a problem is to be solved.

use tautline::{Options, PointSequence, Starts};

use super::GivenError;
use crate::{file::request::RuleName, question::CHORDS, reading::shape::vector};

/// How a problem is to be solved.
#[derive(Clone, Debug, PartialEq)]
pub struct Request {
    /// The rule of numerical integration.
    pub rule: RuleName,
    /// The number of chords.
    pub n: usize,
    /// Polygons from which a search starts, in addition to the automatic starts.
    pub starts: Vec<Vec<Vec<f64>>>,
    /// Whether they replace the automatic starts.
    pub only_these_starts: bool,
    /// The largest number of Newton steps of a local search on one grid.
    pub steps: usize,
    /// The number of threads for one problem, 1 or 2.
    pub threads: usize,
}

impl Default for Request {
    /// Returns the trapezoidal rule with 256 chords, automatic starts, and the options of a search.
    fn default() -> Self {
        let Options { iterations, threads, .. } = Options::<1>::default();
        Self {
            rule: RuleName::default(),
            n: CHORDS,
            starts: Vec::new(),
            only_these_starts: false,
            steps: iterations,
            threads,
        }
    }
}

impl Request {
    /// Returns the options of a search in `D` dimensions.
    pub(super) fn options<const D: usize>(&self) -> Result<Options<D>, GivenError> {
        let mut starts = Vec::new();
        for start in &self.starts {
            if let Some(x) = start.iter().find(|x| x.len() != D) {
                let (what, found) = ("a point of a start", x.len());
                return Err(GivenError::Coordinates { what, found, dimension: D });
            }
            starts.push(PointSequence::new(start.iter().map(|x| vector::<D>(x)).collect())?);
        }
        let starts = match (starts.is_empty(), self.only_these_starts) {
            (_, true) => Starts::Only(starts),
            (true, false) => Starts::Automatic,
            (false, false) => Starts::Also(starts),
        };
        Ok(Options { starts, iterations: self.steps, threads: self.threads })
    }
}
