//! Fast marching at the nodes of cubes.

use std::{
    collections::HashMap,
    hash::{BuildHasherDefault, Hasher},
};

use nalgebra::{SMatrix, SVector};
use tautline_check::{Cubes, Place};
use tautline_formula::Formula;
use tautline_metrics::Metric;

use crate::front::{Front, Order};

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
            let h = gram(formula, &point(&places[node], spacing));
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
    /// other nodes have infinite values; those that are not reached get the largest one.
    pub(crate) fn march(&self, values: Vec<f64>) -> Vec<f64> {
        let mut values = self.front.march(values, Order::Second);
        let finite = values.iter().copied().filter(|value| value.is_finite());
        let largest = finite.fold(0.0, f64::max);
        for value in values.iter_mut().filter(|value| !value.is_finite()) {
            *value = largest;
        }
        values
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

#[cfg(test)]
mod tests;
