//! Witnesses: metrics and curves on which the statements come near equality.

mod claimed;
mod incline;
mod one_step;
mod polygonal;
mod tent;
mod washboard;

pub use claimed::Claimed;
pub use incline::Incline;
pub use one_step::one_step;
pub use polygonal::Polygonal;
pub use tent::Tent;
pub use washboard::Washboard;
