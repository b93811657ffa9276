//! `Drawn`: a metric of the gallery with random parameters, in any dimension.

use tautline::{
    Formula, Metric, SMatrix, SVector, Scalar,
    gallery::{
        Bump, Checkerboard, Constant, Corrugated, CoupledCosines, EggCrate, GaussianFisherPatch,
        Hill, HyperbolicPatch, Lens, Link, Obstacle, Ramp, RotatingAnisotropy, Separable, Shear,
        SineProjection, SineProjections, SoftObstacles, SpherePatch, Swirl, TanhDecoder,
        TwoChannels, TwoLinkArm, Valleys,
    },
};
use tautline_checks::adversary::SplitMix;

use crate::Failure;

/// A metric of `R^K` in the first coordinates, combined with the Euclidean metric in the others.
#[derive(Clone, Copy, Debug)]
pub struct Beside<M, const K: usize>(M);

impl<M: Metric<K>, const K: usize, const D: usize> Metric<D> for Beside<M, K> {
    #[inline]
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let block = self.0.gram(&SVector::<S, K>::from_fn(|i, _| x[i]));
        let mut h = SMatrix::<S, D, D>::identity();
        for j in 0..K {
            for i in 0..K {
                h[(i, j)] = block[(i, j)];
            }
        }
        h
    }
}

/// A recorded metric of the gallery. A metric of fixed dimension `K < D` is extended by [`Beside`].
#[derive(Clone, Debug)]
pub struct Drawn<const D: usize> {
    /// The name of the metric in the gallery.
    pub name: &'static str,
    /// Its formula.
    pub formula: Formula<D>,
}

/// Half the side of the cube about the origin that contains the ends, in `ℓ`. It is used for
/// metrics without a radius of their own, and spans one or two waves of most of them.
const REACH: f64 = 3.0;

/// Returns a random vector in the cube `[−size, size]^D`.
pub(super) fn vector<const D: usize>(random: &mut SplitMix, size: f64) -> SVector<f64, D> {
    SVector::from_fn(|_, _| random.between(-size, size))
}

impl<const D: usize> Drawn<D> {
    fn of(name: &'static str, metric: &impl Metric<D>) -> Result<Self, Failure> {
        Ok(Self { name, formula: Formula::record(metric)? })
    }

    /// Returns a metric, and half the side of the cube about the origin in which its ends are
    /// drawn, in `ℓ`. This is about the radius for a patch, and 3 for all other metrics.
    ///
    /// The metrics are equally likely: the 13 that exist in every dimension, for `D ≥ 2` also the 8
    /// of the plane, and for `D ≥ 3` also the one of space. Each has `c₁ > 0` on all of `R^D`, so
    /// that a discrete minimiser exists. Without this, there might be none: under the metric of the
    /// whole sphere, one chord across infinity costs nothing. The same holds for hyperbolic space
    /// and the normal distributions. The patches of these three represent them.
    ///
    /// # Errors
    ///
    /// There are none: the parameters are admissible, and no formula compares numbers.
    pub fn new(random: &mut SplitMix) -> Result<(Self, f64), Failure> {
        let known = match D {
            1 => 13,
            2 => 21,
            _ => 22,
        };
        let kind = random.below(known);
        let mut between = |low, high| random.between(low, high);
        let mut reach = REACH;
        let metric = match kind {
            0 => {
                let m: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| between(-1.0, 1.0));
                let square: SMatrix<f64, D, D> = m.tr_mul(&m) + SMatrix::identity() * 0.25;
                Self::of("Constant", &Constant::new((square + square.transpose()) * 0.5)?)
            }
            1 => Self::of("Valleys", &Valleys),
            2 => {
                let amplitudes = vector::<D>(random, 0.8);
                let wave_numbers = SVector::<f64, D>::from_fn(|_, _| random.between(0.3, 2.0));
                Self::of("Separable", &Separable::new(amplitudes, wave_numbers)?)
            }
            3 => Self::of("Lens", &Lens::new(between(0.0, 8.0), between(0.3, 1.5))?),
            4 => Self::of("Bump", &Bump::new(between(0.0, 4.0), between(0.3, 1.5))?),
            5 => Self::of("Hill", &Hill::new(between(-2.0, 2.0), between(0.5, 1.5))?),
            6 => {
                let count = 1 + random.below(6);
                let obstacle = |_| Obstacle {
                    centre: vector(random, REACH),
                    height: random.between(0.0, 6.0),
                    width: random.between(0.4, 1.5),
                };
                Self::of("SoftObstacles", &SoftObstacles::new((0..count).map(obstacle).collect())?)
            }
            7 => Self::of("Corrugated", &Corrugated::new(between(-1.0, 1.0), between(0.5, 3.0))?),
            8 => {
                let count = 1 + random.below(8);
                let term = |_| SineProjection {
                    wave_vector: vector(random, 1.5),
                    direction: vector(random, 0.7),
                };
                Self::of("SineProjections", &SineProjections::new((0..count).map(term).collect())?)
            }
            9 => {
                reach = between(0.5, 2.0);
                Self::of("SpherePatch", &SpherePatch::new(reach)?)
            }
            10 => {
                reach = between(0.3, 0.85);
                Self::of("HyperbolicPatch", &HyperbolicPatch::new(reach)?)
            }
            11 => {
                let inner = SMatrix::from_fn(|_, _| between(-1.5, 1.5));
                let outer = SMatrix::from_fn(|_, _| between(-1.5, 1.5));
                Self::of(
                    "TanhDecoder",
                    &TanhDecoder::<D, 4, 3>::new(inner, outer, between(0.05, 1.0))?,
                )
            }
            12 => Self::of("Ramp", &Beside(Ramp::new(between(-0.9, 0.9), between(0.3, 3.0))?)),
            13 => Self::of("Shear", &Beside(Shear::new(between(-1.0, 1.0), between(0.3, 2.0))?)),
            14 => Self::of("Swirl", &Beside(Swirl::new(between(-2.5, 2.5), between(0.5, 2.0))?)),
            15 => {
                Self::of("EggCrate", &Beside(EggCrate::new(between(-0.7, 0.7), between(0.5, 2.0))?))
            }
            16 => {
                let checkerboard = Checkerboard::new(between(0.0, 4.0), between(0.7, 3.0))?;
                Self::of("Checkerboard", &Beside(checkerboard))
            }
            17 => {
                let (height, offset) = (between(0.0, 8.0), between(0.3, 2.0));
                Self::of(
                    "TwoChannels",
                    &Beside(TwoChannels::new(height, offset, between(0.2, 1.0))?),
                )
            }
            18 => {
                let eigenvalues = [between(0.2, 4.0), between(0.2, 4.0)];
                let wave_vector = vector::<2>(random, 1.5);
                Self::of(
                    "RotatingAnisotropy",
                    &Beside(RotatingAnisotropy::new(eigenvalues, wave_vector)?),
                )
            }
            19 => {
                let mut link = || {
                    let (mass, length) = (between(0.3, 3.0), between(0.3, 2.0));
                    let (centre, inertia) = (length * between(0.2, 0.8), between(0.05, 0.5));
                    Link { mass, length, centre, inertia }
                };
                Self::of("TwoLinkArm", &Beside(TwoLinkArm::from_links(link(), link())?))
            }
            20 => {
                reach = between(0.3, 1.5);
                Self::of("GaussianFisherPatch", &Beside(GaussianFisherPatch::new(reach)?))
            }
            _ => Self::of("CoupledCosines", &Beside(CoupledCosines)),
        };
        Ok((metric?, reach))
    }
}
