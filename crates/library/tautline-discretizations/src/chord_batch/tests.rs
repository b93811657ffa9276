//! Batches of chords against one chord at a time.

use nalgebra::{SMatrix, SVector, vector};
use tautline_formula::{AnyBatches, Kind, Plain, Prepared};
use tautline_metrics::{Lanes, Metric, Pair, Scalar, gallery::Swirl};

use super::ChordBatch;
use crate::{ChordModel, ChordModels, LinearModel, Node, PointSequence, Rule};

type Chord<'p, const D: usize> = (&'p SVector<f64, D>, SVector<f64, D>);

fn batch(rule: Rule, metric: &dyn AnyBatches, n: f64) -> ChordBatch<'_> {
    ChordBatch::new(metric, Kind::Contraction, rule.nodes(), n, 2)
}

/// Returns the coordinates of both points of a chord.
fn points<const D: usize>((x, d): Chord<'_, D>) -> Vec<f64> {
    x.iter().copied().chain((x + d).iter().copied()).collect()
}

/// Returns the model of one chord as it is assembled in any dimension.
fn assembled<const D: usize>(batch: &ChordBatch<'_>, end: usize) -> ChordModel<D> {
    let mut models = ChordModels::default();
    // Memory of other chords before: nothing of it remains.
    batch.assemble(1 - end, 1, &mut models);
    batch.assemble(end, 1, &mut models);
    let symmetric = |end: usize| {
        let lower = SMatrix::<f64, D, D>::from_column_slice(models.hessian(end, 0));
        SMatrix::from_fn(|i, j| lower[(i.max(j), i.min(j))])
    };
    ChordModel {
        energy: models.energy(0),
        trace: models.trace(0),
        gradient: [0, 1].map(|end| SVector::from_column_slice(models.gradient(end, 0))),
        hessian: [symmetric(0), symmetric(1)],
        coupling: SMatrix::<f64, D, D>::from_column_slice(models.lower(0)).transpose(),
    }
}

/// Returns the model of one chord from one of its ends, by both implementations of a metric,
/// and whether the metric is positive definite at the nodes of the chord.
fn model_from<const D: usize>(
    end: usize,
    rule: Rule,
    metric: &impl Metric<D>,
    chord: Chord<'_, D>,
    n: f64,
) -> (ChordModel<D>, bool) {
    let (plain, prepared) = (Plain::new(metric), Prepared::new(metric));
    let [one, other] = [&plain as &dyn AnyBatches, &prepared].map(|metric| {
        let mut batch = batch(rule, metric, n);
        match end {
            0 => batch.evaluate(&points(chord)),
            _ => batch.evaluate_reversed(&points(chord)),
        }
        let model = batch.singles().model_from(end, 0);
        if batch.is_metric {
            assert_agrees(0, &model, &assembled(&batch, end));
        }
        (model, batch.is_metric)
    });
    assert_eq!(one.1, other.1);
    if one.1 {
        assert_agrees(0, &one.0, &other.0);
    }
    one
}

/// Returns the model of two facing chords.
fn facing<const D: usize>(
    rule: Rule,
    metric: &impl Metric<D>,
    chords: [Chord<'_, D>; 2],
    n: f64,
) -> (ChordModel<D, Pair>, bool) {
    let (plain, prepared) = (Plain::new(metric), Prepared::new(metric));
    let [one, other] = [&plain as &dyn AnyBatches, &prepared].map(|metric| {
        let mut batch = batch(rule, metric, n);
        batch.evaluate_facing(&points(chords[0]), &points(chords[1]));
        (batch.pairs().model(0), batch.is_metric)
    });
    assert_eq!(one.1, other.1);
    one
}

/// A rule that is not symmetric.
const LOPSIDED: Rule = Rule::new(
    "lopsided",
    &[Node { fraction: 0.25, weight: 0.75 }, Node { fraction: 0.5, weight: 0.25 }],
    1,
);

/// The tolerance for about a hundred operations on numbers below 100, each with two roundings
/// of 3e-14.
const SMALL: f64 = 1e-12;

/// Asserts that the model `one`, from the end `end`, agrees with `other`, from the near end.
#[track_caller]
fn assert_agrees<const D: usize>(end: usize, one: &ChordModel<D>, other: &ChordModel<D>) {
    assert!((one.energy - other.energy).abs() <= SMALL);
    assert!((one.trace - other.trace).abs() <= SMALL);
    for place in [0, 1] {
        let own = place ^ end;
        assert!((one.gradient[own] - other.gradient[place]).amax() <= SMALL);
        assert!((one.hessian[own] - other.hessian[place]).amax() <= SMALL);
    }
    let coupling = if end == 0 { other.coupling } else { other.coupling.transpose() };
    assert!((one.coupling - coupling).amax() <= SMALL);
}

#[track_caller]
fn compare(rule: Rule) {
    let metric = Swirl::new(0.5, 1.0).expect("a width");
    let chords =
        [(vector![0.3, -0.2], vector![0.5, 0.25]), (vector![-0.6, 0.1], vector![0.2, -0.7])];
    let chords = chords.each_ref().map(|(x, d)| (x, *d));
    let (facing, is_metric) = facing(rule, &metric, chords, 8.0);
    assert!(is_metric);
    for (end, chord) in chords.into_iter().enumerate() {
        let (near, is_metric) = model_from(0, rule, &metric, chord, 8.0);
        assert!(is_metric);
        let lane = ChordModel {
            energy: facing.energy.lane(end),
            trace: facing.trace.lane(end),
            gradient: facing.gradient.map(|g| g.map(|x| x.lane(end))),
            hessian: facing.hessian.map(|h| h.map(|x| x.lane(end))),
            coupling: facing.coupling.map(|x| x.lane(end)),
        };
        assert_agrees(end, &lane, &near);
        assert_agrees(end, &model_from(end, rule, &metric, chord, 8.0).0, &near);
    }
}

/// The two models agree bit for bit.
#[test]
fn the_model_at_the_midpoint_is_the_general_model() {
    let metric = Prepared::new(Swirl::new(0.5, 1.0).expect("a width"));
    let points = [0.3, -0.2, -0.6, 0.1, 0.4, 0.9, 0.5, 0.25];
    let mut batch = ChordBatch::new(&metric, Kind::Contraction, Rule::TRAPEZOIDAL.nodes(), 8.0, 4);
    batch.evaluate(&points);
    let models = batch.singles::<2>().first(3);
    assert!(models.is_midpoint());
    for k in 0..3 {
        assert_eq!(models.model_at_midpoint(k), models.model(k));
    }
    batch.evaluate_facing(&points[..6], &points[2..]);
    let models = batch.pairs::<2>().first(2);
    for k in 0..2 {
        assert_eq!(models.model_at_midpoint(k), models.model(k));
    }
    for nodes in [Rule::LEFT_ENDPOINT.nodes(), Rule::TRUE_TRAPEZOID.nodes(), LOPSIDED.nodes(), &[]]
    {
        let batch = ChordBatch::new(&metric, Kind::Contraction, nodes, 8.0, 2);
        assert!(!batch.singles::<2>().is_midpoint(), "{nodes:?}");
    }
}

#[test]
fn a_chord_from_its_far_end_is_reversed() {
    compare(Rule::TRAPEZOIDAL);
    compare(Rule::LEFT_ENDPOINT);
    compare(Rule::TRUE_TRAPEZOID);
    compare(LOPSIDED);
}

/// The matrix `x₂ I`, which is a metric only above the axis.
struct Above;
impl Metric<2> for Above {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(x[1])
    }
}

/// A single node of two chords, with two nodes each, lies below the axis. This is noticed for a
/// pair of chords, for one chord and for a sequence.
#[test]
fn one_node_without_a_metric_is_noticed() {
    // The nodes 0 and 1 are the ends of a chord.
    let chord = |from: f64, to: f64| (vector![0.0, from], vector![1.0, to - from]);
    let heights = [1.0, 2.0, 3.0, 4.0];
    for below in 0..=heights.len() {
        let height = |place: usize| if place == below { -1.0 } else { heights[place] };
        let chords = [chord(height(0), height(1)), chord(height(2), height(3))];
        let [first, second] =
            chords.map(|(x, d)| model_from(0, Rule::TRUE_TRAPEZOID, &Above, (&x, d), 1.0).1);
        assert_eq!([first, second], [below >= 2, !(2..4).contains(&below)], "{below}");
        let both = chords.each_ref().map(|(x, d)| (x, *d));
        let (_, is_metric) = facing(Rule::TRUE_TRAPEZOID, &Above, both, 1.0);
        assert_eq!(is_metric, below == heights.len(), "{below}");
        let points = (0..4).map(|place| vector![place as f64, height(place)]).collect();
        let sequence = PointSequence::new(points).expect("finite");
        let linear = LinearModel::new(Rule::TRUE_TRAPEZOID, &Above, &sequence);
        assert_eq!(linear.is_metric, below == heights.len(), "{below}");
    }
}

/// The identity matrix, except for one entry.
struct Spoilt {
    place: (usize, usize),
    entry: f64,
}
impl<const D: usize> Metric<D> for Spoilt {
    fn gram<S: Scalar>(&self, _: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut h = SMatrix::<S, D, D>::identity();
        h[self.place] = S::constant(self.entry);
        h
    }
}

/// Every kind of evaluation notices each defect: an entry of either triangle differs from its
/// mirror image, a diagonal entry is not positive, or an entry is not finite.
#[track_caller]
fn spoilt_matrices_are_noticed<const D: usize>() {
    let defects = [
        ((0, 1), 0.25),
        ((1, 0), 0.25),
        ((D - 1, 0), 0.25),
        ((D - 2, D - 1), 0.25),
        ((0, 0), -1.0),
        ((D - 1, D - 1), 0.0),
        ((D - 1, D - 1), f64::INFINITY),
        ((0, D - 1), f64::NAN),
    ];
    let whole = ((0, 0), 1.0);
    let (x, d) = (SVector::<f64, D>::zeros(), SVector::<f64, D>::repeat(0.5));
    let sequence = PointSequence::new(vec![x, x + d]).expect("finite");
    for (place, entry) in defects.into_iter().chain([whole]) {
        let metric = Spoilt { place, entry };
        let expected = (place, entry) == whole;
        let (_, is_metric) = model_from(0, Rule::TRAPEZOIDAL, &metric, (&x, d), 1.0);
        assert_eq!(is_metric, expected, "{entry} at {place:?} of {D}");
        let linear = LinearModel::new(Rule::TRAPEZOIDAL, &metric, &sequence);
        assert_eq!(linear.is_metric, expected, "{entry} at {place:?} of {D}");
        for metric in
            [&Plain::<_, D>::new(&metric) as &dyn AnyBatches, &Prepared::<_, D>::new(&metric)]
        {
            let mut batch =
                ChordBatch::new(metric, Kind::Checked, Rule::TRAPEZOIDAL.nodes(), 1.0, 1);
            batch.evaluate(sequence.coordinates());
            assert_eq!(batch.is_metric, expected, "{entry} at {place:?} of {D}");
        }
        let (_, is_metric) = facing(Rule::TRAPEZOIDAL, &metric, [(&x, d), (&x, d)], 1.0);
        assert_eq!(is_metric, expected, "{entry} at {place:?} of {D}");
    }
}

#[test]
fn a_matrix_that_is_not_a_metric_is_noticed_in_every_dimension() {
    spoilt_matrices_are_noticed::<2>();
    spoilt_matrices_are_noticed::<3>();
    spoilt_matrices_are_noticed::<4>();
    spoilt_matrices_are_noticed::<9>();
    spoilt_matrices_are_noticed::<25>();
}

#[test]
fn one_chord_of_a_pair_without_a_metric_is_noticed() {
    let (above, below) = (vector![0.0, 1.0], vector![0.0, -1.0]);
    let d = vector![1.0, 0.25];
    for places in [[&above, &below], [&below, &above], [&above, &above]] {
        let (_, is_metric) = facing(Rule::TRAPEZOIDAL, &Above, places.map(|x| (x, d)), 1.0);
        assert_eq!(is_metric, places == [&above, &above]);
    }
}
