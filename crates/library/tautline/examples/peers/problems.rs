//! The problems of the comparison, P1 to P6, with the straight line from which every program
//! starts.

use std::f64::consts::PI;

use tautline::{
    Ball, Ends, HalfSpace, Metric, PointSequence, SVector,
    gallery::{Bump, CoupledCosines, SineProjections, Sphere, Valleys},
};

/// A program that takes part in the comparison.
pub(crate) trait Peer {
    /// Solves the problem on the grid of the start, which has `n` chords, and reports.
    fn solve<M: Metric<D>, const D: usize>(
        self,
        metric: M,
        ends: Ends<D>,
        start: PointSequence<D>,
    ) -> Result<(), Box<dyn std::error::Error>>;
}

/// Poses the problem of this name to a peer.
pub(crate) fn pose(
    name: &str,
    n: usize,
    peer: impl Peer,
) -> Result<(), Box<dyn std::error::Error>> {
    // exp(−2|x|²) is the bump of width 1/2.
    let bump = Bump::new(4.0, 0.5)?;
    match name {
        "P1" => between(peer, Valleys, [0.0, 0.0], [4.0 * PI, 0.0], n),
        "P2" => between(peer, bump, [-1.5, 0.05], [1.5, -0.1], n),
        "P3" => between(peer, CoupledCosines, [0.0; 3], [3.0, 2.0, -2.0], n),
        "P4" => {
            let ball = Ball::new([-2.0, 0.0], 0.5)?;
            let ends = Ends::new(ball, HalfSpace::at_least([1.0, 0.0], 2.0)?)?;
            peer.solve(bump, ends, PointSequence::straight([-1.6, 0.3], [2.0, 0.3], n)?)
        }
        "P5" => between(peer, SineProjections::benchmark(), [0.0; 8], [1.0; 8], n),
        "P6" => between(peer, Sphere, [-0.8, 0.3], [1.1, 0.6], n),
        _ => Err(format!("no problem {name}").into()),
    }
}

fn between<M: Metric<D>, const D: usize>(
    peer: impl Peer,
    metric: M,
    from: [f64; D],
    to: [f64; D],
    n: usize,
) -> Result<(), Box<dyn std::error::Error>> {
    let (from, to) = (SVector::from(from), SVector::from(to));
    peer.solve(metric, Ends::points(from, to)?, PointSequence::straight(from, to, n)?)
}
