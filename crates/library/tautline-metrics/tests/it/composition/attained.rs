//! The rules of the calculus are tight where they claim to be. The compositions here attain their
//! constants, so a wrong power of a factor fails whether it is too large or too small.

use std::f64::consts::PI;

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_metrics::{
    Bounded, Constants, Metric, Scalar,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{Lens, RotatingAnisotropy, Shear, Valleys},
};

use super::conformal::Conformal;
use crate::measure::{curvature, extremes, high, low, slope};

/// Asserts that `g` attains its four constants at these places: `c₁`, `c₂`, then `L_H` and `M_H` in
/// a direction.
#[track_caller]
fn attained<const D: usize>(
    g: &impl Bounded<D>,
    [lowest, highest]: [SVector<f64, D>; 2],
    [(steep, along), (bent, across)]: [(SVector<f64, D>, SVector<f64, D>); 2],
) {
    low(g, lowest);
    high(g, highest);
    slope(g, steep, along);
    curvature(g, bent, across);
}

/// Returns the `x₁` at which the valleys are steepest.
fn steepest() -> f64 {
    (0.5 * (1.0 - 3_f64.sqrt())).acos()
}

#[test]
fn scaled_attains_all() {
    for s in [0.01, 1.0, 7.0] {
        let g = Scaled::new(Valleys, s).expect("positive");
        let (low, high, w) = (vector![0.0, 3.0], vector![PI, 3.0], vector![1.0, 0.0]);
        let places = [(vector![steepest(), 0.0], w), (high, w)];
        attained(&g, [low, high], places);
    }
}

/// The sums are `H + s H`, and two metrics with eigenvalues `λ₁, λ₂` whose directions rotate
/// together.
#[test]
fn sum_attains_all_for_aligned_metrics() {
    let g = Sum::new(Valleys, Scaled::new(Valleys, 3.0).expect("positive"));
    let (low, high, w) = (vector![0.0, 3.0], vector![PI, 3.0], vector![1.0, 0.0]);
    attained(&g, [low, high], [(vector![steepest(), 0.0], w), (high, w)]);
    let (k, x) = (vector![0.7, -1.1], vector![0.3, 0.9]);
    let turning = |eigenvalues| RotatingAnisotropy::new(eigenvalues, k).expect("positive");
    let g = Sum::new(turning([1.0, 4.0]), turning([0.5, 0.6]));
    attained(&g, [x, x], [(x, k), (x, k)]);
    // With the directions exchanged, the anisotropies cancel: c₂ is 4.6, but 4.5 and 1.6 are the
    // eigenvalues.
    let g = Sum::new(turning([1.0, 4.0]), turning([0.6, 0.5]));
    assert_relative_eq!(extremes(&g.gram(&x)).1, 4.5, max_relative = 1e-13);
    assert_relative_eq!(g.constants().c2(), 4.6, max_relative = 1e-13);
}

/// The shear determines `c₁`, `L_H` and `M_H`, and the lens `c₂`.
#[test]
fn product_attains_all() {
    let (lens, shear) =
        (Lens::new(11.0, 3.0).expect("s > 0"), Shear::new(2.0, 1.5).expect("k > 0"));
    let (flat, steep) = (Bounded::<2>::constants(&lens), shear.constants());
    assert!(steep.c1() < flat.c1() && flat.c2() > steep.c2());
    assert!(steep.l_h() > flat.l_h() && steep.m_h() > flat.m_h());
    // The shear is steepest where sinh u = S cos kx₂ with e^{2u} = 1 + 2S².
    let u = 0.5 * 19_f64.ln();
    let y = (u.sinh() / 3.0).acos() / 1.5;
    let (x, w) = (vector![0.0, 0.0, 0.5, y], vector![0.0, 0.0, 0.0, 1.0]);
    let low = vector![0.4, 0.1, 0.5, 0.0];
    let places = [(x, w), (vector![0.0, 0.0, 0.5, PI / 1.5], w)];
    let g = Product::<_, _, 2, 2>::new(lens, shear);
    attained(&g, [low, vector![0.0, 0.0, 1.0, 1.0]], places);
    // The same holds with the factors in the other order.
    let turn = |x: SVector<f64, 4>| vector![x[2], x[3], x[0], x[1]];
    let g = Product::<_, _, 2, 2>::new(shear, lens);
    let places = places.map(|(x, w)| (turn(x), turn(w)));
    attained(&g, [turn(low), vector![1.0, 1.0, 0.0, 0.0]], places);
}

/// The maps are a similarity of the line and a multiple of a rotation. With `σ²` in place of `σ³`,
/// or any other power, a constant would be off by a factor of 3.
#[test]
fn a_similarity_attains_all() {
    for s in [-3.0, 1.0 / 3.0] {
        let g = AffinePullback::new(Valleys, matrix![s], [0.4]).expect("invertible");
        let at = |image: f64| vector![(image - 0.4) / s];
        let w = vector![-2.0];
        let places = [(at(steepest()), w), (at(PI), w)];
        attained(&g, [at(0.0), at(PI)], places);
        let (sin, cos) = 0.7_f64.sin_cos();
        let rotation = matrix![cos, -sin; sin, cos];
        let g = AffinePullback::new(Valleys, rotation * s, [0.4, -1.0]).expect("invertible");
        let at = |image: SVector<f64, 2>| rotation.transpose() * (image - vector![0.4, -1.0]) / s;
        let w = rotation.transpose() * vector![1.0, 0.0];
        let places = [(at(vector![steepest(), 5.0]), w), (at(vector![PI, -2.0]), w)];
        attained(&g, [at(vector![0.0, 2.0]), at(vector![PI, 1.0])], places);
    }
}

/// The stretches are 1/2 and 4, so exchanging `σ_min` and `σ_max` changes a constant by a factor of
/// at least 64.
#[test]
fn a_stretch_along_the_right_axis_attains_all() {
    let (sin, cos) = 1.1_f64.sin_cos();
    let rotation = matrix![cos, -sin; sin, cos];
    let stretch = matrix![4.0, 0.0; 0.0, 0.5] * rotation;
    // The valleys are isotropic and vary along the first axis, which is the stretched one.
    let g = AffinePullback::new(Valleys, stretch, [0.0, 0.0]).expect("invertible");
    let at = |image: SVector<f64, 2>| stretch.try_inverse().expect("invertible") * image;
    let w = rotation.transpose() * vector![1.0, 0.0];
    let places = [(at(vector![steepest(), 5.0]), w), (at(vector![PI, -2.0]), w)];
    attained(&g, [at(vector![0.0, 2.0]), at(vector![PI, 1.0])], places);
}

/// The metric `4 I`.
struct Four;

impl Metric<2> for Four {
    fn gram<S: Scalar>(&self, _: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        SMatrix::from_diagonal_element(S::constant(4.0))
    }
}

impl Bounded<2> for Four {
    fn constants(&self) -> Constants {
        Constants::new(4.0, 4.0, 0.0).and_then(|c| c.with_m_h(0.0)).expect("in order")
    }
}

#[test]
fn conformal_attains_all_if_a_factor_is_constant() {
    let (low, high, w) = (vector![0.0, 3.0], vector![PI, 3.0], vector![1.0, 0.0]);
    let places = [(vector![steepest(), 0.0], w), (high, w)];
    attained(&Conformal(Four, Valleys), [low, high], places);
    attained(&Conformal(Valleys, Four), [low, high], places);
}

/// Two tents `1 + L (1 − |x − 1|)` on the line: near the tip, the slope of their product is
/// `φ_max L + Lip(φ) c₂ = 2 · 2L`, minus the size of the step.
#[test]
fn conformal_attains_l_h_in_the_limit_of_two_tents() {
    let tent = |x: f64| 2.0 - (x - 1.0).abs();
    let factor = Constants::new(1.0, 2.0, 1.0).expect("a tent of slope 1 on [0, 2]");
    let l_h = factor.conformal(factor).expect("finite").l_h();
    for octave in 4..20 {
        let step = 0.5_f64.powi(octave);
        let slope = (tent(1.0).powi(2) - tent(1.0 + step).powi(2)) / step;
        // (4 − (2 − step)²) / step = 4 − step, which is exact for powers of two.
        assert_eq!(slope, l_h - step);
    }
}
