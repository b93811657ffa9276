//! Compares programs with jets of intervals, evaluated with the formula itself.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{cases, seed};
use tautline_formula::{AnyBatches, Batch, Formula, InstructionSet, Kind, Layout, Plain, Prepared};
use tautline_metrics::{Metric, gallery, is_gram};
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::{random::Random, random_formulas::Trees, squares::decoder};

/// A program rounds in another order than the formula. Points are therefore enclosed together with
/// their neighbours, this many units in the last place on either side. A result may be off by as
/// much as it changes over this range.
const NEIGHBOURS: f64 = 16.0;

fn nearby(x: f64) -> Interval {
    let reach = NEIGHBOURS * f64::EPSILON * x.abs();
    Interval::new(x - reach, x + reach).expect("ordered ends")
}

/// The kinds of rows, in the order of [`rows`].
const NAMES: [&str; 6] = ["dᵀHd", "Hd", "G", "H", "P", "Q"];

/// Returns enclosures of these rows at a point.
fn enclosed<const D: usize>(metric: &impl Metric<D>, (x, d): &Place<D>) -> [Vec<Interval>; 6] {
    let places: [Interval; D] = std::array::from_fn(|i| nearby(x[i]));
    let d = d.map(nearby);
    let jets = metric.gram(&SVector::from(Jet2::variables(&places)));
    let gram = jets.map(|jet| jet.value());
    let first = |k: usize| jets.map(|jet| jet.first(k)) * d;
    let second = |k: usize, l: usize| jets.map(|jet| jet.second(k, l)) * d;
    let matrix = |entry: &dyn Fn(usize, usize) -> Interval| {
        (0..D * D).map(|n| entry(n / D, n % D)).collect()
    };
    [
        vec![d.dot(&(gram * d))],
        (gram * d).iter().copied().collect(),
        (0..D).map(|k| d.dot(&first(k))).collect(),
        matrix(&|i, j| gram[(i, j)]),
        matrix(&|i, k| first(k)[i]),
        matrix(&|k, l| d.dot(&second(k, l))),
    ]
}

/// Returns whether a number is close to its enclosure. Any number is close to an unbounded one.
fn is_near(found: f64, expected: Interval) -> bool {
    let width = expected.hi() - expected.lo();
    let margin = width + f64::MIN_POSITIVE;
    !width.is_finite() || (expected.lo() - margin <= found && found <= expected.hi() + margin)
}

pub(crate) type Place<const D: usize> = (SVector<f64, D>, SVector<f64, D>);

pub(crate) fn evaluate<const D: usize>(batch: &mut Batch<'_>, places: &[Place<D>]) -> bool {
    let mut inputs = batch.inputs(places.len());
    for (lane, (x, d)) in places.iter().enumerate() {
        inputs.set(lane, x, d);
    }
    batch.evaluate(places.len())
}

/// Compares all rows of all lanes, both of the programs and of the compiled formula. Returns how
/// many numbers had a bounded enclosure.
fn compare<const D: usize>(metric: &impl Metric<D>, places: &[Place<D>]) -> usize {
    let formula = Formula::record(metric).expect("no comparison");
    let text = formula.to_string();
    let prepared = Prepared::new(&formula);
    assert!(prepared.size(Kind::Contraction).is_some());
    let known = compare_one(metric, &prepared, places, &text);
    assert_eq!(compare_one(metric, &Plain::new(metric), places, &text), known);
    known
}

pub(crate) fn compare_one<const D: usize>(
    metric: &impl Metric<D>,
    batches: &dyn AnyBatches,
    places: &[Place<D>],
    text: &str,
) -> usize {
    let enclosed: Vec<_> = places.iter().map(|place| enclosed(metric, place)).collect();
    let mut known = 0;
    for kind in KINDS {
        let mut batch = Batch::new(batches, kind, 1, usize::MAX);
        let lanes = batch.lanes();
        for (places, enclosed) in places.chunks(lanes).zip(enclosed.chunks(lanes)) {
            let is_metric = evaluate(&mut batch, places);
            if kind != Kind::Square {
                let are_grams = places.iter().all(|(x, _)| is_gram(&metric.gram(x)));
                assert_eq!(is_metric, are_grams, "{text}");
            }
            for (what, found) in rows(&batch, places.len()).into_iter().enumerate() {
                for (n, found) in found.into_iter().enumerate() {
                    let (row, lane) = (n / places.len(), n % places.len());
                    let (expected, (x, d)) = (enclosed[lane][what][row], places[lane]);
                    assert!(
                        is_near(found, expected),
                        "{} {found:e} not in {expected:?} at {x:?} along {d:?}: {text}",
                        NAMES[what]
                    );
                    known += usize::from((expected.hi() - expected.lo()).is_finite());
                }
            }
        }
    }
    known
}

pub(crate) fn places<const D: usize>(count: usize) -> Vec<Place<D>> {
    let at = |k: usize, i: usize| ((k as f64 + 0.5) * (0.618 + 0.755 * i as f64)).fract() - 0.5;
    (0..count)
        .map(|k| {
            (SVector::from_fn(|i, _| 2.0 * at(k, i)), SVector::from_fn(|i, _| at(k + 7, i + 3)))
        })
        .collect()
}

const KINDS: [Kind; 3] = [Kind::Square, Kind::Momentum, Kind::Contraction];

/// Returns the first `count` lanes of the rows of `dᵀHd`, `Hd`, `G`, `H`, `P` and `Q`, one list for
/// each.
pub(crate) fn rows(batch: &Batch<'_>, count: usize) -> [Vec<f64>; 6] {
    let Layout { square, momentum, slope, gram, turn, bend, .. } = batch.layout();
    [square, momentum, slope, gram, turn, bend].map(|registers| {
        registers.iter().flat_map(|&register| &batch.row(register)[..count]).copied().collect()
    })
}

/// Requires that all numbers of all kinds are known: `dᵀHd`; with `Hd` and `G`; `H`, `G`, `P` and
/// `Q`.
#[track_caller]
pub(crate) fn all<const D: usize>(metric: &impl Metric<D>) {
    let known = compare(metric, &places(100));
    assert_eq!(known, 100 * (1 + 1 + 2 * D + D + 3 * D * D));
}

#[test]
fn the_gallery_is_contracted_by_programs() {
    all::<1>(&gallery::Valleys);
    all::<2>(&gallery::Valleys);
    all(&gallery::Shear::new(0.5, 1.0).expect("a wave number"));
    all::<2>(&gallery::Bump::new(0.5, 1.0).expect("positive"));
    all::<2>(&gallery::Lens::new(0.5, 1.0).expect("positive"));
    all::<2>(&gallery::Hill::new(0.5, 1.0).expect("positive"));
    all(&gallery::Ramp::new(0.5, 1.0).expect("below one"));
    all(&gallery::Separable::new([0.3, -0.5, 0.7], [1.0, 2.0, 3.0]).expect("below one"));
    all(&gallery::CoupledCosines);
    all(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).expect("positive"));
    all(&gallery::SineProjections::benchmark());
    all::<2>(&gallery::Sphere);
    all(&gallery::Constant::<3>::new(SMatrix::identity()).expect("definite"));
}

#[test]
fn random_formulas_are_contracted_by_programs() {
    let mut random = Random(seed(2711));
    let mut known = 0;
    for _ in 0..cases(2000) {
        let trees = Trees::random(&mut random, 4);
        let places: Vec<Place<2>> = (0..3)
            .map(|_| [(); 2].map(|()| SVector::from_fn(|_, _| random.number() / 2.0)))
            .map(|[x, d]| (x, d))
            .collect();
        known += compare(&trees, &places);
    }
    assert!(known > 0);
    println!("{known} numbers were known");
}

/// This is checked for all block sizes and instruction sets.
#[test]
fn neither_the_block_nor_the_processor_changes_a_bit() {
    fn bits<const D: usize>(programs: &dyn AnyBatches, places: &[Place<D>]) -> Vec<u64> {
        let mut all = Vec::new();
        for kind in KINDS {
            let mut batch = Batch::new(programs, kind, 1, usize::MAX);
            for places in places.chunks(batch.lanes()) {
                evaluate(&mut batch, places);
                let rows = rows(&batch, places.len()).concat();
                for lane in 0..places.len() {
                    all.extend(rows.iter().skip(lane).step_by(places.len()).map(|x| x.to_bits()));
                }
            }
        }
        all
    }
    fn same<const D: usize>(metric: &impl Metric<D>) {
        let formula = Formula::record(metric).expect("no comparison");
        let places = places::<D>(131);
        let expected = bits(&Prepared::new(&formula), &places);
        for lanes in [8, 16, 40, 64, 128] {
            for instruction_set in [InstructionSet::Baseline, InstructionSet::Widest] {
                let programs = Prepared::with(&formula, instruction_set, lanes);
                assert!(bits(&programs, &places) == expected, "{lanes} lanes, {instruction_set:?}");
            }
        }
    }
    same::<2>(&gallery::Valleys);
    same(&gallery::SineProjections::benchmark());
    same(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).expect("positive"));
    same(&gallery::CoupledCosines);
}

/// `H′(x) = (m/ℓ)² H(x/ℓ)`: the same metric in other units.
struct InUnits<M> {
    metric: M,
    ell: f64,
    m: f64,
}

impl<M: Metric<D>, const D: usize> Metric<D> for InUnits<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let factor = (self.m / self.ell).powi(2);
        self.metric.gram(&x.map(|x| x / self.ell)).map(|entry| entry * factor)
    }
}

/// Units that are powers of two change only exponents.
#[test]
fn powers_of_two_change_no_bit() {
    fn with_units<const D: usize>(metric: &impl Metric<D>, ell: f64, m: f64) -> Vec<[f64; 2]> {
        let prepared = Prepared::new(metric);
        let mut numbers = Vec::new();
        let places: Vec<Place<D>> =
            places::<D>(40).into_iter().map(|(x, d)| (x * ell, d * ell)).collect();
        for kind in KINDS {
            let mut batch = Batch::new(&prepared, kind, 40, 1);
            evaluate(&mut batch, &places);
            // The units of dᵀHd, Hd, G, H, P and Q.
            let units = [0, 1, 1, 2, 2, 2].map(|power| m * m / ell.powi(power));
            for (rows, unit) in rows(&batch, 40).into_iter().zip(units) {
                numbers.extend(rows.into_iter().map(|value| [value, unit]));
            }
        }
        numbers
    }
    #[track_caller]
    fn same<const D: usize>(metric: &impl Metric<D>) {
        let text = Formula::record(metric).expect("no comparison");
        let here = with_units(metric, 1.0, 1.0);
        for (ell, m) in [(0.5, 1.0), (2.0, 0.25), (1024.0, 1024.0), (0.125, 4.0)] {
            let there = with_units(&InUnits { metric, ell, m }, ell, m);
            for ([here, _], [there, unit]) in here.iter().zip(&there) {
                let same = here * unit == *there || here.is_nan() && there.is_nan();
                assert!(same, "ℓ = {ell}, m = {m}: {here:e} {unit} {there:e}: {text}");
            }
        }
    }
    same::<2>(&gallery::Valleys);
    same(&gallery::Shear::new(0.3, 1.1).expect("a wave number"));
    same::<2>(&gallery::Bump::new(0.3, 1.3).expect("positive"));
    same::<2>(&gallery::Hill::new(0.3, 0.7).expect("positive"));
    same(&gallery::Separable::new([0.3, -0.5, 0.0], [1.1, 2.3, 3.7]).expect("below one"));
    same(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.1, 0.3]).expect("positive"));
    same(&gallery::SineProjections::benchmark());
    same(&gallery::CoupledCosines);
    same(&decoder::<2, 6, 4>());
    same(&decoder::<4, 6, 4>());
    same::<3>(&gallery::Hyperbolic);
    same::<2>(&gallery::Sphere);
}
