//! Shortest paths along a lattice: the angular error, A*, and an independent search.

use nalgebra::{SMatrix, SVector};
use petgraph::{algo::dijkstra, graph::DiGraph};
use tautline_chance::{Random, cases, seed};
use tautline_formula::{Formula, Plain};
use tautline_grid::{Lattice, LatticeGraph, angular_factor, graph};
use tautline_metrics::{
    Bounded, Constants, KnownDistance, Metric,
    gallery::{Constant, Separable, Shear, Swirl, TwoChannels, Valleys},
};
use tautline_sets::{Ball, Ends, HalfSpace, Point};

fn euclidean() -> Constant<2> {
    Constant::new(SMatrix::identity()).expect("positive definite")
}

/// Returns the length of a path from 0 to a point by its distance, for the Euclidean metric.
fn ratio(end: [f64; 2], half: f64, spacing: f64, reach: usize) -> f64 {
    let lattice = Lattice::new([-half, -half], [half, half], spacing).expect("a lattice");
    let ends = Ends::points([0.0, 0.0], end).expect("finite");
    let path = graph(&euclidean(), &ends, &lattice, reach, None).expect("a path");
    path.length() / end[0].hypot(end[1])
}

/// Five diagonal steps and seven straight ones lead to `(12, 5)`, four steps `(2, 1)` and nine straight
/// ones to `(17, 4)`: both directions are within a quarter of a degree of the worst, so that the ratio is
/// below its maximum by less than `1 − cos ¼° < 10⁻⁵`. Sums of at most 2000 edges are rounded by less than
/// 10⁻¹² of themselves.
#[test]
fn the_angular_error_does_not_decrease_with_the_spacing() {
    let expected = [
        (1, [3.0, 1.25], (7.0 + 50_f64.sqrt()) / 13.0),
        (2, [4.25, 1.0], (4.0 * 5_f64.sqrt() + 9.0) / 305_f64.sqrt()),
    ];
    for (reach, end, expected) in expected {
        for spacing in [0.25, 0.125, 0.0625, 0.03125] {
            let found = ratio(end, 4.5, spacing, reach);
            assert!((found / expected - 1.0).abs() < 1e-12, "{reach} {spacing} {found}");
            let of_worst = found / angular_factor(reach);
            assert!((1.0 - 1e-5..1.0).contains(&of_worst), "{reach} {of_worst}");
        }
    }
}

/// To the nodes at the boundary of a square of 25 × 25 nodes. Their directions are at most 1/12 apart, so
/// that one is within 1/24 of the worst, where the ratio is below its maximum by less than `½ (1/24)²`.
#[test]
fn no_direction_is_worse_than_the_angular_factor() {
    for reach in 1..=4 {
        let ends = (-12..=12).flat_map(|k| [[12.0, f64::from(k)], [f64::from(k), -12.0]]);
        let worst = ends.map(|end| ratio(end, 12.0, 1.0, reach)).fold(0.0, f64::max);
        let of_factor = worst / angular_factor(reach);
        assert!(of_factor <= 1.0 + 1e-14, "{reach} {of_factor}");
        assert!(of_factor >= 1.0 - 0.5 / 24.0 / 24.0, "{reach} {of_factor}");
    }
}

/// The cost of Valleys is `f = 2 − cos x₁ ≥ 1` with `|f′| ≤ 1` and `|f″| ≤ 1`. The mean of both ends is too
/// small by at most `ℓ³/12` on an edge of length `ℓ ≤ √2 r h`, hence by at most `r² h²/6` of its cost: no
/// path is shorter than the distance by more. A path that follows the geodesic at a distance of `r h` costs
/// at most `r h` more than its angular factor.
#[test]
fn a_graph_is_too_long_by_its_angular_factor_at_most() {
    let (a, b) = ([0.3, -0.4], [2.3, 0.6]);
    let exact = Valleys.distance(&a.into(), &b.into()).expect("it does not turn back");
    let ends = Ends::points(a, b).expect("finite");
    for reach in [1, 2, 4] {
        let mut last = f64::INFINITY;
        for spacing in [0.1, 0.05, 0.025, 0.0125] {
            let lattice = Lattice::new([-0.2, -1.0], [2.8, 1.2], spacing).expect("a lattice");
            let path = graph(&Valleys, &ends, &lattice, reach, None).expect("a path");
            let (ratio, rh) = (path.length() / exact, reach as f64 * spacing);
            assert!(ratio >= 1.0 / (1.0 + rh * rh / 6.0), "{reach} {spacing} {ratio}");
            assert!(ratio <= angular_factor(reach) * (1.0 + rh), "{reach} {spacing} {ratio}");
            last = ratio;
        }
        // The direction is no edge: the slope ½ in the mean, but the geodesic is bent.
        assert!(last > 1.0 + 0.05 * (angular_factor(reach) - 1.0), "{reach} {last}");
    }
}

/// Returns the number of nodes that Dijkstra and A* open, for random ends.
fn opened<M: Metric<2>>(metric: &M, constants: &Constants, number: u64) -> [usize; 2] {
    let mut random = Random(seed(number));
    let lattice = Lattice::new([-2.0, -2.0], [2.0, 2.0], 0.125).expect("a lattice");
    let mut total = [0, 0];
    for case in 0..cases(20) {
        let mut point = || [random.between(-2.0, 2.0), random.between(-2.0, 2.0)];
        let (a, b) = (point(), point());
        let ball = Ball::new(b, 0.3).expect("a ball");
        let ends = if case % 2 == 0 {
            Ends::points(a, b)
        } else {
            Ends::new(ball, Point::new(a).expect("finite"))
        };
        let ends = ends.expect("bounded");
        let reach = 1 + case as usize % 3;
        let path = |constants| graph(metric, &ends, &lattice, reach, constants).expect("a path");
        let [plain, guided] = [path(None), path(Some(constants))];
        assert_eq!(plain.length(), guided.length(), "{case}");
        assert!(guided.opened() <= plain.opened(), "{case}");
        total[0] += plain.opened();
        total[1] += guided.opened();
    }
    total
}

/// The two lengths are minima of the same rounded sums, equal bit by bit. With `c₁` near `H` in all places
/// A* opens few nodes beside the path.
#[test]
fn a_star_finds_the_length_of_dijkstra_and_opens_fewer_nodes() {
    let shear = Shear::new(0.5, 1.0).expect("a shear");
    let [all, few] = opened(&shear, &shear.constants(), 11);
    assert!(few < all, "{few} {all}");
    let [all, few] = opened(&Valleys, &Bounded::<2>::constants(&Valleys), 12);
    assert!(few < all, "{few} {all}");
    let channels = TwoChannels::new(4.0, 0.7, 0.3).expect("channels");
    let [all, few] = opened(&channels, &channels.constants(), 13);
    assert!(few < all, "{few} {all}");
    let flat = euclidean();
    let [all, few] = opened(&flat, &flat.constants(), 14);
    assert!(2 * few < all, "{few} {all}");
}

/// The search of the library petgraph on the same edges, from one more node that has edges to the nodes
/// near the first set. Its sums are in the same order, so that they have the same bits.
#[test]
fn an_independent_search_finds_the_same_length() {
    let metric = Plain::new(Separable::<2>::new([0.3, 0.5], [1.0, 2.0]).expect("a wave"));
    let lattice = Lattice::new([-1.0, -1.0], [1.0, 1.5], 0.1).expect("a lattice");
    let ball = Ball::new([-0.5, -0.31], 0.22).expect("a ball");
    let wall = HalfSpace::at_least([0.6, 0.8], 0.93).expect("a wall");
    let ends = Ends::new(ball.clone(), wall.clone()).expect("bounded");
    for reach in 1..=3 {
        let graph = LatticeGraph::new(&metric, lattice.clone(), reach).expect("a reach");
        let mut edges = DiGraph::<(), f64>::new();
        let nodes: Vec<_> = (0..lattice.nodes()).map(|_| edges.add_node(())).collect();
        for node in 0..lattice.nodes() {
            for (other, length) in graph.edges(node) {
                edges.add_edge(nodes[node], nodes[other], length);
            }
        }
        let begin = edges.add_node(());
        for (node, _, length) in graph.gates(&ball) {
            edges.add_edge(begin, nodes[node], length);
        }
        let lengths = dijkstra(&edges, begin, None, |edge| *edge.weight());
        let tails = graph.gates(&wall).into_iter();
        let shortest = tails.map(|(node, _, tail)| lengths[&nodes[node]] + tail);
        let shortest = shortest.fold(f64::INFINITY, f64::min);
        assert_eq!(graph.shortest(&ends, None).expect("a path").length(), shortest);
    }
}

/// The length of an edge by the trapezoidal rule, with the mean of the norms at the nodes next to it, two in
/// a plane of nodes, at the points between its ends. A chord to a node has no such points.
pub(crate) fn edge_length(
    norm: &dyn Fn(&SVector<f64, 2>, &SVector<f64, 2>) -> f64,
    x: &SVector<f64, 2>,
    d: &SVector<f64, 2>,
    spacing: f64,
) -> f64 {
    let ends = 0.5 * (norm(x, d) + norm(&(x + d), d));
    let steps = (d / spacing).map(f64::round);
    if (d - steps * spacing).amax() > 1e-9 {
        return ends;
    }
    if steps.amax() == 1.0 && steps.amin() == 1.0 {
        let at =
            |i: usize, j: usize| norm(&(x + SVector::from([i as f64 * d[0], j as f64 * d[1]])), d);
        let middle = 0.25 * (at(0, 0) + at(0, 1) + at(1, 0) + at(1, 1));
        return 0.5 * (ends + middle);
    }
    let (long, short) = if steps[0].abs() > steps[1].abs() { (0, 1) } else { (1, 0) };
    let mut sum = ends;
    for k in 1..steps[long].abs() as i32 {
        let part = f64::from(k) / steps[long].abs();
        let across = steps[short] * part;
        let at = |height: f64| {
            let mut y = *x;
            y[long] += spacing * steps[long] * part;
            y[short] += spacing * height;
            norm(&y, d)
        };
        let above = across - across.floor();
        sum += (1.0 - above) * at(across.floor());
        if above > 0.0 {
            sum += above * at(across.ceil());
        }
    }
    sum / steps[long].abs().max(1.0)
}

/// A wall of cost 1000 that is one node wide, with a gap at its end: the path goes through the gap, though
/// both ends of a knight's move over the wall are cheap.
#[test]
fn no_edge_leaps_over_a_wall_one_node_wide() {
    let wall = Formula::<2>::parse("cost(1 + 1000*exp(-(10*x1)^4)/(1 + exp(20*(x2 - 0.75))))", &[]);
    let lattice = Lattice::new([-1.0, -1.0], [1.0, 1.0], 0.25).expect("a lattice");
    let ends = Ends::points([-1.0, -1.0], [1.0, -1.0]).expect("finite");
    let path = graph(&wall.expect("a formula"), &ends, &lattice, 2, None).expect("a path");
    let top = path.corners().iter().map(|corner| corner.1[1]).fold(f64::NEG_INFINITY, f64::max);
    assert!(top == 1.0 && path.length() < 10.0, "{path:?}");
    // A wall along the diagonal, whose nodes touch at corners, with a gap at its end.
    let text = "cost(1 + 1000*exp(-(10*(x1 - x2))^4)/(1 + exp(20*(x1 - 0.6))))";
    let wall = Formula::<2>::parse(text, &[]).expect("a formula");
    let ends = Ends::points([-1.0, -0.5], [-0.5, -1.0]).expect("finite");
    let path = graph(&wall, &ends, &lattice, 2, None).expect("a path");
    let top = path.corners().iter().map(|corner| corner.1[0]).fold(f64::NEG_INFINITY, f64::max);
    assert!(top >= 0.75 && path.length() < 10.0, "{path:?}");
}

/// The corners are joined by edges, whose lengths are those between them, and the ends are in the sets.
#[test]
fn a_path_is_made_of_edges_between_the_sets() {
    let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
    let lattice = Lattice::new([-1.5, -1.5], [1.5, 1.5], 0.1).expect("a lattice");
    let disc = Ball::new([0.0, 0.0], 0.37).expect("a disc");
    let wall = HalfSpace::at_least([1.0, 0.0], 1.23).expect("a wall");
    let ends = Ends::new(disc, wall).expect("bounded");
    let path = graph(&swirl, &ends, &lattice, 3, None).expect("a path");
    let corners = path.corners();
    let norm = |x: &SVector<f64, 2>, d: &SVector<f64, 2>| d.dot(&(swirl.gram(x) * d)).sqrt();
    for pair in corners.windows(2) {
        let d = pair[1].1 - pair[0].1;
        let length = edge_length(&norm, &pair[0].1, &d, 0.1);
        // A few roundings of a length below 3.
        assert!((pair[1].0 - pair[0].0 - length).abs() < 1e-14);
        assert!(d.amax() <= 0.3 + 1e-14);
    }
    let (begin, end) = (corners[0].1, corners[corners.len() - 1].1);
    assert!(begin.norm() <= 0.37 + 1e-15 && end[0] >= 1.23, "{begin} {end}");
    let sequence = path.sequence(17).expect("chords");
    assert_eq!((*sequence.first(), *sequence.last()), (begin, end));
    assert_eq!(sequence.n().get(), 17);
}
