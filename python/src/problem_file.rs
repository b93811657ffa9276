//! The text of a problem file, for the programs that read one.

use pyo3::prelude::*;
use tautline::{
    RecordError,
    sets::kind::{Kind, Value},
};
use tautline_any::Shape;

use crate::{
    claims::Claims,
    error::{NotCertified, ProblemError},
    metric::Program,
    set::Set,
    table::{Spline, called},
};

/// A metric as a problem file, with two sets, the box of the samples and the constants that are claimed,
/// as far as they are given. All numbers read back exactly.
#[pyfunction]
#[pyo3(signature = (program, start=None, goal=None, region=None, claimed=None))]
pub(crate) fn problem_file(
    program: &Program,
    start: Option<Set>,
    goal: Option<Set>,
    region: Option<Set>,
    claimed: Option<Claims>,
) -> PyResult<String> {
    let given = &program.given;
    let formula = given.text().ok_or_else(|| {
        NotCertified::new_err(format!("there is no formula to audit: {}", RecordError::BlackBox))
    })?;
    let mut file = format!("dimension = {}\n", given.dimension());
    for (k, Spline { spline, .. }) in called(given)?.into_iter().enumerate() {
        let values = array(spline.shape(), spline.coefficients())?;
        file += &format!("\n[tables.table{}]\nvalues = {values}\nspline = \"smoothing\"\n", k + 1);
    }
    file += &format!("\n[metric]\nformula = '''\n{formula}'''\n");
    for (name, set) in [("from", start), ("to", goal)] {
        if let Some(set) = set {
            file += &format!("\n[{name}]\n{}\n", union(&set.pieces)?);
        }
    }
    if let Some(set) = region {
        let [Shape::AxisBox(side)] = &set.pieces[..] else {
            return Err(ProblemError::new_err("the region of the samples is a box"));
        };
        file += &format!("\n[audit]\nregion = {}\n", corners(side.corner_slices())?);
    }
    if let Some(Claims(claimed)) = claimed {
        let first = [("c1", claimed.c1()), ("c2", claimed.c2()), ("l_h", claimed.l_h())];
        let named = first.map(|(name, value)| (name, Some(value)));
        let named = named.into_iter().chain([("m_h", claimed.m_h())]);
        file += "\n[certify.constants]\n";
        for (name, value) in named {
            if let Some(value) = value {
                file += &format!("{name} = {}\n", number(value)?);
            }
        }
    }
    Ok(file)
}

/// Returns a set as a key and its value.
fn union(pieces: &[Shape]) -> PyResult<String> {
    let described: Vec<_> = pieces.iter().flat_map(Shape::described).collect();
    match &described[..] {
        [only] => piece(only),
        all => Ok(format!("union = {}", list(all, |each| Ok(format!("{{ {} }}", piece(each)?)))?)),
    }
}

fn piece((kind, values): &(Kind, Vec<Value>)) -> PyResult<String> {
    let parts = kind.parts.iter().zip(values);
    let parts = parts.map(|(part, value)| Ok((part.name_of(value), part_text(value)?)));
    let parts = parts.collect::<PyResult<Vec<_>>>()?;
    Ok(match &parts[..] {
        [(_, only)] => format!("{} = {only}", kind.key),
        _ => {
            let named: Vec<String> =
                parts.iter().map(|(name, value)| format!("{name} = {value}")).collect();
            format!("{} = {{ {} }}", kind.key, named.join(", "))
        }
    })
}

fn part_text(value: &Value) -> PyResult<String> {
    match value {
        Value::Vector(x) => vector(x),
        Value::Vectors(rows) => list(rows, |row| vector(row)),
        Value::Number(x) | Value::AtMost(x) | Value::AtLeast(x) => number(*x),
    }
}

fn corners([low, high]: [&[f64]; 2]) -> PyResult<String> {
    Ok(format!("{{ lower = {}, upper = {} }}", vector(low)?, vector(high)?))
}

/// Returns numbers as lists of lists, the last axis innermost.
fn array(shape: &[usize], values: &[f64]) -> PyResult<String> {
    match shape {
        [] | [_] => vector(values),
        [length, rest @ ..] => {
            let rows: Vec<&[f64]> = values.chunks((values.len() / length).max(1)).collect();
            list(&rows, |row| array(rest, row))
        }
    }
}

fn vector(x: &[f64]) -> PyResult<String> {
    list(x, |x| number(*x))
}

fn list<T>(items: &[T], written: impl Fn(&T) -> PyResult<String>) -> PyResult<String> {
    let items: Vec<String> = items.iter().map(written).collect::<PyResult<_>>()?;
    Ok(format!("[{}]", items.join(", ")))
}

/// Returns the shortest text that reads back as this number.
fn number(x: f64) -> PyResult<String> {
    if x.is_finite() {
        Ok(format!("{x:?}"))
    } else {
        Err(ProblemError::new_err(format!("the number {x}; an audit takes finite ones")))
    }
}
