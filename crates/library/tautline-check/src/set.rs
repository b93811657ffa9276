//! The two sets: distances, membership, and values of a quadratic polynomial on a set.

use nalgebra::SVector;
use tautline_scalar::{Interval, Scalar};
use tautline_sets::Shape;

use crate::{kuhn::Simplex, quadratic::Bernstein};

/// Returns a lower bound on the distance between a set and a box, in `ℓ`.
pub(crate) fn distance_below<const D: usize>(set: &Shape<D>, x: &SVector<Interval, D>) -> f64 {
    let zero = Interval::point(0.0);
    let positive = |t: Interval| Interval::new(t.lo().max(0.0), t.hi().max(0.0)).unwrap_or(zero);
    let to = |centre: &SVector<f64, D>| norm(&x.zip_map(centre, |x, c| x - c));
    let distance = match set {
        Shape::Point(point) => to(point.position()),
        Shape::Ball(ball) => positive(to(ball.centre()) - ball.r()),
        Shape::AxisBox(side) => norm(&SVector::<_, D>::from_fn(|i, _| {
            let below = positive(Interval::point(side.lower()[i]) - x[i]);
            let above = positive(x[i] - side.upper()[i]);
            below + above
        })),
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given();
            positive(dot(normal, x) - offset) / norm(&normal.map(Interval::point))
        }
        Shape::Union(shapes) => {
            let distances = shapes.iter().map(|shape| distance_below(shape, x));
            return distances.fold(f64::INFINITY, f64::min);
        }
        // No certificate with another set is accepted.
        _ => return 0.0,
    };
    distance.lo().max(0.0)
}

/// Returns the smallest box that contains a set, rounded outward; `None` if the set is unbounded.
pub(crate) fn bounding_box<const D: usize>(set: &Shape<D>) -> Option<SVector<Interval, D>> {
    match set {
        Shape::Point(point) => Some(point.position().map(Interval::point)),
        Shape::Ball(ball) => {
            let side = Interval::new(-ball.r(), ball.r()).ok()?;
            Some(ball.centre().map(|c| side + c))
        }
        Shape::AxisBox(side) => Some(side.lower().zip_map(side.upper(), |lower, upper| {
            Interval::point(lower).hull(Interval::point(upper))
        })),
        Shape::Union(shapes) => {
            let boxes: Option<Vec<_>> = shapes.iter().map(bounding_box).collect();
            boxes?.into_iter().reduce(|a, b| a.zip_map(&b, Interval::hull))
        }
        _ => None,
    }
}

/// One convex piece of a set, ready to meet simplices.
#[derive(Clone, Debug)]
pub(crate) enum Piece<const D: usize> {
    /// A point.
    Point(SVector<Interval, D>),
    /// The points where all functions are at most zero.
    Region(Vec<Constraint<D>>),
}

/// The function `α|x − c|² + n·x − β`, with `α` 0 or 1.
#[derive(Clone, Debug)]
pub(crate) struct Constraint<const D: usize> {
    centre: Option<SVector<Interval, D>>,
    normal: SVector<f64, D>,
    offset: Interval,
}

fn constraints<const D: usize>(piece: &Shape<D>) -> Vec<Constraint<D>> {
    match piece {
        Shape::Ball(ball) => vec![Constraint {
            centre: Some(ball.centre().map(Interval::point)),
            normal: SVector::zeros(),
            offset: Interval::point(ball.r()).sqr(),
        }],
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given();
            vec![Constraint { centre: None, normal: *normal, offset: Interval::point(offset) }]
        }
        Shape::AxisBox(side) => (0..D)
            .flat_map(|i| [(i, 1.0, side.upper()[i]), (i, -1.0, -side.lower()[i])])
            .map(|(i, sign, offset)| {
                let normal = SVector::from_fn(|j, _| if i == j { sign } else { 0.0 });
                Constraint { centre: None, normal, offset: Interval::point(offset) }
            })
            .collect(),
        _ => Vec::new(),
    }
}

impl<const D: usize> Constraint<D> {
    /// Returns the coefficient of the Bernstein form for the vertices `x` and `y`.
    fn polar(&self, x: &SVector<Interval, D>, y: &SVector<Interval, D>) -> Interval {
        let linear = (dot(&self.normal, x) + dot(&self.normal, y)) * 0.5 - self.offset;
        match &self.centre {
            None => linear,
            Some(c) => {
                let products = (0..D).map(|i| {
                    if x == y { (x[i] - c[i]).sqr() } else { (x[i] - c[i]) * (y[i] - c[i]) }
                });
                linear + products.fold(Interval::point(0.0), |sum, product| sum + product)
            }
        }
    }
}

/// A cube with one of its simplices, where a set may meet it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Spot<'s, const D: usize> {
    pub(crate) simplex: &'s Simplex,
    /// The low corner of the cube.
    pub(crate) low: &'s SVector<f64, D>,
    /// The side of the cube, a power of two.
    pub(crate) side: f64,
}

impl<const D: usize> Spot<'_, D> {
    fn vertex(&self, i: usize) -> SVector<Interval, D> {
        let corner = self.simplex.corners[i];
        SVector::from_fn(|axis, _| {
            let step = if corner >> axis & 1 == 1 { self.side } else { 0.0 };
            Interval::point(self.low[axis] + step)
        })
    }
}

impl<const D: usize> Piece<D> {
    /// Returns the pieces of a set.
    pub(crate) fn of(set: &Shape<D>) -> Vec<Self> {
        set.pieces()
            .into_iter()
            .map(|piece| match piece {
                Shape::Point(point) => Piece::Point(point.position().map(Interval::point)),
                Shape::Ball(ball) if ball.r() == 0.0 => {
                    Piece::Point(ball.centre().map(Interval::point))
                }
                piece => Piece::Region(constraints(piece)),
            })
            .collect()
    }

    /// Returns, for each polynomial, an interval that contains its values on the part of the piece
    /// in the simplex; `None` if the piece does not meet the simplex.
    pub(crate) fn values<const N: usize>(
        &self,
        spot: Spot<'_, D>,
        polynomials: [&Bernstein<D>; N],
    ) -> Option<[Interval; N]> {
        match self {
            Piece::Point(x) => {
                let barycentric = barycentric(spot, x)?;
                Some(polynomials.map(|polynomial| {
                    let range = polynomial.range();
                    let value = range.intersection(polynomial.at(&barycentric));
                    value.filter(|value| !value.is_undefined()).unwrap_or(range)
                }))
            }
            Piece::Region(constraints) => {
                let vertices: Vec<_> = (0..=D).map(|i| spot.vertex(i)).collect();
                let forms: Vec<Bernstein<D>> = constraints
                    .iter()
                    .map(|b| Bernstein::new(|i, j| b.polar(&vertices[i], &vertices[j])))
                    .collect();
                if forms.iter().any(|b| b.range().lo() > 0.0) {
                    return None;
                }
                let bounds = polynomials.map(|polynomial| {
                    let least = least_on(polynomial, &forms);
                    (least, -least_on(&polynomial.times(-1.0), &forms))
                });
                // Bounds that cross prove that the piece has no point here.
                if bounds.iter().any(|(least, most)| least > most) {
                    return None;
                }
                let whole = Interval::REALS;
                Some(bounds.map(|(least, most)| Interval::new(least, most).unwrap_or(whole)))
            }
        }
    }

    /// Returns whether the facet without the vertex `k` is proved to lie in the piece.
    pub(crate) fn holds_facet(&self, spot: Spot<'_, D>, k: usize) -> bool {
        let Piece::Region(constraints) = self else { return false };
        let vertices: Vec<_> = (0..=D).map(|i| spot.vertex(i)).collect();
        constraints.iter().all(|b| {
            let form = Bernstein::<D>::new(|i, j| b.polar(&vertices[i], &vertices[j]));
            form.range_opposite(k).hi() <= 0.0
        })
    }
}

/// Returns a lower bound on a polynomial on the part of a simplex where all `b ≤ 0`.
///
/// There `φ ≥ φ + Σ μ b` for all `μ ≥ 0`. Any such `μ` gives a bound; these make the gradient of the
/// sum small, one constraint after the other.
fn least_on<const D: usize>(polynomial: &Bernstein<D>, forms: &[Bernstein<D>]) -> f64 {
    let mut sum = *polynomial;
    for form in forms.iter().filter(|form| !(form.range().hi() < 0.0)) {
        let (slopes, directions) = (sum.slopes(), form.slopes());
        let product = |a: &[f64], b: &[f64]| -> f64 { a.iter().zip(b).map(|(a, b)| a * b).sum() };
        let factor = -product(&slopes, &directions) / product(&directions, &directions);
        if factor > 0.0 && factor.is_finite() {
            sum = sum.plus(&form.times(factor));
        }
    }
    polynomial.range().lo().max(sum.range().lo())
}

/// Returns the barycentric coordinates of a point, within `[0, 1]`; `None` if the point is not in
/// the simplex.
fn barycentric<const D: usize>(
    spot: Spot<'_, D>,
    x: &SVector<Interval, D>,
) -> Option<Vec<Interval>> {
    // Dividing by a power of two does not round.
    let inside = |axis: usize| (x[axis] - spot.low[axis]) / spot.side;
    let unit = Interval::new(0.0, 1.0).ok()?;
    let one = Interval::point(1.0);
    let heights: Vec<Interval> = spot.simplex.axes.iter().map(|&axis| inside(axis)).collect();
    (0..=D)
        .map(|m| {
            let above = if m == 0 { one } else { heights[m - 1] };
            let below = if m == D { Interval::point(0.0) } else { heights[m] };
            (above - below).intersection(unit)
        })
        .collect()
}

fn dot<const D: usize>(n: &SVector<f64, D>, x: &SVector<Interval, D>) -> Interval {
    n.iter().zip(x).fold(Interval::point(0.0), |sum, (&n, &x)| sum + x * n)
}

fn norm<const D: usize>(x: &SVector<Interval, D>) -> Interval {
    x.iter().fold(Interval::point(0.0), |sum, &x| sum + x.sqr()).sqrt()
}

#[cfg(test)]
mod tests;
