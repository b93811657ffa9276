//! Distances and values on sets against samples.

use nalgebra::SVector;
use tautline_chance::{Random, cases, seed};
use tautline_scalar::Interval;
use tautline_sets::{AxisBox, Ball, ClosedSet, HalfSpace, Point, Shape};

use super::{Piece, Spot, bounding_box, distance_below};
use crate::{kuhn::simplices, quadratic::Bernstein};

fn set(random: &mut Random) -> Shape<2> {
    let mut vector = || SVector::from_fn(|_, _| random.between(-1.5, 2.5));
    let (a, b): (SVector<f64, 2>, SVector<f64, 2>) = (vector(), vector());
    match (random.unit() * 4.0) as usize {
        0 => Shape::Point(Point::new(a).expect("finite")),
        1 => Shape::Ball(Ball::new(a, random.between(0.0, 1.5)).expect("a ball")),
        2 => Shape::AxisBox(AxisBox::from_corners(a.inf(&b), a.sup(&b)).expect("a box")),
        _ => Shape::HalfSpace(HalfSpace::new(a, random.between(-1.0, 1.0)).expect("a wall")),
    }
}

/// Returns the distance, by the projection.
fn distance(set: &Shape<2>, x: &SVector<f64, 2>) -> f64 {
    let projected = match set {
        Shape::Point(set) => set.project(x),
        Shape::Ball(set) => set.project(x),
        Shape::AxisBox(set) => set.project(x),
        Shape::HalfSpace(set) => set.project(x),
        other => unreachable!("{} is not drawn", other.name()),
    };
    (x - projected).norm()
}

#[test]
fn distances_are_lower_bounds_and_nearly_exact() {
    let mut random = Random(seed(51));
    for _ in 0..cases(1000) {
        let set = set(&mut random);
        let low = SVector::<f64, 2>::from_fn(|_, _| random.between(-3.0, 3.0));
        let side = 10.0_f64.powf(random.between(-3.0, 0.5));
        let cube = low.map(|t| Interval::new(t, t + side).expect("a side"));
        let bound = distance_below(&set, &cube);
        let x = low + SVector::from_fn(|_, _| random.unit()) * side;
        let exact = distance(&set, &x);
        assert!(bound <= exact + 1e-14, "{bound} > {exact}: {set:?}");
        // The cube has a diagonal of √2 sides; intervals at most double the dependence.
        assert!(bound >= exact - 3.0 * side - 1e-14, "{bound} {exact} {side}: {set:?}");
        if set.contains(&x) {
            assert!(exact <= 1e-14 && bound == 0.0);
        }
        if let Some(around) = bounding_box(&set)
            && set.contains(&x)
        {
            assert!((0..2).all(|i| around[i].contains(x[i])));
        }
    }
}

/// The multipliers of the constraints are found by floats, and any that is not negative is legal.
#[test]
fn values_on_a_set_hold_all_samples() {
    let mut random = Random(seed(52));
    let (mut met, mut sharper) = (0, 0);
    for _ in 0..cases(2000) {
        let set = set(&mut random);
        let scale = random.between(0.1, 3.0);
        let values: Vec<f64> = (0..9).map(|_| random.between(-scale, scale)).collect();
        let low = SVector::zeros();
        for simplex in &simplices(2) {
            let spot = Spot { simplex, low: &low, side: 1.0 };
            let form = Bernstein::<2>::of(simplex, &values);
            let pieces = Piece::of(&set);
            let found = pieces[0].values(spot, [&form]);
            for n in 0..20 {
                let (s, t) = (random.unit(), random.unit());
                let heights = [s.max(t), s.min(t)];
                let mut x = SVector::zeros();
                (x[simplex.axes[0]], x[simplex.axes[1]]) = (heights[0], heights[1]);
                if n == 0
                    && let Shape::Point(point) = &set
                {
                    x = *point.position();
                }
                let weights = [
                    1.0 - x[simplex.axes[0]],
                    x[simplex.axes[0]] - x[simplex.axes[1]],
                    x[simplex.axes[1]],
                ];
                if !set.contains(&x) || weights.iter().any(|&w| w < 0.0) {
                    continue;
                }
                let exact = form.at(&weights.map(Interval::point)).midpoint();
                let range = found.as_ref().expect("they meet")[0];
                met += 1;
                sharper += usize::from(range.width() < 0.9 * form.range().width());
                assert!(range.lo() <= exact + 1e-12 && exact - 1e-12 <= range.hi(), "{set:?}");
            }
        }
    }
    // The test could not fail if the sets did not meet, or if all ranges were those of the simplex.
    assert!(met > 1000 && sharper > 100, "{met} {sharper}");
}

/// A point on a face belongs to the simplices on both sides, and a corner to all.
#[test]
fn points_on_faces_belong_to_all_their_simplices() {
    let corner = Piece::Point(SVector::repeat(Interval::point(0.0)));
    let diagonal = Piece::Point(SVector::repeat(Interval::point(0.3)));
    let side = Piece::Point(SVector::from([0.0, 0.3].map(Interval::point)));
    let meets = |piece: &Piece<2>, low: [f64; 2]| {
        let low = SVector::from(low);
        let simplices = simplices(2);
        let of = |simplex| {
            let form = Bernstein::<2>::of(simplex, &[0.0; 9]);
            piece.values(Spot { simplex, low: &low, side: 1.0 }, [&form]).is_some()
        };
        simplices.iter().filter(|simplex| of(simplex)).count()
    };
    assert_eq!([[0.0, 0.0], [-1.0, -1.0]].map(|low| meets(&corner, low)), [2, 2]);
    assert_eq!([[-1.0, 0.0], [0.0, -1.0]].map(|low| meets(&corner, low)), [1, 1]);
    assert_eq!([[0.0, 0.0], [-1.0, 0.0]].map(|low| meets(&diagonal, low)), [2, 0]);
    assert_eq!([[0.0, 0.0], [-1.0, 0.0]].map(|low| meets(&side, low)), [1, 1]);
}

/// Facets inside a set, which a curve may cross at its end.
#[test]
fn facets_in_a_set_are_found_and_no_others() {
    let simplex = &simplices(2)[0];
    let low = SVector::zeros();
    let spot = Spot { simplex, low: &low, side: 1.0 };
    // The facet without the first vertex is the high face of the first axis.
    let wall = |offset| {
        let wall = HalfSpace::at_least([1.0, 0.0], offset).expect("a wall");
        Piece::of(&Shape::HalfSpace(wall)).remove(0)
    };
    assert_eq!(simplex.axes[0], 0);
    assert!(wall(1.0).holds_facet(spot, 0) && !wall(1.0).holds_facet(spot, 2));
    assert!(!wall(1.001).holds_facet(spot, 0) && wall(-0.1).holds_facet(spot, 2));
    let ball = Piece::of(&Shape::Ball(Ball::new([1.0, 0.5], 0.5).expect("a ball"))).remove(0);
    // The Bernstein coefficients of |x − c|² on the facet are 1/4, 1/4 and −1/4.
    assert!(ball.holds_facet(spot, 0) && !ball.holds_facet(spot, 1));
    assert!(!Piece::<2>::Point(SVector::repeat(Interval::point(0.0))).holds_facet(spot, 0));
}

/// At a point a linear function is the product of two doubles, which is exact in a fused operation up
/// to its last rounding.
#[test]
fn values_at_points_are_rounded_outward() {
    let mut random = Random(seed(53));
    for _ in 0..cases(200) {
        let (slope, x) = (random.between(0.1, 9.0), random.unit());
        let simplex = &simplices(1)[0];
        let low = SVector::zeros();
        let form = Bernstein::<1>::of(simplex, &[0.0, 0.5 * slope, slope]);
        let piece = Piece::of(&Shape::Point(Point::new([x]).expect("finite"))).remove(0);
        let spot = Spot { simplex, low: &low, side: 1.0 };
        let [range] = piece.values(spot, [&form]).expect("a point of the cube");
        assert!(slope.mul_add(x, -range.lo()) >= 0.0, "{slope} {x}");
        assert!(slope.mul_add(x, -range.hi()) <= 0.0, "{slope} {x}");
        assert!(range.width() < 1e-14, "{range:?}");
    }
}

/// Returns whether `(bound + shift)² · factor ≤ square`, exactly, for a bound between 1 and 2¹⁰.
fn is_at_most_root(bound: f64, shift: i128, factor: i128, square: i128) -> bool {
    // The bound is a multiple of 2⁻⁵².
    let unit = 1_i128 << 52;
    let bound = (bound * unit as f64) as i128 + shift * unit;
    bound * bound * factor <= square * unit * unit
}

/// Sets and cubes of small integers: the distance is a root, less a radius or divided by a root. It is
/// never below the bound, not even by a rounding error.
#[test]
fn no_distance_is_below_its_bound_by_a_rounding() {
    let origin = SVector::<f64, 2>::zeros();
    let shape = |normal: [i32; 2], offset: i32| {
        Shape::HalfSpace(HalfSpace::new(normal.map(f64::from), f64::from(offset)).expect("a wall"))
    };
    let mut seen = [0; 4];
    for (a, b, side) in
        (-6..6).flat_map(|a| (-6..6).flat_map(move |b| [(a, b, 0), (a, b, 1), (a, b, 3)]))
    {
        let cube =
            SVector::from([a, b].map(|low: i32| {
                Interval::new(f64::from(low), f64::from(low + side)).expect("a side")
            }));
        // The distance of the cube from the interval from 0 to `far` along an axis.
        let away = |low: i32, far: i32| (low - far).max(-(low + side)).max(0);
        let square = |far: [i32; 2]| {
            let [x, y] = [away(a, far[0]), away(b, far[1])];
            i128::from(x * x + y * y)
        };
        let mut check = |kind: usize, set: &Shape<2>, shift: i128, factor: i128, square: i128| {
            let bound = distance_below(set, &cube);
            let near = (square as f64 / factor as f64).sqrt() - shift as f64;
            assert!(bound >= near - 1e-13, "{bound} {near}: {set:?} {cube:?}");
            if bound >= 1.0 {
                seen[kind] += 1;
                let holds = is_at_most_root(bound, shift, factor, square);
                assert!(holds, "{bound} {near}: {set:?} {cube:?}");
            } else {
                assert!(bound >= 0.0 && bound <= near.max(0.0) + 1e-15, "{bound} {near}: {set:?}");
            }
        };
        check(0, &Shape::Point(Point::new(origin).expect("finite")), 0, 1, square([0, 0]));
        for r in [1, 2, 3] {
            let ball = Shape::Ball(Ball::new(origin, f64::from(r)).expect("a ball"));
            check(1, &ball, i128::from(r), 1, square([0, 0]));
        }
        let far = AxisBox::from_corners([0.0, 0.0], [1.0, 2.0]).expect("a box");
        check(2, &Shape::AxisBox(far), 0, 1, square([1, 2]));
        for (normal, offset) in [([1, 2], 3), ([-3, 1], 1), ([2, -2], -1), ([0, 3], 2), ([5, 4], 0)]
        {
            let corners =
                [0, side].map(|x| [0, side].map(|y| (a + x) * normal[0] + (b + y) * normal[1]));
            let least = corners.concat().into_iter().min().expect("corners") - offset;
            let length = i128::from(normal[0] * normal[0] + normal[1] * normal[1]);
            let least = i128::from(least.max(0));
            check(3, &shape(normal, offset), 0, length, least * least);
        }
    }
    assert!(seen.iter().all(|&count| count > 100), "{seen:?}");
}

/// A union is as near as the nearest of its pieces, wherever that stands.
#[test]
fn the_distance_of_a_union_is_that_of_its_nearest_piece() {
    let cube = SVector::from([0.0, 0.0].map(Interval::point));
    let piece = |x: f64| Shape::Point(Point::new([x, 0.0]).expect("finite"));
    for order in [[1.0, 2.0, 3.0], [3.0, 1.0, 2.0], [2.0, 3.0, 1.0]] {
        let bound = distance_below(&Shape::Union(order.map(piece).to_vec()), &cube);
        assert!(bound <= 1.0 && bound > 1.0 - 1e-15, "{bound}");
    }
}

/// The box around a union reaches as far as each of its pieces.
#[test]
fn the_box_around_a_union_holds_all_pieces() {
    let piece = |lower: [f64; 2], upper: [f64; 2]| {
        Shape::AxisBox(AxisBox::from_corners(lower, upper).expect("a box"))
    };
    let (one, other) = (piece([-3.0, 1.0], [0.5, 2.0]), piece([-1.0, -4.0], [7.0, 1.5]));
    for pieces in [vec![one.clone(), other.clone()], vec![other, one]] {
        let around = bounding_box(&Shape::Union(pieces)).expect("bounded");
        assert_eq!([around[0].lo(), around[0].hi()], [-3.0, 7.0]);
        assert_eq!([around[1].lo(), around[1].hi()], [-4.0, 2.0]);
    }
}

/// A box holds a facet if that is between all of its sides.
#[test]
fn a_box_holds_a_facet_only_between_all_of_its_sides() {
    let simplex = &simplices(2)[0];
    let low = SVector::zeros();
    let spot = Spot { simplex, low: &low, side: 1.0 };
    assert_eq!(simplex.axes[0], 0);
    for (lower, upper, holds) in [
        ([1.0, 0.0], [2.0, 1.0], true),
        ([0.5, -1.0], [1.0, 3.0], true),
        ([1.0, 0.001], [2.0, 1.0], false),
        ([1.0, 0.0], [2.0, 0.999], false),
        ([1.001, 0.0], [2.0, 1.0], false),
        ([0.0, 0.0], [0.999, 1.0], false),
        ([1.0, 3.0], [2.0, 4.0], false),
    ] {
        let side = AxisBox::from_corners(lower, upper).expect("a box");
        let piece = Piece::of(&Shape::AxisBox(side)).remove(0);
        assert_eq!(piece.holds_facet(spot, 0), holds, "{lower:?} {upper:?}");
    }
}

/// The ball about −1 whose radius is the double `1 + x` contains the point `x`, which is a double too.
/// The square of the radius is `1 + 2x + x²`, and doubles near it are `2⁻⁵²` apart: up to `x = 2⁻²⁶/√2`
/// it is rounded down by `x²`. On a cube of side `2⁻²⁶` a ball is nearly a half-space, and a bound on
/// `x` from a radius that is too small by half of that excludes the point.
#[test]
fn the_square_of_a_radius_is_rounded_outward() {
    let side = 2.0_f64.powi(-26);
    let simplex = &simplices(1)[0];
    let low = SVector::zeros();
    let spot = Spot { simplex, low: &low, side };
    let form = Bernstein::<1>::of(simplex, &[0.0, 0.5 * side, side]);
    for share in 1..100 {
        let x = (f64::from(share) * 2.0_f64.powi(26) / 100.0).round() * 2.0_f64.powi(-52);
        let ball = Ball::new([-1.0], 1.0 + x).expect("a ball");
        assert!(
            ball.r() - 1.0 == x && Shape::Ball(ball.clone()).contains(&SVector::from([x])),
            "exact"
        );
        let found = Piece::of(&Shape::Ball(ball))[0].values(spot, [&form]);
        let [range] = found.expect("they meet");
        assert!(range.contains(x) && range.contains(0.0), "{share}: {x} {range:?}");
        // The ball bends away from the half-space by side²/2.
        assert!(range.hi() <= x + side * side, "{share}: {x} {range:?}");
    }
}

/// `1 ± 2⁻⁶⁰` are no doubles.
#[test]
fn the_box_about_a_ball_and_the_distance_to_it_are_rounded_outward() {
    let tiny = 2.0_f64.powi(-60);
    let ball = Shape::Ball(Ball::new([1.0, 0.0], tiny).expect("a ball"));
    let [x, y] = bounding_box(&ball).expect("bounded").into();
    assert!(x.lo() < 1.0 && 1.0 < x.hi() && x.width() <= 4.0 * f64::EPSILON, "{x:?}");
    assert_eq!(y, Interval::new(-tiny, tiny).expect("ordered"));
    // The distance from the origin is 1 − 2⁻⁶⁰, and from (2, 0) too.
    for at in [0.0, 2.0] {
        let distance = distance_below(&ball, &SVector::from([at, 0.0].map(Interval::point)));
        assert!(distance < 1.0 && distance > 1.0 - 4.0 * f64::EPSILON, "{at}: {distance}");
    }
}
