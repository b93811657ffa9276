//! An outline of lines and cubic curves.

use super::extent::Extent;

/// One step of a [`Path`], in px, with `y` downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Segment {
    /// Starts a contour.
    Move(f64, f64),
    /// Draws a straight line.
    Line(f64, f64),
    /// Draws a cubic Bézier curve, given its two control points and its end.
    Cubic([f64; 6]),
    /// Returns to the start of the contour.
    Close,
}

/// A sequence of contours.
#[derive(Clone, Debug, Default, PartialEq)]
#[must_use]
pub struct Path {
    segments: Vec<Segment>,
}

impl Path {
    /// Returns the polyline through `points`, closed or open.
    pub fn polyline(points: impl IntoIterator<Item = (f64, f64)>, closed: bool) -> Path {
        let mut path = Path::default();
        for (x, y) in points {
            let first = path.segments.is_empty();
            path.push(if first { Segment::Move(x, y) } else { Segment::Line(x, y) });
        }
        if closed && !path.segments.is_empty() {
            path.push(Segment::Close);
        }
        path
    }

    /// Returns the outline of a rectangle.
    pub fn rectangle(of: Extent) -> Path {
        let Extent { left, top, right, bottom } = of;
        Path::polyline([(left, top), (right, top), (right, bottom), (left, bottom)], true)
    }

    /// Returns a circle made of four cubic arcs.
    pub fn circle((x, y): (f64, f64), radius: f64) -> Path {
        // The value is 4/3 tan(π/8). The arcs deviate from the circle by less than 0.03 % of the
        // radius.
        let k = 0.552_284_75 * radius;
        let r = radius;
        let mut path = Path::default();
        path.push(Segment::Move(x + r, y));
        path.push(Segment::Cubic([x + r, y + k, x + k, y + r, x, y + r]));
        path.push(Segment::Cubic([x - k, y + r, x - r, y + k, x - r, y]));
        path.push(Segment::Cubic([x - r, y - k, x - k, y - r, x, y - r]));
        path.push(Segment::Cubic([x + k, y - r, x + r, y - k, x + r, y]));
        path.push(Segment::Close);
        path
    }

    /// Appends one step.
    pub fn push(&mut self, segment: Segment) {
        self.segments.push(segment);
    }

    /// Appends all contours of another path.
    pub fn append(&mut self, other: &Path) {
        self.segments.extend_from_slice(&other.segments);
    }

    /// Returns the steps in order.
    #[must_use]
    pub fn segments(&self) -> &[Segment] {
        &self.segments
    }

    /// Returns the image under a map, which must be affine: Bézier curves commute with no other
    /// maps.
    pub fn mapped(&self, map: impl Fn(f64, f64) -> (f64, f64)) -> Path {
        let segments = self.segments.iter().map(|segment| match *segment {
            Segment::Move(x, y) => {
                let (x, y) = map(x, y);
                Segment::Move(x, y)
            }
            Segment::Line(x, y) => {
                let (x, y) = map(x, y);
                Segment::Line(x, y)
            }
            Segment::Cubic([a, b, c, d, e, f]) => {
                let ((a, b), (c, d), (e, f)) = (map(a, b), map(c, d), map(e, f));
                Segment::Cubic([a, b, c, d, e, f])
            }
            Segment::Close => Segment::Close,
        });
        Path { segments: segments.collect() }
    }

    /// Returns the path moved by `(dx, dy)`.
    pub fn moved(&self, dx: f64, dy: f64) -> Path {
        self.mapped(|x, y| (x + dx, y + dy))
    }

    /// Returns the straight pieces, where a curve is replaced by its chord.
    pub(crate) fn chords(&self) -> impl Iterator<Item = ((f64, f64), (f64, f64))> {
        let end = |segment: &Segment| match *segment {
            Segment::Move(x, y) | Segment::Line(x, y) | Segment::Cubic([_, _, _, _, x, y]) => {
                Some((x, y))
            }
            Segment::Close => None,
        };
        self.segments.windows(2).filter_map(move |pair| match pair[1] {
            Segment::Move(..) => None,
            _ => Some((end(&pair[0])?, end(&pair[1])?)),
        })
    }

    /// Returns the smallest box that contains all points and control points; `None` if there are
    /// none.
    ///
    /// For glyphs the box is exact, since their extrema are points of the outline.
    #[must_use]
    pub fn extent(&self) -> Option<Extent> {
        let mut points = Vec::new();
        for segment in &self.segments {
            match *segment {
                Segment::Move(x, y) | Segment::Line(x, y) => points.push((x, y)),
                Segment::Cubic([a, b, c, d, e, f]) => points.extend([(a, b), (c, d), (e, f)]),
                Segment::Close => {}
            }
        }
        let (&(x, y), rest) = points.split_first()?;
        let start = Extent { left: x, top: y, right: x, bottom: y };
        Some(rest.iter().fold(start, |e, &(x, y)| e.with(x, y)))
    }
}

#[cfg(test)]
mod tests {
    use super::{Extent, Path};

    #[test]
    fn a_circle_fills_its_box() {
        let extent = Path::circle((3.0, 4.0), 2.0).extent().expect("five segments");
        assert_eq!(extent, Extent { left: 1.0, top: 2.0, right: 5.0, bottom: 6.0 });
    }

    #[test]
    fn an_empty_path_has_no_box() {
        assert_eq!(Path::default().extent(), None);
    }
}
