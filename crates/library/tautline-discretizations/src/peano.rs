//! How far the discrete energy of any rule is from that of the reconstructed curve.

use crate::{Node, PointSequence, Rule};

/// The Peano constants of a rule on a chord: the least `κ₁` and `κ₂` with
///
/// ```text
/// |∫₀¹ f − Σᵢ wᵢ f(θᵢ)| ≤ κ₁ sup |f′|     and     ≤ κ₂ sup |f″|
/// ```
///
/// for all functions `f` on `[0, 1]`.
///
/// Along a chord `f(s) = βᵀH(x + s d)β` has `|f′| ≤ L |β|³/N` and `|f″| ≤ M |β|⁴/N²`, so that for
/// every point sequence
///
/// ```text
/// |E(γᵖˡ) − E_N| ≤ κ₁ (L/N) mean |β|³     and     ≤ κ₂ (M/N²) mean |β|⁴.
/// ```
///
/// This is Lemma S.2 for any rule; it has `κ₁ = 1/4` and `κ₂ = 1/24` for
/// [`Rule::TRAPEZOIDAL`] and `κ₁ = 1/2` for [`Rule::LEFT_ENDPOINT`].
/// Both constants are attained by metrics `H = φ I`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PeanoConstants {
    /// The constant `κ₁`, the distance of Wasserstein between the weights and the uniform density.
    /// It is infinite for weights that do not add up to 1.
    pub first: f64,
    /// The constant `κ₂`, infinite for a rule that is not exact for linear functions.
    pub second: f64,
}

/// The sums `Σ wᵢ` and `Σ wᵢ θᵢ` are 1 and `1/2` up to a few roundings if a rule is exact for
/// linear functions.
const ROUNDING: f64 = 8.0 * f64::EPSILON;

impl PeanoConstants {
    /// Returns the constants of a rule, up to a few roundings.
    #[must_use]
    pub fn of(rule: Rule) -> Self {
        let moment: f64 = rule.nodes().iter().map(|node| node.weight * node.fraction).sum();
        let weight: f64 = rule.nodes().iter().map(|node| node.weight).sum();
        let is_constant = (weight - 1.0).abs() <= ROUNDING;
        let is_linear = is_constant && (moment - 0.5).abs() <= ROUNDING;
        let mut ends: Vec<f64> = rule.nodes().iter().map(|node| node.fraction).collect();
        ends.extend([0.0, 1.0]);
        ends.sort_by(f64::total_cmp);
        let pieces = || ends.windows(2).map(|piece| [piece[0], piece[1]]);
        let first =
            pieces().map(|piece| integral_of_size(piece, |s| first_kernel(rule.nodes(), piece, s)));
        let second = pieces()
            .map(|piece| integral_of_size(piece, |s| second_kernel(rule.nodes(), piece, s)));
        let second = if is_linear { second.sum() } else { f64::INFINITY };
        let first = if is_constant { first.sum() } else { f64::INFINITY };
        Self { first, second }
    }

    /// Returns a bound on `|E(γᵖˡ) − E_N|`, in `m²`, for a metric with the Lipschitz constant
    /// `lipschitz` along the chords, in `m²/ℓ³`: `κ₁ (L/N) mean |β|³`.
    #[must_use]
    pub fn gap<const D: usize>(&self, sequence: &PointSequence<D>, lipschitz: f64) -> f64 {
        if self.first == f64::INFINITY {
            return f64::INFINITY;
        }
        self.first * lipschitz * mean_power(sequence, 3) / sequence.n().get() as f64
    }

    /// Returns a bound on `|E(γᵖˡ) − E_N|`, in `m²`, for a metric whose second derivatives along the
    /// chords are at most `curvature`, the constant `M_H` in `m²/ℓ⁴`: `κ₂ (M/N²) mean |β|⁴`.
    #[must_use]
    pub fn smooth_gap<const D: usize>(&self, sequence: &PointSequence<D>, curvature: f64) -> f64 {
        if self.second == f64::INFINITY {
            return f64::INFINITY;
        }
        self.second * curvature * mean_power(sequence, 4) / (sequence.n().get() as f64).powi(2)
    }
}

/// Returns `K₁(s) = 1 − s − Σ wᵢ` over the nodes beyond a piece, on that piece.
fn first_kernel(nodes: &[Node], [_, to]: [f64; 2], s: f64) -> f64 {
    let beyond = nodes.iter().filter(|node| node.fraction >= to);
    1.0 - s - beyond.map(|node| node.weight).sum::<f64>()
}

/// Returns `K₂(s) = (1 − s)²/2 − Σ wᵢ (θᵢ − s)` over the nodes beyond a piece, on that piece.
fn second_kernel(nodes: &[Node], [_, to]: [f64; 2], s: f64) -> f64 {
    let beyond = nodes.iter().filter(|node| node.fraction >= to);
    (1.0 - s).powi(2) / 2.0 - beyond.map(|node| node.weight * (node.fraction - s)).sum::<f64>()
}

/// Returns `∫ |k|` over a piece on which `k` is a polynomial of degree 2 or less.
///
/// The integral of a polynomial of degree 3 or less is that of Simpson's rule. The roots split the
/// piece.
fn integral_of_size([from, to]: [f64; 2], k: impl Fn(f64) -> f64) -> f64 {
    let middle = 0.5 * (from + to);
    let (a, b, c) = (k(from), k(middle), k(to));
    // In t from −1 to 1 the polynomial is b + (c − a)/2 t + (a + c − 2b)/2 t².
    let (linear, square) = (0.5 * (c - a), 0.5 * (a + c) - b);
    let mut roots = Vec::new();
    let discriminant = linear * linear - 4.0 * square * b;
    if discriminant >= 0.0 {
        // The larger of both numerators has no cancellation.
        let numerator = -0.5 * (linear + discriminant.sqrt().copysign(linear));
        roots.extend([numerator / square, b / numerator]);
    }
    roots.retain(|root| root.abs() < 1.0);
    roots.sort_by(f64::total_cmp);
    let at = |t: f64| b + t * (linear + t * square);
    let ends: Vec<f64> = std::iter::once(-1.0).chain(roots).chain([1.0]).collect();
    let simpson = |piece: &[f64]| {
        let (from, to) = (piece[0], piece[1]);
        (to - from) / 6.0 * (at(from) + 4.0 * at(0.5 * (from + to)) + at(to))
    };
    ends.windows(2).map(|piece| simpson(piece).abs()).sum::<f64>() * 0.5 * (to - from)
}

/// Returns the mean of `|βₙ|ᵖ`.
fn mean_power<const D: usize>(sequence: &PointSequence<D>, power: i32) -> f64 {
    let sum: f64 = sequence.differences().map(|beta| beta.norm().powi(power)).sum();
    sum / sequence.n().get() as f64
}

#[cfg(test)]
mod tests {
    use super::PeanoConstants;
    use crate::{Node, PointSequence, Rule};

    #[test]
    fn the_constants_of_known_rules() {
        let infinity = f64::INFINITY;
        for (found, first, second) in [
            (PeanoConstants::of(Rule::TRAPEZOIDAL), 1.0 / 4.0, 1.0 / 24.0),
            (PeanoConstants::of(Rule::TRUE_TRAPEZOID), 1.0 / 4.0, 1.0 / 12.0),
            (PeanoConstants::of(Rule::LEFT_ENDPOINT), 1.0 / 2.0, infinity),
            (PeanoConstants::of(Rule::RIGHT_ENDPOINT), 1.0 / 2.0, infinity),
            (PeanoConstants::of(Rule::SIMPSON), 5.0 / 36.0, 1.0 / 81.0),
        ] {
            // A few roundings of numbers below 1.
            assert!((found.first - first).abs() <= 1e-15, "{found:?} {first}");
            let close = (found.second - second).abs() <= 1e-15;
            assert!(close || found.second == second, "{found:?} {second}");
        }
        // Two nodes at a and 1 − a have κ₁ = a² + (1/2 − a)².
        let a = 0.5 - 1.0 / 12.0_f64.sqrt();
        let found = PeanoConstants::of(Rule::GAUSS_TWO).first;
        assert!((found - (a * a + (0.5 - a).powi(2))).abs() <= 1e-15, "{found}");
    }

    /// Sums over a fine grid of the kernels, whose error is at most half the variation of a kernel,
    /// at most 2, times the spacing.
    #[test]
    fn the_constants_are_the_integrals_of_the_kernels() {
        fn compare(rule: Rule) {
            const CELLS: usize = 100_000;
            let (mut first, mut second) = (0.0, 0.0);
            for cell in 0..CELLS {
                let s = (cell as f64 + 0.5) / CELLS as f64;
                let beyond = || rule.nodes().iter().filter(|node: &&Node| node.fraction > s);
                let weight: f64 = beyond().map(|node| node.weight).sum();
                let moment: f64 = beyond().map(|node| node.weight * (node.fraction - s)).sum();
                first += (1.0 - s - weight).abs() / CELLS as f64;
                second += ((1.0 - s).powi(2) / 2.0 - moment).abs() / CELLS as f64;
            }
            let found = PeanoConstants::of(rule);
            assert!((found.first - first).abs() <= 2e-5, "{rule}: {found:?} {first}");
            if rule.error_exponent() == 2 {
                assert!((found.second - second).abs() <= 2e-5, "{rule}: {found:?} {second}");
                // The constants of the second order separate rules, so that this sees a wrong node.
                assert!(second > 1e-3);
            } else {
                assert_eq!(found.second, f64::INFINITY);
            }
        }
        for &rule in Rule::ALL {
            compare(rule);
        }
    }

    /// A constant that does not exist gives no bound, not even for a metric without slopes.
    #[test]
    fn a_missing_constant_bounds_nothing() {
        const TOO_LIGHT: Rule = Rule::new("too_light", &[Node { fraction: 0.5, weight: 0.9 }], 2);
        let line = PointSequence::straight([0.0], [1.0], 2).expect("finite");
        let found = PeanoConstants::of(TOO_LIGHT);
        assert_eq!(
            (found.gap(&line, 0.0), found.smooth_gap(&line, 0.0)),
            (f64::INFINITY, f64::INFINITY)
        );
        // Exact for `f(s) = s` alone, and for no other linear function.
        const BALANCED: Rule = Rule::new("balanced", &[Node { fraction: 0.625, weight: 0.8 }], 2);
        let found = PeanoConstants::of(BALANCED);
        assert_eq!((found.first, found.second), (f64::INFINITY, f64::INFINITY));
        assert_eq!(PeanoConstants::of(Rule::LEFT_ENDPOINT).smooth_gap(&line, 0.0), f64::INFINITY);
        assert_eq!(PeanoConstants::of(Rule::TRAPEZOIDAL).smooth_gap(&line, 0.0), 0.0);
    }
}
