//! Curves on `[0, 1]`, with their lengths, energies and norms. Each curve has a velocity and an
//! acceleration; it is smooth, kinked, reparametrised or a geodesic.
//!
//! ```
//! use tautline_statements::{Finding, curves::SmoothCurve, prop_7_3, prop_7_3_as_printed};
//!
//! // γ(t) = t on [0, ¼]: the printed proposition claims ¼ ≤ ⅛.
//! let line = SmoothCurve::straight([0.0], [1.0]);
//! let printed = prop_7_3_as_printed(&line, [0.0, 0.25])?;
//! assert!(matches!(printed.finding(), Finding::Violated(_)));
//! assert_eq!(prop_7_3(&line, [0.0, 0.25])?.finding(), Finding::Holds);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod ball_model;
mod curve;
mod curve_energy;
mod curve_in_units;
mod geodesic;
mod great_circle;
mod kinked_curve;
mod l2_norm;
mod measured;
mod motion;
mod reparametrisation;
mod segment;
mod smooth_curve;

pub use curve::{BoundedCurve, Curve};
pub use curve_energy::curve_energy;
pub use curve_in_units::CurveInUnits;
pub use geodesic::{Geodesic, KnownGeodesics};
pub use kinked_curve::KinkedCurve;
pub use l2_norm::l2_norm;
pub use measured::Measured;
pub(crate) use motion::largest;
pub use motion::{Motion, Residual};
pub use reparametrisation::{Clock, Pace, Reparametrised};
pub use segment::EvenSegment;
pub use smooth_curve::SmoothCurve;
