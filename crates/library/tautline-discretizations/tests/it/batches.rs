//! Integrals over a curve and discrete energies in batches, and point by point.

use nalgebra::{SMatrix, SVector, vector};
use tautline_discretizations::{
    Interpolation, LinearModel, PointSequence, QuadraticModel, Rule, admissible_energy,
};
use tautline_formula::{AnyBatches, Plain, Prepared};
use tautline_metrics::{
    Metric, Scalar,
    gallery::{Bump, GaussianFisher, Swirl, Valleys},
    quadrature::Integral,
};

/// Compares energy and length on grids that fill a part of a batch, one batch, and several.
fn compare<M: Metric<2>>(metric: M, [from, to]: [[f64; 2]; 2]) {
    let prepared = Prepared::new(&metric);
    assert!(prepared.formula().is_some(), "the program is what is tested");
    let plain = Plain::new(&metric);
    for n in [1, 2, 3, 17, 18, 19, 100, 1001] {
        let bent = (0..=n).map(|k| {
            let s = k as f64 / n as f64;
            let line = vector![from[0], from[1]] * (1.0 - s) + vector![to[0], to[1]] * s;
            line + vector![0.1, -0.2] * (s * (1.0 - s))
        });
        let sequence = PointSequence::new(bent.collect()).expect("finite");
        let curve = Interpolation::new(&sequence);
        let pairs = |batches: &dyn AnyBatches| {
            [
                (curve.energy(&metric), curve.energy_by_batches(batches)),
                (curve.length(&metric), curve.length_by_batches(batches)),
            ]
        };
        for (by_points, by_batches) in pairs(&plain) {
            let bits = |Integral { value, error }| [f64::to_bits(value), f64::to_bits(error)];
            assert_eq!(bits(by_batches), bits(by_points), "N = {n}");
        }
        // A program and the compiled formula differ by a few roundings at each node.
        for (by_points, by_batches) in pairs(&prepared) {
            let difference = (by_batches.value - by_points.value).abs();
            assert!(difference <= 64.0 * f64::EPSILON * by_points.value, "N = {n}: {difference:e}");
        }
    }
}

/// On the coarse grids the first nodes do not resolve the metric, so that chords are halved.
#[test]
fn curves_are_integrated_in_batches_as_point_by_point() {
    compare(Valleys, [[-9.0, 0.0], [14.0, 3.0]]);
    compare(GaussianFisher, [[-2.0, 0.3], [2.0, 4.0]]);
    compare(Bump::new(30.0, 0.5).expect("a height"), [[-8.0, -1.0], [8.0, 1.0]]);
}

/// The energy of `N` chords is `N` times the sum of the energies of the chords alone, and so are its
/// derivatives: also where a point is shared by two chords of different batches. Nothing of a batch stays
/// for the next but what belongs to its last point.
#[test]
fn a_model_of_many_chords_is_the_sum_of_the_models_of_each() {
    fn check(rule: Rule) {
        let swirl = Swirl::new(1.3, 0.8).expect("a swirl");
        let (plain, prepared) = (Plain::new(&swirl), Prepared::new(&swirl));
        for n in [1, 2, 3, 64, 65, 200, 1001] {
            let at = |k: usize| {
                let t = k as f64 / n as f64;
                vector![1.5 * t - 0.7, 0.4 * (9.0 * t).sin()]
            };
            let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
            let factor = n as f64;
            let mut energy = 0.0;
            let mut gradient = vec![SVector::<f64, 2>::zeros(); n + 1];
            let mut diagonal = vec![SMatrix::<f64, 2, 2>::zeros(); n + 1];
            let mut upper = Vec::new();
            for (k, pair) in sequence.points().windows(2).enumerate() {
                let chord = PointSequence::new(pair.to_vec()).expect("finite");
                let model = QuadraticModel::new(rule, &swirl, &chord);
                energy += factor * model.energy;
                for end in 0..2 {
                    gradient[k + end] += model.gradient::<2>()[end] * factor;
                    diagonal[k + end] += model.hessian::<2>().diagonal[end] * factor;
                }
                upper.push(model.hessian::<2>().upper[0] * factor);
            }
            for metric in [&plain as &dyn AnyBatches, &prepared] {
                let linear = LinearModel::by_batches(rule.nodes(), metric, &sequence);
                let mut quadratic = QuadraticModel::default();
                quadratic.expand_by_batches(rule.nodes(), metric, &sequence);
                // Sums of numbers of the size of an energy below 10, and of N times that of a metric.
                let close = |a: f64, b: f64| (a - b).abs() <= 1e-12 * energy;
                let admissible = admissible_energy(rule.nodes(), metric, sequence.coordinates());
                let admissible = admissible.expect("a metric");
                for found in [linear.energy, quadratic.energy, admissible] {
                    assert!(close(found, energy), "{rule} {n}: {found} {energy}");
                }
                assert!(linear.is_metric);
                let small = 1e-12 * factor;
                for k in 0..=n {
                    assert!(
                        (linear.gradient::<2>()[k] - gradient[k]).amax() <= small,
                        "{rule:?} {n} {k}"
                    );
                    assert!(
                        (quadratic.gradient::<2>()[k] - gradient[k]).amax() <= small,
                        "{n} {k}"
                    );
                    let off = (quadratic.hessian::<2>().diagonal[k] - diagonal[k]).amax();
                    assert!(off <= 10.0 * small, "{rule:?} {n} {k}: {off:e}");
                }
                for (k, block) in upper.iter().enumerate() {
                    assert!(
                        (quadratic.hessian::<2>().upper[k] - block).amax() <= 10.0 * small,
                        "{n} {k}"
                    );
                }
            }
        }
    }
    check(Rule::TRAPEZOIDAL);
    check(Rule::LEFT_ENDPOINT);
    check(Rule::SIMPSON);
}

/// `H = x₁ I` is negative left of 0. One chord there, in whichever batch, is enough: the sum of all energies
/// stays positive.
#[test]
fn one_chord_without_a_metric_is_enough() {
    struct Half;
    impl Metric<2> for Half {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element(x[0])
        }
    }
    let (plain, prepared) = (Plain::new(&Half), Prepared::new(&Half));
    let n = 500;
    for wrong in [None, Some(0), Some(1), Some(250), Some(498), Some(499)] {
        let at = |k: usize| {
            let x =
                if wrong.is_some_and(|wrong| k == wrong || k == wrong + 1) { -0.1 } else { 9.0 };
            vector![x, 0.01 * k as f64]
        };
        let sequence = PointSequence::new((0..=n).map(at).collect()).expect("finite");
        for metric in [&plain as &dyn AnyBatches, &prepared] {
            let nodes = Rule::TRAPEZOIDAL.nodes();
            let model = LinearModel::by_batches(nodes, metric, &sequence);
            assert!(model.energy > 0.0, "{wrong:?}");
            assert_eq!(model.is_metric, wrong.is_none(), "{wrong:?}");
            let energy = admissible_energy(nodes, metric, sequence.coordinates());
            assert_eq!(energy.is_some(), wrong.is_none(), "{wrong:?}");
        }
    }
}
