//! `Fault`: a violated law, with the numbers that show the violation.

use tautline::{CertifyError, MetricError};
use tautline_statements::{Inequality, Statement, VerifyError};

use super::{Claim, Lie};

/// The reason why a metric, a set or a rule is rejected.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum Fault {
    /// `H` is not finite, symmetric and positive definite at a point.
    #[error(transparent)]
    Metric(#[from] MetricError),
    /// The formula provably is not a metric: it is indefinite or undefined somewhere.
    #[error(transparent)]
    Unproved(CertifyError),
    /// A claimed constant is wrong at the given point.
    #[error(transparent)]
    Lie(#[from] Lie),
    /// A claimed constant is proved wrong somewhere in the region, but the bounds do not show
    /// where.
    #[error("the metric claims {claim} = {claimed}, but it is proved to be {} {bound}", claim.side())]
    Refuted {
        /// The constant.
        claim: Claim,
        /// The number that the metric claims.
        claimed: f64,
        /// An upper bound on `c₁`, or a lower bound on another constant, in its unit.
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
        /// The allowance for rounding, on top of the right side.
        granted: f64,
        /// The point; empty if the law is not about a point.
        point: Vec<f64>,
        /// The second point of the law, which is a member of a set, if there is one.
        other: Option<Box<[f64]>>,
    },
    /// A statement of the paper, or one of its hypotheses, is violated.
    #[error("{statement}{}: {inequality}", if *.hypothesis { ", a hypothesis" } else { "" })]
    Statement {
        /// The statement.
        statement: Statement,
        /// Whether the inequality is a hypothesis, that is, a claim of the metric.
        hypothesis: bool,
        /// The violated inequality.
        inequality: Inequality,
    },
    /// Errors fall more slowly than they should.
    #[error(
        "{what} falls like N⁻ᑫ with q = {found:.3} over N = {window:?}, but q should be at least {least}"
    )]
    Order {
        /// The error that was fitted.
        what: &'static str,
        /// The observed slope, which is the median over several problems.
        found: f64,
        /// The smallest accepted slope.
        least: f64,
        /// The numbers of subintervals used for the fit.
        window: Vec<usize>,
    },
    /// Something wrong was accepted.
    #[error("{what} was not refused")]
    NotRefused {
        /// What was accepted, in words.
        what: &'static str,
    },
    /// The solver found no minimum for most of the problems, so nothing was tested.
    #[error("the solver found no local minimum for {failed} of {tried} problems: {error}")]
    NotSolved {
        /// The number of problems for which it found no minimum.
        failed: u64,
        /// The number of problems that were tried.
        tried: u64,
        /// The reason for the last of them.
        error: VerifyError,
    },
    /// A statement could not be evaluated.
    #[error(transparent)]
    Unevaluated(#[from] VerifyError),
    /// The law was not tried, because a law of the formula fails and the solver would stall.
    #[error("not tried: {law} fails")]
    NotTried {
        /// The law of the formula that fails.
        law: &'static str,
    },
    /// No sample could be drawn.
    #[error("no sample could be drawn: {why}")]
    NoSample {
        /// The reason.
        why: String,
    },
}

/// Returns the place of a violation, as part of the message.
fn place(point: &[f64], other: Option<&[f64]>) -> String {
    match other {
        _ if point.is_empty() => String::new(),
        None => format!(", at x = {point:?}"),
        Some(other) => format!(", at x = {point:?} with the member {other:?}"),
    }
}

impl Fault {
    /// Adds the second point of a violated inequality.
    pub(crate) fn with_member(mut self, member: &[f64]) -> Self {
        if let Fault::Broken { other, .. } = &mut self {
            *other = Some(member.into());
        }
        self
    }

    /// Returns whether the fault is in the metric or one of its claims, rather than in a statement
    /// about them. Cheaper laws test the metric and its claims.
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

    /// Returns whether a side of the inequality is NaN; such a fault does not show what is wrong.
    pub(crate) fn is_nan(&self) -> bool {
        match self {
            Fault::Broken { left, right, granted, .. } => (left + right + granted).is_nan(),
            Fault::Statement { inequality, .. } => {
                (inequality.observed + inequality.bound + inequality.granted).is_nan()
            }
            _ => false,
        }
    }

    /// Returns the overestimation `right / left` if `left ≤ right + granted`, and the fault
    /// otherwise. A NaN on either side is a fault.
    ///
    /// The overestimation is `∞` if `left` is not positive or does not exceed the granted rounding.
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

    /// Does the same for a quantity that should be 0.
    pub(crate) fn unless_zero(
        law: &'static str,
        size: f64,
        granted: f64,
        point: &[f64],
    ) -> Result<f64, Self> {
        Self::unless_at_most(law, [size, 0.0], granted, point)
    }
}

#[cfg(test)]
mod tests {
    use super::Fault;

    #[test]
    fn a_violated_inequality_shows_its_points() {
        let broken = |point: &[f64]| {
            Fault::unless_at_most("a ≤ b", [2.0, 1.0], 0.5, point).expect_err("2 > 1.5")
        };
        let rest = ": 2e0 is not at most 1e0, with 5e-1 granted";
        assert_eq!(broken(&[]).to_string(), format!("a ≤ b{rest}"));
        assert_eq!(broken(&[3.0]).to_string(), format!("a ≤ b, at x = [3.0]{rest}"));
        let with = broken(&[3.0]).with_member(&[4.0]).to_string();
        assert_eq!(with, format!("a ≤ b, at x = [3.0] with the member [4.0]{rest}"));
    }

    /// The slope of an error that does not fall at all may have either sign.
    #[test]
    fn an_order_shows_its_sign() {
        let fault = Fault::Order { what: "e", found: -0.002, least: 1.95, window: vec![1, 2] };
        let text =
            "e falls like N⁻ᑫ with q = -0.002 over N = [1, 2], but q should be at least 1.95";
        assert_eq!(fault.to_string(), text);
    }
}
