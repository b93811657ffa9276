//! The same problem with its sets exchanged, moved or in other units has the same certificate.

use nalgebra::{SVector, matrix, vector};
use tautline_distance::{DistanceError, Found, Wanted};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    attempt::{attempt, holds},
    flat::{at_least, ball, formula, nearest, point},
};

fn bounds<const D: usize>(found: &Result<Found<D>, DistanceError>) -> [f64; 2] {
    let proved = &found.as_ref().expect("found").proved;
    [proved.lower, proved.upper.expect("a curve")]
}

/// In the half-plane, the points `λ (−3/4, 1)` have the distance `arsinh 3/4 = ln 2` from the vertical
/// `x₁ = 0`, along circles about the origin.
pub(crate) fn problem() -> ([Shape<2>; 2], Vec<Vec<SVector<f64, 2>>>) {
    let scales = [1.0, 4.0];
    let sets = [
        Shape::Union(scales.map(|scale| point([-0.75 * scale, scale])).to_vec()),
        at_least([1.0, 0.0], 0.0),
    ];
    let curves = scales.map(|scale| {
        let arc = |n: i32| {
            let angle = 0.75_f64.atan() * (1.0 - f64::from(n) / 200.0);
            vector![-angle.sin(), angle.cos()] * (1.25 * scale)
        };
        (0..=200).map(arc).collect()
    });
    (sets, curves.to_vec())
}

/// A search from an unbounded set is the one to it, with every curve turned round.
#[test]
fn a_search_from_a_half_space_is_the_one_to_it() {
    let formula = Formula::<2>::parse("1/sqr(x2) I", &[]).expect("a formula");
    let (sets, curves) = problem();
    let wanted = Wanted { gap: 2e-4, cubes: 100_000 };
    let there = attempt(&formula, &sets, &curves, wanted).expect("found");
    holds(&there, 2_f64.ln(), 1e-12, 2e-4);
    let turned = [sets[1].clone(), sets[0].clone()];
    let back: Vec<Vec<_>> =
        curves.iter().map(|curve| curve.iter().rev().copied().collect()).collect();
    let back = attempt(&formula, &turned, &back, wanted).expect("found");
    // All of it: sets, curve and levels.
    assert_eq!(there.certificate, back.certificate);
    assert_eq!(there.certificate.sets, sets);
    // The last point of the curve was moved into the wall by some roundings.
    let curve = there.certificate.curve.expect("a curve");
    assert_eq!(curve[..200], curves[0][..200]);
}

/// Between bounded sets nothing is exchanged, and the two functions change places.
#[test]
fn exchanged_sets_have_exchanged_functions() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let sets = [ball([-1.0, -0.5], 0.25), point([1.0, 0.75])];
    // A curve of an odd number of chords has the same middle from both ends.
    let curve = nearest(&h, &sets)[0].line(7);
    let back: Vec<_> = curve.iter().rev().copied().collect();
    let turned = [sets[1].clone(), sets[0].clone()];
    let there = attempt(&formula(&h), &sets, &[curve], Wanted::gap(1e-3));
    let back = attempt(&formula(&h), &turned, &[back], Wanted::gap(1e-3));
    let ([a, b], [c, d]) = (bounds(&there), bounds(&back));
    assert!((a - c).abs() < 1e-9 * a && (b - d).abs() < 1e-12 * b, "{a} {c} {b} {d}");
    let levels = |found: Result<Found<2>, _>| found.expect("found").certificate.levels;
    let (there, back) = (levels(there), levels(back));
    assert_eq!(there.len(), back.len());
    let values = |side: usize| (there[0].values()[side].iter()).zip(&back[0].values()[1 - side]);
    assert!(values(0).chain(values(1)).all(|(a, b)| (a - b).abs() < 1e-9));
}

/// The metric times 4 in units of half the length has the same distances, and the same cubes. Powers of two
/// do not round.
#[test]
fn other_units_have_the_same_certificate() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let at = |unit: f64| {
        let sets =
            [ball(vector![-1.0, -0.5] * unit, 0.25 * unit), point(vector![1.0, 0.75] * unit)];
        let h = h / (unit * unit);
        let curve = nearest(&h, &sets)[0].line(7);
        attempt(&formula(&h), &sets, &[curve], Wanted::gap(1e-3))
    };
    let ([a, b], [c, d]) = (bounds(&at(1.0)), bounds(&at(0.5)));
    assert!((a - c).abs() < 1e-9 * a && (b - d).abs() < 1e-9 * b, "{a} {c} {b} {d}");
}
