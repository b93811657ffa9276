//! The theorems with a distance that a certificate proves, for a metric that knows none.

use std::{any::Any, ops::ControlFlow};

use nalgebra::SVector;
use tautline::{Ends, Formula, Problem, Rule, distance::Wanted};
use tautline_statements::{Evidence, Known, LIBRARY, PaperRule, Reconstruction, VerifyError};

use super::{Case, formula::on_winding, problems::Posed, statements::judge_all};
use crate::report::{LawResult, Tried};

/// The gap that is asked for, relative to the distance: less than the errors of few chords.
const GAP: f64 = 1e-3;

/// The most cubes of a certificate: a tenth of a second.
const CUBES: usize = 10_000;

/// The number of chords of the curve of a certificate.
const CHORDS: usize = 128;

/// Two points, and two bounds on their distance, in `m`.
#[derive(Clone, Copy, Debug)]
pub(super) struct ProvedDistance<const D: usize> {
    posed: Posed<D>,
    bounds: [f64; 2],
}

impl<const D: usize> Case<'_, D> {
    /// Checks statements on the minimisers between two points, with every distance that a certificate
    /// leaves possible: a case fails if it fails for all of them. What they hide cannot fail. A metric
    /// that knows its distances needs none, and none is searched for in more than two dimensions,
    /// where it takes seconds.
    pub(super) fn of_proved(
        &self,
        rule: PaperRule,
        law: &dyn Fn(&Reconstruction<D>) -> Vec<Evidence>,
    ) -> LawResult {
        self.solvable()?;
        let Some(proved) = self.solved.proved.get_or_init(|| self.prove()) else {
            return Ok(Tried::cases(0));
        };
        let mut tried = Tried::cases(0);
        for &n in self.effort.subintervals {
            let seen = match self.seen_between(proved, rule, n) {
                Ok(seen) => seen,
                Err(VerifyError::NotConverged { .. }) => continue,
                Err(error) => return Err(self.effort.failure(error)),
            };
            let margin = judge_all(law(&seen)).map_err(|fault| self.effort.failure(fault))?;
            let (idle, overestimation) = (u64::from(margin.is_idle()), margin.overestimation);
            let one = Tried { idle, assumed: margin.assumed, ..Tried::cases(1) };
            let overestimation = if idle == 0 { overestimation } else { f64::INFINITY };
            tried = tried.and(Tried { overestimation, ..one });
        }
        Ok(tried)
    }

    /// Returns the minimiser with `n` subintervals. The bounds of the theorems grow with the distance,
    /// so that they are computed with its upper bound; half the width of the interval of `d²` is
    /// granted about its middle.
    fn seen_between(
        &self,
        &ProvedDistance { posed, bounds: [lower, upper] }: &ProvedDistance<D>,
        rule: PaperRule,
        n: usize,
    ) -> Result<Reconstruction<D>, VerifyError> {
        let (metric, ends) = (&self.metric, posed.ends()?);
        let known = Known { metric, ends, distance: upper, distance_error: 0.0 };
        let mut seen = Reconstruction::observe(&LIBRARY, &known, rule, n)?;
        let [least, most] = [lower * lower, upper * upper];
        seen.distance_squared = 0.5 * (least + most);
        // This allows for the rounding of the squares.
        seen.granted += 0.5 * (most - least) + 4.0 * f64::EPSILON * most;
        Ok(seen)
    }

    /// Proves the distance between two points of the region.
    fn prove(&self) -> Option<ProvedDistance<D>> {
        if self.distance.is_some() {
            return None;
        }
        let points = [1, 2].map(|k| on_winding(&self.ends, k));
        let formula: &dyn Any = self.metric.metric.formula().ok()?;
        let ends: &dyn Any = &points;
        // These are compiled with the kit, and not with the tests of each metric.
        let bounds = if let Some(formula) = formula.downcast_ref() {
            on_a_line(formula, ends.downcast_ref()?)
        } else if let Some(formula) = formula.downcast_ref() {
            in_the_plane(formula, ends.downcast_ref()?)
        } else {
            None
        };
        let [a, b] = points;
        Some(ProvedDistance { posed: Posed::between(a, b), bounds: bounds? })
    }
}

fn on_a_line(formula: &Formula<1>, points: &[SVector<f64, 1>; 2]) -> Option<[f64; 2]> {
    proved(formula, points)
}

fn in_the_plane(formula: &Formula<2>, points: &[SVector<f64, 2>; 2]) -> Option<[f64; 2]> {
    proved(formula, points)
}

/// Returns two bounds on the distance that a certificate proves.
fn proved<const D: usize>(
    formula: &Formula<D>,
    &[a, b]: &[SVector<f64, D>; 2],
) -> Option<[f64; 2]> {
    let problem = Problem::new(formula.clone(), Ends::points(a, b).ok()?);
    let line = problem.solve(Rule::TRAPEZOIDAL, CHORDS).ok()?;
    let wanted = Wanted { gap: GAP, cubes: CUBES };
    let found = line.certificate_with(wanted, &mut |_| ControlFlow::Continue(())).ok()?;
    Some([found.proved.lower, found.proved.upper?])
}

#[cfg(test)]
mod tests {
    use tautline::{
        KnownDistance,
        bounds::Setting,
        gallery::{Bump, Shear},
    };
    use tautline_statements::{
        Bounds, LIBRARY, PaperRule, Reconstruction, Subject, lemma_s_4, theorem_1_2, theorem_a,
    };

    use crate::{Effort, Fault, Region, metric::case::Case, report::LawResult};

    fn effort() -> Effort {
        Effort { problems: 6, subintervals: &[1, 2, 3, 8], ..Effort::default() }
    }

    fn region() -> Region<2> {
        Region::cell([0.0, 0.0], [6.0, 6.0])
    }

    #[track_caller]
    fn violated(result: LawResult) -> &'static str {
        match result.expect_err("it is wrong").fault {
            Fault::Statement { hypothesis: false, inequality, .. } => inequality.claim,
            fault => panic!("{fault}"),
        }
    }

    /// The interval contains the distance that the metric knows, and is narrow.
    #[test]
    fn the_distance_is_between_the_bounds() {
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let case = Case::new(&shear, region(), effort());
        let proved = case.prove().expect("a certificate");
        let [a, b] = proved.posed.points().expect("two points");
        let d = shear.distance(&a, &b).expect("known");
        let [lower, upper] = proved.bounds;
        assert!(lower <= d && d <= upper && upper - lower < 2e-2 * d, "{lower} {d} {upper}");
        // A metric that knows its distances needs no proof.
        let knows = Case { distance: Some(Box::new(|_, _| Some(1.0))), ..case };
        assert!(knows.prove().is_none());
    }

    #[test]
    fn the_theorems_hold_with_a_proved_distance_and_could_fail() {
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let case = Case::new(&shear, region(), effort());
        let rule = PaperRule::Trapezoidal;
        let law = |seen: &_| vec![theorem_1_2(&LIBRARY, seen), theorem_a(&LIBRARY, seen)];
        let tried = case.of_proved(rule, &law).expect("it holds");
        assert!(tried.cases == 4 && tried.idle <= 1, "{tried:?}");
    }

    /// A bound that is too small, and a discrete energy that is too large by a fifth are
    /// refused, whatever the distance is in the interval.
    #[test]
    fn wrong_variants_are_refused() {
        let rule = PaperRule::Trapezoidal;
        let shear = Shear::new(0.5, 1.0).expect("a wave number");
        let case = Case::new(&shear, region(), effort());
        let small = Subject::with(Bounds { theorem_1_1_constant: |_| 1e-3, ..Bounds::LIBRARY });
        let wrong = violated(case.of_proved(rule, &|seen| vec![theorem_1_2(&small, seen)]));
        assert_eq!(wrong, "L(γᵖˡ)² − d² ≤ C/√N");
        let wrong = violated(case.of_proved(rule, &|seen| {
            let discrete_energy = 1.2 * seen.discrete_energy;
            vec![lemma_s_4(&LIBRARY, &Reconstruction { discrete_energy, ..seen.clone() })]
        }));
        assert!(wrong.contains("d²"), "{wrong}");
    }

    /// An understated `L_H` is refused by the hypothesis of the theorem, and with the true one the
    /// theorem holds on a hill with two ways around it.
    #[test]
    fn an_understated_constant_is_refused() {
        let rule = PaperRule::Trapezoidal;
        let bump = Bump::new(4.0, 0.5).expect("a bump");
        let case = Case::new(&bump, Region::cell([-1.5, -1.5], [1.5, 1.5]), effort());
        assert!(case.of_proved(rule, &|seen| vec![theorem_a(&LIBRARY, seen)]).is_ok());
        let understated = case.of_proved(rule, &|seen| {
            let constants = seen.setting.constants().times([1.0, 1.0, 0.01, 1.0]);
            let setting = Setting::new(constants.expect("constants"), seen.setting.distance(), 2);
            let setting = setting.expect("a distance");
            vec![theorem_a(&LIBRARY, &Reconstruction { setting, ..seen.clone() })]
        });
        let fault = understated.expect_err("it is wrong").fault;
        assert!(matches!(fault, Fault::Statement { hypothesis: true, .. }), "{fault}");
    }
}
