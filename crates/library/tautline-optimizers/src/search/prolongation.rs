//! Prolongs a point sequence to another grid, by interpolation of degree seven in time.

use tautline_discretizations::{ANY, PointSequence};
use tautline_formula::InstructionSet;

/// The number of points that a polynomial interpolates.
const POINTS: usize = 8;

/// The reciprocals of the orders of the differences.
const RECIPROCALS: [f64; POINTS] = [1.0, 1.0, 0.5, 1.0 / 3.0, 0.25, 0.2, 1.0 / 6.0, 1.0 / 7.0];

/// Returns the coordinates of `sequence` on a grid of `n ≥ 1` subintervals. On each subinterval of
/// `sequence` it is the polynomial through the eight nearest points (through all points, if there are
/// fewer).
///
/// Both ends are kept exactly. If `sequence` has `N` chords, the error on a smooth curve is
/// `O(N⁻⁸)`. On fine grids it is less than the rounding of the points, and no Newton step remains
/// to be taken.
pub(crate) fn prolong(sequence: &PointSequence<ANY>, n: usize) -> Vec<f64> {
    prolong_into(sequence, n, InstructionSet::default(), Vec::new())
}

/// Prolongs like [`prolong`], with the given instructions and memory. The result has the same bits.
pub(crate) fn prolong_into(
    sequence: &PointSequence<ANY>,
    n: usize,
    instruction_set: InstructionSet,
    mut fine: Vec<f64>,
) -> Vec<f64> {
    fine.clear();
    fine.reserve_exact((n + 1) * sequence.dimension());
    match instruction_set {
        InstructionSet::Baseline => prolong_inline(sequence, n, &mut fine),
        InstructionSet::Widest => prolong_widest(sequence, n, &mut fine),
    }
    fine
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn prolong_widest(sequence: &PointSequence<ANY>, n: usize, fine: &mut Vec<f64>) {
    prolong_inline(sequence, n, fine);
}

#[inline(always)]
fn prolong_inline(sequence: &PointSequence<ANY>, n: usize, fine: &mut Vec<f64>) {
    match sequence.dimension() {
        1 => prolong_in::<1>(sequence, n, fine),
        2 => prolong_in::<2>(sequence, n, fine),
        3 => prolong_in::<3>(sequence, n, fine),
        d => prolong_in_any(d, sequence, n, fine),
    }
}

/// Prolongs in one of the usual dimensions.
#[inline(always)]
fn prolong_in<const D: usize>(sequence: &PointSequence<ANY>, n: usize, fine: &mut Vec<f64>) {
    let points = sequence.coordinates().as_chunks::<D>().0;
    let coarse = sequence.n().get();
    let count = (coarse + 1).min(POINTS);
    let fraction = 1.0 / n as f64;
    // The place of the next point on the coarse grid is whole + rest / n, without rounding.
    let (mut whole, mut rest) = (0, 0);
    while whole < coarse {
        let first = whole.saturating_sub(POINTS / 2 - 1).min(coarse + 1 - count);
        let mut coefficients = [[0.0; D]; POINTS];
        coefficients[..count].copy_from_slice(&points[first..first + count]);
        // The usual number is a constant that the compiler can use.
        if count == POINTS {
            differences(&mut coefficients, whole - first);
        } else {
            differences(&mut coefficients[..count], whole - first);
        }
        coefficients[0] = points[whole];
        let inside = (n - rest).div_ceil(coarse);
        for begin in (0..inside).step_by(LANES) {
            let mut s = [0.0; LANES];
            for lane in 0..LANES {
                s[lane] = (rest + (begin + lane) * coarse) as f64 * fraction;
            }
            let mut all = [[0.0; LANES]; D];
            for i in 0..D {
                all[i] = values(|k| coefficients[k][i], &s);
            }
            for lane in 0..LANES.min(inside - begin) {
                let mut point = [0.0; D];
                for i in 0..D {
                    point[i] = all[i][lane];
                }
                fine.extend_from_slice(&point);
            }
        }
        rest += inside * coarse;
        // If the new grid is coarser than the grid of `sequence`, this moves on by several
        // intervals.
        whole += rest / n;
        rest %= n;
    }
    fine.extend_from_slice(&points[coarse]);
}

/// Prolongs in a dimension that is a value: the same arithmetic, four coordinates at a time.
#[inline(always)]
fn prolong_in_any(d: usize, sequence: &PointSequence<ANY>, n: usize, fine: &mut Vec<f64>) {
    let points = sequence.coordinates();
    let coarse = sequence.n().get();
    let count = (coarse + 1).min(POINTS);
    let mut coefficients = vec![[0.0; POINTS]; d];
    // The place of the next point on the coarse grid is whole + rest / n, without rounding.
    let (mut whole, mut rest) = (0, 0);
    while whole < coarse {
        let first = whole.saturating_sub(POINTS / 2 - 1).min(coarse + 1 - count);
        let near = &points[first * d..(first + count) * d];
        for begin in (0..d).step_by(WIDTH) {
            let coefficients = &mut coefficients[begin..d.min(begin + WIDTH)];
            match coefficients.len() {
                1 => interpolate::<1>(&near[begin..], d, whole - first, coefficients),
                2 => interpolate::<2>(&near[begin..], d, whole - first, coefficients),
                3 => interpolate::<3>(&near[begin..], d, whole - first, coefficients),
                _ => interpolate::<WIDTH>(&near[begin..], d, whole - first, coefficients),
            }
        }
        for (coefficients, x) in coefficients.iter_mut().zip(&points[whole * d..]) {
            coefficients[0] = *x;
        }
        let inside = (n - rest).div_ceil(coarse);
        follow(d, &coefficients, [rest, coarse, n], inside, fine);
        rest += inside * coarse;
        // If the new grid is coarser than the grid of `sequence`, this moves on by several
        // intervals.
        whole += rest / n;
        rest %= n;
    }
    fine.extend_from_slice(&points[coarse * d..]);
}

/// The number of coordinates that are interpolated at once.
const WIDTH: usize = 4;

/// The number of points that are evaluated at once, coordinate by coordinate.
const LANES: usize = 8;

/// Adds the `count` values of the polynomials of all coordinates at
/// `s = rest/n, (rest + step)/n, …`.
#[inline(always)]
fn follow(
    d: usize,
    coefficients: &[[f64; POINTS]],
    [rest, step, n]: [usize; 3],
    count: usize,
    fine: &mut Vec<f64>,
) {
    let coefficients = &coefficients[..d];
    let fraction = 1.0 / n as f64;
    for begin in (0..count).step_by(LANES) {
        let mut s = [0.0; LANES];
        for lane in 0..LANES {
            s[lane] = (rest + (begin + lane) * step) as f64 * fraction;
        }
        let lanes = LANES.min(count - begin);
        let end = fine.len();
        fine.resize(end + lanes * d, 0.0);
        for i in 0..d {
            let values = values(|k| coefficients[i][k], &s);
            for (lane, point) in fine[end..].chunks_exact_mut(d).enumerate() {
                point[i] = values[lane];
            }
        }
    }
}

/// Returns the values of a polynomial, given its coefficients.
#[inline(always)]
fn values(coefficient: impl Fn(usize) -> f64, s: &[f64; LANES]) -> [f64; LANES] {
    let mut values = [coefficient(POINTS - 1); LANES];
    for k in (0..POINTS - 1).rev() {
        let coefficient = coefficient(k);
        for lane in 0..LANES {
            values[lane] = values[lane] * s[lane] + coefficient;
        }
    }
    values
}

/// Writes the coefficients, of `1, s, s², …`, of the polynomials through points at
/// `s = −place, 1 − place, 2 − place, …`, in `W` of their `d` coordinates. `near` begins with the first
/// of these coordinates.
#[inline(always)]
fn interpolate<const W: usize>(
    near: &[f64],
    d: usize,
    place: usize,
    coefficients: &mut [[f64; POINTS]],
) {
    let mut points = [[0.0; W]; POINTS];
    let count = near.len().div_ceil(d).min(POINTS);
    for (k, point) in points[..count].iter_mut().enumerate() {
        for i in 0..W {
            point[i] = near[k * d + i];
        }
    }
    // The usual number is a constant that the compiler can use.
    if count == POINTS {
        differences(&mut points, place);
    } else {
        differences(&mut points[..count], place);
    }
    for (i, coefficients) in coefficients[..W].iter_mut().enumerate() {
        for k in 0..POINTS {
            coefficients[k] = points[k][i];
        }
    }
}

/// Replaces points by the coefficients.
#[inline(always)]
fn differences<const W: usize>(points: &mut [[f64; W]], place: usize) {
    // Newton's coefficients, of 1, s − s₀, (s − s₀)(s − s₁), …, are differences divided by
    // factorials.
    for order in 1..points.len() {
        for k in (order..points.len()).rev() {
            for i in 0..W {
                points[k][i] = (points[k][i] - points[k - 1][i]) * RECIPROCALS[order];
            }
        }
    }
    // The factors are multiplied out, one after the other.
    for factor in (0..points.len() - 1).rev() {
        let root = factor as f64 - place as f64;
        for k in factor..points.len() - 1 {
            for i in 0..W {
                points[k][i] -= points[k + 1][i] * root;
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline_discretizations::PointSequence;

    use super::{InstructionSet, prolong_into};

    /// Returns the points of a sequence on another grid.
    fn prolong<const D: usize>(sequence: &PointSequence<D>, n: usize) -> Vec<SVector<f64, D>> {
        bytemuck::cast_slice(&super::prolong(&sequence.clone().into_any(), n)).to_vec()
    }

    #[test]
    fn curves_of_degree_seven_are_interpolated_exactly() {
        let curve = |t: f64| vector![t.powi(7) - t, 2.0 - t.powi(6)];
        for (coarse, fine) in [(7, 20), (8, 8), (9, 11), (32, 45), (45, 32), (99, 7), (9, 1)] {
            let points = (0..=coarse).map(|k| curve(k as f64 / coarse as f64)).collect();
            let sequence = PointSequence::new(points).expect("finite");
            let found = prolong(&sequence, fine);
            assert_eq!(found.len(), fine + 1);
            assert_eq!(
                (found.first(), found.last()),
                (Some(sequence.first()), Some(sequence.last()))
            );
            for (k, point) in found.iter().enumerate() {
                // There are eight weights up to 5 and coordinates up to 2.
                assert!((point - curve(k as f64 / fine as f64)).amax() < 2e-14);
            }
        }
    }

    /// A polynomial through fewer points has a lower degree.
    #[test]
    fn three_points_are_joined_by_a_parabola() {
        let parabola = |t: f64| vector![1.0 - 3.0 * t * t];
        let points = [0.0, 0.5, 1.0].map(parabola).to_vec();
        let found = prolong(&PointSequence::new(points).expect("finite"), 7);
        for (k, point) in found.iter().enumerate() {
            // There are three weights up to 1 and coordinates up to 2.
            assert!((point - parabola(k as f64 / 7.0)).amax() < 4e-15);
        }
    }

    #[test]
    fn points_of_both_grids_are_kept_bit_by_bit() {
        let curve = |k: usize| vector![(7 * k) as f64 + (k as f64).sin(), 1.0 / (1.0 + k as f64)];
        let sequence = PointSequence::new((0..=20).map(curve).collect()).expect("finite");
        for by in [1, 2, 9, 16] {
            let fine = prolong(&sequence, 20 * by);
            let kept: Vec<_> = fine.iter().step_by(by).copied().collect();
            assert_eq!(kept, sequence.points());
        }
    }

    /// Some batches are full, and some are partly filled.
    #[test]
    fn wider_instructions_make_the_same_points() {
        let curve = |k: usize| vector![(k as f64).sin(), 1.0 / (1.0 + k as f64)];
        for (coarse, n) in [(9, 3), (9, 20), (10, 90), (17, 136), (40, 1000)] {
            let sequence = PointSequence::new((0..=coarse).map(curve).collect()).expect("finite");
            let sequence = sequence.into_any();
            let [baseline, widest] = [InstructionSet::Baseline, InstructionSet::Widest]
                .map(|instruction_set| prolong_into(&sequence, n, instruction_set, Vec::new()));
            assert_eq!((&widest, widest.len()), (&baseline, 2 * (n + 1)));
        }
    }

    /// Nothing of the points that the memory held before is left.
    #[test]
    fn memory_that_was_used_makes_the_same_points() {
        let curve = |k: usize| vector![(k as f64).sin(), 1.0 / (1.0 + k as f64)];
        let sequence =
            PointSequence::new((0..=10).map(curve).collect()).expect("finite").into_any();
        for n in [3, 90] {
            let used = vec![7.0; 80];
            let found = prolong_into(&sequence, n, InstructionSet::Baseline, used);
            assert_eq!(found, super::prolong(&sequence, n));
        }
    }

    #[test]
    fn two_points_are_joined_by_a_line() {
        let sequence = PointSequence::straight([0.0], [1.0], 1).expect("finite");
        assert_eq!(
            prolong(&sequence, 4).iter().map(|x| x[0]).collect::<Vec<_>>(),
            [0.0, 0.25, 0.5, 0.75, 1.0]
        );
    }
}
