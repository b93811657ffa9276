//! Where programs end: long formulas, undefined parts, differences, matrices that are no metric.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Batch, Batches, Kind, Plain, Prepared};
use tautline_metrics::{
    Metric,
    gallery::{SineProjection, SineProjections},
};
use tautline_scalar::Scalar;

use crate::programs::{all, compare_one, evaluate, places};

/// `H = Σₖ (cₖ tanh(wₖ·x))² I`, a sum of so many terms, none of which is a multiple of another.
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

/// What is long has more intermediate results than a cache has room for: it is left to the compiled formula,
/// whose results are the same.
#[test]
fn a_long_formula_is_evaluated_as_it_is_compiled() {
    let (short, long) = (Prepared::new(Sum(3)), Prepared::new(Sum(400)));
    assert!(short.size(Kind::Contraction).is_some());
    assert!(long.formula().is_some() && long.size(Kind::Contraction).is_none());
    let places = places::<3>(20);
    let plain = Plain::new(Sum(400));
    let [found, expected] = [&long as &dyn Batches<3>, &plain].map(|metric| {
        let mut batch = Batch::new(metric, Kind::Contraction, 20, 1);
        assert!(evaluate(&mut batch, &places));
        let layout = batch.layout();
        let rows = [&layout.gram, &layout.slope, &layout.turn, &layout.bend];
        let registers = rows.into_iter().flatten();
        registers.flat_map(|&register| batch.row(register)[..20].to_vec()).collect::<Vec<f64>>()
    });
    assert_eq!(found, expected);
}

/// In many dimensions a program is taken at any length: compiled, the derivatives of one formula are taken over
/// and over, a few directions at a time. The numbers are those of the compiled forms of the metric.
#[test]
fn from_24_coordinates_on_there_is_a_program_of_any_length() {
    // Matrices of 32 · 32 jets, by value: compiled for tests they take two megabytes of a stack, more or less.
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
    let [found, expected] = [&prepared as &dyn Batches<32>, &plain].map(|metric| {
        let mut batch = Batch::new(metric, Kind::Contraction, 6, 1);
        assert!(evaluate(&mut batch, &places));
        let layout = batch.layout();
        let rows = [&layout.gram, &layout.slope, &layout.turn, &layout.bend];
        rows.map(|rows| {
            rows.iter().flat_map(|&row| batch.row(row)[..6].to_vec()).collect::<Vec<f64>>()
        })
    });
    for (found, expected) in found.iter().zip(&expected) {
        // Sums of 8 · 32 products, with phases of the size 10 whose rounding is that of the sines.
        let size = expected.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        let off = found.iter().zip(expected).fold(0.0_f64, |off, (a, b)| off.max((a - b).abs()));
        assert!(off < 1e-12 * size, "{off:e} of {size}");
    }
}

/// Which of two numbers is larger cannot be asked, whether they are the same can: it has no formula.
#[test]
fn what_cannot_be_recorded_is_evaluated_as_it_is_compiled() {
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

/// A metric by one function, times the identity.
struct Conformal<F>(F);

/// A function of the coordinates in any numbers.
trait Function<const D: usize>: Sync {
    fn at<S: Scalar>(&self, x: &SVector<S, D>) -> S;
}

impl<F: Function<D>, const D: usize> Metric<D> for Conformal<F> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_diagonal_element(self.0.at(x))
    }
}

/// `dᵀHd` by the program, and whether there is one.
fn square<const D: usize>(metric: &impl Metric<D>, x: [f64; D], d: [f64; D]) -> (f64, bool) {
    let prepared = Prepared::new(metric);
    let mut batch = Batch::new(&prepared, Kind::Square, 1, 1);
    evaluate(&mut batch, &[(x.into(), d.into())]);
    (batch.row(batch.layout().square[0])[0], prepared.size(Kind::Square).is_some())
}

/// A thread of a megabyte has no room for a call for each step.
#[test]
fn long_chains_take_no_stack() {
    struct Chain(usize);
    impl Function<2> for Chain {
        fn at<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            let halved = (0..self.0).fold(x[0], |y, _| y * 0.5 * 2.0);
            let summed = (0..self.0).fold(x[1].sin(), |y, k| y + (x[0] * f64::from(k as u32)));
            2.0 + halved * x[1].sin() + summed * 1e-12
        }
    }
    let compare = || {
        let places = places::<2>(4);
        compare_one(
            &Conformal(Chain(20_000)),
            &Prepared::new(Conformal(Chain(20_000))),
            &places,
            "",
        )
    };
    let thread = std::thread::Builder::new().stack_size(1 << 20).spawn(compare).expect("a thread");
    assert!(thread.join().expect("no overflow") > 0);
}

/// More operations than a graph may have, though never more than a few at a time.
#[test]
fn a_formula_beyond_all_graphs_is_evaluated_as_it_is_compiled() {
    struct Chain;
    impl Function<1> for Chain {
        fn at<S: Scalar>(&self, x: &SVector<S, 1>) -> S {
            (0..200_000).fold(x[0], |y, _| (y + 1.0) / (y + 2.0))
        }
    }
    let found = square(&Conformal(Chain), [0.5], [2.0]);
    let value: SMatrix<f64, 1, 1> = Conformal(Chain).gram(&SVector::from([0.5]));
    assert_eq!(found, (4.0 * value[0], false));
}

#[test]
fn what_is_undefined_is_so_when_it_is_taken_from_itself() {
    struct Vanishes;
    impl Function<1> for Vanishes {
        fn at<S: Scalar>(&self, x: &SVector<S, 1>) -> S {
            2.0 + (x[0].ln() - x[0].ln()) + x[0].sqrt() * 0.0
        }
    }
    assert_eq!(square(&Conformal(Vanishes), [1.5], [1.0]), (2.0, true));
    let (undefined, is_program) = square(&Conformal(Vanishes), [-1.5], [1.0]);
    assert!(undefined.is_nan() && is_program);
}

/// `x − 10⁸` is exact near `10⁸`, where `x d² − 10⁸ d²` has lost all digits.
#[test]
fn exact_differences_stay_exact() {
    struct Far;
    impl Function<2> for Far {
        fn at<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            (x[0] - 1e8) * 3.0 + x[1].sqr()
        }
    }
    let x = 1e8 + 2.0_f64.powi(-10);
    let (found, is_program) = square(&Conformal(Far), [x, 0.0], [0.3, 0.1]);
    let exact = 3.0 * 2.0_f64.powi(-10) * (0.3 * 0.3 + 0.1 * 0.1);
    assert!(is_program && (found / exact - 1.0).abs() < 1e-15, "{found} {exact}");
}

/// The halves may differ by rounding, and by nothing else; how much that is, their rows and columns say.
#[test]
fn halves_that_differ_are_seen() {
    struct Halves(f64);
    impl Metric<3> for Halves {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            let mut h = SMatrix::<S, 3, 3>::from_diagonal(&SVector::from([
                S::constant(1e8),
                x[0].sqr() + 1.0,
                S::constant(4.0),
            ]));
            h[(1, 2)] = x[1].sin();
            h[(2, 1)] = x[1].sin() * (1.0 + self.0);
            h
        }
    }
    let is_metric = |difference: f64| {
        let prepared = Prepared::new(Halves(difference));
        let mut batch = Batch::new(&prepared, Kind::Momentum, 1, 1);
        assert!(prepared.size(Kind::Momentum).is_some());
        evaluate(&mut batch, &[([0.5, 1.0, 0.0].into(), [1.0, 1.0, 1.0].into())])
    };
    assert!(is_metric(0.0) && is_metric(1e-14));
    assert!(!is_metric(1e-10) && !is_metric(1e-6));
}

/// Of three pivots each has its turn to be negative.
#[test]
fn every_pivot_counts() {
    struct Indefinite(usize);
    impl Metric<3> for Indefinite {
        fn gram<S: Scalar>(&self, x: &SVector<S, 3>) -> SMatrix<S, 3, 3> {
            // L Lᵀ with a negative square in one place.
            let (u, v, w) = (x[0].sin(), x[1].cos(), x[2].exp());
            let one = S::one();
            let zero = S::zero();
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

/// `I + f(x) C` with a matrix that has rank one up to nine digits.
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
