//! Curves through passes between two distance fields.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, cases, seed};
use tautline_grid::{EikonalError, GraphPathError, Lattice, pass_paths};
use tautline_metrics::{
    Metric, Scalar,
    gallery::{Obstacle, SoftObstacles},
};
use tautline_sets::Ends;

/// A metric of the plane, and the Euclidean one in all further coordinates. Its minimal geodesics between
/// points of the plane stay in the plane.
#[derive(Debug)]
struct Planar<M>(M);

impl<M: Metric<2>, const D: usize> Metric<D> for Planar<M> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let plane = self.0.gram(&SVector::<S, 2>::from([x[0], x[1]]));
        SMatrix::from_fn(|i, j| match (i, j) {
            (0..=1, 0..=1) => plane[(i, j)],
            _ if i == j => S::one(),
            _ => S::zero(),
        })
    }
}

/// Two hills above each other.
fn two_hills() -> SoftObstacles<2> {
    let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.3 };
    SoftObstacles::new(vec![hill(0.85), hill(-0.7)]).expect("hills")
}

/// The ends of curves past the two hills. The way between them is the shortest, and that below is shorter
/// than that above.
const PAST: [[f64; 2]; 2] = [[-2.0, 0.0], [2.0, 0.1]];

/// A lattice around the two hills.
fn around() -> Lattice<2> {
    Lattice::new([-2.2, -2.0], [2.2, 2.0], 0.1).expect("a box")
}

/// The flat plane without the strip `0.3 < x < 0.7`.
#[derive(Debug)]
struct Torn;

impl Metric<2> for Torn {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let beside = ((x[0] - 0.5).sqr() - 0.04).sqrt();
        SMatrix::identity() * (beside * 0.0 + 1.0)
    }
}

/// A slack of 1 leaves the lowest pass, that of the minimal geodesic.
#[test]
fn slack_and_number_bound_the_passes() {
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let paths =
        |most, slack| pass_paths(&two_hills(), &ends, &around(), most, slack).expect("passes");
    let all = paths(9, 2.0);
    assert!(all.len() >= 3);
    assert_eq!(paths(2, 2.0), all[..2]);
    assert!(paths(0, 2.0).is_empty());
    // The lowest pass comes first, with the curve that is the shortest but for the error of its descents.
    let best = all.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min);
    assert!(all[0].length() / best - 1.0 < 0.02, "{} {best}", all[0].length());
    for slack in [0.9, f64::NAN] {
        let error = pass_paths(&two_hills(), &ends, &around(), 9, slack).map(|_| ());
        let Err(EikonalError::Lattice(GraphPathError::Slack { .. })) = error else {
            panic!("{error:?}")
        };
    }
    let [only] = &paths(9, 1.0)[..] else { panic!("one pass") };
    let shortest = all.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min);
    assert!((only.length() / shortest - 1.0).abs() < 0.02);
}

/// Whatever the errors of the two fields, a slack of 1 leaves the lowest pass, to which a curve leads that is
/// the shortest but for those errors.
#[test]
fn a_slack_of_one_leaves_a_pass_between_any_ends() {
    let mut random = Random(seed(4));
    let metric = two_hills();
    let of = |_| {
        let mut end = |side: f64| [side * random.between(1.2, 2.1), random.between(-1.5, 1.5)];
        let ends = Ends::points(end(-1.0), end(1.0)).expect("finite");
        let [least, more] = [1.0, 1.2].map(|slack| {
            let paths = pass_paths(&metric, &ends, &around(), 9, slack).expect("passes");
            paths.iter().map(|path| path.length()).fold(f64::INFINITY, f64::min)
        });
        least / more
    };
    let quotients: Vec<f64> = (0..cases(20)).map(of).collect();
    // The spacing over the length.
    assert!(quotients.iter().all(|quotient| *quotient <= 1.03), "{quotients:?}");
}

/// Whichever node of the lattice comes first: the hills one above the other, or beside each other.
#[test]
fn the_lowest_pass_comes_first() {
    for is_turned in [false, true] {
        let turned = |[x, y]: [f64; 2]| if is_turned { [y, x] } else { [x, y] };
        let hill = |y| Obstacle { centre: turned([0.0, y]).into(), height: 20.0, width: 0.3 };
        let hills = SoftObstacles::new(vec![hill(0.85), hill(-0.7)]).expect("hills");
        let ends = Ends::points(turned(PAST[0]), turned(PAST[1])).expect("finite");
        let lattice = Lattice::new(turned([-2.2, -2.0]), turned([2.2, 2.0]), 0.1).expect("a box");
        let paths = pass_paths(&hills, &ends, &lattice, 9, 2.0).expect("passes");
        let lengths: Vec<f64> = paths.iter().map(|path| path.length()).collect();
        // Sorted by the sum of two distances, which differs from the length of the two descents by their
        // errors, of the order of the spacing over the length, 0.1/4.
        assert!(lengths.is_sorted_by(|a, b| *a <= 1.025 * b), "{lengths:?}");
        assert!(lengths[0] * 1.2 < lengths[1], "{lengths:?}");
    }
}

/// Two half-planes are all that has a metric: nothing leads from one to the other.
#[test]
fn sets_that_nothing_joins_have_no_passes() {
    let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
    let lattice = Lattice::new([-1.0, -1.0], [2.0, 1.0], 0.1).expect("a box");
    let error = pass_paths(&Torn, &ends, &lattice, 9, 2.0).map(|_| ());
    // The nodes up to 0.3, which is one of them or not.
    let Err(EikonalError::NotConnected { reached: 273..=294, nodes: 651 }) = error else {
        panic!("{error:?}")
    };
}

/// In space the ways past two pillars are those of the plane.
#[test]
fn pillars_in_space_have_three_passes() {
    let [a, b] = PAST.map(|[x, y]| [x, y, 0.0]);
    let ends = Ends::points(a, b).expect("finite");
    let lattice = Lattice::new([-2.2, -2.0, -0.4], [2.2, 2.0, 0.4], 0.2).expect("a box");
    let paths = pass_paths(&Planar(two_hills()), &ends, &lattice, 9, 2.0).expect("passes");
    let height = |at: f64| paths.iter().any(|path| (path.pass()[1] - at).abs() < 0.35);
    assert!(height(1.7) && height(0.1) && height(-1.5), "{paths:?}");
}

/// In another unit of the metric the passes are the same nodes: a corner is a pure number. Powers of four do not
/// even change the rounding of lengths, which are roots.
#[test]
fn passes_are_the_same_in_other_units() {
    #[derive(Debug)]
    struct InUnits(f64);
    impl Metric<2> for InUnits {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            two_hills().gram(x).map(|h| h * self.0)
        }
    }
    let ends = Ends::points(PAST[0], PAST[1]).expect("finite");
    let of = |unit: f64| {
        let paths = pass_paths(&InUnits(unit * unit), &ends, &around(), 9, 2.0).expect("passes");
        paths.iter().map(|path| (*path.pass(), path.length() / unit)).collect::<Vec<_>>()
    };
    let passes = of(1.0);
    assert!(passes.len() >= 3);
    for unit in [1024.0, 1.0 / 1024.0] {
        assert_eq!(of(unit), passes, "{unit}");
    }
}

/// Both distance fields are of one order: from the second set to the first there are the same passes, with
/// curves of the same lengths.
#[test]
fn exchanged_sets_have_the_same_passes() {
    let of = |a, b| {
        let ends = Ends::points(a, b).expect("finite");
        pass_paths(&two_hills(), &ends, &around(), 9, 2.0).expect("passes")
    };
    let (there, back) = (of(PAST[0], PAST[1]), of(PAST[1], PAST[0]));
    assert!(there.len() >= 3);
    assert_eq!(there.len(), back.len());
    for (one, other) in there.iter().zip(&back) {
        assert_eq!(one.pass(), other.pass());
        // Sums of some hundred chords in the other order.
        assert!((one.length() / other.length() - 1.0).abs() < 1e-13, "{}", one.length());
    }
}
