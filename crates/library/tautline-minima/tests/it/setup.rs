//! Metrics and lattices of the tests.

use nalgebra::{SMatrix, SVector};
use tautline::gallery::{Obstacle, SoftObstacles};
use tautline::{Lattice, Metric, Scalar};

/// A metric of the plane, and the Euclidean one in all further coordinates. Its minimal geodesics between
/// points of the plane stay in the plane.
#[derive(Debug)]
pub(crate) struct Planar<M>(pub(crate) M);

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
pub(crate) fn two_hills() -> SoftObstacles<2> {
    let hill = |y: f64| Obstacle { centre: [0.0, y].into(), height: 20.0, width: 0.3 };
    SoftObstacles::new(vec![hill(0.85), hill(-0.7)]).expect("hills")
}

/// The ends of curves past the two hills. The way between them is the shortest, and that below is shorter
/// than that above.
pub(crate) const PAST: [[f64; 2]; 2] = [[-2.0, 0.0], [2.0, 0.1]];

/// A lattice around the two hills.
pub(crate) fn around() -> Lattice<2> {
    Lattice::new([-2.2, -2.0], [2.2, 2.0], 0.1).expect("a box")
}

/// The flat plane without the strip `0.3 < x < 0.7`.
#[derive(Debug)]
pub(crate) struct Torn;

impl Metric<2> for Torn {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let beside = ((x[0] - 0.5).sqr() - 0.04).sqrt();
        SMatrix::identity() * (beside * 0.0 + 1.0)
    }
}
