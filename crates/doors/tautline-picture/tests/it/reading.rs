//! Reads a finished drawing: where the frame is, and which shapes have which paint.

use tautline_picture::{Colour, Extent, Scene, Segment, Shape as Drawn, palette};

/// A place on the canvas may be off by this, in px: the drawing rounds the frame to hundredths of a
/// px, and then rounds a place down to one.
pub(crate) const ROUNDING: f64 = 0.016;

/// A drawing, and the window that its frame shows.
pub(crate) struct Reading<'a> {
    scene: &'a Scene,
    window: [[f64; 2]; 2],
    frame: Extent,
}

impl<'a> Reading<'a> {
    /// Finds the frame: it is the clip of everything inside it.
    pub(crate) fn new(scene: &'a Scene, window: [[f64; 2]; 2]) -> Reading<'a> {
        let mut clips = scene.shapes().iter().filter(|shape| shape.label.is_none());
        let frame = clips.find_map(|shape| {
            // The key has clips of its own, one above the other, that are 18 px tall.
            shape.clip.filter(|clip| clip.height() > 20.0)
        });
        Reading { scene, window, frame: frame.expect("something is drawn in the frame") }
    }

    /// Returns the place of a point of the window, in px.
    pub(crate) fn place(&self, x: f64, y: f64) -> (f64, f64) {
        let [[left, right], [bottom, top]] = self.window;
        let Extent { left: l, right: r, top: t, bottom: b } = self.frame;
        (l + (x - left) / (right - left) * (r - l), b + (y - bottom) / (top - bottom) * (t - b))
    }

    /// Returns the box on the canvas for a box of the window.
    pub(crate) fn place_box(&self, x: [f64; 2], y: [f64; 2]) -> Extent {
        let ((left, bottom), (right, top)) = (self.place(x[0], y[0]), self.place(x[1], y[1]));
        Extent { left, top, right, bottom }
    }

    /// Returns the frame.
    pub(crate) fn frame(&self) -> Extent {
        self.frame
    }

    /// Returns the boxes of the translucent areas in a colour.
    pub(crate) fn areas(&self, colour: Colour) -> Vec<Extent> {
        let painted = |shape: &&Drawn| {
            shape.fill.is_some_and(|fill| fill.colour == colour && fill.opacity < 1.0)
        };
        let areas = self.scene.shapes().iter().filter(painted);
        areas.filter_map(|shape| shape.path.extent()).collect()
    }

    /// Returns the points of all lines of at least 1 px in a colour, line by line.
    pub(crate) fn lines(&self, colour: Colour) -> Vec<Vec<(f64, f64)>> {
        let drawn = |shape: &&Drawn| {
            let is_line = shape.clip == Some(self.frame) && shape.fill.is_none();
            let stroke = shape.stroke.as_ref();
            is_line && stroke.is_some_and(|s| s.paint.colour == colour && s.width >= 1.0)
        };
        self.scene.shapes().iter().filter(drawn).map(corners).collect()
    }

    /// Returns the centres of the opaque markers in a colour.
    pub(crate) fn markers(&self, colour: Colour) -> Vec<(f64, f64)> {
        let painted = |shape: &&Drawn| {
            let opaque = shape.fill.is_some_and(|f| f.colour == colour && f.opacity == 1.0);
            let small = shape.path.extent().is_some_and(|extent| extent.width() < 12.0);
            opaque && small && shape.label.is_none() && shape.clip.is_some()
        };
        let markers = self.scene.shapes().iter().filter(painted);
        let centre = |e: Extent| (f64::midpoint(e.left, e.right), f64::midpoint(e.top, e.bottom));
        markers.filter_map(|shape| shape.path.extent().map(centre)).collect()
    }

    /// Returns the ends of the solution, the start first.
    pub(crate) fn ends(&self) -> [(f64, f64); 2] {
        match self.markers(palette::VERMILLION)[..] {
            [end, start] => [start, end],
            ref other => panic!("two ends, got {other:?}"),
        }
    }
}

/// Returns all labels of a drawing.
pub(crate) fn labels(scene: &Scene) -> Vec<String> {
    let labels = scene.shapes().iter().filter_map(|shape| shape.label.as_ref());
    labels.map(|(text, _)| text.clone()).collect()
}

fn corners(shape: &Drawn) -> Vec<(f64, f64)> {
    let corner = |segment: &Segment| match *segment {
        Segment::Move(x, y) | Segment::Line(x, y) | Segment::Cubic([.., x, y]) => Some((x, y)),
        Segment::Close => None,
    };
    shape.path.segments().iter().filter_map(corner).collect()
}

/// Fails unless two boxes agree within `slack` px.
#[track_caller]
pub(crate) fn assert_same_box(found: Extent, expected: Extent, slack: f64) {
    let sides = |e: Extent| [e.left, e.top, e.right, e.bottom];
    let apart = sides(found).into_iter().zip(sides(expected)).map(|(a, b)| (a - b).abs());
    assert!(apart.fold(0.0, f64::max) <= slack, "{found:?} instead of {expected:?}");
}
