//! Tests that results have the same bits whatever the instructions, the number of threads and the
//! block size are.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::Rule;
use tautline_formula::{InstructionSet, Prepared};
use tautline_metrics::{Metric, Scalar};
use tautline_optimizers::{Minimum, Options, Workspace, minimise_by_batches};

use crate::setup::{ball, between, from_to};

/// The metric has waves along each coordinate, and between neighbouring coordinates.
struct Waves;
impl<const D: usize> Metric<D> for Waves {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = SMatrix::identity() * S::constant(3.0);
        for i in 0..D {
            h[(i, i)] += 0.5 * x[i].sin() + 0.25 * (x[(i + 1) % D].sqr() * -1.0).exp();
            if i + 1 < D {
                h[(i, i + 1)] = 0.5 * (x[i] - x[i + 1]).cos();
                h[(i + 1, i)] = h[(i, i + 1)];
            }
        }
        h
    }
}

/// Returns the numbers of a result, and the bits of its points.
fn bits_of<const D: usize>(minimum: &Minimum<D>) -> (String, Vec<u64>) {
    let points = minimum.sequence.points().iter().flat_map(|x| x.iter());
    let bits = points.map(|x| x.to_bits()).collect();
    let Minimum { energy, decrement, residual, iterations, levels, .. } = minimum;
    (format!("{energy:e} {decrement:e} {residual:e} {iterations} {levels:?}"), bits)
}

/// Compares results on a grid with a middle chord and on one without. Both grids are large enough
/// for two threads, if two are used.
fn compare<const D: usize>(rule: Rule) {
    let at = |x: f64| SVector::<f64, D>::from_fn(|i, _| x + 0.3 * (i as f64).sin());
    let ball = |x: f64| ball(at(x), 0.25);
    for ends in [from_to(at(-1.0), at(1.0)), between(ball(-1.0), ball(1.0))] {
        for n in [300, (65_537 / (D * D)) | 1] {
            let solve = |instruction_set, lanes, threads| {
                let metric = Prepared::with(Waves, instruction_set, lanes);
                let options = Options { threads, ..Options::default() };
                let workspace = &mut Workspace::default();
                let minimum = minimise_by_batches(workspace, &metric, &ends, rule, n, &options);
                bits_of(&minimum.expect("a minimum"))
            };
            let expected = solve(InstructionSet::Baseline, 128, 1);
            for (instruction_set, lanes, threads) in [
                (InstructionSet::Widest, 128, 1),
                (InstructionSet::Widest, 8, 2),
                (InstructionSet::Baseline, 24, 2),
            ] {
                let found = solve(instruction_set, lanes, threads);
                assert_eq!(found.0, expected.0, "{rule} {n} {instruction_set:?} {lanes}");
                assert!(found.1 == expected.1, "{rule} {n} {instruction_set:?} {lanes}");
            }
        }
    }
}

#[test]
fn instructions_lanes_and_threads_change_no_bit_of_a_result() {
    compare::<1>(Rule::TRAPEZOIDAL);
    compare::<2>(Rule::TRAPEZOIDAL);
    compare::<2>(Rule::LEFT_ENDPOINT);
    compare::<3>(Rule::TRUE_TRAPEZOID);
    compare::<4>(Rule::TRAPEZOIDAL);
    compare::<8>(Rule::LEFT_ENDPOINT);
}
