//! The best point sequence on a straight line, by dynamic programming.

use crate::newton::discrete_energy::DiscreteEnergy;

/// The grid extends beyond both ends by this fraction of the distance between them, since the best
/// sequence may begin with a step back into a valley.
const OVERSHOOT: f64 = 0.1;

/// Returns the sequence of least discrete energy from `a` to `b` whose inner points lie on a grid
/// of the straight line through both. The result is `None` if no such sequence has a finite energy.
/// The grid divides the line between `a` and `b` into `intervals`.
///
/// With few chords a minimiser may leap over an expensive region between two nodes (Section 5). It
/// can do so in many ways, each of which is a local minimiser. This start for the local search
/// misses none of them, up to the resolution of the grid. Let `c(x, y)` be the energy of one chord.
/// The least energy `Vₙ(y)` of `n` chords from `a` to `y` satisfies
/// `Vₙ₊₁(y) = minₓ Vₙ(x) + c(x, y)`.
pub(crate) fn line_minimum(
    energy: &DiscreteEnergy<'_>,
    a: &[f64],
    b: &[f64],
    n: usize,
    intervals: usize,
) -> Option<Vec<f64>> {
    let start = (OVERSHOOT * intervals as f64) as usize;
    let last = 2 * start + intervals;
    let at = |k: usize| {
        let t = (k as f64 - start as f64) / intervals as f64;
        a.iter().zip(b).map(move |(a, b)| a * (1.0 - t) + b * t)
    };
    let points: Vec<f64> = (0..=last).flat_map(at).collect();
    let costs = |chords: &[[usize; 2]]| {
        // No sequence passes through points where the metric is undefined.
        let cost = |energy: f64| if energy >= 0.0 { energy } else { f64::INFINITY };
        energy.of_chords(&points, chords).into_iter().map(cost).collect::<Vec<f64>>()
    };
    let best = best_path(start, intervals, n, &costs)?;
    let d = a.len();
    Some(best.into_iter().flat_map(|k| points[k * d..][..d].iter().copied()).collect())
}

/// Returns the indices of the best sequence of `n` chords from the index `start` to
/// `start + intervals`, given the costs of chords between indices. The function does not know the
/// points.
fn best_path(
    start: usize,
    intervals: usize,
    n: usize,
    costs: &dyn Fn(&[[usize; 2]]) -> Vec<f64>,
) -> Option<Vec<usize>> {
    let (end, last) = (start + intervals, 2 * start + intervals);
    // The cost of one particular sequence. No chord of the best sequence costs more. With many
    // chords, this excludes most of the long ones.
    let step = |k: usize| start + (k * intervals + n / 2) / n;
    let steps: Vec<[usize; 2]> = (0..n).map(|k| [step(k), step(k + 1)]).collect();
    let affordable: f64 = costs(&steps).iter().sum();
    // Row y holds the chords that end at y, each with the index of its origin.
    let row = |y: usize| -> Vec<(usize, f64)> {
        let arriving: Vec<[usize; 2]> = (0..=last).map(|x| [x, y]).collect();
        let costs = costs(&arriving).into_iter().enumerate();
        costs.filter(|(_, cost)| *cost <= affordable).collect()
    };
    let rows: Vec<_> = (0..=last).map(row).collect();
    let mut value = vec![f64::INFINITY; last + 1];
    value[start] = 0.0;
    let mut came_from: Vec<Vec<usize>> = Vec::with_capacity(n);
    for _ in 0..n {
        let best = |row: &Vec<(usize, f64)>| {
            row.iter().fold((f64::INFINITY, start), |best, &(x, cost)| {
                let sum = cost + value[x];
                if sum < best.0 { (sum, x) } else { best }
            })
        };
        let (next, from) = rows.iter().map(best).unzip();
        value = next;
        came_from.push(from);
    }
    if !value[end].is_finite() {
        return None;
    }
    let mut sequence = vec![end];
    for from in came_from.iter().rev() {
        sequence.push(from[sequence[sequence.len() - 1]]);
    }
    sequence.reverse();
    Some(sequence)
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use nalgebra::{SVector, vector};
    use tautline_discretizations::Rule;
    use tautline_formula::Prepared;
    use tautline_metrics::gallery::{Hyperbolic, Valleys};

    use crate::newton::discrete_energy::DiscreteEnergy;

    /// Returns the points of the best sequence.
    fn line_minimum<const D: usize>(
        energy: &DiscreteEnergy<'_>,
        a: &SVector<f64, D>,
        b: &SVector<f64, D>,
        n: usize,
        intervals: usize,
    ) -> Option<Vec<SVector<f64, D>>> {
        let line = super::line_minimum(energy, a.as_slice(), b.as_slice(), n, intervals)?;
        Some(bytemuck::cast_slice(&line).to_vec())
    }

    /// Returns the energy of a rule over the valleys.
    fn valleys(rule: Rule) -> DiscreteEnergy<'static> {
        static METRIC: LazyLock<Prepared<Valleys, 2>> = LazyLock::new(|| Prepared::new(Valleys));
        DiscreteEnergy::new(rule, &*METRIC)
    }

    /// Two chords of the left rule lead from valley to valley over two ridges. One leap costs
    /// `32 π²`, twice `(4π)²`. It is best to rest half way, in the valley at `2π`, which costs
    /// `2 · 2 · (2π)²`.
    #[test]
    fn the_left_rule_steps_from_valley_to_valley() {
        let (a, b) = (vector![0.0, 1.0], vector![4.0 * std::f64::consts::PI, 1.0]);
        let line = line_minimum(&valleys(Rule::LEFT_ENDPOINT), &a, &b, 2, 64).expect("finite");
        assert_eq!((line[0], line[2]), (a, b));
        assert!((line[1] - (a + b) * 0.5).norm() < 1e-14, "{}", line[1]);
    }

    /// With many chords the best sequence is near the geodesic, with chords of equal length.
    #[test]
    fn a_flat_metric_has_equal_chords() {
        let flat = tautline_metrics::gallery::Constant::new(nalgebra::matrix![2.0]).expect("2 > 0");
        let line = line_minimum(
            &DiscreteEnergy::new(Rule::TRAPEZOIDAL, &Prepared::<_, 1>::new(flat)),
            &vector![0.0],
            &vector![8.0],
            16,
            64,
        );
        let line: Vec<f64> = line.expect("finite").iter().map(|x| x[0]).collect();
        assert_eq!(line, (0..=16).map(|k| 0.5 * f64::from(k)).collect::<Vec<_>>());
    }

    /// From the slope at `x₁ = 1.2` it saves energy to step back towards the valley before the
    /// leap.
    #[test]
    fn a_leap_begins_with_a_step_back() {
        let (a, b) = (vector![1.2, 0.0], vector![12.0, 0.0]);
        let line = line_minimum(&valleys(Rule::LEFT_ENDPOINT), &a, &b, 4, 128).expect("finite");
        assert!(line.iter().any(|x| x[0] < 1.0), "{line:?}");
    }

    /// The grid extends beyond both ends. For a rule that treats both ends of a chord alike, the
    /// best sequence back is the reverse of the best sequence there.
    #[test]
    fn a_leap_ends_with_a_step_back_too() {
        let energy = valleys(Rule::TRUE_TRAPEZOID);
        let (a, b) = (vector![1.2, 0.0], vector![12.0, 0.0]);
        let there = line_minimum(&energy, &a, &b, 4, 128).expect("finite");
        let mut back = line_minimum(&energy, &b, &a, 4, 128).expect("finite");
        back.reverse();
        for line in [&there, &back] {
            assert!(line.iter().any(|x| x[0] < 1.0), "{line:?}");
        }
        // The grid points of the two sequences differ by rounding.
        let distance = there.iter().zip(&back).map(|(x, y)| (x - y).amax()).fold(0.0, f64::max);
        assert!(distance < 1e-13, "{there:?} {back:?}");
    }

    #[test]
    fn one_chord_joins_the_ends() {
        let (a, b) = (vector![1.2, 0.0], vector![12.0, 0.0]);
        assert_eq!(line_minimum(&valleys(Rule::LEFT_ENDPOINT), &a, &b, 1, 128), Some(vec![a, b]));
    }

    #[test]
    fn no_sequence_leaves_the_domain() {
        let (inside, outside) = (vector![0.9, 0.0], vector![1.5, 0.0]);
        assert_eq!(
            line_minimum(
                &DiscreteEnergy::new(Rule::LEFT_ENDPOINT, &Prepared::<_, 2>::new(Hyperbolic)),
                &outside,
                &inside,
                3,
                64
            ),
            None
        );
    }
}
