//! A metric with branches behind a pointer: its jets of order two are known, its intervals are not.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{cases, seed};
use tautline_formula::{AnyMetric, Formula, RecordError};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::random::Random;

/// A metric with or without a branch at 0. Both are the same for `x ≠ 0`.
struct Branches(bool);

impl Metric<2> for Branches {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let wave = if self.0 && x[0].is_zero() { S::one() } else { x[0].sin() / x[0] };
        let bump = x[0].exp() * x[1].cos();
        SMatrix::from_column_slice(&[wave + 3.0, bump, bump, x[1].powi(3) + 2.0])
    }
}

/// Compares all parts of jets.
fn agree<S: Scalar>(x: &SVector<S, 2>, parts: fn(&S) -> Vec<f64>) {
    let found = AnyMetric::new(&Branches(true)).gram(x);
    let expected = Branches(false).gram(x);
    for (found, expected) in found.iter().zip(&expected) {
        for (found, expected) in parts(found).into_iter().zip(parts(expected)) {
            // About a dozen operations on numbers below 10, with differences.
            assert!((found - expected).abs() <= 1e-13, "{found} and {expected} at {x:?}");
        }
    }
}

#[test]
fn a_formula_with_branches_has_jets_of_all_kinds() {
    let any = AnyMetric::new(&Branches(true));
    assert_eq!(any.formula(), Err(RecordError::Compares));
    let mut random = Random(seed(12));
    for _ in 0..cases(64) {
        let x = [random.number() / 4.0 + 1.5, random.number() / 4.0];
        let [s] = Jet2::<f64, 1>::variables(&[0.0]);
        let [t] = Jet1::<f64, 1>::variables(&[0.0]);
        agree(&SVector::from(x), |x| vec![*x]);
        agree(&SVector::from(Jet1::variables(&x)), |x| vec![x.value(), x.first(0), x.first(1)]);
        agree(&SVector::from(Jet2::variables(&x)), |x| {
            vec![x.value(), x.first(0), x.first(1), x.second(0, 0), x.second(0, 1), x.second(1, 1)]
        });
        agree(&SVector::from([t * 0.5 + x[0], t * -2.0 + x[1]]), |x| vec![x.value(), x.first(0)]);
        // The curve is not straight.
        agree(&SVector::from([s * 0.5 + s * s + x[0], s * -2.0 + x[1]]), |x| {
            vec![x.value(), x.first(0), x.second(0, 0)]
        });
    }
}

/// The values on one branch would not bound those on the others.
#[test]
fn a_formula_with_branches_has_no_intervals() {
    let any = AnyMetric::new(&Branches(true));
    let boxes = [1.0, 2.0].map(|x| Interval::new(x, x + 0.5).expect("ordered ends"));
    assert!(any.gram(&SVector::from(boxes)).iter().all(|entry| entry.is_undefined()));
    let jets = any.gram(&SVector::from(Jet2::variables(&boxes)));
    assert!(jets.iter().all(|entry| entry.value().is_undefined()));
    assert_eq!(Formula::record(&any), Err(RecordError::Compares));
}
