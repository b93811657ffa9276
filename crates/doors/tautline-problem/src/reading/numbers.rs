//! `Numbers`: the parameters of a file, and the numbers that are written with them.

use std::ops::Range;

use tautline::{
    Short,
    formula::{self, Function, Problem as TextProblem, TextError},
};

use crate::{
    Diagnostic,
    file::{
        ProblemFile,
        expression::{Expression, Text, place},
        set::Vector,
    },
    reading::{meant::probably_meant, parse::all},
};

/// The file, and its parameters in their order.
pub(crate) struct Numbers<'f> {
    pub(crate) file: &'f str,
    pub(crate) parameters: Vec<(String, f64)>,
}

impl<'f> Numbers<'f> {
    /// Evaluates the parameters of a file, some of them with other values in place of their own.
    pub(crate) fn new(
        file: &'f str,
        problem: &ProblemFile,
        replaced: &[(&str, f64)],
    ) -> Result<Self, Diagnostic> {
        let mut numbers = Self { file, parameters: Vec::new() };
        let mut parameters: Vec<_> = problem.parameters.iter().collect();
        parameters.sort_by_key(|(name, _)| name.span().start);
        for (name, value) in parameters {
            let other = replaced.iter().find(|(replaced, _)| replaced == name.get_ref());
            let value = other.map_or_else(|| numbers.number(value), |&(_, value)| Ok(value))?;
            // The name is checked by using it.
            let with = [(name.get_ref().as_str(), value)];
            if let Err(error) = formula::number("0", &with) {
                return Err(Diagnostic::new(error.problem.to_string(), name.span()));
            }
            numbers.parameters.push((name.get_ref().clone(), value));
        }
        Ok(numbers)
    }

    /// Returns the parameters by their names.
    pub(crate) fn by_name(&self) -> Vec<(&str, f64)> {
        self.parameters.iter().map(|(name, value)| (name.as_str(), *value)).collect()
    }

    /// Evaluates a number that may be an expression of the parameters.
    pub(crate) fn number(&self, text: &Text) -> Result<f64, Diagnostic> {
        let Expression(expression) = text.get_ref();
        let parameters = self.by_name();
        let value = formula::number(expression, &parameters)
            .map_err(|error| self.explain(&error, text.span(), &[]))?;
        if value.is_finite() {
            Ok(value)
        } else {
            Err(Diagnostic::new(format!("{expression} is {value}"), text.span())
                .label("expected a finite number"))
        }
    }

    /// Evaluates a number that must lie between two others.
    pub(crate) fn between(&self, text: &Text, least: f64, most: f64) -> Result<f64, Diagnostic> {
        let value = self.number(text)?;
        if value > least && value < most {
            return Ok(value);
        }
        let expected = if most.is_finite() {
            format!("expected a number between {} and {}", Short(least), Short(most))
        } else {
            format!("expected a number above {}", Short(least))
        };
        Err(Diagnostic::new(format!("{value} is out of range"), text.span()).label(expected))
    }

    pub(crate) fn all(&self, texts: &[Text]) -> Result<Vec<f64>, Diagnostic> {
        texts.iter().map(|text| self.number(text)).collect()
    }

    /// Evaluates a vector with this many coordinates.
    pub(crate) fn vector(&self, vector: &Vector, dimension: usize) -> Result<Vec<f64>, Diagnostic> {
        let found = vector.get_ref().len();
        if found != dimension {
            let message = format!("{} in dimension {dimension}", counted(found, "coordinate"));
            return Err(Diagnostic::new(message, vector.span())
                .label(format!("expected {}", counted(dimension, "coordinate"))));
        }
        self.all(vector.get_ref())
    }

    /// Explains an error in an expression that stands at `span`, given further names that it may
    /// use.
    pub(crate) fn explain(
        &self,
        error: &TextError,
        span: Range<usize>,
        names: &[&str],
    ) -> Diagnostic {
        let at = place(self.file, span, &error.at);
        let parameters = self.parameters.iter().map(|(name, _)| name.as_str());
        let known = Function::NAMES.iter().copied().chain(["pi"]).chain(names.iter().copied());
        let known = known.chain(parameters).filter(|word| word.len() > 1 || *word != "-");
        match &error.problem {
            TextProblem::Unexpected { found, expected } => {
                let ends = |c: char| c.is_alphanumeric() || c == ')';
                let before = self.file.get(..at.start).map(str::trim_end);
                let is_product = before.is_some_and(|before| before.ends_with(ends));
                let begins = |c: char| c.is_alphabetic() || c == '(';
                let diagnostic = Diagnostic::new(format!("found {found} in an expression"), at)
                    .label(format!("expected {expected}"));
                match found.chars().next() {
                    Some('−' | '–') => diagnostic.help("the minus of a formula is -"),
                    Some(first) if is_product && begins(first) && found != "the end" => {
                        diagnostic.help("a product has a sign, such as 2*x1")
                    }
                    _ => diagnostic,
                }
            }
            TextProblem::NoCoordinate { name, dimension: 0 } => {
                Diagnostic::new(format!("{name} in a number"), at)
                    .help("a function of the coordinates belongs in [metric] or in [let]")
            }
            problem @ (TextProblem::UnknownName { name }
            | TextProblem::UnknownFunction { name }) => {
                let diagnostic = Diagnostic::new(problem.to_string(), at);
                match (name.as_str(), probably_meant(name, known)) {
                    ("abs", _) => diagnostic.help(
                        "a metric must be smooth: write sqrt(u^2 + e^2) with a small e for abs(u)",
                    ),
                    ("max" | "min", _) => diagnostic.help(
                        "a metric must be smooth: write ln(exp(k*u) + exp(k*v))/k with a large k \
                         for max(u, v)",
                    ),
                    ("log", _) => diagnostic.help("the natural logarithm is ln"),
                    ("x" | "X" | "y", _) => diagnostic.help("the coordinates are x1, x2 and so on"),
                    (name, _) if Function::NAMES.contains(&name) => {
                        diagnostic.help(format!("a function has parentheses, such as {name}(x1)"))
                    }
                    (name, _) if names.contains(&name) => {
                        diagnostic.help(format!("{name} is not defined before this"))
                    }
                    (name, _) if is_coordinate(&name.to_lowercase()) => {
                        diagnostic.help(format!("did you mean {}?", name.to_lowercase()))
                    }
                    (_, Some(meant)) => diagnostic.help(format!("did you mean {meant}?")),
                    (_, None) if matches!(problem, TextProblem::UnknownFunction { .. }) => {
                        let names: Vec<&str> =
                            Function::NAMES.iter().copied().filter(|name| *name != "-").collect();
                        diagnostic.help(format!("the functions are {}", all(&names)))
                    }
                    (_, None) => diagnostic
                        .help(format!("{name} may be defined in [parameters] or in [let]")),
                }
            }
            problem @ TextProblem::Exponent => Diagnostic::new(problem.to_string(), at)
                .help("a root is sqrt(u), another power is exp(p*ln(u))"),
            problem => Diagnostic::new(problem.to_string(), at),
        }
    }
}

/// Returns whether a name is that of a coordinate, such as `x1`.
fn is_coordinate(name: &str) -> bool {
    name.strip_prefix('x').is_some_and(|number| number.parse::<usize>().is_ok())
}

/// Returns the number with its noun.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    match (count, noun.strip_suffix('y')) {
        (1, _) => format!("1 {noun}"),
        (_, Some(stem)) => format!("{count} {stem}ies"),
        (_, None) => format!("{count} {noun}s"),
    }
}
