//! What may help where a formula cannot be read.

use super::{Problem, TextError, meant::probably_meant};
use crate::Function;

/// What to write for a function that is missing, because a metric must be smooth or because others say the
/// same. Each is about `u` and `v`.
const INSTEAD: [(&[&str], &str); 9] = [
    (&["abs"], "a metric must be smooth: write sqrt(u^2 + e^2) with a small e for abs(u)"),
    (
        &["max", "min"],
        "a metric must be smooth: write ln(exp(k*u) + exp(k*v))/k with a large k for max(u, v), and with \
         -k for min(u, v)",
    ),
    (
        &["if", "step", "heaviside", "sign", "sgn", "where", "piecewise"],
        "a metric must be smooth: write a + (b - a)*(1 + tanh(u/e))/2 with a small e for a where u < 0 and \
         b where u > 0",
    ),
    (&["log"], "the natural logarithm is ln"),
    (&["log10", "log2"], "write ln(u)/ln(10) for log10(u), and ln(u)/ln(2) for log2(u)"),
    (
        &["atan2", "arctan2"],
        "write 2*atan(v/(sqrt(u^2 + v^2) + u)) for atan2(v, u), where v is not 0 or u is positive",
    ),
    (&["asin", "arcsin"], "write atan(u/sqrt(1 - u^2)) for asin(u)"),
    (&["acos", "arccos"], "write pi/2 - atan(u/sqrt(1 - u^2)) for acos(u)"),
    (&["arctan"], "the arc tangent is atan"),
];

impl TextError {
    /// Returns what may help; `None` if nothing comes to mind. `before` is the text in front of the error,
    /// and `names` are those that the formula may use.
    ///
    /// ```
    /// use tautline_formula::Formula;
    ///
    /// let text = "cost(2 - cso(x1))";
    /// let error = Formula::<1>::parse(text, &[]).expect_err("no function");
    /// assert_eq!(error.help(&text[..error.at.start], &[]).as_deref(), Some("did you mean cos?"));
    /// ```
    #[must_use]
    pub fn help(&self, before: &str, names: &[&str]) -> Option<String> {
        match &self.problem {
            Problem::Unexpected { found, .. } => {
                let ends = |c: char| c.is_alphanumeric() || c == ')';
                let begins = |c: char| c.is_alphabetic() || c == '(';
                let is_product = before.trim_end().ends_with(ends) && found != "the end";
                match found.chars().next()? {
                    '−' | '–' => Some("the minus of a formula is -".to_owned()),
                    first if is_product && begins(first) => {
                        Some("a product has a sign, such as 2*x1".to_owned())
                    }
                    _ => None,
                }
            }
            Problem::UnknownName { name } => meant_by(name, names),
            Problem::UnknownFunction { name } => {
                let instead = INSTEAD.iter().find(|(words, _)| words.contains(&name.as_str()));
                let instead = instead.map(|(_, instead)| (*instead).to_owned());
                instead.or_else(|| meant_by(name, names)).or_else(|| {
                    let all: Vec<&str> = functions().collect();
                    Some(format!("the functions are {}", all.join(", ")))
                })
            }
            Problem::Exponent => {
                Some("a root is sqrt(u), another power is exp(p*ln(u))".to_owned())
            }
            _ => None,
        }
    }
}

/// Returns the names of the functions, without the sign.
fn functions<'f>() -> impl Iterator<Item = &'f str> {
    Function::NAMES.iter().copied().filter(|name| *name != "-")
}

/// Returns what may help with an unknown word.
fn meant_by(word: &str, names: &[&str]) -> Option<String> {
    let lower = word.to_lowercase();
    if names.contains(&word) {
        Some(format!("{word} is not defined before this"))
    } else if matches!(word, "x" | "X" | "y" | "z") {
        Some("the coordinates are x1, x2 and so on".to_owned())
    } else if functions().any(|function| function == word) {
        Some(format!("a function has parentheses, such as {word}(x1)"))
    } else if is_coordinate(&lower) {
        Some(format!("did you mean {lower}?"))
    } else {
        let known = functions().chain(["pi"]).chain(names.iter().copied());
        Some(format!("did you mean {}?", probably_meant(word, known)?))
    }
}

/// Returns whether a name is that of a coordinate, such as `x1`.
fn is_coordinate(name: &str) -> bool {
    name.strip_prefix('x').is_some_and(|number| number.parse::<usize>().is_ok())
}

#[cfg(test)]
mod tests {
    use tautline_metrics::Metric;

    use super::INSTEAD;
    use crate::Formula;

    /// Each formula that stands for a missing function has its values: followed, the advice works.
    #[test]
    fn what_is_advised_has_the_values_of_the_missing_function() {
        let value = |text: &str, at: [f64; 2]| {
            let metric = Formula::<2>::parse(&format!("({text}) I"), &[]).expect("a formula");
            metric.gram(&at.into())[(0, 0)]
        };
        // With k = 50 the larger of two numbers is exceeded by ln 2/50 at most; the step of width 1/100 is
        // one to rounding where |u| ≥ 0.2.
        let exact = 1e-14;
        for [u, v] in [[0.3, 0.8], [-0.6, 0.2], [0.7, -0.4], [-0.2, -0.9_f64]] {
            for (advice, names, expected, error) in [
                ("sqrt(u^2 + e^2)", &[("e", "1e-3")][..], u.abs(), 1e-3),
                ("ln(exp(k*u) + exp(k*v))/k", &[("k", "50")], u.max(v), 0.014),
                ("ln(exp(k*u) + exp(k*v))/k", &[("k", "(-50)")], u.min(v), 0.014),
                (
                    "a + (b - a)*(1 + tanh(u/e))/2",
                    &[("a ", "3 "), ("- a)", "- 3)"), ("(b", "(7"), ("e)", "1e-2)")],
                    if u < 0.0 { 3.0 } else { 7.0 },
                    exact,
                ),
                ("ln(u)/ln(10)", &[("u", "(u^2)")], (u * u).log10(), exact),
                ("ln(u)/ln(2)", &[("u", "(u^2)")], (u * u).log2(), exact),
                ("2*atan(v/(sqrt(u^2 + v^2) + u))", &[], v.atan2(u), exact),
                ("atan(u/sqrt(1 - u^2))", &[], u.asin(), exact),
                ("pi/2 - atan(u/sqrt(1 - u^2))", &[], u.acos(), exact),
            ] {
                assert!(INSTEAD.iter().any(|(_, text)| text.contains(advice)), "{advice}");
                let text = names.iter().fold(advice.to_owned(), |text, (a, b)| text.replace(a, b));
                let text = text.replace('u', "x1").replace('v', "x2");
                let found = value(&text, [u, v]);
                assert!(
                    (found - expected).abs() <= error,
                    "{text} at {u}, {v}: {found} {expected}"
                );
            }
        }
    }

    /// A name that is defined later may be that of a missing function or of a coordinate elsewhere.
    #[test]
    fn a_name_that_is_defined_later_is_told_first() {
        for name in ["z", "step", "x", "b"] {
            let text = format!("phi(2 + {name})");
            let error = Formula::<2>::parse(&text, &[]).expect_err("broken");
            let help = error.help(&text[..error.at.start], &[name, "c"]);
            assert_eq!(help, Some(format!("{name} is not defined before this")));
        }
    }

    #[test]
    fn words_that_are_not_known_are_explained() {
        for (text, expected) in [
            ("phi(abs(x1))", Some("sqrt(u^2 + e^2)")),
            ("phi(atan2(x1, x2))", Some("2*atan(v/(sqrt(u^2 + v^2) + u))")),
            ("phi(if(x1))", Some("tanh(u/e)")),
            ("phi(2 + X1)", Some("did you mean x1?")),
            ("phi(2 + x)", Some("the coordinates are x1")),
            ("phi(sin)", Some("a function has parentheses, such as sin(x1)")),
            ("phi(2 + coss(x1))", Some("did you mean cos?")),
            ("phi(2 + wvbqk(x1))", Some("the functions are ")),
            ("phi(2 + wvbqk)", None),
            ("phi(2 x1)", Some("a product has a sign")),
            ("phi(2 − x1)", Some("the minus of a formula is -")),
            ("phi(x1^0.5)", Some("a root is sqrt(u)")),
        ] {
            let error = Formula::<2>::parse(text, &[]).expect_err("broken");
            let help = error.help(&text[..error.at.start], &[]);
            let is_expected = match expected {
                Some(expected) => help.as_ref().is_some_and(|help| help.contains(expected)),
                None => help.is_none(),
            };
            assert!(is_expected, "{text}: {help:?}");
        }
    }
}
