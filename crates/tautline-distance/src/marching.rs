//! Fast marching: values of a distance at the nodes of cubes, of second order.
//!
//! With Selling's decomposition `H⁻¹ = Σ λₖ eₖ eₖᵀ` the eikonal equation on nodes of distance `h` is
//! `Σ λₖ max(0, u(x) − u(x ± h eₖ))² = h²`. A value depends on smaller values only, so that one pass
//! in increasing order solves all equations. Where two nodes in a row are known, the difference is
//! that of second order.

use std::{
    cmp::Reverse,
    collections::{BinaryHeap, HashMap},
    hash::{BuildHasherDefault, Hasher},
};

use nalgebra::{SMatrix, SVector};
use rayon::prelude::*;
use tautline_check::{Cubes, Place};
use tautline_formula::Formula;
use tautline_metrics::Metric;

use crate::reduction::selling;

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

/// No node.
const NONE: u32 = u32::MAX;

/// A direction of a node: its weight and the nodes at `+e`, `−e`, `+2e` and `−2e`.
#[derive(Clone, Copy, Debug)]
struct Direction {
    weight: f64,
    nodes: [u32; 4],
}

/// The nodes of cubes, with the directions along which each is updated.
#[derive(Debug)]
pub(crate) struct Nodes<const D: usize> {
    spacing: f64,
    places: Vec<Place<D>>,
    index: Index<D>,
    /// The directions of a node are those from `first[node]` to `first[node + 1]`.
    directions: Vec<Direction>,
    first: Vec<u32>,
    /// The nodes that are updated from a node, likewise.
    dependents: Vec<u32>,
    first_dependent: Vec<u32>,
}

impl<const D: usize> Nodes<D> {
    /// Returns the nodes of the cubes, prepared.
    pub(crate) fn new(formula: &Formula<D>, cubes: &Cubes<D>) -> Self {
        let places = cubes.nodes();
        let spacing = 0.5 * cubes.side();
        let index: Index<D> =
            places.iter().enumerate().map(|(n, place)| (*place, n as u32)).collect();
        let of_node = |place: &Place<D>| -> Vec<Direction> {
            let h = gram(formula, &point(place, spacing));
            let Some(inverse) = h.cholesky().map(|factors| factors.inverse()) else {
                return Vec::new();
            };
            let at = |e: &[i32; D], k: i32| {
                let other = std::array::from_fn(|i| place[i] + k * e[i]);
                index.get(&other).copied().unwrap_or(NONE)
            };
            selling(&inverse)
                .into_iter()
                .map(|(e, weight)| Direction { weight, nodes: [1, -1, 2, -2].map(|k| at(&e, k)) })
                .collect()
        };
        let found: Vec<Vec<Direction>> = places.par_iter().map(of_node).collect();
        let mut first = vec![0];
        for directions in &found {
            first.push(first[first.len() - 1] + directions.len() as u32);
        }
        let mut first_dependent = vec![0; places.len() + 1];
        let neighbours = |directions: &[Direction]| -> Vec<u32> {
            let near =
                directions.iter().flat_map(|direction| [direction.nodes[0], direction.nodes[1]]);
            near.filter(|&node| node != NONE).collect()
        };
        for directions in &found {
            for node in neighbours(directions) {
                first_dependent[node as usize + 1] += 1;
            }
        }
        for n in 0..places.len() {
            first_dependent[n + 1] += first_dependent[n];
        }
        let mut next = first_dependent.clone();
        let mut dependents = vec![0; first_dependent[places.len()] as usize];
        for (n, directions) in found.iter().enumerate() {
            for node in neighbours(directions) {
                dependents[next[node as usize] as usize] = n as u32;
                next[node as usize] += 1;
            }
        }
        let directions = found.concat();
        Self { spacing, places, index, directions, first, dependents, first_dependent }
    }

    /// Returns the distance between neighbouring nodes, in `ℓ`.
    pub(crate) fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Returns the points of the nodes.
    pub(crate) fn points(&self) -> Vec<SVector<f64, D>> {
        self.places.iter().map(|place| point(place, self.spacing)).collect()
    }

    /// Returns the distances from a set, given the values at nodes near it and in it. All other nodes
    /// have infinite values; those that are not reached get the largest one.
    pub(crate) fn march(&self, mut values: Vec<f64>) -> Vec<f64> {
        let mut is_known = vec![false; self.places.len()];
        let mut heap = BinaryHeap::new();
        for (n, &value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
            heap.push(Reverse((Ordered(value), n as u32)));
        }
        // The values of the seeds are final.
        let is_seed: Vec<bool> = values.iter().map(|v| v.is_finite()).collect();
        let mut largest = 0.0_f64;
        while let Some(Reverse((Ordered(value), node))) = heap.pop() {
            let node = node as usize;
            if is_known[node] || value > values[node] {
                continue;
            }
            is_known[node] = true;
            largest = largest.max(value);
            let dependents =
                self.first_dependent[node] as usize..self.first_dependent[node + 1] as usize;
            for &other in &self.dependents[dependents] {
                let n = other as usize;
                if is_known[n] || is_seed[n] {
                    continue;
                }
                let value = self.update(n, &values, &is_known);
                if value < values[n] {
                    values[n] = value;
                    heap.push(Reverse((Ordered(value), other)));
                }
            }
        }
        for value in values.iter_mut().filter(|value| !value.is_finite()) {
            *value = largest;
        }
        values
    }

    /// Returns the value at a place of the nodes.
    pub(crate) fn value(&self, values: &[f64], place: &Place<D>) -> Option<f64> {
        self.index.get(place).map(|&n| values[n as usize])
    }

    /// Solves the equation of a node for its value.
    fn update(&self, node: usize, values: &[f64], is_known: &[bool]) -> f64 {
        let known =
            |node: u32| (node != NONE && is_known[node as usize]).then(|| values[node as usize]);
        let directions = self.first[node] as usize..self.first[node + 1] as usize;
        // The terms w (u − m)².
        let mut terms: Vec<(f64, f64)> = Vec::with_capacity(6);
        for direction in &self.directions[directions] {
            let sides = [(0, 2), (1, 3)]
                .map(|(near, far)| (known(direction.nodes[near]), known(direction.nodes[far])));
            let smaller = sides
                .into_iter()
                .filter_map(|(near, far)| Some((near?, far)))
                .min_by(|a, b| a.0.total_cmp(&b.0));
            match smaller {
                Some((near, Some(far))) if far <= near => {
                    terms.push(((4.0 * near - far) / 3.0, 2.25 * direction.weight));
                }
                Some((near, _)) => terms.push((near, direction.weight)),
                None => {}
            }
        }
        terms.sort_unstable_by(|a, b| a.0.total_cmp(&b.0));
        let Some(&(least, _)) = terms.first() else { return f64::INFINITY };
        let (mut a, mut b, mut c) = (0.0, 0.0, -self.spacing * self.spacing);
        let mut value = f64::INFINITY;
        for (m, weight) in terms {
            let m = m - least;
            if m >= value {
                break;
            }
            a += weight;
            b += weight * m;
            c += weight * m * m;
            value = (b + (b * b - a * c).max(0.0).sqrt()) / a;
        }
        least + value
    }
}

/// A number with the order of [`f64::total_cmp`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Ordered(pub(crate) f64);

impl Eq for Ordered {}

impl PartialOrd for Ordered {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Ordered {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
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
