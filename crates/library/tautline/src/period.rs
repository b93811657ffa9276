//! Metrics with a period along some coordinates, such as angles.

use tautline_formula::{AnyBatches, Known};

/// The largest difference of an entry at a point and a period beyond it, relative to the largest entry. A
/// period such as `2π` is rounded, and so are large arguments of waves.
const ROUNDING: f64 = 1e-6;

/// Places along the segment between two points, and fractions of the periods beside it.
const SAMPLES: [(f64, f64); 5] = [(0.0, 0.0), (0.31, 0.27), (0.57, 0.61), (0.83, 0.43), (1.0, 0.0)];

/// A point at which a metric does not have the period that was given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the metric does not have the period {period} in x{}: at {x:?} an entry is {here}, and with x{} larger by \
     the period it is {there}",
    index + 1,
    index + 1
)]
pub struct NotPeriodic {
    /// The index of the coordinate, counted from 0.
    pub index: usize,
    /// The period that was given, in `ℓ`.
    pub period: f64,
    /// The point.
    pub x: Vec<f64>,
    /// An entry of `H` there.
    pub here: f64,
    /// The same entry a period beyond.
    pub there: f64,
}

/// Checks at a few points around the segment from `a` to `b` that `H(x + p eᵢ) = H(x)` for each period
/// `p > 0`, up to `10⁻⁶` of the largest entry. Points where `H` is undefined are passed over.
///
/// # Errors
///
/// [`NotPeriodic`] with the first point that refutes a period.
///
/// # Panics
///
/// If there are not as many periods and coordinates as dimensions.
pub fn check_periods(
    metric: &Known,
    periods: &[f64],
    [a, b]: [&[f64]; 2],
) -> Result<(), NotPeriodic> {
    assert!([a.len(), b.len(), metric.dimension()].iter().all(|&d| d == periods.len()));
    for (along, beside) in SAMPLES {
        let sides = a.iter().zip(b).zip(periods);
        let x: Vec<f64> = sides.map(|((a, b), p)| a + along * (b - a) + beside * p).collect();
        let here = metric.gram(&x);
        let largest = here.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for (index, &period) in periods.iter().enumerate().filter(|(_, period)| **period > 0.0) {
            let mut beyond = x.clone();
            beyond[index] += period;
            let there = metric.gram(&beyond);
            let differs =
                |(here, there): &(&f64, &f64)| (*here - *there).abs() > ROUNDING * largest;
            if let Some((&here, &there)) = here.iter().zip(&there).find(differs) {
                return Err(NotPeriodic { index, period, x, here, there });
            }
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use tautline_formula::{Formula, Known};
    use tautline_scalar::ANY;

    use super::check_periods;

    #[test]
    fn a_period_is_refuted_by_a_point() {
        let known =
            |text: &str| Known::from(Formula::<ANY>::parse_in(2, text, &[], &[]).expect(text));
        let torus = known("diag(4, (3 + 2*cos(x1))^2)");
        let ends = [&[3.0, -3.0][..], &[1.0, 3.0]];
        assert_eq!(check_periods(&torus, &[TAU, TAU], ends), Ok(()));
        assert_eq!(check_periods(&torus, &[0.0, 1.0], ends), Ok(()));
        let error = check_periods(&torus, &[6.25, 0.0], ends).expect_err("refuted");
        assert_eq!((error.index, error.x.as_slice()), (0, ends[0]));
        let message = error.to_string();
        assert!(message.contains("the period 6.25 in x1: at [3.0, -3.0] an entry is"), "{message}");
        // A wave in one coordinate only shows in it, and only away from the ends.
        let bump = known("cost(1 + exp(-(x2 - 1)^2))");
        let error =
            check_periods(&bump, &[0.0, 2.0], [&[0.0, 0.0], &[0.0, 0.0]]).expect_err("refuted");
        assert_eq!((error.index, error.period), (1, 2.0));
        // The logarithm is undefined at the start.
        let half = known("cost(ln(x1))");
        assert!(check_periods(&half, &[5.0, 0.0], [&[-1.0, 0.0], &[3.0, 0.0]]).is_err());
    }
}
