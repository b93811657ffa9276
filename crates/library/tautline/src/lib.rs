//! Shortest curves between two closed sets, under a metric that you write as one formula.
//!
//! A taut line between two bodies is a shortest curve. Given the metric `H(x)` and the closed sets
//! `X⁽⁰⁾`, `X⁽¹⁾` of `R^D`, one of them bounded, Tautline minimises a discretisation of the energy
//! `E(γ) = ∫ γ̇ᵀ H(γ) γ̇ dt` over sequences of points, joins the points of the minimiser into
//! a curve, and returns proven bounds on the error. The minimum of the energy is the squared
//! distance.
//!
//! ```
//! use tautline::{Ball, Ends, HalfSpace, Metric, Problem, Rule, SMatrix, SVector, Scalar};
//!
//! struct Valleys; // f² I with f = 2 − cos x₁
//! impl Metric<2> for Valleys {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal_element((2.0 - x[0].cos()).sqr())
//!     }
//! }
//!
//! let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::new([-1.0, 0.0], -3.0)?)?;
//! let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 256)?;
//! assert!((line.length().value - 5.338305).abs() < 1e-6); // 5 − sin 3 + sin ½
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A formula reads as in mathematics, with `f64` on either side of an operator: `2.0 - x`,
//! `2.0 / x`, `2.0 * x`, `1.0 + x`. [`Scalar`] lists the functions that it may use.
//!
//! # By question
//!
//! | you want | example |
//! | --- | --- |
//! | the distance between two points | `examples/two_points.rs` |
//! | the shortest curve between two bodies | `examples/two_sets.rs` |
//! | the distances among many points, on all threads | `examples/many_pairs.rs` |
//! | a metric of your own, with bounds | `examples/my_own_metric.rs` |
//! | the distance between two normal distributions: a metric without global constants | `examples/normal_distributions.rs` |
//!
//! # What is computed and what is proven
//!
//! | number | status |
//! | --- | --- |
//! | [`TautLine::energy`], [`TautLine::length`] | energy and length of an actual curve between the sets: upper bounds on `d²` and `d`, up to an estimated quadrature error |
//! | [`TautLine::discrete_energy`] | may lie on either side of `d²` |
//! | [`TautLine::distance_squared_estimate`] | extrapolated: an estimate, not a bound |
//! | [`TautLine::enclosure`], [`TautLine::enclosure_among`] | bounds on `d²` by theorems, up to an estimated quadrature error; reports whether a global minimum is assumed (between sets, it always is) |
//! | [`TautLine::prove`] | the same with constants that are proved from the formula, and an upper bound with outward rounding |
//! | [`TautLine::certificate`] | bounds on `d` that assume nothing about global minima, with a certificate that anybody can check |
//! | [`leading_constants`] | limits of the errors times `N` or `N²` on smooth data: computed, not proven |
//! | [`bounds`] | proven, for global minimisers of the discrete energy |
//!
//! A solver finds local minimisers. [`TautLine::minimum`] reports how the line was found and the
//! signature of the Hessian; it does not claim that no other curve is shorter.
//!
//! # Conventions
//!
//! No energy has a factor `½`, so that `E ≥ L²` and `min E = d²`. Time runs over `[0, 1]`. The
//! paper's *trapezoidal* rule evaluates the metric at the middle of each chord; elsewhere it is
//! called the midpoint rule. [`Convention`] converts the numbers of other programs.
//!
//! # Features
//!
//! `serde` is the only feature, and off by default. With it, these types can be written and read by
//! [serde](https://docs.rs/serde), under the names of their fields and variants, and sets under the names of their
//! [parts](sets::kind):
//!
//! | what | types |
//! | --- | --- |
//! | options, in which fields may be missing, but not misspelt | [`Options`], [`certify::Accuracy`]; also [`Scope`], [`Starts`], [`distance::Wanted`] |
//! | results of a search | [`Minimum`], [`Other`], [`Level`], [`Stop`], [`Curvature`], [`PointSequence`] |
//! | numbers with their errors | [`Estimate`], [`Integral`], [`LeadingConstants`] |
//! | bounds | [`bounds::Enclosure`], [`bounds::Bound`], [`SuggestedN`], [`Competitors`] |
//! | constants | [`Constants`], [`CertifiedConstant`] |
//! | sets that are finitely many numbers | [`Shape`] and the kinds that it may be |
//! | words | [`Convention`], [`Quantity`], [`bounds::PaperRule`], [`bounds::Theorem`], [`distance::Ended`] |
//!
//! - What a constructor checks is checked when it is read: constants, point sequences and sets.
//! - [`CertifiedConstants`] and [`check::Verdict`] are only written, since nothing proves what is read.
//!   A certificate has a [format](check::Certificate) of its own, and is proved again when it is read.
//! - A [`TautLine`] is not written, since it has the formula. Save its [`Minimum`], and start from its
//!   sequence ([`Starts::Only`]).
//! - JSON has neither NaN nor infinities. `serde_json` writes them as `null`, and does not read a
//!   `null` as a number. Other formats, such as TOML, have them.
//! - `serde_json` reads a number back to the last bit only with its feature `float_roundtrip`.
//!   Otherwise a bound that was read may be off by one unit in the last place, on either side.

mod batch;
mod both_ends;
mod certificate;
mod certified_distance;
mod competitors;
mod conventions;
mod doubt;
mod jump;
mod other_minima;
mod period;
mod problem;
mod proof;
mod request;
mod search;
mod taut_line;

pub use batch::{answer_all, solve_all};
pub use certificate::SuggestedN;
pub use certified_distance::CertificateError;
pub use competitors::Competitors;
pub use conventions::Convention;
pub use doubt::Doubt;
pub use other_minima::TIE;
pub use period::{NotPeriodic, check_periods};
pub use problem::Problem;
pub use proof::{Proof, ProofError};
pub use request::{CHORDS, Grid, Request, RequestError};
pub use search::tolerance::LEAST_TOLERANCE;
pub use taut_line::TautLine;

pub use tautline_bounds as bounds;
pub use tautline_certify::{
    self as certify, AdmissibleCurve, Certified, CertifiedConstant, CertifiedConstants,
    CertifyError, CurveError, Domain, LocallyCertified, Polygon, Quantity,
};
pub use tautline_check as check;
pub use tautline_discretizations::{
    ANY, ChordBatch, ChordModel, Integral, Interpolation, LARGEST_N, LinearModel, Node,
    PeanoConstants, PointSequence, Rule, SequenceError, admissible_energy, coordinates,
    energy_gradient,
};
pub use tautline_distance as distance;
pub use tautline_formula::{
    self as formula, AnyBatches, AnyMetric, Batch, Batches, BatchesIn, BlackBox, Formula, Kind,
    Known, Plain, Prepare, Prepared, PreparedFormula, RecordError, TextError, Values,
    spline::{FineSpline, Spline, SplineError},
};
pub use tautline_grid::{
    self as grid, ClassPath, GraphPathError, Lattice, LatticeGraph, LatticePath, Nodes, Punctures,
    Word, class_paths, equal_chords, graph_path,
};
pub use tautline_metrics::{
    Bounded, Constants, HypothesisError, KnownDistance, LocalError, LocallyBounded, Metric,
    MetricError, RayleighQuotient, are_gram, check_gram, check_matrix, christoffel, composition,
    gallery, is_gram, norm_squared, quadrature,
};
pub use tautline_optimizers::{
    AsymptoticsError, Curvature, Entry, Estimate, Iterate, LeadingConstants, Level, Minimum,
    NewtonStep, Options, Other, Scope, SolveError, Starts, Stop, Trace, Watcher, Workspace,
    are_apart, extrapolate, leading_constants, minimise, minimise_any, minimise_by_batches,
    minimise_in, minimise_watched, newton_step,
};
pub use tautline_scalar::{FastInterval, Interval, Jet1, Jet2, Scalar, Short, Table, decimal};
pub use tautline_sets::{
    self as sets, AffineSubspace, AnyEnds, AnySet, AxisBox, Ball, ClosedSet, Ends, FiniteSet,
    HalfSpace, Point, Segment, SetError, Shape, Sphere, Union, translates,
};

pub use nalgebra::{SMatrix, SVector};

/// Compiles the example of the README as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../../README.md")]
struct Readme;

/// Runs the Rust in the pages of the guide as tests.
// The names of files after the language of a block are for the tests of the guide.
#[cfg(doctest)]
#[allow(rustdoc::invalid_codeblock_attributes)]
mod guide {
    #[doc = include_str!("../../../../guide/pages/conventions.md")]
    struct Conventions;

    #[doc = include_str!("../../../../guide/pages/from-fast-marching.md")]
    struct FromFastMarching;

    #[doc = include_str!("../../../../guide/pages/from-geomstats.md")]
    struct FromGeomstats;

    #[doc = include_str!("../../../../guide/pages/from-manifolds-jl.md")]
    struct FromManifoldsJl;

    #[doc = include_str!("../../../../guide/pages/how-wrong.md")]
    struct HowWrong;

    #[doc = include_str!("../../../../guide/pages/which-n.md")]
    struct WhichN;
}
