//! The clauses of hypotheses that counterexamples drop, each named by its claim or by a part of it.

/// The Lipschitz constant of the metric.
pub(crate) const LIPSCHITZ: &str = "‖H(x) − H(y)‖/|x − y| ≤ L_H";

/// The lower bound of the metric.
pub(crate) const BELOW: &str = "c₁ ≤ λ_min(H)";

/// The upper bound of the metric.
pub(crate) const ABOVE: &str = "λ_max(H) ≤ c₂";

/// The minimiser is global, to the extent that the proof needs.
pub(crate) const PREMISE: &str = "E_N ≤ the proof's bound";

/// The curve or the sequence joins the two sets.
pub(crate) const ENDS: &str = "the ends lie";
