//! A label at a point of the data.

use super::{colour::Colour, math_text::Align};

/// A remark inside a panel; it clears a little white round itself.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    pub(super) at: (f64, f64),
    pub(super) text: String,
    pub(super) colour: Colour,
    pub(super) align: Align,
    pub(super) shift: (f64, f64),
}

impl Note {
    /// Returns a label whose left, middle or right end (by `align`) is at the data point `at`,
    /// vertically centred on it.
    #[must_use]
    pub fn new(at: (f64, f64), text: impl Into<String>, colour: Colour, align: Align) -> Note {
        Note { at, text: text.into(), colour, align, shift: (0.0, 0.0) }
    }

    /// Moves the label by px from its point, to the right and downwards.
    #[must_use]
    pub fn shifted(mut self, dx: f64, dy: f64) -> Note {
        self.shift = (dx, dy);
        self
    }
}
