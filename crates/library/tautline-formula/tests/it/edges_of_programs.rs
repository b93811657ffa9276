//! Edge cases of programs: long formulas, undefined parts, differences, and matrices that are not
//! metrics.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{AnyBatches, Batch, Formula, Kind, Plain, Prepared};
use tautline_metrics::{
    Metric,
    gallery::{SineProjection, SineProjections},
};
use tautline_scalar::Scalar;

use crate::{
    parsed,
    programs::{Place, all, compare_one, evaluate, places, rows},
};

/// A sum of this many terms in `tanh(wₖ·x)`, none of which is a multiple of another.
struct Sum(usize);

impl Metric<3> for Sum {
    fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
        let mut h = SMatrix::<S, 3, 3>::identity();
        for k in 0..self.0 {
            let w = |i: usize| (1.3 * k as f64 + 0.7 * i as f64).sin();
            let t = (x[0] * w(0) + x[1] * w(1) + x[2] * w(2)).tanh();
            for i in 0..3 {
                for j in i..3 {
                    let term = (t * w(i + 3)) * (x[i] * t * w(j + 3) + 1.0) * (x[j] + w(k));
                    h[(i, j)] += term * 1e-3;
                    h[(j, i)] = h[(i, j)];
                }
            }
        }
        h
    }
}

/// A long formula has more intermediate results than fit into a cache. It is evaluated as compiled,
/// with the same results.
#[test]
fn a_long_formula_is_evaluated_as_compiled() {
    let (short, long) = (Prepared::new(Sum(3)), Prepared::new(Sum(400)));
    assert!(short.size(Kind::Contraction).is_some());
    assert!(long.formula().is_some() && long.size(Kind::Contraction).is_none());
    let places = places::<3>(20);
    let plain = Plain::new(Sum(400));
    let [found, expected] = [&long as &dyn AnyBatches, &plain].map(|metric| {
        let mut batch = Batch::new(metric, Kind::Contraction, 20, 1);
        assert!(evaluate(&mut batch, &places));
        rows(&batch, 20)
    });
    assert_eq!(found, expected);
}

/// Step by step the formula of a text is a hundred times as slow as a program of any length.
#[test]
fn a_long_formula_that_is_not_compiled_has_programs() {
    let formula = Formula::<3>::record(&Sum(400)).expect("no branches");
    let long = Prepared::<_, 3>::new(formula);
    let kinds = [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction];
    assert!(kinds.iter().all(|&kind| long.size(kind).is_some()));
    let places = places::<3>(20);
    let plain = Plain::new(Sum(400));
    // Sums of 400 terms, each with a dozen roundings.
    assert_near(&long, &plain, &places);
}

/// Compares all rows of the contractions of two metrics, relative to the largest number of a row.
fn assert_near<const D: usize>(
    found: &dyn AnyBatches,
    expected: &dyn AnyBatches,
    places: &[Place<D>],
) {
    let count = places.len();
    let [found, expected] = [found, expected].map(|metric| {
        let mut batch = Batch::new(metric, Kind::Contraction, count, 1);
        assert!(evaluate(&mut batch, places));
        rows(&batch, count)
    });
    for (found, expected) in found.iter().zip(&expected) {
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let off = found.iter().zip(expected).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
        assert!(off <= 1e-12 * size, "{off:e} of {size}");
    }
}

/// In many dimensions programs of any length are used, because the compiled formula is evaluated
/// again for every few directions. The numbers are the same.
#[test]
fn from_24_coordinates_on_programs_may_be_long() {
    // Matrices of 32 · 32 jets, passed by value, take about two megabytes of stack in a test build.
    let thread = std::thread::Builder::new().stack_size(1 << 23).spawn(compare_in_32_coordinates);
    thread.expect("a thread").join().expect("the same numbers");
}

fn compare_in_32_coordinates() {
    let vector = |seed: usize| {
        SVector::<f64, 32>::from_fn(|i, _| (1.0 + 1.7 * (32 * seed + i) as f64).sin())
    };
    let term =
        |k: usize| SineProjection { wave_vector: vector(2 * k), direction: vector(2 * k + 1) };
    let metric = SineProjections::new((0..8).map(term).collect()).expect("finite");
    let (plain, prepared) = (Plain::new(&metric), Prepared::new(&metric));
    assert!(prepared.size(Kind::Contraction).is_some_and(|[length, _]| length > 10_000));
    let places = places::<32>(6);
    // There are sums of 8 · 32 products. The sines carry the rounding of their phases, which are about 10.
    assert_near(&prepared, &plain, &places);
}

/// A formula may ask whether two numbers are equal. It then cannot be recorded.
#[test]
fn a_formula_with_branches_is_evaluated_as_compiled() {
    struct Compares;
    impl Metric<2> for Compares {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let factor = if x[0] == S::zero() { S::constant(5.0) } else { x[0].sqr() + 1.0 };
            SMatrix::from_diagonal_element(factor)
        }
    }
    let prepared = Prepared::new(Compares);
    assert!(prepared.formula().is_none() && prepared.size(Kind::Square).is_none());
    let mut batch = Batch::new(&prepared, Kind::Square, 1, 2);
    let one = SVector::from([1.0, 0.0]);
    evaluate(&mut batch, &[(SVector::from([0.0, 0.0]), one), (SVector::from([1.0, 0.0]), one)]);
    assert_eq!(batch.row(batch.layout().square[0])[..2], [5.0, 2.0]);
}

/// Returns `dᵀHd` as the program computes it, and whether there is a program.
fn square<const D: usize>(metric: &impl Metric<D>, x: [f64; D], d: [f64; D]) -> (f64, bool) {
    let prepared = Prepared::new(metric);
    let mut batch = Batch::new(&prepared, Kind::Square, 1, 1);
    evaluate(&mut batch, &[(x.into(), d.into())]);
    (batch.row(batch.layout().square[0])[0], prepared.size(Kind::Square).is_some())
}

/// Factors one after the other may keep what their product loses: it would overflow, underflow, or have
/// no reciprocal. The terms themselves are numbers of ordinary size.
#[test]
fn factors_whose_product_is_no_number_stay_apart() {
    for (text, x) in [
        ("[sqrt(exp(x1)*1e200*1e200 + exp(1.0625*x1)*1e200*1e200)]", -600.0),
        ("[2 + atan(exp(x1)*1e-200*1e-200 + exp(1.0625*x1)*1e-200*1e-200)]", 650.0),
        // These are functions of their exponential alone.
        ("[1 + exp(x1)*1e200*1e200]", -600.0),
        ("[exp(x1)*1e-200*1e-200]", 650.0),
        ("[exp(x1)*1e-160*1e-160]", 700.0),
        ("[3 + cos(exp(x1)*1e155*1e155)]", -705.0),
        ("[1 + exp(x1)/1e-310]", -700.0),
        ("[1 + exp(x1)/1.7e308]", 700.0),
        ("[2 + atan(exp(x1)/1e-309)]", -708.0),
    ] {
        let metric = parsed::<1>(text);
        let (prepared, plain) = (Prepared::new(metric.clone()), Plain::new(metric));
        for kind in [Kind::Checked, Kind::Momentum, Kind::Contraction] {
            assert!(prepared.size(kind).is_some(), "{text} has a program");
            let [found, expected] = [&prepared as &dyn AnyBatches, &plain].map(|metric| {
                let mut batch = Batch::new(metric, kind, 1, 1);
                assert!(evaluate(&mut batch, &[([x].into(), [1.0].into())]), "{text} {kind:?}");
                rows(&batch, 1).concat()
            });
            assert_eq!(found.len(), expected.len());
            for (found, expected) in found.iter().zip(&expected) {
                // A hundred roundings, of numbers of which some are exponentials of 700.
                let tolerance = 1e-10 * expected.abs().max(f64::MIN_POSITIVE);
                let is_close = expected.is_finite() && (found - expected).abs() <= tolerance;
                assert!(is_close, "{text} {kind:?}: {found:e} {expected:e}");
            }
        }
    }
}

/// A stack of a megabyte has no room for one call per step.
#[test]
fn long_chains_take_no_stack() {
    struct Chain;
    impl Metric<2> for Chain {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let halved = (0..20_000).fold(x[0], |y, _| y * 0.5 * 2.0);
            let summed = (0..20_000).fold(x[1].sin(), |y, k| y + (x[0] * f64::from(k)));
            SMatrix::from_diagonal_element(2.0 + halved * x[1].sin() + summed * 1e-12)
        }
    }
    let compare = || compare_one(&Chain, &Prepared::new(Chain), &places(4), "");
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(compare).expect("a thread");
    assert!(thread.join().expect("no overflow") > 0);
}

/// The formula has more operations than a graph may have, though few are live at a time.
#[test]
fn a_formula_too_long_for_a_graph_is_evaluated_as_compiled() {
    struct Chain;
    impl Metric<1> for Chain {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element((0..200_000).fold(x[0], |y, _| (y + 1.0) / (y + 2.0)))
        }
    }
    let value = Chain.gram(&SVector::from([0.5]))[0];
    assert_eq!(square(&Chain, [0.5], [2.0]), (4.0 * value, false));
}

#[test]
fn an_undefined_term_minus_itself_is_undefined() {
    let vanishes = parsed("2 + (ln(x1) - ln(x1)) + sqrt(x1)*0 I");
    assert_eq!(square(&vanishes, [1.5], [1.0]), (2.0, true));
    let (undefined, is_program) = square(&vanishes, [-1.5], [1.0]);
    assert!(undefined.is_nan() && is_program);
}

/// `x − 10⁸` is exact close to `10⁸`, where `x d² − 10⁸ d²` has lost all digits.
#[test]
fn exact_differences_stay_exact() {
    let far = parsed("(x1 - 1e8)*3 + sqr(x2) I");
    let x = 1e8 + 2.0_f64.powi(-10);
    let (found, is_program) = square(&far, [x, 0.0], [0.3, 0.1]);
    let exact = 3.0 * 2.0_f64.powi(-10) * (0.3 * 0.3 + 0.1 * 0.1);
    assert!(is_program && (found / exact - 1.0).abs() < 1e-15, "{found} {exact}");
}

/// The halves may differ by rounding errors, measured by the diagonal entries, and by nothing else.
#[test]
fn halves_that_differ_are_detected() {
    let is_metric = |difference: f64| {
        let halves = format!(
            "diagonal = sqr(x1) + 1; s = sin(x2);
            [1e8, 0, 0; 0, diagonal, s; 0, s*(1 + {difference:?}), 4]"
        );
        let prepared = Prepared::new(parsed::<3>(&halves));
        let mut batch = Batch::new(&prepared, Kind::Momentum, 1, 1);
        assert!(prepared.size(Kind::Momentum).is_some());
        evaluate(&mut batch, &[([0.5, 1.0, 0.0].into(), [1.0, 1.0, 1.0].into())])
    };
    assert!(is_metric(0.0) && is_metric(1e-14));
    assert!(!is_metric(1e-10) && !is_metric(1e-6));
}

/// Each of the three pivots is made negative, one after another.
#[test]
fn every_pivot_counts() {
    /// `L S Lᵀ` with the identity `S`, except for a negative entry in one place.
    struct Indefinite(usize);
    impl Metric<3> for Indefinite {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            let (u, v, w) = (x[0].sin(), x[1].cos(), x[2].exp());
            let (one, zero) = (S::one(), S::zero());
            let lower = SMatrix::<S, 3, 3>::new(one, zero, zero, u, one, zero, v, w, one);
            let mut square = SMatrix::<S, 3, 3>::identity();
            square[(self.0, self.0)] = S::constant(-1e-3);
            lower * square * lower.transpose()
        }
    }
    for kind in [Kind::Momentum, Kind::Contraction] {
        for place in 0..3 {
            let prepared = Prepared::new(Indefinite(place));
            let mut batch = Batch::new(&prepared, kind, 1, 1);
            let x = ([0.3, 0.2, 0.1].into(), [1.0, 0.0, 0.0].into());
            assert!(!evaluate(&mut batch, &[x]), "{place}");
        }
    }
}

/// `3 I + f(x) C` with a matrix that has rank one only to nine digits.
#[test]
fn nearly_rank_one_is_not_rank_one() {
    struct Nearly;
    impl Metric<3> for Nearly {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            let (f, a) = ((x[0] + x[1] * 2.0).sin(), [0.5, -0.25, 0.75]);
            SMatrix::from_fn(|i, j| {
                let off = if i + j == 1 { 1e-9 } else { 0.0 };
                f * (a[i] * a[j] + off) + if i == j { 3.0 } else { 0.0 }
            })
        }
    }
    all(&Nearly);
}
