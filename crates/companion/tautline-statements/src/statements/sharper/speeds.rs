//! Lemmas S.3 and S.5: the greatest speed of a chord, and the spread of the speeds.

use tautline::{Bounded, MetricError, PointSequence};

use crate::statements::section_1::admitted;
use crate::{
    Evidence, GramRange, PaperRule, Reconstruction, Statement, Subject, Unit, discrete_energy,
    reconstruction::nodes,
};

/// Evaluates Lemma S.3 on any point sequence, with its residual `ρ`.
///
/// ```text
/// max qₙ   ≤  min( √(N E_N), √E_N + (L_H/c₁^{3/2}) E_N + mean|ρ|/√c₁ ),      ∂E_N/∂xₙ = −2hρₙ
/// max |βₙ|  ≤  (c₂K₃ + ½ L_H K₃² + mean|ρ|)/c₁
/// ```
///
/// Needs: `c₁ ≤ H` and `H` Lipschitz; the second inequality also needs `H ≤ c₂`.
///
/// Both are attained for a constant metric. The `L_H` term of the second is attained in a limit of
/// sequences that run away. Companion: `|βₙ − βₙ₋₁| ≤ (3L_H/2Nc₁) B² + |ρₙ|/Nc₁`, where `B` is the
/// largest difference; this is attained over a twist.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
pub fn lemma_s_3<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    rule: PaperRule,
    sequence: &PointSequence<D>,
) -> Result<Evidence, MetricError> {
    let gradient = subject.energy_gradient(rule.into(), metric, sequence);
    let speeds = subject.discrete_speeds(rule.into(), metric, sequence);
    let (n, constants) = (sequence.n(), subject.constants(metric));
    let (count, c1, c2) = (n.get() as f64, constants.c1(), constants.c2());
    let energy = discrete_energy(subject, rule, metric, sequence);
    let rho: Vec<f64> = gradient[1..n.get()].iter().map(|g| g.norm() * 0.5 * count).collect();
    let mean_rho = rho.iter().sum::<f64>() / count;
    let fastest = speeds.iter().copied().fold(0.0, f64::max);
    let differences: Vec<_> = sequence.differences().collect();
    let greatest = differences.iter().map(|beta| beta.norm()).fold(0.0, f64::max);
    let steps = differences.windows(2).zip(&rho).map(|(pair, rho)| {
        let bound = subject.difference_step(constants, greatest, n) + rho / (count * c1);
        [(pair[1] - pair[0]).norm(), bound]
    });
    let over = |[step, bound]: &[f64; 2]| step - bound;
    let worst = steps.max_by(|a, b| over(a).total_cmp(&over(b))).unwrap_or([0.0, 0.0]);
    // The rounding of the points changes a difference by 2Nε|x|, and a residual, which has two
    // momenta, by 8N²c₂ε|x|. A momentum is also off by a few ε, and by the effect of the slope of
    // H.
    let size = sequence.points().iter().map(|x| x.norm()).fold(0.0, f64::max);
    let off = f64::EPSILON * count * size;
    let slope = constants.l_h() * f64::EPSILON * size * greatest;
    let momentum = c2 * (8.0 * off + 16.0 * f64::EPSILON * greatest) + slope;
    let residual = momentum * count;
    let speed_bound = subject.greatest_speed(constants, energy, mean_rho, n);
    let difference_bound = subject.greatest_difference(constants, sequence.k3(), mean_rho);
    let speed_granted = residual / c1.sqrt() + 1e-14 * fastest;
    let difference_granted = residual / c1 + 1e-14 * greatest;
    let step_granted = residual / (count * c1) + 4.0 * off;
    let [speed, difference] =
        ["max qₙ ≤ √E + (L_H/c₁^{3/2})E + mean|ρ|/√c₁", "max|βₙ| ≤ (c₂K₃ + ½L_H K₃² + mean|ρ|)/c₁"];
    Ok(Evidence::of(Statement::LemmaS3)
        .given_constants(constants, &GramRange::along(metric, nodes(sequence))?)
        .stated(speed, Unit::LENGTH, [fastest, speed_bound], speed_granted)
        .stated(difference, Unit::COORDINATE, [greatest, difference_bound], difference_granted)
        .sharper("|βₙ − βₙ₋₁| ≤ 3L_H B²/2Nc₁ + |ρₙ|/Nc₁", Unit::COORDINATE, worst, step_granted))
}

/// Evaluates Lemma S.5 on any sequence from set to set, where the distance `d > 0` is known. With
/// `uₙ = qₙ/d` and `ε = max(1, E_N/d²)`,
///
/// ```text
/// mean u ≥ 1 − x,    v ≤ ε − max(0, 1 − x)²,    |uₙ − mean u| ≤ √((N − 1)v)
/// mean u³ ≤ m₃,      mean u⁴ ≤ m₄
/// L(γᵖˡ)²  ≤  E_N + (k L_H/N c₁^{3/2}) E_N^{3/2}
/// L(γᵖˡ)²  ≤  E_tra,N + (M_H/24c₁²N²) E_tra,N²
/// ```
///
/// Needs: `c₁ ≤ H`; `H` Lipschitz, and for the bound with `M_H` also `DH` Lipschitz; both ends in
/// their sets. The sequence need not be a minimiser.
///
/// The last two bounds are attained at `N = 1`: over a valley as `δ → 0`, and along a parabola as
/// `μ → 0`.
#[must_use]
pub fn lemma_s_5<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let &Reconstruction {
        setting, rule, n, discrete_energy, distance_squared: d2, granted, ..
    } = seen;
    let d = setting.distance();
    let relative = granted / d2;
    let u: Vec<f64> = seen.speeds.iter().map(|q| q / d).collect();
    let mean = |f: &dyn Fn(f64) -> f64| u.iter().map(|&u| f(u)).sum::<f64>() / u.len() as f64;
    let average = mean(&|u| u);
    let variance = mean(&|u| (u - average).powi(2));
    let deviation = u.iter().map(|u| (u - average).abs()).fold(0.0, f64::max);
    let surplus = (discrete_energy / d2 - 1.0).max(0.0);
    let mut evidence = admitted(Evidence::of(Statement::LemmaS5), seen);
    evidence = evidence.given("0 < d", Unit::LENGTH, [-d, 0.0], 0.0);
    let spreads = [
        Some(subject.spread(setting, rule, n, surplus)),
        subject.sharp_spread(setting, n, surplus).filter(|_| rule == PaperRule::Trapezoidal),
    ];
    // `off` is the root of the allowance for the variance; its products with the moments also
    // count.
    let others = (n.get() - 1) as f64;
    let off = (others * relative).sqrt();
    for spread in spreads.into_iter().flatten() {
        let moments = 16.0 * relative * (1.0 + spread.deviation).powi(2)
            + 4.0 * off * spread.variance * (1.0 + spread.deviation);
        evidence = evidence
            .stated("1 − mean u ≤ x", Unit::NONE, [1.0 - average, spread.shortfall], relative)
            .stated("var u ≤ v", Unit::NONE, [variance, spread.variance], 4.0 * relative)
            .stated(
                "|u − mean u| ≤ √((N−1)v)",
                Unit::NONE,
                [deviation, spread.deviation],
                2.0 * off,
            )
            .stated("mean u³ ≤ m₃", Unit::NONE, [mean(&|u| u.powi(3)), spread.cube], moments)
            .stated("mean u⁴ ≤ m₄", Unit::NONE, [mean(&|u| u.powi(4)), spread.fourth], moments);
    }
    if let (Some(m_h), PaperRule::Trapezoidal) = (setting.constants().m_h(), rule) {
        evidence = evidence.given_curvature(seen.curvature, m_h);
    }
    let bound = subject.squared_length(setting.constants(), rule, discrete_energy, n);
    let (excess, room) = (seen.length_squared.value - discrete_energy, bound - discrete_energy);
    evidence.stated("L(γᵖˡ)² − E_N ≤ its bound", Unit::ENERGY, [excess, room], granted)
}
