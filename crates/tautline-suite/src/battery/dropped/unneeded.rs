//! Hypotheses on `H` that Propositions 7.6, 7.7, 7.9, 8.1 and 8.2 do not need.
//!
//! `c₁` and `c₂` do not occur in the bounds of 7.9, 8.1 and 8.2, nor in their proofs, which compare
//! `H` at two points of a chord. In `C_tra(N)` there is no `c₁`; and by the inequality of Jensen
//! its terms with `c₂` are not needed for the bound from above, which is Proposition 7.7.

use std::num::NonZeroUsize;

use tautline::{Constants, PointSequence};
use tautline_statements::{
    Evidence, LIBRARY, Statement,
    Statement::{Proposition7_6, Proposition7_7, Proposition7_9, Proposition8_1, Proposition8_2},
    VerifyError, WithConstants,
    curves::SmoothCurve,
    prop_7_6, prop_7_7, prop_7_9, prop_8_1, prop_8_2,
    witnesses::Incline,
};

use super::super::{Check, Kind, Outcome, check::all, failing::holds_without};

const SAMPLED: &[Statement] = &[Proposition7_6, Proposition7_7];
const SEQUENCES: &[Statement] = &[Proposition7_9, Proposition8_1, Proposition8_2];
const BELOW: &str = "c₁ ≤ λ_min(H)";
const ABOVE: &str = "λ_max(H) ≤ c₂";

pub(super) fn checks() -> Vec<Check> {
    vec![
        Check::new("prop_7_6_does_not_need_c1_nor_prop_7_7_c2", Kind::Dropped, SAMPLED, |_| {
            curves()
        }),
        Check::new(
            "props_7_9_8_1_and_8_2_need_neither_c1_nor_c2",
            Kind::Dropped,
            SEQUENCES,
            |_| sequences(),
        ),
    ]
}

/// `H = 1 + x` with other bounds claimed for it: above 2, and below 1.
fn inclines() -> Result<[(&'static str, WithConstants<Incline>); 2], VerifyError> {
    let metric = Incline::new(1.0, 1.0).expect("positive");
    let claimed = |c1, c2| -> Result<_, VerifyError> {
        Ok(WithConstants { metric, constants: Constants::new(c1, c2, 1.0)? })
    };
    Ok([(BELOW, claimed(3.0, 4.0)?), (ABOVE, claimed(0.25, 0.5)?)])
}

/// One step up the incline, and back in three: as in the witnesses, with small numbers.
fn sequences() -> Outcome {
    let points = [[0.0], [1.0], [0.8], [0.3], [0.0]].map(Into::into).to_vec();
    let sequence = PointSequence::new(points).map_err(VerifyError::from)?;
    let mut outcomes = Vec::new();
    for (clause, metric) in inclines()? {
        let evidence: [Evidence; 3] = [
            prop_7_9(&LIBRARY, &metric, &sequence).map_err(VerifyError::from)?,
            prop_8_1(&LIBRARY, &metric, &sequence).map_err(VerifyError::from)?,
            prop_8_2(&LIBRARY, &metric, &sequence).map_err(VerifyError::from)?,
        ];
        outcomes.extend(evidence.map(|evidence| holds_without(&[clause], evidence)));
    }
    all(outcomes)
}

/// The straight line up the incline, and the one that goes as `t²`.
fn curves() -> Outcome {
    let line = SmoothCurve::straight([0.0], [1.0]);
    let late = SmoothCurve::polynomial([0.0, 0.0, 1.0].map(|x| [x].into()));
    let [(below, overstated), (above, understated)] = inclines()?;
    let mut outcomes = Vec::new();
    for n in [1, 2, 7].map(|n| NonZeroUsize::new(n).expect("positive")) {
        for curve in [&line, &late] {
            outcomes.extend([
                holds_without(&[below], prop_7_6(&LIBRARY, &overstated, curve, n)?),
                holds_without(&[below], prop_7_7(&LIBRARY, &overstated, &[curve], n)?),
                holds_without(&[above], prop_7_7(&LIBRARY, &understated, &[curve], n)?),
            ]);
        }
    }
    all(outcomes)
}
