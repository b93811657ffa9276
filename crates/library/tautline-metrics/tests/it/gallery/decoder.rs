//! The decoder: its formula, and its constants.

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, matrix, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    Bounded, Constants, Jet1, Jet2, Metric,
    gallery::{GalleryError, TanhDecoder},
};

use super::{
    distances::run,
    refused::{FINITE, POSITIVE, refused},
};
use crate::{
    laws::constants_hold,
    measure::{curvature, directions, extremes, high, low, scan, slope},
};

const INNER: [[f64; 2]; 5] = [[0.9, -0.3], [-0.4, 0.8], [0.2, 0.6], [-0.7, -0.5], [0.5, 0.1]];
const OUTER: [[f64; 5]; 3] =
    [[0.7, -0.2, 0.5, -0.9, 0.3], [-0.1, 0.8, 0.4, 0.2, -0.6], [0.6, 0.3, -0.5, -0.4, 0.9]];

/// Returns a decoder with two coordinates, five neurons and three outputs.
fn decoder() -> TanhDecoder<2, 5, 3> {
    let inner = SMatrix::<f64, 5, 2>::from_fn(|k, i| INNER[k][i]);
    let outer = SMatrix::<f64, 3, 5>::from_fn(|o, k| OUTER[o][k]);
    TanhDecoder::new(inner, outer, 0.1).expect("finite")
}

fn weights() -> impl Strategy<Value = [f64; 8]> {
    uniform(-2.0..2.0_f64)
}

constants_hold! {
    constants_of_tanh_decoder_hold, 2, seed 101: (weights(), weights(), 0.01..1.0_f64),
        |(inner, outer, floor)| {
            let inner = SMatrix::<f64, 4, 2>::from_column_slice(&inner);
            let outer = SMatrix::<f64, 2, 4>::from_column_slice(&outer);
            (TanhDecoder::new(inner, outer, floor).expect("finite"), 2.0)
        };
    constants_of_a_narrow_tanh_decoder_hold, 4, seed 102:
        (weights(), uniform::<_, 6>(-2.0..2.0_f64)), |(inner, outer)| {
            let inner = SMatrix::<f64, 2, 4>::from_column_slice(&inner);
            let outer = SMatrix::<f64, 3, 2>::from_column_slice(&outer);
            (TanhDecoder::new(inner, outer, 0.5).expect("finite"), 2.0)
        };
}

/// The metric is `JᵀJ + μ I` with the Jacobian of `decode`.
#[test]
fn tanh_decoder_is_the_metric_of_its_image() {
    let g = decoder();
    run(103, uniform::<_, 2>(-3.0..3.0_f64), |x| {
        let image = g.decode(&SVector::from(Jet1::<f64, 2>::variables(&x)));
        let jacobian = SMatrix::<f64, 3, 2>::from_fn(|o, i| image[o].first(i));
        let h = jacobian.transpose() * jacobian + SMatrix::identity() * 0.1;
        // The entries are of size 10 and are sums of fifteen terms.
        prop_assert!((h - g.gram(&SVector::from(x))).amax() < 1e-14);
        Ok(())
    });
    // This is the formula of the decoder itself, entry by entry.
    let x = [0.3, -0.8];
    let output = g.decode(&SVector::from(x));
    for (o, weights) in OUTER.iter().enumerate() {
        let neuron = |k: usize| (INNER[k][0] * x[0] + INNER[k][1] * x[1]).tanh();
        let sum: f64 = (0..5).map(|k| weights[k] * neuron(k)).sum();
        assert_relative_eq!(output[o], sum, max_relative = 1e-14);
    }
}

/// For one neuron with two outputs, `H = μ I + |W₂|² cosh⁻⁴(w·x) w wᵀ`.
#[test]
fn one_neuron_attains_all() {
    let w = vector![0.6, -1.1, 0.4];
    let g = TanhDecoder::<3, 1, 2>::new(SMatrix::from(w.transpose()), vector![1.5, -2.0], 0.3)
        .expect("finite");
    // Returns the x with the activation w·x = a.
    let at = |a: f64| w * (a / w.norm_squared());
    low(&g, at(0.0));
    high(&g, at(0.0));
    // The slope is greatest at tanh² a = 1/5.
    slope(&g, at(0.2_f64.sqrt().atanh()), w);
    curvature(&g, at(0.0), w);
    let constants = Bounded::<3>::constants(&g);
    let (square, most) = (w.norm_squared(), w.norm_squared() * 6.25);
    assert_relative_eq!(constants.c2(), 0.3 + most, max_relative = 1e-13);
    assert_relative_eq!(constants.m_h().expect("known"), 4.0 * most * square, max_relative = 1e-13);
}

/// Identical neurons are aligned, so everything is still attained.
#[test]
fn equal_neurons_attain_all() {
    let g =
        TanhDecoder::<2, 2, 2>::new(matrix![0.5, 1.0; 0.5, 1.0], matrix![1.0, 1.0; 2.0, 2.0], 0.2)
            .expect("finite");
    let w = vector![0.5, 1.0];
    high(&g, vector![0.0, 0.0]);
    slope(&g, w * (0.2_f64.sqrt().atanh() / 1.25), w);
    curvature(&g, vector![0.0, 0.0], w);
}

/// Far from the origin the neurons are saturated, and only the floor remains.
#[test]
fn tanh_decoder_falls_to_its_floor() {
    let g = decoder();
    low(&g, vector![-300.0, 170.0]);
    // This holds even where cosh² overflows.
    let [t] = Jet2::<f64, 1>::variables(&[1e4]);
    let h = g.gram(&vector![t * -2.0, t]);
    assert!(h.iter().all(|entry| entry.first(0) == 0.0 && entry.second(0, 0) == 0.0));
}

/// For five neurons with different directions, a scan of a square measured the overestimation: 1.15
/// for `c₂`, 1.55 for `L_H`, 1.91 for `M_H`.
#[test]
fn several_neurons_are_within_their_bounds() {
    let g = decoder();
    let grid = (0..10_000)
        .map(|i| vector![f64::from(i % 100) * 0.04 - 2.0, f64::from(i / 100) * 0.04 - 2.0]);
    let highest = grid.clone().map(|x| extremes(&g.gram(&x)).1).fold(0.0, f64::max);
    let [slope, curvature] = scan(&g, grid.flat_map(|x| directions(8).map(move |w| (x, w))));
    for (ratio, least) in [(highest / g.constants().c2(), 0.86), (slope, 0.64), (curvature, 0.52)] {
        assert!((least..=1.0).contains(&ratio), "{ratio}");
    }
}

#[test]
fn tanh_decoder_refuses_bad_weights() {
    let build = |inner: f64, outer: f64, floor: f64| {
        TanhDecoder::<1, 1, 1>::new(matrix![inner], matrix![outer], floor)
    };
    refused(FINITE, "entry of W1", |bad| [build(bad, 1.0, 1.0).err()]);
    refused(FINITE, "entry of W2", |bad| [build(1.0, bad, 1.0).err()]);
    refused(POSITIVE, "floor", |bad| [build(1.0, 1.0, bad).err()]);
    for (inner, outer) in [(1e200, 1.0), (1.0, 1e200), (1e100, 1e100), (1e120, 1.0)] {
        let error = build(inner, outer, 1.0).expect_err("overflow");
        assert!(matches!(error, GalleryError::Constants(_)), "{error}");
    }
    // In more dimensions the eigenvalues are computed by iteration.
    let huge = SMatrix::<f64, 3, 4>::from_fn(|i, j| 1e200 * (1.0 + i as f64 - j as f64));
    let error = TanhDecoder::<4, 3, 1>::new(huge, SMatrix::zeros(), 1.0).expect_err("overflow");
    assert!(matches!(error, GalleryError::Constants(_)), "{error}");
    // Without weights the metric is the Euclidean line.
    let flat = Constants::new(1.0, 1.0, 0.0).and_then(|c| c.with_m_h(0.0));
    assert_eq!(build(0.0, 0.0, 1.0).expect("finite").constants(), flat.expect("in order"));
}
