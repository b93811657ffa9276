//! A label at a data point.

use crate::{colours::Colour, math_text::Align};

/// A remark inside a panel, with a little white space around it.
#[derive(Clone, Debug, PartialEq)]
#[must_use]
pub struct Note {
    pub(crate) at: (f64, f64),
    pub(crate) text: String,
    pub(crate) colour: Colour,
    pub(crate) align: Align,
    pub(crate) shift: (f64, f64),
}

impl Note {
    /// Returns a label whose left, middle or right end (according to `align`) is at the data point
    /// `at`. The label is vertically centred on this point.
    pub fn new(at: (f64, f64), text: impl Into<String>, colour: Colour, align: Align) -> Note {
        Note { at, text: text.into(), colour, align, shift: (0.0, 0.0) }
    }

    /// Moves the label away from its point, by `dx` px to the right and `dy` px downwards.
    pub fn shifted(mut self, dx: f64, dy: f64) -> Note {
        self.shift = (dx, dy);
        self
    }
}
