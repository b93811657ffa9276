//! A gallery of metrics: one a file, each with its formula, its constants in closed form
//! and, where known, its exact distance.
//!
//! | metric | `D` | `H(x)` | constants | distance |
//! | --- | --- | --- | --- | --- |
//! | [`Constant`] | any | `A` | exact | all pairs |
//! | [`Valleys`] | any | `(2 − cos x₁)² I` | exact | most pairs |
//! | [`Ramp`] | 1 | `(1 + a tanh kx)²` | exact but `M_H` | all pairs |
//! | [`Separable`] | any | `diag((1 + aᵢ sin kᵢxᵢ)²)` | exact | all pairs |
//! | [`Shear`] | 2 | `JᵀJ` of `(x₁ + a sin kx₂, x₂)` | exact | all pairs |
//! | [`Lens`] | any | `(1 + a e^{−r²/2s²}) I` | exact | on rays |
//! | [`Bump`] | any | `(1 + a e^{−r²/2s²})² I` | exact but `L_H` | on rays |
//! | [`Hill`] | any | `I + ∇f ∇fᵀ`, `f = h e^{−r²/2s²}` | exact | on rays |
//! | [`SoftObstacles`] | any | `(1 + Σ aᵢ e^{−rᵢ²/2sᵢ²}) I` | bounds | |
//! | [`Swirl`] | 2 | `JᵀJ` of `R(α e^{−r²/2s²}) x` | exact but `L_H`, `M_H` | all pairs |
//! | [`EggCrate`] | 2 | `I + ∇f ∇fᵀ`, `f = a (sin kx₁ + sin kx₂)` | exact | on lines |
//! | [`Corrugated`] | any | `I + f′² e₁e₁ᵀ`, `f = a sin kx₁` | exact | all pairs |
//! | [`Checkerboard`] | 2 | `(1 + a sin²(πx₁/e) sin²(πx₂/e)) I` | exact | on grid lines |
//! | [`TwoChannels`] | 2 | `(1 + a Π (1 − e^{−(x₂ ∓ b)²/2s²})) I` | exact but `L_H`, `M_H` | many pairs |
//! | [`RotatingAnisotropy`] | 2 | `Q(k·x) diag(λ₁, λ₂) Q(k·x)ᵀ` | exact | |
//! | [`TwoLinkArm`] | 2 | kinetic energy of a robot arm | exact | |
//! | [`CoupledCosines`] | 3 | `diag + ⅖ cos(xᵢ − xⱼ) / (1 + ∣i − j∣)` | exact but `M_H` | |
//! | [`SineProjections`] | any | `I + ½ Σ sin²(wₖ·x) aₖ aₖᵀ` | bounds | |
//! | [`Sphere`] | any | `4 / (1 + r²)² I` | on balls | all pairs |
//! | [`Hyperbolic`] | any | `4 / (1 − r²)² I` in the unit ball | on balls | in the ball |
//! | [`GaussianFisher`] | 2 | `diag(e^{−2t}, 2)` | on balls | all pairs |
//! | [`SpherePatch`] | any | `4 / (1 + r²)² I`, `r ≤ R` | exact | in the patch |
//! | [`HyperbolicPatch`] | any | `4 / (1 − r²)² I`, `r ≤ R` | exact | in the patch |
//! | [`GaussianFisherPatch`] | 2 | `diag(e^{−2t}, 2)`, `∣t∣ ≤ T` | exact | in the strip |
//! | [`TanhDecoder`] | any | `JᵀJ + μ I` of `W₂ tanh(W₁ x)` | bounds | |
//!
//! *Exact* constants are the best ones: no smaller `c₂`, `L_H`, `M_H` and no larger `c₁` holds
//! on all of `R^D`. The others are bounds that hold as well. Three metrics have none there, but on
//! every ball inside of their domain, as [`LocallyBounded`](crate::LocallyBounded) says.
//!
//! The three with an `R` or a `T` are patches: beyond it they pass to a constant matrix, which
//! gives them constants on all of `R^D`, *exact* up to `2 · 10⁻³` for `L_H` and `M_H`. A distance
//! is known where the geodesic stays.
//!
//! Parameters are checked by the constructors, so that a metric which exists is one.

mod bump;
mod checkerboard;
mod clairaut;
mod constant;
mod corrugated;
mod coupled_cosines;
mod egg_crate;
mod eigenvalues;
mod error;
mod gaussian_fisher;
mod gaussian_fisher_patch;
mod hill;
mod hyperbolic;
mod hyperbolic_patch;
mod lens;
mod radial;
mod ramp;
mod rotating_anisotropy;
mod saturation;
mod separable;
mod shear;
mod sine_projections;
mod soft_obstacles;
mod sphere;
mod sphere_patch;
mod swirl;
mod tanh_decoder;
mod two_channels;
mod two_link_arm;
mod valleys;

pub use bump::Bump;
pub use checkerboard::Checkerboard;
pub use constant::Constant;
pub use corrugated::Corrugated;
pub use coupled_cosines::CoupledCosines;
pub use egg_crate::EggCrate;
pub use error::GalleryError;
pub use gaussian_fisher::GaussianFisher;
pub use gaussian_fisher_patch::GaussianFisherPatch;
pub use hill::Hill;
pub use hyperbolic::Hyperbolic;
pub use hyperbolic_patch::HyperbolicPatch;
pub use lens::Lens;
pub use ramp::Ramp;
pub use rotating_anisotropy::RotatingAnisotropy;
pub use separable::Separable;
pub use shear::Shear;
pub use sine_projections::{SineProjection, SineProjections};
pub use soft_obstacles::{Obstacle, SoftObstacles};
pub use sphere::Sphere;
pub use sphere_patch::SpherePatch;
pub use swirl::Swirl;
pub use tanh_decoder::TanhDecoder;
pub use two_channels::TwoChannels;
pub use two_link_arm::{Link, TwoLinkArm};
pub use valleys::Valleys;
