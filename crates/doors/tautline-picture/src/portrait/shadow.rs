//! What is seen of a set: its projection to the plane of two coordinates, and its intervals on the line.

use std::f64::consts::{PI, TAU};

use tautline_scalar::ANY;
use tautline_sets::Shape;

use super::span::Span;
use crate::clip;

/// A point of the plane, in the units of the data.
pub(crate) type Point = (f64, f64);

/// The projection of a set to the plane, inside a box that contains the window.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Shadow {
    /// The inside of a polygon; empty if the set is outside of the window.
    Area(Vec<Point>),
    /// Polylines.
    Lines(Vec<Vec<Point>>),
    /// Points.
    Points(Vec<Point>),
    /// The whole plane.
    Everything,
}

/// The part of the plane near the window.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Frame {
    pub(crate) plane: [usize; 2],
    x: (f64, f64),
    y: (f64, f64),
}

/// Beyond this many diagonals of the window, a circle is straight: across the window it bends by an
/// eighth of a thousandth.
const STRAIGHT: f64 = 1000.0;
/// A direction whose drawn part is a smaller share of it does not appear in the plane.
const NEGLIGIBLE: f64 = 1e-9;

impl Frame {
    pub(crate) fn new(plane: [usize; 2], [x, y]: [Span; 2]) -> Frame {
        // Outlines along the edge of this box are not visible.
        Frame { plane, x: x.wider(0.2), y: y.wider(0.2) }
    }

    fn corners(&self) -> [Point; 4] {
        let ((left, right), (bottom, top)) = (self.x, self.y);
        [(left, bottom), (right, bottom), (right, top), (left, top)]
    }

    fn centre(&self) -> Point {
        (f64::midpoint(self.x.0, self.x.1), f64::midpoint(self.y.0, self.y.1))
    }

    fn diagonal(&self) -> f64 {
        (self.x.1 - self.x.0).hypot(self.y.1 - self.y.0)
    }

    /// Returns the drawn coordinates of a point.
    fn seen(&self, point: &[f64]) -> Point {
        (point[self.plane[0]], point[self.plane[1]])
    }

    /// Returns the pieces of a polyline near the window.
    pub(crate) fn pieces(&self, points: &[Point]) -> Vec<Vec<Point>> {
        clip::polyline(points, self.x, self.y)
    }

    /// Returns what is seen of a piece of a set; nothing for a union, whose pieces are seen one by one.
    pub(crate) fn shadow(&self, piece: &Shape<ANY>) -> Shadow {
        match piece {
            Shape::Point(point) => Shadow::Points(vec![self.seen(point.position_slice())]),
            Shape::FiniteSet(set) => {
                let points = set.points().iter();
                Shadow::Points(points.map(|point| self.seen(point.position_slice())).collect())
            }
            Shape::Ball(ball) => self.disc(self.seen(ball.centre_slice()), ball.r()),
            Shape::Sphere(sphere) => {
                let (centre, r) = (sphere.centre_slice(), sphere.r());
                if centre.len() > 2 {
                    self.disc(self.seen(centre), r)
                } else {
                    self.circle(self.seen(centre), r)
                }
            }
            Shape::AxisBox(side) => self.rectangle(side.corner_slices()),
            Shape::HalfSpace(wall) => self.half_plane(wall.given_slice()),
            Shape::Segment(segment) => match segment.end_slices().map(|end| self.seen(end)) {
                [from, to] if from == to => Shadow::Points(vec![from]),
                ends => Shadow::Lines(self.pieces(&ends)),
            },
            Shape::AffineSubspace(subspace) => {
                self.affine(subspace.base_slice(), subspace.given_slices())
            }
            Shape::Union(_) => Shadow::Points(Vec::new()),
        }
    }

    fn rectangle(&self, corners: [&[f64]; 2]) -> Shadow {
        let [(left, bottom), (right, top)] = corners.map(|corner| self.seen(corner));
        if left == right && bottom == top {
            return Shadow::Points(vec![(left, bottom)]);
        }
        let side = |from: f64, to: f64, (low, high): (f64, f64)| {
            (from.max(low.min(to)), to.min(high.max(from)))
        };
        let ((left, right), (bottom, top)) = (side(left, right, self.x), side(bottom, top, self.y));
        if left == right || bottom == top {
            return Shadow::Lines(self.pieces(&[(left, bottom), (right, top)]));
        }
        let ring = [(left, bottom), (right, bottom), (right, top), (left, top)];
        Shadow::Area(clip::to_box(&ring, self.x, self.y))
    }

    fn half_plane(&self, (normal, offset): (&[f64], f64)) -> Shadow {
        let largest = normal.iter().fold(0.0_f64, |most, n| most.max(n.abs()));
        let hidden =
            |(k, n): (usize, &f64)| !self.plane.contains(&k) && n.abs() > NEGLIGIBLE * largest;
        if normal.iter().enumerate().any(hidden) {
            return Shadow::Everything;
        }
        let (a, b) = self.seen(normal);
        let normal = (a / largest, b / largest);
        Shadow::Area(clip::by_half_plane(&self.corners(), normal, offset / largest))
    }

    fn disc(&self, centre: Point, radius: f64) -> Shadow {
        if radius == 0.0 {
            return Shadow::Points(vec![centre]);
        }
        match self.straight(centre, radius) {
            Some((normal, offset)) => {
                Shadow::Area(clip::by_half_plane(&self.corners(), normal, offset))
            }
            None => Shadow::Area(clip::to_box(&self.ring(centre, radius), self.x, self.y)),
        }
    }

    fn circle(&self, centre: Point, radius: f64) -> Shadow {
        if radius == 0.0 {
            return Shadow::Points(vec![centre]);
        }
        match self.straight(centre, radius) {
            Some(((a, b), offset)) => {
                // The point of the line that is nearest to the middle of the window.
                let (x, y) = self.centre();
                let beyond = offset - a * x - b * y;
                let (foot, far) = ((x + beyond * a, y + beyond * b), self.diagonal());
                let ends =
                    [(foot.0 - far * b, foot.1 + far * a), (foot.0 + far * b, foot.1 - far * a)];
                Shadow::Lines(self.pieces(&ends))
            }
            None => {
                let mut ring = self.ring(centre, radius);
                ring.extend(ring.first().copied());
                Shadow::Lines(self.pieces(&ring))
            }
        }
    }

    /// Returns the half-plane `normal·x ≤ offset` that a very large ball is near the window.
    fn straight(&self, (x, y): Point, radius: f64) -> Option<(Point, f64)> {
        if radius <= STRAIGHT * self.diagonal() {
            return None;
        }
        let (cx, cy) = self.centre();
        // A centre in the window has no direction; then the ball covers everything.
        let away = (cx - x).hypot(cy - y);
        let normal = if away > 0.0 { ((cx - x) / away, (cy - y) / away) } else { (1.0, 0.0) };
        // Counted from the middle of the window, since the radius may be much larger.
        Some((normal, normal.0 * cx + normal.1 * cy + (radius - away)))
    }

    fn ring(&self, (x, y): Point, radius: f64) -> Vec<Point> {
        // A side deviates from the circle by a ten-thousandth of the diagonal at most.
        let sides = PI * (radius / (2e-4 * self.diagonal())).sqrt();
        let sides = sides.ceil().clamp(96.0, 10_000.0) as usize;
        let corner = |k: usize| {
            let (sin, cos) = (TAU * k as f64 / sides as f64).sin_cos();
            (x + radius * cos, y + radius * sin)
        };
        (0..sides).map(corner).collect()
    }

    fn affine(&self, point: &[f64], directions: &[Box<[f64]>]) -> Shadow {
        let (x, y) = self.seen(point);
        let mut along: Option<Point> = None;
        for direction in directions {
            let largest = direction.iter().fold(0.0_f64, |most, d| most.max(d.abs()));
            if largest == 0.0 {
                continue;
            }
            let (a, b) = self.seen(direction);
            let (a, b) = (a / largest, b / largest);
            let length = a.hypot(b);
            if length <= NEGLIGIBLE {
                continue;
            }
            let unit = (a / length, b / length);
            match along {
                None => along = Some(unit),
                Some(first) if (first.0 * unit.1 - first.1 * unit.0).abs() > NEGLIGIBLE => {
                    return Shadow::Everything;
                }
                Some(_) => {}
            }
        }
        let Some((a, b)) = along else { return Shadow::Points(vec![(x, y)]) };
        let (cx, cy) = self.centre();
        let ahead = (cx - x) * a + (cy - y) * b;
        let (foot, far) = ((x + ahead * a, y + ahead * b), self.diagonal());
        let ends = [(foot.0 - far * a, foot.1 - far * b), (foot.0 + far * a, foot.1 + far * b)];
        Shadow::Lines(self.pieces(&ends))
    }
}

/// Returns the intervals of a set on the line; a point is an interval of length 0.
pub(super) fn intervals(shape: &Shape<ANY>) -> Vec<[f64; 2]> {
    match shape {
        Shape::Point(point) => vec![[point.position_slice()[0]; 2]],
        Shape::FiniteSet(set) => {
            set.points().iter().map(|point| [point.position_slice()[0]; 2]).collect()
        }
        Shape::Ball(ball) => {
            let (centre, r) = (ball.centre_slice()[0], ball.r());
            vec![[centre - r, centre + r]]
        }
        Shape::Sphere(sphere) => {
            let (centre, r) = (sphere.centre_slice()[0], sphere.r());
            vec![[centre - r; 2], [centre + r; 2]]
        }
        Shape::AxisBox(side) => vec![side.corner_slices().map(|corner| corner[0])],
        Shape::HalfSpace(wall) => {
            let (normal, offset) = wall.given_slice();
            let at = offset / normal[0];
            vec![if normal[0] > 0.0 { [f64::NEG_INFINITY, at] } else { [at, f64::INFINITY] }]
        }
        Shape::Segment(segment) => {
            let [from, to] = segment.end_slices().map(|end| end[0]);
            vec![[from.min(to), from.max(to)]]
        }
        Shape::AffineSubspace(subspace) if subspace.given_slices().is_empty() => {
            vec![[subspace.base_slice()[0]; 2]]
        }
        Shape::AffineSubspace(_) => vec![[f64::NEG_INFINITY, f64::INFINITY]],
        Shape::Union(shapes) => shapes.iter().flat_map(intervals).collect(),
    }
}
