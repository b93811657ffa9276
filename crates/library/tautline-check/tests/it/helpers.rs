//! Certificates made of functions.

use std::collections::BTreeSet;

use nalgebra::SVector;
use tautline_check::{Certificate, Chain, CheckError, Cubes, Level, Place, Proved, Region};
use tautline_formula::Formula;
use tautline_sets::{AxisBox, Point, Shape};

/// A function on `R^D`.
pub(crate) type Function<'f, const D: usize> = &'f dyn Fn(&SVector<f64, D>) -> f64;

/// Returns the set of one point.
pub(crate) fn point<const D: usize>(x: [f64; D]) -> Shape<D> {
    Shape::Point(Point::new(x).expect("finite"))
}

/// Returns the box with these corners.
pub(crate) fn axis_box<const D: usize>(lower: [f64; D], upper: [f64; D]) -> Shape<D> {
    Shape::AxisBox(AxisBox::from_corners(lower, upper).expect("corners in order"))
}

/// Returns the formula of a text.
pub(crate) fn formula<const D: usize>(text: &str) -> Formula<D> {
    Formula::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"))
}

/// Returns the points of the nodes of cubes.
pub(crate) fn points<const D: usize>(cubes: &Cubes<D>) -> Vec<SVector<f64, D>> {
    let half = 0.5 * cubes.side();
    cubes.nodes().iter().map(|node| SVector::from(node.map(|k| f64::from(k) * half))).collect()
}

/// Returns the level with the values of two functions at the nodes.
pub(crate) fn level<const D: usize>(
    number: usize,
    cubes: &Cubes<D>,
    functions: [Function<'_, D>; 2],
) -> Level<D> {
    let points = points(cubes);
    let values = functions.map(|f| points.iter().map(f).collect());
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
    several_levels(formula, sets, hi, region, &[exponent], functions)
}

/// Checks a certificate with one level of these cubes, whether or not the region requires others.
pub(crate) fn on_cubes<const D: usize>(
    metric: &str,
    sets: [Shape<D>; 2],
    hi: f64,
    region: Region,
    exponent: i32,
    places: &[Place<D>],
    functions: [Function<'_, D>; 2],
) -> Result<Proved<D>, CheckError> {
    let cubes = Cubes::new(exponent, places.to_vec()).expect("in range");
    let levels = vec![level(0, &cubes, functions)];
    Certificate { formula: formula(metric), sets, hi, region, curve: None, levels }.check()
}

/// Returns a certificate with levels of these exponents, each on the cubes that are required.
pub(crate) fn several_levels<const D: usize>(
    formula: Formula<D>,
    sets: [Shape<D>; 2],
    hi: f64,
    region: Region,
    exponents: &[i32],
    functions: [Function<'_, D>; 2],
) -> Certificate<D> {
    let first = region.required(sets.each_ref(), hi, exponents[0]).expect("a region");
    levels_from(first, formula, sets, hi, region, exponents, functions)
        .unwrap_or_else(|error| panic!("{error}"))
}

/// Returns a certificate whose first level has these cubes, with further levels.
pub(crate) fn levels_from<const D: usize>(
    first: Cubes<D>,
    formula: Formula<D>,
    sets: [Shape<D>; 2],
    hi: f64,
    region: Region,
    exponents: &[i32],
    functions: [Function<'_, D>; 2],
) -> Result<Certificate<D>, CheckError> {
    let mut levels = Vec::new();
    let mut chain = Chain::new(&formula, &sets, hi, region)?;
    for &exponent in exponents {
        let cubes = match levels.len() {
            0 => first.clone(),
            _ => chain.required(exponent)?,
        };
        let level = level(levels.len(), &cubes, functions);
        chain.add(&level, hi)?;
        levels.push(level);
    }
    Ok(Certificate { formula, sets, hi, region, curve: None, levels })
}

/// Returns the cubes with a corner where `near` holds that are connected to the one of `start`.
pub(crate) fn flood<const D: usize>(
    exponent: i32,
    start: &SVector<f64, D>,
    near: impl Fn(&SVector<f64, D>) -> bool,
) -> Cubes<D> {
    let side = 2.0_f64.powi(exponent);
    let mut left = vec![std::array::from_fn(|i| (start[i] / side).floor() as i32)];
    let mut found: BTreeSet<[i32; D]> = left.iter().copied().collect();
    while let Some(place) = left.pop() {
        let corner = |at: usize| {
            SVector::from_fn(|i, _| (f64::from(place[i]) + (at >> i & 1) as f64) * side)
        };
        if !(0..1 << D).any(|at| near(&corner(at))) {
            continue;
        }
        for (axis, step) in (0..D).flat_map(|axis| [(axis, -1), (axis, 1)]) {
            let mut beside = place;
            beside[axis] += step;
            if found.insert(beside) {
                left.push(beside);
            }
        }
    }
    Cubes::new(exponent, found.into_iter().collect()).expect("in range")
}

/// Returns what the certificate proves.
pub(crate) fn proved<const D: usize>(certificate: &Certificate<D>) -> Proved<D> {
    certificate.check().unwrap_or_else(|error| panic!("{error}"))
}

/// Returns the lower bound, or 0 if the certificate is refused.
pub(crate) fn lower<const D: usize>(checked: &Result<Proved<D>, CheckError>) -> f64 {
    checked.as_ref().map_or(0.0, |proved| proved.lower)
}

/// Asserts that no more than a distance is proved, if anything is.
pub(crate) fn proves_at_most<const D: usize>(checked: &Result<Proved<D>, CheckError>, d: f64) {
    // The distance is rounded.
    assert!(lower(checked) <= d * (1.0 + 1e-14), "{checked:?}, and the distance is {d}");
}

/// Returns whether all points lie in a kept cube.
pub(crate) fn keeps<const D: usize>(proved: &Proved<D>, curve: &[SVector<f64, D>]) -> bool {
    let side = proved.corridor.side();
    curve.iter().all(|x| {
        // A point on a face belongs to the cubes on both sides.
        let near = |place: &[i32; D]| {
            (0..D).all(|i| (x[i] / side - f64::from(place[i]) - 0.5).abs() <= 0.5 + 1e-9)
        };
        proved.corridor.places().iter().any(near)
    })
}
