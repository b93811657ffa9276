//! Clauses of hypotheses that counterexamples drop, each by its claim or a part of it.

/// The Lipschitz constant of the metric.
pub(crate) const LIPSCHITZ: &str = "‖H(x) − H(y)‖/|x − y| ≤ L_H";

/// The lower bound of the metric.
pub(crate) const BELOW: &str = "c₁ ≤ λ_min(H)";

/// The upper bound of the metric.
pub(crate) const ABOVE: &str = "λ_max(H) ≤ c₂";

/// The minimiser is global, as far as the proof needs it.
pub(crate) const PREMISE: &str = "E_N ≤ the proof's bound";

/// The curve or the sequence leads from set to set.
pub(crate) const ENDS: &str = "the ends lie";
