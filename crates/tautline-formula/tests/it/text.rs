//! What is typed is what is written in Rust, and what is printed is read again.

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_formula::Formula;
use tautline_metrics::{Metric, Scalar, gallery};

#[track_caller]
fn reads_back<const D: usize>(metric: &impl Metric<D>) {
    let formula = Formula::record(metric).expect("no comparison");
    let text = formula.to_string();
    assert_eq!(Formula::parse(&text, &[]).as_ref(), Ok(&formula), "{text}");
}

#[test]
fn the_gallery_is_printed_and_read_back_step_by_step() {
    reads_back::<1>(&gallery::Valleys);
    reads_back(&gallery::Shear::new(0.1, 1.0 / 3.0).expect("a wave number"));
    reads_back::<2>(&gallery::Bump::new(0.3, 0.7).expect("positive"));
    reads_back(&gallery::CoupledCosines);
    reads_back(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).expect("positive"));
    reads_back(&gallery::SineProjections::benchmark());
    reads_back::<3>(&gallery::Hyperbolic);
    reads_back(&gallery::GaussianFisher);
}

/// Steps that no gallery has: numbers of every kind, powers of every size, pairs.
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
fn numbers_and_powers_of_every_size_are_read_back() {
    reads_back(&Odd);
}

#[test]
fn a_text_does_what_the_same_formula_does_in_rust() {
    struct Sheet(f64);
    impl Metric<2> for Sheet {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let wave = 2.0 - self.0 * x[0].cos();
            let well = 1.0 + 3.0 / (1.0 + x[1].powi(2)) - -x[0] / 4.0;
            let off = 0.5 * x[0].sin() * x[1].exp();
            matrix![wave.sqr(), off; off, well * 2.0 * x[1].powi(-2)]
        }
    }
    let text = "wave = 2 - height*cos(x1);
        well = 1 + 3/(1 + x2^2) - -x1/4;
        off = 0.5*sin(x1)*exp(x2);
        [sqr(wave), off; off, well*2*x2**-2]";
    let typed = Formula::<2>::parse(text, &[("height", 0.9)]).expect("a formula");
    assert_eq!(Ok(typed), Formula::record(&Sheet(0.9)));
}

#[test]
fn numbers_among_themselves_are_numbers() {
    let of = |text: &str| Formula::<1>::parse(text, &[]).expect("a formula");
    assert_eq!(of("[(1 + 2)*3^2/sqrt(4) - 0.5 + x1]"), of("[13 + x1]"));
    assert_eq!(of("[2^-1*x1]"), of("[0.5*x1]"));
    assert_eq!(of("a = 2*pi; [a*x1]"), of("[6.283185307179586*x1]"));
    assert_eq!(of("1e-3 I"), of("[.001]"));
    // A number that is a step is none of these.
    assert_ne!(of("[number(2)*x1]"), of("[2*x1]"));
}

/// Powers before signs, products before sums, left before right.
#[test]
fn operators_bind_as_in_mathematics() {
    let value = |text: &str| {
        let formula = Formula::<2>::parse(&format!("{text} I"), &[]).expect("a formula");
        formula.gram(&vector![3.0, 5.0])[(0, 0)]
    };
    for (text, expected) in [
        ("-x1^2", -9.0),
        ("(-x1)^2", 9.0),
        ("x1 - x2 - 1", -3.0),
        ("x1/x2/2", 0.3),
        ("x1 + x2*2", 13.0),
        ("2*-x1", -6.0),
        ("--x1", 3.0),
        ("x1 - -x2", 8.0),
        ("16/x1^2^1", f64::NAN),
    ] {
        if expected.is_nan() {
            assert!(Formula::<2>::parse(&format!("{text} I"), &[]).is_err(), "{text}");
        } else {
            assert_eq!(value(text), expected, "{text}");
        }
    }
}
