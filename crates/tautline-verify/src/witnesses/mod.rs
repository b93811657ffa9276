//! Witnesses: metrics and curves on which the statements come near equality.

mod claiming;
mod corrugated;
mod incline;
mod one_step;
mod tent;
mod two_routes;
mod valley_jump;

pub use claiming::Claiming;
pub use corrugated::Corrugated;
pub use incline::Incline;
pub use one_step::one_step;
pub use tent::Tent;
pub use two_routes::{Profile, TwoRoutes};
pub use valley_jump::valley_jump;
