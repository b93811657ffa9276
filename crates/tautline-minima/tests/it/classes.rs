//! Lattice paths of homotopy classes, beside shortest paths in a plane with a wall.

use nalgebra::{SMatrix, SVector};
use tautline::{Ends, Lattice, LatticeGraph, Metric, Plain, Punctures, Scalar, class_paths};

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
    let paths = |most, slack| class_paths(&graph, &ends, &punctures, most, slack).expect("paths");
    let all = paths(20, 9.0);
    assert_eq!(all.len(), 20);
    let mut words: Vec<_> = all.iter().map(|path| path.word().clone()).collect();
    words.sort();
    words.dedup();
    assert_eq!(words.len(), 20);
    assert!(all.is_sorted_by(|a, b| a.path().length() <= b.path().length()));
    assert_eq!(paths(3, 9.0), all[..3]);
    assert_eq!(paths(20, 1.0), all[..1]);
    let slack = 0.5 * (all[4].path().length() + all[5].path().length()) / all[0].path().length();
    assert!(all[4].path().length() < all[5].path().length());
    assert_eq!(paths(20, slack), all[..5]);
    assert!(paths(0, 9.0).is_empty());
}
