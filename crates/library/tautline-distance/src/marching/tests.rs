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
    let values = nodes.march(&formula, points.iter().map(seed).collect()).expect("seeds");
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
fn nodes_that_are_not_connected_with_a_seed_have_the_largest_value() {
    let flat = Formula::<1>::parse("1 I", &[]).expect("a formula");
    let cubes = Cubes::new(0, vec![[0], [5]]).expect("in range");
    let nodes = Nodes::new(&flat, &cubes);
    let mut seeds = vec![f64::INFINITY; 6];
    assert_eq!(nodes.march(&flat, seeds.clone()), None);
    seeds[0] = 0.0;
    assert_eq!(nodes.march(&flat, seeds), Some(vec![0.0, 0.5, 1.0, 1.0, 1.0, 1.0]));
}

/// A seed that is not a number, or infinite with either sign, is none: the value there is that of the
/// march.
#[test]
fn seeds_that_are_not_finite_are_none() {
    let flat = Formula::<1>::parse("4 I", &[]).expect("a formula");
    let nodes = Nodes::new(&flat, &Cubes::new(1, vec![[0], [1]]).expect("in range"));
    for none in [f64::NAN, f64::NEG_INFINITY] {
        let seeds = vec![0.0, f64::INFINITY, f64::INFINITY, f64::INFINITY, none];
        assert_eq!(nodes.march(&flat, seeds), Some(vec![0.0, 2.0, 4.0, 6.0, 8.0]));
        assert_eq!(nodes.march(&flat, vec![none; 5]), None);
    }
}

/// Where there is no metric, a node gets the greatest value of its neighbours, and the nodes behind it the
/// lengths of chords from there.
#[test]
fn nodes_without_a_metric_have_values_of_their_neighbours() {
    // Undefined at 1 only, which is a node.
    let hole = Formula::<1>::parse("(1 + 0*ln(sqr(x1 - 1))) I", &[]).expect("a formula");
    let nodes = Nodes::new(&hole, &Cubes::new(1, vec![[0], [1]]).expect("in range"));
    let mut seeds = vec![f64::INFINITY; 5];
    seeds[0] = 0.0;
    assert_eq!(nodes.march(&hole, seeds), Some(vec![0.0, 0.0, 1.0, 2.0, 3.0]));
}

/// A node in a corner of the cubes may lack all neighbours of its stencil.
#[test]
fn nodes_that_lack_their_neighbours_have_lengths_of_chords() {
    let text = "[1, 9.9; 9.9, 100]";
    let formula = Formula::<2>::parse(text, &[]).expect("a formula");
    let h = matrix![1.0, 9.9; 9.9, 100.0];
    let nodes = Nodes::new(&formula, &Cubes::new(0, vec![[0, 0], [1, 0]]).expect("in range"));
    let points = nodes.points();
    let length = |x: &SVector<f64, 2>| x.dot(&(h * x)).sqrt();
    let centre = nalgebra::vector![1.0, 0.5];
    let seeds = points.iter().map(|x| if *x == centre { 0.0 } else { f64::INFINITY }).collect();
    let values = nodes.march(&formula, seeds).expect("a seed");
    for (x, value) in points.iter().zip(&values) {
        let exact = length(&(x - centre));
        assert!(*value <= 1.5 * exact + 1.0, "{x} {value} {exact}");
    }
}

/// Each of two nodes without a metric has the value of its own side, whichever comes first in the order of
/// the nodes: neither takes what the other has just got.
#[test]
fn nodes_in_a_hole_do_not_depend_on_their_order() {
    let march = |holes: [f64; 2], seeds: [f64; 5]| {
        let [a, b] = holes;
        // Undefined at two nodes in a row.
        let text = format!("(1 + 0*ln(sqr(x1 - {a})*sqr(x1 - {b}))) I");
        let formula = Formula::<1>::parse(&text, &[]).expect("a formula");
        let nodes = Nodes::new(&formula, &Cubes::new(1, vec![[0], [1]]).expect("in range"));
        nodes.march(&formula, seeds.to_vec()).expect("seeds")
    };
    let none = f64::INFINITY;
    let values = march([1.0, 2.0], [5.0, none, none, 0.0, none]);
    assert_eq!(values, [5.0, 5.0, 0.0, 0.0, 1.0]);
    let mirrored = march([2.0, 3.0], [none, 0.0, none, none, 5.0]);
    assert_eq!(mirrored, [1.0, 0.0, 0.0, 5.0, 5.0]);
}
