//! What must not change what is proved.

use nalgebra::{SVector, vector};
use tautline_check::{Certificate, Cubes, Level, Proved, Region};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    helpers::{point, proved, several_levels},
    wave::Wave,
};

/// The wave whose certificates are compared. Its ends are multiples of powers of two.
const AMPLITUDE: f64 = 0.25;
const ENDS: [[f64; 2]; 2] = [[0.0625, 0.03125], [0.9375, 0.28125]];
const EXPONENTS: [i32; 2] = [-4, -5];

struct Compared {
    wave: Wave,
    hi: f64,
    certificate: Certificate<2>,
    proved: Proved<2>,
}

fn compared() -> Compared {
    let wave = Wave::new(AMPLITUDE, 2.0);
    let [x, y] = ENDS.map(SVector::from);
    let hi = 1.01 * wave.distance(&x, &y);
    let functions = [wave.calibration([x, y], 0.4), wave.calibration([y, x], 0.4)];
    let certificate = several_levels(
        wave.formula(),
        ENDS.map(point),
        hi,
        wave.declared(),
        &EXPONENTS,
        [&functions[0], &functions[1]],
    );
    let proved = proved(&certificate);
    Compared { wave, hi, certificate, proved }
}

impl Compared {
    /// Returns the certificate with other cubes and values, made place by place and value by value.
    fn with_levels(
        &self,
        exponent: i32,
        place: impl Fn(usize, [i32; 2]) -> [i32; 2],
        value: impl Fn(f64) -> f64,
    ) -> Vec<Level<2>> {
        let old = self.certificate.levels.iter().enumerate();
        old.map(|(n, level)| {
            let places = level.cubes().places().iter().map(|&k| place(n, k)).collect();
            let cubes = Cubes::new(level.cubes().exponent() + exponent, places).expect("in range");
            // A map of cubes that keeps the order of the nodes, or swaps the axes.
            let corner = place(n, [0, 0]);
            let nodes: std::collections::BTreeMap<[i32; 2], usize> =
                level.nodes().iter().enumerate().map(|(n, &node)| (node, n)).collect();
            let swapped = place(n, [1, 0])[1] > corner[1];
            let old_node = |node: &[i32; 2]| {
                let [i, j] = [node[0] - 2 * corner[0], node[1] - 2 * corner[1]];
                nodes[&if swapped { [j, i] } else { [i, j] }]
            };
            let new_nodes = cubes.nodes();
            let values = level
                .values()
                .each_ref()
                .map(|values| new_nodes.iter().map(|node| value(values[old_node(node)])).collect());
            Level::new(n, cubes, values).expect("finite")
        })
        .collect()
    }

    fn declared(&self, factor: f64) -> Region {
        Region::Declared { c1: factor * self.wave.c1() }
    }
}

fn scaled(formula: &Formula<2>, text: &str) -> Formula<2> {
    // The entries of the pull-back by (x₁ + a sin kx₂, x₂).
    let _ = formula;
    Formula::parse(text, &[("a", AMPLITUDE), ("k", 2.0)]).expect("a formula")
}

/// Lengths are doubled, and every step of the proof is a multiple by a power of two.
#[test]
fn four_times_the_metric_doubles_the_bound() {
    let base = compared();
    let mut certificate = base.certificate.clone();
    certificate.formula = scaled(&certificate.formula, "pullback(2*x1 + 2*a*sin(k*x2), 2*x2)");
    certificate.hi = 2.0 * base.hi;
    certificate.region = base.declared(4.0);
    certificate.levels = base.with_levels(0, |_, place| place, |value| 2.0 * value);
    let proved = proved(&certificate);
    // The formulas differ by roundings.
    let ratio = proved.lower / base.proved.lower;
    assert!((ratio - 2.0).abs() < 1e-12, "{ratio}");
    assert_eq!(proved.corridor, base.proved.corridor);
}

#[test]
fn the_sets_can_be_exchanged() {
    let base = compared();
    let mut certificate = base.certificate.clone();
    certificate.sets.reverse();
    for (n, level) in base.certificate.levels.iter().enumerate() {
        let [u, v] = level.values().clone();
        certificate.levels[n] = Level::new(n, level.cubes().clone(), [v, u]).expect("finite");
    }
    let proved = proved(&certificate);
    assert_eq!(proved, base.proved);
}

#[test]
fn the_axes_can_be_exchanged() {
    let base = compared();
    let mut certificate = base.certificate.clone();
    certificate.formula = scaled(&certificate.formula, "pullback(x1, x2 + a*sin(k*x1))");
    certificate.sets = ENDS.map(|[i, j]| point([j, i]));
    certificate.levels = base.with_levels(0, |_, [i, j]| [j, i], |value| value);
    let proved = proved(&certificate);
    // Factors of H − ε I come in another order, and round differently.
    assert!((proved.lower / base.proved.lower - 1.0).abs() < 1e-12);
    let places = base.proved.corridor.places().iter().map(|&[i, j]| [j, i]).collect();
    assert_eq!(proved.corridor, Cubes::new(EXPONENTS[1], places).expect("in range"));
}

/// The metric does not depend on `x₁`.
#[test]
fn a_translation_by_cubes_changes_nothing() {
    let base = compared();
    for steps in [1, -3, 1 << 20] {
        let step = f64::from(steps) * 2.0_f64.powi(EXPONENTS[0]);
        let mut certificate = base.certificate.clone();
        certificate.sets = ENDS.map(|[i, j]| point([i + step, j]));
        let moved = |n: usize, [i, j]: [i32; 2]| [i + (steps << n), j];
        certificate.levels = base.with_levels(0, moved, |value| value);
        let proved = proved(&certificate);
        assert_eq!(proved.lower, base.proved.lower, "{steps}");
        assert_eq!(proved.levels, base.proved.levels);
    }
}

/// `x ↦ 2x` with `H(x/2)/4`.
#[test]
fn other_units_of_the_coordinates_change_nothing() {
    let base = compared();
    let mut certificate = base.certificate.clone();
    certificate.formula =
        scaled(&certificate.formula, "pullback(0.5*x1 + a*sin(0.5*k*x2), 0.5*x2)");
    certificate.sets = ENDS.map(|x| point(x.map(|t| 2.0 * t)));
    certificate.region = base.declared(0.25);
    certificate.levels = base.with_levels(1, |_, place| place, |value| value);
    let proved = proved(&certificate);
    assert!((proved.lower / base.proved.lower - 1.0).abs() < 1e-12);
    assert_eq!(proved.corridor.places(), base.proved.corridor.places());
}

/// Only differences of values count.
#[test]
fn a_constant_added_to_the_values_changes_roundings_only() {
    let base = compared();
    for constant in [0.5, -3.0, 1024.0] {
        let mut certificate = base.certificate.clone();
        certificate.levels = base.with_levels(0, |_, place| place, |value| value + constant);
        let proved = proved(&certificate);
        // Adding rounds the values by up to ε|c|, and their slopes by that over the side; the 4096
        // bins are in other places by as much.
        let tolerance = 8.0 * f64::EPSILON * constant.abs() * 2.0_f64.powi(6) + 1e-12;
        let change = (proved.lower / base.proved.lower - 1.0).abs();
        assert!(change <= tolerance, "{constant}: {change:e} > {tolerance:e}");
    }
}

/// Nothing is pruned at the length of a much longer curve.
#[test]
fn without_pruning_the_bound_is_not_larger() {
    let base = compared();
    let [x, y] = ENDS.map(SVector::from);
    let functions = [base.wave.calibration([x, y], 0.4), base.wave.calibration([y, x], 0.4)];
    let unpruned = several_levels(
        base.wave.formula(),
        ENDS.map(point),
        4.0 * base.hi,
        base.wave.declared(),
        &[-3],
        [&functions[0], &functions[1]],
    );
    let pruned = several_levels(
        base.wave.formula(),
        ENDS.map(point),
        base.hi,
        base.wave.declared(),
        &[-3],
        [&functions[0], &functions[1]],
    );
    assert!(proved(&unpruned).lower <= proved(&pruned).lower);
}

/// A set as a union of pieces, or as one of them that holds the other.
#[test]
fn a_piece_inside_another_one_changes_nothing() {
    let base = compared();
    let mut certificate = base.certificate.clone();
    let [x, _] = ENDS;
    certificate.sets[0] = Shape::Union(vec![point(x), point(x)]);
    assert_eq!(proved(&certificate), base.proved);
    let far: SVector<f64, 2> = vector![0.125, 0.0625];
    certificate.sets[0] = Shape::Union(vec![point(x), point(far.into())]);
    // A larger set is not farther away.
    assert!(certificate.check().map_or(0.0, |proved| proved.lower) <= base.proved.lower);
}
