//! The errata: what is false as printed, each with a witness and its two numbers.

use std::num::NonZeroUsize;

use nalgebra::{SMatrix, SVector};
use tautline::gallery::Constant;

use crate::{
    Evidence, Finding, Inequality, Known, LIBRARY, Source, Statement, VerifyError,
    curves::{Clock, Geodesic, KinkedCurve, Measured, Pace, Reparametrised, SmoothCurve},
    statements::{
        TwoForms, prop_7_2_as_printed, prop_7_3_as_printed, prop_7_4, prop_7_5_as_printed,
        prop_7_6_as_printed, prop_7_7, prop_9_1_as_printed,
    },
    witnesses::{Polygonal, tent},
};

/// A statement that is false as printed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Erratum {
    /// The statement; its verdict has the repair.
    pub statement: Statement,
    /// The smallest witness that we know, in words.
    pub witness: &'static str,
    /// The inequality of the printed form that it violates: observed above bound.
    pub violated: Inequality,
    /// Who relies on the statement, and whether it matters there.
    pub relied_on_by: &'static str,
}

/// Returns all errata in the paper's order, with their witnesses evaluated.
///
/// # Errors
///
/// [`VerifyError::NotRefuted`] if a witness does not refute, which a correct build does not return.
pub fn errata() -> Result<Vec<Erratum>, VerifyError> {
    let one = NonZeroUsize::MIN;
    let still = SmoothCurve::polynomial([SVector::from([1.0])]);
    let line = SmoothCurve::straight([0.0], [1.0]);
    let modulus = KinkedCurve::new([0.5], [(0.5, [0.0].into())], [0.5])?;
    let flat = Constant::<1>::new(SMatrix::from_diagonal_element(1.0))?;
    let erratum = |evidence: Evidence, witness, relied_on_by| -> Result<Erratum, VerifyError> {
        // That there is no kink is a hypothesis of the repaired form; the printed one has it not.
        let evidence = evidence.without("γ̇ does not jump");
        let statement = evidence.statement;
        match evidence.finding() {
            Finding::Violated(&violated) if violated.source == Source::Stated => {
                Ok(Erratum { statement, witness, violated, relied_on_by })
            }
            _ => Err(VerifyError::NotRefuted { statement }),
        }
    };
    Ok(vec![
        erratum(
            prop_7_2_as_printed(&still, [0.0, 0.125, 0.25])?,
            "the constant curve γ = 1 on [0, 1/4], where ‖γ‖ = 1/2 and ‖γ̇‖ = 0",
            "Proposition 7.3, and Proposition 7.6 on [0, 1], where it holds",
        )?,
        erratum(
            prop_7_3_as_printed(&line, [0.0, 0.25])?,
            "γ(t) = t on [0, 1/4]",
            "Proposition 7.6, which needs it on [0, 1] only",
        )?,
        erratum(
            prop_7_4(&modulus, one, 0, 0.0)?,
            "γ(t) = |t − 1/2| with N = 1: β = 0, γ̇(0) = −1, and γ̈ = 0 but for the kink",
            "Proposition 7.6; Theorem 1.1 applies both to geodesics, which are smooth",
        )?,
        erratum(
            prop_7_5_as_printed(&TwoForms {
                points: [SVector::from([0.0]); 2],
                vectors: [SVector::from([0.0]), SVector::from([1.0])],
                matrices: [SMatrix::from_diagonal_element(-2.0); 2],
                c2: 1.0,
                l_h: 0.0,
            }),
            "D = 1, H = −2 ≤ c₂ = 1, u₁ = 0 and u₂ = 1",
            "Proposition 7.6, where H is a metric and so positive",
        )?,
        erratum(
            prop_7_6_as_printed(&LIBRARY, &flat, &modulus, [1.0, 0.1], one)?,
            "γ(t) = |t − 1/2| with H = 1, N = 1, K₁ = 1 and K₂ = 1/10: E = 1 and E_tra,N = 0",
            "Proposition 7.7 and Theorem 1.1, for minimal geodesics, which are smooth",
        )?,
        erratum(
            prop_7_7(&LIBRARY, &ridge()?, &[fast_start(17)?], seventeen())?,
            "from 0 to 1 in the time 1/N over a ridge, then at rest; any N ≥ 17, here 17",
            "Theorem 1.1, for minimal geodesics, which are smooth",
        )?,
        erratum(
            late_minimiser()?,
            "H = 1 from 0 to 1, γ* = t² and γ = t: both have the least length",
            "Theorems 1.2 and 1.4, where γ* is a minimal geodesic",
        )?,
    ])
}

fn seventeen() -> NonZeroUsize {
    NonZeroUsize::new(17).unwrap_or(NonZeroUsize::MIN)
}

/// `H = 2 − 3/2 |x − ½|` on `[0, 1]`.
fn ridge() -> Result<Polygonal, VerifyError> {
    let slope = -1.5;
    let range = VerifyError::OutOfRange { name: "slope", value: slope, low: -4.0, high: 4.0 };
    tent(2.0, slope).ok_or(range)
}

/// From 0 to 1 in the time `1/n`, then at rest.
fn fast_start(n: u32) -> Result<KinkedCurve<1>, VerifyError> {
    KinkedCurve::new([0.0], [(1.0 / f64::from(n), SVector::from([1.0]))], [1.0])
}

fn late_minimiser() -> Result<Evidence, VerifyError> {
    let metric = Constant::<1>::new(SMatrix::from_diagonal_element(1.0))?;
    let ends = [SVector::from([0.0]), SVector::from([1.0])];
    let on_time = Geodesic::between(metric, ends);
    let clock = Clock::plain(Pace::Accelerating);
    let late = Reparametrised { curve: &on_time, clock: &clock };
    let known = Known::joined(metric, ends)?
        .ok_or(VerifyError::NotRefuted { statement: Statement::Proposition9_1 })?;
    let [on_time, late] = [Measured::of(&metric, &on_time), Measured::of(&metric, &late)];
    Ok(prop_9_1_as_printed(&LIBRARY, &known, &on_time, &late))
}

#[cfg(test)]
mod tests {
    use super::errata;
    use crate::{Statement, Verdict};

    /// The statements whose verdict is that they are refuted, and no others.
    #[test]
    fn every_refuted_statement_has_its_erratum() {
        let refuted =
            |statement: &Statement| matches!(statement.verdict(), Verdict::RefutedRepairedAs(_));
        let statements: Vec<Statement> = Statement::ALL.into_iter().filter(refuted).collect();
        let errata = errata().expect("every witness refutes");
        assert!(errata.iter().map(|erratum| erratum.statement).eq(statements));
        for erratum in errata {
            assert!(!erratum.violated.holds(), "{}", erratum.violated);
        }
    }
}
