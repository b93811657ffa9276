//! Witnesses: metrics and curves on which the statements come near equality.

mod incline;
mod one_step;
mod tent;

pub use incline::Incline;
pub use one_step::one_step;
pub use tent::Tent;
