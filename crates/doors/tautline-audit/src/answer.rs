//! `Audit`: what an audit found.

use schemars::JsonSchema;
use serde::Serialize;
use tautline_problem::UsedConstants;

/// What an audit of a metric found.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Audit {
    /// The verdict in one word.
    pub verdict: Verdict,
    /// False claims, each with the point that refutes it; the worst that was found of each.
    pub lies: Vec<Lie>,
    /// The number of coordinates.
    pub dimension: usize,
    /// The box in which samples are drawn.
    pub region: Place,
    /// The number of random samples for each law.
    pub cases: u32,
    /// The seed of the samples.
    pub seed: u64,
    /// The constants that the laws use; absent if none are known.
    pub constants: Option<UsedConstants>,
    /// Why there are no constants.
    pub no_constants: Option<String>,
    /// The extreme values that samples and ascents found, if no constants are claimed.
    pub measured: Vec<Measured>,
    /// What is proved of each constant.
    pub proved: Vec<Standing>,
    /// All laws of the kit, in its order.
    pub laws: Vec<Law>,
}

impl Audit {
    /// Returns the number of laws with this result.
    #[must_use]
    pub fn count(&self, status: Status) -> usize {
        self.laws.iter().filter(|law| law.status == status).count()
    }
}

/// A verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// All laws hold.
    Holds,
    /// A claim is false, or the formula is not a metric.
    Lies,
    /// A law fails, although no claim is known to be false.
    Fails,
    /// No law fails, but some are not tried.
    Incomplete,
}

/// A box of space.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct Place {
    /// Its lower corner.
    pub lower: Vec<f64>,
    /// Its upper corner.
    pub upper: Vec<f64>,
    /// Why it is this box.
    pub why: String,
}

/// A false claim, with the place that refutes it.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Lie {
    /// What the claim is about: `c1`, `c2`, `L_H`, `M_H`, or `H` if it is not a metric.
    pub about: &'static str,
    /// What is claimed, such as `L_H = 4`, or that `H` is positive definite.
    pub claim: String,
    /// The number that is claimed; absent if the claim is not about a constant.
    pub claimed: Option<f64>,
    /// The number that was found; absent if it is not finite.
    pub found: Option<f64>,
    /// What was found, as a formula in the point `x`, the direction `w` and the other point `y`.
    pub formula: String,
    /// The point `x`; absent if only bounds over the region refute the claim.
    pub point: Option<Vec<f64>>,
    /// The direction `w`, of length 1.
    pub direction: Option<Vec<f64>>,
    /// The other point `y` of a difference.
    pub other: Option<Vec<f64>>,
}

/// An extreme value that was found.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Measured {
    /// The constant that it would be.
    pub constant: &'static str,
    /// The value. A constant is at least as far out.
    pub value: f64,
    /// The point where it was found.
    pub point: Vec<f64>,
    /// The direction, of length 1.
    pub direction: Vec<f64>,
}

/// What is proved of a constant.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Standing {
    /// The constant.
    pub constant: &'static str,
    /// What is proved, in words.
    pub proof: String,
    /// Where.
    pub within: String,
}

/// The result of one law.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Law {
    /// Its name.
    pub law: &'static str,
    /// What it says.
    pub says: &'static str,
    /// Its result.
    pub status: Status,
    /// The number of cases that were checked.
    pub cases: u64,
    /// The number of these cases that could have violated the law.
    pub could_fail: u64,
    /// The smallest `bound / observed`; absent if nothing came near the bound.
    pub overestimation: Option<f64>,
    /// Hypotheses that were assumed without a check.
    pub assumed: Vec<&'static str>,
    /// Why it fails, is not tried or does not apply; or a remark.
    pub reason: Option<String>,
    /// The smallest random sample that was found to violate the law.
    pub sample: Option<String>,
}

/// The result of a law.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// It held in every case.
    Holds,
    /// It does not hold.
    Fails,
    /// It does not apply, since a claim that it rests on is false.
    FalseHypothesis,
    /// It is about something that this metric does not claim.
    DoesNotApply,
    /// It was not tried.
    NotTried,
}
