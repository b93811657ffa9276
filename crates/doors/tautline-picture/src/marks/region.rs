//! A filled area of the plane.

use crate::{
    colours::Colour,
    picture::{Paint, Stroke},
};

/// An area of a panel, with its outline. Curves and markers are drawn over it.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Region {
    pub(crate) rings: Vec<Vec<(f64, f64)>>,
    pub(crate) fill: Option<Paint>,
    pub(crate) outline: Option<Stroke>,
    pub(crate) halo: bool,
}

impl Region {
    /// Returns the area inside closed rings of data points, by the nonzero rule, without any paint.
    pub fn new(rings: Vec<Vec<(f64, f64)>>) -> Region {
        Region { rings, fill: None, outline: None, halo: false }
    }

    /// Fills the area.
    pub fn filled(mut self, colour: Colour, opacity: f64) -> Region {
        self.fill = Some(Paint { colour, opacity });
        self
    }

    /// Draws the outline, `width` px wide.
    pub fn outlined(mut self, colour: Colour, width: f64) -> Region {
        self.outline = Some(Stroke::solid(colour, width));
        self
    }

    /// Draws a white rim around the outline, so that it stands out from a heat-map.
    pub fn over_field(mut self) -> Region {
        self.halo = true;
        self
    }
}
