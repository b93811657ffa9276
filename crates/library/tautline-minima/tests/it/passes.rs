//! Curves through passes between two distance fields.

use tautline::{
    Ball, Ends, HalfSpace, Lattice, LatticeGraph, Options, Plain, Point, Problem, Punctures, Rule,
    Starts, are_apart, class_paths,
    gallery::{Obstacle, SoftObstacles},
    grid::pass_paths,
};
use tautline_minima::GlobalSearch;

use crate::setup::{PAST, around, two_hills};

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
