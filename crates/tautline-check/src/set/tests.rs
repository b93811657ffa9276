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
        Shape::Union(_) => unreachable!("no unions are drawn"),
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
