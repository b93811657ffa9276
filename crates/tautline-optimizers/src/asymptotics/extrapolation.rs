//! Richardson extrapolation of the discrete energies to `N = ∞`.

use crate::Level;

/// An extrapolated value with an estimate of its error, which is not a bound.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The extrapolated value.
    pub value: f64,
    /// The change that the last order of extrapolation made, or what rounding may make if that is
    /// more.
    pub error: f64,
}

/// The relative error of an extrapolated value by rounding. The absolute values of the weights of
/// Neville's scheme add up to less than `∏ (2ᵏ + 1)/(2ᵏ − 1) < 8.3` for grids that are at least twice
/// as fine as the one before, and an energy, a sum of positive terms, has a few roundings.
const ROUNDING: f64 = 32.0 * f64::EPSILON;

/// Returns an estimate of `d²`, in `m²`, from the minima on several grids; `None` if there are
/// fewer than two grids.
///
/// On smooth data `E_N = d² + c₁ N⁻ᑫ + c₂ N⁻²ᑫ + …` (see
/// [`Rule::ERROR_EXPONENT`](tautline_discretizations::Rule::ERROR_EXPONENT)), which is a polynomial
/// in `N⁻ᑫ`. Neville's scheme evaluates it at 0. All grids must follow the same minimiser.
///
/// The result is the entry of the scheme that changed least, since the coarsest grids may lie
/// outside the asymptotic range and the finest carry rounding.
#[must_use]
pub fn extrapolate(levels: &[Level], exponent: i32) -> Option<Estimate> {
    let variable: Vec<f64> = levels.iter().map(|level| (level.n as f64).powi(-exponent)).collect();
    let mut column: Vec<f64> = levels.iter().map(|level| level.energy).collect();
    let mut best: Option<Estimate> = None;
    for order in 1..levels.len() {
        let next: Vec<f64> = (order..levels.len())
            .map(|k| {
                let (fine, coarse) = (column[k - order + 1], column[k - order]);
                let (x, y) = (variable[k], variable[k - order]);
                fine + (fine - coarse) * x / (y - x)
            })
            .collect();
        let (value, before) = (*next.last()?, *column.last()?);
        let change = (value - before).abs();
        if best.is_none_or(|best| change <= best.error) {
            best = Some(Estimate { value, error: change });
        }
        column = next;
    }
    best.map(|Estimate { value, error }| {
        let rounding = ROUNDING * value.abs();
        Estimate { value, error: error.max(rounding) }
    })
}

#[cfg(test)]
mod tests {
    use super::extrapolate;
    use crate::Level;

    fn levels(energy: impl Fn(f64) -> f64) -> Vec<Level> {
        [10, 20, 50, 100].map(|n| Level { n, energy: energy(n as f64) }).to_vec()
    }

    #[test]
    fn polynomials_in_the_step_are_extrapolated_exactly() {
        let even = levels(|n| 7.0 - 3.0 * n.powi(-2) + 5.0 * n.powi(-4));
        let all = levels(|n| 7.0 - 3.0 / n + 5.0 * n.powi(-2) - 2.0 * n.powi(-3));
        for (levels, exponent) in [(even, 2), (all, 1)] {
            let estimate = extrapolate(&levels, exponent).expect("four grids");
            // The weights are about 10 and the numbers are of size 7.
            assert!((estimate.value - 7.0).abs() < 1e-13, "{}", estimate.value);
        }
    }

    /// A coarse grid outside the asymptotic range does not spoil the others.
    #[test]
    fn a_bad_coarse_grid_is_ignored() {
        let mut levels = levels(|n| 7.0 - 3.0 * n.powi(-2));
        levels[0].energy = 1.0;
        let estimate = extrapolate(&levels, 2).expect("four grids");
        assert!((estimate.value - 7.0).abs() < 1e-12, "{}", estimate.value);
        assert!(estimate.error >= (estimate.value - 7.0).abs());
    }

    /// With `y = N⁻²`, the error is the change at `y = 0`: by the first difference for two grids,
    /// and by the second difference for three.
    #[test]
    fn the_error_is_the_change_by_the_last_order() {
        let energy = |n: f64| 7.0 - 3.0 * n.powi(-2) + 5.0 * n.powi(-4);
        let levels = [1, 2, 4].map(|n| Level { n, energy: energy(n as f64) });
        let two = extrapolate(&levels[..2], 2).expect("two grids");
        approx::assert_relative_eq!(two.error, (energy(2.0) - energy(1.0)).abs() / 3.0);
        let three = extrapolate(&levels, 2).expect("three grids");
        // The quadratic term at 0 that a straight line through 1/4 and 1/16 misses.
        approx::assert_relative_eq!(three.error, 5.0 / 64.0, max_relative = 1e-13);
    }

    /// Equal energies agree to their roundings, and no better.
    #[test]
    fn the_error_is_at_least_that_of_rounding() {
        let estimate = extrapolate(&levels(|_| 7.0), 2).expect("four grids");
        assert_eq!((estimate.value, estimate.error), (7.0, 224.0 * f64::EPSILON));
    }

    #[test]
    fn one_grid_is_not_enough() {
        assert_eq!(extrapolate(&[Level { n: 4, energy: 1.0 }], 2), None);
    }
}
