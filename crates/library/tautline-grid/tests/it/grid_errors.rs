//! What is refused, with the offending numbers.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::LARGEST_N;
use tautline_grid::{Eikonal, EikonalError, GraphPathError, Lattice, Order, eikonal, graph};
use tautline_metrics::{
    Bounded, Constants, Metric, Scalar,
    gallery::{Constant, Valleys},
};
use tautline_sets::{Ball, Ends, Point};

fn square(spacing: f64) -> Lattice<2> {
    Lattice::new([-1.0, -1.0], [1.0, 1.0], spacing).expect("a lattice")
}

fn between(a: [f64; 2], b: [f64; 2]) -> Ends<2> {
    Ends::points(a, b).expect("finite")
}

/// No metric in the strip `|x₁| < 0.3`, where `H` is negative.
struct Strip;

impl Metric<2> for Strip {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(x[0].sqr() - 0.09)
    }
}

#[test]
fn a_strip_without_a_metric_separates_the_sets() {
    let (ends, lattice) = (between([-0.7, 0.0], [0.7, 0.0]), square(0.1));
    // Not even an edge of 0.8 leaps over it.
    for reach in [1, 3, 8] {
        assert_eq!(graph(&Strip, &ends, &lattice, reach, None), Err(GraphPathError::NotConnected));
    }
    // The columns from −1 to −0.4, and the one at −0.3 if rounding leaves a metric there.
    let error = eikonal(&Strip, &ends, &lattice, Order::Second).expect_err("two halves");
    let EikonalError::NotConnected { reached, nodes: 441 } = error else { panic!("{error}") };
    assert!([7 * 21, 8 * 21].contains(&reached), "{reached}");
}

#[test]
fn an_end_outside_of_the_lattice_is_refused() {
    let lattice = square(0.1);
    for (ends, end) in
        [(between([3.0, 0.0], [0.5, 0.0]), "first"), (between([0.5, 0.0], [0.0, -1.2]), "second")]
    {
        let error = graph(&Valleys, &ends, &lattice, 1, None);
        assert_eq!(error, Err(GraphPathError::FarFromEnd { end }));
    }
    let error = eikonal(&Valleys, &between([3.0, 0.0], [0.5, 0.0]), &lattice, Order::First);
    assert_eq!(error, Err(EikonalError::FarFromEnd { end: "first" }));
    // Also within a step of a node: there is no value to interpolate.
    for end in [[0.0, -1.2], [0.0, 1.05]] {
        let error = eikonal(&Valleys, &between([0.5, 0.0], end), &lattice, Order::First);
        assert_eq!(error, Err(EikonalError::FarFromEnd { end: "second" }));
    }
    // In the strip without a metric.
    for [a, b, end] in [["0", "0.7", "first"], ["0.7", "0", "second"]] {
        let at = |x: &str| [x.parse().expect("a number"), 0.0];
        let ends = between(at(a), at(b));
        let error = eikonal(&Strip, &ends, &lattice, Order::First).expect_err("no metric");
        assert!(error.to_string().contains(end), "{error}");
        assert!(matches!(error, EikonalError::FarFromEnd { .. }), "{error}");
    }
}

#[test]
fn a_reach_or_a_bound_that_is_none_is_refused() {
    let (ends, lattice) = (between([0.5, 0.0], [-0.5, 0.0]), square(0.5));
    for reach in [0, 9, usize::MAX] {
        let error = graph(&Valleys, &ends, &lattice, reach, None);
        assert_eq!(error, Err(GraphPathError::Reach { reach, largest: 8 }));
    }
    // The least H is 1, along x₁ = 0.
    let exact = Bounded::<2>::constants(&Valleys);
    assert!(graph(&Valleys, &ends, &lattice, 1, Some(&exact)).is_ok());
    let wrong = Constants::new(1.0001, 9.0, 5.0).expect("constants");
    let error = graph(&Valleys, &ends, &lattice, 1, Some(&wrong));
    assert_eq!(error, Err(GraphPathError::Bound { c1: 1.0001, point: vec![0.0, -1.0] }));
}

#[test]
fn a_box_or_a_spacing_that_is_none_is_refused() {
    let of_spacing = |spacing| Lattice::<2>::new([0.0, 0.0], [1.0, 1.0], spacing);
    for spacing in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = of_spacing(spacing).expect_err("no spacing");
        assert!(matches!(error, GraphPathError::Box { axis: 1, .. }), "{error}");
    }
    let error = of_spacing(1e-6).expect_err("too fine");
    assert!(matches!(error, GraphPathError::TooManyNodes { nodes } if nodes > 1e12), "{error}");
    let error = Lattice::<2>::new([0.0, 0.0], [1.0, -1.0], 0.1).expect_err("no box");
    assert!(matches!(error, GraphPathError::Box { axis: 2, .. }), "{error}");
}

#[test]
fn an_equation_in_too_many_dimensions_or_nodes_is_refused() {
    let flat = Constant::<4>::new(SMatrix::identity()).expect("positive definite");
    let lattice = Lattice::new([0.0; 4], [1.0; 4], 0.5).expect("a lattice");
    let error = Eikonal::new(&flat, &lattice).expect_err("four dimensions");
    assert_eq!(error, EikonalError::Dimension { dimension: 4 });
    let lattice = square(1.0 / 1024.0);
    let error = Eikonal::new(&Valleys, &lattice).expect_err("too many nodes");
    assert_eq!(error, EikonalError::TooManyNodes { nodes: 2049 * 2049, most: 1 << 22 });
}

/// The eigenvalues of `diag(1, 10⁹)` by Frobenius norms: the condition number is 10⁹ up to a few ulps.
#[test]
fn a_metric_with_endless_stencils_is_refused() {
    let thin = Constant::<2>::new(SMatrix::from_diagonal(&[1.0, 1e9].into())).expect("positive");
    let error = Eikonal::new(&thin, &square(0.5)).expect_err("too anisotropic");
    let EikonalError::Anisotropy { point, condition, most } = error else { panic!("{error}") };
    assert_eq!((point, most), (vec![-1.0, -1.0], 1e8));
    assert!((condition / 1e9 - 1.0).abs() < 1e-12);
    // In steps of a lattice that is as thin it is isotropic.
    let root = 1e9_f64.sqrt();
    let lattice = Lattice::with_spacings([0.0, 0.0], [1.0, 1.0 / root], [0.1, 0.1 / root]);
    let lattice = lattice.expect("a lattice");
    let ends = between([0.0, 0.0], [1.0, 0.0]);
    let path = eikonal(&thin, &ends, &lattice, Order::First).expect("a path");
    assert!((path.length() - 1.0).abs() < 1e-9, "{}", path.length());
}

#[test]
fn values_and_bands_that_are_none_are_refused() {
    let lattice = square(0.5);
    let equation = Eikonal::new(&Valleys, &lattice).expect("stencils");
    // Between the nodes.
    let set = Ball::new([0.25, 0.25], 0.2).expect("a ball");
    let from = |values| equation.distances_from_values(&set, values, Order::First).map(|_| ());
    assert_eq!(from(vec![0.0; 24]), Err(EikonalError::Count { found: 24, nodes: 25 }));
    let mut values = vec![0.0; 25];
    values[7] = f64::NEG_INFINITY;
    let error = EikonalError::Value { node: 7, value: f64::NEG_INFINITY };
    assert_eq!(from(values), Err(error));
    for nothing in [f64::INFINITY, f64::NAN] {
        assert_eq!(from(vec![nothing; 25]), Err(EikonalError::FarFromEnd { end: "first" }));
    }
    for steps in [0.9, -1.0, f64::INFINITY] {
        let error = equation.clone().with_band(steps).expect_err("no band");
        assert_eq!(error, EikonalError::Band { steps, most: 4_194_304.0 });
    }
    let error = equation.with_band(f64::NAN).expect_err("no band").to_string();
    assert!(error.contains("a band of NaN steps"), "{error}");
}

/// The values spread from a node that is far from the set to which the path is to lead.
#[test]
fn a_path_that_ends_elsewhere_is_lost() {
    let lattice = square(0.1);
    let equation = Eikonal::new(&Valleys, &lattice).expect("stencils");
    let (set, other) = ([0.8, 0.8], [-0.8, 0.0]);
    let [set, other] = [set, other].map(|x| Point::new(x).expect("finite"));
    let mut values = vec![f64::INFINITY; lattice.nodes()];
    values[0] = 0.0;
    let distances = equation.distances_from_values(&set, values, Order::First).expect("a seed");
    let error = distances.path_to(&other).expect_err("another place");
    let EikonalError::PathLost { point, distance } = error else { panic!("{error}") };
    // At the seed, up to the rounding of a place.
    assert!(distance.abs() < 1e-9 && point.iter().all(|x| (x + 1.0).abs() < 1e-9), "{point:?}");
}

#[test]
fn zero_chords_are_refused() {
    let (ends, lattice) = (between([0.5, 0.0], [-0.5, 0.0]), square(0.25));
    let error = Err(GraphPathError::Chords { n: 0 });
    assert_eq!(graph(&Valleys, &ends, &lattice, 1, None).expect("a path").sequence(0), error);
    let path = eikonal(&Valleys, &ends, &lattice, Order::First).expect("a path");
    assert_eq!(path.sequence(0), error);
    let too_many = LARGEST_N + 1;
    assert_eq!(path.sequence(too_many), Err(GraphPathError::Chords { n: too_many }));
}
