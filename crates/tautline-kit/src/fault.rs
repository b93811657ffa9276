//! `Fault`: the law that does not hold, with the numbers that show it.

use tautline::{CertifyError, MetricError};
use tautline_statements::{Inequality, Statement, VerifyError};

use super::{Claim, Lie};

/// Why a metric, a set or a rule is rejected.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// `H` is not finite, symmetric and positive definite at a point.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The formula proves that the metric is none: indefinite or undefined somewhere.
    #[error(transparent)]
    Unproved(CertifyError),
    /// A claimed constant does not hold.
    #[error(transparent)]
    Lie(#[from] Lie),
    /// A claimed constant does not hold somewhere in the region: where, the bounds do not say.
    #[error("the metric claims {claim} = {claimed}, but it is proved to be {} {bound}", claim.side())]
    Refuted {
        /// Which constant.
        claim: Claim,
        /// The number that the metric claims.
        claimed: f64,
        /// At most so much `c₁` can be, and at least so much another constant, in its unit.
        bound: f64,
    },
    /// An inequality of a law does not hold at a point.
    #[error(
        "{law}{}: {left:e} is not at most {right:e}, with {granted:e} granted",
        place(point, other.as_deref())
    )]
    Broken {
        /// The law, as a formula.
        law: &'static str,
        /// The left side.
        left: f64,
        /// The right side.
        right: f64,
        /// What is granted to rounding, besides the right side.
        granted: f64,
        /// Where; empty if the law has no point.
        point: Vec<f64>,
        /// The other point of the law, if it has one: a member of a set.
        other: Option<Box<[f64]>>,
    },
    /// The numbers of a statement of the paper violate it, or its hypotheses.
    #[error("{statement}{}: {inequality}", if *.hypothesis { ", a hypothesis" } else { "" })]
    Statement {
        /// The statement.
        statement: Statement,
        /// Whether the inequality is a hypothesis of it: a claim of the metric.
        hypothesis: bool,
        /// The inequality that does not hold.
        inequality: Inequality,
    },
    /// Errors fall more slowly than they should.
    #[error(
        "{what} falls like N⁻ᑫ with q = {found:.3} over N = {window:?}, which should be {least} at least"
    )]
    Order {
        /// The error.
        what: &'static str,
        /// The slope that was observed, of the median of several problems.
        found: f64,
        /// The least slope that is accepted.
        least: f64,
        /// The numbers of subintervals.
        window: Vec<usize>,
    },
    /// Something that has to be refused was not.
    #[error("{what} was not refused")]
    NotRefused {
        /// What, in words.
        what: &'static str,
    },
    /// The solver reached no minimum for most problems, so that nothing was tested.
    #[error("the solver found no local minimum for {failed} of {tried} problems: {error}")]
    NotSolved {
        /// Problems without a result.
        failed: u64,
        /// All problems.
        tried: u64,
        /// Why, for one of them.
        error: VerifyError,
    },
    /// A statement could not be evaluated.
    #[error(transparent)]
    Unevaluated(#[from] VerifyError),
    /// Nothing was solved, since a law of the formula does not hold: the solver would stall.
    #[error("not tried: {law} fails")]
    NotTried {
        /// The name of the law that fails.
        law: &'static str,
    },
    /// No sample could be drawn.
    #[error("no sample could be drawn: {why}")]
    NoSample {
        /// Why.
        why: String,
    },
}

/// Where an inequality does not hold, as a part of its message.
fn place(point: &[f64], other: Option<&[f64]>) -> String {
    match other {
        _ if point.is_empty() => String::new(),
        None => format!(", at x = {point:?}"),
        Some(other) => format!(", at x = {point:?} with the member {other:?}"),
    }
}

impl Fault {
    /// Names the other point of an inequality that does not hold.
    pub(crate) fn with_member(mut self, member: &[f64]) -> Self {
        if let Fault::Broken { other, .. } = &mut self {
            *other = Some(member.into());
        }
        self
    }

    /// Returns whether it is the metric or a claim of it that is wrong, and not what a statement
    /// makes of them: there are laws that look for no more than that.
    pub(crate) fn is_of_the_metric(&self) -> bool {
        matches!(
            self,
            Fault::Metric(_)
                | Fault::Lie(_)
                | Fault::Refuted { .. }
                | Fault::NotTried { .. }
                | Fault::Statement { hypothesis: true, .. }
                | Fault::Unevaluated(VerifyError::Metric(_))
        )
    }

    /// Returns whether a side of an inequality is NaN, which says little.
    pub(crate) fn is_nan(&self) -> bool {
        match self {
            Fault::Broken { left, right, granted, .. } => (left + right + granted).is_nan(),
            Fault::Statement { inequality, .. } => {
                (inequality.observed + inequality.bound + inequality.granted).is_nan()
            }
            _ => false,
        }
    }

    /// Returns `Ok` with the overestimation `right / left` if `left ≤ right + granted`; NaN on
    /// either side is a fault.
    ///
    /// The overestimation is `∞` where `left` is not positive or cannot be told from what is
    /// granted.
    pub(crate) fn unless_at_most(
        law: &'static str,
        [left, right]: [f64; 2],
        granted: f64,
        point: &[f64],
    ) -> Result<f64, Self> {
        if left <= right + granted {
            let seen = left > 0.0 && granted <= 0.01 * left;
            Ok(if seen { right / left } else { f64::INFINITY })
        } else {
            Err(Fault::Broken { law, left, right, granted, point: point.to_vec(), other: None })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Fault;

    #[test]
    fn an_inequality_is_told_with_its_points() {
        let broken = |point: &[f64]| {
            Fault::unless_at_most("a ≤ b", [2.0, 1.0], 0.5, point).expect_err("2 > 1.5")
        };
        let rest = ": 2e0 is not at most 1e0, with 5e-1 granted";
        assert_eq!(broken(&[]).to_string(), format!("a ≤ b{rest}"));
        assert_eq!(broken(&[3.0]).to_string(), format!("a ≤ b, at x = [3.0]{rest}"));
        let with = broken(&[3.0]).with_member(&[4.0]).to_string();
        assert_eq!(with, format!("a ≤ b, at x = [3.0] with the member [4.0]{rest}"));
    }

    /// An error that does not fall at all has a slope of either sign.
    #[test]
    fn an_order_is_told_with_its_sign() {
        let fault = Fault::Order { what: "e", found: -0.002, least: 1.95, window: vec![1, 2] };
        let text =
            "e falls like N⁻ᑫ with q = -0.002 over N = [1, 2], which should be 1.95 at least";
        assert_eq!(fault.to_string(), text);
    }
}
