//! `Flow`: a point of the geodesic flow with its derivatives, as a state of the integrator.

use std::cell::RefCell;

use differential_equations::{ode::ODE, tolerance::Tolerance, traits::State};
use nalgebra::{SMatrix, SVector};
use tautline::Metric;

use crate::{EquationError, geodesic_equation::Acceleration};

/// A position `x` and a velocity `v`, both in `ℓ`, with their derivatives by those at the time 0.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Flow<const D: usize> {
    pub(crate) position: SVector<f64, D>,
    pub(crate) velocity: SVector<f64, D>,
    /// `∂x/∂x₀`.
    pub(crate) position_by_position: SMatrix<f64, D, D>,
    /// `∂x/∂v₀`.
    pub(crate) position_by_velocity: SMatrix<f64, D, D>,
    /// `∂v/∂x₀`.
    pub(crate) velocity_by_position: SMatrix<f64, D, D>,
    /// `∂v/∂v₀`.
    pub(crate) velocity_by_velocity: SMatrix<f64, D, D>,
}

impl<const D: usize> Flow<D> {
    /// Returns the flow at the time 0.
    pub(crate) fn start(position: &SVector<f64, D>, velocity: &SVector<f64, D>) -> Self {
        Self {
            position: *position,
            velocity: *velocity,
            position_by_position: SMatrix::identity(),
            velocity_by_velocity: SMatrix::identity(),
            ..Self::zeros()
        }
    }

    fn components(&self) -> impl Iterator<Item = &f64> {
        let vectors = self.position.iter().chain(self.velocity.iter());
        vectors
            .chain(self.position_by_position.iter())
            .chain(self.position_by_velocity.iter())
            .chain(self.velocity_by_position.iter())
            .chain(self.velocity_by_velocity.iter())
    }

    fn components_mut(&mut self) -> impl Iterator<Item = &mut f64> {
        let vectors = self.position.iter_mut().chain(self.velocity.iter_mut());
        vectors
            .chain(self.position_by_position.iter_mut())
            .chain(self.position_by_velocity.iter_mut())
            .chain(self.velocity_by_position.iter_mut())
            .chain(self.velocity_by_velocity.iter_mut())
    }

    /// Applies `f` to corresponding components.
    fn zip(&mut self, other: &Self, f: impl Fn(&mut f64, f64)) {
        for (a, b) in self.components_mut().zip(other.components()) {
            f(a, *b);
        }
    }
}

/// The components are numbered as the fields are, each by columns.
impl<const D: usize> State<f64> for Flow<D> {
    fn len(&self) -> usize {
        2 * D + 4 * D * D
    }

    fn get_component(&self, index: usize) -> f64 {
        self.components().nth(index).copied().unwrap_or(f64::NAN)
    }

    fn set_component(&mut self, index: usize, value: f64) {
        if let Some(component) = self.components_mut().nth(index) {
            *component = value;
        }
    }

    fn map_components_mut<F: FnMut(usize, &mut f64)>(&mut self, mut f: F) {
        self.components_mut().enumerate().for_each(|(index, value)| f(index, value));
    }

    fn zeros_like(&self) -> Self {
        Self::zeros()
    }

    fn zeros() -> Self {
        Self {
            position: SVector::zeros(),
            velocity: SVector::zeros(),
            position_by_position: SMatrix::zeros(),
            position_by_velocity: SMatrix::zeros(),
            velocity_by_position: SMatrix::zeros(),
            velocity_by_velocity: SMatrix::zeros(),
        }
    }

    fn mul_add_assign(&mut self, alpha: f64, other: &Self) {
        self.zip(other, |a, b| *a += alpha * b);
    }

    fn scale_mut(&mut self, alpha: f64) {
        self.components_mut().for_each(|a| *a *= alpha);
    }

    /// Sums in one pass; the default looks up each component by its number.
    fn error_norm(
        &self,
        next: &Self,
        error: &Self,
        absolute: &Tolerance<f64>,
        relative: &Tolerance<f64>,
    ) -> f64 {
        let sizes = self.components().zip(next.components()).map(|(a, b)| a.abs().max(b.abs()));
        let allowed = sizes.enumerate().map(|(i, size)| absolute[i] + relative[i] * size);
        allowed.zip(error.components()).map(|(allowed, error)| (error / allowed).powi(2)).sum()
    }

    fn copy_from_state(&mut self, other: &Self) {
        self.clone_from(other);
    }

    fn add_scaled(&mut self, alpha: f64, other: &Self) -> &mut Self {
        self.mul_add_assign(alpha, other);
        self
    }
}

/// The geodesic equation and its variational equation, as a system of first order.
///
/// Where the metric makes no equation the derivative is NaN, so that the integrator refuses the
/// step, and the reason is kept.
pub(crate) struct Equation<'a, M> {
    metric: &'a M,
    failure: RefCell<Option<EquationError>>,
}

impl<'a, M> Equation<'a, M> {
    pub(crate) fn new(metric: &'a M) -> Self {
        Self { metric, failure: RefCell::default() }
    }

    /// Returns the last failure since the last call, and forgets it.
    pub(crate) fn take_failure(&self) -> Option<EquationError> {
        self.failure.take()
    }
}

impl<M: Metric<D>, const D: usize> ODE<f64, Flow<D>> for Equation<'_, M> {
    fn diff(&self, _time: f64, at: &Flow<D>, derivative: &mut Flow<D>) {
        match Acceleration::new(self.metric, &at.position, &at.velocity) {
            Ok(a) => {
                derivative.position = at.velocity;
                derivative.velocity = a.value;
                derivative.position_by_position = at.velocity_by_position;
                derivative.position_by_velocity = at.velocity_by_velocity;
                derivative.velocity_by_position = a.by_position * at.position_by_position
                    + a.by_velocity * at.velocity_by_position;
                derivative.velocity_by_velocity = a.by_position * at.position_by_velocity
                    + a.by_velocity * at.velocity_by_velocity;
            }
            Err(failure) => {
                *self.failure.borrow_mut() = Some(failure);
                derivative.fill(f64::NAN);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use differential_equations::traits::State;
    use nalgebra::vector;

    use super::Flow;

    #[test]
    fn every_component_has_its_own_number() {
        let mut flow = Flow::start(&vector![1.0, 2.0], &vector![3.0, 4.0]);
        assert_eq!(flow.components().count(), flow.len());
        assert_eq!((flow.get_component(1), flow.get_component(2)), (2.0, 3.0));
        for index in 0..flow.len() {
            flow.set_component(index, index as f64);
        }
        flow.map_components_mut(|index, value| assert_eq!(*value, index as f64));
        let doubled = flow.plus_scaled(1.0, &flow);
        assert_eq!(doubled, flow.scaled(2.0));
        assert_eq!(doubled.get_component(19), 38.0);
        assert!(flow.get_component(20).is_nan());
    }
}
