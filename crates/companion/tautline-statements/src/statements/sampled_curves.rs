//! Propositions 7.6 and 7.7, `C_tra(N)` and `C_tra♯`: the discrete energy of a sampled curve.

use std::num::NonZeroUsize;

use tautline::{
    Bounded, Constants, Integral, Rule,
    bounds::{PaperRule, pointwise_fall, pointwise_rise, sampling_fall, sampling_rise},
};

use super::morrey::without_kinks;
use crate::{
    Evidence, GramRange, Statement, Subject, Unit, VerifyError,
    curves::{BoundedCurve, curve_energy, l2_norm},
    reconstruction::nodes,
};

/// The energy of a curve and the discrete energies of its samples.
struct Sampled {
    curve: Integral,
    trapezoidal: f64,
    left: f64,
    /// `‖γ̇‖` and `‖γ̈‖`, rounded up by the errors of their quadratures: the best `K₁` and `K₂`.
    norms: [f64; 2],
    gram: GramRange,
    /// The allowance for quadrature and rounding, in `m²`.
    granted: f64,
}

impl Sampled {
    fn of<const D: usize>(
        subject: &Subject,
        metric: &impl Bounded<D>,
        curve: &impl BoundedCurve<D>,
        n: NonZeroUsize,
    ) -> Result<Self, VerifyError> {
        let sequence = curve.sample(n.get())?;
        let trapezoidal = subject.discrete_energy(Rule::TRAPEZOIDAL, metric, &sequence);
        let left = subject.discrete_energy(Rule::LEFT_ENDPOINT, metric, &sequence);
        let energy = curve_energy(metric, curve, 2 * n.get());
        let upper = |norm: Integral| norm.value + norm.error;
        let constants = subject.constants(metric);
        let [position, speed, _] = curve.suprema();
        // A sample is off by r, and hence β by 2Nr. This changes a discrete energy by 2 c₂ |β|
        // times 2Nr and, through the slope of H, by a term in r. The integrand changes by the
        // rounding of γ̇ and through the slope of H.
        let r = 64.0 * f64::EPSILON * position;
        let rounding = constants.c2() * speed * (4.0 * n.get() as f64 * r + 1e-14 * speed)
            + 2.0 * constants.l_h() * r * speed * speed;
        Ok(Self {
            curve: energy,
            trapezoidal,
            left,
            norms: [1, 2].map(|k| upper(l2_norm(curve, k, [0.0, 1.0]))),
            gram: GramRange::along(metric, nodes(&sequence))?,
            granted: energy.error + rounding,
        })
    }
}

/// Evaluates Proposition 7.6 in its repaired form, with `K₁ = ‖γ̇‖` and `K₂ = ‖γ̈‖`.
///
/// ```text
/// |E(γ) − E_tra,N(γ)|  ≤  C_tra(N)
/// ```
///
/// Needs: `0 ≤ H ≤ c₂`, `H` Lipschitz, and that `γ̇` does not jump, which the paper omits.
///
/// The least known overestimation is 4, for a straight line over a valley at the middle of each
/// chord. The companions are attained.
///
/// Companions: `β` is the mean of `γ̇` over its subinterval, so that the cross term of the proof
/// integrates to 0 and Wirtinger's inequality bounds the square. The bounds on `E_tra,N − E` do not
/// need `c₂`, by Jensen's inequality.
///
/// ```text
/// E_tra,N − E  ≤  (L_H/2N) K₁² (K₁ + K₂/√3)
/// E − E_tra,N  ≤  (L_H/2N) K₁² (K₁ + K₂/√3) + c₂ K₂²/π²N²
/// E_tra,N − E  ≤  L_H A₁² (A₁/4N + A₂/12N²)        where |γ̇| ≤ A₁ and |γ̈| ≤ A₂ at every time
/// E − E_tra,N  ≤  L_H A₁² (A₁/4N + A₂/12N²) + c₂ A₂²/12N²
/// E_l,N − E    ≤  L_H A₁³/2N
/// ```
///
/// # Errors
///
/// [`VerifyError::Metric`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:approx_numerical_integral")]
pub fn prop_7_6<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    n: NonZeroUsize,
) -> Result<Evidence, VerifyError> {
    let seen = Sampled::of(subject, metric, curve, n)?;
    let constants = subject.constants(metric);
    let [k1, k2] = seen.norms;
    let [_, a1, a2] = curve.suprema();
    let bound = subject.c_tra(constants, k1, k2, n);
    let (rise, fall) = (seen.trapezoidal - seen.curve.value, seen.curve.value - seen.trapezoidal);
    let left = seen.left - seen.curve.value;
    let pointwise = |rule| pointwise_rise(constants, rule, a1, a2, n);
    let evidence = Evidence::of(Statement::Proposition7_6).given_constants(constants, &seen.gram);
    let evidence = without_kinks(evidence, curve);
    let (claim, numbers) = ("|E − E_tra,N| ≤ C_tra(N)", [rise.abs(), bound]);
    let evidence = evidence.stated(claim, Unit::ENERGY, numbers, seen.granted);
    let companions = [
        ("E_tra,N − E ≤ L_H K₁²(K₁ + K₂/√3)/2N", rise, sampling_rise(constants, k1, k2, n)),
        (
            "E − E_tra,N ≤ L_H K₁²(K₁ + K₂/√3)/2N + c₂K₂²/π²N²",
            fall,
            sampling_fall(constants, k1, k2, n),
        ),
        ("E_tra,N − E ≤ L_H A₁²(A₁/4N + A₂/12N²)", rise, pointwise(PaperRule::Trapezoidal)),
        (
            "E − E_tra,N ≤ L_H A₁²(A₁/4N + A₂/12N²) + c₂A₂²/12N²",
            fall,
            pointwise_fall(constants, a1, a2, n),
        ),
        ("E_l,N − E ≤ L_H A₁³/2N", left, pointwise(PaperRule::LeftEndpoint)),
    ];
    Ok(companions.into_iter().fold(evidence, |evidence, (claim, gap, bound)| {
        evidence.sharper(claim, Unit::ENERGY, [gap, bound], seen.granted)
    }))
}

/// Evaluates Proposition 7.6 as printed. It admits kinks, which `‖γ̈‖` does not see.
///
/// It is false for `γ(t) = |t − ½|`, `H = 1`, `N = 1` and `K₂ < (√2 − 1)/2`, where `E = 1` and
/// `E_tra = 0`.
///
/// # Errors
///
/// The errors of [`prop_7_6`].
pub fn prop_7_6_as_printed<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curve: &impl BoundedCurve<D>,
    [k1, k2]: [f64; 2],
    n: NonZeroUsize,
) -> Result<Evidence, VerifyError> {
    let seen = Sampled::of(subject, metric, curve, n)?;
    let constants = subject.constants(metric);
    let bound = subject.c_tra(constants, k1, k2, n);
    let gap = (seen.curve.value - seen.trapezoidal).abs();
    let granted = 1e-12 * seen.norms[0];
    Ok(Evidence::of(Statement::Proposition7_6)
        .given_constants(constants, &seen.gram)
        .given("‖γ̇‖ ≤ K₁", Unit::COORDINATE, [seen.norms[0], k1], granted)
        .given("‖γ̈‖ ≤ K₂", Unit::COORDINATE, [seen.norms[1], k2], granted)
        .stated("|E − E_tra,N| ≤ C_tra(N)", Unit::ENERGY, [gap, bound], seen.granted))
}

/// Evaluates Proposition 7.7 in its repaired form, on a finite set `Ξ` of curves whose norms are at
/// most `K₁` and `K₂`.
///
/// ```text
/// min E_tra,N  ≤  min E + C_tra(N)      over Ξ
/// ```
///
/// Needs: the hypotheses of [`prop_7_6`] for every curve, except `c₂`. The overestimation is the
/// same as there. Companion: half of the first term of `C_tra(N)`, without the other terms.
///
/// # Errors
///
/// The errors of [`prop_7_6`].
#[doc(alias = "prop:approx_numerical_integral_set")]
pub fn prop_7_7<const D: usize>(
    subject: &Subject,
    metric: &impl Bounded<D>,
    curves: &[impl BoundedCurve<D>],
    n: NonZeroUsize,
) -> Result<Evidence, VerifyError> {
    let constants = subject.constants(metric);
    let mut evidence = Evidence::of(Statement::Proposition7_7);
    let (mut least, mut least_sampled) = (f64::INFINITY, f64::INFINITY);
    let (mut norms, mut granted) = ([0.0_f64; 2], 0.0_f64);
    for curve in curves {
        let seen = Sampled::of(subject, metric, curve, n)?;
        least = least.min(seen.curve.value);
        least_sampled = least_sampled.min(seen.trapezoidal);
        norms = [0, 1].map(|k| norms[k].max(seen.norms[k]));
        granted = granted.max(seen.granted);
        evidence = without_kinks(evidence.given_constants(constants, &seen.gram), curve);
    }
    let gap = least_sampled - least;
    let bound = subject.c_tra(constants, norms[0], norms[1], n);
    let sharp = sampling_rise(constants, norms[0], norms[1], n);
    let sharper = "min E_tra,N − min E ≤ L_H K₁²(K₁ + K₂/√3)/2N";
    Ok(evidence
        .stated("min E_tra,N − min E ≤ C_tra(N)", Unit::ENERGY, [gap, bound], granted)
        .sharper(sharper, Unit::ENERGY, [gap, sharp], granted))
}

/// Evaluates the definition of `C_tra(N)`.
///
/// ```text
/// C_tra(N)  =  (L_H (K₁³ + 2 K₁² K₂) + 4 c₂ K₁ K₂)/N + 4 c₂ K₂²/N²
/// ```
///
/// This is an identity: it compares the definition, grouped by powers of `K₁`, with the library's
/// order of terms. [`prop_7_6`] and [`prop_7_7`] have the bounds by `C_tra(N)`. Needs: nothing.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "C_tra(N)")]
#[must_use]
pub fn constant_c_tra(
    subject: &Subject,
    constants: Constants,
    [k1, k2]: [f64; 2],
    n: NonZeroUsize,
) -> Evidence {
    // The terms are grouped by powers of K₁, so as not to repeat an error in the library's order of
    // terms.
    let (l_h, c2, h) = (constants.l_h(), constants.c2(), 1.0 / n.get() as f64);
    let defined = h * l_h * k1.powi(3)
        + 2.0 * h * k2 * (l_h * k1.powi(2) + 2.0 * c2 * k1)
        + 4.0 * c2 * (h * k2).powi(2);
    let found = subject.c_tra(constants, k1, k2, n);
    // Both sides are sums of nonnegative terms with a dozen roundings each.
    let granted = 32.0 * f64::EPSILON * defined;
    let claims = ["C_tra(N) ≤ its definition", "its definition ≤ C_tra(N)"];
    Evidence::of(Statement::ConstantCTra).identity(claims, Unit::ENERGY, [found, defined], granted)
}

/// Evaluates `C_tra(N) ≤ C_tra♯/N`. Needs: nothing.
///
/// The bound is attained as `K₂ → 0`. For `N = 1` or `K₂ = 0`, the two sides are the same formula,
/// and the claim is an identity.
///
/// # Panics
///
/// If `k1` or `k2` is negative or NaN.
#[doc(alias = "C_tra^sharp")]
#[must_use]
pub fn constant_c_tra_sharp(
    subject: &Subject,
    constants: Constants,
    [k1, k2]: [f64; 2],
    n: NonZeroUsize,
) -> Evidence {
    let of_n = subject.c_tra(constants, k1, k2, n);
    let sharp = subject.c_tra_sharp(constants, k1, k2) / n.get() as f64;
    let (begun, claim) = (Evidence::of(Statement::ConstantCTraSharp), "C_tra(N) ≤ C_tra♯/N");
    let granted = 8.0 * f64::EPSILON * sharp;
    if n.get() == 1 || k2 == 0.0 {
        let claims = [claim, "C_tra♯/N ≤ C_tra(N)"];
        return begun.identity(claims, Unit::ENERGY, [of_n, sharp], granted);
    }
    begun.stated(claim, Unit::ENERGY, [of_n, sharp], granted)
}
