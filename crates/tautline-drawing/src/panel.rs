//! One coordinate system with everything that is drawn in it.

use super::{axis::Axis, curve::Curve, field::Field, note::Note, slope_triangle::SlopeTriangle};

/// A panel of a figure: data only, no place yet.
#[derive(Clone, Debug)]
pub struct Panel {
    pub(super) x: Axis,
    pub(super) y: Axis,
    pub(super) title: String,
    pub(super) height: Height,
    pub(super) flush: bool,
    pub(super) field: Option<Field>,
    pub(super) curves: Vec<Curve>,
    pub(super) triangles: Vec<SlopeTriangle>,
    pub(super) notes: Vec<Note>,
}

/// How tall the frame of a panel is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Height {
    Px(f64),
    EqualUnits,
}

impl Panel {
    /// Returns an empty panel, 300 px tall.
    ///
    /// The `x` axis is drawn in one piece; a break in it is ignored.
    #[must_use]
    pub fn new(x: Axis, y: Axis) -> Panel {
        Panel {
            x,
            y,
            title: String::new(),
            height: Height::Px(300.0),
            flush: false,
            field: None,
            curves: Vec::new(),
            triangles: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Sets the title above the frame, such as `"(a) valleys"`.
    #[must_use]
    pub fn titled(mut self, title: impl Into<String>) -> Panel {
        self.title = title.into();
        self
    }

    /// Sets the height of the frame, in px.
    #[must_use]
    pub fn tall(mut self, height: f64) -> Panel {
        self.height = Height::Px(height);
        self
    }

    /// Makes the height such that both axes have the same px to a unit.
    #[must_use]
    pub fn equal_units(mut self) -> Panel {
        self.height = Height::EqualUnits;
        self
    }

    /// Lets the `x` axis reach to both sides of the frame, as over a heat-map: for a panel that
    /// is stacked on one.
    #[must_use]
    pub fn flush(mut self) -> Panel {
        self.flush = true;
        self
    }

    /// Puts a heat-map behind everything, with its colour bar on the right.
    #[must_use]
    pub fn over(mut self, field: Field) -> Panel {
        self.field = Some(field);
        self
    }

    /// Adds a curve over those added before.
    #[must_use]
    pub fn curve(mut self, curve: Curve) -> Panel {
        self.curves.push(curve);
        self
    }

    /// Adds a slope triangle.
    #[must_use]
    pub fn triangle(mut self, triangle: SlopeTriangle) -> Panel {
        self.triangles.push(triangle);
        self
    }

    /// Adds a label at a point of the data.
    #[must_use]
    pub fn note(mut self, note: Note) -> Panel {
        self.notes.push(note);
        self
    }
}
