//! A label at a point of the data.

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
    /// Returns a label whose left, middle or right end (by `align`) is at the data point `at`,
    /// vertically centred on it.
    pub fn new(at: (f64, f64), text: impl Into<String>, colour: Colour, align: Align) -> Note {
        Note { at, text: text.into(), colour, align, shift: (0.0, 0.0) }
    }

    /// Moves the label by px from its point, to the right and downwards.
    pub fn shifted(mut self, dx: f64, dy: f64) -> Note {
        self.shift = (dx, dy);
        self
    }
}
