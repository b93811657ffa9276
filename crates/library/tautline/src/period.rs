//! Metrics with a period along some coordinates, such as angles.

use tautline_formula::{AnyBatches, Known};

/// The largest difference of an entry at a point and a period beyond it, relative to the largest entry. A
/// period such as `2π` is rounded, and so are large arguments of waves.
const ROUNDING: f64 = 1e-6;

/// The number of points at which the metric is compared with itself.
const SAMPLES: usize = 64;

/// A point at which a metric does not have the period that was given.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error(
    "the metric does not have the period {period} in x{}: at {x:?} an entry is {here}, and with x{} larger by \
     periods it is {there}",
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
    /// The same entry one or more periods beyond.
    pub there: f64,
}

/// Checks that `H(x + kp eᵢ) = H(x)` for each period `p > 0`, up to `10⁻⁶` of the largest entry, at 64 points
/// around the segment from `a` to `b` that fill the periods, for `k = 1` and for so many periods that the
/// point lies beyond the other end. This may refute a period, and proves none. Points where `H` is undefined
/// on both sides are passed over.
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
    for k in 0..SAMPLES {
        // The fractions of multiples of irrational numbers fill the interval evenly.
        let fraction = |i: usize| (k as f64 * (i as f64 + 2.0).sqrt().recip()).fract();
        let sides = a.iter().zip(b).zip(periods).enumerate();
        let along = |(i, ((a, b), p))| a + fraction(0) * (b - a) + fraction(i + 1) * p;
        let x: Vec<f64> = sides.map(along).collect();
        let here = metric.gram(&x);
        let largest = here.iter().fold(0.0_f64, |most, entry| most.max(entry.abs()));
        for (index, &period) in periods.iter().enumerate().filter(|(_, period)| **period > 0.0) {
            let many = ((b[index] - a[index]).abs() / period).ceil() + 1.0;
            for times in [1.0, many] {
                let mut beyond = x.clone();
                beyond[index] += times * period;
                let there = metric.gram(&beyond);
                let differs = |(here, there): &(&f64, &f64)| {
                    let both_undefined = here.is_nan() && there.is_nan();
                    !both_undefined && !((*here - *there).abs() <= ROUNDING * largest)
                };
                if let Some((&here, &there)) = here.iter().zip(&there).find(differs) {
                    return Err(NotPeriodic { index, period, x, here, there });
                }
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
        // A bump that is narrow beside the period, a period that is short beside the metric, and one that is
        // a little wrong.
        let narrow = known("cost(1 + 5*exp(-100*(x1 - 1)^2))");
        assert!(check_periods(&narrow, &[2.0, 0.0], [&[0.0, 0.0], &[0.4, 0.0]]).is_err());
        let slow = known("cost(1 + x1^2)");
        assert!(check_periods(&slow, &[1e-9, 0.0], [&[0.0, 0.0], &[3.0, 0.0]]).is_err());
        assert!(check_periods(&torus, &[TAU + 1e-5, 0.0], ends).is_err());
    }
}
