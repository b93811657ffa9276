//! Curves through passes between two distance fields.

use tautline::{
    Ball, Ends, GraphPathError, HalfSpace, Lattice, LatticeGraph, Metric, Options, Plain, Point,
    Problem, Punctures, Rule, SMatrix, SVector, Scalar, Starts, are_apart, class_paths,
    gallery::{Obstacle, SoftObstacles},
};
use tautline_baselines::EikonalError;
use tautline_chance::{Random, cases, seed};
use tautline_minima::{GlobalSearch, pass_paths};

use crate::setup::{PAST, Planar, Torn, around, two_hills};

/// Each of the three ways past two hills has a pass. The curve through it is longer than the minimum to
/// which it leads by the errors of two descents, of the order of the spacing over its length. Some
/// curves through further nodes without a corner are much longer.
#[test]
fn each_way_past_the_hills_has_a_pass() {
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let problem = Problem::new(two_hills(), ends.clone());
    let known =
        GlobalSearch::within(around()).search(&problem, Rule::TRAPEZOIDAL, 64).expect("found");
    let paths = pass_paths(problem.metric(), &ends, &around(), 9, 2.0).expect("passes");
    let mut longer = [f64::INFINITY; 3];
    for path in &paths {
        let sequence = path.sequence(64).expect("chords");
        assert!(sequence.points().windows(2).all(|pair| (pair[1] - pair[0]).norm() < 0.2));
        // The pass is on the curve.
        let nearest = sequence.points().iter().map(|x| (x - path.pass()).norm());
        assert!(nearest.fold(f64::INFINITY, f64::min) < 0.1);
        let options = Options { starts: Starts::OnTheGrid(vec![sequence]), ..Options::default() };
        let line = problem.solve_with(Rule::TRAPEZOIDAL, 64, &options).expect("solved");
        let is_it = |k: &usize| !are_apart(line.sequence(), known.minima()[*k].line.sequence());
        let way = (0..3).find(is_it).expect("one of the ways");
        longer[way] = longer[way].min(path.length() / line.length().value - 1.0);
    }
    assert!(longer.iter().all(|longer| (-1e-3..0.05).contains(longer)), "{longer:?}");
}

/// A slack of 1 leaves the lowest pass, that of the minimal geodesic.
#[test]
fn slack_and_number_bound_the_passes() {
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let paths =
        |most, slack| pass_paths(&two_hills(), &ends, &around(), most, slack).expect("passes");
    let all = paths(9, 2.0);
    assert!(all.len() >= 3);
    assert_eq!(paths(2, 2.0), all[..2]);
    assert!(paths(0, 2.0).is_empty());
    // The lowest pass comes first, with the curve that is the shortest but for the error of its descents.
    let best = all.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min);
    assert!(all[0].length() / best - 1.0 < 0.02, "{} {best}", all[0].length());
    for slack in [0.9, f64::NAN] {
        let error = pass_paths(&two_hills(), &ends, &around(), 9, slack).map(|_| ());
        let Err(EikonalError::Lattice(GraphPathError::Slack { .. })) = error else {
            panic!("{error:?}")
        };
    }
    let [only] = &paths(9, 1.0)[..] else { panic!("one pass") };
    let shortest = all.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min);
    assert!((only.length() / shortest - 1.0).abs() < 0.02);
}

/// Whatever the errors of the two fields, a slack of 1 leaves the lowest pass, to which a curve leads that is
/// the shortest but for those errors.
#[test]
fn a_slack_of_one_leaves_a_pass_between_any_ends() {
    let mut random = Random(seed(4));
    let metric = two_hills();
    let of = |_| {
        let mut end = |side: f64| [side * random.between(1.2, 2.1), random.between(-1.5, 1.5)];
        let ends = Ends::points(end(-1.0), end(1.0)).expect("finite");
        let [least, more] = [1.0, 1.2].map(|slack| {
            let paths = pass_paths(&metric, &ends, &around(), 9, slack).expect("passes");
            paths.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min)
        });
        least / more
    };
    let quotients: Vec<f64> = (0..cases(20)).map(of).collect();
    // The spacing over the length.
    assert!(quotients.iter().all(|quotient| *quotient <= 1.03), "{quotients:?}");
}

/// Whichever node of the lattice comes first: the hills one above the other, or beside each other.
#[test]
fn the_lowest_pass_comes_first() {
    for is_turned in [false, true] {
        let turned = |[x, y]: [f64; 2]| if is_turned { [y, x] } else { [x, y] };
        let hill = |y| Obstacle { centre: turned([0.0, y]).into(), height: 20.0, width: 0.3 };
        let hills = SoftObstacles::new(vec![hill(0.85), hill(-0.7)]).expect("hills");
        let ends = Ends::points(turned(PAST[0]), turned(PAST[1])).expect("finite");
        let lattice = Lattice::new(turned([-2.2, -2.0]), turned([2.2, 2.0]), 0.1).expect("a box");
        let paths = pass_paths(&hills, &ends, &lattice, 9, 2.0).expect("passes");
        let lengths: Vec<f64> = paths.iter().map(|path| path.length()).collect();
        // Sorted by the sum of two distances, which differs from the length of the two descents by their
        // errors, of the order of the spacing over the length, 0.1/4.
        assert!(lengths.is_sorted_by(|a, b| *a <= 1.025 * b), "{lengths:?}");
        assert!(lengths[0] * 1.2 < lengths[1], "{lengths:?}");
    }
}

/// Two half-planes are all that has a metric: nothing leads from one to the other.
#[test]
fn sets_that_nothing_joins_have_no_passes() {
    let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
    let lattice = Lattice::new([-1.0, -1.0], [2.0, 1.0], 0.1).expect("a box");
    let error = pass_paths(&Torn, &ends, &lattice, 9, 2.0).map(|_| ());
    // The nodes up to 0.3, which is one of them or not.
    let Err(EikonalError::NotConnected { reached: 273..=294, nodes: 651 }) = error else {
        panic!("{error:?}")
    };
}

/// In space the ways past two pillars are those of the plane.
#[test]
fn pillars_in_space_have_three_passes() {
    let [a, b] = PAST.map(|[x, y]| [x, y, 0.0]);
    let ends = Ends::points(a, b).expect("finite");
    let lattice = Lattice::new([-2.2, -2.0, -0.4], [2.2, 2.0, 0.4], 0.2).expect("a box");
    let paths = pass_paths(&Planar(two_hills()), &ends, &lattice, 9, 2.0).expect("passes");
    let height = |at: f64| paths.iter().any(|path| (path.pass()[1] - at).abs() < 0.35);
    assert!(height(1.7) && height(0.1) && height(-1.5), "{paths:?}");
}

/// Between sets the ends are free: from a ball to a half-plane there are three ways past the hills, and the
/// last chord is normal to the edge of the half-plane.
#[test]
fn between_sets_there_are_three_ways_as_well() {
    let ball = Ball::new([-2.0, 0.0], 0.2).expect("a ball");
    let side = HalfSpace::new([-1.0, 0.0], -2.0).expect("a half-plane");
    let problem = Problem::new(two_hills(), Ends::new(ball, side).expect("bounded"));
    let lattice = Lattice::new([-2.6, -2.2], [2.2, 2.2], 0.1).expect("a box");
    let found =
        GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, 64).expect("found");
    assert!(found.refused().is_empty(), "{:?}", found.refused());
    assert_eq!(found.minima().len(), 3);
    let mut words: Vec<_> = found.minima().iter().map(|minimum| &minimum.word).collect();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), 3);
    for minimum in found.minima() {
        assert!(minimum.line.minimum().is_local_minimum());
        let points = minimum.line.sequence().points();
        let last = points[64] - points[63];
        // The metric is nearly flat there; the normality of a chord is off by its length.
        assert!(last[1].abs() < 0.05 * last[0], "{last}");
    }
}

/// The ray of the hill runs to the half-plane, and neither minimum crosses it: their words differ by where
/// they end.
#[test]
fn minima_that_end_on_either_side_of_a_ray_have_different_words() {
    let hill = Obstacle { centre: [0.0, 0.0].into(), height: 20.0, width: 0.3 };
    let hill = SoftObstacles::new(vec![hill]).expect("a hill");
    let roof = HalfSpace::new([0.0, -1.0], -1.5).expect("a half-plane");
    let point = Point::new([0.05, -1.5]).expect("finite");
    let problem = Problem::new(hill, Ends::new(point, roof).expect("bounded"));
    let lattice = Lattice::new([-1.8, -1.8], [1.8, 1.8], 0.1).expect("a box");
    let found =
        GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, 32).expect("found");
    let [right, left] = found.minima() else { panic!("{}", found.minima().len()) };
    assert!(right.line.curve().at(0.5)[0] > 0.5 && left.line.curve().at(0.5)[0] < -0.5);
    assert_ne!(right.word, left.word);
}

/// In another unit of the metric the passes are the same nodes: a corner is a pure number. Powers of four do not
/// even change the rounding of lengths, which are roots.
#[test]
fn passes_are_the_same_in_other_units() {
    #[derive(Debug)]
    struct InUnits(f64);
    impl Metric<2> for InUnits {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            two_hills().gram(x).map(|h| h * self.0)
        }
    }
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let of = |unit: f64| {
        let paths = pass_paths(&InUnits(unit * unit), &ends, &around(), 9, 2.0).expect("passes");
        paths.iter().map(|path| (*path.pass(), path.length() / unit)).collect::<Vec<_>>()
    };
    let passes = of(1.0);
    assert!(passes.len() >= 3);
    for unit in [1024.0, 1.0 / 1024.0] {
        assert_eq!(of(unit), passes, "{unit}");
    }
}

/// A search has as many starts as its ways find, with the slack that is asked for: the automatic search and its
/// other minima, the classes and the passes.
#[test]
fn all_ways_have_the_slack_that_is_asked_for() {
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let problem = Problem::new(two_hills(), ends.clone());
    let automatic = problem.solve(Rule::TRAPEZOIDAL, 64).expect("solved").other_minima().len() + 1;
    let plain = Plain::new(problem.metric());
    let graph = LatticeGraph::usual(&plain, around());
    let mut counts = Vec::new();
    for slack in [1.0, 1.1, 2.0] {
        let mut search = GlobalSearch::within(around());
        (search.slack, search.steps) = (slack, 0);
        let found = search.search(&problem, Rule::TRAPEZOIDAL, 64).expect("found");
        let classes = class_paths(&graph, &ends, found.punctures(), 32, slack).expect("paths");
        let passes = pass_paths(problem.metric(), &ends, &around(), 32, slack).expect("passes");
        assert_eq!(found.starts(), automatic + classes.len() + passes.len(), "{slack}");
        counts.push(passes.len());
    }
    assert!(counts[0] < counts[2], "{counts:?}");
}

/// Punctures that are given are those that the words are about, also where the metric has other peaks.
#[test]
fn given_punctures_are_not_replaced_by_peaks() {
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let problem = Problem::new(two_hills(), ends);
    let given = Punctures::new(vec![[0.0, 0.85]]).expect("a point");
    let mut search = GlobalSearch::within(around());
    (search.punctures, search.steps) = (Some(given.clone()), 0);
    let found = search.search(&problem, Rule::TRAPEZOIDAL, 64).expect("found");
    assert_eq!(*found.punctures(), given);
    let mut words: Vec<_> = found.minima().iter().map(|minimum| &minimum.word).collect();
    words.sort();
    words.dedup();
    // Below the upper hill there are two ways, which it does not tell apart.
    assert_eq!((found.minima().len(), words.len()), (3, 2));
}

/// Both distance fields are of one order: from the second set to the first there are the same passes, with
/// curves of the same lengths.
#[test]
fn exchanged_sets_have_the_same_passes() {
    let of = |a, b| {
        let ends = Ends::points(a, b).expect("finite");
        pass_paths(&two_hills(), &ends, &around(), 9, 2.0).expect("passes")
    };
    let (there, back) = (of(PAST[0], PAST[1]), of(PAST[1], PAST[0]));
    assert!(there.len() >= 3);
    assert_eq!(there.len(), back.len());
    for (one, other) in there.iter().zip(&back) {
        assert_eq!(one.pass(), other.pass());
        // Sums of some hundred chords in the other order.
        assert!((one.length() / other.length() - 1.0).abs() < 1e-13, "{}", one.length());
    }
}
