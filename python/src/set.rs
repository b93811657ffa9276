//! `Set`: a closed set.

use std::collections::HashMap;

use pyo3::{IntoPyObjectExt, prelude::*, types::PyType};
use tautline::sets::kind::{Form, Kind, Value};
use tautline_any::Shape;

use crate::error::ProblemError;

/// A closed set: a piece, or the union of several with `|`.
#[pyclass(frozen, from_py_object, module = "tautline_geodesics")]
#[derive(Clone, Debug)]
pub(crate) struct Set {
    pub(crate) pieces: Vec<Shape>,
}

/// A piece: the key of its kind in problem files, and its parts by their names.
type Piece<'py> = (String, HashMap<String, Bound<'py, PyAny>>);

fn piece((key, mut given): Piece<'_>) -> PyResult<Shape> {
    let other = |what: String| ProblemError::new_err(format!("no piece of a set: {what}"));
    let kind = Kind::keyed(&key).ok_or_else(|| other(key))?;
    let mut values = Vec::new();
    for part in kind.parts {
        let mut found = part.names().iter().filter_map(|&name| Some((name, given.remove(name)?)));
        let (name, value) = match (found.next(), found.next()) {
            (Some(one), None) => one,
            (first, _) => {
                let has = if first.is_some() { "has either" } else { "needs" };
                let names = part.names().join(" or ");
                return Err(ProblemError::new_err(format!("{} {has} {names}", kind.name)));
            }
        };
        values.push(match part.form {
            Form::Vector => Value::Vector(value.extract()?),
            Form::Vectors => Value::Vectors(value.extract()?),
            Form::Number => Value::Number(value.extract()?),
            Form::Side if name == "at_least" => Value::AtLeast(value.extract()?),
            Form::Side => Value::AtMost(value.extract()?),
        });
    }
    if let Some(name) = given.into_keys().next() {
        return Err(other(format!("{} with {name}", kind.name)));
    }
    kind.shape(&values).map_err(|error| ProblemError::new_err(error.to_string()))
}

/// The values of the parts of a piece by their names.
type Parts = HashMap<&'static str, Py<PyAny>>;

/// The arguments that make a set.
type Arguments = (Vec<(&'static str, Parts)>,);

fn parts(py: Python<'_>, kind: Kind, values: Vec<Value>) -> PyResult<Parts> {
    let named = kind.parts.iter().zip(values).map(|(part, value)| {
        let name = part.name_of(&value);
        let value = match value {
            Value::Vector(x) => x.into_py_any(py)?,
            Value::Vectors(rows) => rows.into_py_any(py)?,
            Value::Number(x) | Value::AtMost(x) | Value::AtLeast(x) => x.into_py_any(py)?,
        };
        Ok((name, value))
    });
    named.collect()
}

#[pymethods]
impl Set {
    /// A set from its pieces, each the key of its kind in problem files and its parts by their names.
    #[new]
    fn new(pieces: Vec<Piece<'_>>) -> PyResult<Self> {
        Ok(Self { pieces: pieces.into_iter().map(piece).collect::<PyResult<_>>()? })
    }

    fn __reduce__<'py>(slf: &Bound<'py, Self>) -> PyResult<(Bound<'py, PyType>, Arguments)> {
        let described = slf.get().pieces.iter().flat_map(Shape::described);
        let pieces = described.map(|(kind, values)| Ok((kind.key, parts(slf.py(), kind, values)?)));
        Ok((slf.get_type(), (pieces.collect::<PyResult<_>>()?,)))
    }

    fn __or__(&self, other: &Self) -> Self {
        Self { pieces: [&self.pieces[..], &other.pieces].concat() }
    }

    fn __repr__(&self) -> String {
        let names: Vec<&str> = self.pieces.iter().map(Shape::name).collect();
        format!("<tautline.Set: {}>", names.join(" and "))
    }
}
