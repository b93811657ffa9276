//! Lemma S.3: bounds on the speeds of a sequence that is stationary with respect to its inner
//! points.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::{number::Number, product::product};

/// Bounds the greatest speed `max qₙ` of a sequence, in `m`, where `qₙ² = βₙᵀ H βₙ` with `H`
/// evaluated at the node of the rule (Lemma S.3).
///
/// ```text
/// max qₙ  ≤  min( √(N E_N),  √E_N + (L_H/c₁^{3/2}) E_N + mean|ρ|/√c₁ ),      ∂E_N/∂xₙ = −2hρₙ
/// ```
///
/// If the sequence is stationary, the speed changes by at most `h (L_H/c₁^{3/2}) q²` from one chord
/// to the next, and some chord is no faster than the mean. Divided by `√c₁`, the bound becomes a
/// bound on `max |βₙ|`.
///
/// - `discrete_energy`: `E_N`, in `m²`.
/// - `mean_residual`: `(1/N) Σ |ρₙ|` over the inner points, in `m²/ℓ`.
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and either rule of the paper. The sequence need not
/// be a minimiser: local minima and saddles are included, and the ends may be anywhere.
///
/// Overestimation: the smallest overestimation known for the second term is 2.
///
/// # Panics
///
/// If `discrete_energy` or `mean_residual` is negative or NaN.
#[must_use]
pub fn greatest_speed(
    constants: Constants,
    discrete_energy: f64,
    mean_residual: f64,
    n: NonZeroUsize,
) -> f64 {
    assert!(discrete_energy >= 0.0, "an energy must be nonnegative, got {discrete_energy}");
    assert!(mean_residual >= 0.0, "the mean residual must be nonnegative, got {mean_residual}");
    greatest_speed_in(constants, discrete_energy, mean_residual, n)
}

/// Returns what [`greatest_speed`] documents, in doubles or in intervals.
pub(super) fn greatest_speed_in<T: Number>(
    constants: Constants,
    discrete_energy: T,
    mean_residual: T,
    n: NonZeroUsize,
) -> T {
    let root = T::constant(constants.c1()).sqrt().recip();
    let steps = T::product([T::constant(constants.l_h()), discrete_energy, root, root, root]);
    let stationary = discrete_energy.sqrt() + steps + mean_residual * root;
    stationary.least((discrete_energy * n.get() as f64).sqrt())
}

/// Bounds the greatest difference `max |βₙ|` of a sequence, in `ℓ`, by means of its momentum (Lemma
/// S.3).
///
/// ```text
/// max |βₙ|  ≤  (c₂ K₃ + ½ L_H K₃² + mean|ρ|)/c₁
/// ```
///
/// If the sequence is stationary, the momentum `H βₙ` changes by at most `½ L_H K₃²` in total.
///
/// - `k3`: the root mean square `K₃` of the differences, in `ℓ`.
/// - `mean_residual`: as for [`greatest_speed`].
///
/// Needs: as for [`greatest_speed`], and `H ≤ c₂`. Overestimation: the bound is attained by a
/// constant metric with `c₁ = c₂`.
///
/// # Panics
///
/// If `k3` or `mean_residual` is negative or NaN.
#[must_use]
pub fn greatest_difference(constants: Constants, k3: f64, mean_residual: f64) -> f64 {
    assert!(k3 >= 0.0, "K3 must be nonnegative, got {k3}");
    assert!(mean_residual >= 0.0, "the mean residual must be nonnegative, got {mean_residual}");
    let momentum = constants.c2() * k3 + product([0.5, constants.l_h(), k3, k3]) + mean_residual;
    momentum / constants.c1()
}

/// Bounds `|βₙ − βₙ₋₁|`, in `ℓ`, for a sequence that is stationary with respect to its inner points
/// (Lemma S.3). This is the analogue of Lemma S.1 for sequences.
///
/// ```text
/// |βₙ − βₙ₋₁|  ≤  (3/2) (L_H/N c₁) max |β|²
/// ```
///
/// - `greatest`: `max |βₙ|`, in `ℓ`, or an upper bound on it.
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and either rule of the paper.
///
/// # Panics
///
/// If `greatest` is negative or NaN.
#[must_use]
pub fn difference_step(constants: Constants, greatest: f64, n: NonZeroUsize) -> f64 {
    assert!(greatest >= 0.0, "the greatest difference must be nonnegative, got {greatest}");
    product([1.5, constants.l_h() / constants.c1(), greatest, greatest]) / n.get() as f64
}

#[cfg(test)]
mod tests {
    use super::{difference_step, greatest_difference, greatest_speed};
    use crate::by_hand::{constants, n};

    #[test]
    fn by_hand() {
        let constants = constants(4.0, 10.0, 8.0);
        // √9 + (8/8)·9 + 6/2, unless √(N·9) is less.
        assert_eq!(greatest_speed(constants, 9.0, 6.0, n(100)), 15.0);
        assert_eq!(greatest_speed(constants, 9.0, 6.0, n(4)), 6.0);
        assert_eq!(greatest_speed(constants, 0.0, 0.0, n(4)), 0.0);
        // (10·2 + 4·4 + 4)/4.
        assert_eq!(greatest_difference(constants, 2.0, 4.0), 10.0);
        // (3/2)(8/4)·9/6.
        assert_eq!(difference_step(constants, 3.0, n(6)), 4.5);
    }
}
