//! The adversary: a search for the case in which a statement is tightest.
//!
//! A [`Family`] is a box of parameters (of a metric, of two sets or a point sequence, and `N`) with
//! a function that maps each point of the box to the [`Evidence`](tautline_statements::Evidence)
//! for one statement. A [`Search`] minimises the overestimation. Several times, it samples cases at
//! random and then searches locally, without derivatives. The result is an upper bound on the least
//! overestimation of the statement, with the case that shows it. If a conclusion fails on the way,
//! the search returns an error.
//!
//! If the tightest case lies at an [`Edge`] of its box, the edge gives the reason. Either no case
//! lies beyond, or the range ends near a limit; then the search measures what is left on the way to
//! it.
//!
//! ```
//! use tautline_checks::adversary::{Search, families};
//! use tautline_statements::{LIBRARY, Source};
//!
//! // Proposition 7.9 is attained by a step over the valley of a tent, and the search finds it.
//! let families = families(&LIBRARY);
//! let tent = families.iter().find(|family| family.is("Proposition 7.9", "tent"));
//! let found = Search::default().tightest(tent.expect("listed"), Source::Stated)?;
//! assert!(found.is_some_and(|tightest| tightest.overestimation < 1.01));
//! # Ok::<(), tautline_checks::adversary::AdversaryError>(())
//! ```

mod adversary_error;
mod edge;
mod families;
mod family;
mod parameter;
mod search;
mod split_mix;
mod tightest;

pub use adversary_error::AdversaryError;
pub use edge::{Beyond, Edge, End};
pub use families::families;
pub use family::Family;
pub use parameter::Parameter;
pub use search::Search;
pub use split_mix::SplitMix;
pub use tightest::Tightest;
