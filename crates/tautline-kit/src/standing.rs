//! `Standing` and `Proof`: what bounds over the whole region prove of a claimed constant.

use std::fmt;

use super::Claim;

/// What is proved of one claimed constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The constant.
    pub claim: Claim,
    /// What is proved of it.
    pub proof: Proof,
}

/// How far a claim is proved over the whole region, with outward rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proof {
    /// It holds at every point of the region.
    Proved,
    /// It lies between the two bounds of the exact constant, which are this many percent apart.
    /// Nothing more can be proved of a claim that is attained.
    RightTo {
        /// The distance of the bounds, in percent.
        percent: f64,
    },
    /// The boxes did not suffice; the claim may be wrong.
    NotDecided,
    /// Not attempted: the dimension is above three, or the formula cannot be recorded.
    NotTried,
}

impl Proof {
    /// Returns whether the claim is proved to hold, or to be off by no more than a known amount.
    #[must_use]
    pub fn is_decided(self) -> bool {
        matches!(self, Proof::Proved | Proof::RightTo { .. })
    }
}

impl fmt::Display for Proof {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Proof::Proved => f.write_str("proved"),
            Proof::RightTo { percent } => write!(f, "right to {percent:.1} %"),
            Proof::NotDecided => f.write_str("not decided"),
            Proof::NotTried => f.write_str("not tried"),
        }
    }
}

impl fmt::Display for Standing {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} {}", self.claim, self.proof)
    }
}
