//! The tables of a file, as functions.

use std::sync::Arc;

use tautline::{FineSpline, Spline, Table, formula};

use crate::{
    Diagnostic,
    array::Array,
    file::{
        ProblemFile,
        placed::Placed,
        table::{Nested, SplineFile, TableFile},
    },
    reading::numbers::Numbers,
};

/// Tables by their names.
pub(crate) type Tables = Arc<[(String, Arc<dyn Table>)]>;

/// Returns the bytes of a file with this name, or why it cannot be read.
pub type Open<'a> = dyn FnMut(&str) -> Result<Vec<u8>, String> + 'a;

/// Opens no file, for problems whose tables all stand in the text.
///
/// # Errors
///
/// Always.
pub fn no_file(_: &str) -> Result<Vec<u8>, String> {
    Err("a table in another file, which is not read here".to_owned())
}

/// Reads the tables of a file, in their order.
pub(crate) fn tables(
    problem: &ProblemFile,
    numbers: &Numbers<'_>,
    open: &mut Open<'_>,
) -> Result<Tables, Diagnostic> {
    let mut written: Vec<_> = problem.tables.iter().collect();
    written.sort_by_key(|(name, _)| name.span().start);
    let mut names = numbers.by_name();
    let mut tables: Vec<(String, Arc<dyn Table>)> = Vec::new();
    for (name, table) in written {
        // The name is checked by using it.
        names.push((name.get_ref(), 0.0));
        if let Err(error) = formula::number("0", &names) {
            return Err(Diagnostic::new(error.problem.to_string(), name.span()));
        }
        tables.push((name.get_ref().clone(), spline(name, table.get_ref(), open)?));
    }
    Ok(tables.into())
}

fn spline(
    name: &Placed<String>,
    table: &TableFile,
    open: &mut Open<'_>,
) -> Result<Arc<dyn Table>, Diagnostic> {
    let TableFile { values, file, component, spline } = table;
    let (array, place) = match (values, file) {
        (Some(values), None) => (nested(values)?, values.span()),
        (None, Some(file)) => {
            let refuse =
                |what: String| Diagnostic::new(format!("{}: {what}", file.get_ref()), file.span());
            let bytes = open(file.get_ref()).map_err(refuse)?;
            let array = Array::read(&bytes).map_err(|error| refuse(error.to_string()))?;
            if let (true, None, &[_, _, channels]) =
                (Array::is_picture(&bytes), component, array.shape())
            {
                return Err(refuse(format!("the pixels have {channels} numbers each"))
                    .help("component = [1] takes the first of them"));
            }
            (array, file.span())
        }
        (Some(_), Some(file)) => {
            return Err(Diagnostic::new("a file besides values", file.span())
                .label("expected values or file, not both"));
        }
        (None, None) => {
            return Err(Diagnostic::new("a table without numbers", name.span())
                .help("such as values = [[0, 1], [1, 2]], or file = \"terrain.npy\""));
        }
    };
    let array = match component {
        None => array,
        Some(numbers) => {
            // In a file everything is counted from 1.
            let index: Option<Vec<usize>> =
                numbers.get_ref().iter().map(|number| number.checked_sub(1)).collect();
            let entry = index.and_then(|index| array.component(&index).ok());
            entry.ok_or_else(|| {
                let message = format!("no such entry of an array of shape {:?}", array.shape());
                Diagnostic::new(message, numbers.span())
                    .label("expected an index for each of the last axes, from 1")
            })?
        }
    };
    let axes = array.shape().len();
    let (shape, values) = array.into_parts();
    let table: Result<Arc<dyn Table>, _> = match spline {
        SplineFile::Monotone => {
            FineSpline::monotone(&shape, values).map(|spline| Arc::new(spline) as _)
        }
        SplineFile::Cubic => {
            Spline::interpolating(&shape, values).map(|spline| Arc::new(spline) as _)
        }
        SplineFile::Smoothing => Spline::new(&shape, values).map(|spline| Arc::new(spline) as _),
    };
    table.map_err(|error| {
        let diagnostic = Diagnostic::new(error.to_string(), place);
        let has_channels = file.is_some() && component.is_none() && axes > 3;
        if has_channels {
            diagnostic.help("component = [1, 1], say, takes one number at each point")
        } else {
            diagnostic
        }
    })
}

/// Returns the array of numbers that are written in brackets.
fn nested(values: &Placed<Nested>) -> Result<Array, Diagnostic> {
    let mut shape = Vec::new();
    let mut first = values.get_ref();
    while let Nested::List(list) = first {
        shape.push(list.len());
        match list.first() {
            Some(next) => first = next,
            None => break,
        }
    }
    let mut numbers = Vec::new();
    let is_array = collect(values.get_ref(), &shape, &mut numbers);
    let ragged = || {
        Diagnostic::new("rows of different lengths", values.span())
            .label("expected rows of the same length")
    };
    if !is_array {
        return Err(ragged());
    }
    Array::new(shape, numbers).map_err(|_| ragged())
}

/// Collects the numbers of a list of this shape; returns whether it has this shape.
fn collect(values: &Nested, shape: &[usize], numbers: &mut Vec<f64>) -> bool {
    match (values, shape) {
        (Nested::Number(value), []) => {
            numbers.push(*value);
            true
        }
        (Nested::List(list), [length, rest @ ..]) => {
            list.len() == *length && list.iter().all(|values| collect(values, rest, numbers))
        }
        _ => false,
    }
}
