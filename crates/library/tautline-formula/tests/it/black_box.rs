//! Batches of a black box against those of the formula that it hides.

use std::sync::{
    Arc,
    atomic::{AtomicUsize, Ordering},
};

use nalgebra::{SMatrix, SVector, vector};
use tautline_formula::{
    AnyBatches, Batch, BlackBox, Formula, Kind, Plain, Prepared, RecordError, Values,
};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Interval, Jet2, Scalar};

use crate::parsed;

/// The values of a formula, and its derivatives up to an order.
struct Hidden<const D: usize> {
    formula: Formula<D>,
    order: usize,
    calls: AtomicUsize,
}

impl<const D: usize> Hidden<D> {
    fn new(text: &str, order: usize) -> Arc<Self> {
        Arc::new(Self { formula: parsed(text), order, calls: AtomicUsize::new(0) })
    }

    /// Returns what `of` returns for each entry of `H` at each point, row by row.
    fn all(&self, x: &[f64], of: fn(&Jet2<f64, D>) -> Vec<f64>) -> Vec<f64> {
        self.calls.fetch_add(1, Ordering::Relaxed);
        let jets = |x: &[f64]| {
            let x: [f64; D] = x.try_into().expect("D coordinates");
            self.formula.gram(&SVector::from(Jet2::variables(&x))).transpose()
        };
        x.chunks(D).flat_map(|x| jets(x).iter().flat_map(of).collect::<Vec<_>>()).collect()
    }
}

impl<const D: usize> Values for Hidden<D> {
    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.all(x, |jet| vec![jet.value()])
    }

    fn first(&self, x: &[f64]) -> Option<Vec<f64>> {
        let of = |jet: &Jet2<f64, D>| (0..D).map(|k| jet.first(k)).collect();
        (self.order >= 1).then(|| self.all(x, of))
    }

    fn second(&self, x: &[f64]) -> Option<Vec<f64>> {
        let of = |jet: &Jet2<f64, D>| {
            let pairs = (0..D).flat_map(|k| (0..D).map(move |l| (k.min(l), k.max(l))));
            pairs.map(|(k, l)| jet.second(k, l)).collect()
        };
        (self.order >= 2).then(|| self.all(x, of))
    }
}

const FULL: &str = "a = sin(x1 - 2*x2); b = cos(x1*x3/2); [4 + a, a*b, b/3; a*b, 5 - b, a/2; b/3, \
                    a/2, 4 + x3^2/4]";
/// The step of the differences.
const H: f64 = 1e-3;

/// The derivatives of `FULL` at the points below are at most 2⁵ times 10 in every order up to five:
/// `SIZE` bounds them, and the sums of nine products with `|d| ≤ 1`.
const SIZE: f64 = 9.0 * 320.0;

/// Returns all rows of a kind at some points.
fn rows(metric: &dyn AnyBatches, kind: Kind) -> Vec<(&'static str, Vec<f64>)> {
    let mut batch = Batch::new(metric, kind, 5, 1);
    let mut inputs = batch.inputs(5);
    for lane in 0..5 {
        let t = lane as f64;
        let x = vector![0.4 - 0.2 * t, 0.3 * t, -0.5 + 0.25 * t];
        inputs.set(lane, &x, &vector![0.6, -0.5 + 0.1 * t, 0.4]);
    }
    assert!(batch.evaluate(5), "{kind:?}");
    let layout = batch.layout();
    let lists = [
        ("square", &layout.square),
        ("momentum", &layout.momentum),
        ("slope", &layout.slope),
        ("gram", &layout.gram),
        ("turn", &layout.turn),
        ("bend", &layout.bend),
    ];
    let all = |list: &Vec<_>| list.iter().flat_map(|&row| batch.row(row)[..5].to_vec()).collect();
    lists.map(|(name, list)| (name, all(list))).to_vec()
}

/// Derivatives that are given are exact. Those from differences have the errors of the documentation,
/// with roundings of `ε SIZE / h` for each difference.
#[test]
fn a_black_box_has_the_rows_of_its_formula() {
    let plain = Plain::new(parsed::<3>(FULL));
    let rounding = f64::EPSILON * SIZE;
    let (first, second) = (H.powi(4) * SIZE / 30.0 + 2.0 * rounding / H, 8.0 * rounding / (H * H));
    for (order, slopes, bends) in
        [(2, rounding, rounding), (1, rounding, first), (0, first, second)]
    {
        let black_box = BlackBox::<3>::new(Hidden::<3>::new(FULL, order), H).expect("a step");
        let black_box = Prepared::of_black_box(parsed::<3>(FULL), black_box);
        for kind in [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction] {
            for ((name, found), (_, expected)) in
                rows(&black_box, kind).iter().zip(rows(&plain, kind))
            {
                let tolerance = match *name {
                    "slope" | "turn" => slopes,
                    "bend" => bends,
                    _ => rounding,
                };
                assert_eq!(found.len(), expected.len(), "{name} {kind:?}");
                for (found, expected) in found.iter().zip(expected) {
                    let off = (found - expected).abs();
                    assert!(off <= tolerance, "order {order}, {name} {kind:?}: {off:e}");
                }
            }
        }
    }
}

/// The same derivatives along vectors.
struct Along<const D: usize>(Arc<Hidden<D>>);

impl<const D: usize> Along<D> {
    /// Returns the sums over the entries `(i, j)`, each with `size` numbers, times `weights(v)`.
    fn sums(all: &[f64], v: &[f64], size: usize, rows: bool) -> Vec<f64> {
        let at = |(all, v): (&[f64], &[f64])| -> Vec<f64> {
            let entry = |i: usize, j: usize| &all[(i * D + j) * size..][..size];
            let row = |i: usize, n: usize| (0..D).map(|j| entry(i, j)[n] * v[j]).sum::<f64>();
            if rows {
                return (0..D)
                    .flat_map(|i| (0..size).map(move |n| (i, n)))
                    .map(|(i, n)| row(i, n))
                    .collect();
            }
            (0..size).map(|n| (0..D).map(|i| v[i] * row(i, n)).sum()).collect()
        };
        all.chunks(D * D * size).zip(v.chunks(D)).flat_map(at).collect()
    }
}

impl<const D: usize> Values for Along<D> {
    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.0.gram(x)
    }

    fn is_along(&self) -> bool {
        true
    }

    fn first_along(&self, x: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        Some(Self::sums(&self.0.first(x)?, v, D, true))
    }

    fn second_along(&self, x: &[f64], v: &[f64]) -> Option<Vec<f64>> {
        Some(Self::sums(&self.0.second(x)?, v, D * D, false))
    }
}

/// Derivatives along vectors are exact if they are given; the second ones are otherwise differences.
#[test]
fn derivatives_along_vectors_give_the_same_rows() {
    let plain = Plain::new(parsed::<3>(FULL));
    let rounding = f64::EPSILON * SIZE;
    let first = H.powi(4) * SIZE / 30.0 + 2.0 * rounding / H;
    for (order, bends) in [(2, rounding), (1, first)] {
        let values = Arc::new(Along(Hidden::<3>::new(FULL, order)));
        let black_box = BlackBox::<3>::new(values, H).expect("a step");
        let black_box = Prepared::of_black_box(parsed::<3>(FULL), black_box);
        for kind in [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction] {
            for ((name, found), (_, expected)) in
                rows(&black_box, kind).iter().zip(rows(&plain, kind))
            {
                let tolerance = if *name == "bend" { bends } else { rounding };
                assert_eq!(found.len(), expected.len(), "{name} {kind:?}");
                for (found, expected) in found.iter().zip(expected) {
                    let off = (found - expected).abs();
                    assert!(off <= tolerance, "order {order}, {name} {kind:?}: {off:e}");
                }
            }
        }
    }
}

/// Numbers that are missing are undefined, and no panic; along vectors the dimension has no limit.
#[test]
fn derivatives_along_vectors_in_many_dimensions_or_missing() {
    struct Short;
    impl Values for Short {
        fn gram(&self, x: &[f64]) -> Vec<f64> {
            x.chunks(3).flat_map(|_| [1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0]).collect()
        }

        fn is_along(&self) -> bool {
            true
        }

        fn first_along(&self, x: &[f64], _v: &[f64]) -> Option<Vec<f64>> {
            Some(vec![0.0; x.len()])
        }
    }
    let short = BlackBox::<3>::new(Arc::new(Short), H).expect("a step");
    let short = Prepared::of_black_box(parsed::<3>("1 I"), short);
    let of = |name: &str| {
        let found = rows(&short, Kind::Contraction);
        found.into_iter().find(|&(other, _)| other == name).expect("a row").1
    };
    assert!(of("turn").iter().chain(&of("bend")).all(|x| x.is_nan()));
    let dimension = BlackBox::<ANY>::LARGEST_DIMENSION + 1;
    assert!(BlackBox::<ANY>::new_in(dimension, Arc::new(Short), H).is_some());
    assert!(BlackBox::<ANY>::new_in(dimension, Hidden::<3>::new(FULL, 2), H).is_none());
    assert!(BlackBox::<ANY>::new_in(0, Arc::new(Short), H).is_none());
}

/// A black box whose derivatives are not filled in below the diagonal.
struct Upper<const D: usize>(Arc<Hidden<D>>);

impl<const D: usize> Upper<D> {
    /// Overwrites what is below the diagonal; there are `size` numbers for each entry.
    fn spoilt(mut all: Vec<f64>, size: usize) -> Vec<f64> {
        for (place, numbers) in all.chunks_mut(size).enumerate() {
            if place / D % D > place % D {
                numbers.fill(f64::NAN);
            }
        }
        all
    }
}

impl<const D: usize> Values for Upper<D> {
    fn gram(&self, x: &[f64]) -> Vec<f64> {
        self.0.gram(x)
    }

    fn first(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.0.first(x).map(|all| Self::spoilt(all, D))
    }

    fn second(&self, x: &[f64]) -> Option<Vec<f64>> {
        self.0.second(x).map(|all| Self::spoilt(all, D * D))
    }
}

/// The half on and above the diagonal is that of `H`, for derivatives too, and also where second
/// derivatives are differences of first ones.
#[test]
fn derivatives_below_the_diagonal_are_not_read() {
    for order in [1, 2] {
        let of = |values: Arc<dyn Values>| {
            let black_box = BlackBox::<3>::new(values, H).expect("a step");
            let metric = Prepared::of_black_box(parsed::<3>(FULL), black_box);
            [Kind::Checked, Kind::Momentum, Kind::Contraction].map(|kind| rows(&metric, kind))
        };
        let hidden = || Hidden::<3>::new(FULL, order);
        assert_eq!(of(Arc::new(Upper(hidden()))), of(hidden()), "order {order}");
    }
}

/// A call from another language costs as much as some dozen points.
#[test]
fn a_batch_of_a_black_box_takes_one_call_for_each_order() {
    for (order, calls) in [(2, 3), (1, 3), (0, 2)] {
        let hidden = Hidden::<3>::new(FULL, order);
        let black_box = BlackBox::<3>::new(hidden.clone(), H).expect("a step");
        rows(&Prepared::of_black_box(parsed::<3>(FULL), black_box), Kind::Contraction);
        assert_eq!(hidden.calls.load(Ordering::Relaxed), calls, "order {order}");
    }
}

/// Derivatives that are known at some points and not at others are undefined, and no panic.
#[test]
fn slopes_that_are_known_at_one_point_only_have_undefined_bends() {
    struct Once(Arc<Hidden<2>>);
    impl Values for Once {
        fn gram(&self, x: &[f64]) -> Vec<f64> {
            self.0.gram(x)
        }

        fn first(&self, x: &[f64]) -> Option<Vec<f64>> {
            (x == [1.0, 2.0]).then(|| self.0.first(x)).flatten()
        }
    }
    let hidden = Hidden::<2>::new("[3 + sin(x1), x2; x2, 4 + x2^2]", 1);
    let black_box = BlackBox::<2>::new(Arc::new(Once(hidden)), H).expect("a step");
    assert_eq!(black_box.gram(&vector![1.0, 2.0])[(1, 1)], 8.0);
    let h = black_box.gram(&SVector::from(Jet2::<f64, 2>::variables(&[1.0, 2.0])));
    assert!(h[(1, 1)].second(1, 1).is_nan());
}

#[test]
fn a_black_box_is_refused_where_it_is_no_metric() {
    // Not symmetric, though each half alone is that of a metric; not positive definite; not finite, in
    // the half that is used or in the other one. Each is a metric at 1 or at neither point.
    for (text, at_one) in [
        ("[2, x1; 0, 2]", false),
        ("[2, 0; x1, 2]", false),
        ("[2, 0.1*x1; 0.1*x1^2, 2]", true),
        ("[1, x1; x1, 1]", false),
        ("[1, 0; 0, x1]", true),
        ("[1, 0; 0, 1 + ln(x1)]", true),
        ("[2, 0; ln(x1), 2]", true),
    ] {
        for (x, is_metric) in [(-1.0, false), (1.0, at_one)] {
            for (kind, order) in [
                (Kind::Checked, 0),
                (Kind::Momentum, 0),
                (Kind::Momentum, 1),
                (Kind::Contraction, 0),
                (Kind::Contraction, 2),
            ] {
                let hidden = Hidden::<2>::new(text, order);
                let black_box = BlackBox::<2>::new(hidden, H).expect("a step");
                let metric = Prepared::of_black_box(parsed::<2>(text), black_box);
                let mut batch = Batch::new(&metric, kind, 1, 1);
                batch.inputs(1).set(0, &vector![x, 0.0], &vector![1.0, 1.0]);
                assert_eq!(batch.evaluate(1), is_metric, "{text} {x} {kind:?} {order}");
            }
        }
    }
}

#[test]
fn a_black_box_has_jets_but_neither_intervals_nor_a_formula() {
    const WAVES: &str = "[3 + sin(x1), x2; x2, 4 + x2^2]";
    let black_box = BlackBox::<2>::new(Hidden::<2>::new(WAVES, 2), H).expect("a step");
    assert_eq!(Formula::record(&black_box), Err(RecordError::BlackBox));
    let boxes = vector![Interval::constant(0.5), Interval::constant(0.25)];
    assert!(black_box.gram(&boxes).iter().all(|entry| entry.lo().is_nan()));
    let x = SVector::from(Jet2::<f64, 2>::variables(&[0.5, 0.25]));
    let (found, expected): (SMatrix<_, 2, 2>, _) =
        (black_box.gram(&x), parsed::<2>(WAVES).gram(&x));
    for (found, expected) in found.iter().zip(&expected) {
        let parts = |jet: &Jet2<f64, 2>| {
            let second = [(0, 0), (0, 1), (1, 1)].map(|(k, l)| jet.second(k, l));
            [jet.value(), jet.first(0), jet.first(1), second[0], second[1], second[2]]
        };
        for (found, expected) in parts(found).into_iter().zip(parts(expected)) {
            // A dozen operations on numbers below 5.
            assert!((found - expected).abs() <= 1e-14, "{found} {expected}");
        }
    }
}

/// Each entry and each derivative is in its place, also if `H` is not symmetric. All derivatives of
/// the entries up to order six are at most 64 here. Differences of two directions have an error of
/// `h² (∂ₖ³∂ₗH + ∂ₖ∂ₗ³H) / 6`.
#[test]
fn the_jets_of_a_black_box_are_those_of_its_formula() {
    const PLACES: &str = "[4 + x1*x2, sin(x1 - 2*x2), x3^2; cos(x2*x3), 5, x1; x2^3, x1*x3, 6]";
    let place = vector![0.5_f64, -0.3, 0.7];
    let x = SVector::from(Jet2::<f64, 3>::variables(&[0.5, -0.3, 0.7]));
    let formula = parsed::<3>(PLACES);
    let rounding = 64.0 * f64::EPSILON;
    let first = 64.0 * H.powi(4) / 30.0 + 2.0 * rounding / H;
    let second = 64.0 * H.powi(2) / 3.0 + 8.0 * rounding / H.powi(2);
    for (order, slopes, bends) in
        [(2, rounding, rounding), (1, rounding, first), (0, first, second)]
    {
        let black_box = BlackBox::<3>::new(Hidden::<3>::new(PLACES, order), H).expect("a step");
        let off = black_box.gram(&place) - formula.gram(&place);
        assert!(off.abs().max() <= rounding, "order {order}: {off}");
        let (found, expected): (SMatrix<_, 3, 3>, _) = (black_box.gram(&x), formula.gram(&x));
        for (n, (found, expected)) in found.iter().zip(&expected).enumerate() {
            let near = |a: f64, b: f64, tolerance: f64| {
                assert!((a - b).abs() <= tolerance, "order {order}, entry {n}: {a} {b}");
            };
            near(found.value(), expected.value(), rounding);
            for k in 0..3 {
                near(found.first(k), expected.first(k), slopes);
                for l in k..3 {
                    near(found.second(k, l), expected.second(k, l), bends);
                }
            }
        }
    }
}

#[test]
fn a_step_is_positive_and_finite() {
    for step in [0.0, -1e-3, f64::NAN, f64::INFINITY] {
        assert!(BlackBox::<2>::new(Hidden::<2>::new("phi(1)", 0), step).is_none(), "{step}");
    }
}
