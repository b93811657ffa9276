//! The metrics to measure: all of the gallery, two with many coordinates, and decoders.

use std::error::Error;

use tautline::{Metric, SMatrix, SVector, gallery::*};

/// A measurement of a metric in any dimension.
pub(crate) trait Visitor {
    fn visit<const D: usize>(&mut self, name: &str, metric: &impl Metric<D>);
}

/// Shows each metric to the visitor.
pub(crate) fn every_metric(visitor: &mut impl Visitor) -> Result<(), Box<dyn Error>> {
    let full = SMatrix::<f64, 3, 3>::new(2.0, 0.3, 0.1, 0.3, 1.7, -0.4, 0.1, -0.4, 1.1);
    visitor.visit("Constant", &Constant::new(full)?);
    visitor.visit::<2>("Valleys", &Valleys);
    visitor.visit("Ramp", &Ramp::new(0.7, 1.3)?);
    visitor.visit("Separable", &Separable::new([0.3, 0.5, -0.4], [1.1, 2.0, 1.7])?);
    visitor.visit("Shear", &Shear::new(0.7, 1.3)?);
    visitor.visit::<2>("Lens", &Lens::new(1.3, 0.6)?);
    visitor.visit::<2>("Bump", &Bump::new(4.0, 0.5)?);
    visitor.visit::<2>("Hill", &Hill::new(0.7, 0.6)?);
    visitor.visit("SoftObstacles", &obstacles()?);
    visitor.visit("Swirl", &Swirl::new(1.3, 0.6)?);
    visitor.visit("EggCrate", &EggCrate::new(0.7, 1.3)?);
    visitor.visit::<2>("Corrugated", &Corrugated::new(0.7, 1.3)?);
    visitor.visit("Checkerboard", &Checkerboard::new(2.3, 0.9)?);
    visitor.visit("TwoChannels", &TwoChannels::new(2.3, 0.9, 0.4)?);
    visitor.visit("RotatingAnisotropy", &RotatingAnisotropy::new([0.9, 4.1], [0.7, -1.1])?);
    visitor.visit("TwoLinkArm", &TwoLinkArm::new(4.1, 0.7, 1.1)?);
    visitor.visit("CoupledCosines", &CoupledCosines);
    visitor.visit::<2>("Sphere", &Sphere);
    visitor.visit::<2>("Hyperbolic", &Hyperbolic);
    visitor.visit("GaussianFisher", &GaussianFisher);
    visitor.visit::<2>("SpherePatch", &SpherePatch::new(0.9)?);
    visitor.visit::<2>("HyperbolicPatch", &HyperbolicPatch::new(0.6)?);
    visitor.visit("GaussianFisherPatch", &GaussianFisherPatch::new(0.7)?);
    visitor.visit("SineProjections", &SineProjections::benchmark());
    visitor.visit("SineProjections of 4 terms", &projections::<24>(4)?);
    visitor.visit("SineProjections of 4 terms", &projections::<64>(4)?);
    visitor.visit("TanhDecoder with 8 units and 16 outputs", &*decoder::<8, 16>()?);
    visitor.visit("TanhDecoder with 64 units and 784 outputs", &*decoder::<64, 784>()?);
    Ok(())
}

fn obstacles() -> Result<SoftObstacles<2>, Box<dyn Error>> {
    let obstacle = |at: [f64; 2]| Obstacle { centre: at.into(), height: 2.0, width: 0.5 };
    Ok(SoftObstacles::new(vec![obstacle([0.3, 0.1]), obstacle([-0.7, 0.4])])?)
}

/// Returns numbers between −1 and 1 that have no pattern.
fn number(k: usize) -> f64 {
    (1.0 + 1.7 * k as f64).sin()
}

fn projections<const D: usize>(terms: usize) -> Result<SineProjections<D>, Box<dyn Error>> {
    let vector = |begin: usize| SVector::from_fn(|i, _| number(begin + i));
    let term = |k: usize| SineProjection {
        wave_vector: vector(2 * k * D),
        direction: vector((2 * k + 1) * D),
    };
    Ok(SineProjections::new((0..terms).map(term).collect())?)
}

/// Returns a decoder. It is boxed, since its matrices are large.
fn decoder<const HIDDEN: usize, const OUT: usize>()
-> Result<Box<TanhDecoder<2, HIDDEN, OUT>>, Box<dyn Error>> {
    let inner = SMatrix::from_fn(|i, j| number(2 * i + j));
    let outer = SMatrix::from_fn(|i, j| number(HIDDEN * i + j) / OUT as f64);
    Ok(Box::new(TanhDecoder::new(inner, outer, 0.1)?))
}
