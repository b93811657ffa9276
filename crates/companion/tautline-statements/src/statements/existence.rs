//! Proposition 7.1: the discrete energies have minimisers, in a known region.

use nalgebra::SVector;
use tautline::{Bounded, ClosedSet, PointSequence};

use crate::{
    Evidence, GramRange, PaperRule, Reconstruction, Statement, Subject, Unit, VerifyError,
    discrete_energy, reconstruction::nodes,
};

/// Evaluates Proposition 7.1 on two admissible sequences, the first of which claims to be a
/// minimiser.
///
/// ```text
/// |xₙ − X| ≤ √(R/c₁) for both,    E_N(γ*) ≤ E_N(γᵖ) = R
/// ```
///
/// Here `X` is the bounded set, and `R` is the energy of the second sequence. The first inequality
/// is from the proof. It implies that the sequences of energy at most `R` form a compact set, so
/// that a search may stay in a box. The second inequality defines a minimiser. Companion: even the
/// total way `Σ |xₙ₊₁ − xₙ|` is at most `√(R/c₁)`.
///
/// # Errors
///
/// [`VerifyError::Metric`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:existence_discrete_minimizers")]
pub fn prop_7_1<const D: usize>(
    subject: &Subject,
    rule: PaperRule,
    metric: &impl Bounded<D>,
    sets: [&dyn ClosedSet<D>; 2],
    [minimiser, other]: [&PointSequence<D>; 2],
) -> Result<Evidence, VerifyError> {
    let c1 = subject.constants(metric).c1();
    let gram = GramRange::along(metric, nodes(minimiser).chain(nodes(other)))?;
    let bounded = sets.iter().find(|set| set.radius().is_some_and(f64::is_finite));
    let differ = minimiser.n().get().abs_diff(other.n().get()) as f64;
    // The greatest distance between the points of a sequence and the bounded set.
    let reach = |sequence: &PointSequence<D>| match bounded {
        Some(&set) => sequence
            .points()
            .iter()
            .map(|x| (subject.project(set, x) - x).norm())
            .fold(0.0, f64::max),
        None => f64::INFINITY,
    };
    let off = [minimiser, other].map(|sequence| {
        let ends = [(sets[0], sequence.first()), (sets[1], sequence.last())];
        ends.map(|(set, x)| (set.project(x) - x).norm()).into_iter().fold(0.0, f64::max)
    });
    let off = off[0].max(off[1]);
    let size = [minimiser, other].map(|sequence| {
        sequence.points().iter().map(|x: &SVector<f64, D>| x.norm()).fold(0.0, f64::max)
    });
    let size = size[0].max(size[1]);
    let [least, energy] =
        [minimiser, other].map(|sequence| discrete_energy(subject, rule, metric, sequence));
    let way: f64 = other.chords().map(|(_, chord)| chord.norm()).sum();
    let radius = (energy / c1).sqrt();
    // A projection has 4 D roundings of coordinates; the radius is a root of a compensated sum.
    let rounding = 1e-14 * (size + radius);
    // The points have size |x| and are rounded; the momentum 2√(c₂E) turns this into an error of
    // the energy.
    let momentum = 2.0 * (gram.high * least.max(0.0)).sqrt();
    let granted = 1e-14 * (least + energy) + 8.0 * f64::EPSILON * size * momentum;
    Ok(Evidence::of(Statement::Proposition7_1)
        .given_that("one of the sets is bounded", bounded.is_some())
        .given("both sequences have the same N", Unit::NONE, [differ, 0.0], 0.0)
        .given("c₁ ≤ λ_min(H)", Unit::GRAM, [c1, gram.low], 1e-14 * gram.high)
        .assumed("c₁ holds elsewhere")
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], 1e-13 * size)
        .stated("|xₙ − X| ≤ √(R/c₁)", Unit::COORDINATE, [reach(other), radius], rounding)
        .stated("|xₙ − X| ≤ √(R/c₁) for γ*", Unit::COORDINATE, [reach(minimiser), radius], rounding)
        .stated("E_N(γ*) ≤ E_N(γᵖ)", Unit::ENERGY, [least, energy], granted)
        .sharper("Σ |xₙ₊₁ − xₙ| ≤ √(R/c₁)", Unit::COORDINATE, [way, radius], rounding))
}

/// Evaluates companions of Proposition 7.1, which state that a minimiser is a critical point.
///
/// ```text
/// ρₙ = (N/2) ∂E_N/∂xₙ = 0 inside,    P(x − s ∂E_N/∂x) = x at the ends, for small s > 0
/// |qₙ − qₙ₋₁| ≤ (L_H/N c₁^{3/2}) (w qₙ² + (1 − w) qₙ₋₁²),    qₙ² = βₙᵀHβₙ
/// ```
///
/// Here `w = ½` for the trapezoidal rule and `w = ⅝` for the left-endpoint rule. The last
/// inequality is a discrete form of Proposition 3.1, since it says that the speeds are nearly
/// equal. It follows from the first equation.
///
/// # Allowance
///
/// A search stops where a Newton step would lower the energy by `10⁻¹⁸ E`. The Hessian is at most
/// about `8 N c₂`, hence `|∂E|² ≤ 16 N c₂ · 10⁻¹⁸ E`, and `((1/N) Σ |ρₙ|²)^{1/2} = ½√N |∂E|` is at
/// most `2 N (c₂E)^{1/2} 10⁻⁹`. The rounding of the points adds a few `ε N² |x| c₂`.
#[must_use]
pub fn critical_point<M: Bounded<D>, const D: usize>(
    subject: &Subject,
    known: &crate::Known<M, D>,
    seen: &Reconstruction<D>,
) -> Evidence {
    let (metric, sequence) = (&known.metric, &seen.minimum.sequence);
    let gradient = subject.energy_gradient(seen.rule.into(), metric, sequence);
    let speeds = subject.discrete_speeds(seen.rule.into(), metric, sequence);
    let weight = match seen.rule {
        PaperRule::Trapezoidal => 0.5,
        PaperRule::LeftEndpoint => 0.625,
    };
    let (n, constants) = (seen.n.get(), seen.setting.constants());
    let (count, c2) = (n as f64, constants.c2());
    let size = sequence.points().iter().map(|x| x.norm()).fold(0.0, f64::max);
    let momentum = (c2 * seen.discrete_energy.max(0.0)).sqrt();
    let granted = 4e-9 * count * momentum + 16.0 * f64::EPSILON * count * count * size * c2;
    let inner = &gradient[1..n];
    let squares: f64 = inner.iter().map(|g| (g * (0.5 * count)).norm_squared()).sum();
    let residual = (squares / count).sqrt();
    // The step is short, since s has the size of the inverse Hessian; ½|∂E| is a momentum.
    let s = 1.0 / (2.0 * count * c2);
    let ends = [
        (known.ends.first(), sequence.first(), &gradient[0]),
        (known.ends.second(), sequence.last(), &gradient[n]),
    ];
    let slip = ends.map(|(set, x, g)| (subject.project(&**set, &(x - g * s)) - x).norm() * 0.5 / s);
    let lambda = constants.l_h() / constants.c1().powf(1.5);
    let steps = speeds.windows(2).map(|q| {
        let bound = lambda / count * (weight * q[1] * q[1] + (1.0 - weight) * q[0] * q[0]);
        [(q[1] - q[0]).abs(), bound]
    });
    let excess = |[step, bound]: &[f64; 2]| step - bound;
    let worst = steps.max_by(|a, b| excess(a).total_cmp(&excess(b))).unwrap_or([0.0, 0.0]);
    // The remaining gradient ∂E changes the speeds by |ρₙ|/(N √c₁), and |ρₙ| ≤ √N granted.
    let speed_granted = granted / (count * constants.c1()).sqrt()
        + 16.0 * f64::EPSILON * (count * size * c2.sqrt() + momentum);
    let (rho, rounding) = (Unit { ell: -1, m: 2 }, 1e-13 * (size + seen.k3));
    Evidence::of(Statement::Proposition7_1)
        .sharper("the ends lie in their sets", Unit::COORDINATE, [seen.off_sets, 0.0], rounding)
        .sharper("((1/N) Σ |ρₙ|²)^{1/2} = 0", rho, [residual, 0.0], granted)
        .sharper("½∂E/∂x₀ points into X⁽⁰⁾", rho, [slip[0], 0.0], granted)
        .sharper("½∂E/∂x_N points into X⁽¹⁾", rho, [slip[1], 0.0], granted)
        .sharper("|qₙ − qₙ₋₁| ≤ (L_H/N c₁^{3/2}) q²", Unit::LENGTH, worst, speed_granted)
}
