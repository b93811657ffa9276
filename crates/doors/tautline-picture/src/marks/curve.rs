//! A curve or a set of points, with its style and its name.

use super::marker::Marker;
use crate::{axes::Axis, colours::Colour, measures::CURVE};

/// A curve of a panel.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Curve {
    pub(crate) course: Course,
    pub(crate) colour: Colour,
    /// The width of the line; zero draws no line.
    pub(crate) width: f64,
    pub(crate) dash: Vec<f64>,
    pub(crate) marker: Option<Marker>,
    pub(crate) label: String,
    pub(crate) halo: bool,
}

/// The points of a curve.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Course {
    Through(Vec<(f64, f64)>),
    Level(f64),
}

impl Curve {
    /// Returns the polyline through `points`, drawn as a solid line without markers.
    ///
    /// A point that its axes cannot show (not finite, or not positive on a logarithmic scale)
    /// interrupts the line.
    pub fn new(points: impl IntoIterator<Item = (f64, f64)>, colour: Colour) -> Curve {
        Curve {
            course: Course::Through(points.into_iter().collect()),
            colour,
            width: CURVE,
            dash: Vec::new(),
            marker: None,
            label: String::new(),
            halo: false,
        }
    }

    /// Returns a thin, dashed, horizontal reference line at `y` across the whole `x` axis.
    pub fn level(y: f64, colour: Colour) -> Curve {
        let empty = Curve::new([], colour);
        Curve { course: Course::Level(y), width: 1.1, dash: vec![5.0, 3.5], ..empty }
    }

    /// Draws a marker, if there is one, at every point.
    pub fn marked(mut self, marker: impl Into<Option<Marker>>) -> Curve {
        self.marker = marker.into();
        self
    }

    /// Draws only the markers.
    pub fn without_line(mut self) -> Curve {
        self.width = 0.0;
        self
    }

    /// Sets the lengths of dashes and gaps, in px; an empty list gives a solid line.
    pub fn dashed(mut self, dash: &[f64]) -> Curve {
        self.dash = dash.to_vec();
        self
    }

    /// Sets the width of the line, in px.
    pub fn wide(mut self, width: f64) -> Curve {
        self.width = width;
        self
    }

    /// Names the curve, at its right end or in the key if the figure has one.
    ///
    /// The syntax is that of [`typeset`](crate::math_text::typeset).
    pub fn labelled(mut self, label: impl Into<String>) -> Curve {
        self.label = label.into();
        self
    }

    /// Draws a white rim around the line and the markers, so that they stand out from a heat-map.
    pub fn over_field(mut self) -> Curve {
        self.halo = true;
        self
    }

    /// Returns the runs of consecutive points that the axes can show.
    pub(crate) fn runs(&self, x: &Axis, y: &Axis) -> Vec<Vec<(f64, f64)>> {
        let across = |level: f64| vec![(x.from(), level), (x.to(), level)];
        let points = match &self.course {
            Course::Through(points) => points.clone(),
            Course::Level(level) => across(*level),
        };
        let (x, y) = (&x.stretches[0], &y.stretches[0]);
        points
            .split(|(a, b)| !(x.can_place(*a) && y.can_place(*b)))
            .filter(|run| !run.is_empty())
            .map(<[_]>::to_vec)
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::{Axis, Curve};
    use crate::{axes::Scale, colours::palette::BLUE};

    #[test]
    fn points_without_a_place_interrupt_the_line() {
        let x = Axis::new(Scale::Linear, 0.0, 9.0).expect("a range");
        let y = Axis::new(Scale::Decades, 1.0, 10.0).expect("a range");
        let points = [(0.0, 1.0), (1.0, 2.0), (2.0, 0.0), (3.0, f64::NAN), (4.0, 5.0)];
        let runs = Curve::new(points, BLUE).runs(&x, &y);
        assert_eq!(runs, [vec![(0.0, 1.0), (1.0, 2.0)], vec![(4.0, 5.0)]]);
        assert_eq!(Curve::level(3.0, BLUE).runs(&x, &y), [[(0.0, 3.0), (9.0, 3.0)]]);
    }
}
