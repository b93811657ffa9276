//! Tests metrics that are undefined between the nodes of a rule, where the resulting curve passes.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{Interpolation, Rule};
use tautline_metrics::{Metric, MetricError, Scalar};
use tautline_optimizers::{Options, SolveError, minimise};
use tautline_sets::{AxisBox, Ends, FiniteSet};

use crate::setup::{ball, between, from_to, half_space, lowest, only, point, straight};

/// The identity with the last entry `1 − (3/2) e^{−|P(x − c)|²/w²}`. This entry is negative within
/// `0.6 w` of `c`, and 1 up to rounding from `6 w` on. `P` projects to the first coordinate, or is
/// the identity.
struct Dip<const D: usize> {
    centre: SVector<f64, D>,
    width: f64,
    of_all: bool,
}

impl<const D: usize> Metric<D> for Dip<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let square = |i: usize| ((x[i] - self.centre[i]) / self.width).sqr();
        let distance = (1..D).filter(|_| self.of_all).map(square).fold(square(0), |a, b| a + b);
        let mut h = SMatrix::identity();
        h[(D - 1, D - 1)] = 1.0 - 1.5 * (-distance).exp();
        h
    }
}

/// The fractions of a chord at which the quadrature evaluates, other than its middle.
const PLACES: [f64; 6] = [
    0.019_754_365_645_989_85,
    0.112_701_665_379_258_3,
    0.282_878_125_326_598_7,
    0.717_121_874_673_401_3,
    0.887_298_334_620_741_7,
    0.980_245_634_354_010_2,
];

const N: usize = 4;

/// The point on the first axis at `x`.
fn on_the_axis<const D: usize>(x: f64) -> SVector<f64, D> {
    SVector::from_fn(|i, _| if i == 0 { x } else { 0.0 })
}

/// Solves along a straight line from 0 to 1 on the first axis, with a dip at the fraction `place`
/// of a chord that is too narrow for the nodes. The error must name that place.
#[track_caller]
fn assert_refused<const D: usize>(rule: Rule, ends: &Ends<D>, chord: usize, place: f64) {
    let x = (chord as f64 + place) / N as f64;
    let dip = Dip::<D> { centre: on_the_axis(x), width: 3e-4, of_all: false };
    let line = straight(on_the_axis(0.0), on_the_axis(1.0), N);
    let options = only(line.clone());
    // The nodes miss the dip, so the discrete energy is the energy of the straight line.
    assert_eq!(rule.energy(&dip, &line), 1.0);
    let error = minimise(&dip, ends, rule, N, &options).expect_err("no metric");
    let SolveError::Metric(MetricError::NotPositiveDefinite { point, eigenvalue }) = &error else {
        panic!("{error}");
    };
    // The eigenvalue is 1 − 3/2, up to the rounding of the place divided by the width:
    // (1e-16/3e-4)².
    assert!((point[0] - x).abs() < 1e-14 && (eigenvalue + 0.5).abs() < 1e-12, "{error}");
    assert!(point[1..].iter().all(|&y| y == 0.0));
    assert!(error.to_string().contains("is not positive definite"), "{error}");
}

fn assert_refused_everywhere<const D: usize>(rule: Rule) {
    let corner = SVector::<f64, D>::from_fn(|i, _| if i == 0 { -0.5 } else { 0.0 });
    let ball = || ball(corner, 0.5);
    let wall = || half_space(on_the_axis::<D>(1.0), 1.0);
    let cube = || AxisBox::new(on_the_axis::<D>(2.0), SVector::repeat(1.0)).expect("not empty");
    let between = [
        from_to(on_the_axis::<D>(0.0), on_the_axis(1.0)),
        between(ball(), wall()),
        between(ball(), cube()),
    ];
    for ends in &between {
        for chord in 0..N {
            PLACES.iter().for_each(|&place| assert_refused(rule, ends, chord, place));
        }
    }
}

#[test]
fn a_defect_between_nodes_is_reported_with_its_point() {
    assert_refused_everywhere::<1>(Rule::TRAPEZOIDAL);
    assert_refused_everywhere::<2>(Rule::TRAPEZOIDAL);
    assert_refused_everywhere::<3>(Rule::LEFT_ENDPOINT);
    assert_refused_everywhere::<5>(Rule::LEFT_ENDPOINT);
}

/// The search runs from all starts on every grid, where nodes may find the dip. Every result has a
/// length.
#[test]
fn a_result_has_a_length() {
    let mut refused = 0;
    for width in [0.001, 0.01, 0.1] {
        for n in [1, 2, 3, 5, 8, 16, 33, 64, 100, 300] {
            let dip = Dip::<1> { centre: on_the_axis(0.4), width, of_all: false };
            let ends = from_to([0.0], [1.0]);
            match minimise(&dip, &ends, Rule::TRAPEZOIDAL, n, &Options::default()) {
                Ok(minimum) => {
                    let curve = Interpolation::new(&minimum.sequence);
                    let length = curve.length(&dip).value;
                    assert!(
                        length > 0.0,
                        "width {width}, N = {n}: {length}, {:?} {minimum:?}",
                        curve.check(&dip)
                    );
                }
                Err(SolveError::Metric(MetricError::NotPositiveDefinite { point, .. })) => {
                    assert!((point[0] - 0.4).abs() < width, "width {width}, N = {n}: {point:?}");
                    refused += 1;
                }
                Err(error) => panic!("{error}"),
            }
        }
    }
    // The widest dip is refused on all grids, the narrower ones if the chords are short enough.
    assert!(refused >= 15, "{refused}");
}

/// Both of two ways have a dip that the quadrature finds and the rule misses.
#[test]
fn the_error_is_the_defect_of_the_lowest_result() {
    struct TwoDips;
    impl Metric<2> for TwoDips {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let dip = |place: f64| (((x[0] - place) * 3e3).sqr() * -1.0).exp() * 2.0;
            let [near, far] = [16.0 + PLACES[4], 17.0 + PLACES[4]].map(|chords| chords / 40.0);
            SMatrix::from_diagonal_element(1.0 - dip(near) - dip(-1.2 * far))
        }
    }
    for members in [[[-1.2, 0.0], [1.0, 0.0]], [[1.0, 0.0], [-1.2, 0.0]]] {
        let ends = between(point([0.0, 0.0]), FiniteSet::new(members).expect("finite"));
        let error = minimise(&TwoDips, &ends, Rule::TRAPEZOIDAL, 40, &Options::default());
        let Err(SolveError::Metric(MetricError::NotPositiveDefinite { point, .. })) = error else {
            panic!("{error:?}")
        };
        assert!((point[0] - 0.422).abs() < 1e-3, "{point:?}");
    }
}

/// The way to the nearer of two points has a dip, on the only grid or on one that is refined later.
/// On the finer grid a single search is followed.
#[test]
fn the_lowest_result_with_a_metric_all_along_is_returned() {
    for (n, of, chord, width) in [(N, N, 1, 3e-4), (600, 150, 75, 1e-5)] {
        let centre = on_the_axis((chord as f64 + PLACES[1]) / of as f64);
        let dip = Dip::<2> { centre, width, of_all: true };
        let members = FiniteSet::new([[1.0, 0.0], [0.0, 1.2]]).expect("finite");
        let ends = between(point([0.0, 0.0]), members);
        let minimum = lowest(&dip, &ends, Rule::TRAPEZOIDAL, n);
        assert_eq!(*minimum.sequence.last(), SVector::from([0.0, 1.2]), "N = {n}");
        // The N squares of 1.2/N are each rounded.
        assert!((minimum.energy - 1.44).abs() < 1e-13 && minimum.is_local_minimum());
    }
}
