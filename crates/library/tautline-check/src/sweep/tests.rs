//! One level, with numbers that are known by hand.

use nalgebra::SVector;
use tautline_chance::{Random, cases, seed};
use tautline_formula::Formula;
use tautline_scalar::Interval;
use tautline_sets::{AxisBox, Ball, HalfSpace, Point, Shape};

use super::{Sweep, Swept};
use crate::{Cubes, Level, lattice, quadratic::Bernstein, set::Spot, work::UNLIMITED};

type Function<'f> = &'f dyn Fn(&SVector<f64, 2>) -> f64;

fn level(exponent: i32, places: &[[i32; 2]], functions: [Function<'_>; 2]) -> Level<2> {
    let cubes = Cubes::new(exponent, places.to_vec()).expect("in range");
    let nodes = cubes.nodes();
    let at = |f: Function<'_>| nodes.iter().map(|k| f(&lattice::point(exponent - 1, k))).collect();
    Level::new(0, cubes, functions.map(at)).expect("finite")
}

fn formula(text: &str) -> Formula<2> {
    Formula::parse(text, &[]).expect("a formula")
}

fn points(ends: [[f64; 2]; 2]) -> [Shape<2>; 2] {
    ends.map(|x| Shape::Point(Point::new(x).expect("finite")))
}

fn tested<'l>(formula: &Formula<2>, sets: [&Shape<2>; 2], level: &'l Level<2>) -> Sweep<'l, 2> {
    Sweep::new(formula, sets, level, &UNLIMITED).expect("nothing stops it")
}

fn shorter(formula: &Formula<2>, sets: [&Shape<2>; 2], level: &Level<2>, hi: f64) -> Swept<2> {
    tested(formula, sets, level).shorter_than(hi).expect("nothing stops it")
}

fn swept(text: &str, ends: [[f64; 2]; 2], level: &Level<2>, hi: f64) -> Swept<2> {
    let sets = points(ends);
    shorter(&formula(text), sets.each_ref(), level, hi)
}

/// Returns the bounds on the squared gradients of `φ`, simplex by simplex.
fn squares(text: &str, level: &Level<2>) -> Vec<f64> {
    let sets = points([[0.0, 0.0]; 2]);
    let sweep = tested(&formula(text), sets.each_ref(), level);
    sweep.tested.iter().map(|tested| tested.growths[0].q).collect()
}

/// With `M = 2`, `a = 1/2` and a constant gradient the bound is attained at the centre. With half of
/// `ε` it would be 0.941, and less with none.
#[test]
fn the_whole_shift_is_needed() {
    let level = level(-1, &[[0, 0]], [&|x| x[0], &|x| x[1]]);
    for q in squares("(1 + sqr(x1 - 0.25) + sqr(x2 - 0.25)) I", &level) {
        assert!((1.0..1.0 + 1e-12).contains(&q), "{q}");
    }
}

/// The gradient of `x₁²` is largest at one side of a simplex, that of `(1 − x₁)²` at the other.
#[test]
fn all_vertices_count() {
    let f: [Function<'_>; 2] = [&|x| x[0] * x[0], &|x| (1.0 - x[0]).powi(2)];
    for f in f {
        for q in squares("1 I", &level(0, &[[0, 0]], [f, f])) {
            assert!((4.0..4.0 + 1e-12).contains(&q), "{q}");
        }
    }
    // The largest one of a sum of both axes is at the last vertex of both simplices only.
    for q in squares("1 I", &level(0, &[[0, 0]], [&|x| x.norm_squared(), &|_| 0.0])) {
        assert!((8.0..8.0 + 1e-12).contains(&q), "{q}");
    }
}

/// `H = diag(1, 4)`: the gradient of `x₁` has norm 1, that of `x₂` has norm 1/2.
#[test]
fn gradients_belong_to_their_axes() {
    let text = "[1, 0; 0, 4]";
    for (exponent, scale) in [(0, 1.0), (-3, 8.0), (2, 0.25)] {
        let linear = level(exponent, &[[0, 0]], [&|x| scale * x[0], &|_| 0.0]);
        let found = squares(text, &linear);
        assert!(found.iter().all(|q| (q / (scale * scale) - 1.0).abs() < 1e-12), "{found:?}");
        let linear = level(exponent, &[[0, 0]], [&|x| scale * x[1], &|_| 0.0]);
        let found = squares(text, &linear);
        assert!(found.iter().all(|q| (q / (scale * scale) - 0.25).abs() < 1e-12), "{found:?}");
    }
}

/// Between its nodes, `φ` is larger than at them. With ranges from the nodes, no gradient would
/// count beyond 10, and the bound would be 1.778.
#[test]
fn values_between_the_nodes_count() {
    let along = |x: &SVector<f64, 2>| [0.0, 0.5, 1.0, 9.0, 10.0][(2.0 * x[0]) as usize];
    let level = level(0, &[[0, 0], [1, 0]], [&along, &|_| 0.0]);
    let found = swept("1 I", [[0.05, 0.53], [1.8, 0.53]], &level, 3.0);
    assert!(found.lower <= 1.75 && found.lower > 0.9, "{}", found.lower);
}

/// Functions with half of the slopes prove half of the distance. With slopes of `f` above 1, which
/// would be legal for each alone, the sum bound would drop every simplex.
#[test]
fn small_slopes_prove_less_and_drop_nothing_that_short_curves_meet() {
    let places: Vec<[i32; 2]> = (-2..6).flat_map(|i| (-2..6).map(move |j| [i, j])).collect();
    let (from, to) = ([0.05, 0.13], [0.95, 0.13]);
    let level = level(-2, &places, [&|x| 0.5 * (x[0] - from[0]), &|x| 0.5 * (to[0] - x[0])]);
    let d = to[0] - from[0];
    let found = swept("1 I", [from, to], &level, 1.001 * d);
    assert!(found.lower <= 0.5 * d && found.lower >= 0.499 * d, "{} of {d}", found.lower);
    for i in 0..4 {
        assert!(found.kept.contains(&[i, 0]), "{:?}", found.kept);
    }
}

/// If `hi` is below the distance, the values prove more than `hi`, but only `hi` may be claimed:
/// curves that are longer were not followed.
#[test]
fn no_more_than_the_bound_on_the_curves_is_claimed() {
    let places: Vec<[i32; 2]> = (-2..6).flat_map(|i| (-2..6).map(move |j| [i, j])).collect();
    let (from, to) = ([0.05, 0.13], [0.95, 0.13]);
    let level = level(-2, &places, [&|x| x[0] - from[0], &|x| to[0] - x[0]]);
    let hi = 0.97 * (to[0] - from[0]);
    let found = swept("1 I", [from, to], &level, hi);
    assert_eq!(found, Swept { lower: hi, kept: Vec::new() });
    // Cubes without one of the sets.
    let found = swept("1 I", [from, [9.0, 9.0]], &level, hi);
    assert_eq!(found, Swept { lower: hi, kept: Vec::new() });
}

/// On a set that a simplex meets, the levels begin at the largest value.
#[test]
fn levels_begin_at_the_largest_value_on_the_set() {
    let ends = [[0.3, 0.4], [3.5, 0.4]];
    // Both ends of a union of two points.
    let from =
        Shape::Union(vec![points([ends[0]; 2])[0].clone(), points([[1.5, 0.6]; 2])[0].clone()]);
    let places: Vec<[i32; 2]> = (0..8).flat_map(|i| [[i, 0], [i, 1]]).collect();
    let level = level(-1, &places, [&|x| x[0], &|x| -x[0]]);
    let to = points([ends[1]; 2])[1].clone();
    let found = shorter(&formula("1 I"), [&from, &to], &level, 2.5);
    assert!(found.lower <= 2.0 + 1e-15 && found.lower > 2.0 - 1e-12, "{}", found.lower);
}

/// The walls of two cubes: `x₁` grows from the left wall to the right one.
#[test]
fn every_facet_of_the_boundary_counts_once() {
    let level = level(0, &[[0, 0], [1, 0]], [&|x| x[0], &|x| 4.0 * x[1]]);
    let sets = points([[0.0, 0.5], [1.0, 0.0]]);
    let sweep = tested(&formula("1 I"), sets.each_ref(), &level);
    let to_the_boundary = |ignored: &dyn Fn(Spot<'_, 2>, usize) -> bool| {
        let found = sweep.to_the_boundary(None, |_, spot, k| ignored(spot, k));
        found.expect("nothing stops it")
    };
    // All facets: the left wall has the value 0, and so has the bottom for the other function.
    assert_eq!(to_the_boundary(&|_, _| false), [0.0, 0.0]);
    // Without the first vertex of a simplex, the facet is the right or the upper wall.
    let least = to_the_boundary(&|spot, k| k != 0 || spot.simplex.axes[0] != 0);
    assert!((least[0] - 2.0).abs() < 1e-12, "{least:?}");
    let least = to_the_boundary(&|spot, k| k != 0 || spot.simplex.axes[0] != 1);
    assert!((least[1] - 1.0).abs() < 1e-12, "{least:?}");
    let counted = std::cell::Cell::new(0);
    to_the_boundary(&|_, _| {
        counted.set(counted.get() + 1);
        false
    });
    // The wall between the cubes is not one of them.
    assert_eq!(counted.get(), 6);
}

/// `H` is not known on the cube: no bound on gradients, and nothing is dropped.
#[test]
fn where_the_metric_is_undefined_nothing_is_proved() {
    let level = level(-1, &[[0, 0], [1, 0], [-1, 0]], [&|x| 9.0 * x[0], &|x| -9.0 * x[0]]);
    let found = swept("(0.1 + sqrt(x1)) I", [[0.1, 0.2], [0.9, 0.2]], &level, 0.5);
    assert!(found.kept.contains(&[0, 0]) && found.lower < 0.5, "{found:?}");
    let q = squares("(0.1 + sqrt(x1)) I", &level);
    assert_eq!(q[..2], [f64::INFINITY; 2], "{q:?}");
}

/// One to four pieces, as large as a simplex or smaller.
fn union(random: &mut Random) -> Shape<2> {
    let piece = |random: &mut Random| {
        let mut vector = |size: f64| SVector::<f64, 2>::from_fn(|_, _| random.between(-size, size));
        let (x, y) = (vector(1.0), vector(0.5));
        match (random.unit() * 4.0) as usize {
            0 => Shape::Point(Point::new(x).expect("finite")),
            1 => Shape::Ball(Ball::new(x, y.norm()).expect("a ball")),
            2 => Shape::AxisBox(AxisBox::from_corners(x - y.abs(), x + y.abs()).expect("a box")),
            _ => Shape::HalfSpace(HalfSpace::new(y, -0.3 * y.norm()).expect("a wall")),
        }
    };
    let count = 1 + (random.unit() * 4.0) as usize;
    Shape::Union((0..count).map(|_| piece(random)).collect())
}

/// Of all pieces in a simplex, the greatest value of the set's own function and the least one of the
/// other count.
#[test]
fn the_values_at_all_points_of_a_union_are_within_those_of_its_simplices() {
    let mut random = Random(seed(81));
    let places: Vec<[i32; 2]> = (-1..1).flat_map(|i| (-1..1).map(move |j| [i, j])).collect();
    let (mut seen, mut sharp) = (0, 0);
    for _ in 0..cases(300) {
        let sets = [union(&mut random), union(&mut random)];
        let cubes = Cubes::new(0, places.clone()).expect("in range");
        let count = cubes.nodes().len();
        let values = [0, 1].map(|_| (0..count).map(|_| random.between(-1.0, 1.0)).collect());
        let level = Level::new(0, cubes, values).expect("finite");
        let formula = formula("1 I");
        let sweep = tested(&formula, sets.each_ref(), &level);
        for set in [0, 1] {
            // Points of the set: its own ones, and those of a square.
            let spots = sets[set].pieces().into_iter().filter_map(|piece| match piece {
                Shape::Point(point) => Some(*point.position()),
                _ => None,
            });
            let mut samples: Vec<SVector<f64, 2>> = spots.collect();
            samples.extend((0..60).map(|_| SVector::from_fn(|_, _| random.between(-1.0, 1.0))));
            for x in samples.iter().filter(|x| sets[set].contains(x)) {
                let place = [0, 1].map(|i| x[i].floor() as i32);
                let cube = level.cubes().places().binary_search(&place).expect("a cube");
                let y = [0, 1].map(|i| Interval::point(x[i]) - f64::from(place[i]));
                let axes = if y[0].midpoint() >= y[1].midpoint() { [0, 1] } else { [1, 0] };
                let number = sweep.simplices.iter().position(|s| s.axes == axes).expect("one");
                let weights =
                    [Interval::point(1.0) - y[axes[0]], y[axes[0]] - y[axes[1]], y[axes[1]]];
                let mut scratch = super::Scratch::default();
                let values = scratch.values(&level, &place);
                let value = values.map(|values| {
                    Bernstein::<2>::of(&sweep.simplices[number], values).at(&weights)
                });
                let simplex = 2 * cube + number;
                let found = sweep.meetings[set].iter().find(|found| found.simplex == simplex);
                let found = found.unwrap_or_else(|| panic!("{x} of {:?} is missed", sets[set]));
                assert!(value[set].lo() <= found.own, "{x} {:?} {found:?}", sets[set]);
                assert!(found.other <= value[1 - set].hi(), "{x} {:?} {found:?}", sets[set]);
                seen += 1;
                sharp += usize::from(value[set].hi() > found.own - 1e-12);
            }
        }
    }
    // At a point that is the only one of its set in a simplex, the values are those of the point.
    assert!(seen > 1000 && sharp > 20, "{seen} {sharp}");
}

/// Of all simplices that the set meets, the largest value counts, wherever that is in their order.
#[test]
fn a_facet_counts_from_the_largest_value_on_the_set() {
    let level = level(-2, &[[0, 0], [1, 0], [2, 0], [3, 0]], [&|x| x[0], &|_| 0.0]);
    let from =
        Shape::Union([0.125, 0.625, 0.375].map(|x| points([[x, 0.1]; 2])[0].clone()).to_vec());
    let to = points([[0.5, 0.1]; 2])[0].clone();
    let formula = formula("1 I");
    let sweep = tested(&formula, [&from, &to], &level);
    // Only the right wall counts.
    let ignored = |_: &[&_], spot: Spot<'_, 2>, k| k != 0 || spot.simplex.axes[0] != 0;
    let least = sweep.to_the_boundary(None, ignored).expect("nothing stops it");
    assert!(least[0] <= 0.375 && least[0] > 0.375 - 1e-3, "{least:?}");
}
