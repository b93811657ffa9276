//! `System`: the collocation equations, linearised, in blocks.

use nalgebra::{DMatrix, DVector, Dyn, LU, SMatrix, SVector};
use tautline::Metric;

use super::{
    gauss::{STAGES, Table},
    path::Path,
};
use crate::{
    EquationError,
    geodesic_equation::Acceleration,
    normal_map::{NormalMap, pseudo_inverse},
};

/// What the equations of a path lack: all are zero at a solution.
pub(crate) struct Defects<const D: usize> {
    /// `kⱼ − a(Xⱼ, Vⱼ)` at the Gauss points.
    stages: Vec<[SVector<f64, D>; STAGES]>,
    /// `xᵢ₊₁ − xᵢ − h vᵢ − h² Σ b̄ⱼ kⱼ`.
    positions: Vec<SVector<f64, D>>,
    /// `vᵢ₊₁ − vᵢ − h Σ bⱼ kⱼ`.
    velocities: Vec<SVector<f64, D>>,
}

/// One interval of the linearised equations. With the stages eliminated it is the map
///
/// ```text
/// δxᵢ₊₁ = Axx δxᵢ + Axv δvᵢ + …,    δvᵢ₊₁ = Avx δxᵢ + Avv δvᵢ + …
/// ```
struct Interval<const D: usize> {
    step: f64,
    /// Of the equations of the stages, `4D × 4D`.
    factor: LU<f64, Dyn, Dyn>,
    /// `∂k/∂xᵢ` and `∂k/∂vᵢ`.
    by_position: [SMatrix<f64, D, D>; STAGES],
    by_velocity: [SMatrix<f64, D, D>; STAGES],
    xx: SMatrix<f64, D, D>,
    vx: SMatrix<f64, D, D>,
    vv: SMatrix<f64, D, D>,
    /// `Axv⁻¹`: by it `δvᵢ` follows from the positions at both ends.
    inverse: SMatrix<f64, D, D>,
}

/// The equations of a path, linearised and factorised.
///
/// The velocities are eliminated as well. What remains says that the velocity is continuous at the
/// nodes, where at both ends it meets that of the normal map. It is block tridiagonal in the
/// positions of the inner nodes and the points of the normal maps: the discrete Jacobi equation.
pub(crate) struct System<'a, const D: usize> {
    table: &'a Table,
    intervals: Vec<Interval<D>>,
    /// For each node, the derivative of its position by its unknown.
    columns: Vec<SMatrix<f64, D, D>>,
    /// For each node, the block below the diagonal and the inverse of the pivot.
    pivots: Vec<[SMatrix<f64, D, D>; 2]>,
}

/// Returns the defects of `path`.
pub(crate) fn defects<const D: usize>(
    metric: &impl Metric<D>,
    table: &Table,
    path: &Path<D>,
) -> Result<Defects<D>, EquationError> {
    let n = path.intervals();
    let mut defects = Defects {
        stages: vec![[SVector::zeros(); STAGES]; n],
        positions: Vec::with_capacity(n),
        velocities: Vec::with_capacity(n),
    };
    for i in 0..n {
        for j in 0..STAGES {
            let at = path.within(i, &table.stages[j]);
            let exact = Acceleration::new(metric, &at.position, &at.velocity)?.value;
            defects.stages[i][j] = path.accelerations[i][j] - exact;
        }
        let end = path.within(i, &table.end);
        defects.positions.push(path.positions[i + 1] - end.position);
        defects.velocities.push(path.velocities[i + 1] - end.velocity);
    }
    Ok(defects)
}

impl<'a, const D: usize> System<'a, D> {
    /// Linearises about `path`. The result is `None` if the equations are singular.
    pub(crate) fn new(
        metric: &impl Metric<D>,
        table: &'a Table,
        path: &Path<D>,
        maps: &[NormalMap<'_, D>; 2],
    ) -> Result<Option<Self>, EquationError> {
        let n = path.intervals();
        let mut intervals = Vec::with_capacity(n);
        for i in 0..n {
            match Interval::new(metric, table, path, i)? {
                Some(interval) => intervals.push(interval),
                None => return Ok(None),
            }
        }
        let ends = [0, 1].map(|end| maps[end].at(metric, &path.normals[end]));
        let mut columns = vec![SMatrix::identity(); n + 1];
        columns[0] = ends[0].position_by;
        columns[n] = ends[1].position_by;
        let mut pivots: Vec<[SMatrix<f64, D, D>; 2]> = Vec::with_capacity(n + 1);
        for node in 0..=n {
            // The velocity from the left less that to the right.
            let (mut below, mut pivot) = (SMatrix::zeros(), SMatrix::zeros());
            if node > 0 {
                let left: &Interval<D> = &intervals[node - 1];
                below = (left.vx - left.vv * left.inverse * left.xx) * columns[node - 1];
                pivot += left.vv * left.inverse * columns[node];
                // The block above the diagonal of the row before is −inverse · column.
                pivot += below * pivots[node - 1][1] * left.inverse * columns[node];
            } else {
                pivot += ends[0].velocity_by;
            }
            if node < n {
                pivot += intervals[node].inverse * intervals[node].xx * columns[node];
            } else {
                pivot -= ends[1].velocity_by;
            }
            // A family of solutions shows in the last pivot.
            let inverse = if node < n { pivot.try_inverse() } else { pseudo_inverse(&pivot) };
            match inverse {
                Some(inverse) => pivots.push([below, inverse]),
                None => return Ok(None),
            }
        }
        Ok(Some(Self { table, intervals, columns, pivots }))
    }

    /// Returns the correction of a path with these defects, whose ends are those of the normal
    /// maps: the solution `δ` of `(derivative) δ = −(defects)`, in the fields of a path.
    pub(crate) fn solve(&self, defects: &Defects<D>) -> Path<D> {
        let n = self.intervals.len();
        let (b, b_bar) = (&self.table.end.integral, &self.table.end.double_integral);
        // What each interval adds to its stages, its last position and its last velocity.
        let mut stages = Vec::with_capacity(n);
        let mut shifts = Vec::with_capacity(n);
        for (i, interval) in self.intervals.iter().enumerate() {
            let right = DVector::from_fn(STAGES * D, |row, _| -defects.stages[i][row / D][row % D]);
            let solved = interval.factor.solve(&right).unwrap_or(right * f64::NAN);
            let own: [SVector<f64, D>; STAGES] =
                std::array::from_fn(|j| SVector::from_fn(|k, _| solved[j * D + k]));
            let h = interval.step;
            let mut shift = [-defects.positions[i], -defects.velocities[i]];
            for j in 0..STAGES {
                shift[0] += own[j] * (h * h * b_bar[j]);
                shift[1] += own[j] * (h * b[j]);
            }
            stages.push(own);
            shifts.push(shift);
        }
        // Forward elimination and back substitution over the nodes.
        let mut unknowns = vec![SVector::zeros(); n + 1];
        for node in 0..=n {
            let mut value = SVector::zeros();
            if node > 0 {
                let left = &self.intervals[node - 1];
                let [x, v] = shifts[node - 1];
                value += left.vv * left.inverse * x - v;
                value -= self.pivots[node][0] * unknowns[node - 1];
            }
            if node < n {
                value -= self.intervals[node].inverse * shifts[node][0];
            }
            unknowns[node] = self.pivots[node][1] * value;
        }
        for node in (0..n).rev() {
            let next = self.columns[node + 1] * unknowns[node + 1];
            unknowns[node] += self.pivots[node][1] * (self.intervals[node].inverse * next);
        }
        let positions: Vec<_> = self.columns.iter().zip(&unknowns).map(|(c, u)| c * u).collect();
        let mut velocities = Vec::with_capacity(n + 1);
        let mut last = SVector::zeros();
        for (i, interval) in self.intervals.iter().enumerate() {
            let x = positions[i];
            let v = interval.inverse * (positions[i + 1] - interval.xx * x - shifts[i][0]);
            for j in 0..STAGES {
                stages[i][j] += interval.by_position[j] * x + interval.by_velocity[j] * v;
            }
            last = interval.vx * x + interval.vv * v + shifts[i][1];
            velocities.push(v);
        }
        velocities.push(last);
        let normals = [unknowns[0], unknowns[n]];
        Path { mesh: Vec::new(), positions, velocities, normals, accelerations: stages }
    }
}

impl<const D: usize> Interval<D> {
    fn new(
        metric: &impl Metric<D>,
        table: &Table,
        path: &Path<D>,
        i: usize,
    ) -> Result<Option<Self>, EquationError> {
        let h = path.step(i);
        let mut matrix = DMatrix::identity(STAGES * D, STAGES * D);
        let mut right = DMatrix::zeros(STAGES * D, 2 * D);
        for (j, weights) in table.stages.iter().enumerate() {
            let at = path.within(i, weights);
            let a = Acceleration::new(metric, &at.position, &at.velocity)?;
            for l in 0..STAGES {
                let block = a.by_position * (h * h * weights.double_integral[l])
                    + a.by_velocity * (h * weights.integral[l]);
                let mut place = matrix.view_mut((j * D, l * D), (D, D));
                place -= &block;
            }
            let by_velocity = a.by_position * (h * weights.fraction) + a.by_velocity;
            right.view_mut((j * D, 0), (D, D)).copy_from(&a.by_position);
            right.view_mut((j * D, D), (D, D)).copy_from(&by_velocity);
        }
        let factor = matrix.lu();
        let Some(solved) = factor.solve(&right) else { return Ok(None) };
        let part = |j: usize, column: usize| {
            SMatrix::<f64, D, D>::from_fn(|r, c| solved[(j * D + r, column * D + c)])
        };
        let by_position: [_; STAGES] = std::array::from_fn(|j| part(j, 0));
        let by_velocity: [_; STAGES] = std::array::from_fn(|j| part(j, 1));
        let (b, b_bar) = (&table.end.integral, &table.end.double_integral);
        let one = SMatrix::identity();
        let (mut xx, mut xv, mut vx, mut vv) = (one, one * h, SMatrix::zeros(), one);
        for j in 0..STAGES {
            xx += by_position[j] * (h * h * b_bar[j]);
            xv += by_velocity[j] * (h * h * b_bar[j]);
            vx += by_position[j] * (h * b[j]);
            vv += by_velocity[j] * (h * b[j]);
        }
        let Some(inverse) = xv.try_inverse() else { return Ok(None) };
        Ok(Some(Self { step: h, factor, by_position, by_velocity, xx, vx, vv, inverse }))
    }
}
