//! The formulas of compositions, and the distances of compositions.

use approx::assert_relative_eq;
use nalgebra::{SMatrix, SVector, matrix, vector};
use proptest::{array::uniform, prelude::*};
use tautline_metrics::{
    KnownDistance, Metric,
    composition::{AffinePullback, Product, Scaled, Sum},
    gallery::{Lens, Ramp, Separable, Shear, Sphere, TwoLinkArm, Valleys},
    norm_squared,
    quadrature::integrate,
};

use crate::measure::runner;

#[test]
fn each_is_its_matrix() {
    let (shear, arm) = (Shear::new(0.7, 1.3).expect("k > 0"), TwoLinkArm::new(4.0, 0.8, 1.0));
    let arm = arm.expect("3 > B²");
    let x = vector![0.3, -0.8];
    let (g, h): (SMatrix<f64, 2, 2>, SMatrix<f64, 2, 2>) = (shear.gram(&x), arm.gram(&x));
    assert_eq!(Scaled::new(shear, 2.5).expect("positive").gram(&x), g * 2.5);
    assert_eq!(Sum::new(shear, arm).gram(&x), g + h);
    let y = vector![0.4, 0.1];
    let block: SMatrix<f64, 2, 2> = arm.gram(&y);
    let product: SMatrix<f64, 4, 4> =
        Product::<_, _, 2, 2>::new(shear, arm).gram(&vector![x[0], x[1], y[0], y[1]]);
    assert_eq!(product.fixed_view::<2, 2>(0, 0), g);
    assert_eq!(product.fixed_view::<2, 2>(2, 2), block);
    assert_eq!(product.fixed_view::<2, 2>(0, 2), SMatrix::<f64, 2, 2>::zeros());
    assert_eq!(product.fixed_view::<2, 2>(2, 0), SMatrix::<f64, 2, 2>::zeros());
    let (map, shift) = (matrix![0.3, -1.2; 2.0, 0.4], vector![0.5, -0.25]);
    let pulled: SMatrix<f64, 2, 2> =
        AffinePullback::new(shear, map, shift).expect("invertible").gram(&x);
    let at_image: SMatrix<f64, 2, 2> = shear.gram(&(map * x + shift));
    // The entries are at most 10 and are sums of eight terms.
    assert!((pulled - map.transpose() * at_image * map).amax() < 1e-14);
}

#[test]
fn distances_are_those_of_the_parts() {
    let shear = Shear::new(0.5, 1.0).expect("k > 0");
    let (x, y) = (vector![0.3, -0.8], vector![1.9, 2.0]);
    let d = shear.distance(&x, &y).expect("all pairs");
    let scaled = Scaled::new(shear, 9.0).expect("positive");
    assert_relative_eq!(scaled.distance(&x, &y).expect("all pairs"), 3.0 * d, max_relative = 1e-15);
    // The shear is written in oblique coordinates and transformed back.
    let (map, shift) = (matrix![0.3, -1.2; 2.0, 0.4], vector![0.5, -0.25]);
    let pulled = AffinePullback::new(shear, map, shift).expect("invertible");
    let back = |image: SVector<f64, 2>| map.try_inverse().expect("invertible") * (image - shift);
    assert_relative_eq!(pulled.image(&back(x)), x, max_relative = 1e-14);
    let pulled_d = pulled.distance(&back(x), &back(y)).expect("all pairs");
    assert_relative_eq!(pulled_d, d, max_relative = 1e-14);
}

/// The product of the shear and the lens; the distance of the lens is known on rays only.
#[test]
fn the_square_of_a_distance_in_a_product_is_the_sum_of_squares() {
    let (shear, lens) = (Shear::new(0.5, 1.0).expect("k > 0"), Lens::new(2.0, 0.7).expect("s > 0"));
    let product = Product::<_, _, 2, 2>::new(shear, lens);
    let (x, y) = (vector![0.3, -0.8, 0.3, 0.4], vector![1.9, 2.0, 1.2, 1.6]);
    let d = product.distance(&x, &y).expect("on a ray");
    let first = shear.distance(&vector![0.3, -0.8], &vector![1.9, 2.0]).expect("all pairs");
    // The reference for this lens and this ray is the one in the gallery's test.
    assert_relative_eq!(
        d * d,
        first * first + 1.848_184_957_482_796_7_f64.powi(2),
        max_relative = 1e-14
    );
    let aside = vector![1.9, 2.0, 1.2, -1.6];
    assert_eq!(product.distance(&x, &aside), None);
    let swapped = Product::<_, _, 2, 2>::new(lens, shear);
    assert_eq!(
        swapped.distance(&vector![0.3, 0.4, 0.3, -0.8], &vector![1.2, -1.6, 1.9, 2.0]),
        None
    );
}

/// A separable metric is a product of metrics on the line, so its distance can be computed in two
/// ways.
#[test]
fn a_product_is_a_metric_whose_distance_is_known_otherwise() {
    let separable = |i: usize| {
        let (a, k) = ([0.5, -0.8, 0.3][i], [1.0, 2.0, 0.7][i]);
        Separable::<1>::new(SVector::<f64, 1>::new(a), SVector::<f64, 1>::new(k)).expect("|a| < 1")
    };
    let whole =
        Separable::<3>::new(vector![0.5, -0.8, 0.3], vector![1.0, 2.0, 0.7]).expect("|a| < 1");
    let pair = Product::<_, _, 1, 1>::new(separable(0), separable(1));
    let product = Product::<_, _, 2, 1>::new(pair, separable(2));
    let points = uniform::<_, 3>(-3.0..3.0_f64).prop_map(SVector::from);
    let outcome = runner(72).run(&(points.clone(), points), |(x, y)| {
        let h: SMatrix<f64, 3, 3> = product.gram(&x);
        prop_assert_eq!(h, whole.gram(&x));
        let (d, known) = (product.distance(&x, &y), whole.distance(&x, &y));
        let (d, known) = (d.expect("all pairs"), known.expect("all pairs"));
        prop_assert!((d - known).abs() <= 1e-14 * (1.0 + known), "{d} {known}");
        let v = y - x;
        let chord = |t: f64| norm_squared(&product, &(x + v * t), &v).sqrt();
        prop_assert!(d <= integrate(chord, 0.0, 1.0, 1e-13).value * (1.0 + 1e-12));
        Ok(())
    });
    if let Err(error) = outcome {
        panic!("{error}");
    }
}

/// A part may lack constants, or a distance for all pairs.
#[test]
fn unbounded_parts_make_metrics_too() {
    let ramp = Ramp::new(0.5, 1.0).expect("|a| < 1");
    let product = Product::<_, _, 2, 1>::new(Sphere, ramp);
    let d = product.distance(&vector![0.0, 0.0, 1.0], &vector![1.0, 0.0, 1.0]);
    // The arc is a quarter of a great circle.
    assert_relative_eq!(d.expect("all pairs"), std::f64::consts::FRAC_PI_2, max_relative = 1e-15);
    let scaled = Scaled::new(Valleys, 2.0).expect("positive");
    assert_eq!(scaled.distance(&vector![3.0, 0.0], &vector![3.0, 5.0]), None, "on a ridge");
}
