//! Random cases for quickcheck: the data of the algebraic lemmas, settings of Theorem 1.1, and the
//! constants of metrics.
//!
//! Each is a newtype over small integers, so that quickcheck's own shrinking of these ends in the
//! simplest numbers that still fail; every case that is drawn or shrunk meets its hypotheses.

mod any_constants;
mod any_setting;
mod nonnegatives;
mod two_forms;

pub use any_constants::AnyConstants;
pub use any_setting::AnySetting;
pub use nonnegatives::Nonnegatives;
pub use two_forms::AnyTwoForms;
