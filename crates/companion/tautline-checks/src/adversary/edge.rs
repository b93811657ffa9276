//! `Edge`: an end of a range at which a search stopped, and what lies beyond it.

use std::fmt;

/// An end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// The lower end.
    Least = 0,
    /// The upper end.
    Most = 1,
}

/// What lies beyond an end of a range.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// There is no case beyond the end, for this reason.
    Nothing(&'static str),
    /// A limit lies beyond, such as `a → 0`. The range ends where hardly anything is left to gain.
    Limit(&'static str),
}

/// A parameter at an end of its range in the tightest case found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Edge {
    /// The name of the parameter.
    pub parameter: &'static str,
    /// Which end it is.
    pub end: End,
    /// What lies beyond the end, if declared.
    pub beyond: Option<Beyond>,
    /// The relative growth of the overestimation if this parameter moves twice as far from the
    /// limit.
    ///
    /// If the overestimation `s` tends to its limit at least linearly, this growth bounds what is
    /// left beyond the edge: `s(a) − s(0) ≤ (s(2a) − s(0))/2` implies `s(a) − s(0) ≤ s(2a) − s(a)`.
    pub left: f64,
}

impl Edge {
    /// The largest fraction of an overestimation that may be left beyond an edge. It is the
    /// tolerance to which overestimations are compared; if more is left, the range is too short.
    pub const LEFT: f64 = 1e-2;

    /// Returns whether the range cuts the search off: either what lies beyond is not declared, or
    /// more than [`LEFT`](Edge::LEFT) of the overestimation is left on the way to the limit.
    #[must_use]
    pub fn is_cut_off(&self) -> bool {
        match self.beyond {
            Some(Beyond::Nothing(_)) => false,
            Some(Beyond::Limit(_)) => !(self.left <= Self::LEFT),
            None => true,
        }
    }
}

impl fmt::Display for Edge {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.beyond {
            Some(Beyond::Nothing(why)) => write!(f, "{why}"),
            Some(Beyond::Limit(limit)) if !self.is_cut_off() => write!(f, "{limit}"),
            Some(Beyond::Limit(limit)) => {
                write!(f, "cut off on the way to {limit}: {:.1e} left", self.left)
            }
            None => write!(f, "cut off at an end of {}", self.parameter),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Beyond, Edge, End};

    fn edge(beyond: Option<Beyond>, left: f64) -> Edge {
        Edge { parameter: "a", end: End::Least, beyond, left }
    }

    #[test]
    fn an_edge_has_a_reason_or_cuts_the_search_off() {
        let limit = Some(Beyond::Limit("a → 0"));
        for (edge, cut_off, says) in [
            (edge(Some(Beyond::Nothing("N ≥ 1")), 7.0), false, "N ≥ 1"),
            (edge(limit, 9e-3), false, "a → 0"),
            (edge(limit, 2e-2), true, "cut off on the way to a → 0: 2.0e-2 left"),
            (edge(limit, f64::NAN), true, "cut off on the way to a → 0: NaN left"),
            (edge(None, 0.0), true, "cut off at an end of a"),
        ] {
            assert_eq!((edge.is_cut_off(), edge.to_string().as_str()), (cut_off, says));
        }
    }
}
