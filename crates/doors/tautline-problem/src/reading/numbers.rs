//! `Numbers`: the parameters of a file, and the numbers that are written with them.

use std::ops::Range;

use tautline::{
    Short,
    formula::{self, Problem as TextProblem, TextError},
};

use crate::{
    Diagnostic,
    file::{
        ProblemFile,
        expression::{Expression, Text, place},
        set::Vector,
    },
};

/// The file, and its parameters in their order.
pub(crate) struct Numbers<'f> {
    pub(crate) file: &'f str,
    /// The names of all parameters, also of those that have no value yet.
    names: Vec<String>,
    pub(crate) parameters: Vec<(String, f64)>,
}

impl<'f> Numbers<'f> {
    /// Returns a file with the values of all of its parameters.
    pub(crate) fn evaluated(file: &'f str, parameters: Vec<(String, f64)>) -> Self {
        let names = parameters.iter().map(|(name, _)| name.clone()).collect();
        Self { file, names, parameters }
    }

    /// Evaluates the parameters of a file, some of them with other values in place of their own.
    pub(crate) fn new(
        file: &'f str,
        problem: &ProblemFile,
        replaced: &[(&str, f64)],
    ) -> Result<Self, Diagnostic> {
        let names = problem.parameters.keys().map(|name| name.get_ref().clone()).collect();
        let mut numbers = Self { file, names, parameters: Vec::new() };
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
        let known: Vec<&str> =
            names.iter().copied().chain(self.names.iter().map(String::as_str)).collect();
        let help = error.help(self.file.get(..at.start).unwrap_or_default(), &known);
        let (diagnostic, help) = match &error.problem {
            TextProblem::Unexpected { found, expected } => {
                let diagnostic = Diagnostic::new(format!("found {found} in an expression"), at);
                (diagnostic.label(format!("expected {expected}")), help)
            }
            TextProblem::NoCoordinate { name, dimension: 0 } => {
                let belongs = "a function of the coordinates belongs in [metric] or in [let]";
                (Diagnostic::new(format!("{name} in a number"), at), Some(belongs.to_owned()))
            }
            problem @ TextProblem::UnknownName { name } => {
                let defined = || format!("{name} may be defined in [parameters] or in [let]");
                (Diagnostic::new(problem.to_string(), at), Some(help.unwrap_or_else(defined)))
            }
            problem => (Diagnostic::new(problem.to_string(), at), help),
        };
        match help {
            Some(help) => diagnostic.help(help),
            None => diagnostic,
        }
    }
}

/// Returns the number with its noun.
pub(crate) fn counted(count: usize, noun: &str) -> String {
    match (count, noun.strip_suffix('y')) {
        (1, _) => format!("1 {noun}"),
        (_, Some(stem)) => format!("{count} {stem}ies"),
        (_, None) => format!("{count} {noun}s"),
    }
}
