//! A gallery of metrics, one per file. Each has its formula, its constants in closed form and,
//! where it is known, its exact distance.
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
//! *Exact* constants are the best ones: no smaller `c₂`, `L_H`, `M_H` and no larger `c₁` holds on
//! all of `R^D`. Three of the metrics have constants only on balls inside their domain
//! ([`LocallyBounded`](crate::LocallyBounded)).
//!
//! The three metrics with an `R` or a `T` are patches of these. Beyond the rim they become
//! constant, which gives them constants on all of `R^D`, *exact* up to `2 · 10⁻³` for `L_H` and
//! `M_H`. A distance is known if the geodesic stays in the patch.
//!
//! Constructors check the parameters, so every value is a metric. To add a metric, write its file,
//! its lines here, and a sample in [`for_each_sample`]. The tests of the gallery and the table of
//! proved constants then include it.

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

pub use crate::for_each_sample;
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

/// Passes the samples to the macro `$each`: every metric of the gallery that has constants on all
/// of `R^D`, with parameters. Tests and tables of the whole gallery are generated from this list.
///
/// A sample consists of an identifier, the name in tables, the `Result` of a constructor, the
/// dimension, a cell in which the constants are attained or nearly attained (a period, or six
/// widths to each side, where a Gaussian is below `10⁻⁷`), and which of `c₁`, `c₂`, `L_H`, `M_H`
/// are exact. It ends with `with distances` if the metric is a
/// [`KnownDistance`](crate::KnownDistance). The caller imports the gallery:
///
/// ```
/// use tautline_metrics::gallery::*;
///
/// macro_rules! names {
///     ($($id:ident: $name:literal, $metric:expr, dimension $D:literal, in [$low:expr, $high:expr],
///        exact $exact:expr $(, with $distances:ident)?;)*) => { [$(($name, $D)),*] };
/// }
/// assert_eq!(for_each_sample!(names)[0], ("constant", 2));
/// ```
#[macro_export]
macro_rules! for_each_sample {
    ($each:ident) => {
        $each! {
            a_constant_matrix: "constant", Constant::<2>::new([[2.0, 1.0], [1.0, 2.0]].into()),
                dimension 2, in [[-2.0; 2], [2.0; 2]], exact [false, false, true, true],
                with distances;
            valleys_on_a_line: "valleys", Ok::<_, GalleryError>(Valleys),
                dimension 1, in [[0.0], [std::f64::consts::TAU]], exact [true; 4], with distances;
            valleys: "valleys", Ok::<_, GalleryError>(Valleys),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [true; 4],
                with distances;
            valleys_in_space: "valleys", Ok::<_, GalleryError>(Valleys),
                dimension 3, in [[0.0; 3], [std::f64::consts::TAU; 3]], exact [true; 4],
                with distances;
            a_ramp: "ramp", Ramp::new(0.5, 1.0),
                dimension 1, in [[-8.0], [8.0]], exact [true, true, true, false], with distances;
            a_separable_metric: "separable", Separable::<2>::new([0.3, 0.5], [1.0, 2.0]),
                dimension 2, in [[-3.2; 2], [3.2; 2]], exact [true; 4], with distances;
            a_shear: "shear", Shear::new(0.5, 1.0),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [true; 4],
                with distances;
            a_lens: "lens", Lens::new(1.0, 0.5),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [true; 4], with distances;
            a_lens_in_space: "lens", Lens::new(1.0, 0.5),
                dimension 3, in [[-3.0; 3], [3.0; 3]], exact [true; 4], with distances;
            a_bump: "bump", Bump::new(1.0, 0.5),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [true, true, false, true],
                with distances;
            a_hill: "hill", Hill::new(0.5, 0.5),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [true; 4], with distances;
            soft_obstacles: "soft obstacles", SoftObstacles::<2>::new(vec![
                    Obstacle { centre: [0.0, 0.0].into(), height: 2.0, width: 0.5 },
                    Obstacle { centre: [1.0, 1.0].into(), height: 1.0, width: 0.7 },
                ]),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [false; 4];
            a_swirl: "swirl", Swirl::new(1.0, 0.5),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [true, true, false, false],
                with distances;
            an_egg_crate: "egg crate", EggCrate::new(0.5, 1.0),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [true; 4],
                with distances;
            a_corrugated_sheet: "corrugated", Corrugated::new(0.5, 1.0),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [true; 4],
                with distances;
            a_checkerboard: "checkerboard", Checkerboard::new(2.0, 1.0),
                dimension 2, in [[-1.5; 2], [1.5; 2]], exact [true; 4], with distances;
            two_channels: "two channels", TwoChannels::new(2.0, 1.0, 0.5),
                dimension 2, in [[-3.0; 2], [3.0; 2]], exact [true, true, false, false],
                with distances;
            rotating_anisotropy: "rotating anisotropy",
                RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]),
                dimension 2, in [[-2.0; 2], [2.0; 2]], exact [true; 4];
            a_two_link_arm: "two-link arm", TwoLinkArm::new(4.0, 0.8, 1.0),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [true; 4];
            coupled_cosines: "coupled cosines", Ok::<_, GalleryError>(CoupledCosines),
                dimension 3, in [[0.0; 3], [std::f64::consts::TAU; 3]],
                exact [true, true, true, false];
            sine_projections: "sine projections", SineProjections::<2>::new(vec![
                    SineProjection {
                        wave_vector: [1.0, 0.0].into(), direction: [1.0, 0.5].into(),
                    },
                    SineProjection {
                        wave_vector: [1.0, 1.0].into(), direction: [0.0, 1.0].into(),
                    },
                ]),
                dimension 2, in [[0.0; 2], [std::f64::consts::TAU; 2]], exact [false; 4];
            a_patch_of_the_sphere: "sphere patch", SpherePatch::new(1.0),
                dimension 2, in [[-2.0; 2], [2.0; 2]], exact [true, true, false, false],
                with distances;
            a_patch_of_hyperbolic_space: "hyperbolic patch", HyperbolicPatch::new(0.5),
                dimension 2, in [[-1.0; 2], [1.0; 2]], exact [true, true, false, false],
                with distances;
            normal_distributions: "Gaussian Fisher patch", GaussianFisherPatch::new(0.75),
                dimension 2, in [[-2.0, -1.5], [2.0, 1.5]], exact [true, true, false, false],
                with distances;
            a_tanh_decoder: "tanh decoder", TanhDecoder::<2, 3, 3>::new(
                    [[1.0, -0.5, 0.3], [0.2, 0.8, -1.0]].into(),
                    [[1.0, 0.0, 0.4], [0.0, 1.0, 0.3], [0.5, -0.5, 1.0]].into(),
                    0.5,
                ),
                dimension 2, in [[-6.0; 2], [6.0; 2]], exact [false; 4];
        }
    };
}
