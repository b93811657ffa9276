//! Formulas of metrics as data.
//!
//! A metric is written as one formula, a function that is generic in its numbers. Evaluated once in a
//! number that writes down what it is asked for, the function becomes a list of operations: a [`Formula`],
//! which can be compared, hashed, sent, printed, and evaluated in any numbers again, to the same bits.
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

mod batch;
mod formula;
mod functions;
mod graph;
mod operation;
mod program;
mod record_error;
mod recording;
mod text;

pub use batch::{Batch, Batches, Inputs, Kind, Layout, Plain, Prepared};
pub use formula::Formula;
pub use operation::{Arithmetic, Function, Number, Operation, Pair, Step};
pub use program::{InstructionSet, Register, Registers, WIDTH};
pub use record_error::RecordError;
pub use text::{Problem, TextError};

/// The most steps of a formula: a million. More are a loop that was not meant to be unrolled.
pub const LONGEST: usize = 1 << 20;
