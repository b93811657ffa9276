//! Witnesses: metrics and curves on which the statements come near equality.

mod incline;
mod one_step;
mod tent;
mod two_routes;

pub use incline::Incline;
pub use one_step::one_step;
pub use tent::Tent;
pub use two_routes::TwoRoutes;
