//! `Doubt`: a reason why a line may not be a shortest one, or its numbers not what they seem.

use core::fmt;

use tautline_formula::Prepare;
use tautline_scalar::decimal::nearest;

use crate::TautLine;

/// A reason why a line may not be a shortest one, or its numbers not what they seem; in words by `Display`.
///
/// Files, the command, Python and the interactive page show every doubt of an answer.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Doubt {
    /// The chords do not [resolve](TautLine::is_resolved) the metric.
    NotResolved {
        /// The root of the discrete energy, which is the length that the rule sees, in `m`.
        seen: f64,
        /// The number of chords.
        chords: usize,
    },
    /// Another local minimum is [shorter](TautLine::shorter_minimum).
    Shorter {
        /// Its length, in `m`.
        length: f64,
    },
    /// The search did not end at a strict local minimum.
    NotConverged,
    /// The relative error of the length exceeds the tolerance that was asked for, by extrapolation.
    Tolerance {
        /// The number of chords.
        chords: usize,
    },
    /// The metric [jumps](TautLine::jump), which a search by derivatives does not see.
    Jump {
        /// A point at which it jumps, in `ℓ`.
        at: Vec<f64>,
    },
    /// The curve is proved to be longer than its quadrature says, which has missed a part of the metric.
    Longer {
        /// The proved upper bound on its length, in `m`.
        upper: f64,
    },
}

impl Doubt {
    /// The key of each kind of doubt.
    pub const KEYS: [&str; 6] =
        ["not_resolved", "shorter_minimum", "not_converged", "tolerance", "jump", "longer"];

    /// Returns the key of the doubt, the same for all numbers.
    #[must_use]
    pub fn key(&self) -> &'static str {
        let kind = match self {
            Self::NotResolved { .. } => 0,
            Self::Shorter { .. } => 1,
            Self::NotConverged => 2,
            Self::Tolerance { .. } => 3,
            Self::Jump { .. } => 4,
            Self::Longer { .. } => 5,
        };
        Self::KEYS[kind]
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotResolved { seen, chords } => write!(
                f,
                "the metric changes between the points of the rule, which sees a length of {} with \
                 {}",
                nearest(*seen),
                Chords(*chords)
            ),
            Self::Shorter { length } => write!(
                f,
                "another minimum is shorter, {}, but has more energy by the rule",
                nearest(*length)
            ),
            Self::NotConverged => write!(f, "the search did not end at a strict minimum"),
            Self::Tolerance { chords } => {
                write!(f, "the tolerance is not reached with {}", Chords(*chords))
            }
            Self::Jump { at } => {
                let at: Vec<String> = at.iter().map(|x| nearest(*x)).collect();
                write!(
                    f,
                    "the metric jumps at [{}], which a search by derivatives does not see",
                    at.join(", ")
                )
            }
            Self::Longer { upper } => write!(
                f,
                "the metric changes between the points of the quadrature: the length may be up to {}",
                nearest(*upper)
            ),
        }
    }
}

/// A number of chords, in words.
struct Chords(usize);

impl fmt::Display for Chords {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} chord{}", self.0, if self.0 == 1 { "" } else { "s" })
    }
}

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns why this line may not be a shortest one, as far as is known. Empty if no reason is.
    ///
    /// ```
    /// use tautline::{Ends, Problem, Rule, gallery::Bump};
    ///
    /// let ends = Ends::points([-2.0, 0.1], [2.0, 0.0])?;
    /// let problem = Problem::new(Bump::new(40.0, 0.05)?, ends);
    /// let [doubt] = &problem.solve(Rule::TRAPEZOIDAL, 4)?.doubts()[..] else { panic!("too few chords") };
    /// assert_eq!(doubt.key(), "not_resolved");
    /// assert!(problem.solve(Rule::TRAPEZOIDAL, 256)?.doubts().is_empty());
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    #[must_use]
    pub fn doubts(&self) -> Vec<Doubt> {
        let mut doubts = self.own_doubts();
        let shorter = self.shorter_minimum();
        doubts.extend(shorter.map(|other| Doubt::Shorter { length: other.length().value }));
        doubts
    }

    /// Returns the [doubts](TautLine::doubts) that do not come from other minima.
    #[must_use]
    pub fn own_doubts(&self) -> Vec<Doubt> {
        let mut doubts = Vec::new();
        if !self.is_resolved() {
            let seen = self.discrete_energy().sqrt();
            doubts.push(Doubt::NotResolved { seen, chords: self.sequence().n().get() });
        }
        if !self.minimum().is_local_minimum() {
            doubts.push(Doubt::NotConverged);
        }
        doubts.extend(self.jump().map(|at| Doubt::Jump { at }));
        doubts
    }
}
