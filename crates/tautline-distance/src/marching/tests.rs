//! Marching over metrics whose distances are known.

use nalgebra::{SVector, matrix};
use tautline_check::Cubes;
use tautline_formula::Formula;

use super::Nodes;

/// Returns the largest error of the distance from the origin under a constant metric, on `[−1, 1]²`
/// with cubes of side `2^exponent`, if the values within ½ are exact.
fn error(exponent: i32) -> f64 {
    let formula = Formula::<2>::parse("[4, 1.5; 1.5, 1]", &[]).expect("a formula");
    let h = matrix![4.0, 1.5; 1.5, 1.0];
    let n = 1 << -exponent;
    let places = (-n..n).flat_map(|i| (-n..n).map(move |j| [i, j])).collect();
    let nodes = Nodes::new(&formula, &Cubes::new(exponent, places).expect("in range"));
    let exact = |x: &SVector<f64, 2>| x.dot(&(h * x)).sqrt();
    let points = nodes.points();
    let seed = |x: &SVector<f64, 2>| if x.norm() < 0.5 { exact(x) } else { f64::INFINITY };
    let values = nodes.march(points.iter().map(seed).collect());
    // Near the boundary the stencils lack nodes.
    let inside = points.iter().zip(&values).filter(|(x, _)| x.amax() < 0.7);
    inside.map(|(x, value)| (value - exact(x)).abs()).fold(0.0, f64::max)
}

/// Halving the spacing divides the error by about 4.
#[test]
fn a_march_is_of_second_order_for_an_anisotropic_metric() {
    let (coarse, fine) = (error(-4), error(-6));
    assert!(fine < 1e-3 && fine < coarse / 8.0, "{coarse:e} {fine:e}");
}

#[test]
fn nodes_that_are_not_reached_have_the_largest_value() {
    let flat = Formula::<1>::parse("1 I", &[]).expect("a formula");
    let cubes = Cubes::new(0, vec![[0], [5]]).expect("in range");
    let nodes = Nodes::new(&flat, &cubes);
    let values = nodes.march(vec![
        0.0,
        f64::INFINITY,
        f64::INFINITY,
        f64::INFINITY,
        f64::INFINITY,
        f64::INFINITY,
    ]);
    assert_eq!(values, [0.0, 0.5, 1.0, 1.0, 1.0, 1.0]);
}
