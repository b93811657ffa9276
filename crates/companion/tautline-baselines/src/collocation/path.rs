//! `Path`: a piecewise polynomial curve, given at the nodes of a mesh and at the Gauss points.

use nalgebra::SVector;
use tautline::{Metric, norm_squared};

use super::gauss::{STAGES, Table, Weights, weights};
use crate::{EquationError, geodesic_equation::Acceleration};

/// A curve `γ` over the time `[0, 1]`, of degree 5 on each interval of a mesh. It is once
/// continuously differentiable up to the rounding of the solve.
#[derive(Clone, Debug, PartialEq)]
pub struct Path<const D: usize> {
    /// The times of the nodes, from 0 to 1.
    pub(crate) mesh: Vec<f64>,
    /// At the nodes, in `ℓ`.
    pub(crate) positions: Vec<SVector<f64, D>>,
    /// At the nodes, in `ℓ`.
    pub(crate) velocities: Vec<SVector<f64, D>>,
    /// The points of the normal maps of both ends, in `ℓ`.
    pub(crate) normals: [SVector<f64, D>; 2],
    /// At the Gauss points of each interval, in `ℓ`.
    pub(crate) accelerations: Vec<[SVector<f64, D>; STAGES]>,
}

/// A point of a path with its derivatives, all in `ℓ`.
pub(crate) struct At<const D: usize> {
    pub(crate) position: SVector<f64, D>,
    pub(crate) velocity: SVector<f64, D>,
    pub(crate) acceleration: SVector<f64, D>,
}

/// Returns the larger of two numbers, or NaN if one of them is NaN.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a.is_nan() || a > b { a } else { b }
}

impl<const D: usize> Path<D> {
    /// Returns the number of intervals of the mesh.
    #[must_use]
    pub fn intervals(&self) -> usize {
        self.accelerations.len()
    }

    /// Returns the times of the nodes of the mesh, from 0 to 1.
    #[must_use]
    pub fn mesh(&self) -> &[f64] {
        &self.mesh
    }

    /// Returns the point `γ(t)`, in `ℓ`; `None` unless `0 ≤ t ≤ 1`.
    #[must_use]
    pub fn position(&self, t: f64) -> Option<SVector<f64, D>> {
        Some(self.at(t)?.position)
    }

    /// Returns the velocity `γ̇(t)`, in `ℓ`; `None` unless `0 ≤ t ≤ 1`.
    #[must_use]
    pub fn velocity(&self, t: f64) -> Option<SVector<f64, D>> {
        Some(self.at(t)?.velocity)
    }

    pub(crate) fn at(&self, t: f64) -> Option<At<D>> {
        if !(0.0..=1.0).contains(&t) {
            return None;
        }
        let i = self.mesh[1..].partition_point(|&end| end < t).min(self.intervals() - 1);
        Some(self.within(i, &weights((t - self.mesh[i]) / self.step(i))))
    }

    /// Returns the length of interval `i`.
    pub(crate) fn step(&self, i: usize) -> f64 {
        self.mesh[i + 1] - self.mesh[i]
    }

    /// Evaluates the polynomial of interval `i`.
    pub(crate) fn within(&self, i: usize, weights: &Weights) -> At<D> {
        let h = self.step(i);
        let (x, v, k) = (self.positions[i], self.velocities[i], &self.accelerations[i]);
        let mut at = At {
            position: x + v * (h * weights.fraction),
            velocity: v,
            acceleration: SVector::zeros(),
        };
        for j in 0..STAGES {
            at.position += k[j] * (h * h * weights.double_integral[j]);
            at.velocity += k[j] * (h * weights.integral[j]);
            at.acceleration += k[j] * weights.value[j];
        }
        at
    }

    /// Returns the energy `∫ γ̇ᵀHγ̇ dt`, in `m²`, by the rule of Gauss on each interval.
    pub(crate) fn energy(&self, metric: &impl Metric<D>, table: &Table) -> f64 {
        self.integrate(metric, table, |square| square)
    }

    /// Returns the length `∫ (γ̇ᵀHγ̇)^{1/2} dt`, in `m`, by the rule of Gauss on each interval.
    pub(crate) fn length(&self, metric: &impl Metric<D>, table: &Table) -> f64 {
        self.integrate(metric, table, f64::sqrt)
    }

    fn integrate(&self, metric: &impl Metric<D>, table: &Table, f: fn(f64) -> f64) -> f64 {
        let term = |i, j| {
            let At { position, velocity, .. } = self.within(i, &table.stages[j]);
            self.step(i) * table.end.integral[j] * f(norm_squared(metric, &position, &velocity))
        };
        (0..self.intervals())
            .flat_map(|i| (0..STAGES).map(move |j| (i, j)))
            .map(|(i, j)| term(i, j))
            .sum()
    }

    /// Returns the largest residual `|γ̈ − a(γ, γ̇)|` of each interval, relative to the largest
    /// speed `|γ̇|` at a node.
    pub(crate) fn residuals(
        &self,
        metric: &impl Metric<D>,
        table: &Table,
    ) -> Result<Vec<f64>, EquationError> {
        let speed = self.velocities.iter().map(|v| v.norm()).fold(f64::MIN_POSITIVE, f64::max);
        let of_interval = |i| {
            let mut most = 0.0_f64;
            for sample in &table.samples {
                let at = self.within(i, sample);
                let exact = Acceleration::new(metric, &at.position, &at.velocity)?.value;
                most = larger(most, (at.acceleration - exact).norm() / speed);
            }
            Ok(most)
        };
        (0..self.intervals()).map(of_interval).collect()
    }

    /// Returns the same curve on a mesh in which interval `i` has `parts[i]` parts.
    pub(crate) fn refined(&self, parts: &[usize], table: &Table) -> Self {
        let mut fine = Self {
            mesh: vec![0.0],
            positions: vec![self.positions[0]],
            velocities: vec![self.velocities[0]],
            normals: self.normals,
            accelerations: Vec::new(),
        };
        for (i, &parts) in parts.iter().enumerate() {
            for part in 0..parts {
                let inside = |tau: f64| (part as f64 + tau) / parts as f64;
                fine.accelerations.push(std::array::from_fn(|j| {
                    self.within(i, &weights(inside(table.stages[j].fraction))).acceleration
                }));
                if part + 1 == parts {
                    fine.mesh.push(self.mesh[i + 1]);
                    fine.positions.push(self.positions[i + 1]);
                    fine.velocities.push(self.velocities[i + 1]);
                } else {
                    let at = self.within(i, &weights(inside(1.0)));
                    fine.mesh.push(self.mesh[i] + inside(1.0) * self.step(i));
                    fine.positions.push(at.position);
                    fine.velocities.push(at.velocity);
                }
            }
        }
        fine
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, vector};
    use tautline::gallery::Constant;

    use super::{Path, Table};

    /// Under a flat metric geodesics have no acceleration. That of this path grows along its second interval
    /// from 0 to 3: nothing at its begin, and the residual is the largest on the way.
    #[test]
    fn a_residual_is_the_largest_along_its_interval() {
        let table = Table::new();
        let along = table.stages.map(|stage| vector![3.0 * stage.fraction]);
        let path = Path {
            mesh: vec![0.0, 0.5, 1.0],
            positions: vec![vector![0.0], vector![1.0], vector![2.0]],
            velocities: vec![vector![2.0], vector![2.0], vector![1.5]],
            normals: [vector![0.0], vector![2.0]],
            accelerations: vec![[vector![0.0]; 4], along],
        };
        let flat = Constant::new(SMatrix::<f64, 1, 1>::identity()).expect("definite");
        let residuals = path.residuals(&flat, &table).expect("smooth");
        // Relative to the largest speed, 2; the weights round by 10⁻¹³.
        assert_eq!(residuals.len(), 2);
        assert!(residuals[0] < 1e-13 && (residuals[1] - 1.5).abs() < 1e-13, "{residuals:?}");
    }
}
