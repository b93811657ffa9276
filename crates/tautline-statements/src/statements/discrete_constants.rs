//! The constants of Theorems 1.1 and 1.3: `K̄_{3,g}`, `K̄_{4,g}` and both `C`, on computed
//! minimisers.
//!
//! What is needed of the minimiser is the premise of Theorems 1.1 to 1.4, an upper bound of its
//! discrete energy; it is a hypothesis here too.

use super::section_1::begin_in_the_paper;
use crate::{Evidence, PaperRule, Reconstruction, Statement, Subject, Unit};

/// Evaluates `K̄_{3,g}` on a computed minimiser of the trapezoidal rule.
///
/// ```text
/// K₃ ≤ K̄_{3,g} = √((d² + C_tra♯)/c₁)
/// ```
///
/// Once as it is, and once as a gap, `c₁K₃² − d² ≤ c₁K̄²_{3,g} − d²`, in which `C_tra♯` is seen.
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
/// Once as it is, and once as a gap, `c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²`.
#[doc(alias = "overline K_{4,g}")]
#[must_use]
pub fn constant_k4_bar<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let bar = subject.k4_bar_g(seen.setting);
    let begun =
        begin_in_the_paper(Statement::ConstantK4Bar, subject, seen, PaperRule::LeftEndpoint);
    speed(begun, seen, bar, ["K₃ ≤ K̄_{4,g}", "c₁K₃² − d² ≤ c₁K̄²_{4,g} − d²"])
}

/// `K₃` of a minimiser against its bound.
fn speed<const D: usize>(
    evidence: Evidence,
    seen: &Reconstruction<D>,
    bar: f64,
    [plain, gap]: [&'static str; 2],
) -> Evidence {
    let (c1, d2) = (seen.setting.constants().c1(), seen.distance_squared);
    // dK₃ = dE/(2 c₁ K₃), where E is what is granted an error; and K₃ = 0 where all points are one.
    let granted = if seen.k3 > 0.0 { 0.5 * seen.granted / (c1 * seen.k3) } else { 0.0 };
    let [observed, bound] = [seen.k3, bar].map(|k| c1 * k * k - d2);
    // K̄ is a square root of a sum, squared again: a few roundings of the bound.
    let rounding = seen.granted + 8.0 * f64::EPSILON * (bound + 2.0 * d2);
    evidence.stated(plain, Unit::COORDINATE, [seen.k3, bar], granted).stated(
        gap,
        Unit::ENERGY,
        [observed, bound],
        rounding,
    )
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
    let (setting, n) = (seen.setting, seen.n);
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    let sharp = subject.c_tra_sharp(setting.constants(), k1, k2);
    let cube = setting.constants().l_h() * subject.k3_bar_g(setting).powi(3);
    let total = Excess {
        by_parts: subject.theorem_1_1_excess(setting, n),
        constant: subject.theorem_1_1_constant(setting),
        sum: sharp + 0.25 * cube,
        first_order: subject.theorem_a_excess(setting, PaperRule::Trapezoidal, n),
    };
    let begun = begin_in_the_paper(Statement::ConstantC1_1, subject, seen, PaperRule::Trapezoidal);
    total.conclude(begun, seen)
}

/// Evaluates the constant `C` of Theorems 1.3 and 1.4 on a computed minimiser of the left-endpoint
/// rule.
///
/// ```text
/// E(γᵖˡ) − d²  ≤  C_tra♯/N + L_H (K̄_{3,g}³ + K̄_{4,g}³)/(2√N)  ≤  C/√N
/// C  =  C_tra♯ + L_H (K̄_{3,g}³ + K̄_{4,g}³)/2
/// ```
///
/// The other two gaps which it bounds are those of Theorem 1.3. Companion: the excess is of order
/// `1/N`.
#[doc(alias = "C (Theorem 1.3)")]
#[must_use]
pub fn constant_c_1_3<const D: usize>(subject: &Subject, seen: &Reconstruction<D>) -> Evidence {
    let (setting, n) = (seen.setting, seen.n);
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    let sharp = subject.c_tra_sharp(setting.constants(), k1, k2);
    let cubes = subject.k3_bar_g(setting).powi(3) + subject.k4_bar_g(setting).powi(3);
    let total = Excess {
        by_parts: subject.theorem_1_3_excess(setting, n),
        constant: subject.theorem_1_3_constant(setting),
        sum: sharp + 0.5 * setting.constants().l_h() * cubes,
        first_order: subject.theorem_a_excess(setting, PaperRule::LeftEndpoint, n),
    };
    let begun = begin_in_the_paper(Statement::ConstantC1_3, subject, seen, PaperRule::LeftEndpoint);
    total.conclude(begun, seen)
}

/// The bounds of `E(γᵖˡ) − d²`, in `m²`.
struct Excess {
    /// As the proof has it, part by part.
    by_parts: f64,
    /// `C`.
    constant: f64,
    /// `C` by its formula, from the constants of which it is made.
    sum: f64,
    first_order: f64,
}

impl Excess {
    fn conclude<const D: usize>(self, evidence: Evidence, seen: &Reconstruction<D>) -> Evidence {
        let excess = seen.energy.value - seen.distance_squared;
        let bound = self.constant / (seen.n.get() as f64).sqrt();
        // C is a product of cubes of sums of cubes: some 40 roundings, and powers up to 9.
        let rounding = 1e-13 * self.constant;
        evidence
            .stated("E(γᵖˡ) − d² ≤ by parts", Unit::ENERGY, [excess, self.by_parts], seen.granted)
            .sharper("by parts ≤ C/√N", Unit::ENERGY, [self.by_parts, bound], rounding)
            .identity(
                ["C ≤ the sum of its parts", "the sum of its parts ≤ C"],
                Unit::ENERGY,
                [self.constant, self.sum],
                rounding,
            )
            .sharper("E(γᵖˡ) − d² = O(1/N)", Unit::ENERGY, [excess, self.first_order], seen.granted)
    }
}
