//! `Neighbourhood`: the cubes near a set, by about their distances from it.

use std::{
    cmp::Reverse,
    collections::{BinaryHeap, HashMap},
};

use nalgebra::{SMatrix, SVector};
use tautline_check::{Cubes, Place};
use tautline_formula::Formula;
use tautline_grid::Ordered;
use tautline_sets::Shape;

use crate::{marching::metric, seed::seed};

/// Cubes near a set.
#[derive(Clone, Debug)]
pub(crate) struct Neighbourhood<const D: usize> {
    /// About the distances of their nearest corners, nearest first.
    nearest: Vec<f64>,
    cubes: Vec<Place<D>>,
    seeds: Vec<Place<D>>,
    /// All cubes within this distance are there.
    reach: f64,
}

impl<const D: usize> Neighbourhood<D> {
    /// Returns the cubes within `reach` of a set, which meets those of `seeds`, but at most `most`, and
    /// none behind cubes whose centre is an `end`.
    ///
    /// The distances are those along paths from centre to centre, so that they are some percent too
    /// large, less half a diagonal. No path leads through a centre without a metric.
    pub(crate) fn new(
        formula: &Formula<D>,
        (set, seeds): (&Shape<D>, &Cubes<D>),
        mut reach: f64,
        most: usize,
        end: impl Fn(&SVector<f64, D>) -> bool,
    ) -> Self {
        let side = seeds.side();
        let steps = steps::<D>();
        let centre = |place: &Place<D>| SVector::from(place.map(|k| (f64::from(k) + 0.5) * side));
        let half =
            |h: &Option<SMatrix<f64, D, D>>| h.map_or(0.0, |h| 0.5 * side * h.trace().sqrt());
        let mut known: HashMap<Place<D>, (f64, Option<SMatrix<f64, D, D>>)> = HashMap::new();
        let mut heap = BinaryHeap::new();
        for place in seeds.places() {
            let x = centre(place);
            let h = metric(formula, &x);
            // Without a metric at its centre the cube still meets the set, at the distance 0.
            let value = seed(formula, set, side * D as f64, &x).map_or(0.0, |value| value.max(0.0));
            known.insert(*place, (value, h));
            heap.push(Reverse((Ordered(value - half(&h)), *place)));
        }
        let mut cubes = Vec::new();
        // By the distances of the nearest corners: far away, cubes may be short and very many. So a path
        // to a cube that was taken from the heap may become shorter, and the cube is taken once more.
        while let Some(Reverse((Ordered(nearest), place))) = heap.pop() {
            let (value, h) = known[&place];
            if nearest > value - half(&h) {
                continue;
            }
            if cubes.len() == most || !nearest.is_finite() {
                reach = nearest;
                break;
            }
            cubes.push((nearest, place));
            if end(&centre(&place)) {
                continue;
            }
            for step in &steps {
                let other: Place<D> = std::array::from_fn(|i| place[i].saturating_add(step[i]));
                let (known, beyond) = known
                    .entry(other)
                    .or_insert_with(|| (f64::INFINITY, metric(formula, &centre(&other))));
                let Some(there) = *beyond else { continue };
                let chord = SVector::from(step.map(f64::from)) * side;
                let length = |h: &SMatrix<f64, D, D>| chord.dot(&(h * chord)).sqrt();
                let value = value + 0.5 * (length(&h.unwrap_or(there)) + length(&there));
                let nearest = value - half(beyond);
                if value < *known && nearest <= reach {
                    *known = value;
                    heap.push(Reverse((Ordered(nearest), other)));
                }
            }
        }
        cubes.sort_by(|a: &(f64, _), b| a.0.total_cmp(&b.0));
        let (nearest, cubes) = cubes.into_iter().unzip();
        Self { nearest, cubes, seeds: seeds.places().to_vec(), reach }
    }

    /// Returns the places of the cubes that the set meets.
    pub(crate) fn seeds(&self) -> &[Place<D>] {
        &self.seeds
    }

    /// Returns the places of the cubes within this distance; `None` if some are not there.
    pub(crate) fn within(&self, reach: f64) -> Option<&[Place<D>]> {
        let past = self.nearest.partition_point(|&value| value <= reach);
        (reach <= self.reach).then(|| &self.cubes[..past])
    }
}

/// Returns the steps to neighbours and, in the plane, those of a knight.
fn steps<const D: usize>() -> Vec<[i32; D]> {
    let far = if D == 2 { 2 } else { 1 };
    let width = 2 * far as usize + 1;
    let all = (0..width.pow(D as u32)).map(|mut at| {
        std::array::from_fn(|_| {
            let step = (at % width) as i32 - far;
            at /= width;
            step
        })
    });
    // Without multiples of shorter steps.
    all.filter(|step: &[i32; D]| step.iter().any(|k| k.abs() == 1)).collect()
}

#[cfg(test)]
mod tests {
    use tautline_check::Cubes;
    use tautline_formula::Formula;
    use tautline_sets::{Point, Shape};

    use super::Neighbourhood;

    /// Under a constant metric, paths of steps are at most 3 % too long in the plane (a direction between
    /// (1, 0) and (2, 1)). All cubes within reach are there.
    #[test]
    fn distances_are_a_little_too_large() {
        let flat = Formula::<2>::parse("4 I", &[]).expect("a formula");
        let seeds = Cubes::new(0, vec![[3, -2]]).expect("in range");
        let centre = Shape::Point(Point::new([3.5, -1.5]).expect("finite"));
        let near = Neighbourhood::new(&flat, (&centre, &seeds), 20.0, 1000, |_| false);
        let found = near.within(20.0).expect("few cubes");
        for (value, [i, j]) in near.nearest.iter().zip(found) {
            // Half a diagonal is √2.
            let exact = 2.0 * f64::from(i - 3).hypot(f64::from(j + 2)) - 2_f64.sqrt();
            assert!(
                *value >= exact - 1e-12 && *value <= 1.03 * exact + 0.05,
                "{value} for {exact}"
            );
        }
        let within = |reach: f64| {
            let offsets = (-12..=12).flat_map(|i| (-12..=12).map(move |j| (i, j)));
            let corner = |(i, j): (i32, i32)| 2.0 * f64::from(i).hypot(f64::from(j)) - 2_f64.sqrt();
            offsets.filter(|&cube| corner(cube) <= reach).count()
        };
        assert!(found.len() <= within(20.0) && found.len() >= within(20.0 / 1.03 - 0.05));
        assert!(near.nearest.is_sorted());
        // Of a hundred cubes, all within a smaller distance are known to be there.
        let few = Neighbourhood::new(&flat, (&centre, &seeds), 20.0, 100, |_| false);
        assert!(few.within(20.0).is_none());
        assert_eq!(few.within(8.0).map(<[_]>::len), near.within(8.0).map(<[_]>::len));
    }

    /// Behind an end there are no cubes. The nearest corner of the cube at `−9` is 9 away,
    /// that of the one at `−8` is 8 away.
    #[test]
    fn nothing_lies_behind_an_end() {
        let flat = Formula::<1>::parse("1 I", &[]).expect("a formula");
        let seeds = Cubes::new(0, vec![[0]]).expect("in range");
        let origin = Shape::Point(Point::new([0.0]).expect("finite"));
        let near = Neighbourhood::new(&flat, (&origin, &seeds), 8.5, 100, |x| x[0] > 3.0);
        let found = near.within(8.5).expect("few cubes");
        let greatest = found.iter().map(|[i]| *i).max();
        let least = found.iter().map(|[i]| *i).min();
        assert_eq!((least, greatest), (Some(-8), Some(3)));
    }
}
