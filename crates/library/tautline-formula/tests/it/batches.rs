//! Batches of every number of points, in memory that held other points before.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{AnyBatches, Batch, InstructionSet, Kind, Plain, Prepared, WIDTH};
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

use crate::{
    parsed,
    programs::{Place, evaluate, places, rows},
};

/// Functions of every kind: those of whole chunks, which pass numbers out of range to the standard
/// library, and those that are called one by one.
struct Functions;

impl Metric<2> for Functions {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let (sin, cos) = (x[0] * 3.0 - x[1]).sin_cos();
        let (sinh, cosh) = (x[1] * 0.5).sinh_cosh();
        let a = (x[0] * 0.7).exp() * sin + (x[1].sqr() + 1.5).ln() * cos + (x[0] * 0.3).tan();
        let b = x[0].tanh() + x[1].atan() * sinh + cosh + (x[1] * 0.1 + 2.0).powi(-3);
        let beside = (a * b).tanh() * 0.5;
        let root = (a.sqr() + 2.0).sqrt();
        SMatrix::from_row_slice(&[root + 1.0, beside, beside, b.sqr() + 1.0])
    }
}

/// Points at which the functions leave their ranges, or have no value, or `H` is no metric.
fn extreme(count: usize) -> Vec<Place<2>> {
    const FAR: [f64; 8] = [1e9, -1e300, f64::NAN, f64::INFINITY, 800.0, -5000.0, 0.0, -1e-320];
    let at = |k: usize| FAR[k % FAR.len()];
    let vector = |k: usize| SVector::from([at(k), at(k / 3 + 1)]);
    (0..count).map(|k| (vector(k), vector(k + 5))).collect()
}

const KINDS: [Kind; 4] = [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction];

/// All rows, lane by lane, in bits.
fn bits(batch: &Batch<'_>, count: usize) -> Vec<Vec<u64>> {
    let rows = rows(batch, count).concat();
    let lane = |lane: usize| rows.iter().skip(lane).step_by(count).map(|x| x.to_bits()).collect();
    (0..count).map(lane).collect()
}

/// Evaluates each point alone, and then the first `count` of them for every count, each time after a
/// full batch of extreme points in the same memory. `check` sees the batch.
fn compare(metric: &dyn AnyBatches, name: &str, check: impl Fn(&Batch<'_>, usize)) {
    for kind in KINDS {
        let mut batch = Batch::new(metric, kind, 1, 64);
        let lanes = batch.lanes();
        let (old, new) = (extreme(lanes), places::<2>(lanes));
        let alone: Vec<_> = new
            .iter()
            .map(|place| {
                let mut one = Batch::new(metric, kind, 1, 1);
                assert!(evaluate(&mut one, &[*place]), "{name}, {kind:?}: no metric");
                bits(&one, 1).remove(0)
            })
            .collect();
        for count in 1..=lanes {
            evaluate(&mut batch, &old);
            let is_metric = evaluate(&mut batch, &new[..count]);
            assert!(is_metric, "{name}, {kind:?}: {count} points are no metric");
            assert_eq!(bits(&batch, count), alone[..count], "{name}, {kind:?}: {count} points");
            check(&batch, count);
        }
    }
}

/// One bad point among good ones, in any lane: `H` is not symmetric, or not positive definite, or not
/// finite in the half that is not used.
#[test]
fn a_batch_is_that_of_a_metric_only_if_every_lane_is() {
    const TEXT: &str = "[2, x1; x2 + 0*ln(x2 + 1.9), 2]";
    let (prepared, plain) = (Prepared::new(parsed::<2>(TEXT)), Plain::new(parsed::<2>(TEXT)));
    let place = |x: [f64; 2]| (SVector::from(x), SVector::from([0.5, -1.0]));
    let good = place([0.5, 0.5]);
    for kind in [Kind::Checked, Kind::Momentum, Kind::Contraction] {
        assert!(prepared.size(kind).is_some(), "{kind:?}");
        for metric in [&prepared as &dyn AnyBatches, &plain] {
            let mut batch = Batch::new(metric, kind, 2 * WIDTH, 1);
            for bad in [[0.5, -0.5], [3.0, 3.0], [-1.95, -1.95]].map(place) {
                for count in [1, 3, WIDTH, WIDTH + 1] {
                    for lane in 0..count {
                        let mut places = vec![good; count];
                        places[lane] = bad;
                        assert!(!evaluate(&mut batch, &places), "{kind:?}: {lane} of {count}");
                    }
                    assert!(evaluate(&mut batch, &vec![good; count]), "{kind:?}: {count}");
                }
            }
        }
    }
}

/// The halves of `H` may differ by `10⁻¹² √(Hᵢᵢ Hⱼⱼ)`, here `6 · 10⁻¹²`, wherever they are.
#[test]
fn halves_that_differ_by_more_than_roundings_are_no_metric() {
    for text in [
        "[4, x1, 0; x2, 9, 0; 0, 0, 1e-100]",
        "[4, 0, x1; 0, 1e-100, 0; x2, 0, 9]",
        "[1e100, 0, 0; 0, 4e-100, x1; 0, x2, 9e100]",
    ] {
        let (prepared, plain) = (Prepared::new(parsed::<3>(text)), Plain::new(parsed::<3>(text)));
        for kind in [Kind::Checked, Kind::Momentum, Kind::Contraction] {
            assert!(prepared.size(kind).is_some(), "{text} {kind:?}");
            for metric in [&prepared as &dyn AnyBatches, &plain] {
                let mut batch = Batch::new(metric, kind, 1, 1);
                for (off, is_metric) in [(0.0, true), (0.9, true), (1.1, false)] {
                    let (one, other) = (1.0, 1.0 + off * 6e-12);
                    for x in [[one, other, 0.5], [other, one, 0.5]] {
                        let place = (SVector::from(x), SVector::from([0.5, -1.0, 0.25]));
                        let found = evaluate(&mut batch, &[place]);
                        assert_eq!(found, is_metric, "{text} {kind:?} at {x:?}");
                    }
                }
            }
        }
    }
}

/// Nothing of the batch before is left, in any lane that is computed.
#[test]
fn a_batch_does_not_know_the_one_before() {
    for set in [InstructionSet::Baseline, InstructionSet::Widest] {
        let prepared = Prepared::with(Functions, set, 64);
        assert!(KINDS.iter().all(|&kind| prepared.size(kind).is_some()));
        compare(&prepared, &format!("{set:?}"), |batch, count| {
            let used = count.next_multiple_of(WIDTH);
            let last = bits(batch, count).remove(count - 1);
            for (lane, found) in bits(batch, used).into_iter().enumerate().skip(count) {
                assert_eq!(found, last, "{set:?}: lane {lane} beyond {count} points");
            }
        });
    }
    compare(&Plain::new(Functions), "as compiled", |_, _| {});
}
