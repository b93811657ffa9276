//! `Standing` and `Proof`: what bounds over the whole region prove about a claimed constant.

use std::fmt;

use super::Claim;

/// What is proved about one claimed constant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Standing {
    /// The constant.
    pub claim: Claim,
    /// What is proved about the constant.
    pub proof: Proof,
}

/// The result of the attempt to prove a claim over the whole region, with outward rounding.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Proof {
    /// The claim holds at every point of the region.
    Proved,
    /// The claim lies between the two bounds on the exact constant, which differ by this many
    /// percent. Nothing more can be proved about a claim that is attained.
    RightTo {
        /// The difference between the bounds, in percent.
        percent: f64,
    },
    /// The number of boxes did not suffice to decide; the claim may be wrong.
    NotDecided,
    /// No proof was attempted: the dimension is above three, or the formula cannot be recorded.
    NotTried,
}

impl Proof {
    /// Returns whether the claim is proved to hold, or proved to be off by at most a known amount.
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
