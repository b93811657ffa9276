//! Lattice paths of homotopy classes, beside shortest paths in a plane with a wall.

use nalgebra::{SMatrix, SVector};
use tautline::{
    ClassPath, Ends, GraphPathError, HalfSpace, Lattice, LatticeGraph, Metric, Plain, Point,
    Punctures, Scalar, class_paths,
};
use tautline_chance::{Random, seed};

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
