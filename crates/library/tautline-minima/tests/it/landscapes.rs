//! Landscapes whose minima are known.

use tautline::{
    AxisBox, Curvature, Ends, HalfSpace, Lattice, Metric, Problem, Rule, SMatrix, SVector, Scalar,
    distance::Wanted,
    gallery::{Bump, Constant, TwoChannels},
};
use tautline_minima::{GlobalSearch, Minima, Origin, Standing};

use crate::setup::{PAST, Planar, around, two_hills};

const N: usize = 64;

fn energies<M: Metric<D>, const D: usize>(found: &Minima<M, D>) -> Vec<f64> {
    found.minima().iter().map(|minimum| minimum.line.discrete_energy()).collect()
}

/// Above, between and below the hills: three words, each of one minimum.
#[test]
fn two_hills_have_three_ways() {
    let problem = Problem::new(two_hills(), Ends::points(PAST[0], PAST[1]).expect("finite"));
    let found =
        GlobalSearch::within(around()).search(&problem, Rule::TRAPEZOIDAL, N).expect("found");
    assert!(found.refused().is_empty(), "{:?}", found.refused());
    assert_eq!(found.punctures().points().len(), 2);
    let heights: Vec<f64> =
        found.minima().iter().map(|minimum| minimum.line.curve().at(0.5)[1]).collect();
    let [between, below, above] = heights[..] else { panic!("{heights:?}") };
    assert!(between.abs() < 0.3 && below < -1.0 && above > 1.0, "{heights:?}");
    let mut words: Vec<_> = found.minima().iter().map(|minimum| minimum.word.clone()).collect();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), 3);
    for minimum in found.minima() {
        assert!(minimum.line.minimum().is_local_minimum());
    }
}

/// The certificate proves that the way between the hills is the shortest of all curves up to its gap; the
/// ways around are proved to be longer.
#[test]
fn a_certificate_ranks_the_ways() {
    let problem = Problem::new(two_hills(), Ends::points(PAST[0], PAST[1]).expect("finite"));
    let found =
        GlobalSearch::within(around()).search(&problem, Rule::TRAPEZOIDAL, N).expect("found");
    let ranked = found.ranked(Wanted::gap(1e-2)).expect("a certificate");
    let [Standing::Shortest { gap }, rest @ ..] = &ranked.standings[..] else {
        panic!("{:?}", ranked.standings);
    };
    // The polygon of 64 chords is longer than the proved one by less than a hundredth as well.
    assert!((0.0..2e-2).contains(gap), "{gap}");
    // What the standings say follows from what is proved, up to three roundings.
    let (proved, rounding) = (&ranked.found.proved, 1.0 + 3.0 * f64::EPSILON);
    let least = found.lowest().length().value * (1.0 - gap);
    assert!(least <= proved.lower * rounding, "{least} {}", proved.lower);
    assert_eq!(rest.len(), 2);
    let upper = proved.upper.expect("a proved length");
    for (standing, minimum) in rest.iter().zip(&found.minima()[1..]) {
        let (Standing::Longer { by }, length) = (standing, minimum.line.length()) else {
            panic!("{standing:?}")
        };
        assert!(upper * (1.0 + by) <= (length.value - length.error) * rounding, "{by}");
    }
    let lengths: Vec<f64> =
        found.minima().iter().map(|minimum| minimum.line.length().value).collect();
    for (standing, length) in rest.iter().zip(&lengths[1..]) {
        let Standing::Longer { by } = standing else { panic!("{standing:?}") };
        assert!((by - (length / lengths[0] - 1.0)).abs() < 1e-2, "{by}");
    }
}

/// The two channels are mirror images: both minima have the same energy, and neither is proved to be
/// longer.
#[test]
fn mirror_images_are_two_minima_and_both_the_shortest() {
    let ends = Ends::points([-3.0, 0.0], [3.0, 0.0]).expect("finite");
    let channels = TwoChannels::new(2.0, 1.0, 0.5).expect("channels");
    let lattice = Lattice::new([-3.5, -2.5], [3.5, 2.5], 0.1).expect("a box");
    let found = GlobalSearch::within(lattice);
    let found = found.search(&Problem::new(channels, ends), Rule::TRAPEZOIDAL, N).expect("found");
    let [first, second, ..] = energies(&found)[..] else { panic!("{}", found.minima().len()) };
    // Two solves to the floor of rounding.
    assert!((first / second - 1.0).abs() < 1e-11, "{first} {second}");
    let mirrored = found.minima()[0].line.curve().at(0.5) + found.minima()[1].line.curve().at(0.5);
    assert!(mirrored[1].abs() < 1e-5, "{mirrored}");
    let ranked = found.ranked(Wanted::gap(2e-2)).expect("a certificate");
    for standing in &ranked.standings[..2] {
        assert!(matches!(standing, Standing::Shortest { .. }), "{standing:?}");
    }
}

/// In space and in six dimensions the ways are those of the plane. In six dimensions there is no lattice,
/// so that only what splits off the straight line is found.
#[test]
fn further_dimensions_have_the_ways_of_the_plane() {
    let plane = Problem::new(two_hills(), Ends::points(PAST[0], PAST[1]).expect("finite"));
    let plane = GlobalSearch::within(around()).search(&plane, Rule::TRAPEZOIDAL, N).expect("found");
    let plane = energies(&plane);

    let [a, b] = PAST.map(|[x, y]| [x, y, 0.0]);
    let space = Problem::new(Planar(two_hills()), Ends::points(a, b).expect("finite"));
    let lattice = Lattice::new([-2.2, -2.0, -0.4], [2.2, 2.0, 0.4], 0.2).expect("a box");
    let search = GlobalSearch::within(lattice);
    let found = search.search(&space, Rule::TRAPEZOIDAL, N).expect("found");
    let ways = energies(&found);
    assert_eq!(ways.len(), plane.len());
    for (way, exact) in ways.iter().zip(&plane) {
        // Both are minima of the same energy, to rounding.
        assert!((way / exact - 1.0).abs() < 1e-11, "{way} {exact}");
    }

    let [a, b] = PAST.map(|[x, y]| [x, y, 0.0, 0.0, 0.0, 0.0]);
    let wide = Problem::new(Planar(two_hills()), Ends::points(a, b).expect("finite"));
    let found = GlobalSearch::default().search(&wide, Rule::TRAPEZOIDAL, N).expect("found");
    for way in energies(&found) {
        assert!(plane.iter().any(|exact| (way / exact - 1.0).abs() < 1e-11), "{way} {plane:?}");
    }
}

/// From a square to a half-plane beside it all shortest ways have the length 1. Some of them are found, and
/// none is called strict.
#[test]
fn degenerate_minima_are_minima() {
    let square = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("a box");
    let side = HalfSpace::new([-1.0, 0.0], -2.0).expect("a half-plane");
    let flat = Constant::new(SMatrix::<f64, 2, 2>::identity()).expect("definite");
    let problem = Problem::new(flat, Ends::new(square, side).expect("bounded"));
    let lattice = Lattice::new([-1.5, -1.5], [2.5, 1.5], 0.1).expect("a box");
    let found =
        GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, N).expect("found");
    for minimum in found.minima() {
        assert_eq!(minimum.line.minimum().curvature, Curvature::Degenerate);
        let energy = minimum.line.discrete_energy();
        assert!((energy - 1.0).abs() < 1e-11, "{energy}");
    }
}

/// A bump off the straight line: the automatic starts find the way on the near side and the one on the far
/// side, and so does each of the other starts.
#[test]
fn each_kind_of_start_finds_both_sides_of_a_bump() {
    let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
    let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
    let lattice = Lattice::new([-2.0, -1.5], [2.0, 1.5], 0.05).expect("a box");
    let found =
        GlobalSearch::within(lattice).search(&problem, Rule::TRAPEZOIDAL, N).expect("found");
    let [near, far] = found.minima() else { panic!("{}", found.minima().len()) };
    // The automatic search and its other minima, two classes, two passes and two branches.
    assert!(near.hits >= 4 && far.hits >= 4, "{} {}", near.hits, far.hits);
    assert_eq!(near.origin, Origin::Automatic);
    assert!(near.line.discrete_energy() < far.line.discrete_energy());
}

/// A wall of the cost 100 with a gap far from the straight line: the automatic search misses the gap. The way
/// through it is found by the lattice, and stands before what was found first.
#[test]
fn the_lowest_minimum_stands_first_whoever_finds_it() {
    #[derive(Debug)]
    struct Wall;
    impl Metric<2> for Wall {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let wall = (-(x[0] / 0.1).sqr()).exp();
            let gap = (-((x[1] - 3.0) / 0.3).sqr()).exp();
            SMatrix::from_diagonal_element((wall * (-gap + 1.0) * 100.0 + 1.0).sqr())
        }
    }
    let problem = Problem::new(Wall, Ends::points([-1.0, 0.0], [1.0, 0.0]).expect("finite"));
    let lattice = Lattice::new([-2.0, -1.0], [2.0, 4.0], 0.1).expect("a lattice");
    let mut search = GlobalSearch::within(lattice);
    search.steps = 0;
    let found = search.search(&problem, Rule::TRAPEZOIDAL, 128).expect("found");
    let energies = energies(&found);
    assert!(energies.len() >= 2 && energies.is_sorted(), "{energies:?}");
    // √40 is the way to the gap and back, without the wall.
    assert!((40.0..52.0).contains(&energies[0]), "{energies:?}");
    assert_ne!(found.minima()[0].origin, Origin::Automatic);
}
