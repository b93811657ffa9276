//! `collocate`: damped Newton steps on a mesh that is refined where the residual is large.

use nalgebra::SVector;
use tautline::{Ends, LARGEST_N, Metric, PointSequence, check_gram};

use super::{
    Collocation, CollocationError,
    gauss::{STAGES, Table},
    path::{Path, larger},
    system::{Defects, System, defects},
};
use crate::{
    EquationError,
    geodesic_equation::in_range,
    normal_map::{NormalMap, nearby},
    not_finite::finite,
};

/// Newton's method has converged if its step, relative to the distance of the farthest node from the
/// first, is at most this. It converges quadratically, so that another step would be of the size of rounding.
const SMALL: f64 = 1e-9;

/// A geodesic that was found by collocation.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub struct Collocated<const D: usize> {
    /// The curve.
    pub path: Path<D>,
    /// Its energy `∫ γ̇ᵀHγ̇ dt`, in `m²`.
    pub energy: f64,
    /// Its length, in `m`.
    pub length: f64,
    /// The largest residual `|γ̈ − a(γ, γ̇)|` of the geodesic equation at the ends and in
    /// the middle of the intervals, relative to the largest `|γ̇|`: a pure number. What the metric does
    /// between all these points goes unseen.
    pub residual: f64,
    /// The number of Newton steps on all meshes.
    pub iterations: usize,
}

/// Returns a geodesic between two closed sets that is normal to both, by collocation.
///
/// The curve is a continuously differentiable piecewise polynomial of degree 5. It satisfies the
/// geodesic equation at the four Gauss points of each interval of a mesh, so that its nodes have
/// errors of the order 8 in the length of an interval (C. de Boor, B. Swartz, Collocation at
/// Gaussian points, SIAM J. Numer. Anal. 10 (1973)). The equations are solved by Newton's method,
/// damped by the natural monotonicity test (P. Deuflhard, *Newton Methods for Nonlinear Problems*,
/// 2004), with the stages and the velocities of each interval eliminated. Intervals in which the
/// residual exceeds the tolerance are divided, and the equations solved again.
///
/// As in [`shoot`](crate::shooting::shoot()), each end with its velocity is given by a point of
/// `R^D` through the nearest-point map of its set. Sets of several pieces are searched along one
/// branch of these maps.
///
/// The result is a geodesic, but need not be minimal: that depends on the start.
///
/// # Errors
///
/// - [`CollocationError::Tolerance`] and [`CollocationError::NoIntervals`] for such input, and
///   [`CollocationError::NotFinite`] if a nearest point has such a coordinate;
/// - [`CollocationError::LeavesTheDomain`] if the metric makes no geodesic equation at an end or a
///   Gauss point of the start, or at a sample of the residual of a solution;
/// - [`CollocationError::Energy`] if the energy overflows or underflows;
/// - [`CollocationError::NoConvergence`] and [`CollocationError::TooManyIntervals`] with the
///   numbers that were reached.
pub fn collocate<const D: usize>(
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    options: &Collocation<D>,
) -> Result<Collocated<D>, CollocationError> {
    let tolerance = options.tolerance;
    if !(1e-10..=1e-1).contains(&tolerance) {
        return Err(CollocationError::Tolerance { tolerance });
    }
    if options.intervals == 0 {
        return Err(CollocationError::NoIntervals);
    }
    let too_many = |intervals, residual| CollocationError::TooManyIntervals { intervals, residual };
    let most_intervals = options.most_intervals.min(LARGEST_N);
    if options.intervals > most_intervals {
        return Err(too_many(options.intervals, f64::INFINITY));
    }
    let [first, second] = [&**ends.first(), &**ends.second()];
    let near = match &options.start {
        Some(start) => [first.project(start.first()), second.project(start.last())],
        None => nearby(first, second),
    };
    finite("first point", &near[0])?;
    finite("second point", &near[1])?;
    let gram = |end: usize| check_gram(metric, &near[end]).map_err(EquationError::from);
    let (scale, _) = (gram(0)?.trace() / D as f64, gram(1)?);
    // The normal map of the second set is for the opposite of the velocity.
    let maps = [NormalMap { set: first, scale }, NormalMap { set: second, scale: -scale }];
    let table = Table::new();
    let mut path = start(&near, options);
    path.normals = [(0, 0), (1, path.intervals())]
        .map(|(end, node)| maps[end].unknown(metric, &near[end], &path.velocities[node]));
    keep_to(metric, &maps, &mut path);
    // Beyond the range of f64 no size of a step makes sense.
    defects(metric, &table, &path)?;
    let energy = path.energy(metric, &table);
    if !energy.is_finite() {
        return Err(CollocationError::Energy { energy });
    }
    let mut iterations = 0;
    loop {
        iterations += solve(metric, &table, &maps, &mut path, options.iterations)?;
        let residuals = path.residuals(metric, &table)?;
        let residual = residuals.iter().copied().fold(0.0, larger);
        if residual <= tolerance {
            let (energy, length) = (path.energy(metric, &table), path.length(metric, &table));
            if !in_range(energy, path.positions[0] == path.positions[path.intervals()]) {
                return Err(CollocationError::Energy { energy });
            }
            return Ok(Collocated { path, energy, length, residual, iterations });
        }
        // The residual is of the order 4. The target is half the tolerance, since the next solution
        // differs a little; four parts at most, since the order does not show on a coarse mesh.
        let parts: Vec<usize> =
            residuals
                .iter()
                .map(|residual| {
                    if *residual <= tolerance { 1 } else { divisions(residual / (0.5 * tolerance)) }
                })
                .collect();
        if parts.iter().sum::<usize>() > most_intervals {
            return Err(too_many(path.intervals(), residual));
        }
        path = path.refined(&parts, &table);
    }
}

/// Returns how many parts lower a residual by `factor`: between 2 and 4.
fn divisions(factor: f64) -> usize {
    (2..4).find(|&parts: &usize| (parts as f64).powi(4) >= factor).unwrap_or(4)
}

/// Returns the straight line, or the given sequence, on an even mesh.
fn start<const D: usize>([x, y]: &[SVector<f64, D>; 2], options: &Collocation<D>) -> Path<D> {
    let n = options.intervals;
    let mesh: Vec<f64> = (0..=n).map(|i| i as f64 / n as f64).collect();
    let mut positions: Vec<_> = mesh
        .iter()
        .map(|&t| options.start.as_ref().map_or(x * (1.0 - t) + y * t, |start| along(start, t)))
        .collect();
    positions[0] = *x;
    positions[n] = *y;
    // The mean of the chords at both sides, and one chord at the ends.
    let velocity = |i: usize| {
        let (low, high) = (i.saturating_sub(1), (i + 1).min(n));
        (positions[high] - positions[low]) / (mesh[high] - mesh[low])
    };
    let velocities = match options.start {
        Some(_) => (0..=n).map(velocity).collect(),
        None => vec![y - x; n + 1],
    };
    let accelerations = vec![[SVector::zeros(); STAGES]; n];
    Path { mesh, positions, velocities, normals: [*x, *y], accelerations }
}

/// Gives a path the ends that its normal maps have.
fn keep_to<const D: usize>(
    metric: &impl Metric<D>,
    maps: &[NormalMap<'_, D>; 2],
    path: &mut Path<D>,
) {
    for (end, node) in [(0, 0), (1, path.intervals())] {
        let at = maps[end].at(metric, &path.normals[end]);
        (path.positions[node], path.velocities[node]) = (at.position, at.velocity);
    }
}

/// Returns the point of a sequence at the time `t`, by linear interpolation.
fn along<const D: usize>(sequence: &PointSequence<D>, t: f64) -> SVector<f64, D> {
    let n = sequence.n().get();
    let place = t * n as f64;
    let number = (place as usize).min(n - 1);
    let (x, chord) = sequence.chord(number);
    x + chord * (place - number as f64)
}

/// Solves the equations on the mesh of `path`, and returns the number of steps.
fn solve<const D: usize>(
    metric: &impl Metric<D>,
    table: &Table,
    maps: &[NormalMap<'_, D>; 2],
    path: &mut Path<D>,
    limit: usize,
) -> Result<usize, CollocationError> {
    let n = path.intervals();
    // Not the distance of the ends, which may be one point. The coordinates of a short curve are rounded all
    // the same.
    let first = path.positions[0];
    let size = path.positions.iter().map(|x| (x - first).norm()).fold(0.0, f64::max);
    let extent = first.amax().max(path.positions[n].amax());
    let scale = size.max(1e-6 * extent).max(f64::MIN_POSITIVE);
    let mut lacks: Defects<D> = defects(metric, table, path)?;
    let mut damping = 1.0_f64;
    let mut size = f64::INFINITY;
    for iterations in 1..=limit {
        let failure = |correction| {
            Err(CollocationError::NoConvergence { intervals: n, correction, iterations })
        };
        let Some(system) = System::new(metric, table, path, maps)? else {
            return failure(f64::NAN);
        };
        let step = system.solve(&lacks);
        size = norm(&step) / scale;
        if !size.is_finite() {
            return failure(size);
        }
        damping = (2.0 * damping).min(1.0);
        loop {
            let mut trial = moved(path, &step, damping);
            keep_to(metric, maps, &mut trial);
            // The next correction with the same derivative has to be shorter.
            if let Ok(found) = defects(metric, table, &trial)
                && (size <= SMALL
                    || norm(&system.solve(&found)) / scale <= (1.0 - 0.25 * damping) * size)
            {
                (*path, lacks) = (trial, found);
                break;
            }
            damping *= 0.5;
            if damping < 1e-6 {
                return failure(size);
            }
        }
        if size <= SMALL && damping == 1.0 {
            return Ok(iterations);
        }
    }
    Err(CollocationError::NoConvergence { intervals: n, correction: size, iterations: limit })
}

/// Returns the root mean square of all entries, in `ℓ`.
fn norm<const D: usize>(step: &Path<D>) -> f64 {
    let stages = step.accelerations.as_flattened();
    let all = step.positions.iter().chain(&step.velocities).chain(&step.normals).chain(stages);
    let (mut sum, mut count) = (0.0, 0.0);
    for entry in all {
        sum += entry.norm_squared();
        count += 1.0;
    }
    (sum / count).sqrt()
}

/// Returns `path + damping · step`.
fn moved<const D: usize>(path: &Path<D>, step: &Path<D>, damping: f64) -> Path<D> {
    let mut moved = path.clone();
    let add = |to: &mut [SVector<f64, D>], from: &[SVector<f64, D>]| {
        to.iter_mut().zip(from).for_each(|(to, from)| *to += from * damping);
    };
    add(&mut moved.positions, &step.positions);
    add(&mut moved.velocities, &step.velocities);
    add(&mut moved.normals, &step.normals);
    add(moved.accelerations.as_flattened_mut(), step.accelerations.as_flattened());
    moved
}
