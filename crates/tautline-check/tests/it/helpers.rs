//! Certificates made of functions.

use nalgebra::SVector;
use tautline_check::{Certificate, Cubes, Level, Region};
use tautline_formula::Formula;
use tautline_sets::{Point, Shape};

/// A function on `R^D`.
pub(crate) type Function<'f, const D: usize> = &'f dyn Fn(&SVector<f64, D>) -> f64;

/// Returns the set of one point.
pub(crate) fn point<const D: usize>(x: [f64; D]) -> Shape<D> {
    Shape::Point(Point::new(x).expect("finite"))
}

/// Returns the level with the values of two functions at the nodes.
pub(crate) fn level<const D: usize>(
    number: usize,
    cubes: &Cubes<D>,
    functions: [Function<'_, D>; 2],
) -> Level<D> {
    let half = 0.5 * cubes.side();
    let at = |place: &[i32; D]| SVector::from(place.map(|k| f64::from(k) * half));
    let values = functions.map(|f| cubes.nodes().iter().map(|node| f(&at(node))).collect());
    Level::new(number, cubes.clone(), values).expect("one value for each node")
}

/// Returns a certificate with one level of the cubes that the region requires.
pub(crate) fn one_level<const D: usize>(
    formula: Formula<D>,
    sets: [Shape<D>; 2],
    hi: f64,
    region: Region,
    exponent: i32,
    functions: [Function<'_, D>; 2],
) -> Certificate<D> {
    let cubes = region.required(sets.each_ref(), hi, exponent).expect("a region");
    let levels = vec![level(0, &cubes, functions)];
    Certificate { formula, sets, hi, region, curve: None, levels }
}
