//! Lemma S.3: how fast a sequence that is stationary in its inner points can go.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::product::product;

/// Bounds the greatest speed `max qₙ` of a sequence, `qₙ² = βₙᵀ H βₙ` with the `H` that the rule
/// reads, in `m` (Lemma S.3).
///
/// ```text
/// max qₙ  ≤  min( √(N E_N),  √E_N + (L_H/c₁^{3/2}) E_N + mean|ρ|/√c₁ ),      ∂E_N/∂xₙ = −2hρₙ
/// ```
///
/// From one chord to the next the speed changes by `h (L_H/c₁^{3/2}) q²` at most, where the inner
/// points are stationary; and some chord is no faster than the mean. `max |βₙ|` is at most that
/// over `√c₁`.
///
/// - `discrete_energy`: `E_N`, in `m²`; `mean_residual`: `(1/N) Σ |ρₙ|` over the inner points, in
///   `m²/ℓ`, which floating point leaves.
///
/// Needs: `H ≥ c₁`, Lipschitz with `L_H`; either rule of the paper. No minimiser: local minima and
/// saddles are included, and the ends may be anywhere.
///
/// Overestimation: 2 at best as far as is known, in the second term.
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
    assert!(discrete_energy >= 0.0, "an energy, got {discrete_energy}");
    assert!(mean_residual >= 0.0, "a mean of norms, got {mean_residual}");
    let root = 1.0 / constants.c1().sqrt();
    let steps = product([constants.l_h(), discrete_energy, root, root, root]);
    let stationary = discrete_energy.sqrt() + steps + mean_residual * root;
    stationary.min((n.get() as f64 * discrete_energy).sqrt())
}

/// Bounds the greatest difference `max |βₙ|` of a sequence by its momentum, in `ℓ` (Lemma S.3).
///
/// ```text
/// max |βₙ|  ≤  (c₂ K₃ + ½ L_H K₃² + mean|ρ|)/c₁
/// ```
///
/// The momentum `H βₙ` changes by `½ L_H K₃²` in all, where the inner points are stationary.
///
/// - `k3`: root mean square `K₃` of the differences, in `ℓ`; `mean_residual` as in
///   [`greatest_speed`].
///
/// Needs: as there, and `H ≤ c₂`. Overestimation: none for a constant metric with `c₁ = c₂`.
///
/// # Panics
///
/// If `k3` or `mean_residual` is negative or NaN.
#[must_use]
pub fn greatest_difference(constants: Constants, k3: f64, mean_residual: f64) -> f64 {
    assert!(k3 >= 0.0, "K3 is a norm, got {k3}");
    assert!(mean_residual >= 0.0, "a mean of norms, got {mean_residual}");
    let momentum = constants.c2() * k3 + product([0.5, constants.l_h(), k3, k3]) + mean_residual;
    momentum / constants.c1()
}

/// Bounds `|βₙ − βₙ₋₁|`, in `ℓ`, for a sequence that is stationary in its inner points (Lemma S.3):
/// Lemma S.1 for sequences.
///
/// ```text
/// |βₙ − βₙ₋₁|  ≤  (3/2) (L_H/N c₁) max |β|²
/// ```
///
/// - `greatest`: `max |βₙ|`, in `ℓ`, or an upper bound of it.
///
/// Needs: `H ≥ c₁`, Lipschitz with `L_H`; either rule of the paper.
///
/// # Panics
///
/// If `greatest` is negative or NaN.
#[must_use]
pub fn difference_step(constants: Constants, greatest: f64, n: NonZeroUsize) -> f64 {
    assert!(greatest >= 0.0, "a greatest norm, got {greatest}");
    product([1.5, constants.l_h() / constants.c1(), greatest, greatest]) / n.get() as f64
}

#[cfg(test)]
mod tests {
    use super::{difference_step, greatest_difference, greatest_speed};
    use crate::Constants;
    use std::num::NonZeroUsize;

    fn constants() -> Constants {
        Constants::new(4.0, 10.0, 8.0).expect("in order")
    }

    #[test]
    fn by_hand() {
        let n = |n| NonZeroUsize::new(n).expect("positive");
        // √9 + (8/8)·9 + 6/2, unless N·9 is less.
        assert_eq!(greatest_speed(constants(), 9.0, 6.0, n(100)), 15.0);
        assert_eq!(greatest_speed(constants(), 9.0, 6.0, n(4)), 6.0);
        assert_eq!(greatest_speed(constants(), 0.0, 0.0, n(4)), 0.0);
        // (10·2 + 4·4 + 4)/4.
        assert_eq!(greatest_difference(constants(), 2.0, 4.0), 10.0);
        // (3/2)(8/4)·9/6.
        assert_eq!(difference_step(constants(), 3.0, n(6)), 4.5);
    }

    #[test]
    fn what_is_no_norm_is_a_mistake() {
        let one = NonZeroUsize::MIN;
        for bad in [-1.0, f64::NAN] {
            let panics = |f: &dyn Fn() -> f64| {
                std::panic::catch_unwind(std::panic::AssertUnwindSafe(f)).is_err()
            };
            assert!(panics(&|| greatest_speed(constants(), bad, 0.0, one)));
            assert!(panics(&|| greatest_speed(constants(), 1.0, bad, one)));
            assert!(panics(&|| greatest_difference(constants(), bad, 0.0)));
            assert!(panics(&|| greatest_difference(constants(), 1.0, bad)));
            assert!(panics(&|| difference_step(constants(), bad, one)));
        }
    }
}
