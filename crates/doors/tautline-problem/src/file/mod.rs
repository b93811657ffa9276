//! `ProblemFile`: what a problem file says, word for word. Nothing is evaluated yet.

pub(crate) mod expression;
pub(crate) mod gallery;
pub(crate) mod metric;
pub(crate) mod obstacles;
pub(crate) mod placed;
pub(crate) mod request;
pub(crate) mod set;
pub(crate) mod sweep;
pub(crate) mod table;

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;

use expression::Text;
use metric::MetricFile;
use obstacles::ObstaclesFile;
use placed::Placed;
use request::{AuditFile, CertifyFile, OutputFile, SolveFile};
use set::{SetFile, Vector};
use sweep::SweepFile;
use table::TableFile;

/// A problem: a metric, the two sets that a curve joins, and the options of each command.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(title = "A problem of Tautline", rename = "Problem")]
pub(crate) struct ProblemFile {
    /// The number of coordinates, if the sets do not show it.
    pub(crate) dimension: Option<Placed<usize>>,
    /// Named numbers. One may use those before it.
    #[serde(default)]
    pub(crate) parameters: BTreeMap<Placed<String>, Text>,
    /// Named expressions of the coordinates `x1`, `x2`, …. One may use those before it.
    #[serde(default, rename = "let")]
    pub(crate) definitions: BTreeMap<Placed<String>, Text>,
    /// Arrays of numbers as smooth functions, by the names under which expressions call them.
    #[serde(default)]
    pub(crate) tables: BTreeMap<Placed<String>, Placed<TableFile>>,
    /// The metric.
    pub(crate) metric: Placed<MetricFile>,
    /// The period of each coordinate, such as `[0, "2*pi"]` for an angle `x2`; 0 if it has none. The set `to`
    /// is then those of its translates that come near to the set `from`.
    pub(crate) period: Option<Vector>,
    /// Regions that no curve enters.
    pub(crate) obstacles: Option<Placed<ObstaclesFile>>,
    /// The set in which curves start.
    pub(crate) from: Option<Placed<SetFile>>,
    /// The set in which curves end.
    pub(crate) to: Option<Placed<SetFile>>,
    /// How the problem is solved.
    #[serde(default)]
    pub(crate) solve: SolveFile,
    /// What is proved.
    #[serde(default)]
    pub(crate) certify: CertifyFile,
    /// How the metric is audited.
    #[serde(default)]
    pub(crate) audit: AuditFile,
    /// What is shown.
    #[serde(default)]
    pub(crate) output: OutputFile,
    /// Which parameters vary, for `tautline plan` and `tautline run`.
    pub(crate) sweep: Option<Placed<SweepFile>>,
}

/// Says that a name is none of these, in the words of serde.
fn one_of(what: &str, name: &str, known: impl Iterator<Item = &'static str>) -> String {
    let known: Vec<String> = known.map(|name| format!("`{name}`")).collect();
    let expected = match &known[..] {
        [first, second] => format!("{first} or {second}"),
        [only] => only.clone(),
        _ => format!("one of {}", known.join(", ")),
    };
    format!("unknown {what} `{name}`, expected {expected}")
}
