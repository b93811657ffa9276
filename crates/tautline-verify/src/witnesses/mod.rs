//! Witnesses: metrics and curves on which the statements come near equality.

mod claimed;
mod incline;
mod incline_geodesic;
mod one_step;
mod ripple;
mod tent;
mod twist;
mod zigzag;

pub use claimed::Claimed;
pub use incline::Incline;
pub use incline_geodesic::InclineGeodesic;
pub use one_step::one_step;
pub use ripple::Ripple;
pub use tent::Tent;
pub use twist::Twist;
pub use zigzag::Zigzag;
