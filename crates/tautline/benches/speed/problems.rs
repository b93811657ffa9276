//! The six problems on which solvers are timed.

use std::f64::consts::PI;

use tautline::{
    Ball, Ends, HalfSpace, Metric, Options, PointSequence, Problem, SVector, Starts,
    gallery::{Bump, CoupledCosines, SineProjections, Sphere, Valleys},
};

/// A problem and the curve from which it is solved: the straight line.
pub(crate) struct Case<M, const D: usize> {
    pub(crate) name: &'static str,
    pub(crate) problem: Problem<M, D>,
    line: PointSequence<D>,
}

impl<M: Metric<D>, const D: usize> Case<M, D> {
    fn new(name: &'static str, metric: M, ends: Ends<D>, line: [[f64; D]; 2]) -> Self {
        let line = PointSequence::straight(line[0], line[1], 1).expect("finite");
        Self { name, problem: Problem::new(metric, ends), line }
    }

    fn between(name: &'static str, metric: M, line: [[f64; D]; 2]) -> Self {
        let ends = Ends::points(line[0], line[1]).expect("finite");
        Self::new(name, metric, ends, line)
    }

    /// One search, from the straight line.
    pub(crate) fn options(&self) -> Options<D> {
        Options { starts: Starts::Only(vec![self.line.clone()]), ..Options::default() }
    }
}

/// Across two valleys, to be left at once: the straight line is a geodesic.
pub(crate) fn p1() -> Case<Valleys, 2> {
    Case::between("P1", Valleys, [[0.0, 0.0], [4.0 * PI, 0.0]])
}

/// Round a bump: the straight line is near a saddle.
pub(crate) fn p2() -> Case<Bump, 2> {
    let bump = Bump::new(4.0, 0.5).expect("a width");
    Case::between("P2", bump, [[-1.5, 0.05], [1.5, -0.1]])
}

/// A full matrix in space.
pub(crate) fn p3() -> Case<CoupledCosines, 3> {
    Case::between("P3", CoupledCosines, [[0.0; 3], [3.0, 2.0, -2.0]])
}

/// Round the same bump, from a ball to a half-space.
pub(crate) fn p4() -> Case<Bump, 2> {
    let bump = Bump::new(4.0, 0.5).expect("a width");
    let ball = Ball::new([-2.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 2.0).expect("a normal");
    let ends = Ends::new(ball, wall).expect("the ball is bounded");
    Case::new("P4", bump, ends, [[-1.6, 0.3], [2.0, 0.3]])
}

/// Eight terms of rank one in eight dimensions.
pub(crate) fn p5() -> Case<SineProjections<8>, 8> {
    Case::between("P5", SineProjections::benchmark(), [[0.0; 8], [1.0; 8]])
}

/// On a sphere, in the stereographic chart.
pub(crate) fn p6() -> Case<Sphere, 2> {
    Case::between("P6", Sphere, [[-0.8, 0.3], [1.1, 0.6]])
}

/// The points of a curve on the way of the search, neither straight nor a geodesic: what a pass
/// over the points is timed at.
pub(crate) fn bent<const D: usize>(line: [&SVector<f64, D>; 2], n: usize) -> PointSequence<D> {
    let at = |k: usize| {
        let t = k as f64 / n as f64;
        line[0].lerp(line[1], t).map(|x| x + 0.1 * (PI * t).sin())
    };
    PointSequence::new((0..=n).map(at).collect()).expect("finite")
}
