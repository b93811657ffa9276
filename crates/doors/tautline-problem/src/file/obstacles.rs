//! `ObstaclesFile`: regions that no curve enters.

use schemars::JsonSchema;
use serde::Deserialize;

use super::{
    expression::Text,
    placed::Placed,
    set::{HalfSpaceFile, Round},
};

/// Regions that no curve enters. They repel: with the distance `δₖ(x)` from each, and the margin `m`,
/// the metric is `(1 + Σₖ (m/δₖ(x))²) H(x)`, and there is none in a region.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ObstaclesFile {
    /// The regions.
    pub(crate) regions: Placed<Vec<RegionFile>>,
    /// The distance from a region at which `H` is doubled. With a smaller margin a curve runs closer to
    /// the regions, and its length is closer to that without a margin.
    pub(crate) margin: Text,
}

/// A region: one of the keys `ball`, `half_space` and `negative`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum RegionFile {
    /// The ball `|x − centre| ≤ radius`.
    Ball(Round),
    /// The half-space `normal·x ≥ at_least`, or `normal·x ≤ at_most`.
    HalfSpace(HalfSpaceFile),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(Text),
}
