//! Shortest curves between two closed sets, under a metric that you write as one formula.
//!
//! A taut line between two bodies is a shortest curve. Given the metric `H(x)` and the closed
//! sets `X⁽⁰⁾`, `X⁽¹⁾` of `R^D`, one of them bounded, Tautline minimises a discretisation of
//! the energy `E(γ) = ∫ γ̇ᵀ H(γ) γ̇ dt`, whose minimum is the square of the distance, joins
//! the points up, and says by proven bounds how wrong the result can be.
//!
//! ```
//! use tautline::{Ball, Ends, HalfSpace, Metric, Problem, SMatrix, SVector, Scalar, Trapezoidal};
//!
//! struct Valleys; // f² I with f = 2 − cos x₁
//! impl Metric<2> for Valleys {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal_element((2.0 - x[0].cos()).sqr())
//!     }
//! }
//!
//! let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::new([-1.0, 0.0], -3.0)?)?;
//! let line = Problem::new(Valleys, ends).solve(Trapezoidal, 256)?;
//! assert!((line.length().value - 5.338305).abs() < 1e-6); // 5 − sin 3 + sin ½
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A formula reads as in mathematics, with `f64` on either side: `2.0 - x`, `2.0 / x`, `2.0 * x`,
//! `1.0 + x`. What else it may use is on the page of [`Scalar`].
//!
//! # By question
//!
//! | you want | example |
//! | --- | --- |
//! | the distance of two points | `examples/two_points.rs` |
//! | the shortest way between two bodies | `examples/two_sets.rs` |
//! | the distances among many points, on all threads | `examples/many_pairs.rs` |
//! | a metric of your own, with bounds | `examples/my_own_metric.rs` |
//! | the distance of two normal distributions, whose metric has no constants on all of the plane | `examples/normal_distributions.rs` |
//!
//! # What is computed and what is proven
//!
//! | number | is |
//! | --- | --- |
//! | [`TautLine::energy`], [`TautLine::length`] | of an actual curve between the sets, hence upper bounds of `d²` and `d`, up to a quadrature error, which is estimated |
//! | [`TautLine::discrete_energy`] | may lie on either side of `d²` |
//! | [`TautLine::distance_squared_estimate`] | extrapolated: an estimate, not a bound |
//! | [`TautLine::enclosure`], [`TautLine::enclosure_among`] | `d²` between two bounds by theorems, up to an estimated quadrature error, and whether a global minimum had to be assumed (between sets always) |
//! | [`TautLine::prove`] | the same with constants that are proved from the formula, and the upper bound with outward rounding |
//! | [`leading_constants`] | limits of the errors times `N` or `N²` on smooth data: computed, not proven |
//! | [`bounds`] | proven, for global minimisers of the discrete energy |
//!
//! A solver finds local minimisers. [`TautLine::minimum`] tells how it was found and what the
//! Hessian says; that no other curve is shorter is not claimed.
//!
//! # Conventions
//!
//! No factor `½` in any energy, `E ≥ L²`, `min E = d²`. Time runs over `[0, 1]`. The paper's
//! *trapezoidal* rule reads the metric at the middle of each chord and is called the midpoint
//! rule elsewhere.

mod batch;
mod certificate;
mod competitors;
mod problem;
mod proof;
mod taut_line;

pub use batch::solve_all;
pub use certificate::{RuleOfThePaper, SuggestedN};
pub use competitors::Competitors;
pub use problem::Problem;
pub use proof::{Proof, ProofError};
pub use taut_line::TautLine;

pub use tautline_bounds as bounds;
pub use tautline_certify::{
    self as certify, AdmissibleCurve, Certified, CertifiedConstant, CertifiedConstants,
    CertifyError, CurveError, Domain, LocallyCertified, Polygon, Quantity,
};
pub use tautline_discretizations::{
    Integral, Interpolation, LARGEST_N, LeftEndpoint, Node, PointSequence, Rule, SequenceError,
    Trapezoidal, TrueTrapezoid, energy_gradient,
};
pub use tautline_formula::{
    self as formula, AnyMetric, Batch, Batches, Formula, Kind, Plain, Prepared, RecordError,
    TextError,
};
pub use tautline_metrics::{
    Bounded, Constants, HypothesisError, KnownDistance, LocalError, LocallyBounded, Metric,
    MetricError, check_gram, christoffel, composition, gallery, norm_squared, quadrature,
};
pub use tautline_optimizers::{
    AsymptoticsError, Curvature, Estimate, LeadingConstants, Level, Minimum, NewtonStep, Options,
    SolveError, Starts, Stop, Workspace, extrapolate, leading_constants, minimise,
    minimise_by_batches, minimise_in, newton_step,
};
pub use tautline_scalar::{FastInterval, Interval, Jet1, Jet2, Scalar};
pub use tautline_sets::{
    AffineSubspace, AxisBox, Ball, ClosedSet, Ends, FiniteSet, HalfSpace, Point, Segment, SetError,
    Sphere, Union,
};

pub use nalgebra::{SMatrix, SVector};

/// The example of the README, as a test.
#[cfg(doctest)]
#[doc = include_str!("../../../README.md")]
struct Readme;
