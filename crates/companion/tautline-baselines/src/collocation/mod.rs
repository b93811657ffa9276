//! Geodesics by collocation: the geodesic equation as a two-point boundary value problem.
//!
//! ```
//! use tautline::{Ends, KnownDistance, gallery::Shear};
//! use tautline_baselines::collocation::{Collocation, collocate};
//!
//! let shear = Shear::new(0.5, 1.0)?;
//! let (x, y) = ([0.0, 0.0], [2.0, 3.0]);
//! let found = collocate(&shear, &Ends::points(x, y)?, &Collocation::default())?;
//! let d = shear.distance(&x.into(), &y.into()).expect("always known");
//! assert!((found.length / d - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! The method finds a geodesic near its start, which need not be minimal.

mod collocate;
mod collocation_error;
mod gauss;
mod path;
mod system;

use tautline::PointSequence;

pub use collocate::{Collocated, collocate};
pub use collocation_error::CollocationError;
pub use path::Path;

/// Options of [`collocate`].
#[derive(Clone, Debug, PartialEq)]
pub struct Collocation<const D: usize> {
    /// The largest residual of the geodesic equation, relative to the speed, from `10⁻¹⁰` to
    /// `10⁻¹`. At a minimum the energy is stationary, so that its relative error is of the size of
    /// the square of this number.
    pub tolerance: f64,
    /// The number of intervals of the first mesh, at least 1.
    pub intervals: usize,
    /// The largest number of intervals of a mesh.
    pub most_intervals: usize,
    /// The largest number of Newton steps on one mesh.
    pub iterations: usize,
    /// The curve from which Newton's method starts; a straight line between nearby points of the
    /// sets if there is none. Its ends are replaced by the nearest points of the sets.
    pub start: Option<PointSequence<D>>,
}

impl<const D: usize> Default for Collocation<D> {
    /// Returns the tolerance `10⁻⁶`, 16 intervals at first and 4096 at most, 100 steps, and a start
    /// from a straight line.
    fn default() -> Self {
        Self { tolerance: 1e-6, intervals: 16, most_intervals: 4096, iterations: 100, start: None }
    }
}
