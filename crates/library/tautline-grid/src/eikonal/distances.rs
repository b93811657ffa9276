//! `Distances`: the values of a march, and what is between them.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, check_gram};
use tautline_sets::ClosedSet;

use super::{Eikonal, EikonalError, EikonalPath, descent::descend, near};

/// The shortest step to the nearest point of a set, in steps of the lattice.
const SHORTEST_STEP: f64 = 1e-6;

/// The most steps to the nearest point of a set. The first place is within a few steps of it.
const MOST_STEPS: usize = 200;

/// The distances from a set at the nodes of a lattice.
#[derive(Clone, Debug)]
pub struct Distances<'s, M, const D: usize> {
    pub(super) equation: &'s Eikonal<'s, M, D>,
    pub(super) set: &'s dyn ClosedSet<D>,
    values: Vec<f64>,
}

impl<'s, M: Metric<D>, const D: usize> Distances<'s, M, D> {
    pub(super) fn new(
        equation: &'s Eikonal<'s, M, D>,
        set: &'s dyn ClosedSet<D>,
        values: Vec<f64>,
    ) -> Self {
        Self { equation, set, values }
    }

    /// Returns the distances at the nodes, in `m`; `∞` at those that were not reached.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the distance at a point of the box, in `m`; `None` outside of it, and next to nodes that
    /// were not reached.
    ///
    /// In the [band](Eikonal::with_band) around the set it is the length of a chord. Elsewhere it is multilinear between the
    /// nodes: off by a multiple of the square of the spacing where the distance is smooth.
    #[must_use]
    pub fn at(&self, x: &SVector<f64, D>) -> Option<f64> {
        if self.is_near(x) {
            let _ = self.cell(x)?;
            return near::chord(self.equation.metric, self.set, x).map(|(_, length)| length);
        }
        let mut sum = 0.0;
        for (node, weight) in self.cell(x)? {
            sum += self.values[node] * weight;
        }
        Some(sum).filter(|value| value.is_finite())
    }

    /// Returns the point of another set that is nearest to this one, in `ℓ`, and its distance, in `m`.
    ///
    /// It is the lowest of the points of the set that are nearest to nodes within one step of it,
    /// followed by a descent along the set.
    ///
    /// # Errors
    ///
    /// [`EikonalError::FarFromEnd`] if the other set is far from all nodes or outside of the box, and
    /// [`EikonalError::NotConnected`] if none of these points was reached.
    pub fn nearest_in(
        &self,
        other: &dyn ClosedSet<D>,
    ) -> Result<(SVector<f64, D>, f64), EikonalError> {
        let lattice = self.equation.lattice();
        let (mut is_far, mut best) = (true, None::<(SVector<f64, D>, f64)>);
        for node in 0..lattice.nodes() {
            let x = lattice.point(node);
            let q = other.project(&x);
            if !self.equation.is_within(1.0, &(x - q)) || self.cell(&q).is_none() {
                continue;
            }
            is_far &= check_gram(self.equation.metric, &q).is_err();
            if let Some(value) = self.at(&q)
                && best.is_none_or(|best| value < best.1)
            {
                best = Some((q, value));
            }
        }
        if is_far {
            return Err(EikonalError::FarFromEnd { end: "second" });
        }
        let Some((mut q, mut value)) = best else {
            let reached = self.values.iter().filter(|value| value.is_finite()).count();
            return Err(EikonalError::NotConnected { reached, nodes: lattice.nodes() });
        };
        let mut step = 0.5;
        for _ in 0..MOST_STEPS {
            let Some(direction) = self.direction(&q).filter(|_| step >= SHORTEST_STEP) else {
                break;
            };
            let next = other.project(&(q - direction * step));
            match self.at(&next) {
                Some(lower) if lower < value => (q, value) = (next, lower),
                _ => step *= 0.5,
            }
        }
        Ok((q, value))
    }

    /// Returns the path from this set to another one: from the nearest point of the other set it descends
    /// along `−H⁻¹∇u`, and ends along a chord.
    ///
    /// # Errors
    ///
    /// Those of [`nearest_in`](Distances::nearest_in), and [`EikonalError::PathLost`].
    pub fn path_to(&self, other: &dyn ClosedSet<D>) -> Result<EikonalPath<D>, EikonalError> {
        let (point, distance) = self.nearest_in(other)?;
        descend(self, point, distance)
    }

    /// Returns whether a point is so near to the set that its distance is the length of a chord.
    pub(super) fn is_near(&self, x: &SVector<f64, D>) -> bool {
        self.equation.is_within(self.equation.band, &(x - self.set.project(x)))
    }

    /// Returns the corners of the cell around a point, with their weights; those with the weight 0 are
    /// left out. `None` outside of the box.
    pub(super) fn cell(&self, x: &SVector<f64, D>) -> Option<Vec<(usize, f64)>> {
        let lattice = self.equation.lattice();
        let (mut place, mut along) = ([0; D], [0.0; D]);
        for i in 0..D {
            let steps = (x[i] - lattice.lower()[i]) / lattice.spacing()[i];
            let most = (lattice.counts()[i] - 1) as f64;
            // A point on the boundary may be rounded out of the box.
            let rounding = 1e-9;
            if !(-rounding <= steps && steps <= most + rounding) {
                return None;
            }
            let steps = steps.clamp(0.0, most);
            (place[i], along[i]) = (steps as usize, steps.fract());
        }
        let corner = |at: usize| {
            let is_upper = |i: usize| at >> i & 1 == 1;
            let weight = |i| if is_upper(i) { along[i] } else { 1.0 - along[i] };
            let weight: f64 = (0..D).map(weight).product();
            let offset = std::array::from_fn(|i| isize::from(is_upper(i)));
            (weight > 0.0).then(|| Some((lattice.neighbour(&place, &offset)?, weight))).flatten()
        };
        Some((0..1 << D).filter_map(corner).collect())
    }

    /// Returns `H⁻¹∇u` at a point, as a vector that is one step of the lattice long along its longest axis;
    /// `None` where there is no gradient.
    pub(super) fn direction(&self, x: &SVector<f64, D>) -> Option<SVector<f64, D>> {
        let (mut gradient, mut weights) = (SVector::zeros(), 0.0);
        for (node, weight) in self.cell(x)? {
            if let Some(slope) = self.gradient(node) {
                gradient += slope * weight;
                weights += weight;
            }
        }
        let h: SMatrix<f64, D, D> = check_gram(self.equation.metric, x).ok()?;
        let velocity = h.cholesky()?.inverse() * gradient;
        let spacing = self.equation.lattice().spacing();
        let steps = (0..D).map(|i| velocity[i].abs() / spacing[i]).fold(0.0, f64::max);
        let direction = velocity / steps;
        (weights > 0.0 && direction.iter().all(|along| along.is_finite())).then_some(direction)
    }

    /// Returns the gradient of the values at a node, in `m/ℓ`: central differences, or one-sided ones next
    /// to nodes that were not reached. `None` at a node that was not reached, or that there is not.
    #[must_use]
    pub fn gradient(&self, node: usize) -> Option<SVector<f64, D>> {
        let lattice = self.equation.lattice();
        let here = self.values.get(node).copied().filter(|value| value.is_finite())?;
        let place = lattice.place(node);
        let slope = |i: usize| {
            let beside = [1, -1].map(|side| {
                let offset = std::array::from_fn(|j| if i == j { side } else { 0 });
                let value = self.values[lattice.neighbour(&place, &offset)?];
                value.is_finite().then_some(value)
            });
            let rise = match beside {
                [Some(above), Some(below)] => 0.5 * (above - below),
                [Some(above), None] => above - here,
                [None, Some(below)] => here - below,
                [None, None] => 0.0,
            };
            rise / lattice.spacing()[i]
        };
        Some(SVector::from_fn(|i, _| slope(i)))
    }
}
