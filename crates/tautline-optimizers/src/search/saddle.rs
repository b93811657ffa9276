//! The way down from a saddle.

use nalgebra::SVector;
use tautline_discretizations::{PointSequence, QuadraticModel};

use crate::{
    newton::reduced_system::ReducedSystem,
    search::{damping::SHIFT_FACTOR, local_search::LocalSearch},
};

impl<const D: usize> LocalSearch<'_, D> {
    /// Walks down from a saddle, along the direction of the most negative curvature.
    pub(crate) fn leave_saddle(
        &self,
        model: &QuadraticModel<D>,
        sequence: &PointSequence<D>,
        shift: f64,
    ) -> Option<Vec<SVector<f64, D>>> {
        // The smallest shift that makes the system definite, to 1 in 8: the direction which
        // is flattest there is the one of most negative curvature.
        let (mut low, mut high) = (0.0, shift);
        let factorized = |shift: f64| {
            let system = ReducedSystem::new(model, self.ends, sequence.points(), shift);
            system.factorize().map(|factorization| (system, factorization))
        };
        while factorized(high / SHIFT_FACTOR).is_some() {
            high /= SHIFT_FACTOR;
            if high < f64::MIN_POSITIVE {
                return None;
            }
        }
        for _ in 0..6 {
            let middle = 0.5 * (low + high);
            *(if factorized(middle).is_some() { &mut high } else { &mut low }) = middle;
        }
        let (system, factorization) = factorized(high)?;
        let mut direction = system.flattest_direction(&factorization);
        let size = extent(sequence.points());
        let largest = direction.iter().map(|v| v.amax()).fold(0.0, f64::max);
        direction.iter_mut().for_each(|v| *v *= size / largest);
        let mut best: Option<(f64, Vec<_>)> = None;
        // From 1e-4 of the size of the curve on, as long as it leads down on one of both sides.
        for exponent in 0..14 {
            let length = 1e-4 * f64::from(1 << exponent);
            let lower = [length, -length]
                .into_iter()
                .filter_map(|s| {
                    let trial = self.retract(sequence, &direction, s);
                    self.energy.admissible(&trial).map(|energy| (energy, trial))
                })
                .min_by(|a, b| a.0.total_cmp(&b.0));
            let limit = best.as_ref().map_or(model.energy * (1.0 - 1e-13), |best| best.0);
            match lower {
                Some(lower) if lower.0 < limit => best = Some(lower),
                _ if best.is_some() => break,
                _ => {}
            }
        }
        best.map(|(_, points)| points)
    }
}

/// The largest distance, by a coordinate, from the first point.
fn extent<const D: usize>(points: &[SVector<f64, D>]) -> f64 {
    points.iter().map(|x| (x - points[0]).amax()).fold(0.0, f64::max)
}
