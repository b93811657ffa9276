//! The text of a problem file, for the programs that read one.

use pyo3::prelude::*;
use tautline::RecordError;
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
    for (k, Spline { spline }) in called(given)?.into_iter().enumerate() {
        let values = array(spline.shape(), spline.coefficients())?;
        file += &format!("\n[tables.table{}]\nvalues = {values}\n", k + 1);
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
    match pieces {
        [only] => piece(only),
        _ => Ok(format!("union = {}", list(pieces, |each| Ok(format!("{{ {} }}", piece(each)?)))?)),
    }
}

fn piece(shape: &Shape) -> PyResult<String> {
    let round = |centre: &[f64], radius: f64| -> PyResult<String> {
        Ok(format!("{{ centre = {}, radius = {} }}", vector(centre)?, number(radius)?))
    };
    Ok(match shape {
        Shape::Point(point) => format!("point = {}", vector(point.position_slice())?),
        Shape::FiniteSet(set) => {
            format!("points = {}", list(set.points(), |point| vector(point.position_slice()))?)
        }
        Shape::Ball(ball) => format!("ball = {}", round(ball.centre_slice(), ball.r())?),
        Shape::Sphere(sphere) => format!("sphere = {}", round(sphere.centre_slice(), sphere.r())?),
        Shape::AxisBox(side) => format!("box = {}", corners(side.corner_slices())?),
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given_slice();
            let (normal, offset) = (vector(normal)?, number(offset)?);
            format!("half_space = {{ normal = {normal}, at_most = {offset} }}")
        }
        Shape::Segment(segment) => {
            let [start, end] = segment.end_slices();
            format!("segment = {{ from = {}, to = {} }}", vector(start)?, vector(end)?)
        }
        Shape::AffineSubspace(subspace) => {
            let directions = list(subspace.given_slices(), |row| vector(row))?;
            let through = vector(subspace.base_slice())?;
            format!("affine = {{ through = {through}, directions = {directions} }}")
        }
        Shape::Union(shapes) => union(shapes)?,
    })
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
