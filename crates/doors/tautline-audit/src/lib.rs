//! Audits the metric of a problem file: every law of the kit, in the dimension of the file.
//!
//! The metric is typed, not compiled, and so may its constants be wrong. The audit names each false
//! claim with the point, the direction and both numbers.
//!
//! ```
//! use tautline_audit::{Effort, Verdict, audit};
//! use tautline_problem::Question;
//!
//! let file = r#"
//!     dimension = 2
//!     [metric]
//!     cost = "2 - cos(x1)"
//!     [certify.constants]
//!     c1 = 1
//!     c2 = 9
//!     l_h = 4    # the best constant is 4.4037
//! "#;
//! let audit = audit(&Question::read(file)?, Effort::default())?;
//! assert_eq!(audit.verdict, Verdict::Lies);
//! assert_eq!(audit.lies[0].about, "L_H");
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod answer;
mod constants;
mod document;
mod effort;
mod laws;
mod lies;
mod markdown;
mod region;
mod run;
mod text;
mod timed;
mod typed;
mod words;

pub use answer::{Audit, Law, Lie, Measured, Place, Standing, Status, Verdict};
pub use document::{Document, audit_schema};
pub use effort::Effort;
pub use markdown::markdown;
pub use text::text;
pub use timed::{AuditError, audit};
