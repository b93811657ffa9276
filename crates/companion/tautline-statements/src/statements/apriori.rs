//! Proposition 7.12, `K_{1,g}`, `K_{2,g}` and Lemma S.1: bounds on a minimal geodesic.

use nalgebra::SVector;
use tautline::{Bounded, Constants, bounds::Setting, norm_squared};

use crate::{
    Evidence, GramRange, Statement, Subject, Unit, VerifyError,
    curvature::curvature_at,
    curves::{BoundedCurve, curve_energy, l2_norm},
};

/// The state of a minimal geodesic at one time.
struct Instant {
    setting: Setting,
    evidence: Evidence,
    speed: f64,
    acceleration: f64,
    /// The allowances for `γ̇` and `γ̈`, in `ℓ`.
    granted: [f64; 2],
}

impl Instant {
    /// Checks at the time `t` that the speed is `d` and that the geodesic equation holds.
    fn of<const D: usize>(
        statement: Statement,
        subject: &Subject,
        metric: &impl Bounded<D>,
        curve: &impl BoundedCurve<D>,
        distance: f64,
        t: f64,
    ) -> Result<Self, VerifyError> {
        let setting = Setting::new(subject.constants(metric), distance, D)?;
        let constants = setting.constants();
        let [position, velocity, acceleration] = curve.motion(t).derivatives();
        let symbols = subject.christoffel(metric, &position)?;
        let expected = SVector::<f64, D>::from_fn(|k, _| -velocity.dot(&(symbols[k] * velocity)));
        let residual = (acceleration - expected).norm();
        let speed_squared = norm_squared(metric, &position, &velocity);
        let [size, a1, a2] = curve.suprema();
        let natural = constants.l_h() / constants.c1();
        let condition = constants.c2() / constants.c1();
        // A derivative has a dozen roundings. The metric is evaluated at a point that is off by a
        // few ε|γ|, and it varies on the scale c₁/L_H. Γ is off by ε times the condition number.
        let relative = 128.0 * f64::EPSILON * (1.0 + condition + size * natural);
        let granted = [relative * a1, relative * (a2 + 1.5 * natural * a1 * a1)];
        let seen = GramRange::near(metric, constants, &position)?;
        let off = (speed_squared - distance * distance).abs();
        let rounding = 2.0 * constants.c2() * a1 * granted[0] + relative * distance * distance;
        let evidence = Evidence::of(statement)
            .given_constants(constants, &seen)
            .given("|g(γ̇, γ̇) − d²| = 0", Unit::ENERGY, [off, 0.0], rounding)
            .given("|γ̈ + Γ(γ̇, γ̇)| = 0", Unit::COORDINATE, [residual, 0.0], granted[1] * (D as f64));
        let (speed, acceleration) = (velocity.norm(), acceleration.norm());
        Ok(Self { setting, evidence, speed, acceleration, granted })
    }
}

/// Evaluates the bound `|γ̇(t)| ≤ K_{1,g}`, where `K_{1,g} = d/√c₁`, on a minimal geodesic at the
/// time `t`.
///
/// Minimality is checked with `distance`: the speed must equal the distance `d` between the ends.
/// The bound uses neither the geodesic equation nor `c₂` and `L_H`.
///
/// The bound is attained where `H = c₁` in the direction of `γ̇`. Identity: `c₁ K_{1,g}² = d²`.
///
/// # Errors
///
/// [`VerifyError::Metric`] where `H` is not positive definite. [`VerifyError::Bound`] if `distance`
/// is negative or not finite.
#[doc(alias = "K_{1,g}")]
pub fn constant_k1<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    distance: f64,
    t: f64,
) -> Result<Evidence, VerifyError> {
    let statement = Statement::ConstantK1;
    let instant = Instant::of(statement, subject, metric, curve, distance, t)?;
    let k1 = subject.k1_g(instant.setting);
    let energy = instant.setting.constants().c1() * k1 * k1;
    let (d2, rounding) = (distance * distance, 16.0 * f64::EPSILON * energy);
    Ok(instant
        .evidence
        .stated("|γ̇(t)| ≤ K₁", Unit::COORDINATE, [instant.speed, k1], instant.granted[0])
        .identity(["c₁K₁² ≤ d²", "d² ≤ c₁K₁²"], Unit::ENERGY, [energy, d2], rounding))
}

/// Evaluates the bound `|γ̈(t)| ≤ K_{2,g}`, where `K_{2,g} = 3 L_H D² K_{1,g}²/2c₁`, on a minimal
/// geodesic at the time `t`.
///
/// Needs: the hypotheses of [`constant_k1`], the geodesic equation, and `H` Lipschitz. The bound
/// does not need `c₂`.
///
/// Its overestimation is at least `D²` for `D ≥ 2`, and at least 3 on the line, by the companion.
///
/// Companion: `|γ̈| ≤ ω (L_H/c₁) K_{1,g}²`, where `ω` is `3/2`, or `½` for an isotropic metric and
/// on the line (Lemma S.1). Identity: the definition of `K_{2,g}`.
///
/// # Errors
///
/// The errors of [`constant_k1`].
#[doc(alias = "K_{2,g}")]
pub fn constant_k2<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    distance: f64,
    t: f64,
) -> Result<Evidence, VerifyError> {
    let statement = Statement::ConstantK2;
    let instant = Instant::of(statement, subject, metric, curve, distance, t)?;
    let constants = instant.setting.constants();
    let k2 = subject.k2_g(instant.setting);
    // This is L_H d²/c₁², which is L_H K₁²/c₁ by the definition of K₁.
    let natural = constants.l_h() * (distance / constants.c1()).powi(2);
    let defined = 1.5 * natural * (D * D) as f64;
    let sharp = subject.k2_sharp(without_m_h(instant.setting)?);
    let (found, granted) = (instant.acceleration, instant.granted[1]);
    let rounding = 16.0 * f64::EPSILON * defined;
    let definition = ["K₂ ≤ 3L_H D² d²/2c₁²", "3L_H D² d²/2c₁² ≤ K₂"];
    Ok(instant
        .evidence
        .stated("|γ̈(t)| ≤ K₂", Unit::COORDINATE, [found, k2], granted)
        .sharper("|γ̈(t)| ≤ ω L_H K₁²/c₁", Unit::COORDINATE, [found, sharp], granted + rounding)
        .identity(definition, Unit::COORDINATE, [k2, defined], rounding))
}

/// Evaluates Lemma S.1 on a minimal geodesic at the time `t`.
///
/// ```text
/// |γ̈(t)|  ≤  G d/√c₁,        γ̈ᵀ H(γ) γ̈  ≤  G² d²
/// ```
///
/// Here [`G`](Setting::bend) is that of the setting: `ωδ`, where `ω` is `3/2`, or `½` for an
/// isotropic metric and on the line. In the last two cases, `G` is smaller if `M_H` is known.
///
/// Needs: the hypotheses of [`constant_k2`] and of `G`.
///
/// Both bounds are attained: for `D ≥ 2` at 0 over a twist, and for `ω = ½` at the foot of an
/// incline.
///
/// # Errors
///
/// The errors of [`constant_k1`].
pub fn lemma_s_1<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    distance: f64,
    t: f64,
) -> Result<Evidence, VerifyError> {
    let instant = Instant::of(Statement::LemmaS1, subject, metric, curve, distance, t)?;
    let setting = instant.setting;
    let bound = subject.k2_sharp(setting);
    let [position, _, acceleration] = curve.motion(t).derivatives();
    let force = norm_squared(metric, &position, &acceleration);
    let force_bound = setting.constants().c1() * bound * bound;
    let granted = instant.granted[1] + 16.0 * f64::EPSILON * bound;
    let momentum = 2.0 * (setting.constants().c2() * force_bound.max(force)).sqrt();
    let mut evidence = instant.evidence;
    if let (true, Some(m_h)) = (setting.bend_needs_m_h(), setting.constants().m_h()) {
        evidence = evidence.given_curvature(curvature_at(metric, &position), m_h);
    }
    Ok(evidence
        .stated("|γ̈(t)| ≤ G d/√c₁", Unit::COORDINATE, [instant.acceleration, bound], granted)
        .stated("γ̈ᵀHγ̈ ≤ G²d²", Unit::ENERGY, [force, force_bound], momentum * granted))
}

/// Evaluates Proposition 7.12 on a minimiser of the energy between points at a given distance.
///
/// ```text
/// ‖γ̇‖  ≤  K_{1,g},        ‖γ̈‖  ≤  K_{2,g}
/// ```
///
/// Needs: `H ≥ c₁`, `H` Lipschitz, and `E(γ) ≤ d²`, which a minimiser satisfies. Neither `c₂` nor
/// closed sets are needed.
///
/// The first bound is attained where `H = c₁` in the direction of the geodesic. The second has the
/// overestimation of [`constant_k2`].
///
/// Companion: `‖γ̈‖ ≤ ω (L_H/c₁) K_{1,g}²` with the `ω` of Lemma S.1.
///
/// # Errors
///
/// The errors of [`constant_k1`].
#[doc(alias = "prop:apriori_estuimate_geodesic")]
pub fn prop_7_12<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    distance: f64,
) -> Result<Evidence, VerifyError> {
    let setting = Setting::new(subject.constants(metric), distance, D)?;
    let constants = setting.constants();
    let energy = curve_energy(metric, curve, 4);
    let [velocity, acceleration] = [1, 2].map(|k| l2_norm(curve, k, [0.0, 1.0]));
    let seen = GramRange::along(metric, (0..9).map(|k| curve.motion(f64::from(k) / 8.0).position))?;
    let [size, a1, _] = curve.suprema();
    // As for a single time, γ̇ and the argument of the metric are rounded. The distance is a
    // difference of numbers of the size of √c₂ |γ|.
    let relative = 128.0 * f64::EPSILON * (1.0 + size * constants.l_h() / constants.c1());
    let granted = energy.error
        + constants.c2() * a1 * (2.0 * relative * a1)
        + 64.0 * f64::EPSILON * constants.c2().sqrt() * size * distance;
    // The error of the distance carries over to K₁ and to K₂, which contains K₁².
    let off = 32.0 * f64::EPSILON * constants.c2().sqrt() * size / constants.c1().sqrt();
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    let bend = subject.k2_sharp(without_m_h(setting)?);
    let granted_bend = acceleration.error
        + 2.0 * relative * bend
        + 2.0 * setting.omega() * constants.l_h() / constants.c1() * k1 * off;
    Ok(Evidence::of(Statement::Proposition7_12)
        .given_constants(constants, &seen)
        .given("E(γ) ≤ d²", Unit::ENERGY, [energy.value, distance * distance], granted)
        .stated("‖γ̇‖ ≤ K₁", Unit::COORDINATE, [velocity.value, k1], velocity.error + off)
        .stated("‖γ̈‖ ≤ K₂", Unit::COORDINATE, [acceleration.value, k2], granted_bend)
        .sharper("‖γ̈‖ ≤ ω L_H K₁²/c₁", Unit::COORDINATE, [acceleration.value, bend], granted_bend))
}

/// Returns the setting without `M_H`, for which Lemma S.1 has the bound by `L_H` alone.
fn without_m_h(setting: Setting) -> Result<Setting, VerifyError> {
    let known = setting.constants();
    let constants = Constants::new(known.c1(), known.c2(), known.l_h())?;
    let constants = if known.is_isotropic() { constants.isotropic() } else { constants };
    Ok(Setting::new(constants, setting.distance(), setting.dimension())?)
}
