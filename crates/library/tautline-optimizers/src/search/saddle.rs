//! The way down from a saddle.

use tautline_discretizations::{ANY, PointSequence, QuadraticModel};

use crate::{
    newton::{arithmetic::small::amax, reduced_system::ReducedSystem},
    search::{damping::SHIFT_FACTOR, local_search::LocalSearch},
};

impl LocalSearch<'_> {
    /// Walks down from a saddle along the direction of most negative curvature.
    pub(crate) fn leave_saddle(
        &self,
        model: &QuadraticModel,
        sequence: &PointSequence<ANY>,
        shift: f64,
    ) -> Option<Vec<f64>> {
        // With the smallest shift that makes the system definite, up to 1 in 8, the flattest
        // direction is the direction of most negative curvature.
        let (mut low, mut high) = (0.0, shift);
        let factorized = |shift: f64| {
            let system = ReducedSystem::new(model, self.ends, sequence.coordinates(), shift);
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
        let size = extent(sequence);
        let largest = amax(&direction);
        direction.iter_mut().for_each(|v| *v *= size / largest);
        let mut best: Option<(f64, Vec<_>)> = None;
        // The lengths start at 1e-4 of the size of the curve and grow as long as either side leads
        // down.
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

/// Returns the largest distance from the first point, in the maximum norm.
fn extent(sequence: &PointSequence<ANY>) -> f64 {
    let first = sequence.row(0);
    let rows = sequence.coordinates().chunks_exact(first.len());
    let gaps = rows.flat_map(|x| x.iter().zip(first).map(|(x, y)| (x - y).abs()));
    gaps.fold(0.0, f64::max)
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline_discretizations::{PointSequence, QuadraticModel, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::{Metric, Scalar, gallery::Bump};
    use tautline_sets::{InAny, Point};

    use crate::{
        newton::discrete_energy::DiscreteEnergy, search::local_search::LocalSearch,
        watch::Unwatched,
    };

    /// A bump that is undefined where `sign · x₂ < −10⁻⁵`, which puts a wall along the line over
    /// the bump.
    struct Walled {
        bump: Bump,
        sign: f64,
    }

    impl Metric<2> for Walled {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let inside = (x[1] * self.sign + 1e-5).sqrt() * 0.0 + 1.0;
            self.bump.gram(x) * inside
        }
    }

    /// Both sides lead down, but one of them is closed.
    #[test]
    fn a_saddle_is_left_to_the_open_side() {
        let [a, b] = [[-1.5, 0.0], [1.5, 0.0]];
        let line = PointSequence::straight(a, b, 32).expect("finite");
        let [a, b] = [a, b].map(|x| Point::new(x).expect("finite"));
        for sign in [1.0, -1.0] {
            let metric = Walled { bump: Bump::new(4.0, 0.5).expect("a width"), sign };
            let batches = Prepared::<_, 2>::new(&metric);
            let energy = &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &batches);
            let search = LocalSearch {
                energy,
                ends: [&InAny(&a), &InAny(&b)],
                iterations: 1,
                threads: 1,
                watch: &Unwatched,
            };
            let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &line);
            let points =
                search.leave_saddle(&model, &line.clone().into_any(), 64.0).expect("a way down");
            assert!(points[2..64].chunks(2).all(|x| x[1] * sign > -1e-5), "{points:?}");
            let lower = search.energy.admissible(&points).expect("inside");
            assert!(lower < 0.999 * model.energy, "{lower} {}", model.energy);
        }
    }

    /// The way over the bump and back begins and ends at one point. Its size, by which the search walks, is how
    /// far it leads away from there.
    #[test]
    fn a_closed_curve_is_left_too() {
        let metric = Bump::new(4.0, 0.5).expect("a width");
        let (begin, n) = ([-1.5, 0.0], 32);
        let at = |k: usize| {
            let away = if k <= n / 2 { k } else { n - k };
            SVector::from([begin[0] + 6.0 * away as f64 / n as f64, 0.0])
        };
        let line = PointSequence::new((0..=n).map(at).collect()).expect("finite");
        let begin = Point::new(begin).expect("finite");
        let batches = Prepared::<_, 2>::new(&metric);
        let search = LocalSearch {
            energy: &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &batches),
            ends: [&InAny(&begin), &InAny(&begin)],
            iterations: 1,
            threads: 1,
            watch: &Unwatched,
        };
        let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &line);
        let points =
            search.leave_saddle(&model, &line.clone().into_any(), 64.0).expect("a way down");
        let lower = search.energy.admissible(&points).expect("defined everywhere");
        assert!(lower < 0.999 * model.energy, "{lower} {}", model.energy);
    }
}
