//! `ObstaclesFile`: regions that no curve enters.

use schemars::{JsonSchema, Schema, SchemaGenerator};
use serde::{Deserialize, Deserializer, de::DeserializeSeed};
use tautline::{ANY, AxisBox, Ball, HalfSpace};

use super::{
    expression::Text,
    placed::Placed,
    set::{PieceFile, Values, described},
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

/// A region: one of the keys `ball`, `half_space`, `box` and `negative`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum RegionFile {
    /// The ball `|x − centre| ≤ radius`.
    #[serde(deserialize_with = "ball")]
    #[schemars(schema_with = "ball_schema")]
    Ball(PieceFile),
    /// The half-space `normal·x ≥ at_least`, or `normal·x ≤ at_most`.
    #[serde(deserialize_with = "half_space")]
    #[schemars(schema_with = "half_space_schema")]
    HalfSpace(PieceFile),
    /// The box between two corners. It is rounded, and grows by a part of the margin.
    #[serde(deserialize_with = "axis_box")]
    #[schemars(schema_with = "box_schema")]
    Box(PieceFile),
    /// Where this expression of the coordinates is not positive; it takes the place of the distance.
    Negative(Text),
}

fn ball<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PieceFile, D::Error> {
    Values(Ball::<ANY>::KIND).deserialize(deserializer)
}

fn ball_schema(generator: &mut SchemaGenerator) -> Schema {
    described(Ball::<ANY>::KIND, generator)
}

fn half_space<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PieceFile, D::Error> {
    Values(HalfSpace::<ANY>::KIND).deserialize(deserializer)
}

fn half_space_schema(generator: &mut SchemaGenerator) -> Schema {
    described(HalfSpace::<ANY>::KIND, generator)
}

fn axis_box<'de, D: Deserializer<'de>>(deserializer: D) -> Result<PieceFile, D::Error> {
    Values(AxisBox::<ANY>::KIND).deserialize(deserializer)
}

fn box_schema(generator: &mut SchemaGenerator) -> Schema {
    described(AxisBox::<ANY>::KIND, generator)
}
