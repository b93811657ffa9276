//! One coordinate system and its contents.

use crate::{
    axes::Axis,
    marks::{Curve, Field, Note, Region, SlopeTriangle},
};

/// A panel of a figure, as data.
#[derive(Clone, Debug)]
#[must_use]
pub struct Panel {
    pub(crate) x: Axis,
    pub(crate) y: Axis,
    pub(crate) title: String,
    pub(crate) height: Height,
    pub(crate) flush: bool,
    pub(crate) boxed: bool,
    pub(crate) field: Option<Field>,
    pub(crate) regions: Vec<Region>,
    pub(crate) curves: Vec<Curve>,
    pub(crate) triangles: Vec<SlopeTriangle>,
    pub(crate) notes: Vec<Note>,
}

/// The height of the frame of a panel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Height {
    Px(f64),
    EqualUnits,
}

impl Panel {
    /// Returns an empty panel that is 300 px tall.
    ///
    /// The `x` axis is drawn in one piece; a break in it is ignored.
    pub fn new(x: Axis, y: Axis) -> Panel {
        Panel {
            x,
            y,
            title: String::new(),
            height: Height::Px(300.0),
            flush: false,
            boxed: false,
            field: None,
            regions: Vec::new(),
            curves: Vec::new(),
            triangles: Vec::new(),
            notes: Vec::new(),
        }
    }

    /// Sets the title above the frame, such as `"(a) valleys"`.
    pub fn titled(mut self, title: impl Into<String>) -> Panel {
        self.title = title.into();
        self
    }

    /// Sets the height of the frame, in px.
    pub fn tall(mut self, height: f64) -> Panel {
        self.height = Height::Px(height);
        self
    }

    /// Chooses the height so that both axes have the same scale.
    pub fn equal_units(mut self) -> Panel {
        self.height = Height::EqualUnits;
        self
    }

    /// Extends the `x` axis to both sides of the frame, as over a heat-map. This is for a panel
    /// above or below a heat-map.
    pub fn flush(mut self) -> Panel {
        self.flush = true;
        self
    }

    /// Draws a heat-map behind everything else, with its colour bar on the right.
    pub fn over(mut self, field: Field) -> Panel {
        self.field = Some(field);
        self.boxed()
    }

    /// Draws a closed frame whose sides are the ends of the axes, without a grid, as around a
    /// heat-map. This is for a map of the plane.
    pub fn boxed(mut self) -> Panel {
        self.boxed = true;
        self
    }

    /// Adds an area, over the heat-map and the areas added before, and under all curves.
    pub fn region(mut self, region: Region) -> Panel {
        self.regions.push(region);
        self
    }

    /// Adds a curve on top of those added before.
    pub fn curve(mut self, curve: Curve) -> Panel {
        self.curves.push(curve);
        self
    }

    /// Adds a slope triangle.
    pub fn triangle(mut self, triangle: SlopeTriangle) -> Panel {
        self.triangles.push(triangle);
        self
    }

    /// Adds a label at a data point.
    pub fn note(mut self, note: Note) -> Panel {
        self.notes.push(note);
        self
    }
}
