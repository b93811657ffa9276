//! Formulas of metrics as data, and metrics evaluated at many places at once.
//!
//! A metric is a function that is generic in its number type. Evaluated once in a number type that
//! records its operations, it becomes a list of operations, a [`Formula`]. A formula can be
//! compared, hashed, sent and printed, and evaluated in any number type, where it gives the same
//! bits as the metric.
//!
//! ```
//! use nalgebra::{SMatrix, SVector, vector};
//! use tautline_formula::Formula;
//! use tautline_metrics::{Metric, Scalar};
//!
//! struct Wave;
//! impl Metric<2> for Wave {
//!     fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
//!         SMatrix::from_diagonal_element(2.0 + x[0].sin() * x[1].cos())
//!     }
//! }
//! let formula = Formula::record(&Wave)?;
//! let x = vector![0.3, -1.2];
//! assert_eq!(formula.gram(&x), Wave.gram(&x));
//! assert_eq!(formula, Formula::record(&formula)?);
//! # Ok::<(), tautline_formula::RecordError>(())
//! ```
//!
//! A search needs `H` and its derivatives along thousands of chords. [`Prepared`] derives a program
//! from the formula and runs it over a [`Batch`] of chords, which is faster than calling the
//! compiled metric. If the formula cannot be recorded, the compiled metric is called instead,
//! behind the same interface ([`Plain`]).
//!
//! ```
//! use nalgebra::vector;
//! use tautline_formula::{Batch, Formula, Kind, Prepared};
//!
//! let formula = Formula::<2>::parse("phi = 2 - cos(x1); [phi^2, 0; 0, phi^2]", &[])?;
//! let metric = Prepared::new(formula);
//! let mut batch = Batch::new(&metric, Kind::Square, 1, 2);
//! let mut places = batch.inputs(2);
//! places.set(0, &vector![0.0, 0.0], &vector![1.0, 0.0]);
//! places.set(1, &vector![std::f64::consts::PI, 0.0], &vector![1.0, 2.0]);
//! batch.evaluate(2);
//! let square = batch.layout().square[0];
//! // dᵀHd: φ = 1 where x₁ is 0, and 3 where it is π.
//! assert_eq!(batch.row(square)[..2], [1.0, 45.0]);
//! # Ok::<(), tautline_formula::TextError>(())
//! ```
//!
//! A cost that was measured is an array: a [`spline`] makes it a function that formulas call.

mod any_metric;
mod batch;
mod black_box;
mod formula;
mod functions;
mod graph;
mod operation;
mod program;
mod record_error;
mod recording;
pub mod spline;
mod text;

pub use any_metric::AnyMetric;
pub use batch::{
    AnyBatches, Batch, Batches, BatchesIn, Inputs, Kind, Known, Layout, Plain, Prepare, Prepared,
    PreparedFormula,
};
pub use black_box::{BlackBox, BlackBoxBatches, Values};
pub use formula::Formula;
pub use operation::{Arithmetic, Function, Number, Operation, Pair, Step, Tabulation};
pub use program::{InstructionSet, Register, Registers, WIDTH};
pub use record_error::RecordError;
pub use text::{
    Form, Part, Problem, TextError, Weight, Written, WrittenError, number, probably_meant,
};

/// The largest number of steps of a formula, a million. A longer formula comes from a loop that
/// nobody meant to unroll.
pub const LONGEST: usize = 1 << 20;
