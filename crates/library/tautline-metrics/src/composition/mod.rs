//! Metrics built from other metrics.
//!
//! | metric | on | `H` | constants by | distance |
//! | --- | --- | --- | --- | --- |
//! | [`Scaled`] | `R^D` | `s H(x)` | [`Constants::scaled`] | `√s d` |
//! | [`Sum`] | `R^D` | `H(x) + H′(x)` | [`Constants::plus`] | |
//! | [`Product`] | `R^{D₁ + D₂}` | `diag(H(x), H′(y))` | [`Constants::beside`] | `√(d² + d′²)` |
//! | [`AffinePullback`] | `R^D` | `Aᵀ H(A x + b) A` | [`Constants::pulled_back`] | of the images |
//!
//! Each composition is [`Bounded`] if its parts are. Except for the sum, it knows its distance if
//! its parts do.
//!
//! ```
//! use nalgebra::{matrix, vector};
//! use tautline_metrics::{
//!     Bounded, KnownDistance,
//!     composition::{AffinePullback, Product},
//!     gallery::{Ramp, Shear},
//! };
//!
//! // A ramp in a doubled coordinate, and a shear of the plane.
//! let ramp = Ramp::new(0.5, 1.0)?;
//! let shear = Shear::new(0.5, 1.0)?;
//! let twice = AffinePullback::new(ramp, matrix![2.0], [0.0])?;
//! let product: Product<_, _, 1, 2> = Product::new(twice, shear);
//!
//! let (x, y) = (vector![0.0, 0.0, 0.0], vector![1.0, 2.0, 3.0]);
//! let d = product.distance(&x, &y).expect("both are known for all pairs");
//! let parts = [
//!     ramp.distance(&vector![0.0], &vector![2.0]).expect("all pairs"),
//!     shear.distance(&vector![0.0, 0.0], &vector![2.0, 3.0]).expect("all pairs"),
//! ];
//! assert_eq!(d, parts[0].hypot(parts[1]));
//! assert!(Bounded::<3>::constants(&product).c2() >= 4.0 * ramp.constants().c2());
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Bounded`]: crate::Bounded
//! [`Constants::scaled`]: crate::Constants::scaled
//! [`Constants::plus`]: crate::Constants::plus
//! [`Constants::beside`]: crate::Constants::beside
//! [`Constants::pulled_back`]: crate::Constants::pulled_back

mod affine_pullback;
mod error;
mod product;
mod scaled;
mod sum;

pub use affine_pullback::AffinePullback;
pub use error::CompositionError;
pub use product::Product;
pub use scaled::Scaled;
pub use sum::Sum;
