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
        let mut c1 = margin
            * bounded.iter().map(|(.., end, _)| least(formula, end)).fold(f64::INFINITY, f64::min);
        for _ in 0..ROUNDS {
            let radius = needed / c1.sqrt() * (1.0 + 1e-9);
            let found = bounded
                .iter()
                .map(|(set, end, wide)| least_within(formula, set, end, radius, radius + wide))
                .fold(f64::INFINITY, f64::min);
            if !(found > 0.0) {
                return None;
            }
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
    let h = gram(formula, x);
    if !h.iter().all(|entry| entry.is_finite()) {
        return f64::NAN;
    }
    eigenvalues(&h).into_iter().fold(f64::INFINITY, f64::min)
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
        Shape::HalfSpace(_) => None,
        Shape::Union(shapes) => {
            let all: Option<Vec<f64>> = shapes.iter().map(|shape| diameter(shape, x)).collect();
            Some(all?.into_iter().fold(0.0, f64::max))
        }
    }
}
