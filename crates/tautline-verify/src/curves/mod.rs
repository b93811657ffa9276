//! Curves on `[0, 1]` with their velocity and acceleration: geodesics, and reparametrised ones.

mod ball_model;
mod geodesic;
mod great_circle;
mod measured;
mod motion;
mod reparametrisation;
mod segment;

pub use geodesic::{Geodesic, KnownGeodesics};
pub use measured::Measured;
pub(crate) use motion::largest;
pub use motion::{Curve, Motion, Residual};
pub use reparametrisation::{Clock, Pace, Reparametrised};
pub use segment::EvenSegment;
