//! Theorems 1.1 to 1.4: the minimisers of the discrete energies and their reconstructions.
//!
//! # Global and local minimisers
//!
//! The theorems are about a global minimiser `γᵖ` of the discrete energy. A solver returns a local
//! minimiser, whose energy may be above the minimum. Therefore
//!
//! - `E_N − d² ≤ C/N` claims more than the theorem: it fails if the solver stops at a worse local
//!   minimiser;
//! - `E(γᵖˡ) − E_N ≤ C/√N` needs only the *premise* of `K̄_{3,g}` or `K̄_{4,g}`, an upper bound on the
//!   discrete energy. The premise is a hypothesis here: where it holds, the theorem holds for the
//!   computed sequence.
//!
//! There is no allowance for a residual: no inequality of the paper needs a stationary sequence.
//!
//! The constants exceed the observed numbers by many decades, so these inequalities alone hardly
//! test a program. The sharper companions are of first order in `1/N`, or bound the gap of the
//! computed sequence by the mean cube of its differences.

use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// This is assumed, since no finite number of evaluations shows it.
pub(super) const GLOBAL: &str = "γᵖ is a global minimiser";

/// Begins the evidence with the hypotheses on the metric, the ends, the rule and the premise.
pub(super) fn begin<const D: usize>(
    statement: Statement,
    seen: &Reconstruction<D>,
    rule: PaperRule,
    premise: f64,
) -> Evidence {
    let evidence = Evidence::of(statement);
    let evidence = evidence.given_that("the rule is that of the theorem", seen.rule == rule);
    let (claim, energy) = ("E_N ≤ the proof's bound on the minimum", seen.discrete_energy);
    admitted(evidence, seen).given(claim, Unit::ENERGY, [energy, premise], seen.granted)
}

/// Adds the hypotheses on the metric, and that the ends lie in their sets.
pub(super) fn admitted<const D: usize>(evidence: Evidence, seen: &Reconstruction<D>) -> Evidence {
    // Coordinates and radii have the size of K₃ + |x|, and a projection has about 4 D roundings.
    let size = seen.minimum.sequence.first().norm() + seen.k3;
    let (claim, numbers) = ("the ends lie in X⁽⁰⁾ and X⁽¹⁾", [seen.off_sets, 0.0]);
    let evidence = evidence.given_constants(seen.setting.constants(), &seen.gram);
    evidence.given(claim, Unit::COORDINATE, numbers, 1e-13 * size)
}

/// Returns the bound of the proof on the minimum: `d² + C_tra♯` for `E_tra,N` (Theorem 1.1), and
/// `d² + C_tra♯ + ½ L_H K̄_{3,g}³` for `E_l,N` (Theorem 1.3).
fn premise<const D: usize>(subject: &Subject, seen: &Reconstruction<D>, rule: PaperRule) -> f64 {
    let (setting, constants) = (seen.setting, seen.setting.constants());
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    let trapezoidal = seen.distance_squared + subject.c_tra_sharp(constants, k1, k2);
    match rule {
        PaperRule::Trapezoidal => trapezoidal,
        PaperRule::LeftEndpoint => {
            trapezoidal + 0.5 * constants.l_h() * subject.k3_bar_g(setting).powi(3)
        }
    }
}

/// Calls [`begin`] with the premise of the paper.
pub(super) fn begin_in_the_paper<const D: usize>(
    statement: Statement,
    subject: &Subject,
    seen: &Reconstruction<D>,
    rule: PaperRule,
) -> Evidence {
    begin(statement, seen, rule, premise(subject, seen, rule))
}

/// Evaluates Theorem 1.1 on a computed minimiser of the trapezoidal rule.
///
/// ```text
/// min E − C/√N  ≤  E(γᵖˡ) − C/√N  ≤  E_tra,N(γᵖ)  ≤  min E + C/N
/// ```
///
/// Companions: the gap of the computed sequence is at most `(L_H/4N) mean |β|³`, and all three gaps
/// are of order `1/N` ([`tautline::bounds::theorem_a_excess`] and its parts).
#[doc(alias = "theo:approx_numerical_integral_trapezoidal")]
#[must_use]
pub fn theorem_1_1<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let (constant, count) = (subject.theorem_1_1_constant(seen.setting), seen.n.get() as f64);
    let claims = Claims {
        polyline: ("E(γᵖˡ) − E_tra,N ≤ C/√N", constant / count.sqrt()),
        minimum: ("E_tra,N − d² ≤ C/N", constant / count),
        sharper: [
            "E(γᵖˡ) − E_tra,N ≤ L_H mean|β|³/4N",
            "E_tra,N − d² ≤ d² (e − 1)",
            "E(γᵖˡ) − E_tra,N ≤ d² (δ/4N) e Q",
            "d² − E_tra,N ≤ d² (δ/4N) e Q",
        ],
    };
    claims.conclude(Statement::Theorem1_1, subject, seen, PaperRule::Trapezoidal)
}

/// Evaluates Theorem 1.2 on a computed minimiser of the trapezoidal rule.
///
/// ```text
/// 0  ≤  L(γᵖˡ)² − d²  ≤  C/√N      with the C of Theorem 1.1
/// ```
///
/// Companion: `L(γᵖˡ)² − d²` is of order `1/N` ([`tautline::bounds::theorem_a_excess`]).
#[doc(alias = "theo:approx_numerical_integral_trapezoidal_length")]
#[must_use]
pub fn theorem_1_2<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let constant = subject.theorem_1_1_constant(seen.setting);
    length_excess(Statement::Theorem1_2, subject, seen, PaperRule::Trapezoidal, constant)
}

/// Evaluates Theorem 1.3 on a computed minimiser of the left-endpoint rule.
///
/// ```text
/// min E − C/√N  ≤  E(γᵖˡ) − C/√N  ≤  E_l,N(γᵖ)  ≤  min E + C/√N
/// ```
///
/// Companions: the gap of the computed sequence is at most `(L_H/2N) mean |β|³`, and all three gaps
/// are of order `1/N` ([`tautline::bounds::theorem_a_excess`] and its parts).
#[doc(alias = "theo:approx_numerical_integral_left")]
#[must_use]
pub fn theorem_1_3<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let bound = subject.theorem_1_3_constant(seen.setting) / (seen.n.get() as f64).sqrt();
    let claims = Claims {
        polyline: ("E(γᵖˡ) − E_l,N ≤ C/√N", bound),
        minimum: ("E_l,N − d² ≤ C/√N", bound),
        sharper: [
            "E(γᵖˡ) − E_l,N ≤ L_H mean|β|³/2N",
            "E_l,N − d² ≤ d² (e − 1)",
            "E(γᵖˡ) − E_l,N ≤ d² (δ/2N) e Q",
            "d² − E_l,N ≤ d² (δ/2N) e Q",
        ],
    };
    claims.conclude(Statement::Theorem1_3, subject, seen, PaperRule::LeftEndpoint)
}

/// The claims of Theorem 1.1 or 1.3 with their bounds, and the claims of their companions.
struct Claims {
    polyline: (&'static str, f64),
    minimum: (&'static str, f64),
    /// First by the mean cube; then by Theorem A: for the minimum, for the polyline, and from
    /// below.
    sharper: [&'static str; 4],
}

impl Claims {
    fn conclude<const D: usize>(
        self,
        statement: Statement,
        subject: &Subject,
        seen: &Reconstruction<D>,
        rule: PaperRule,
    ) -> Evidence {
        let &Reconstruction { setting, n, distance_squared: d2, discrete_energy, .. } = seen;
        let granted = seen.granted;
        let gap = seen.energy.value - discrete_energy;
        let mean_cube = subject.cubic_gap(setting.constants(), seen.rule, seen.mean_cube, n);
        let ceiling = subject.theorem_a_minimum_gap(setting, seen.rule, n);
        let first_order = subject.theorem_a_polyline_gap(setting, seen.rule, n);
        let [by_cube, of_minimum, of_polyline, from_below] = self.sharper;
        begin_in_the_paper(statement, subject, seen, rule)
            .assumed(GLOBAL)
            .stated(self.polyline.0, Unit::ENERGY, [gap, self.polyline.1], granted)
            .stated(self.minimum.0, Unit::ENERGY, [discrete_energy - d2, self.minimum.1], granted)
            .stated("d² ≤ E(γᵖˡ)", Unit::ENERGY, [d2 - seen.energy.value, 0.0], granted)
            .sharper(by_cube, Unit::ENERGY, [gap, mean_cube], granted)
            .sharper(of_minimum, Unit::ENERGY, [discrete_energy - d2, ceiling], granted)
            .sharper(of_polyline, Unit::ENERGY, [gap, first_order], granted)
            .sharper(from_below, Unit::ENERGY, [d2 - discrete_energy, first_order], granted)
    }
}

/// Evaluates Theorem 1.4 on a computed minimiser of the left-endpoint rule.
///
/// ```text
/// 0  ≤  L(γᵖˡ)² − d²  ≤  C/√N      with the C of Theorem 1.3
/// ```
///
/// Companion: `L(γᵖˡ)² − d²` is of order `1/N` ([`tautline::bounds::theorem_a_excess`]).
#[doc(alias = "theo:approx_numerical_integral_left_length")]
#[must_use]
pub fn theorem_1_4<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let constant = subject.theorem_1_3_constant(seen.setting);
    length_excess(Statement::Theorem1_4, subject, seen, PaperRule::LeftEndpoint, constant)
}

/// The common claims of Theorems 1.2 and 1.4.
fn length_excess<const D: usize>(
    statement: Statement,
    subject: &Subject,
    seen: &Reconstruction<D>,
    rule: PaperRule,
    constant: f64,
) -> Evidence {
    let (length2, d2) = (seen.length_squared.value, seen.distance_squared);
    let bound = constant / (seen.n.get() as f64).sqrt();
    let first_order = subject.theorem_a_excess(seen.setting, seen.rule, seen.n);
    begin_in_the_paper(statement, subject, seen, rule)
        .stated("L(γᵖˡ)² − d² ≤ C/√N", Unit::ENERGY, [length2 - d2, bound], seen.granted)
        .sharper("d² ≤ L(γᵖˡ)²", Unit::ENERGY, [d2 - length2, 0.0], seen.granted)
        .sharper("L(γᵖˡ)² ≤ E(γᵖˡ)", Unit::ENERGY, [length2 - seen.energy.value, 0.0], seen.granted)
        .sharper("L(γᵖˡ)² − d² = O(1/N)", Unit::ENERGY, [length2 - d2, first_order], seen.granted)
}

#[cfg(test)]
mod tests {
    use tautline::{bounds, gallery::Shear};

    use super::{theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4};
    use crate::{Known, LIBRARY, PaperRule, Reconstruction};

    /// The bounds are so large that no case tells one theorem's from another's.
    #[test]
    fn every_claim_has_the_bound_of_its_theorem() {
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let known = Known::between(shear, [0.0, 0.0], [2.0, 3.0]).expect("finite").expect("known");
        let [tra, left] = PaperRule::BOTH
            .map(|rule| Reconstruction::observe(&LIBRARY, &known, rule, 12).expect("a minimum"));
        let setting = known.setting().expect("a distance");
        let of_tra = bounds::theorem_1_1_constant(setting);
        let of_left = bounds::theorem_1_3_constant(setting);
        let [first, second] = [theorem_1_1, theorem_1_2].map(|theorem| theorem(&LIBRARY, &tra));
        let [third, fourth] = [theorem_1_3, theorem_1_4].map(|theorem| theorem(&LIBRARY, &left));
        let (n, root) = (12.0, 12_f64.sqrt());
        for (evidence, claim, bound) in [
            (&first, "E(γᵖˡ) − E_tra,N ≤ C/√N", of_tra / root),
            (&first, "E_tra,N − d² ≤ C/N", of_tra / n),
            (&second, "L(γᵖˡ)² − d² ≤ C/√N", of_tra / root),
            (&third, "E(γᵖˡ) − E_l,N ≤ C/√N", of_left / root),
            (&third, "E_l,N − d² ≤ C/√N", of_left / root),
            (&fourth, "L(γᵖˡ)² − d² ≤ C/√N", of_left / root),
        ] {
            assert_eq!(evidence.conclusion(claim).bound, bound, "{}: {claim}", evidence.statement);
        }
    }
}
