//! Geodesics by shooting: the geodesic equation as an initial value problem.
//!
//! [`exponential`] follows a geodesic from a point; [`shoot`] looks for one from set to set by
//! Newton's method; [`logarithm`] is the initial velocity of a shot from point to point.
//!
//! ```
//! use tautline::{Ends, KnownDistance, gallery::Shear};
//! use tautline_baselines::shooting::{Shooting, shoot};
//!
//! let shear = Shear::new(0.5, 1.0)?;
//! let (x, y) = ([0.0, 0.0], [2.0, 3.0]);
//! let shot = shoot(&shear, &Ends::points(x, y)?, &Shooting::default())?;
//! let d = shear.distance(&x.into(), &y.into()).expect("always known");
//! assert!((shot.geodesic.length() / d - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! A shot satisfies the necessary condition of a minimum and no more: it may be longer than other
//! geodesics, even if Newton's method converges. Over long distances it depends on its initial
//! velocity exponentially, and a start from the straight line may fail.

mod exponential;
mod flow;
mod geodesic;
mod shoot;
mod shooting_error;

use nalgebra::SVector;

pub use exponential::exponential;
pub use geodesic::Geodesic;
pub use shoot::{Shot, logarithm, shoot};
pub use shooting_error::ShootingError;

/// Options of the integration of the geodesic equation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Integration {
    /// The error of a step relative to the speed, from `10⁻¹⁴` to `10⁻²`.
    pub tolerance: f64,
    /// The largest number of steps, with those that are refused.
    pub steps: usize,
}

impl Default for Integration {
    /// Returns the tolerance `10⁻¹²` and 10 000 steps.
    fn default() -> Self {
        Self { tolerance: 1e-12, steps: 10_000 }
    }
}

/// Options of [`shoot`].
#[derive(Clone, Debug, PartialEq)]
pub struct Shooting<const D: usize> {
    /// How the equation is integrated.
    pub integration: Integration,
    /// The largest number of Newton steps.
    pub iterations: usize,
    /// The velocity of the first shot, in `ℓ`; that of a straight line if there is none.
    pub velocity: Option<SVector<f64, D>>,
}

impl<const D: usize> Default for Shooting<D> {
    /// Returns the default integration, 50 steps, and a start from a straight line.
    fn default() -> Self {
        Self { integration: Integration::default(), iterations: 50, velocity: None }
    }
}
