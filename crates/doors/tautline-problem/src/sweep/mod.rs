//! Sweeps: tables of problems that differ in parameters, solved block by block and merged.
//!
//! A sweep file is a problem file with a section `[sweep]`, which says what varies. From it follow the
//! problems, numbered by ids from 0, so that any process can solve any block of them, and needs nothing
//! but the file. The blocks merge to the same bytes, however many there were, on however many threads.
//!
//! ```
//! use tautline_problem::sweep::{Block, Plan, Runner, Shard, merged};
//!
//! let plan = Plan::read(r#"
//!     [parameters]
//!     height = 1
//!     y = 0
//!     [metric]
//!     cost = "1 + height*exp(-(x1^2 + x2^2))"
//!     [from]
//!     point = [-2, "y"]
//!     [to]
//!     point = [2, 0]
//!     [solve]
//!     n = 32
//!     [sweep.vary]
//!     height = [0.5, 1]
//!     y = { from = -1, to = 1, count = 5 }
//! "#)?;
//! assert_eq!((plan.count(), plan.row(7)), (10, vec![1.0, 0.0]));
//!
//! let runner = Runner::new(&plan, 1)?;
//! let first = runner.solved(Shard::new(1, 2)?.ids(plan.count()))?;
//! let second = runner.solved(Shard::new(2, 2)?.ids(plan.count()))?;
//! let blocks = [Block::read(&second)?, Block::read(&first)?];
//! assert_eq!(merged(&blocks)?, runner.solved(0..10)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! | file | holds |
//! | --- | --- |
//! | a plan | the sweep file, its hash, and the parameters of each problem |
//! | a block of results | the hash of the plan, the ids, a row for each problem, and a hash of all this |

mod block;
mod block_error;
mod block_writer;
mod draw;
mod hash;
mod line_ends;
mod merge;
mod merge_error;
mod plan;
mod plan_error;
mod result_row;
mod runner;
mod shard;
mod table;
mod varied;

pub use block::{Block, Head};
pub use block_error::BlockError;
pub use block_writer::BlockWriter;
pub use line_ends::plain;
pub use merge::{in_order, merged};
pub use merge_error::MergeError;
pub use plan::Plan;
pub use plan_error::PlanError;
pub use runner::{Rows, Runner};
pub use shard::{Shard, ShardError};
pub use table::TableHead;
pub use varied::{Axis, Sweep, Values};
