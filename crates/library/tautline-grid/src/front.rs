//! `Front`: fast marching over nodes of any arrangement, of first or second order.
//!
//! With Selling's decomposition `H⁻¹ = Σ λₖ eₖ eₖᵀ` the eikonal equation on nodes of distance `h` is
//! `Σ λₖ max(0, u(x) − u(x ± h eₖ))² = h²`. A value depends on smaller values only, so that one pass
//! in increasing order solves all equations. Where two nodes in a row are known, the difference of
//! second order is that of the three values.
//!
//! (J.-M. Mirebeau, *Riemannian fast-marching on Cartesian grids, using Voronoi's first reduction of
//! quadratic forms*, SIAM J. Numer. Anal. 57, 2019.)

use std::{cmp::Reverse, collections::BinaryHeap};

use nalgebra::SMatrix;
use rayon::prelude::*;

use crate::{Ordered, reduction::selling};

/// No node.
const NONE: u32 = u32::MAX;

/// Which differences a march uses.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Order {
    /// Those of two values. The scheme is monotone: larger seeds never lead to smaller values.
    First,
    /// Those of three values, where two nodes in a row are known and the farther one has the smaller
    /// value; otherwise those of two values. More accurate where the distance is smooth, not monotone.
    Second,
}

/// A direction of a node: its weight and the nodes at `+e`, `−e`, `+2e` and `−2e`.
#[derive(Clone, Copy, Debug)]
struct Direction {
    weight: f64,
    nodes: [u32; 4],
}

/// Nodes, with the directions along which each is updated.
#[derive(Clone, Debug)]
pub struct Front {
    spacing: f64,
    directions: Vec<Direction>,
    /// The directions of a node are those from `first[node]` to `first[node + 1]`.
    first: Vec<u32>,
    /// The nodes that are updated from a node, likewise.
    dependents: Vec<u32>,
    first_dependent: Vec<u32>,
}

impl Front {
    /// Prepares the nodes `0` to `count − 1`, fewer than `2³² − 1`, which lie in a lattice of this
    /// spacing.
    ///
    /// `inverse` returns `H⁻¹` at a node, or `None` where there is no metric: such a node is never
    /// reached. `neighbour` returns the node at an offset in steps from a node, if there is one; one beyond
    /// the last is none. In more than three dimensions only the diagonal of `H⁻¹` counts.
    #[must_use]
    pub fn new<const D: usize>(
        count: usize,
        spacing: f64,
        inverse: impl Fn(usize) -> Option<SMatrix<f64, D, D>> + Sync,
        neighbour: impl Fn(usize, &[i32; D]) -> Option<usize> + Sync,
    ) -> Self {
        let of_node = |node: usize| -> Vec<Direction> {
            let at = |e: &[i32; D], k: i32| {
                let other = neighbour(node, &e.map(|along| along * k));
                other.filter(|&other| other < count).map_or(NONE, |other| other as u32)
            };
            let terms = inverse(node).map(|inverse| selling(&inverse)).unwrap_or_default();
            terms
                .into_iter()
                .map(|(e, weight)| Direction { weight, nodes: [1, -1, 2, -2].map(|k| at(&e, k)) })
                .collect()
        };
        let found: Vec<Vec<Direction>> = (0..count).into_par_iter().map(of_node).collect();
        let mut first = vec![0];
        for directions in &found {
            first.push(first[first.len() - 1] + directions.len() as u32);
        }
        let mut first_dependent = vec![0; count + 1];
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
        for n in 0..count {
            first_dependent[n + 1] += first_dependent[n];
        }
        let mut next = first_dependent.clone();
        let mut dependents = vec![0; first_dependent[count] as usize];
        for (n, directions) in found.iter().enumerate() {
            for node in neighbours(directions) {
                dependents[next[node as usize] as usize] = n as u32;
                next[node as usize] += 1;
            }
        }
        Self { spacing, directions: found.concat(), first, dependents, first_dependent }
    }

    /// Returns the distance between neighbouring nodes, in `ℓ`.
    #[must_use]
    pub fn spacing(&self) -> f64 {
        self.spacing
    }

    /// Returns the nodes from which a node is updated: those at `±eₖ`, one step away. A node beyond the last
    /// has none.
    pub fn neighbours(&self, node: usize) -> impl Iterator<Item = usize> + '_ {
        let of_node = self.first.get(node..).and_then(|rest| Some(*rest.first()?..*rest.get(1)?));
        let of_node = of_node.unwrap_or_default();
        let directions = &self.directions[of_node.start as usize..of_node.end as usize];
        let near = directions.iter().flat_map(|direction| [direction.nodes[0], direction.nodes[1]]);
        near.filter(|&other| other != NONE).map(|other| other as usize)
    }

    /// Returns the distances from a set, in `m`, given the values at nodes near it, one for each node.
    ///
    /// Finite values are kept. Nodes with infinite values get theirs, or stay infinite if they are not
    /// reached. A node whose value is NaN is left out: it keeps NaN, and no other node is updated from it.
    ///
    /// # Panics
    ///
    /// If there are not as many values as nodes.
    #[must_use]
    pub fn march(&self, mut values: Vec<f64>, order: Order) -> Vec<f64> {
        assert_eq!(values.len() + 1, self.first.len(), "one value for each node");
        let mut is_known = vec![false; values.len()];
        let mut heap = BinaryHeap::new();
        for (n, &value) in values.iter().enumerate().filter(|(_, value)| value.is_finite()) {
            heap.push(Reverse((Ordered(value), n as u32)));
        }
        // The values of the seeds are final.
        let is_seed: Vec<bool> = values.iter().map(|v| v.is_finite()).collect();
        while let Some(Reverse((Ordered(value), node))) = heap.pop() {
            let node = node as usize;
            if is_known[node] || value > values[node] {
                continue;
            }
            is_known[node] = true;
            let dependents =
                self.first_dependent[node] as usize..self.first_dependent[node + 1] as usize;
            for &other in &self.dependents[dependents] {
                let n = other as usize;
                if is_known[n] || is_seed[n] {
                    continue;
                }
                let value = self.update(n, &values, &is_known, order);
                if value < values[n] {
                    values[n] = value;
                    heap.push(Reverse((Ordered(value), other)));
                }
            }
        }
        values
    }

    /// Solves the equation of a node for its value.
    fn update(&self, node: usize, values: &[f64], is_known: &[bool], order: Order) -> f64 {
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
                Some((near, Some(far))) if order == Order::Second && far <= near => {
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

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;

    use super::{Front, Order};

    /// On a line the distance from the first node is its number.
    #[test]
    fn a_neighbour_beyond_the_last_node_is_none() {
        for beyond in [None, Some(5), Some(usize::MAX)] {
            let neighbour = |node: usize, offset: &[i32; 1]| {
                let other = node as i64 + i64::from(offset[0]);
                usize::try_from(other).ok().filter(|&other| other < 5).or(beyond)
            };
            let front = Front::new(5, 1.0, |_| Some(SMatrix::<f64, 1, 1>::identity()), neighbour);
            let mut seeds = vec![f64::INFINITY; 5];
            seeds[0] = 0.0;
            assert_eq!(front.march(seeds, Order::Second), [0.0, 1.0, 2.0, 3.0, 4.0]);
            assert_eq!(front.neighbours(4).collect::<Vec<_>>(), [3]);
            assert_eq!(front.neighbours(5).count() + front.neighbours(usize::MAX).count(), 0);
        }
    }

    /// Returns 25 nodes in a square, at half a unit from each other, with this diagonal of `H⁻¹`.
    fn square(diagonal: [f64; 2]) -> Front {
        let neighbour = |node: usize, offset: &[i32; 2]| {
            let at = |k: usize, by: i32| usize::try_from(k as i32 + by).ok().filter(|&k| k < 5);
            Some(5 * at(node / 5, offset[0])? + at(node % 5, offset[1])?)
        };
        let inverse = SMatrix::<f64, 2, 2>::from([[diagonal[0], 0.0], [0.0, diagonal[1]]]);
        Front::new(25, 0.5, |_| Some(inverse), neighbour)
    }

    /// From the middle: with weights 4 and 1 along the axes, `4 (u/h)² = 1` beside it along the first one.
    /// Beside two known values, `4 (u − 1/2)² + (u − 1/4)² = 1/4`, whose larger root is `(9 + 4)/20`.
    #[test]
    fn values_solve_the_equation_of_their_node() {
        let front = square([4.0, 1.0]);
        let mut seeds = vec![f64::INFINITY; 25];
        seeds[12] = 0.0;
        for order in [Order::First, Order::Second] {
            let found = front.march(seeds.clone(), order);
            let close = |node: usize, exact: f64| (found[node] - exact).abs() < 1e-14;
            // Straight on, values are added, in both orders.
            assert!(close(17, 0.25) && close(22, 0.5) && close(7, 0.25) && close(2, 0.5));
            assert!(close(13, 0.5) && close(14, 1.0) && close(11, 0.5) && close(10, 1.0));
            assert!([6, 8, 16, 18].into_iter().all(|node| close(node, 0.65)), "{found:?}");
        }
    }

    /// A node whose value is NaN keeps it, and the others are reached around it. A seed keeps its value,
    /// whether larger or smaller than that of a march.
    #[test]
    fn a_node_without_a_number_is_left_out() {
        let front = square([1.0, 1.0]);
        let mut seeds = vec![f64::INFINITY; 25];
        (seeds[12], seeds[13]) = (0.0, f64::NAN);
        for order in [Order::First, Order::Second] {
            let found = front.march(seeds.clone(), order);
            assert!(found[13].is_nan() && found[11] == 0.5);
            assert!((found[14] - 2.0).abs() < 1e-14, "{}", found[14]);
            assert_eq!(found.iter().filter(|value| value.is_nan()).count(), 1);
        }
        seeds[13] = 3.0;
        seeds[11] = 0.125;
        let found = front.march(seeds, Order::First);
        assert_eq!([found[11], found[12], found[13], found[10]], [0.125, 0.0, 3.0, 0.625]);
    }
}
