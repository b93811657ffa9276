//! `Form`: a Gram matrix that a text makes of functions.

use super::{
    gradient::{along, gradients, sum},
    value::Value,
};
use crate::recording::Symbol;

/// How a Gram matrix is made of functions of the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// `JᵀJ` with the derivative `J` of a map from `R^D` to `R^m`, `m ≥ D`: the lengths of the curves there.
    Pullback,
    /// `I + ∇f ∇fᵀ`: the lengths of curves on the graph of `f`.
    Graph,
    /// `φ I`.
    Phi,
    /// `f² I`: the length of a curve is `∫ f |γ'| dt`.
    Speed,
    /// The diagonal matrix with these entries.
    Diag,
}

/// Returns the form of this name.
pub(super) fn form(name: &str) -> Option<Form> {
    Some(match name {
        "pullback" => Form::Pullback,
        "graph" => Form::Graph,
        "phi" => Form::Phi,
        "speed" => Form::Speed,
        "diag" => Form::Diag,
        _ => return None,
    })
}

impl Form {
    /// Whether so many functions make a matrix of `dimension` rows.
    pub(super) fn takes(self, functions: usize, dimension: usize) -> bool {
        match self {
            Form::Pullback => functions >= dimension,
            Form::Graph | Form::Phi | Form::Speed => functions == 1,
            Form::Diag => functions == dimension,
        }
    }

    /// Returns its name and what it takes in this dimension, as an error says it.
    pub(super) fn takes_what(self, dimension: usize) -> (&'static str, String) {
        let count = |count: usize| match count {
            1 => "one function".to_owned(),
            _ => format!("{count} functions"),
        };
        match self {
            Form::Pullback => ("pullback", format!("{} or more", count(dimension))),
            Form::Graph => ("graph", count(1)),
            Form::Phi => ("phi", count(1)),
            Form::Speed => ("speed", count(1)),
            Form::Diag => ("diag", count(dimension)),
        }
    }

    /// Returns the entries, column by column.
    pub(super) fn entries(self, functions: &[Value], dimension: usize) -> Vec<Symbol> {
        let one = |is_diagonal: bool| Value::Number(f64::from(u8::from(is_diagonal)));
        let derivatives: Vec<Vec<Value>> = match self {
            Form::Pullback | Form::Graph => gradients(functions, dimension),
            Form::Phi | Form::Speed | Form::Diag => Vec::new(),
        };
        let entry = |i: usize, j: usize| {
            let begin = if self == Form::Pullback { one(false) } else { one(i == j) };
            match self {
                Form::Pullback | Form::Graph => {
                    // A square as such: in intervals it is not negative.
                    let term = |row: &Vec<Value>| {
                        if i == j { row[i].squared() } else { product(row[i], row[j]) }
                    };
                    let products = derivatives.iter().map(term);
                    products.fold(begin, sum)
                }
                Form::Phi => along(begin, functions[0]),
                Form::Speed => along(begin, functions[0].squared()),
                Form::Diag => along(begin, functions[i]),
            }
        };
        let places = (0..dimension).flat_map(|j| (0..dimension).map(move |i| (i, j)));
        // The halves are the same steps.
        places.map(|(i, j)| entry(i.min(j), i.max(j)).symbol()).collect()
    }
}

/// The product of two derivatives, of which 0 is one that is known to be so.
fn product(a: Value, b: Value) -> Value {
    if b.is(0.0) { b } else { along(a, b) }
}
