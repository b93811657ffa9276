//! Prolongs a point sequence to another grid, by interpolation of degree seven in time.

use nalgebra::SVector;
use tautline_discretizations::PointSequence;
use tautline_formula::InstructionSet;

/// The number of points that a polynomial interpolates.
const POINTS: usize = 8;

/// The reciprocals of the orders of the differences.
const RECIPROCALS: [f64; POINTS] = [1.0, 1.0, 0.5, 1.0 / 3.0, 0.25, 0.2, 1.0 / 6.0, 1.0 / 7.0];

/// Returns `sequence` on a grid of `n ≥ 1` subintervals. On each subinterval of `sequence` it is
/// the polynomial through the eight nearest points (through all points, if there are fewer).
///
/// Both ends are kept exactly. If `sequence` has `N` chords, the error on a smooth curve is
/// `O(N⁻⁸)`. On fine grids it is less than the rounding of the points, and no Newton step remains
/// to be taken.
pub(crate) fn prolong<const D: usize>(
    sequence: &PointSequence<D>,
    n: usize,
) -> Vec<SVector<f64, D>> {
    prolong_into(sequence, n, InstructionSet::default(), Vec::new())
}

/// Prolongs like [`prolong`], with the given instructions and memory. The result has the same bits.
pub(crate) fn prolong_into<const D: usize>(
    sequence: &PointSequence<D>,
    n: usize,
    instruction_set: InstructionSet,
    mut fine: Vec<SVector<f64, D>>,
) -> Vec<SVector<f64, D>> {
    let points = sequence.points();
    let coarse = points.len() - 1;
    let count = points.len().min(POINTS);
    fine.clear();
    fine.reserve_exact(n + 1);
    // The place of the next point on the coarse grid is whole + rest / n, without rounding.
    let (mut whole, mut rest) = (0, 0);
    while whole < coarse {
        let first = whole.saturating_sub(POINTS / 2 - 1).min(points.len() - count);
        let near = &points[first..first + count];
        let place = whole - first;
        // The usual length is a constant that the compiler can use.
        let usual: Result<&[_; POINTS], _> = near.try_into();
        let mut coefficients =
            usual.map_or_else(|_| coefficients(near, place), |near| coefficients(near, place));
        coefficients[0] = points[whole];
        let inside = (n - rest).div_ceil(coarse);
        let steps = [rest, coarse, n];
        match instruction_set {
            InstructionSet::Baseline => follow_inline(&coefficients, steps, inside, &mut fine),
            InstructionSet::Widest => follow_widest(&coefficients, steps, inside, &mut fine),
        }
        rest += inside * coarse;
        // If the new grid is coarser than the grid of `sequence`, this moves on by several
        // intervals.
        whole += rest / n;
        rest %= n;
    }
    fine.push(points[coarse]);
    fine
}

/// The number of points that are evaluated at once, coordinate by coordinate.
const LANES: usize = 8;

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn follow_widest<const D: usize>(
    coefficients: &[SVector<f64, D>; POINTS],
    steps: [usize; 3],
    count: usize,
    fine: &mut Vec<SVector<f64, D>>,
) {
    follow_inline(coefficients, steps, count, fine);
}

/// Adds the `count` values of a polynomial at `s = rest/n, (rest + step)/n, …`.
#[inline(always)]
fn follow_inline<const D: usize>(
    coefficients: &[SVector<f64, D>; POINTS],
    [rest, step, n]: [usize; 3],
    count: usize,
    fine: &mut Vec<SVector<f64, D>>,
) {
    let fraction = 1.0 / n as f64;
    for begin in (0..count).step_by(LANES) {
        let mut s = [0.0; LANES];
        for lane in 0..LANES {
            s[lane] = (rest + (begin + lane) * step) as f64 * fraction;
        }
        let mut values = [[0.0; LANES]; D];
        for i in 0..D {
            let mut value = [coefficients[POINTS - 1][i]; LANES];
            for coefficient in coefficients[..POINTS - 1].iter().rev() {
                for lane in 0..LANES {
                    value[lane] = value[lane] * s[lane] + coefficient[i];
                }
            }
            values[i] = value;
        }
        for lane in 0..LANES.min(count - begin) {
            let mut point = SVector::zeros();
            for i in 0..D {
                point[i] = values[i][lane];
            }
            fine.push(point);
        }
    }
}

/// Returns the coefficients, of `1, s, s², …`, of the polynomial through points at
/// `s = −place, 1 − place, 2 − place, …`.
#[inline(always)]
fn coefficients<const D: usize>(
    points: &[SVector<f64, D>],
    place: usize,
) -> [SVector<f64, D>; POINTS] {
    let mut coefficients = [SVector::zeros(); POINTS];
    coefficients[..points.len()].copy_from_slice(points);
    // Newton's coefficients, of 1, s − s₀, (s − s₀)(s − s₁), …, are differences divided by
    // factorials.
    for order in 1..points.len() {
        for k in (order..points.len()).rev() {
            coefficients[k] = (coefficients[k] - coefficients[k - 1]) * RECIPROCALS[order];
        }
    }
    // The factors are multiplied out, one after the other.
    for factor in (0..points.len() - 1).rev() {
        let root = factor as f64 - place as f64;
        for k in factor..points.len() - 1 {
            let above = coefficients[k + 1];
            coefficients[k] -= above * root;
        }
    }
    coefficients
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_discretizations::PointSequence;

    use super::{InstructionSet, prolong, prolong_into};

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
            let [baseline, widest] = [InstructionSet::Baseline, InstructionSet::Widest]
                .map(|instruction_set| prolong_into(&sequence, n, instruction_set, Vec::new()));
            assert_eq!((&widest, widest.len()), (&baseline, n + 1));
        }
    }

    /// Nothing of the points that the memory held before is left.
    #[test]
    fn memory_that_was_used_makes_the_same_points() {
        let curve = |k: usize| vector![(k as f64).sin(), 1.0 / (1.0 + k as f64)];
        let sequence = PointSequence::new((0..=10).map(curve).collect()).expect("finite");
        for n in [3, 90] {
            let used = vec![vector![7.0, 7.0]; 40];
            let found = prolong_into(&sequence, n, InstructionSet::Baseline, used);
            assert_eq!(found, prolong(&sequence, n));
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
