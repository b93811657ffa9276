//! The constants `K̄_{3,g}`, `K̄_{4,g}` and `C` of Theorems 1.1 and 1.3, on computed minimisers.
//!
//! As for Theorems 1.1 to 1.4, the hypothesis is an upper bound on the discrete energy.

use super::section_1::begin_in_the_paper;
use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// Evaluates `K̄_{3,g}` on a computed minimiser of the trapezoidal rule.
///
/// ```text
/// K₃ ≤ K̄_{3,g} = √((d² + C_tra♯)/c₁)
/// ```
///
/// The bound is compared as it is, and as a gap `c₁K₃² − d² ≤ c₁K̄²_{3,g} − d²`, in which `C_tra♯`
/// shows.
#[doc(alias = "overline K_{3,g}")]
#[must_use]
pub fn constant_k3_bar<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let bar = subject.k3_bar_g(seen.setting);
    let begun = begin_in_the_paper(Statement::ConstantK3Bar, subject, seen, PaperRule::Trapezoidal);
    speed(begun, seen, bar, ["K₃ ≤ K̄_{3,g}", "c₁K₃² − d² ≤ c₁K̄²_{3,g} − d²"])
}

/// Evaluates `K̄_{4,g}` on a computed minimiser of the left-endpoint rule.
///
/// ```text
/// K₃ ≤ K̄_{4,g} = √((d² + C_tra♯ + ½ L_H K̄_{3,g}³)/c₁)
/// ```
///
/// The bound is compared as it is, and as a gap `c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²`.
#[doc(alias = "overline K_{4,g}")]
#[must_use]
pub fn constant_k4_bar<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let bar = subject.k4_bar_g(seen.setting);
    let begun =
        begin_in_the_paper(Statement::ConstantK4Bar, subject, seen, PaperRule::LeftEndpoint);
    speed(begun, seen, bar, ["K₃ ≤ K̄_{4,g}", "c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²"])
}

/// Compares `K₃` of a minimiser with its bound.
fn speed<const D: usize>(
    evidence: Evidence,
    seen: &Reconstruction<D>,
    bar: f64,
    [plain, gap]: [&'static str; 2],
) -> Evidence {
    let (c1, d2) = (seen.setting.constants().c1(), seen.distance_squared);
    // An error dE of the energy changes K₃ by dE/(2 c₁ K₃). K₃ = 0 if all points coincide.
    let granted = if seen.k3 > 0.0 { 0.5 * seen.granted / (c1 * seen.k3) } else { 0.0 };
    let [observed, bound] = [seen.k3, bar].map(|k| c1 * k * k - d2);
    // K̄ is the square root of a sum and is squared again, with a few roundings of the bound.
    let rounding = seen.granted + 8.0 * f64::EPSILON * (bound + 2.0 * d2);
    let evidence = evidence.stated(plain, Unit::COORDINATE, [seen.k3, bar], granted);
    evidence.stated(gap, Unit::ENERGY, [observed, bound], rounding)
}

/// Evaluates the constant `C` of Theorems 1.1 and 1.2 on a computed minimiser of the trapezoidal
/// rule.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  C_tra♯/N + L_H K̄_{3,g}³/(4√N)  ≤  C/√N,      C = C_tra♯ + L_H K̄_{3,g}³/4
/// ```
///
/// Companion: the excess is of order `1/N`.
#[doc(alias = "C (Theorem 1.1)")]
#[must_use]
pub fn constant_c_1_1<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let setting = seen.setting;
    let cube = setting.constants().l_h() * subject.k3_bar_g(setting).powi(3);
    let excess = Excess {
        by_parts: subject.theorem_1_1_excess(setting, seen.n),
        constant: subject.theorem_1_1_constant(setting),
        cubes: 0.25 * cube,
    };
    excess.conclude(Statement::ConstantC1_1, subject, seen, PaperRule::Trapezoidal)
}

/// Evaluates the constant `C` of Theorems 1.3 and 1.4 on a computed minimiser of the left-endpoint
/// rule.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  C_tra♯/N + L_H (K̄_{3,g}³ + K̄_{4,g}³)/(2√N)  ≤  C/√N
/// C  =  C_tra♯ + L_H (K̄_{3,g}³ + K̄_{4,g}³)/2
/// ```
///
/// The other two gaps that `C` bounds are in Theorem 1.3. Companion: the excess is of order `1/N`.
#[doc(alias = "C (Theorem 1.3)")]
#[must_use]
pub fn constant_c_1_3<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let setting = seen.setting;
    let cubes = subject.k3_bar_g(setting).powi(3) + subject.k4_bar_g(setting).powi(3);
    let excess = Excess {
        by_parts: subject.theorem_1_3_excess(setting, seen.n),
        constant: subject.theorem_1_3_constant(setting),
        cubes: 0.5 * setting.constants().l_h() * cubes,
    };
    excess.conclude(Statement::ConstantC1_3, subject, seen, PaperRule::LeftEndpoint)
}

/// The bounds on `E(γᵖˡ) − d²`, in `m²`.
struct Excess {
    /// The bound of the proof, part by part.
    by_parts: f64,
    /// `C`.
    constant: f64,
    /// The terms of `C` after `C_tra♯`, computed from their formula.
    cubes: f64,
}

impl Excess {
    fn conclude<const D: usize>(
        self,
        statement: Statement,
        subject: &Subject,
        seen: &Reconstruction<D>,
        rule: PaperRule,
    ) -> Evidence {
        let (setting, excess) = (seen.setting, seen.energy.value - seen.distance_squared);
        let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
        let sum = subject.c_tra_sharp(setting.constants(), k1, k2) + self.cubes;
        let first_order = subject.theorem_a_excess(setting, rule, seen.n);
        let bound = self.constant / (seen.n.get() as f64).sqrt();
        // C contains cubes of sums of cubes. It has some 40 roundings, and powers up to 9.
        let rounding = 1e-13 * self.constant;
        let definition = ["C ≤ the sum of its parts", "the sum of its parts ≤ C"];
        begin_in_the_paper(statement, subject, seen, rule)
            .stated("E(γᵖˡ) − d² ≤ by parts", Unit::ENERGY, [excess, self.by_parts], seen.granted)
            .sharper("by parts ≤ C/√N", Unit::ENERGY, [self.by_parts, bound], rounding)
            .identity(definition, Unit::ENERGY, [self.constant, sum], rounding)
            .sharper("E(γᵖˡ) − d² = O(1/N)", Unit::ENERGY, [excess, first_order], seen.granted)
    }
}
