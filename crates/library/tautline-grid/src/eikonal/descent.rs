//! The descent along `−H⁻¹∇u` to the set from which the distances are.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;
use tautline_metrics::Metric;

use super::{Distances, EikonalError, near};
use crate::{GraphPathError, equal_chords};

/// The length of a step, in steps of the lattice along its longest axis.
const STEP: f64 = 0.5;

/// A step must lower the distance by at least this part of its length.
const LEAST_DESCENT: f64 = 0.25;

/// A path between two sets that descends the distances from the first.
#[derive(Clone, Debug, PartialEq)]
pub struct EikonalPath<const D: usize> {
    distance: f64,
    corners: Vec<(f64, SVector<f64, D>)>,
}

impl<const D: usize> EikonalPath<D> {
    /// Returns the solution of the eikonal equation at the second set, in `m`.
    #[must_use]
    pub fn distance(&self) -> f64 {
        self.distance
    }

    /// Returns the length of the path, in `m`: of its chords, each under `H` at its middle.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.corners.last().map_or(0.0, |last| last.0)
    }

    /// Returns the corners from the first set to the second, in `ℓ`, each with the length up to it, in `m`.
    #[must_use]
    pub fn corners(&self) -> &[(f64, SVector<f64, D>)] {
        &self.corners
    }

    /// Returns `n` chords of equal length along the path.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Chords`] if `n` is 0 or too large.
    pub fn sequence(&self, n: usize) -> Result<PointSequence<D>, GraphPathError> {
        equal_chords(&self.corners, n)
    }
}

/// Returns the path from the set of the distances to a point at this distance.
///
/// Steps are of second order (the midpoint rule). Where the gradient is of no use, on a ridge of the
/// distance or next to nodes that were not reached, the path goes to the neighbouring node along which
/// the distance falls most: each node but the first ones has one from which its value was computed.
pub(super) fn descend<M: Metric<D>, const D: usize>(
    distances: &Distances<'_, M, D>,
    end: SVector<f64, D>,
    distance: f64,
) -> Result<EikonalPath<D>, EikonalError> {
    let metric = distances.equation.metric;
    let lost = |x: &SVector<f64, D>, distance| EikonalError::PathLost {
        point: x.as_slice().to_vec(),
        distance,
    };
    let counts = distances.equation.lattice().counts();
    // A corridor may wind through all nodes, with a few steps beside each.
    let most = 4 * counts.iter().product::<usize>() + 64;
    let (mut points, mut x, mut value) = (vec![end], end, distance);
    while !distances.is_near(&x) {
        if points.len() > most {
            return Err(lost(&x, value));
        }
        let next = step(distances, &x, value).or_else(|| node_below(distances, &x, value));
        let Some(next) = next else { return Err(lost(&x, value)) };
        (x, value) = next;
        points.push(x);
    }
    let (begin, _) = near::chord(metric, distances.set, &x).ok_or_else(|| lost(&x, value))?;
    points.push(begin);
    points.reverse();
    let mut corners = vec![(0.0, begin)];
    for pair in points.windows(2) {
        let length = near::length(metric, &pair[0], &pair[1]);
        let length = length.ok_or_else(|| lost(&pair[1], value))?;
        corners.push((corners[corners.len() - 1].0 + length, pair[1]));
    }
    Ok(EikonalPath { distance, corners })
}

/// Returns the next point along the descent and its distance, if it is low enough.
fn step<M: Metric<D>, const D: usize>(
    distances: &Distances<'_, M, D>,
    x: &SVector<f64, D>,
    value: f64,
) -> Option<(SVector<f64, D>, f64)> {
    let middle = x - distances.direction(x)? * (0.5 * STEP);
    let next = x - distances.direction(&middle)? * STEP;
    let lower = distances.at(&next)?;
    let length = near::length(distances.equation.metric, x, &next)?;
    (value - lower >= LEAST_DESCENT * length).then_some((next, lower))
}

/// Returns the node near a point to which the distance falls most on the way, and its distance.
fn node_below<M: Metric<D>, const D: usize>(
    distances: &Distances<'_, M, D>,
    x: &SVector<f64, D>,
    value: f64,
) -> Option<(SVector<f64, D>, f64)> {
    let (lattice, front) = (distances.equation.lattice(), &distances.equation.front);
    let corners: Vec<usize> = distances.cell(x)?.into_iter().map(|corner| corner.0).collect();
    let beside = corners.iter().flat_map(|&corner| front.neighbours(corner));
    let fall = |node: usize| {
        let (point, lower) = (lattice.point(node), distances.values()[node]);
        let length = near::length(distances.equation.metric, x, &point)?;
        (lower < value && length > 0.0).then(|| ((value - lower) / length, point, lower))
    };
    let falls = corners.iter().copied().chain(beside).filter_map(fall);
    let best = falls.max_by(|a, b| a.0.total_cmp(&b.0))?;
    Some((best.1, best.2))
}
