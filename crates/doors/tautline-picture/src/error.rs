//! What can be wrong with a figure.

/// Why a figure cannot be drawn as requested.
///
/// Each message by itself tells which label, range or number to change.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DrawingError {
    /// The embedded font has no outline for a character. A blank in its place would go unnoticed.
    #[error("the figure font has no glyph for {character:?} (U+{:04X}), which {label:?} needs", u32::from(*character))]
    UnknownGlyph {
        /// The character without a glyph.
        character: char,
        /// The label that needs it.
        label: String,
    },
    /// A label does not follow the syntax of [`typeset`](crate::math_text::typeset).
    #[error("the label {label:?} is malformed: {problem}")]
    MalformedLabel {
        /// The label as it was given.
        label: String,
        /// What is wrong with it.
        problem: &'static str,
    },
    /// An axis needs a finite, increasing range; on a logarithmic axis the range must also be
    /// positive.
    #[error("an axis cannot run from {from} to {to}: {want}")]
    BadRange {
        /// The lower end, as given.
        from: f64,
        /// The upper end, as given.
        to: f64,
        /// The condition that failed.
        want: &'static str,
    },
    /// A heat-map has no colour for a value that is not finite.
    #[error("the field is {value} at ({x}, {y}); a heat-map needs finite values")]
    NotFinite {
        /// The first coordinate of the sample.
        x: f64,
        /// The second coordinate of the sample.
        y: f64,
        /// The value of the sample.
        value: f64,
    },
    /// A heat-map needs at least two increasing, finite levels.
    #[error("a heat-map needs at least two increasing finite levels, got {levels:?}")]
    BadLevels {
        /// The levels as given.
        levels: Vec<f64>,
    },
    /// The labels leave no room for the plots.
    #[error("a panel would be {left:.0} px wide; widen the figure or shorten its labels")]
    TooNarrow {
        /// The width left for each plot, in px.
        left: f64,
    },
    /// Two labels of a finished scene overlap.
    #[error("the labels {first:?} and {second:?} overlap")]
    Overlap {
        /// The label drawn first.
        first: String,
        /// The label drawn on top of it.
        second: String,
    },
    /// A curve runs through a label of a finished scene.
    #[error("a curve crosses the label {label:?}")]
    Crossed {
        /// The label.
        label: String,
    },
    /// A label of a finished scene extends beyond the canvas.
    #[error("the label {label:?} is cut by the edge of the figure")]
    Cut {
        /// The label.
        label: String,
    },
    /// A remark lies outside its panel, where it would go unnoticed.
    #[error("{what} at ({x}, {y}) lies outside its panel")]
    Outside {
        /// The remark.
        what: String,
        /// The first coordinate.
        x: f64,
        /// The second coordinate.
        y: f64,
    },
    /// A figure needs at least one panel, and the same number of panels in each row.
    #[error("a figure needs at least one panel, and equally many in each row")]
    NoPanels,
    /// A library that draws or encodes failed with this message.
    #[error("drawing failed: {0}")]
    Backend(String),
}
