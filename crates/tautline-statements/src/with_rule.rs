//! From a rule as a value to a rule as a type.

/// Evaluates an expression with `$rule` bound to the rule that a `PaperRule` names.
macro_rules! with_rule {
    ($which:expr, $rule:ident => $value:expr) => {
        match $which {
            $crate::PaperRule::Trapezoidal => {
                let $rule = tautline::Trapezoidal;
                $value
            }
            $crate::PaperRule::LeftEndpoint => {
                let $rule = tautline::LeftEndpoint;
                $value
            }
        }
    };
}
pub(crate) use with_rule;

/// Evaluates an expression with `$rule` bound to the rule that a mutant takes for the type `$kind`.
macro_rules! with_mistaken_rule {
    ($mutant:expr, $rule:ident: $kind:ty => $value:expr) => {
        // A rule is identified by its nodes.
        match ($mutant, <$kind>::NODES == tautline::Trapezoidal::NODES) {
            ($crate::Mutant::RulesExchanged, true) => {
                let $rule = tautline::LeftEndpoint;
                $value
            }
            ($crate::Mutant::RulesExchanged, false) => {
                let $rule = tautline::Trapezoidal;
                $value
            }
            ($crate::Mutant::TrueTrapezoid, true) => {
                let $rule = tautline::TrueTrapezoid;
                $value
            }
            _ => $value,
        }
    };
}
pub(crate) use with_mistaken_rule;
