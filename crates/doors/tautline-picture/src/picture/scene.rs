//! A finished drawing: shapes in px, in the order in which they are painted.

use crate::{
    colours::Colour,
    error::DrawingError,
    geometry::{Extent, Path},
    math_text::TextBlock,
};

/// A finished drawing, which can be written as SVG, PNG or PDF.
///
/// Units are px, with `y` pointing downwards. Nothing is snapped to a grid.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Scene {
    /// The width of the canvas.
    pub width: f64,
    /// The height of the canvas.
    pub height: f64,
    /// What the picture shows, in words.
    pub title: String,
    shapes: Vec<Shape>,
}

/// An outline and its paint.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Shape {
    /// The outline, which is filled by the nonzero rule.
    pub path: Path,
    /// The colour of the inside.
    pub fill: Option<Paint>,
    /// The line along the outline.
    pub stroke: Option<Stroke>,
    /// The box outside which the shape is invisible.
    pub clip: Option<Extent>,
    /// The text and the measured box, if the shape is a label.
    pub label: Option<(String, Extent)>,
}

/// A colour with opacity.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Paint {
    /// The colour.
    pub colour: Colour,
    /// The opacity, from 0 (invisible) to 1.
    pub opacity: f64,
}

/// A line with butt ends and round joins.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Stroke {
    /// Its paint.
    pub paint: Paint,
    /// Its width, in px.
    pub width: f64,
    /// The lengths of dashes and gaps, alternately, in px; empty for a solid line.
    pub dash: Vec<f64>,
}

impl From<Colour> for Paint {
    fn from(colour: Colour) -> Paint {
        Paint { colour, opacity: 1.0 }
    }
}

impl Stroke {
    /// Returns a solid, opaque line.
    pub fn solid(colour: Colour, width: f64) -> Stroke {
        Stroke { paint: colour.into(), width, dash: Vec::new() }
    }
}

impl Shape {
    /// Returns a filled outline.
    pub fn filled(path: Path, paint: impl Into<Paint>) -> Shape {
        Shape { path, fill: Some(paint.into()), stroke: None, clip: None, label: None }
    }

    /// Returns a line along an outline.
    pub fn stroked(path: Path, stroke: Stroke) -> Shape {
        Shape { path, fill: None, stroke: Some(stroke), clip: None, label: None }
    }
}

impl Scene {
    /// Returns a white canvas.
    pub fn new(width: f64, height: f64, title: impl Into<String>) -> Scene {
        let mut scene = Scene { width, height, title: title.into(), shapes: Vec::new() };
        scene.push(Shape::filled(Path::rectangle(scene.canvas()), Colour::WHITE));
        scene
    }

    /// Returns the shapes in painting order.
    pub fn shapes(&self) -> &[Shape] {
        &self.shapes
    }

    /// Paints a shape over all others.
    pub fn push(&mut self, shape: Shape) {
        self.shapes.push(shape);
    }

    /// Writes a label with its origin at `(x, y)`.
    pub fn write(&mut self, text: &TextBlock, (x, y): (f64, f64), colour: Colour) {
        let Extent { left, top, right, bottom } = text.extent;
        let place = Extent { left: left + x, top: top + y, right: right + x, bottom: bottom + y };
        let mut shape = Shape::filled(text.path.moved(x, y), colour);
        shape.label = Some((text.spoken.clone(), place));
        self.push(shape);
    }

    /// Writes a label with a white rim, so that it is legible over curves and colours.
    pub fn write_with_halo(&mut self, text: &TextBlock, at: (f64, f64), colour: Colour) {
        let mut stroke = Stroke::solid(Colour::WHITE, 4.0);
        stroke.paint.opacity = 0.85;
        self.push(Shape::stroked(text.path.moved(at.0, at.1), stroke));
        self.write(text, at, colour);
    }

    /// Checks that every label lies on the canvas and that no two overlap.
    ///
    /// # Errors
    ///
    /// Names the first label that is cut off, or the first two labels that overlap.
    pub fn check_labels(&self) -> Result<(), DrawingError> {
        let labels: Vec<_> = self.shapes.iter().filter_map(|shape| shape.label.as_ref()).collect();
        for (k, (label, place)) in labels.iter().enumerate() {
            if !self.canvas().contains(place) {
                return Err(DrawingError::Cut { label: label.clone() });
            }
            if let Some((first, _)) = labels[..k].iter().find(|(_, other)| place.overlaps(other)) {
                let (first, second) = (first.clone(), label.clone());
                return Err(DrawingError::Overlap { first, second });
            }
        }
        Ok(())
    }

    /// Checks that no curve runs through a label.
    ///
    /// Curves are the lines inside a panel that are at least 1 px wide. A grid line or a contour
    /// line may pass behind a label. Drawing a figure does not run this check, since a note with
    /// its white rim may lie on a curve.
    ///
    /// # Errors
    ///
    /// Names the first label that a curve crosses.
    pub fn check_crossings(&self) -> Result<(), DrawingError> {
        let is_curve = |shape: &&Shape| {
            shape.clip.is_some() && shape.stroke.as_ref().is_some_and(|stroke| stroke.width >= 1.0)
        };
        let lines: Vec<_> = self.shapes.iter().filter(is_curve).collect();
        for (label, place) in self.shapes.iter().filter_map(|shape| shape.label.as_ref()) {
            let crosses = |line: &&Shape| {
                let visible = line.clip.is_some_and(|clip| clip.overlaps(place));
                visible && line.path.chords().any(|(from, to)| place.meets(from, to))
            };
            if lines.iter().any(crosses) {
                return Err(DrawingError::Crossed { label: label.clone() });
            }
        }
        Ok(())
    }

    /// Returns the whole drawing surface.
    pub fn canvas(&self) -> Extent {
        Extent { left: 0.0, top: 0.0, right: self.width, bottom: self.height }
    }
}

#[cfg(test)]
mod tests {
    use super::{Colour, DrawingError, Extent, Path, Scene, Shape, Stroke};
    use crate::math_text::{Align, typeset};

    #[test]
    fn overlapping_and_cut_labels_are_found() {
        let text = typeset("label", 10.0, Align::Left).expect("ASCII");
        let mut scene = Scene::new(100.0, 50.0, "test");
        scene.write(&text, (10.0, 20.0), Colour::new(0, 0, 0));
        scene.write(&text, (10.0, 40.0), Colour::new(0, 0, 0));
        assert_eq!(scene.check_labels(), Ok(()));
        let mut crowded = scene.clone();
        crowded.write(&text, (15.0, 22.0), Colour::new(0, 0, 0));
        assert!(matches!(crowded.check_labels(), Err(DrawingError::Overlap { .. })));
        scene.write(&text, (90.0, 20.0), Colour::new(0, 0, 0));
        assert!(matches!(scene.check_labels(), Err(DrawingError::Cut { .. })));
    }

    #[test]
    fn a_curve_through_a_label_is_found() {
        let text = typeset("label", 10.0, Align::Left).expect("ASCII");
        let mut scene = Scene::new(100.0, 50.0, "test");
        scene.write(&text, (30.0, 25.0), Colour::new(0, 0, 0));
        let curve = |from: (f64, f64), to: (f64, f64)| {
            let stroke = Stroke::solid(Colour::new(0, 0, 0), 1.5);
            let mut shape = Shape::stroked(Path::polyline([from, to], false), stroke);
            shape.clip = Some(Extent { left: 0.0, top: 0.0, right: 100.0, bottom: 50.0 });
            shape
        };
        scene.push(curve((0.0, 0.0), (100.0, 5.0)));
        scene.push(curve((0.0, 50.0), (20.0, 0.0)));
        assert_eq!(scene.check_crossings(), Ok(()));
        scene.push(curve((0.0, 50.0), (100.0, 0.0)));
        assert!(matches!(scene.check_crossings(), Err(DrawingError::Crossed { .. })));
    }
}
