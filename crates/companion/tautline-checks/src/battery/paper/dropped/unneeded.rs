//! Hypotheses on `H` that Propositions 7.6, 7.7, 7.9, 8.1 and 8.2 do not need.
//!
//! `c₁` and `c₂` do not occur in the bounds of Propositions 7.9, 8.1 and 8.2, nor in their proofs,
//! which compare `H` at two points of a chord. `C_tra(N)` does not contain `c₁`. By Jensen's
//! inequality, its terms with `c₂` are not needed for the upper bound, Proposition 7.7.

use std::num::NonZeroUsize;

use tautline::{Constants, PointSequence};
use tautline_statements::{
    LIBRARY,
    Statement::{
        self, Proposition7_6, Proposition7_7, Proposition7_9, Proposition8_1, Proposition8_2,
    },
    VerifyError, WithConstants,
    curves::SmoothCurve,
    prop_7_6, prop_7_7,
    witnesses::Incline,
};

use crate::battery::{
    cases::clauses::{ABOVE, BELOW},
    harness::{Check, Dropped, Outcome, Trial, all, holds_without},
    paper::point_sequences,
};

const SAMPLED: &[Statement] = &[Proposition7_6, Proposition7_7];
const SEQUENCES: &[Statement] = &[Proposition7_9, Proposition8_1, Proposition8_2];

pub(crate) const CHECKS: &[Check] = &[
    Dropped.check("prop_7_6_does_not_need_c1_nor_prop_7_7_c2", SAMPLED, curves),
    Dropped.check("props_7_9_8_1_and_8_2_need_neither_c1_nor_c2", SEQUENCES, sequences),
];

/// Returns `H = 1 + x` twice: with claimed bounds above 2, and with claimed bounds below 1.
fn inclines() -> Result<[(&'static str, WithConstants<Incline>); 2], VerifyError> {
    let metric = Incline::new(1.0, 1.0).expect("positive");
    let claimed = |c1, c2| -> Result<_, VerifyError> {
        Ok(WithConstants { metric, constants: Constants::new(c1, c2, 1.0)? })
    };
    Ok([(BELOW, claimed(3.0, 4.0)?), (ABOVE, claimed(0.25, 0.5)?)])
}

/// The sequence takes one step up the incline and three steps back, as in the witnesses, with small
/// numbers.
fn sequences(_: &Trial<'_>) -> Outcome {
    let points = [[0.0], [1.0], [0.8], [0.3], [0.0]].map(Into::into).to_vec();
    let sequence = PointSequence::new(points)?;
    for (clause, metric) in inclines()? {
        let evidence = point_sequences::evidence(&LIBRARY, &metric, &sequence)?;
        all(evidence.map(|evidence| holds_without(&[clause], evidence)))?;
    }
    Ok(Default::default())
}

/// The curves are the straight line up the incline and the same line parametrised by `t²`.
fn curves(_: &Trial<'_>) -> Outcome {
    let line = SmoothCurve::straight([0.0], [1.0]);
    let late = SmoothCurve::polynomial([0.0, 0.0, 1.0].map(|x| [x].into()));
    let [(below, overstated), (above, understated)] = inclines()?;
    for n in [1, 2, 7].map(|n| NonZeroUsize::new(n).expect("positive")) {
        for curve in [&line, &late] {
            all([
                holds_without(&[below], prop_7_6(&LIBRARY, &overstated, curve, n)?),
                holds_without(&[below], prop_7_7(&LIBRARY, &overstated, &[curve], n)?),
                holds_without(&[above], prop_7_7(&LIBRARY, &understated, &[curve], n)?),
            ])?;
        }
    }
    Ok(Default::default())
}
