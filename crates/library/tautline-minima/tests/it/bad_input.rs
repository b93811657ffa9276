//! What cannot be searched is told.

use nalgebra::{SMatrix, SVector};
use tautline::{
    Ends, GraphPathError, Lattice, Metric, Plain, Problem, Punctures, Rule, Scalar, SolveError,
    gallery::Valleys, grid::EikonalError,
};
use tautline_minima::{GlobalSearch, MinimaError, Refused, follow};

use crate::setup::Torn;

fn problem() -> Problem<Valleys, 2> {
    Problem::new(Valleys, Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite"))
}

#[test]
fn a_lattice_far_from_an_end_refuses_paths_and_nothing_is_lost() {
    let lattice = Lattice::new([-1.0, -1.0], [0.5, 1.0], 0.1).expect("a box");
    let found =
        GlobalSearch::within(lattice).search(&problem(), Rule::TRAPEZOIDAL, 16).expect("found");
    assert_eq!(found.minima().len(), 1);
    let [Refused::Classes(classes), Refused::Passes(passes)] = found.refused() else {
        panic!("{:?}", found.refused())
    };
    assert_eq!(*classes, GraphPathError::FarFromEnd { end: "second" });
    assert_eq!(*passes, EikonalError::FarFromEnd { end: "second" });
}

#[test]
fn ends_that_nothing_joins_have_no_minimum() {
    let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
    let lattice = Lattice::new([-1.0, -1.0], [2.0, 1.0], 0.1).expect("a box");
    let search = GlobalSearch::within(lattice);
    let error = search.search(&Problem::new(Torn, ends), Rule::TRAPEZOIDAL, 16).expect_err("torn");
    let MinimaError::NoMinimum { starts: 1, source: Some(SolveError::Metric(_)) } = error else {
        panic!("{error:?}")
    };
}

/// A wall without a metric, with a gap far from the straight line. The metric grows towards the wall.
#[derive(Debug)]
struct Wall;

impl Metric<2> for Wall {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let gap = (-(x[1] - 2.2).sqr() * 10.0).exp() * 0.3;
        let outside = x[0].sqr() + gap - 0.04;
        SMatrix::identity() * (S::constant(0.1) / outside.sqrt() + 1.0)
    }
}

/// The automatic starts run into the wall, and so does all that continuation could start from, which says why.
/// A path along a lattice finds the gap.
#[test]
fn a_gap_that_no_automatic_start_sees_is_found_by_the_lattice() {
    let ends = Ends::points([-1.0, 0.0], [1.0, 0.1]).expect("finite");
    let lattice = Lattice::new([-1.2, -1.0], [1.2, 3.0], 0.1).expect("a box");
    let problem = Problem::new(Wall, ends);
    let automatic = problem.solve(Rule::TRAPEZOIDAL, 64).expect_err("a wall");
    let found =
        GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, 64).expect("a gap");
    let [only] = found.minima() else { panic!("{}", found.minima().len()) };
    // In the middle of the wall the gap is where 0.3 e^(−10 (y − 2.2)²) > 0.04.
    let across = only.line.sequence().points().iter().filter(|x| x[0].abs() < 0.05);
    assert!(across.map(|x| x[1]).all(|y| (y - 2.2).abs() < 0.46));
    let [Refused::Continuation(error)] = found.refused() else { panic!("{:?}", found.refused()) };
    // The entry is NaN, which is not equal to itself.
    assert_eq!(error.to_string(), automatic.to_string());
}

#[test]
fn numbers_out_of_range_are_errors() {
    let lattice = Lattice::new([-1.0, -1.0], [2.0, 2.0], 0.1).expect("a box");
    for slack in [0.5, f64::NAN] {
        let mut search = GlobalSearch::within(lattice.clone());
        search.slack = slack;
        let error = search.search(&problem(), Rule::TRAPEZOIDAL, 16);
        assert!(matches!(error, Err(MinimaError::Lattice(GraphPathError::Slack { .. }))));
    }
    // No further start is tried.
    let error = GlobalSearch::within(lattice).search(&problem(), Rule::TRAPEZOIDAL, 0);
    let source = Some(SolveError::NoSubinterval);
    assert_eq!(error.err(), Some(MinimaError::NoMinimum { starts: 1, source }));
    let twice = Punctures::new(vec![[0.0, 0.0]; 2]);
    assert!(matches!(twice, Err(GraphPathError::Puncture { number: 2, .. })));
    let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
    let nothing = follow(|_| Valleys, &[], &ends, Rule::TRAPEZOIDAL, 16, 8);
    assert_eq!(nothing.map(|_| ()), Err(SolveError::NoStart));
}

/// More than two hundred hills.
#[derive(Debug)]
struct EggBox;

impl Metric<2> for EggBox {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::identity() * ((x[0] * 16.0).sin() * (x[1] * 16.0).sin() + 2.0)
    }
}

#[test]
fn of_many_peaks_the_most_prominent_are_told_apart() {
    let lattice = Lattice::new([-4.0, -4.0], [4.0, 4.0], 0.05).expect("a box");
    let peaks = Punctures::peaks(&Plain::new(&EggBox), &lattice, 1.05).expect("a prominence");
    assert!(peaks.points().len() > 200, "{}", peaks.points().len());
    let mut search = GlobalSearch::within(lattice);
    (search.most, search.steps) = (0, 0);
    let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
    let found = search.search(&Problem::new(EggBox, ends), Rule::TRAPEZOIDAL, 16).expect("found");
    assert_eq!(found.punctures().points(), &peaks.points()[..64]);
}

/// Neither classes nor passes nor continuation: the automatic search is left.
#[test]
fn without_ways_there_is_the_automatic_search() {
    let lattice = Lattice::new([-1.0, -1.0], [2.0, 2.0], 0.1).expect("a box");
    let mut search = GlobalSearch::within(lattice);
    (search.most, search.steps) = (0, 0);
    let found = search.search(&problem(), Rule::TRAPEZOIDAL, 16).expect("found");
    assert_eq!((found.minima().len(), found.starts()), (1, 1));
}
