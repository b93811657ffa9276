//! Fast marching beside known distances.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, seed};
use tautline_grid::{Distances, Eikonal, Lattice, Order};
use tautline_metrics::{
    KnownDistance, Metric,
    composition::AffinePullback,
    gallery::{Constant, HyperbolicPatch, Separable, Shear, SpherePatch, Swirl, Valleys},
};
use tautline_sets::{Ball, ClosedSet, HalfSpace, Point};

use crate::orders::slope;

/// A cube around the origin: its half side, and that of the cube in which errors are measured. Between
/// them stencils lack nodes.
#[derive(Clone, Copy)]
struct Cube {
    half: f64,
    inner: f64,
}

impl Cube {
    fn lattice<const D: usize>(self, spacing: f64) -> Lattice<D> {
        let half = SVector::from_element(self.half);
        Lattice::new(-half, half, spacing).expect("a lattice")
    }

    /// Returns the largest error of distances in the inner cube.
    fn error<M: Metric<D>, const D: usize>(
        self,
        distances: &Distances<M, D>,
        lattice: &Lattice<D>,
        exact: impl Fn(&SVector<f64, D>) -> f64,
    ) -> f64 {
        let nodes = (0..lattice.nodes()).map(|node| (node, lattice.point(node)));
        let inside = nodes.filter(|(_, x)| x.amax() <= self.inner);
        inside.map(|(n, x)| (distances.values()[n] - exact(&x)).abs()).fold(0.0, f64::max)
    }
}

/// Returns the slope of the largest error of the distance from a point beside the origin, with exact
/// values within `r` of it, where the distance is not smooth.
fn order_from_a_point<M: KnownDistance<D>, const D: usize>(
    metric: &M,
    cube: Cube,
    r: f64,
    spacings: [f64; 4],
    order: Order,
) -> f64 {
    let source = SVector::<f64, D>::from_fn(|i, _| 0.05 * (i as f64 + 1.0));
    let set = Point::new(source).expect("finite");
    let exact = |x: &SVector<f64, D>| metric.distance(&source, x).expect("it is known");
    let errors = spacings.map(|spacing| {
        let lattice = cube.lattice(spacing);
        let equation = Eikonal::new(metric, &lattice).expect("stencils");
        let seed = |node| {
            let x = lattice.point(node);
            if (x - source).norm() < r { exact(&x) } else { f64::INFINITY }
        };
        let seeds = (0..lattice.nodes()).map(seed).collect();
        let distances = equation.distances_from_values(&set, seeds, order).expect("seeds");
        (spacing, cube.error(&distances, &lattice, exact))
    });
    slope(&errors)
}

const SQUARE: Cube = Cube { half: 1.5, inner: 1.0 };

/// Five problems of the plane: a flat metric that is not conformal, one that turns, a diagonal one, and two
/// that are curved. Halving the spacing divides the errors by about 2 or 4. The slopes over eight times the
/// spacing are allowed a tenth, or two, below the order, for the next term of the error.
fn orders_in_the_plane(order: Order) -> [f64; 5] {
    let spacings = [1.0 / 8.0, 1.0 / 16.0, 1.0 / 32.0, 1.0 / 64.0];
    let shear = Shear::new(0.5, 1.0).expect("a shear");
    let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
    let separable = Separable::<2>::new([0.3, 0.5], [1.0, 2.0]).expect("waves");
    let hyperbolic = HyperbolicPatch::new(0.85).expect("a patch");
    let sphere = SpherePatch::new(3.0).expect("a patch");
    let disc = Cube { half: 0.55, inner: 0.5 };
    [
        order_from_a_point(&shear, SQUARE, 0.4, spacings, order),
        order_from_a_point(&swirl, SQUARE, 0.4, spacings, order),
        order_from_a_point(&separable, SQUARE, 0.4, spacings, order),
        // Its details are half as large.
        order_from_a_point::<_, 2>(&hyperbolic, disc, 0.2, spacings.map(|h| 0.5 * h), order),
        order_from_a_point::<_, 2>(&sphere, Cube { half: 1.0, inner: 0.8 }, 0.3, spacings, order),
    ]
}

#[test]
fn first_order_marching_converges_with_its_order() {
    let orders = orders_in_the_plane(Order::First);
    assert!(orders.iter().all(|&order| order > 0.9), "{orders:?}");
}

#[test]
fn second_order_marching_converges_with_its_order() {
    let orders = orders_in_the_plane(Order::Second);
    assert!(orders.iter().all(|&order| order > 1.8), "{orders:?}");
}

/// A diagonal metric in space in oblique coordinates, which has six directions in each stencil.
#[test]
fn marching_in_space_converges_with_its_order() {
    let waves = Separable::<3>::new([0.3, 0.2, 0.2], [1.0, 2.0, 1.5]).expect("waves");
    let oblique = SMatrix::<f64, 3, 3>::new(1.0, 0.4, 0.0, 0.0, 1.0, -0.3, 0.2, 0.0, 1.0);
    let metric = AffinePullback::new(waves, oblique, [0.0; 3]).expect("invertible");
    let cube = Cube { half: 0.8, inner: 0.5 };
    let spacings = [1.0 / 10.0, 1.0 / 15.0, 1.0 / 20.0, 1.0 / 30.0];
    let order = |order| order_from_a_point(&metric, cube, 0.35, spacings, order);
    let [first, second] = [order(Order::First), order(Order::Second)];
    assert!(first > 0.9 && second > 1.8, "{first} {second}");
}

/// Returns the slope of the largest error of the distance from a set, within 1 of the origin, on boxes
/// with the corner `upper`.
fn order_from_a_set<M: Metric<2>>(
    metric: &M,
    (set, upper): (&dyn ClosedSet<2>, [f64; 2]),
    spacings: [f64; 4],
    order: Order,
    exact: impl Fn(&SVector<f64, 2>) -> f64,
) -> f64 {
    let errors = spacings.map(|spacing| {
        let lattice = Lattice::new(upper.map(|x| -x), upper, spacing).expect("a lattice");
        let equation = Eikonal::new(metric, &lattice).expect("stencils");
        let distances = equation.distances_from(set, order).expect("seeds");
        (spacing, SQUARE.error(&distances, &lattice, &exact))
    });
    slope(&errors)
}

/// The swirl maps discs about the origin to themselves, and Valleys has `F(b) − F(a)` with
/// `F = 2x₁ − sin x₁` across: the chords near the boundary are accurate to the third power. The error of
/// the chords and that of the march have different signs in Valleys, so that the spacings are smaller, of
/// a strip.
#[test]
fn marching_from_a_set_with_a_smooth_boundary_needs_no_exact_values() {
    let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
    let disc = Ball::new([0.0, 0.0], 0.37).expect("a disc");
    let from_disc = |x: &SVector<f64, 2>| (x.norm() - 0.37).max(0.0);
    let wall = HalfSpace::new([1.0, 0.0], 0.02).expect("a wall");
    let climb = |x: f64| 2.0 * x - x.sin();
    let from_wall = |x: &SVector<f64, 2>| (climb(x[0]) - climb(0.02)).max(0.0);
    let spacings = [1.0 / 24.0, 1.0 / 48.0, 1.0 / 96.0, 1.0 / 192.0];
    for (order, least) in [(Order::First, 0.9), (Order::Second, 1.8)] {
        let found = order_from_a_set(&swirl, (&disc, [1.25, 1.25]), spacings, order, from_disc);
        assert!(found > least, "{order:?} {found}");
        let halves = spacings.map(|h| 0.5 * h);
        let found = order_from_a_set(&Valleys, (&wall, [1.2, 0.1]), halves, order, from_wall);
        assert!(found > least, "{order:?} {found}");
    }
}

/// The distance from a half-space under a constant metric is linear, for which all differences are exact,
/// as are the chords up to 10⁻¹². The stencils are about ten steps long and reach through the band of one
/// step into the half-space, where the values have a kink: no difference may cross it. Rounding grows by a
/// few ulps of values below 30 in each of a few hundred steps.
#[test]
fn long_stencils_do_not_reach_across_the_kink_of_a_set() {
    let (sin, cos) = 0.4_f64.sin_cos();
    let turn = SMatrix::<f64, 2, 2>::new(cos, -sin, sin, cos);
    let h = turn * SMatrix::from_diagonal(&[1.0, 100.0].into()) * turn.transpose();
    let metric = Constant::new((h + h.transpose()) * 0.5).expect("positive definite");
    let n = SVector::from([0.6, 0.8]);
    let wall = HalfSpace::new(n, 0.013).expect("a wall");
    let dual = n.dot(&(h.try_inverse().expect("regular") * n)).sqrt();
    let exact = |x: &SVector<f64, 2>| (n.dot(x) - 0.013).max(0.0) / dual;
    let cube = Cube { half: 1.5, inner: 0.5 };
    let lattice = cube.lattice(0.05);
    let equation = Eikonal::new(&metric, &lattice).expect("stencils").with_band(1.0);
    let equation = equation.expect("steps");
    for order in [Order::First, Order::Second] {
        let distances = equation.distances_from(&wall, order).expect("seeds");
        let error = cube.error(&distances, &lattice, exact);
        assert!(error < 1e-11, "{order:?} {error}");
    }
}

/// From a point with a band of chords whose width is as `h^{1/2}`: the chords are wrong by its third power,
/// the march by `h²` over the width. With three steps the order is one, of which 0.2 are allowed for the
/// difference between the two bands.
#[test]
fn a_wider_band_around_a_point_gains_half_an_order() {
    let swirl = Swirl::new(1.0, 0.7).expect("a swirl");
    let source = [0.05, 0.1];
    let point = Point::new(source).expect("finite");
    let exact = |x: &SVector<f64, 2>| swirl.distance(&source.into(), x).expect("it is known");
    let order = |exponent: f64| {
        let errors = [8.0, 16.0, 32.0, 64.0, 128.0].map(|n: f64| {
            let lattice = SQUARE.lattice(1.0 / n);
            let equation = Eikonal::new(&swirl, &lattice).expect("stencils");
            let equation = equation.with_band(3.0 * (n / 8.0).powf(exponent)).expect("steps");
            let distances = equation.distances_from(&point, Order::Second).expect("seeds");
            (1.0 / n, SQUARE.error(&distances, &lattice, exact))
        });
        slope(&errors)
    };
    let [narrow, wide] = [order(0.0), order(0.5)];
    assert!((narrow - 1.0).abs() < 0.2 && (wide - 1.5).abs() < 0.2, "{narrow} {wide}");
}

/// Raising some values of the seeds raises no other value less than nothing: for the first order, up to
/// some roundings of each of the values, which are below 10.
#[test]
fn first_order_marching_is_monotone() {
    let shear = Shear::new(1.5, 1.0).expect("a shear");
    let lattice = SQUARE.lattice(0.125);
    let equation = Eikonal::new(&shear, &lattice).expect("stencils");
    let set = Point::new([0.0, 0.0]).expect("finite");
    let mut random = Random(seed(31));
    for _ in 0..20 {
        let (mut low, mut high) = (vec![f64::INFINITY; lattice.nodes()], Vec::new());
        for _ in 0..10 {
            let node = random.bits() as usize % lattice.nodes();
            low[node] = random.between(0.0, 1.0);
        }
        high.extend(low.iter().map(|value| value + random.between(0.0, 0.5)));
        let march = |seeds| {
            let distances = equation.distances_from_values(&set, seeds, Order::First);
            distances.expect("seeds").values().to_vec()
        };
        let (low, high) = (march(low), march(high));
        assert!(low.iter().zip(&high).all(|(low, high)| *low <= high + 1e-12));
        assert!(low.iter().all(|value| value.is_finite() && *value < 10.0));
    }
}

/// The gradients of the values solve the equation that they come from, `∇uᵀH⁻¹∇u = 1`, up to the spacing
/// over the distance from the source; a node that there is not has none.
#[test]
fn gradients_have_unit_length() {
    let metric = Swirl::new(1.0, 0.8).expect("a width");
    let cube = Cube { half: 2.0, inner: 1.5 };
    let lattice = cube.lattice(0.05);
    let equation = Eikonal::new(&metric, &lattice).expect("stencils");
    let source = Ball::new([0.2, -0.1], 0.4).expect("a ball");
    let distances = equation.distances_from(&source, Order::Second).expect("reached");
    let mut checked = 0;
    for node in 0..lattice.nodes() {
        let x: SVector<f64, 2> = lattice.point(node);
        if x.amax() > cube.inner || (x - source.project(&x)).norm() < 0.3 {
            continue;
        }
        let slope = distances.gradient(node).expect("it was reached");
        let h: SMatrix<f64, 2, 2> = metric.gram(&x);
        let square = slope.dot(&h.cholesky().expect("positive definite").solve(&slope));
        assert!((square - 1.0).abs() < 0.1, "{square} at {x}");
        checked += 1;
    }
    assert!(checked > 1000);
    assert_eq!(distances.gradient(lattice.nodes()), None);
}
