//! The difference test compares a claimed derivative with central differences of decreasing step.

use super::Fault;

/// The steps are `4⁻ʲ` times a length, for `j` in this range.
const QUARTERINGS: std::ops::RangeInclusive<i32> = 2..=8;

/// The error of a central difference falls by a factor of 16 from one step to the next. Where the
/// derivative after the next one jumps, as that of a cubic spline does from cell to cell, it falls by
/// a factor of 4 or more: at a distance `a ≤ h` from a jump `J` it is `J (h − a)²/(4h)`, and
/// `(4h − a)²/(4 (h − a)²) ≥ 4`. At the last steps, where the next term of the expansion is small, it
/// must fall at least by this factor.
const FALL: f64 = 3.0;

/// The result of a failed difference test at the smallest step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Disagreement {
    /// The difference between the claimed derivative and the central difference.
    pub(crate) error: f64,
    /// The rounding error of a central difference at this step.
    pub(crate) granted: f64,
}

impl Disagreement {
    /// Returns the fault that a wrong derivative violates `law` at `point`.
    pub(crate) fn of(self, law: &'static str, point: &[f64]) -> Fault {
        let Self { error, granted } = self;
        Fault::Broken { law, left: error, right: 0.0, granted, point: point.to_vec(), other: None }
    }
}

/// Compares a claimed derivative with central differences of `f`, at the steps `4⁻² … 4⁻⁸` times
/// `length`.
///
/// They agree if the error falls like the step or faster until it reaches rounding. For a
/// derivative that is off by `δ` the error stays at `δ`. `size` is the size of the terms of `f`,
/// which are rounded. A NaN counts as a disagreement.
pub(crate) fn difference_test(
    claimed: f64,
    f: impl Fn(f64) -> f64,
    length: f64,
    size: f64,
) -> Result<(), Disagreement> {
    let mut before = f64::INFINITY;
    let mut last = Disagreement { error: f64::NAN, granted: 0.0 };
    let mut falls = false;
    for j in QUARTERINGS {
        let step = length * 0.25_f64.powi(j);
        let error = ((f(step) - f(-step)) / (2.0 * step) - claimed).abs();
        // Each of the two values has about thirty roundings of terms of this size.
        let granted = 64.0 * f64::EPSILON * size / step;
        if error <= granted {
            return Ok(());
        }
        falls = error <= before / FALL;
        (before, last) = (error, Disagreement { error, granted });
    }
    if falls { Ok(()) } else { Err(last) }
}

#[cfg(test)]
mod tests {
    use super::difference_test;

    #[test]
    fn a_derivative_agrees_and_a_wrong_one_does_not() {
        let sine = |t: f64| (3.0 * t + 1.0).sin();
        let right = 3.0 * 1_f64.cos();
        assert_eq!(difference_test(right, sine, 1.0, 1.0), Ok(()));
        assert_eq!(difference_test(0.0, |t| t * t, 1.0, 1.0), Ok(()));
        for off in [1e-6, -1e-3, 1.0, f64::NAN] {
            let found = difference_test(right + off, sine, 1.0, 1.0).expect_err("off");
            assert!(off.is_nan() || (found.error - off.abs()).abs() <= 1e-7, "{found:?}");
        }
    }

    /// `t|t|` has the derivative `2|t|`, and so has `(t − a)|t − a|` in `t − a`.
    #[test]
    fn a_derivative_may_have_a_kink() {
        for a in [0.0, 1e-5, 1e-4, 1e-3] {
            let square = |t: f64| (t - a) * (t - a).abs();
            assert_eq!(difference_test(2.0 * a, square, 1.0, 1.0), Ok(()), "{a}");
            assert!(difference_test(2.0 * a + 1e-4, square, 1.0, 1.0).is_err(), "{a}");
        }
    }

    #[test]
    fn a_kink_has_no_derivative() {
        assert!(difference_test(1.0, |t: f64| (t + 1e-9).abs(), 1.0, 1.0).is_err());
        assert!(difference_test(f64::NAN, |_| f64::NAN, 1.0, 1.0).is_err());
    }
}
