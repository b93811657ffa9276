//! Lemma S.5: bounds on the length of a reconstruction in terms of its discrete energy alone.

use std::num::NonZeroUsize;

use tautline_metrics::Constants;

use crate::{PaperRule, product::product};

/// Bounds `L(γᵖˡ)²` of any point sequence in terms of its discrete energy, in `m²` (Lemma S.5).
///
/// ```text
/// L(γᵖˡ)²  ≤  E_N + (k L_H/N c₁^{3/2}) E_N^{3/2},      k = ¼ (trapezoidal), ½ (left endpoint)
/// L(γᵖˡ)²  ≤  E_tra,N + (M_H/24c₁²N²) E_tra,N²
/// ```
///
/// For the trapezoidal rule it is the smaller of the two if `M_H` is known. On a chord the mean of
/// `βᵀHβ` is at most `s + c s^{3/2}`, or `s + c s²`, with `s = q²`; the square roots of both are
/// concave in `s`.
///
/// - `discrete_energy`: `E_N`, in `m²`, or an upper bound on it.
///
/// Needs: `H ≥ c₁`, `H` Lipschitz with `L_H`, and for the second bound `DH` Lipschitz with `M_H`.
/// The sequence need not be a minimiser, so any `E_N` gives an upper bound on `d²`.
///
/// Overestimation: the bounds are attained in the limit `L_H → 0` for equal chords over valleys or
/// up an incline, and in the limit `M_H → 0` along a parabola.
///
/// # Panics
///
/// If `discrete_energy` is negative or NaN.
#[must_use]
pub fn squared_length(
    constants: Constants,
    rule: PaperRule,
    discrete_energy: f64,
    n: NonZeroUsize,
) -> f64 {
    assert!(discrete_energy >= 0.0, "an energy must be nonnegative, got {discrete_energy}");
    let (e, count) = (discrete_energy, n.get() as f64);
    let root = 1.0 / constants.c1().sqrt();
    let speed = e.sqrt();
    let k = rule.mean_distance();
    let first = product([k, constants.l_h(), root, root, root, e, speed]) / count;
    let second = match (rule, constants.m_h()) {
        (PaperRule::Trapezoidal, Some(m_h)) => {
            product([m_h / 24.0, root, root, root, root, e, e]) / (count * count)
        }
        _ => f64::INFINITY,
    };
    e + first.min(second)
}

#[cfg(test)]
mod tests {
    use super::squared_length;
    use crate::{
        PaperRule,
        by_hand::{constants, n},
    };

    #[test]
    fn by_hand() {
        let constants = constants(4.0, 10.0, 8.0);
        // The bounds are 9 + (27/4)/N and 9 + (27/2)/N; with M_H = 96, 9 + (96/384)·81/N².
        assert_eq!(squared_length(constants, PaperRule::Trapezoidal, 9.0, n(3)), 11.25);
        assert_eq!(squared_length(constants, PaperRule::LeftEndpoint, 9.0, n(3)), 13.5);
        let smooth = constants.with_m_h(96.0).expect("nonnegative");
        assert_eq!(squared_length(smooth, PaperRule::Trapezoidal, 9.0, n(9)), 9.25);
        assert_eq!(squared_length(smooth, PaperRule::LeftEndpoint, 9.0, n(3)), 13.5);
        assert_eq!(squared_length(smooth, PaperRule::Trapezoidal, 9.0, n(1)), 15.75);
        assert_eq!(squared_length(smooth, PaperRule::Trapezoidal, 0.0, n(9)), 0.0);
    }
}
