//! `MetricFile`: a metric in a file.

use std::ops::Range;

use schemars::JsonSchema;
use serde::Deserialize;

use super::{expression::Text, gallery::FromGallery, placed::Placed};

/// A metric: one key that says how its matrix `H(x)` is written.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum MetricFile {
    /// The whole metric in one text, such as `"f = 2 - cos(x1); [f, 0; 0, f^2]"`.
    Formula(Text),
    /// All entries of the matrix, row by row.
    Matrix(Placed<Vec<Placed<Vec<Text>>>>),
    /// The entries on the diagonal and to the right of it, row by row.
    Upper(Placed<Vec<Placed<Vec<Text>>>>),
    /// The diagonal matrix with these entries.
    Diag(Placed<Vec<Text>>),
    /// `φ I`.
    Phi(Text),
    /// `f² I`: a curve has the length `∫ f |γ'| dt`, so `f` is the cost of a unit of length. It is positive
    /// on every curve that counts: where it is 0 there is no metric.
    Cost(Text),
    /// `f⁻² I`: the length of a curve is the time it takes at the speed `f`, which is positive on every curve
    /// that counts.
    Speed(Text),
    /// `JᵀJ` with the derivative `J` of a map: lengths are those of image curves.
    Pullback(Placed<Vec<Text>>),
    /// `I + ∇f ∇fᵀ`: lengths are those of curves on the graph of `f`.
    Graph(Text),
    /// The sum of metrics.
    Sum(Placed<Vec<MetricFile>>),
    /// A metric times a positive function.
    Scaled(ScaledFile),
    /// Metrics in blocks along the diagonal.
    Product(Placed<Vec<BlockFile>>),
    /// A metric of the gallery with its parameters, such as `{ shear = { amplitude = 0.5,
    /// wave_number = 1 } }`, or its name alone, such as `"valleys"`, if it has none.
    Gallery(Placed<FromGallery>),
}

impl MetricFile {
    /// Returns where the expressions of the metric stand, if they are together.
    pub(crate) fn span(&self) -> Option<Range<usize>> {
        match self {
            MetricFile::Formula(text)
            | MetricFile::Phi(text)
            | MetricFile::Cost(text)
            | MetricFile::Speed(text)
            | MetricFile::Graph(text) => Some(text.span()),
            MetricFile::Matrix(rows) | MetricFile::Upper(rows) => Some(rows.span()),
            MetricFile::Diag(texts) | MetricFile::Pullback(texts) => Some(texts.span()),
            MetricFile::Sum(metrics) => Some(metrics.span()),
            MetricFile::Product(blocks) => Some(blocks.span()),
            MetricFile::Gallery(metric) => Some(metric.span()),
            MetricFile::Scaled(_) => None,
        }
    }
}

/// A metric times a positive function.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ScaledFile {
    /// The function.
    pub(crate) by: Text,
    /// The metric.
    pub(crate) metric: Box<MetricFile>,
}

/// A block of a product.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct BlockFile {
    /// The numbers of the coordinates of the block, from 1.
    pub(crate) coordinates: Placed<Vec<usize>>,
    /// The metric of the block. Its texts may use all coordinates; its rows, its columns and its
    /// derivatives are those of the block.
    pub(crate) metric: MetricFile,
}
