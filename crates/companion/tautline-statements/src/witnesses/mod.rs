//! Witnesses: metrics and curves for which a statement is near equality, or fails without a
//! hypothesis.

mod incline;
mod incline_geodesic;
mod one_step;
mod polygonal;
mod ripple;
mod tent;
mod twist;
mod two_routes;
mod valley_jump;
mod washboard;
mod zigzag;

pub use incline::Incline;
pub use incline_geodesic::InclineGeodesic;
pub use one_step::one_step;
pub use polygonal::Polygonal;
pub use ripple::Ripple;
pub use tent::tent;
pub use twist::Twist;
pub use two_routes::two_routes;
pub use valley_jump::valley_jump;
pub use washboard::Washboard;
pub use zigzag::Zigzag;
