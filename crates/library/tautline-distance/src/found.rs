//! `Wanted`, the request to a search for a certificate, and `Found`, its result.

use tautline_check::{Certificate, Proved};

/// What is wanted of a certificate.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct Wanted {
    /// The largest gap `(upper − lower)/upper`, between 0 and 1.
    pub gap: f64,
    /// The most cubes of all levels together. Each takes some 140 bytes of the certificate in the plane,
    /// and some 440 in space.
    pub cubes: usize,
}

impl Wanted {
    /// Asks for this gap, with at most two million cubes.
    #[must_use]
    pub fn gap(gap: f64) -> Self {
        Self { gap, cubes: 2_000_000 }
    }
}

/// A certificate, and what it proves.
#[derive(Clone, Debug)]
pub struct Found<const D: usize> {
    /// The certificate.
    pub certificate: Certificate<D>,
    /// What it proves. The corridor may be a little wider than the one that the checker finds.
    pub proved: Proved<D>,
    /// Why the search ended.
    pub ended: Ended,
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Ended {
    /// The gap is as small as wanted.
    Reached,
    /// Smaller cubes no longer made the gap smaller. Either there is a shorter curve, or there are
    /// other curves that are nearly as short, or an end is conjugate to the other.
    Stalled,
    /// The next level would have had too many cubes.
    TooManyCubes,
    /// The next level would have had cubes too small for their distance from the origin, or smaller than
    /// those of any certificate.
    TooFar,
    /// With the next level, the check would cost more work than a certificate of this size may.
    TooMuchWork,
    /// The observer stopped it.
    Stopped,
}

/// What a search has done so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The number of levels.
    pub levels: usize,
    /// The number of cubes of all levels.
    pub cubes: usize,
    /// The lower bound so far, in `m`.
    pub lower: f64,
    /// The length of the curve, in `m`.
    pub upper: f64,
}
