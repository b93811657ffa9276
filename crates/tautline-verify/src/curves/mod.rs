//! Curves over `[0, 1]` with their first two derivatives, and their norms in `L²`.

mod curve;
mod curve_energy;
mod curve_in_units;
mod flat_geodesic;
mod kinked_curve;
mod l2_norm;
mod smooth_curve;

pub use curve::Curve;
pub use curve_energy::curve_energy;
pub use curve_in_units::CurveInUnits;
pub use flat_geodesic::FlatGeodesic;
pub use kinked_curve::KinkedCurve;
pub use l2_norm::l2_norm;
pub use smooth_curve::SmoothCurve;
