//! Every statement of the paper as one function, with its evidence.
//!
//! A statement is evaluated on a case, and returns [`Evidence`]: the hypotheses that could be
//! checked and those that are assumed, and its inequalities, each with the number that was observed
//! and its bound.
//!
//! ```
//! use tautline::{PointSequence, gallery::Valleys};
//! use tautline_statements::{Finding, LIBRARY, prop_7_9};
//!
//! // |E(γᵖˡ) − E_tra,N| ≤ L_H K₃³ / 4√N for four points over a ridge
//! let sequence = PointSequence::straight([0.0, 0.0], [6.0, 1.0], 3)?;
//! let evidence = prop_7_9(&LIBRARY, &Valleys, &sequence)?;
//! assert_eq!(evidence.finding(), Finding::Holds);
//! assert!(evidence.slack() > 1.0);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod catalogue;
pub mod curves;
mod errata;
mod evidence;
mod gram_range;
mod inequality;
mod known;
mod mutants;
mod reconstruction;
mod slope;
mod statement;
mod statements;
mod subject;
mod units;
mod verdict;
mod verify_error;
mod with_constants;
pub mod witnesses;

pub use errata::{Erratum, errata};
pub use evidence::{Evidence, Finding};
pub use gram_range::{GramRange, extreme_eigenvalues, operator_norm};
pub use inequality::{Inequality, Source, Unit};
pub use known::Known;
pub use mutants::Mutant;
pub use reconstruction::{Reconstruction, curvature_along, discrete_energy, mean_power, nodes};
pub use slope::slope;
pub use statement::Statement;
pub use statements::*;
pub use subject::{Asked, Bounds, LIBRARY, Subject};
pub use tautline::bounds::PaperRule;
pub use units::{InUnits, Units};
pub use verdict::Verdict;
pub use verify_error::VerifyError;
pub use with_constants::{AnyBounded, WithConstants};
