//! Compares the derivatives of every metric of the gallery and of every composition, over random
//! boxes, with the derivatives at points of the boxes in high precision.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

use std::any::type_name;

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_metrics::{Metric, composition::*, gallery::*, norm_squared};
use tautline_scalar::{Fast, FastInterval, Interval, Jet1, Jet2, Rigorous, Scalar};

use crate::{
    precise::{Cell, Precise, Tally},
    reference::Random,
};

/// The results recorded for a metric.
#[derive(Clone, Debug)]
pub(crate) struct Record {
    pub(crate) name: &'static str,
    pub(crate) dimension: usize,
    pub(crate) tally: Tally,
    /// The widest entries of `H`, of its first and of its second derivatives at a point within
    /// `reach`, in units of `2⁻⁵²` of the largest entry of all three at that point. (Relative to
    /// the entry itself the widths would mean little, since derivatives may cancel.)
    pub(crate) widest: [f64; 3],
}

impl Record {
    pub(crate) fn add(&mut self, other: &Self) {
        assert_eq!((self.name, self.dimension), (other.name, other.dimension));
        self.tally.add(other.tally);
        for (widest, other) in self.widest.iter_mut().zip(other.widest) {
            *widest = widest.max(other);
        }
    }
}

/// Tries every metric on as many boxes as it takes to make the given number of comparisons.
#[derive(Debug)]
pub(crate) struct Trial {
    pub(crate) random: Random,
    pub(crate) comparisons: u64,
    pub(crate) records: Vec<Record>,
}

impl Trial {
    /// Tries a metric with coordinates of about the size `reach`. It uses the recorded formula,
    /// which gives the same bits, so that this code is compiled only once for each dimension.
    #[track_caller]
    fn metric<M: Metric<D>, const D: usize>(&mut self, metric: &M, reach: f64) {
        let path = type_name::<M>().split('<').next().expect("a first part");
        let name = path.rsplit("::").next().expect("a last part");
        let mut record = Record { name, dimension: D, tally: Tally::default(), widest: [0.0; 3] };
        let formula = Formula::record(metric).expect("no metric of the gallery compares");
        // At least four boxes are tried, and the loop also ends for a metric with nothing to
        // compare.
        let mut boxes = 0_u32;
        while boxes < 4 || (record.tally.compared < self.comparisons && boxes < 1_000_000) {
            attempt(&formula, reach, &mut self.random, &mut record);
            boxes += 1;
        }
        self.records.push(record);
    }
}

/// The entries of `H`, of its first and of its second derivatives.
type Orders<S> = [Vec<S>; 3];

fn second_order<S: Scalar, const D: usize>(metric: &Formula<D>, x: [S; D]) -> Orders<S> {
    let h = metric.gram(&SVector::from(Jet2::variables(&x)));
    let first = h.iter().flat_map(|entry| *entry.gradient());
    let second = h.iter().flat_map(|entry| pairs::<D>().map(|(k, l)| entry.second(k, l)));
    [h.iter().map(Jet2::value).collect(), first.collect(), second.collect()]
}

/// Returns the same, computed as first derivatives of first derivatives.
fn nested<S: Scalar, const D: usize>(metric: &Formula<D>, x: [S; D]) -> Orders<S> {
    let h = metric.gram(&SVector::from(Jet1::variables(&Jet1::<S, D>::variables(&x))));
    let first = h.iter().flat_map(|entry| *entry.value().gradient());
    let second = h.iter().flat_map(|entry| pairs::<D>().map(|(k, l)| entry.first(k).first(l)));
    [h.iter().map(|entry| entry.value().value()).collect(), first.collect(), second.collect()]
}

fn pairs<const D: usize>() -> impl Iterator<Item = (usize, usize)> {
    (0..D).flat_map(|l| (0..=l).map(move |k| (k, l)))
}

/// Tries one box and two of its points: every entry with both kernels and both kinds of jets, and
/// the length of a vector with both kernels.
#[track_caller]
fn attempt<const D: usize>(
    metric: &Formula<D>,
    reach: f64,
    random: &mut Random,
    record: &mut Record,
) {
    let cell = Cell::<D>::random(reach, random);
    let over = cell.intervals::<Rigorous>();
    let u = SVector::from_fn(|_, _| random.between(-2.0, 2.0));
    let (rigorous, twice) = (second_order(metric, over), nested(metric, over));
    let fast = second_order(metric, cell.intervals::<Fast>());
    let length: Interval = norm_squared(metric, &SVector::from(over), &u);
    let fast_length: FastInterval = norm_squared(metric, &SVector::from(cell.intervals()), &u);
    for _ in 0..2 {
        Precise::forget_all();
        let point = cell.point(random);
        let at = second_order(metric, point);
        let name = record.name;
        let check = |what: &str, outcome: Result<(), String>| {
            outcome.unwrap_or_else(|miss| {
                panic!("{name} in dimension {D}, {what}: {miss}\nin {cell:?} at {point:?}")
            });
        };
        let tally = &mut record.tally;
        for order in 0..3 {
            assert_eq!(at[order].len(), rigorous[order].len());
            for (k, &value) in at[order].iter().enumerate() {
                let what = |jet: &str| format!("{jet}, order {order}, entry {k}");
                check(&what("Jet2"), tally.compare(rigorous[order][k], value));
                check(&what("fast Jet2"), tally.compare(fast[order][k], value));
                check(&what("nested Jet1"), tally.compare(twice[order][k], value));
            }
        }
        let value: Precise = norm_squared(metric, &SVector::from(point), &u);
        check("length", tally.compare(length, value));
        check("fast length", tally.compare(fast_length, value));
    }
    if cell.is_point() && cell.is_within(reach) {
        let size = rigorous.iter().flatten().map(|x| x.magnitude()).fold(0.0, f64::max);
        for (widest, entries) in record.widest.iter_mut().zip(&rigorous) {
            // The width of an undefined interval is NaN, which `max` ignores.
            let width = entries.iter().map(|x| x.width()).fold(0.0, f64::max);
            *widest = widest.max(width / size / f64::EPSILON);
        }
    }
}

/// Tries every metric of the gallery and every composition, with parameters that are not dyadic.
/// Metrics of any dimension are tried in one, two and three dimensions.
pub(crate) fn try_all(trial: &mut Trial) {
    let full = SMatrix::<f64, 3, 3>::new(2.0, 0.3, 0.1, 0.3, 1.7, -0.4, 0.1, -0.4, 1.1);
    trial.metric(&Constant::new(full).expect("positive definite"), 1.0);
    in_three(trial, &Valleys, 7.0);
    trial.metric(&Ramp::new(0.7, 1.3).expect("below one"), 3.0);
    trial.metric(&Separable::<1>::new([0.7], [3.3]).expect("below one"), 3.0);
    trial.metric(&Separable::<3>::new([0.3, 0.5, -0.4], [1.1, 2.0, 1.7]).expect("below one"), 3.0);
    trial.metric(&Shear::new(0.7, 1.3).expect("a wave number"), 6.0);
    in_three(trial, &Lens::new(1.3, 0.6).expect("a width"), 2.0);
    in_three(trial, &Bump::new(1.3, 0.6).expect("a width"), 2.0);
    in_three(trial, &Hill::new(0.7, 0.6).expect("a width"), 2.0);
    let one = Obstacle { centre: [0.1, -0.3].into(), height: 2.3, width: 0.6 };
    let two = Obstacle { centre: [1.1, 0.9].into(), height: 0.7, width: 0.3 };
    trial.metric(&SoftObstacles::new(vec![one, two]).expect("widths"), 2.0);
    trial.metric(&Swirl::new(1.3, 0.6).expect("a width"), 2.0);
    trial.metric(&EggCrate::new(0.7, 1.3).expect("a wave number"), 6.0);
    in_three(trial, &Corrugated::new(0.7, 1.3).expect("a wave number"), 6.0);
    trial.metric(&Checkerboard::new(2.3, 0.9).expect("a side"), 2.0);
    trial.metric(&TwoChannels::new(2.3, 0.9, 0.4).expect("a width"), 2.0);
    trial.metric(&RotatingAnisotropy::new([0.9, 4.1], [0.7, -1.1]).expect("eigenvalues"), 3.0);
    trial.metric(&TwoLinkArm::new(4.1, 0.7, 1.1).expect("positive definite"), 6.0);
    trial.metric(&CoupledCosines, 6.0);
    let term =
        |w: [f64; 3], a: [f64; 3]| SineProjection { wave_vector: w.into(), direction: a.into() };
    let terms =
        vec![term([0.7, -1.1, 0.3], [0.9, 0.2, -0.6]), term([1.3, 0.4, 0.8], [0.1, 1.1, 0.7])];
    trial.metric(&SineProjections::new(terms).expect("finite entries"), 3.0);
    in_three(trial, &Sphere, 2.0);
    in_three(trial, &Hyperbolic, 0.9);
    trial.metric(&GaussianFisher, 3.0);
    in_three(trial, &SpherePatch::new(0.9).expect("a radius"), 2.0);
    in_three(trial, &HyperbolicPatch::new(0.6).expect("below 0.86"), 1.0);
    trial.metric(&GaussianFisherPatch::new(0.7).expect("a rim"), 2.0);
    let inner = SMatrix::<f64, 3, 2>::new(1.0, 0.2, -0.5, 0.8, 0.3, -1.0);
    let outer = SMatrix::<f64, 2, 3>::new(1.0, 0.1, 0.5, -0.3, 0.9, -0.5);
    trial.metric(&TanhDecoder::new(inner, outer, 0.3).expect("a floor"), 4.0);
    let shear = Shear::new(0.7, 1.3).expect("a wave number");
    trial.metric::<_, 2>(&Scaled::new(shear, 1.7).expect("a factor"), 6.0);
    trial.metric::<_, 2>(&Sum::new(shear, Sphere), 2.0);
    trial.metric::<_, 3>(&Product::<_, _, 2, 1>::new(shear, Valleys), 6.0);
    let matrix = SMatrix::<f64, 2, 2>::new(1.1, 0.3, -0.4, 0.9);
    let pullback = AffinePullback::new(GaussianFisher, matrix, [0.3, -0.7]);
    trial.metric(&pullback.expect("invertible"), 3.0);
}

fn in_three(trial: &mut Trial, metric: &(impl Metric<1> + Metric<2> + Metric<3>), reach: f64) {
    trial.metric::<_, 1>(metric, reach);
    trial.metric::<_, 2>(metric, reach);
    trial.metric::<_, 3>(metric, reach);
}
