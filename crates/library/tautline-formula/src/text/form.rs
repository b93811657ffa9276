//! `Form`: a way to make a Gram matrix from functions.

use super::{
    gradient::{along, gradients, sum},
    value::Value,
};
use crate::recording::Symbol;

/// A way to make a Gram matrix from functions of the coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Form {
    /// `JᵀJ` with the derivative `J` of a map from `R^D` to `R^m`, `m ≥ D`. It measures the lengths
    /// of image curves.
    Pullback,
    /// `I + ∇f ∇fᵀ`, which measures the lengths of curves on the graph of `f`.
    Graph,
    /// `φ I`.
    Phi,
    /// `f² I`, under which a curve has the length `∫ f |γ'| dt`: `f` is the cost of a unit of length.
    Cost,
    /// `f⁻² I`, under which the length of a curve is the time it takes at the speed `f`.
    Speed,
    /// The diagonal matrix with these entries.
    Diag,
}

/// Returns the form with this name.
pub(super) fn form(name: &str) -> Option<Form> {
    Some(match name {
        "pullback" => Form::Pullback,
        "graph" => Form::Graph,
        "phi" => Form::Phi,
        "cost" => Form::Cost,
        "speed" => Form::Speed,
        "diag" => Form::Diag,
        _ => return None,
    })
}

impl Form {
    /// Returns whether this many functions make a matrix of `dimension` rows.
    pub(super) fn takes(self, functions: usize, dimension: usize) -> bool {
        match self {
            Form::Pullback => functions >= dimension,
            Form::Graph | Form::Phi | Form::Cost | Form::Speed => functions == 1,
            Form::Diag => functions == dimension,
        }
    }

    /// Returns the form's name and how many functions it takes, for an error message.
    pub(super) fn takes_what(self, dimension: usize) -> (&'static str, String) {
        let (name, count) = match self {
            Form::Pullback => ("pullback", dimension),
            Form::Graph => ("graph", 1),
            Form::Phi => ("phi", 1),
            Form::Cost => ("cost", 1),
            Form::Speed => ("speed", 1),
            Form::Diag => ("diag", dimension),
        };
        let functions = if count == 1 { "one function" } else { &format!("{count} functions") };
        let more = if self == Form::Pullback { " or more" } else { "" };
        (name, format!("{functions}{more}"))
    }

    /// Returns the entries of the matrix for curves along which only these coordinates change,
    /// column by column.
    pub(super) fn entries(self, functions: &[Value], coordinates: &[usize]) -> Vec<Symbol> {
        let dimension = coordinates.len();
        let one = |is_diagonal: bool| Value::Number(f64::from(u8::from(is_diagonal)));
        let derivatives: Vec<Vec<Value>> = match self {
            Form::Pullback | Form::Graph => gradients(functions, coordinates),
            Form::Phi | Form::Cost | Form::Speed | Form::Diag => Vec::new(),
        };
        let entry = |i: usize, j: usize| {
            let begin = if self == Form::Pullback { one(false) } else { one(i == j) };
            match self {
                Form::Pullback | Form::Graph => {
                    // This is a square, so that it is not negative in intervals.
                    let term = |row: &Vec<Value>| {
                        if i == j { row[i].squared() } else { product(row[i], row[j]) }
                    };
                    let products = derivatives.iter().map(term);
                    products.fold(begin, sum)
                }
                Form::Phi => along(begin, functions[0]),
                Form::Cost => along(begin, functions[0].squared()),
                Form::Speed if i == j => begin / functions[0].squared(),
                Form::Speed => begin,
                Form::Diag => along(begin, functions[i]),
            }
        };
        let places = (0..dimension).flat_map(|j| (0..dimension).map(move |i| (i, j)));
        // Both halves consist of the same steps.
        places.map(|(i, j)| entry(i.min(j), i.max(j)).symbol()).collect()
    }
}

/// Returns the product of two derivatives. A 0 means that a derivative is known to vanish.
fn product(a: Value, b: Value) -> Value {
    if b.is(0.0) { b } else { along(a, b) }
}
