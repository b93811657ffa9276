//! Random cases for quickcheck: data of the algebraic lemmas, settings of Theorem 1.1, and
//! constants of metrics.
//!
//! Each is a newtype over small integers, so that quickcheck shrinks to the simplest numbers that
//! still fail. Every case, drawn or shrunk, meets its hypotheses.

mod any_constants;
mod any_setting;
mod nonnegatives;
mod two_forms;

pub use any_constants::AnyConstants;
pub use any_setting::AnySetting;
pub use nonnegatives::Nonnegatives;
pub use two_forms::AnyTwoForms;
