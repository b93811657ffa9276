//! The steps of a proof, in the dimensions that certificates have.
//!
//! A generic function that another crate calls is compiled in that crate, once more for each dimension. Here
//! its arguments are pointers to values of some type, and the dimension chooses the function that knows
//! the type: what is heavy is compiled in this crate alone. A value of another type than the dimension says
//! would be a panic, not a proof.

use std::any::Any;

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    CheckError, Cubes, Level, Region,
    polygon::length_within,
    sweep::{Sweep, Swept},
    work::Work,
};

/// Calls a function with the dimension as its parameter.
macro_rules! in_dimension {
    ($d:expr, $function:ident($($argument:expr),*)) => {
        match $d {
            1 => $function::<1>($($argument),*),
            2 => $function::<2>($($argument),*),
            3 => $function::<3>($($argument),*),
            4 => $function::<4>($($argument),*),
            dimension => Err(CheckError::Dimension { dimension }),
        }
    };
}

fn known<T: Any>(value: &dyn Any) -> &T {
    value.downcast_ref().expect("the type that the dimension says")
}

fn known_sets<const D: usize>([first, second]: [&dyn Any; 2]) -> [&Shape<D>; 2] {
    [known(first), known(second)]
}

/// The lengths of a proof, in `m`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Lengths {
    /// Curves that are at least as long are not followed.
    pub(crate) hi: f64,
    /// Cubes are kept that shorter curves may meet, at least `hi`.
    pub(crate) keep: f64,
}

/// Tests the simplices of a level. If it is the `first` one, also proves that no short curve leaves it.
pub(crate) fn sweep<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    level: &Level<D>,
    lengths: Lengths,
    first: Option<Region>,
    work: &Work<'_>,
) -> Result<Swept<D>, CheckError> {
    let sets = sets.map(|set| set as &dyn Any);
    let swept = sweep_any(D, formula, sets, level, lengths, first, work)?;
    Ok(*swept.downcast().expect("the type that the dimension says"))
}

fn sweep_any(
    d: usize,
    formula: &dyn Any,
    sets: [&dyn Any; 2],
    level: &dyn Any,
    lengths: Lengths,
    first: Option<Region>,
    work: &Work<'_>,
) -> Result<Box<dyn Any>, CheckError> {
    fn sweep_in<const D: usize>(
        formula: &dyn Any,
        sets: [&dyn Any; 2],
        level: &dyn Any,
        Lengths { hi, keep }: Lengths,
        first: Option<Region>,
        work: &Work<'_>,
    ) -> Result<Box<dyn Any>, CheckError> {
        let sets = known_sets::<D>(sets);
        let sweep = Sweep::<D>::new(known(formula), sets, known(level), work)?;
        if let Some(region) = first {
            region.prove_exit(sets, hi, &sweep)?;
        }
        Ok(Box::new(sweep.shorter_than(keep)?))
    }
    in_dimension!(d, sweep_in(formula, sets, level, lengths, first, work))
}

/// Proves the constant of a region, see [`Region::prove`].
pub(crate) fn prove_region<const D: usize>(
    region: Region,
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    hi: f64,
    work: &Work<'_>,
) -> Result<(), CheckError> {
    prove_region_any(D, region, formula, sets.map(|set| set as &dyn Any), hi, work)
}

fn prove_region_any(
    d: usize,
    region: Region,
    formula: &dyn Any,
    sets: [&dyn Any; 2],
    hi: f64,
    work: &Work<'_>,
) -> Result<(), CheckError> {
    fn prove_in<const D: usize>(
        region: Region,
        formula: &dyn Any,
        sets: [&dyn Any; 2],
        hi: f64,
        work: &Work<'_>,
    ) -> Result<(), CheckError> {
        region.prove_within::<D>(known(formula), known_sets(sets), hi, work)
    }
    in_dimension!(d, prove_in(region, formula, sets, hi, work))
}

/// Returns the cubes that the first level has to contain, see [`Region::required`].
pub(crate) fn required<const D: usize>(
    region: Region,
    sets: [&Shape<D>; 2],
    hi: f64,
    limits: (i32, usize, &Work<'_>),
) -> Result<Cubes<D>, CheckError> {
    let cubes = required_any(D, region, sets.map(|set| set as &dyn Any), hi, limits)?;
    Ok(*cubes.downcast().expect("the type that the dimension says"))
}

fn required_any(
    d: usize,
    region: Region,
    sets: [&dyn Any; 2],
    hi: f64,
    limits: (i32, usize, &Work<'_>),
) -> Result<Box<dyn Any>, CheckError> {
    fn required_in<const D: usize>(
        region: Region,
        sets: [&dyn Any; 2],
        hi: f64,
        limits: (i32, usize, &Work<'_>),
    ) -> Result<Box<dyn Any>, CheckError> {
        Ok(Box::new(region.required_within::<D>(known_sets(sets), hi, limits)?))
    }
    in_dimension!(d, required_in(region, sets, hi, limits))
}

/// Returns an upper bound on the length of a polygon, see [`length_above`](crate::length_above).
pub(crate) fn length<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    points: &[SVector<f64, D>],
    work: &Work<'_>,
) -> Result<f64, CheckError> {
    let coordinates: Vec<f64> = points.iter().flatten().copied().collect();
    length_any(D, formula, sets.map(|set| set as &dyn Any), &coordinates, work)
}

fn length_any(
    d: usize,
    formula: &dyn Any,
    sets: [&dyn Any; 2],
    coordinates: &[f64],
    work: &Work<'_>,
) -> Result<f64, CheckError> {
    fn length_in<const D: usize>(
        formula: &dyn Any,
        sets: [&dyn Any; 2],
        coordinates: &[f64],
        work: &Work<'_>,
    ) -> Result<f64, CheckError> {
        let points = coordinates.chunks_exact(D).map(SVector::from_column_slice);
        let points: Vec<SVector<f64, D>> = points.collect();
        length_within::<D>(known(formula), known_sets(sets), &points, work)
    }
    in_dimension!(d, length_in(formula, sets, coordinates, work))
}
