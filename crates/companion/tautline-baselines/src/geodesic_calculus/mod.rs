//! The discrete geodesic calculus of Rumpf and Wirth, on the midpoint rule.
//!
//! Everything follows from the energy of a chord,
//!
//! ```text
//! W[x, y] = (y − x)ᵀ H((x + y)/2) (y − x)
//! ```
//!
//! A sequence is a discrete geodesic if the sum of `W` over its chords is stationary. The first
//! chord of a discrete geodesic is the [discrete logarithm](discrete_logarithm), its continuation
//! the [discrete exponential](discrete_exponential); geodesic parallelograms give the
//! [parallel transport](parallel_transport) (M. Rumpf, B. Wirth, Variational time discretization of
//! geodesic calculus, IMA J. Numer. Anal. 35 (2015)).
//!
//! | what | error |
//! | --- | --- |
//! | points of a discrete geodesic | `O(1/N²)` |
//! | discrete logarithm, discrete exponential | `O(1/N)` |
//! | parallel transport along a sampled curve | `O(1/N)` |
//!
//! ```
//! use tautline::gallery::Shear;
//! use tautline_baselines::geodesic_calculus::{discrete_exponential, discrete_logarithm};
//!
//! let shear = Shear::new(0.5, 1.0)?;
//! let (x, y) = ([0.0, 0.0].into(), [2.0, 3.0].into());
//! let v = discrete_logarithm(&shear, &x, &y, 16)?;
//! let back = discrete_exponential(&shear, &x, &v, 16)?;
//! assert!((back.last() - y).norm() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod calculus_error;
mod chord;
mod discrete_maps;
mod step;
mod transport;

pub use calculus_error::CalculusError;
pub use discrete_maps::{discrete_exponential, discrete_geodesic, discrete_logarithm};
pub use step::{extend, midpoint};
pub use transport::parallel_transport;
