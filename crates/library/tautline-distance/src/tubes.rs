//! Tubes about the sets, with a lower bound on the metric, that short curves cannot leave.

use nalgebra::SVector;
use tautline_check::Region;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{hamiltonian::eigenvalues, marching::gram, seed::distance};

/// How far below the least eigenvalue at samples the constant lies that is proved, in turn.
const MARGINS: [f64; 3] = [0.93, 0.8, 0.6];

/// The samples along each axis, by dimension.
const SAMPLES: [usize; 4] = [201, 41, 15, 9];

/// How often the radius grows with the constant that belongs to it.
const ROUNDS: usize = 20;

/// Returns tubes that curves of length `hi` cannot leave; `None` if none are found.
pub(crate) fn tubes<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curve: &[SVector<f64, D>],
    hi: f64,
) -> Option<Region> {
    let bounded: Vec<(&Shape<D>, SVector<f64, D>, f64)> = [(0, curve.first()?), (1, curve.last()?)]
        .into_iter()
        .filter_map(|(n, end)| Some((&sets[n], *end, diameter(&sets[n], end)?)))
        .collect();
    let needed = if bounded.len() == 2 { 0.5 * hi } else { hi };
    for margin in MARGINS {
        // The least eigenvalue at the ends themselves.
        let at_ends = bounded.iter().map(|(.., end, _)| least(formula, end));
        let mut c1 = margin * at_ends.reduce(least_of)?;
        for _ in 0..ROUNDS {
            if !(c1 > 0.0) {
                return None;
            }
            let radius = needed / c1.sqrt() * (1.0 + 1e-9);
            let found = bounded
                .iter()
                .map(|(set, end, wide)| least_within(formula, set, end, radius, radius + wide))
                .reduce(least_of)?;
            if margin * found >= c1 {
                let region = Region::Tubes { radius, c1 };
                if region.prove(formula, sets.each_ref(), hi).is_ok() {
                    return Some(region);
                }
                break;
            }
            // A little less, so that the rounds end.
            c1 = 0.98 * margin * found;
        }
    }
    None
}

/// Returns the least eigenvalue of `H` at a point; NaN if `H` is undefined.
fn least<const D: usize>(formula: &Formula<D>, x: &SVector<f64, D>) -> f64 {
    eigenvalues(&gram(formula, x)).into_iter().reduce(least_of).unwrap_or(f64::NAN)
}

/// Returns the less of two numbers; NaN if one of them is.
fn least_of(a: f64, b: f64) -> f64 {
    if a.is_nan() || a <= b { a } else { b }
}

/// Returns the least eigenvalue at samples within `radius` of a set, all of which lie within `reach`
/// of `end` along each axis; 0 if `H` is undefined at one of them.
fn least_within<const D: usize>(
    formula: &Formula<D>,
    set: &Shape<D>,
    end: &SVector<f64, D>,
    radius: f64,
    reach: f64,
) -> f64 {
    let n = SAMPLES[D - 1];
    let mut found = f64::INFINITY;
    for sample in 0..n.pow(D as u32) {
        let mut at = sample;
        let x = SVector::from_fn(|i, _| {
            let step = (at % n) as f64 / (n - 1) as f64;
            at /= n;
            end[i] + reach * (2.0 * step - 1.0)
        });
        if set.pieces().into_iter().any(|piece| distance(piece, &x) <= radius) {
            let here = least(formula, &x);
            if !(here > 0.0) {
                return 0.0;
            }
            found = found.min(here);
        }
    }
    found
}

/// Returns a length that no member of a set exceeds in its distance from `x`; `None` if there is none.
fn diameter<const D: usize>(set: &Shape<D>, x: &SVector<f64, D>) -> Option<f64> {
    match set {
        Shape::Point(point) => Some((point.position() - x).norm()),
        Shape::Ball(ball) => Some((ball.centre() - x).norm() + ball.r()),
        Shape::AxisBox(side) => Some((side.lower() - x).norm() + (side.upper() - x).norm()),
        Shape::Union(shapes) => {
            let all: Option<Vec<f64>> = shapes.iter().map(|shape| diameter(shape, x)).collect();
            Some(all?.into_iter().fold(0.0, f64::max))
        }
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_check::Region;
    use tautline_formula::Formula;
    use tautline_sets::{HalfSpace, Point, Shape};

    use super::{least_of, tubes};

    fn point(x: [f64; 2]) -> Shape<2> {
        Shape::Point(Point::new(x).expect("finite"))
    }

    /// One tube has to be as wide as curves are long, two together.
    #[test]
    fn a_single_tube_is_as_wide_as_two() {
        let flat = Formula::<2>::parse("4 I", &[]).expect("a formula");
        let wall = Shape::HalfSpace(HalfSpace::at_least([1.0, 0.0], 1.0).expect("a normal"));
        let curve = [vector![0.0, 0.0], vector![1.0, 0.0]];
        let radius =
            |second: Shape<2>| match tubes(&flat, &[point([0.0, 0.0]), second], &curve, 2.0) {
                Some(Region::Tubes { radius, c1 }) => radius * c1.sqrt(),
                other => panic!("{other:?}"),
            };
        let two = radius(point([1.0, 0.0]));
        assert!((two - 1.0).abs() < 1e-6 && (radius(wall) - 2.0 * two).abs() < 1e-6, "{two}");
    }

    /// The constant is that of both tubes.
    #[test]
    fn the_constant_holds_near_both_sets() {
        let slope = Formula::<2>::parse("exp(-x1) I", &[]).expect("a formula");
        let ends = [vector![0.0, 0.0], vector![1.0, 0.0]];
        let sets = ends.map(|x| point(x.into()));
        assert!(tubes(&slope, &sets, &ends, 0.8).is_some());
        let back = [sets[1].clone(), sets[0].clone()];
        assert!(tubes(&slope, &back, &[ends[1], ends[0]], 0.8).is_some());
        // Undefined near one of them.
        let pole = Formula::<2>::parse("(1 + 0*ln(x1 + 0.1)) I", &[]).expect("a formula");
        assert_eq!(tubes(&pole, &sets, &ends, 1.0), None);
    }

    /// The curve leaves the first of two points, and the metric is smaller about the second.
    #[test]
    fn the_constant_holds_near_all_pieces_of_a_set() {
        let slope = Formula::<2>::parse("(1.5 - tanh(x1 - 4)) I", &[]).expect("a formula");
        let ends = [vector![0.0, 0.0], vector![0.0, 1.0]];
        let from = Shape::Union(vec![point(ends[0].into()), point([8.0, 0.0])]);
        let sets = [from, point(ends[1].into())];
        // 1.5 − tanh 4 and less, about the second point; 1.5 + tanh 4 about the others.
        match tubes(&slope, &sets, &ends, 1.6) {
            Some(Region::Tubes { c1, .. }) => assert!(c1 > 0.4 && c1 < 0.501, "{c1}"),
            other => panic!("{other:?}"),
        }
    }

    #[test]
    fn the_less_of_two_numbers_is_nan_if_one_of_them_is() {
        assert_eq!((least_of(1.0, 2.0), least_of(2.0, 1.0)), (1.0, 1.0));
        assert!(least_of(f64::NAN, 1.0).is_nan() && least_of(1.0, f64::NAN).is_nan());
    }
}
