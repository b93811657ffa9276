//! What the theorems compare, as computed for one problem, one rule and one `N`.

use std::num::NonZeroUsize;

use proptest::prelude::*;
use tautline::{
    Bounded, Curvature, Integral, Problem, Rule, SVector, Stop, TautLine, bounds::Setting,
};

use crate::{
    families::Known,
    random::{Verdict, at_most},
};

/// The numbers of one solve, with the setting by which the theorems know the problem.
pub(super) struct Observed {
    pub(super) setting: Setting,
    pub(super) n: NonZeroUsize,
    /// `min E = min L² = d²`.
    pub(super) d2: f64,
    /// `E_N(γᵖ)`.
    pub(super) discrete: f64,
    /// `E(γᵖˡ)`.
    pub(super) energy: Integral,
    /// `L(γᵖˡ)²`, with its error.
    pub(super) length2: Integral,
}

impl Observed {
    /// Solves, and checks that the search converged and that the ends lie in their sets.
    pub(super) fn new<M: Bounded<D> + Clone, const D: usize>(
        known: &Known<M, D>,
        rule: impl Rule,
        n: usize,
    ) -> Result<Self, TestCaseError> {
        let fail = |error: &dyn std::error::Error| TestCaseError::fail(error.to_string());
        let setting = Setting::new(known.metric.constants(), known.distance, D)
            .map_err(|error| fail(&error))?;
        let problem = Problem::new(known.metric.clone(), known.ends.clone());
        let line = problem.solve(rule, n).map_err(|error| fail(&error))?;
        let minimum = line.minimum();
        prop_assert_eq!(minimum.stop, Stop::Converged);
        // Degenerate is allowed: where a curve leaves a ball, it may be free to move sideways.
        let saddle = matches!(minimum.curvature, Curvature::Indefinite { .. });
        prop_assert!(!saddle, "a saddle: {:?}", minimum.curvature);
        prop_assert_eq!(line.sequence().n().get(), n);
        ends_lie_in_their_sets(&line, known)?;
        let length = line.length();
        Ok(Self {
            setting,
            n: NonZeroUsize::new(n).expect("a point sequence has N ≥ 1"),
            d2: known.distance.powi(2),
            discrete: line.discrete_energy(),
            energy: line.energy(),
            length2: Integral {
                value: length.value.powi(2),
                error: 2.0 * length.value * length.error,
            },
        })
    }

    /// `left ≤ right` up to rounding and to the errors of the integrals that occur.
    ///
    /// Rounding: `d` is a difference of two numbers up to 20 with some 4 roundings each, 2e-14 in
    /// all, and at least 0.03, so `d²` has a relative error below 2e-12; energies are compensated
    /// sums of terms with some ten roundings each, relative to themselves.
    pub(super) fn at_most(&self, inequality: &str, left: f64, right: f64) -> Verdict {
        let magnitude = self.d2 + self.discrete + self.energy.value;
        let slack = 2e-12 * magnitude + self.energy.error + self.length2.error;
        at_most(&format!("{inequality} at N = {}", self.n), left, right, slack)
    }
}

/// The ends are not relaxed: projecting them once more moves them by rounding at most.
fn ends_lie_in_their_sets<M: Bounded<D>, R: Rule, const D: usize>(
    line: &TautLine<M, R, D>,
    known: &Known<M, D>,
) -> Verdict {
    let sequence = line.sequence();
    for (name, set, x) in [
        ("first", known.ends.first(), sequence.first()),
        ("last", known.ends.second(), sequence.last()),
    ] {
        let off: SVector<f64, D> = set.project(x) - x;
        // Coordinates and radii up to 20, a projection of at most 4 D roundings.
        prop_assert!(
            off.amax() <= 1e-13,
            "the {name} point {x} is outside of its set by {:e}",
            off.amax()
        );
    }
    Ok(())
}
