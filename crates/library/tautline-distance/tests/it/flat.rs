//! Distances between sets under a constant metric, to twelve digits and with their own proof.

use nalgebra::{SMatrix, SVector};
use tautline_chance::Random;
use tautline_formula::Formula;
use tautline_metrics::gallery::Constant;
use tautline_sets::{AxisBox, Ball, ClosedSet, HalfSpace, Point, Shape};

/// The nearest points of two sets, and their distance.
#[derive(Clone, Debug)]
pub(crate) struct Nearest<const D: usize> {
    pub(crate) ends: [SVector<f64, D>; 2],
    pub(crate) distance: f64,
}

impl<const D: usize> Nearest<D> {
    /// Returns the straight line between the points.
    pub(crate) fn line(&self, chords: usize) -> Vec<SVector<f64, D>> {
        let [x, y] = self.ends;
        (0..=chords).map(|n| x.lerp(&y, n as f64 / chords as f64)).collect()
    }
}

/// Returns, for each piece of each of two sets, one of which is bounded, the nearest points of the two
/// pieces under the metric `h`, the nearest ones first.
pub(crate) fn nearest<const D: usize>(
    h: &SMatrix<f64, D, D>,
    sets: &[Shape<D>; 2],
) -> Vec<Nearest<D>> {
    let [first, second] = sets.each_ref().map(Shape::pieces);
    let pairs = first.iter().flat_map(|a| second.iter().map(move |b| of_pieces(h, a, b)));
    let mut pairs: Vec<_> = pairs.collect();
    pairs.sort_by(|a, b| a.distance.total_cmp(&b.distance));
    pairs
}

fn of_pieces<const D: usize>(h: &SMatrix<f64, D, D>, a: &Shape<D>, b: &Shape<D>) -> Nearest<D> {
    match (a, b) {
        (Shape::HalfSpace(wall), _) => {
            let Nearest { ends: [x, y], distance } = to_a_wall(h, b, wall);
            Nearest { ends: [y, x], distance }
        }
        (_, Shape::HalfSpace(wall)) => to_a_wall(h, a, wall),
        _ => between_bounded(h, a, b),
    }
}

/// From the lowest point of the piece, along `h⁻¹n`.
fn to_a_wall<const D: usize>(
    h: &SMatrix<f64, D, D>,
    piece: &Shape<D>,
    wall: &HalfSpace<D>,
) -> Nearest<D> {
    let n = wall.normal();
    let x = farthest(piece, &-n);
    let along = h.try_inverse().expect("definite") * n;
    let height = n.dot(&x) - wall.offset();
    let y = x - along * (height / n.dot(&along));
    Nearest { ends: [x, y], distance: height / n.dot(&along).sqrt() }
}

/// Projected gradients, and a hyperplane between the pieces that proves the result.
fn between_bounded<const D: usize>(
    h: &SMatrix<f64, D, D>,
    a: &Shape<D>,
    b: &Shape<D>,
) -> Nearest<D> {
    let inverse = h.try_inverse().expect("definite");
    // A step of 1/(2 trace) is short enough for the form of both ends.
    let step = 0.5 / h.trace();
    let (mut x, mut y) = (project(a, &SVector::zeros()), project(b, &SVector::zeros()));
    for _ in 0..100_000 {
        let p = h * (y - x);
        let distance = (y - x).dot(&p).sqrt();
        // With |p|* = distance: the distance of the two planes with the normal p.
        let between = p.dot(&farthest(b, &-p)) - p.dot(&farthest(a, &p));
        let lower = between / p.dot(&(inverse * p)).sqrt();
        if distance - lower <= 1e-12 * distance {
            return Nearest { ends: [x, y], distance };
        }
        (x, y) = (project(a, &(x + p * step)), project(b, &(y - p * step)));
    }
    panic!("no convergence: {h} {a:?} {b:?}");
}

fn project<const D: usize>(piece: &Shape<D>, x: &SVector<f64, D>) -> SVector<f64, D> {
    match piece {
        Shape::Point(point) => point.project(x),
        Shape::Ball(ball) => ball.project(x),
        Shape::AxisBox(side) => side.project(x),
        Shape::HalfSpace(wall) => wall.project(x),
        other => panic!("{} is no piece", other.name()),
    }
}

/// Returns the point of a bounded piece that is farthest in this direction.
fn farthest<const D: usize>(piece: &Shape<D>, direction: &SVector<f64, D>) -> SVector<f64, D> {
    match piece {
        Shape::Point(point) => *point.position(),
        Shape::Ball(ball) => ball.centre() + direction.normalize() * ball.r(),
        Shape::AxisBox(side) => {
            SVector::from_fn(
                |i, _| {
                    if direction[i] > 0.0 { side.upper()[i] } else { side.lower()[i] }
                },
            )
        }
        other => panic!("{} is no bounded piece", other.name()),
    }
}

/// Returns the formula of a constant metric.
pub(crate) fn formula<const D: usize>(h: &SMatrix<f64, D, D>) -> Formula<D> {
    Formula::record(&Constant::new(*h).expect("definite")).expect("no branches")
}

/// Returns a matrix with a condition number up to 10 and entries beside the diagonal.
pub(crate) fn full_matrix<const D: usize>(random: &mut Random) -> SMatrix<f64, D, D> {
    let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-1.0, 1.0));
    let square = a.transpose() * a;
    // The eigenvalues are between trace/9 and trace (1 + 1/9).
    let h = square + SMatrix::identity() * (square.trace() / 9.0);
    h / h.trace() * D as f64
}

pub(crate) fn point<const D: usize>(x: impl Into<SVector<f64, D>>) -> Shape<D> {
    Shape::Point(Point::new(x).expect("finite"))
}

pub(crate) fn ball<const D: usize>(centre: impl Into<SVector<f64, D>>, r: f64) -> Shape<D> {
    Shape::Ball(Ball::new(centre, r).expect("a ball"))
}

/// Returns the box around a centre.
pub(crate) fn around<const D: usize>(
    centre: impl Into<SVector<f64, D>>,
    half: impl Into<SVector<f64, D>>,
) -> Shape<D> {
    let (centre, half) = (centre.into(), half.into());
    Shape::AxisBox(AxisBox::from_corners(centre - half, centre + half).expect("corners in order"))
}

/// Returns `{n·x ≥ b}`.
pub(crate) fn at_least<const D: usize>(normal: impl Into<SVector<f64, D>>, b: f64) -> Shape<D> {
    Shape::HalfSpace(HalfSpace::at_least(normal, b).expect("a normal"))
}
