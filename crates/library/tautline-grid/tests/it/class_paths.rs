//! Lattice paths of homotopy classes, beside shortest paths in a plane with a wall.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, cases, seed};
use tautline_formula::{Batches, Plain};
use tautline_grid::{
    ClassPath, GraphPathError, Lattice, LatticeGraph, Punctures, Word, class_paths,
};
use tautline_metrics::{Constants, Metric, Scalar};
use tautline_sets::{Ball, Ends, HalfSpace, Point};

use crate::graphs::edge_length;

fn lattice() -> Lattice<2> {
    Lattice::new([-2.0, -1.5], [2.0, 1.5], 0.1).expect("a box")
}

/// Returns the length of the shortest path whose edges do not cross the vertical line below or above a
/// point: edges are relaxed until no length changes.
fn around_a_wall(
    graph: &LatticeGraph<'_, 2>,
    ends: &Ends<2>,
    [across, end]: [f64; 2],
    is_below: bool,
) -> f64 {
    let crosses = |a: &SVector<f64, 2>, b: &SVector<f64, 2>| {
        let t = (across - a[0]) / (b[0] - a[0]);
        (0.0..=1.0).contains(&t) && (a[1] + t * (b[1] - a[1]) < end) == is_below
    };
    let nodes = graph.lattice().nodes();
    let point = |node: usize| graph.lattice().point(node);
    let mut lengths = vec![f64::INFINITY; nodes];
    for (node, _, length) in graph.gates(&**ends.first()) {
        lengths[node] = length;
    }
    let mut is_changed = true;
    while std::mem::take(&mut is_changed) {
        for node in 0..nodes {
            for (there, edge) in graph.edges(node) {
                let longer = lengths[node] + edge;
                if longer < lengths[there] && !crosses(&point(node), &point(there)) {
                    lengths[there] = longer;
                    is_changed = true;
                }
            }
        }
    }
    let gates = graph.gates(&**ends.second()).into_iter();
    gates.map(|(node, _, tail)| lengths[node] + tail).fold(f64::INFINITY, f64::min)
}

/// Around one puncture there are two ways that do not wind. The shortest path of either is the shortest of
/// all in a plane with a wall from the puncture to the other side of the box.
#[test]
fn a_class_is_as_long_as_the_way_around_a_wall() {
    fn check(metric: &impl Metric<2>, puncture: [f64; 2]) {
        let ends = Ends::points([-1.5, 0.2], [1.5, -0.3]).expect("finite");
        let punctures = Punctures::new(vec![puncture]).expect("a point");
        let plain = Plain::new(metric);
        for reach in [1, 2] {
            let graph = LatticeGraph::new(&plain, lattice(), reach).expect("a reach");
            let paths = class_paths(&graph, &ends, &punctures, 2, 9.0).expect("paths");
            let mut around =
                [true, false].map(|below| around_a_wall(&graph, &ends, puncture, below));
            around.sort_by(f64::total_cmp);
            assert_eq!(paths.len(), 2);
            for (path, around) in paths.iter().zip(around) {
                // Sums of some fifty edges, which may be other ones of the same length.
                assert!((path.path().length() / around - 1.0).abs() < 1e-13, "{puncture:?}");
                let corners = path.path().sequence(512).expect("chords");
                assert_eq!(punctures.word(corners.points()), *path.word());
            }
            assert!(paths[0].path().length() < paths[1].path().length());
        }
    }
    check(&Euclidean, [0.03, 0.33]);
    check(&Tilted, [-0.45, -0.12]);
}

struct Euclidean;

impl Metric<2> for Euclidean {
    fn gram<S: Scalar>(&self, _: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::identity()
    }
}

struct Tilted;

impl Metric<2> for Tilted {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let skew = x[1].sin() * 0.5;
        SMatrix::from([[x[0].cos() + 2.0, skew], [skew, S::one()]])
    }
}

/// A slack of 1 leaves the shortest path, and each further class is the next one in length.
#[test]
fn slack_and_number_bound_the_classes() {
    let ends = Ends::points([-1.5, 0.2], [1.5, -0.3]).expect("finite");
    let points = vec![[-0.5, 0.03], [0.13, 0.4], [0.7, -0.6]];
    let punctures = Punctures::new(points).expect("points");
    let plain = Plain::new(&Tilted);
    let graph = LatticeGraph::new(&plain, lattice(), 2).expect("a reach");
    // Without the work of the search, which is the same for all paths.
    let lengths = |paths: &[ClassPath<2>]| -> Vec<_> {
        paths.iter().map(|path| (path.word().clone(), path.path().length())).collect()
    };
    let paths = |most, slack| class_paths(&graph, &ends, &punctures, most, slack).expect("paths");
    let all = paths(20, 9.0);
    assert_eq!(all.len(), 20);
    let mut words: Vec<_> = all.iter().map(|path| path.word().clone()).collect();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), 20);
    assert!(all.is_sorted_by(|a, b| a.path().length() <= b.path().length()));
    assert_eq!(lengths(&paths(3, 9.0)), lengths(&all[..3]));
    assert_eq!(lengths(&paths(20, 1.0)), lengths(&all[..1]));
    let slack = 0.5 * (all[4].path().length() + all[5].path().length()) / all[0].path().length();
    assert!(all[4].path().length() < all[5].path().length());
    assert_eq!(lengths(&paths(20, slack)), lengths(&all[..5]));
    assert!(paths(0, 9.0).is_empty());
    for slack in [0.9, f64::NAN] {
        let error = class_paths(&graph, &ends, &punctures, 9, slack).map(|_| ());
        assert!(matches!(error, Err(GraphPathError::Slack { .. })), "{error:?}");
    }
}

/// A slalom passes each puncture, from left to right, on either side. All are among the classes, whatever the
/// direction of the rays: also those that cross a ray, pass another puncture, and cross the ray back.
#[test]
fn every_slalom_has_a_class() {
    let mut random = Random(seed(2));
    let (a, b) = (SVector::from([-1.5, 0.013]), SVector::from([1.5, 0.017]));
    let ends = Ends::points(a, b).expect("finite");
    let plain = Plain::new(&Euclidean);
    let graph = LatticeGraph::new(&plain, lattice(), 1).expect("a reach");
    let mut back = 0;
    for _ in 0..10 {
        let across = [-0.45, -0.15, 0.15, 0.45];
        let points = across.map(|x| [x + random.between(-0.1, 0.1), random.between(-0.7, 0.7)]);
        let punctures = Punctures::new(points.to_vec()).expect("points");
        let paths = class_paths(&graph, &ends, &punctures, 400, 4.0).expect("paths");
        for sides in 0..16 {
            let beside = |k: usize| {
                let [x, y] = points[k];
                SVector::from([x, y + if sides >> k & 1 == 1 { 1e-3 } else { -1e-3 }])
            };
            let word = punctures.word(&[a, beside(0), beside(1), beside(2), beside(3), b]);
            let mut rays: Vec<i32> = word.letters().iter().map(|letter| letter.abs()).collect();
            rays.sort_unstable();
            back += usize::from(rays.windows(2).any(|pair| pair[0] == pair[1]));
            assert!(paths.iter().any(|path| *path.word() == word), "{points:?} {word}");
        }
    }
    assert!(back > 0);
}

/// The ray of the puncture runs through the half-plane, so that the paths on the two sides of the puncture do
/// not differ by the rays that they cross, but by the part of the half-plane at which they end. The puncture
/// and the point are in the middle between two columns of nodes: the paths are mirror images, as long as each
/// other, and neither runs through the half-plane.
#[test]
fn between_a_half_plane_and_a_point_there_are_two_ways_past_a_puncture() {
    let roof = || HalfSpace::new([0.0, -1.0], -1.0).expect("a half-plane");
    let point = || Point::new([0.05, -1.2]).expect("finite");
    let punctures = Punctures::new(vec![[0.05, 0.02]]).expect("a point");
    let plain = Plain::new(&Euclidean);
    let graph = LatticeGraph::new(&plain, lattice(), 2).expect("a reach");
    for ends in [Ends::new(roof(), point()), Ends::new(point(), roof())] {
        let ends = ends.expect("bounded");
        let [one, other] = &class_paths(&graph, &ends, &punctures, 9, 1.5).expect("paths")[..]
        else {
            panic!("two paths")
        };
        assert_ne!(one.word(), other.word());
        // Sums of some thirty edges of the same length but for rounding.
        assert!((one.path().length() / other.path().length() - 1.0).abs() < 1e-13);
        // The middle of a path is within 0.1 of the height of the puncture.
        let beside =
            [one, other].map(|path| path.path().sequence(2).expect("chords").points()[1][0] - 0.05);
        assert!(beside[0] * beside[1] < 0.0, "{beside:?}");
    }
}

/// Sums of the same edges from the one end and from the other differ by rounding, which must not cost the
/// shortest path itself.
#[test]
fn a_slack_of_one_leaves_the_shortest_path_whatever_the_rounding() {
    let mut random = Random(seed(5));
    let plain = Plain::new(&Tilted);
    let graph = LatticeGraph::new(&plain, lattice(), 2).expect("a reach");
    let punctures = Punctures::new(vec![[-0.5, 0.03], [0.7, -0.6]]).expect("points");
    for case in 0..cases(20) {
        let mut end = || [random.between(-1.9, 1.9), random.between(-1.4, 1.4)];
        let ends = Ends::points(end(), end()).expect("finite");
        let shortest = graph.shortest(&ends, None).expect("a path").length();
        let paths = class_paths(&graph, &ends, &punctures, 9, 1.0).expect("paths");
        let lengths: Vec<f64> = paths.iter().map(|path| path.path().length()).collect();
        // Sums of some fifty edges, each rounded.
        let is_it = |length: &f64| (length / shortest - 1.0).abs() < 1e-13;
        assert!(!lengths.is_empty() && lengths.iter().all(is_it), "{case} {lengths:?} {shortest}");
    }
}

/// Nodes that stand exactly above a puncture are on its right. It has the same classes, with the same
/// lengths, as a puncture that is a little to the left, between two columns of nodes: no path over such a
/// node loses its letter, on the way to the right or to the left.
#[test]
fn punctures_under_columns_of_nodes_have_the_classes_of_punctures_beside_them() {
    let plain = Plain::new(&Tilted);
    // Powers of two, so that nodes and punctures are exact.
    let lattice = Lattice::new([-2.0, -1.5], [2.0, 1.5], 0.125).expect("a box");
    let graph = LatticeGraph::new(&plain, lattice, 2).expect("a reach");
    let row = [[-0.75, 0.05], [0.0, -0.3], [0.5, 0.2]];
    let beside = row.map(|[x, y]| [x - 0.01, y]);
    for [a, b] in [[[-1.5, 0.0], [1.5, 0.125]], [[1.5, 0.125], [-1.5, 0.0]]] {
        let ends = Ends::points(a, b).expect("finite");
        let classes = |points: [[f64; 2]; 3]| -> Vec<(Word, f64)> {
            let punctures = Punctures::new(points.to_vec()).expect("points");
            let paths = class_paths(&graph, &ends, &punctures, 12, 9.0).expect("paths");
            paths.iter().map(|path| (path.word().clone(), path.path().length())).collect()
        };
        let under = classes(row);
        assert_eq!(under.len(), 12);
        assert_eq!(under, classes(beside));
    }
}

/// Between a ball and a half-plane a path begins and ends with chords from and to points of the sets, which
/// count in its length: the sum of its chords, each by the trapezoidal rule.
#[test]
fn a_path_between_sets_is_as_long_as_its_chords() {
    let ball = Ball::new([-1.43, 0.11], 0.27).expect("a ball");
    let wall = HalfSpace::new([-1.0, -0.3], -1.52).expect("a wall");
    let ends = Ends::new(ball, wall).expect("bounded");
    let punctures = Punctures::new(vec![[0.03, 0.33]]).expect("a point");
    let plain = Plain::new(&Tilted);
    let graph = LatticeGraph::new(&plain, lattice(), 2).expect("a reach");
    let paths = class_paths(&graph, &ends, &punctures, 2, 9.0).expect("paths");
    assert_eq!(paths.len(), 2);
    let shortest = graph.shortest(&ends, None).expect("a path");
    for path in paths.iter().map(|path| path.path()).chain([&shortest]) {
        let corners = path.corners();
        let [first, last] = [corners[0].1, corners[corners.len() - 1].1];
        for (set, x) in [(ends.first(), first), (ends.second(), last)] {
            assert!((set.project(&x) - x).norm() < 1e-15, "{x}");
        }
        // Neighbours of the lattice, and points within a spacing of nodes.
        for pair in corners.windows(2) {
            let d = pair[1].1 - pair[0].1;
            assert!(d.amax() <= 0.2 + 1e-12, "{d}");
            let norm = |x: &SVector<f64, 2>, d: &SVector<f64, 2>| {
                let h: SMatrix<f64, 2, 2> = Tilted.gram(x);
                d.dot(&(h * d)).sqrt()
            };
            let length = edge_length(&norm, &pair[0].1, &d, 0.1);
            // Differences of sums below 10.
            assert!((pair[1].0 - pair[0].0 - length).abs() < 1e-14, "{length}");
        }
    }
    // The shortest of all classes is the shortest of all.
    assert!((paths[0].path().length() / shortest.length() - 1.0).abs() < 1e-13);
}

/// A metric that changes from node to node.
struct Rough;

impl Metric<2> for Rough {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::identity() * ((x[0] * 41.0).sin() * (x[1] * 37.0 + x[0]).sin() * 1.9 + 2.0)
    }
}

/// Between sets of any kind the shortest path is the shortest of all, with the chords to the sets: as long as
/// what is left when no edge shortens anything, with and without a lower bound on the rest of the way.
#[test]
fn between_sets_no_path_is_shorter_than_the_shortest() {
    let mut random = Random(seed(6));
    let (tilted, rough) = (Plain::new(&Tilted), Plain::new(&Rough));
    let graphs = [&tilted as &dyn Batches<2>, &rough];
    let graphs = graphs.map(|plain| LatticeGraph::new(plain, lattice(), 2).expect("a reach"));
    // Up to |x₁| = 2.1 the determinant of the tilted metric is at least 2 + cos 2.1 − ¼ > 1.2, and its
    // trace at most 4: no eigenvalue is below their quotient. The rough one is at least 1/10.
    let bounds = [0.3, 0.1].map(|c1| Constants::new(c1, 4.0, 1.0).expect("in order"));
    let none = Punctures::new(Vec::new()).expect("no points");
    for case in 0..cases(24) {
        let (graph, bound) = (&graphs[case as usize / 2 % 2], &bounds[case as usize / 2 % 2]);
        let [x, y] = [random.between(-1.7, -0.6), random.between(-1.2, 1.2)];
        let ball = Ball::new([x, y], random.between(0.05, 0.4)).expect("a ball");
        let tilt = random.between(-0.5, 0.5);
        let wall = HalfSpace::at_least([1.0, tilt], random.between(0.7, 1.1)).expect("a wall");
        let ends = if case % 2 == 0 { Ends::new(ball, wall) } else { Ends::new(wall, ball) };
        let ends = ends.expect("bounded");
        let least = around_a_wall(graph, &ends, [0.0, f64::NEG_INFINITY], true);
        let [one] = &class_paths(graph, &ends, &none, 9, 2.0).expect("paths")[..] else {
            panic!("one class")
        };
        for path in [
            &graph.shortest(&ends, None).expect("a path"),
            &graph.shortest(&ends, Some(bound)).expect("a path"),
            one.path(),
        ] {
            // Sums of some thirty edges.
            assert!((path.length() / least - 1.0).abs() < 1e-13, "{case} {}", path.length());
        }
    }
}

/// The bound of A* has to hold where a path ends as well as at the nodes: between them the metric has a dip.
#[test]
fn a_bound_that_fails_at_an_end_between_nodes_is_refused() {
    struct Dip;
    impl Metric<2> for Dip {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let square = (x[0] - 0.05).sqr() + (x[1] - 0.05).sqr();
            SMatrix::identity() * ((square * -2e4).exp() * -0.9 + 1.0)
        }
    }
    let plain = Plain::new(&Dip);
    let graph = LatticeGraph::new(&plain, lattice(), 1).expect("a reach");
    let bound = |c1| Constants::new(c1, 1.0, 1.0).expect("in order");
    let (dip, far) = ([0.05, 0.05], [1.0, 0.4]);
    for ends in [Ends::points(dip, far), Ends::points(far, dip)] {
        let ends = ends.expect("finite");
        let refused = graph.shortest(&ends, Some(&bound(0.5)));
        assert!(matches!(refused, Err(GraphPathError::Bound { c1: 0.5, .. })), "{refused:?}");
        let [slow, fast] = [None, Some(&bound(0.1))].map(|bound| graph.shortest(&ends, bound));
        let [slow, fast] = [slow, fast].map(|path| path.expect("a path"));
        assert_eq!(slow.length(), fast.length());
        assert!(fast.opened() < slow.opened());
    }
}
