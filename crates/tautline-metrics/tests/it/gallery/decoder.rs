//! The decoder: its formula, and its constants.

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, matrix, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    Bounded, Constants, Jet1, Jet2, Metric,
    gallery::{GalleryError, TanhDecoder},
};

use super::{
    attained::{curvature, high, low, slope},
    distances::run,
};
use crate::{
    laws::hold,
    measure::{extremes, first, norm, second},
};

const INNER: [[f64; 2]; 5] = [[0.9, -0.3], [-0.4, 0.8], [0.2, 0.6], [-0.7, -0.5], [0.5, 0.1]];
const OUTER: [[f64; 5]; 3] =
    [[0.7, -0.2, 0.5, -0.9, 0.3], [-0.1, 0.8, 0.4, 0.2, -0.6], [0.6, 0.3, -0.5, -0.4, 0.9]];

/// Two coordinates, five neurons, three outputs.
fn decoder() -> TanhDecoder<2, 5, 3> {
    let inner = SMatrix::<f64, 5, 2>::from_fn(|k, i| INNER[k][i]);
    let outer = SMatrix::<f64, 3, 5>::from_fn(|o, k| OUTER[o][k]);
    TanhDecoder::new(inner, outer, 0.1).expect("finite")
}

#[test]
fn constants_of_tanh_decoder_hold() {
    let weights = || uniform::<_, 8>(-2.0..2.0_f64);
    hold::<2, _, _>(101, (weights(), weights(), 0.01..1.0_f64), |(inner, outer, floor)| {
        let inner = SMatrix::<f64, 4, 2>::from_column_slice(&inner);
        let outer = SMatrix::<f64, 2, 4>::from_column_slice(&outer);
        (TanhDecoder::new(inner, outer, floor).expect("finite"), 2.0)
    });
    hold::<4, _, _>(102, (weights(), uniform::<_, 6>(-2.0..2.0_f64)), |(inner, outer)| {
        let inner = SMatrix::<f64, 2, 4>::from_column_slice(&inner);
        let outer = SMatrix::<f64, 3, 2>::from_column_slice(&outer);
        (TanhDecoder::new(inner, outer, 0.5).expect("finite"), 2.0)
    });
}

/// `JᵀJ + μ I` with the Jacobian of `decode`.
#[test]
fn tanh_decoder_is_the_metric_of_its_image() {
    let g = decoder();
    run(103, uniform::<_, 2>(-3.0..3.0_f64), |x| {
        let image = g.decode(&SVector::from(Jet1::<f64, 2>::variables(&x)));
        let jacobian = SMatrix::<f64, 3, 2>::from_fn(|o, i| image[o].first(i));
        let h = jacobian.transpose() * jacobian + SMatrix::identity() * 0.1;
        // Entries of size 10 from fifteen terms.
        prop_assert!((h - g.gram(&SVector::from(x))).amax() < 1e-14);
        Ok(())
    });
    // The formula of the decoder itself, entry by entry.
    let x = [0.3, -0.8];
    let output = g.decode(&SVector::from(x));
    for (o, weights) in OUTER.iter().enumerate() {
        let neuron = |k: usize| (INNER[k][0] * x[0] + INNER[k][1] * x[1]).tanh();
        let sum: f64 = (0..5).map(|k| weights[k] * neuron(k)).sum();
        assert_relative_eq!(output[o], sum, max_relative = 1e-14);
    }
}

/// One neuron, with two outputs: `H = μ I + |W₂|² cosh⁻⁴(w·x) w wᵀ`.
#[test]
fn one_neuron_attains_all() {
    let w = vector![0.6, -1.1, 0.4];
    let g = TanhDecoder::<3, 1, 2>::new(SMatrix::from(w.transpose()), vector![1.5, -2.0], 0.3)
        .expect("finite");
    // x with the activation w·x = a.
    let at = |a: f64| w * (a / w.norm_squared());
    low(&g, at(0.0));
    high(&g, at(0.0));
    // tanh² a = 1/5.
    slope(&g, at(0.2_f64.sqrt().atanh()), w);
    curvature(&g, at(0.0), w);
    let constants = Bounded::<3>::constants(&g);
    let (square, most) = (w.norm_squared(), w.norm_squared() * 6.25);
    assert_relative_eq!(constants.c2(), 0.3 + most, max_relative = 1e-13);
    assert_relative_eq!(constants.m_h().expect("known"), 4.0 * most * square, max_relative = 1e-13);
}

/// Neurons that are copies of each other go together: everything is still attained.
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

/// Far out the neurons are saturated: the floor is left.
#[test]
fn tanh_decoder_falls_to_its_floor() {
    let g = decoder();
    low(&g, vector![-300.0, 170.0]);
    // Where cosh² overflows, too.
    let [t] = Jet2::<f64, 1>::variables(&[1e4]);
    let h = g.gram(&vector![t * -2.0, t]);
    assert!(h.iter().all(|entry| entry.first(0) == 0.0 && entry.second(0, 0) == 0.0));
}

/// What the norms give away for five neurons of different directions, by a scan of a square:
/// `c₂` is 1.15 times too large, `L_H` 1.55 times, `M_H` 1.91 times.
#[test]
fn several_neurons_are_within_their_bounds() {
    let g = decoder();
    let mut most = [0.0_f64; 3];
    for i in 0..10_000 {
        let x = vector![f64::from(i % 100) * 0.04 - 2.0, f64::from(i / 100) * 0.04 - 2.0];
        most[0] = most[0].max(extremes(&g.gram(&x)).1);
        for j in 0..8 {
            let (sin, cos) = (f64::from(j) * std::f64::consts::PI / 8.0).sin_cos();
            let w = vector![cos, sin];
            most[1] = most[1].max(norm(&first(&g, &x, &w)));
            most[2] = most[2].max(norm(&second(&g, &x, &w)));
        }
    }
    let constants = g.constants();
    let bounds = [constants.c2(), constants.l_h(), constants.m_h().expect("known")];
    for ((most, bound), least) in most.into_iter().zip(bounds).zip([0.86, 0.64, 0.52]) {
        assert!((least..=1.0).contains(&(most / bound)), "{}", bound / most);
    }
}

#[test]
fn tanh_decoder_refuses_bad_weights() {
    let build = |inner: f64, outer: f64, floor: f64| {
        TanhDecoder::<1, 1, 1>::new(matrix![inner], matrix![outer], floor)
    };
    for bad in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for (outcome, entry) in
            [(build(bad, 1.0, 1.0), "entry of W1"), (build(1.0, bad, 1.0), "entry of W2")]
        {
            let error = outcome.expect_err("not finite");
            assert!(
                matches!(error, GalleryError::NotFinite { name, value }
                    if name == entry && value.to_bits() == bad.to_bits()),
                "{error}"
            );
        }
    }
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = build(1.0, 1.0, bad).expect_err("no floor");
        assert!(
            matches!(error, GalleryError::NotPositive { name: "floor", value }
                if value.to_bits() == bad.to_bits()),
            "{error}"
        );
    }
    for (inner, outer) in [(1e200, 1.0), (1.0, 1e200), (1e100, 1e100), (1e120, 1.0)] {
        let error = build(inner, outer, 1.0).expect_err("overflow");
        assert!(matches!(error, GalleryError::Constants(_)), "{error}");
    }
    // In more dimensions, too, where eigenvalues take an iteration.
    let huge = SMatrix::<f64, 3, 4>::from_fn(|i, j| 1e200 * (1.0 + i as f64 - j as f64));
    let error = TanhDecoder::<4, 3, 1>::new(huge, SMatrix::zeros(), 1.0).expect_err("overflow");
    assert!(matches!(error, GalleryError::Constants(_)), "{error}");
    // No weights: the Euclidean line.
    let flat = Constants::new(1.0, 1.0, 0.0).and_then(|c| c.with_m_h(0.0));
    assert_eq!(build(0.0, 0.0, 1.0).expect("finite").constants(), flat.expect("in order"));
}
