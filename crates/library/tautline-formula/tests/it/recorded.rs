//! A formula agrees with its metric bit for bit: recorded, printed and parsed, and behind a
//! pointer.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{cases, seed};
use tautline_formula::{
    AnyMetric, Arithmetic, Formula, Function, LONGEST, Number, Operation, Pair, RecordError,
};
use tautline_metrics::{Metric, gallery};
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::random::Random;

/// Compares texts, since NaN is then equal to NaN, and `−0` is not equal to `0`.
fn same<S: Scalar, const D: usize>(
    metric: &impl Metric<D>,
    formula: &Formula<D>,
    any: &AnyMetric<'_, D>,
    x: [S; D],
) {
    let x = SVector::from(x);
    let text = |h: SMatrix<S, D, D>| format!("{h:?}");
    let expected = text(metric.gram(&x));
    assert_eq!(text(formula.gram(&x)), expected, "at {x:?}");
    assert_eq!(text(any.gram(&x)), expected, "behind a pointer, at {x:?}");
}

fn laws<const D: usize>(metric: &impl Metric<D>) {
    let (formula, any) = (formula(metric), AnyMetric::new(metric));
    let mut random = Random(seed(11));
    for _ in 0..cases(32) {
        let x: [f64; D] = std::array::from_fn(|_| random.number() / 8.0);
        let [s] = Jet2::<f64, 1>::variables(&[0.0]);
        let [t] = Jet1::<f64, 1>::variables(&[0.0]);
        let boxes = x.map(|x| Interval::new(x, x + 0.125).expect("ordered ends"));
        same(metric, &formula, &any, x);
        same(metric, &formula, &any, Jet1::variables(&x));
        same(metric, &formula, &any, Jet2::variables(&x));
        same(metric, &formula, &any, x.map(|x| t * 0.5 + x));
        same(metric, &formula, &any, x.map(|x| s * 0.5 + x));
        same(metric, &formula, &any, boxes);
        same(metric, &formula, &any, Jet2::variables(&boxes));
    }
    assert_eq!(Formula::record(&formula).as_ref(), Ok(&formula));
    assert_eq!(Formula::record(&any).as_ref(), Ok(&formula));
    let text = formula.to_string();
    assert_eq!(Formula::parse(&text, &[]).as_ref(), Ok(&formula), "{text}");
}

fn formula<const D: usize>(metric: &impl Metric<D>) -> Formula<D> {
    Formula::record(metric).expect("no comparison")
}

#[test]
fn the_gallery_is_recorded_to_the_bit() {
    laws::<1>(&gallery::Valleys);
    laws::<2>(&gallery::Valleys);
    laws(&gallery::Shear::new(0.1, 1.0 / 3.0).expect("a wave number"));
    laws::<2>(&gallery::Bump::new(0.3, 0.7).expect("positive"));
    laws::<2>(&gallery::Lens::new(0.5, 1.0).expect("positive"));
    laws::<2>(&gallery::Hill::new(0.5, 1.0).expect("positive"));
    laws::<1>(&gallery::Ramp::new(0.5, 1.0).expect("below one"));
    laws(&gallery::Separable::new([0.3, -0.5, 0.7], [1.0, 2.0, 3.0]).expect("below one"));
    laws(&gallery::CoupledCosines);
    laws(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).expect("positive"));
    laws(&gallery::SineProjections::benchmark());
    laws::<2>(&gallery::Sphere);
    laws::<3>(&gallery::Hyperbolic);
    laws(&gallery::GaussianFisher);
    laws(&gallery::Constant::<3>::new(SMatrix::identity()).expect("definite"));
}

/// Steps that do not occur in the gallery: numbers of every kind, powers of every size, pairs.
struct Odd;

impl Metric<1> for Odd {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let (x, (a, b)) = (x[0], x[0].sinh_cosh());
        let numbers = [-0.0, 5e-324, f64::MAX, 0.1, -1e16, f64::INFINITY, -f64::INFINITY, f64::NAN];
        let sum = numbers.iter().fold(a / b, |sum, &c| (sum + c) * S::constant(c) - x / c);
        let powers = [i32::MIN, -1, 0, 1, 2, i32::MAX];
        SMatrix::from_element(powers.iter().fold(-sum.sin_cos().1, |sum, &n| sum + x.powi(n)))
    }
}

#[test]
fn numbers_and_powers_of_every_size_are_recorded() {
    laws(&Odd);
}

/// Each operation once, with numbers on either side.
struct Everything;

impl Metric<1> for Everything {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        let x = x[0];
        let (sin, cos) = x.sin_cos();
        let (sinh, cosh) = x.sinh_cosh();
        let mut sum = (2.0 - x).sqr() + 3.0 / (x + 4.0) + x.powi(-3) - (x * x - 5.0).tan();
        sum += sin * cosh - cos / sinh + (-x).atan() * (x * 0.5).sinh() + x.cosh();
        sum -= (x / 8.0).exp().sqrt().ln().tanh() + x.sin() - x.cos() + S::constant(-0.0);
        sum *= x.recip() + S::one();
        SMatrix::from_element(sum)
    }
}

#[test]
fn every_operation_is_recorded_to_the_bit() {
    laws(&Everything);
    let formula = Formula::record(&Everything).expect("no comparison");
    let has = |operation| formula.operations().contains(&operation);
    let [sub, add] = [Arithmetic::Sub, Arithmetic::Add];
    assert!(has(Operation::Of(Function::Neg, 0)) && has(Operation::Powi(0, -3)));
    assert!(has(Operation::WithNumber(add, 0, Number::of(4.0))));
    assert!(has(Operation::Constant(Number::of(-0.0))) && has(Operation::First(Pair::SinCos, 0)));
    assert!(
        formula
            .operations()
            .iter()
            .any(|step| matches!(step, Operation::Binary(how, ..) if *how == sub))
    );
}

#[test]
fn repeated_steps_are_recorded_once_and_unused_ones_dropped() {
    struct Twice;
    impl Metric<2> for Twice {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let _ = x[1].exp() + x[0].sinh_cosh().1;
            let (_, cos) = x[0].sin_cos();
            SMatrix::from_diagonal_element(cos + 2.0) + SMatrix::from_diagonal_element(cos + 2.0)
        }
    }
    let formula = Formula::record(&Twice).expect("no comparison");
    let cos = 3;
    assert_eq!(
        formula.operations()[..5],
        [
            Operation::Coordinate(0),
            Operation::Coordinate(1),
            Operation::First(Pair::SinCos, 0),
            Operation::Second,
            Operation::WithNumber(Arithmetic::Add, cos, Number::of(2.0)),
        ]
    );
    // Both diagonal entries are 2 cos + 4, and both others are 0 + 0.
    assert_eq!(formula.entry(0, 0), formula.entry(1, 1));
    assert_eq!(formula.entry(0, 1), formula.entry(1, 0));
    assert_eq!(formula.operations().len(), 8, "{formula:?}");
}

#[test]
fn a_formula_with_branches_is_refused() {
    struct Branch;
    impl Metric<1> for Branch {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let zero = S::zero();
            SMatrix::from_element(if x[0] == zero { S::one() } else { x[0].sin() / x[0] })
        }
    }
    assert_eq!(Formula::record(&Branch), Err(RecordError::Compares));
    // Constants may be compared.
    struct Known;
    impl Metric<1> for Known {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let half = S::constant(0.5);
            assert!(half == S::constant(0.5) && half != S::one() && !half.is_zero());
            SMatrix::from_element(if S::zero().is_zero() { x[0] + 1.0 } else { x[0] })
        }
    }
    laws(&Known);
}

#[test]
fn a_loop_that_is_too_long_is_refused() {
    struct Loop;
    impl Metric<1> for Loop {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element((0..2_000_000).fold(x[0], |sum, k| sum + f64::from(k)))
        }
    }
    let most = LONGEST;
    assert_eq!(Formula::record(&Loop), Err(RecordError::TooLong { most }));
}

/// A sine takes a step for the cosine with it. No formula has more steps than the longest, also if the
/// last two come together.
#[test]
fn the_longest_formula_may_end_with_two_steps() {
    struct Pair {
        before: usize,
    }
    impl Metric<1> for Pair {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            // The coordinate is the first step.
            let sum = (1..self.before).fold(x[0], |sum, k| sum + k as f64);
            SMatrix::from_element(sum.sin_cos().1)
        }
    }
    let steps = |before| Formula::record(&Pair { before }).map(|it| it.operations().len());
    assert_eq!(steps(LONGEST - 2), Ok(LONGEST));
    assert_eq!(steps(LONGEST - 1), Err(RecordError::TooLong { most: LONGEST }));
}

/// Numbers from another thread are on no tape.
#[test]
fn a_formula_that_uses_another_thread_is_refused() {
    struct Elsewhere;
    impl Metric<1> for Elsewhere {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let x = x[0];
            let sum = std::thread::scope(|scope| scope.spawn(|| x + 1.0).join());
            SMatrix::from_element(sum.expect("no panic"))
        }
    }
    assert_eq!(Formula::record(&Elsewhere), Err(RecordError::Foreign));
}

/// A formula may record another formula, and after a panic nothing remains on the next tape.
#[test]
fn recordings_do_not_disturb_each_other() {
    struct Within;
    impl Metric<1> for Within {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let before = x[0].sin();
            assert!(Formula::record(&Everything).is_ok());
            SMatrix::from_element(before * x[0].sin() + 2.0)
        }
    }
    laws(&Within);
    struct Panics;
    impl Metric<1> for Panics {
        fn gram<S: Scalar>(&self, _: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            panic!("on purpose")
        }
    }
    let caught = std::panic::catch_unwind(|| Formula::record(&Panics));
    assert!(caught.is_err());
    laws(&Everything);
}
