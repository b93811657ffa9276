//! Fast marching at the nodes of cubes.

use std::{
    collections::HashMap,
    hash::{BuildHasherDefault, Hasher},
};

use nalgebra::{SMatrix, SVector};
use tautline_check::{Cubes, Place};
use tautline_formula::Formula;
use tautline_grid::{Front, Order};
use tautline_metrics::Metric;

/// The numbers of the nodes.
type Index<const D: usize> = HashMap<Place<D>, u32, BuildHasherDefault<PlaceHasher>>;

/// A hasher for places, whose coordinates need no protection from an adversary.
#[derive(Debug, Default)]
struct PlaceHasher(u64);

impl Hasher for PlaceHasher {
    fn write(&mut self, bytes: &[u8]) {
        for chunk in bytes.chunks(4) {
            let mut word = [0; 4];
            word[..chunk.len()].copy_from_slice(chunk);
            self.write_u32(u32::from_le_bytes(word));
        }
    }

    fn write_u32(&mut self, word: u32) {
        self.0 = (self.0.rotate_left(5) ^ u64::from(word)).wrapping_mul(0x9e37_79b9_7f4a_7c15);
    }

    fn write_i32(&mut self, word: i32) {
        self.write_u32(word as u32);
    }

    fn write_usize(&mut self, _: usize) {
        // The length of an array says nothing.
    }

    fn finish(&self) -> u64 {
        self.0 ^ (self.0 >> 32)
    }
}

/// The nodes of cubes, with the directions along which each is updated.
#[derive(Debug)]
pub(crate) struct Nodes<const D: usize> {
    places: Vec<Place<D>>,
    index: Index<D>,
    front: Front,
}

impl<const D: usize> Nodes<D> {
    /// Returns the nodes of the cubes, prepared.
    pub(crate) fn new(formula: &Formula<D>, cubes: &Cubes<D>) -> Self {
        let places = cubes.nodes();
        let spacing = 0.5 * cubes.side();
        let index: Index<D> =
            places.iter().enumerate().map(|(n, place)| (*place, n as u32)).collect();
        let inverse = |node: usize| {
            let h = metric(formula, &point(&places[node], spacing))?;
            h.cholesky().map(|factors| factors.inverse())
        };
        let neighbour = |node: usize, offset: &[i32; D]| {
            let other: Place<D> = std::array::from_fn(|i| places[node][i] + offset[i]);
            index.get(&other).map(|&n| n as usize)
        };
        let front = Front::new(places.len(), spacing, inverse, neighbour);
        Self { places, index, front }
    }

    /// Returns the distance between neighbouring nodes, in `ℓ`.
    pub(crate) fn spacing(&self) -> f64 {
        self.front.spacing()
    }

    /// Returns the points of the nodes.
    pub(crate) fn points(&self) -> Vec<SVector<f64, D>> {
        self.places.iter().map(|place| point(place, self.spacing())).collect()
    }

    /// Returns the distances from a set, of second order, given the values at nodes near it and in it. All
    /// other nodes have infinite values. All values returned are finite; there are none if none is given.
    ///
    /// Some nodes are not reached. Near the boundary of the cubes a node may lack all neighbours from
    /// which it is updated: it gets the length of the shortest chord from a node around it that has a
    /// value, added to that value. Where there is no metric, nothing can be proved of the cubes around
    /// a node, and the fewer levels they meet, the less is lost: it gets the greatest value of the
    /// nodes around it. Nodes that are not connected with any seed get the largest value of all.
    pub(crate) fn march(&self, formula: &Formula<D>, values: Vec<f64>) -> Option<Vec<f64>> {
        let mut values = self.front.march(values, Order::Second);
        let finite = values.iter().copied().filter(|value| value.is_finite());
        let largest = finite.reduce(f64::max)?;
        let mut left: Vec<usize> = (0..values.len()).filter(|&n| !values[n].is_finite()).collect();
        // Layer by layer: what a layer gets depends on the layers before it, not on the order in it.
        while !left.is_empty() {
            let found: Vec<(usize, f64)> = left
                .iter()
                .filter_map(|&n| Some((n, self.value_around(formula, &values, n)?)))
                .collect();
            if found.is_empty() {
                break;
            }
            for (n, value) in found {
                values[n] = value;
            }
            left.retain(|&n| !values[n].is_finite());
        }
        for n in left {
            values[n] = largest;
        }
        Some(values)
    }

    /// Returns a value for a node that was not reached, from those of the nodes around it; `None` if none
    /// of them has one.
    fn value_around(&self, formula: &Formula<D>, values: &[f64], node: usize) -> Option<f64> {
        let place = &self.places[node];
        let around = (0..3_usize.pow(D as u32)).filter_map(|at| {
            let step: [i32; D] =
                std::array::from_fn(|i| (at / 3_usize.pow(i as u32) % 3) as i32 - 1);
            let value = self.value(values, &std::array::from_fn(|i| place[i] + step[i]))?;
            value
                .is_finite()
                .then_some((value, SVector::from(step.map(f64::from)) * self.spacing()))
        });
        match metric(formula, &point(place, self.spacing())) {
            Some(h) => {
                around.map(|(value, chord)| value + chord.dot(&(h * chord)).sqrt()).reduce(f64::min)
            }
            None => around.map(|(value, _)| value).reduce(f64::max),
        }
    }

    /// Returns the value at a place of the nodes.
    pub(crate) fn value(&self, values: &[f64], place: &Place<D>) -> Option<f64> {
        self.index.get(place).map(|&n| values[n as usize])
    }
}

/// Returns the point at a place of the lattice.
pub(crate) fn point<const D: usize>(place: &Place<D>, spacing: f64) -> SVector<f64, D> {
    SVector::from(place.map(|k| f64::from(k) * spacing))
}

/// Returns `H` at a point, from its entries on and above the diagonal.
pub(crate) fn gram<const D: usize>(
    formula: &Formula<D>,
    x: &SVector<f64, D>,
) -> SMatrix<f64, D, D> {
    let h = formula.gram(x);
    SMatrix::from_fn(|i, j| h[(i.min(j), i.max(j))])
}

/// Returns `H` at a point; `None` where it is undefined, infinite or not positive definite.
pub(crate) fn metric<const D: usize>(
    formula: &Formula<D>,
    x: &SVector<f64, D>,
) -> Option<SMatrix<f64, D, D>> {
    let h = gram(formula, x);
    // An infinite pivot passes for a positive one.
    (h.iter().all(|entry| entry.is_finite()) && h.cholesky().is_some()).then_some(h)
}

#[cfg(test)]
mod tests;
