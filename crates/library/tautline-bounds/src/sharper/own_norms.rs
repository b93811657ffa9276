//! S.11: Theorems C and D with constants in the metric's own norms.

use std::num::NonZeroUsize;

use crate::{BoundError, PaperRule, product::product};

/// Bounds on the derivatives of a metric in its own norms `|u|² = uᵀ H(x) u`, with the distance
/// between the ends.
///
/// ```text
/// |uᵀ DH(x)[w] u|  ≤  λ |u|² |w|,        |uᵀ D²H(x)[w, w] u|  ≤  ν |u|² |w|²        for all x, u, w
/// ```
///
/// `λ ≤ L_H/c₁^{3/2}` and `ν ≤ M_H/c₁²` always hold. They are far smaller where `c₁`, `L_H` and
/// `M_H` are attained at different places, and they do not depend on the coordinates: an affine
/// map changes none of them.
///
/// Invariant: `λ`, `ν` and `d` are nonnegative and finite, and the dimension is positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OwnNorms {
    lambda: f64,
    nu: Option<f64>,
    distance: f64,
    omega: f64,
}

impl OwnNorms {
    /// Checks `λ`, in `1/m`, `ν`, in `1/m²`, if it is known, the distance `d` or an upper bound on
    /// it, in `m`, and the dimension.
    ///
    /// # Errors
    ///
    /// [`BoundError::NotABound`] if `λ` or `ν` is negative, infinite or NaN;
    /// [`BoundError::NotADistance`] if `distance` is; [`BoundError::NoDimension`] if `dimension` is
    /// 0.
    pub fn new(
        lambda: f64,
        nu: Option<f64>,
        distance: f64,
        dimension: usize,
    ) -> Result<Self, BoundError> {
        for (name, value) in [("λ", lambda), ("ν", nu.unwrap_or(0.0))] {
            if !(value >= 0.0 && value.is_finite()) {
                return Err(BoundError::NotABound { name, value });
            }
        }
        if !(distance >= 0.0 && distance.is_finite()) {
            return Err(BoundError::NotADistance { distance });
        }
        if dimension == 0 {
            return Err(BoundError::NoDimension);
        }
        let omega = if dimension == 1 { 0.5 } else { 1.5 };
        Ok(Self { lambda, nu, distance, omega })
    }

    /// Returns the numbers of a metric that is a multiple of the identity everywhere.
    #[must_use]
    pub fn isotropic(self) -> Self {
        Self { omega: 0.5, ..self }
    }

    /// Returns `δ = λ d`, a pure number.
    #[must_use]
    pub fn delta(&self) -> f64 {
        product([self.lambda, self.distance])
    }

    /// Returns `μ = ν d²`, a pure number, or `None` if `ν` is unknown.
    #[must_use]
    pub fn mu(&self) -> Option<f64> {
        self.nu.map(|nu| product([nu, self.distance, self.distance]))
    }

    /// Returns `ζ = (ωδ²/16N²) e^{δ/2N}`. On a subinterval of a minimal geodesic, half of `λ` times
    /// the distance from the geodesic to its chord is at most `ζ`.
    fn sag(&self, n: f64) -> f64 {
        let step = self.delta() / n;
        product([self.omega / 16.0, step, step, (0.5 * step).exp()])
    }

    /// Returns `e − 1`: for either rule the sampled geodesic has `E_N ≤ d² e`, which is `1 + kδ/N`
    /// up to terms in `1/N²`; `∞` if `ζ ≥ 1`.
    fn first_order(&self, rule: PaperRule, n: f64) -> f64 {
        let (step, sag) = (self.delta() / n, self.sag(n));
        match rule {
            PaperRule::LeftEndpoint => 0.5 * step * step.exp(),
            PaperRule::Trapezoidal if sag < 1.0 => {
                let along = 0.25 * step * (0.5 * step).exp();
                let across = sag * (2.0 - sag) / (1.0 - sag).powi(2);
                along + across + product([along, across])
            }
            PaperRule::Trapezoidal => f64::INFINITY,
        }
    }

    /// Returns `ê − 1` for the trapezoidal rule; `∞` if `ζ ≥ 1`, and `None` if `ν` is unknown.
    fn second_order(&self, n: f64) -> Option<f64> {
        let (mu, sag, step) = (self.mu()?, self.sag(n), self.delta() / n);
        if !(sag < 1.0) {
            return Some(f64::INFINITY);
        }
        let theta = (0.5 * step).exp() / (1.0 - sag).powi(2);
        let bend = product([self.omega, self.delta()]);
        let bent = [
            product([theta, theta, 1.0 / 12.0]),
            product([theta, theta, theta, step / 360_f64.sqrt()]),
            product([theta, theta, theta, theta, mu / (240.0 * n * n)]),
        ];
        let bent = product([bend, bend, bent.iter().sum()]);
        Some((bent + product([theta, theta, theta, theta, mu / 24.0])) / n / n)
    }

    /// Bounds `L(γᵖˡ)² − d²`, in `m²`, for every admissible sequence with `E_N ≤ d² e`, by the lesser
    /// of the forms of Theorems C and D (S.11). It is `∞` if `N` is too small.
    ///
    /// ```text
    /// L(γᵖˡ)² − d²  ≤  d² [e − 1 + (k/N) δ/(1 − t) e^{3/2}],        t = kδ√(e/N)
    /// L(γᵖˡ)² − d²  ≤  d² [ê − 1 + (1/24N²) μ/(1 − t)⁴ ê²]          (trapezoidal),   t = ¼δ√(ê/N)
    /// ```
    ///
    /// Needs: the setting of Theorem 1.1, except that its constants do not enter; `H` of class `C²`;
    /// a *global* minimiser.
    ///
    /// Overestimation: as for [`theorem_c_length_excess`](crate::theorem_c_length_excess) and
    /// [`theorem_d_length_excess`](crate::theorem_d_length_excess) with the `δ` and `μ` of own
    /// norms, up to a factor that tends to 1 as `N → ∞`.
    #[must_use]
    pub fn length_excess(&self, rule: PaperRule, n: NonZeroUsize) -> f64 {
        let (count, k, d) = (n.get() as f64, rule.mean_distance(), self.distance);
        if d == 0.0 {
            return 0.0;
        }
        let left = |surplus: f64| 1.0 - k * self.delta() * ((1.0 + surplus) / count).sqrt();
        let by = |surplus: f64, gap: f64| {
            if left(surplus) > 0.0 { product([d, d, surplus + gap]) } else { f64::INFINITY }
        };
        let surplus = self.first_order(rule, count);
        let cube = (1.0 + surplus).powf(1.5);
        let first = by(surplus, product([k / count, self.delta(), cube]) / left(surplus));
        let second = match rule {
            PaperRule::Trapezoidal => self.second_order(count).zip(self.mu()),
            PaperRule::LeftEndpoint => None,
        };
        second.map_or(first, |(surplus, mu)| {
            let (e, fourth) = (1.0 + surplus, left(surplus).powi(4));
            first.min(by(surplus, product([mu, e, e]) / (24.0 * count * count * fourth)))
        })
    }

    /// Bounds `|E(γᵖˡ) − E_N|`, in `m²`, for any sequence with these discrete speeds `qₙ`, in `m`
    /// (S.11).
    ///
    /// ```text
    /// (1/N) Σ (kλ/N) qₙ³/(1 − (kλ/N) qₙ)
    /// ```
    ///
    /// Needs: the first inequality of [`OwnNorms`] on the chords. The distance does not matter.
    ///
    /// Overestimation: the bound is attained for every `λ` up the slope `H = (1 − ½λx)⁻²`, where
    /// `λ` is the same everywhere (left endpoint).
    ///
    /// Returns `∞` if a chord is so long that `kλqₙ ≥ N`, and 0 for no speeds.
    #[must_use]
    pub fn gap(&self, rule: PaperRule, speeds: &[f64]) -> f64 {
        let count = speeds.len() as f64;
        let of_chord = |&q: &f64| {
            let t = product([rule.mean_distance(), self.lambda, q.abs()]) / count;
            if t < 1.0 { product([t, q.abs(), q.abs()]) / (1.0 - t) } else { f64::INFINITY }
        };
        if speeds.is_empty() { 0.0 } else { speeds.iter().map(of_chord).sum::<f64>() / count }
    }
}

#[cfg(test)]
mod tests {
    use super::OwnNorms;
    use crate::{
        BoundError, PaperRule, Setting,
        by_hand::{close, n, with_m_h},
        theorem_c_length_excess, theorem_d_length_excess,
    };

    const TRA: PaperRule = PaperRule::Trapezoidal;
    const LEFT: PaperRule = PaperRule::LeftEndpoint;

    fn norms(lambda: f64, nu: Option<f64>) -> OwnNorms {
        OwnNorms::new(lambda, nu, 3.0, 2).expect("valid")
    }

    /// `λ = ½`, `ν = ⅓`, `d = 3`: `δ = 3/2`, `μ = 3`, `ω = 3/2`.
    #[test]
    fn by_hand() {
        let own = norms(0.5, Some(1.0 / 3.0));
        assert_eq!((own.delta(), own.mu()), (1.5, Some(3.0)));
        let n6 = 6.0_f64;
        let step = 0.25_f64;
        let surplus = 0.125 * step.exp();
        let t = 0.75 * ((1.0 + surplus) / n6).sqrt();
        let gap = 0.125 / (1.0 - t) * (1.0 + surplus).powf(1.5);
        // This allows for about twenty roundings.
        close(own.length_excess(LEFT, n(6)), 9.0 * (surplus + gap), 8e-15);
        let zeta = 1.5 / 16.0 * step * step * (0.5 * step).exp();
        let theta = (0.5 * step).exp() / (1.0 - zeta).powi(2);
        let bent = theta.powi(2) / 12.0
            + theta.powi(3) * step / 360_f64.sqrt()
            + theta.powi(4) * 3.0 / (240.0 * 36.0);
        let surplus = (2.25_f64.powi(2) * bent + theta.powi(4) / 8.0) / 36.0;
        let t = 0.375 * ((1.0 + surplus) / n6).sqrt();
        let gap = 3.0 / (24.0 * 36.0 * (1.0 - t).powi(4)) * (1.0 + surplus).powi(2);
        close(own.length_excess(TRA, n(6)), 9.0 * (surplus + gap), 8e-15);
        // Without ν, the first order: (1 + ¼·¼ e^{1/8})(1 − ζ)⁻² − 1.
        let surplus = (1.0 + 0.0625 * 0.125_f64.exp()) / (1.0 - zeta).powi(2) - 1.0;
        let t = 0.375 * ((1.0 + surplus) / n6).sqrt();
        let gap = 0.0625 / (1.0 - t) * (1.0 + surplus).powf(1.5);
        // The surplus is computed here as a difference from 1.
        close(norms(0.5, None).length_excess(TRA, n(6)), 9.0 * (surplus + gap), 1e-14);
    }

    /// With many chords the bounds are those of Theorems C and D with `δ` and `μ` of own norms: here
    /// `c₁ = 1`, so that `λ = L_H` and `ν = M_H` give the same `δ` and `μ`.
    #[test]
    fn with_many_chords_they_are_the_bounds_of_theorems_c_and_d() {
        let constants = with_m_h(1.0, 1e9, 0.5, 1.0 / 3.0).on_a_region();
        let huge = n(1 << 26);
        for dimension in [1, 2] {
            let setting = Setting::new(constants, 3.0, dimension).expect("valid");
            let own = OwnNorms::new(0.5, Some(1.0 / 3.0), 3.0, dimension).expect("valid");
            let left = theorem_c_length_excess(setting, LEFT, huge);
            let tra = theorem_d_length_excess(setting, huge).expect("M_H");
            // The next terms are of relative order t = O(N^{-1/2}).
            for ratio in [own.length_excess(LEFT, huge) / left, own.length_excess(TRA, huge) / tra]
            {
                assert!((1.0..1.0 + 8.0 / (huge.get() as f64).sqrt()).contains(&ratio), "{ratio}");
            }
        }
        let own = norms(0.5, Some(1.0 / 3.0));
        assert!(own.isotropic().length_excess(TRA, huge) < own.length_excess(TRA, huge));
    }

    /// Up `H = (1 − ½λx)⁻²` the energy of the chord from 0 to 1 is `1/(1 − ½λ)`, and the left rule
    /// sees 1. Without the `1 − t` the bound would be too small. The trapezoidal rule sees
    /// `(1 − ¼λ)⁻²`.
    #[test]
    fn the_gap_is_attained_for_every_lambda() {
        for lambda in [1e-3_f64, 0.5, 1.0, 1.9] {
            let own = norms(lambda, None);
            let energy = 1.0 / (1.0 - 0.5 * lambda);
            // The differences lose up to three digits.
            close(own.gap(LEFT, &[1.0]), energy - 1.0, 1e-12);
            assert!(energy - 1.0 > 1.0002 * 0.5 * lambda);
            let q = 1.0 / (1.0 - 0.25 * lambda);
            assert!((energy - q * q).abs() <= own.gap(TRA, &[q]) * (1.0 + 1e-12));
        }
        // Of two chords of half the length each counts by its own speed: t = ¼ and ½.
        close(norms(1.0, None).gap(LEFT, &[1.0, 2.0]), 0.5 * (1.0 / 3.0 + 4.0), 4e-15);
    }

    /// Where `ζ ≥ 1`, the factor `(1 − ζ)⁻²` is finite again and means nothing. With one chord,
    /// `ν = 0` and `δ` between 3.2 and 3.8, all other terms of the second order are finite.
    #[test]
    fn a_geodesic_that_may_be_too_far_from_its_chord_gives_no_bound() {
        for dimension in [1, 2] {
            let omega = if dimension == 1 { 0.5 } else { 1.5 };
            let mut finite = 0;
            for delta in (1..=80).map(|k| 0.05 * f64::from(k)) {
                let own = OwnNorms::new(delta, Some(0.0), 1.0, dimension).expect("valid");
                let zeta = omega / 16.0 * delta * delta * (0.5 * delta).exp();
                let bound = own.length_excess(TRA, n(1));
                assert!(zeta < 1.0 || bound == f64::INFINITY, "δ = {delta}: {bound}");
                finite += usize::from(bound.is_finite());
            }
            assert!(finite > 10, "{finite}");
        }
    }

    /// The `t` of both forms is at least `kδ/√N`. From `t = 1` on there is no bound, though the power
    /// `(1 − t)⁴` is positive again, and the other terms are finite: `ζ < 1` for `δ/N = 1` and 1/2.
    #[test]
    fn where_t_is_not_below_one_there_is_no_bound() {
        for (chords, step) in [(16_u32, 1.0), (64, 1.0), (64, 0.5), (1000, 1.0), (1 << 20, 0.25)] {
            let delta = step * f64::from(chords);
            let count = n(chords as usize);
            for (rule, k) in [(TRA, 0.25), (LEFT, 0.5)] {
                assert!(k * delta / f64::from(chords).sqrt() >= 1.0);
                for nu in [None, Some(0.0), Some(1e-9)] {
                    let own = OwnNorms::new(delta, nu, 1.0, 2).expect("valid");
                    for own in [own, own.isotropic()] {
                        let bound = own.length_excess(rule, count);
                        assert_eq!(bound, f64::INFINITY, "N = {chords}, δ = {delta}, {nu:?}");
                    }
                }
            }
        }
        // With t below 1 both forms are finite, and the second one is smaller.
        let [first, second] = [None, Some(1e-9)]
            .map(|nu| OwnNorms::new(4.0, nu, 1.0, 2).expect("valid").length_excess(TRA, n(16)));
        assert!(second < first && first.is_finite(), "{second} {first}");
    }

    #[test]
    fn too_few_chords_give_no_bound_and_touching_ends_no_excess() {
        let far = OwnNorms::new(2.0, Some(1.0), 100.0, 2).expect("valid");
        assert_eq!(far.length_excess(TRA, n(1)), f64::INFINITY);
        assert_eq!(far.length_excess(LEFT, n(100)), f64::INFINITY);
        assert!(far.length_excess(TRA, n(100_000)).is_finite());
        assert_eq!(far.gap(LEFT, &[1.0]), f64::INFINITY);
        assert_eq!(far.gap(LEFT, &[]), 0.0);
        let touching = OwnNorms::new(1e300, Some(1e300), 0.0, 2).expect("valid");
        assert_eq!(touching.length_excess(TRA, n(1)), 0.0);
        let flat = norms(0.0, Some(0.0));
        assert_eq!((flat.length_excess(TRA, n(1)), flat.length_excess(LEFT, n(1))), (0.0, 0.0));
    }

    #[test]
    fn invalid_numbers_are_errors() {
        for bad in [-1.0, f64::NAN, f64::INFINITY] {
            let error = OwnNorms::new(bad, None, 1.0, 2).expect_err("λ");
            assert!(matches!(error, BoundError::NotABound { name: "λ", .. }), "{error}");
            let error = OwnNorms::new(1.0, Some(bad), 1.0, 2).expect_err("ν");
            assert!(matches!(error, BoundError::NotABound { name: "ν", .. }), "{error}");
            let error = OwnNorms::new(1.0, None, bad, 2).expect_err("d");
            assert!(matches!(error, BoundError::NotADistance { .. }), "{error}");
        }
        assert_eq!(OwnNorms::new(1.0, None, 1.0, 0), Err(BoundError::NoDimension));
    }
}
