//! The sections `[solve]`, `[certify]`, `[audit]` and `[output]` of a file.

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::{Deserialize, Deserializer, de::Error};
use tautline::{Rule, Scope};

use super::{
    expression::Text,
    placed::Placed,
    set::{Corners, SetFile, Vector},
};

/// How the problem is solved.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct SolveFile {
    /// The rule of numerical integration, which says where the metric is evaluated: `trapezoidal` in the
    /// middle of each chord (called the midpoint rule elsewhere), `left_endpoint` at the first point of
    /// each chord, `true_trapezoid` at both ends.
    #[serde(default, deserialize_with = "named_rule")]
    #[schemars(schema_with = "rule_names")]
    pub(crate) rule: Rule,
    /// The number of chords; 256 unless a tolerance is given.
    pub(crate) n: Option<Placed<usize>>,
    /// The relative error of the length, by extrapolation over several grids. It replaces `n`.
    pub(crate) tolerance: Option<Text>,
    /// Polygons from which a search starts, in addition to the automatic starts.
    #[serde(default)]
    pub(crate) starts: Vec<Placed<Vec<Vector>>>,
    /// Whether the given starts replace the automatic ones.
    #[serde(default)]
    pub(crate) only_these_starts: bool,
    /// How far a search looks: `automatic`, in two and three coordinates also along a path through a coarse
    /// lattice around what the starts led to, or `local`, from the starts alone.
    #[serde(default, deserialize_with = "named_scope")]
    #[schemars(schema_with = "scope_names")]
    pub(crate) scope: Scope,
    /// A lattice; a search also starts, with `n` chords, from a shortest path along its nodes. It finds
    /// the way through a landscape with many hills, in at most four dimensions.
    pub(crate) lattice: Option<Placed<LatticeFile>>,
    /// The largest number of Newton steps of a local search on one grid.
    pub(crate) steps: Option<Placed<usize>>,
    /// The time after which everything stops, in seconds. What is known by then is the answer.
    pub(crate) time_limit: Option<Text>,
}

/// Nodes in a box.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct LatticeFile {
    /// The first node.
    pub(crate) lower: Vector,
    /// The corner at which the nodes end.
    pub(crate) upper: Vector,
    /// The distance of neighbouring nodes.
    pub(crate) spacing: Text,
    /// The most ways around the peaks and holes of the metric from which a search starts, shortest first: the
    /// shortest path of each homotopy class. 1 unless said otherwise, the shortest path of all.
    pub(crate) classes: Option<Placed<usize>>,
}

/// Reads the name of a rule of the library.
fn named_rule<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Rule, D::Error> {
    let name = String::deserialize(deserializer)?;
    Rule::named(&name).ok_or_else(|| D::Error::unknown_variant(&name, &Rule::NAMES))
}

/// Describes the names of the rules.
fn rule_names(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "enum": Rule::NAMES })
}

/// Reads the name of a scope of the library.
fn named_scope<'de, D: Deserializer<'de>>(deserializer: D) -> Result<Scope, D::Error> {
    let name = String::deserialize(deserializer)?;
    Scope::named(&name).ok_or_else(|| D::Error::unknown_variant(&name, &Scope::NAMES))
}

/// Describes the names of the scopes.
fn scope_names(_: &mut SchemaGenerator) -> Schema {
    json_schema!({ "type": "string", "enum": Scope::NAMES })
}

/// What is proved.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct CertifyFile {
    /// Whether the distance is bounded from both sides; `true` unless said otherwise.
    pub(crate) bound: Option<bool>,
    /// Constants that you claim for the metric: on all of space, or in the region `within`, and then no
    /// bounds rest on them, since curves may leave it. Without them they are proved from the formula.
    pub(crate) constants: Option<ConstantsFile>,
    /// The region in which `tautline constants` proves constants, and `tautline audit` tests those that you
    /// claim: a ball or a box. Without it that is all of space. `tautline solve` finds its own ball.
    pub(crate) within: Option<Placed<SetFile>>,
    /// The largest number of boxes for one constant; unless said otherwise 100,000 in the plane, a fifth of
    /// that for each further dimension, and 160 from six dimensions on.
    pub(crate) boxes: Option<Placed<usize>>,
    /// The relative accuracy of a constant; 0.001 unless said otherwise.
    pub(crate) tolerance: Option<Text>,
}

/// Constants of a metric: `c1 ≤ H ≤ c2`, `‖DH[v]‖ ≤ l_h |v|` and `‖D²H[v, v]‖ ≤ m_h |v|²`.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct ConstantsFile {
    /// A lower bound on the eigenvalues of `H`.
    pub(crate) c1: Text,
    /// An upper bound on the eigenvalues of `H`.
    pub(crate) c2: Text,
    /// A Lipschitz constant of `H`.
    pub(crate) l_h: Text,
    /// A Lipschitz constant of the derivative of `H`.
    pub(crate) m_h: Option<Text>,
}

/// How the metric is audited.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct AuditFile {
    /// The box in which samples are drawn.
    pub(crate) region: Option<Corners>,
    /// The number of random samples for each law.
    pub(crate) cases: Option<Placed<u32>>,
    /// The seed of the samples.
    pub(crate) seed: Option<u64>,
}

/// What is shown.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct OutputFile {
    /// The two coordinates that a picture shows, from 1.
    pub(crate) coordinates: Option<Placed<[usize; 2]>>,
    /// How a picture shows the metric.
    #[serde(default)]
    pub(crate) field: FieldFile,
    /// The part of the plane that a picture shows.
    pub(crate) window: Option<Corners>,
}

/// How a picture shows the metric.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub(crate) enum FieldFile {
    /// Filled contours of `det H`.
    #[default]
    Determinant,
    /// Ellipses `vᵀHv = const`.
    Ellipses,
    /// Nothing.
    Plain,
}
