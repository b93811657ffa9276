//! `Search`: random sampling, then pattern search on the logarithm of the overestimation.

use tautline_statements::{Evidence, Finding, Inequality, Source, VerifyError};

use super::{AdversaryError, Edge, Family, Tightest, split_mix::SplitMix};

/// The budget and the seed of a search.
///
/// The ascent is the pattern search of Hooke and Jeeves (1961). It tries each parameter a step up
/// and a step down, keeps what is better, and continues in the direction that helped; if no step
/// helped, it halves the step. It needs no derivatives, which a minimum over several conclusions
/// lacks, and no continuity, which is lost at a tie between two minimisers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Search {
    /// The seed of the samples.
    pub seed: u64,
    /// How many times the search samples and then ascends.
    pub restarts: usize,
    /// How many cases are sampled each time. The ascent starts from the best of them.
    pub samples: usize,
    /// How many cases one ascent may evaluate.
    pub climbs: usize,
}

impl Default for Search {
    /// Returns two restarts of 100 samples each and an ascent of up to 400 cases, with the seed
    /// 1961.
    fn default() -> Self {
        Self { seed: 1961, restarts: 2, samples: 100, climbs: 400 }
    }
}

/// The first and the last step of an ascent, relative to each side of the box. If an overestimation
/// varies by a factor of 10⁶ over a side, then it varies by 10⁻³ over the last step.
const STEPS: [f64; 2] = [0.25, 1e-4];

/// The largest relative rounding with which an observed number still counts. Without it, a search
/// for the least overestimation would find the largest rounding error.
const SEEN: f64 = 1e-4;

/// An overestimation counts as better only if it is smaller by at least this fraction. The last
/// bits, which differ between machines, therefore do not steer a search.
const GAIN: f64 = 1e-6;

/// A point of the unit cube with its evidence.
#[derive(Clone)]
struct Place {
    places: Vec<f64>,
    found: Option<(Evidence, Inequality)>,
}

impl Place {
    /// Returns the overestimation; `∞` if there is none.
    fn overestimation(&self) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |(_, conclusion)| conclusion.overestimation())
    }

    /// Returns whether this place is tighter than the other.
    fn beats(&self, other: &Place) -> bool {
        self.overestimation() < (1.0 - GAIN) * other.overestimation()
    }
}

/// Returns the tightest conclusion of this source whose observed number exceeds rounding.
fn tightest(evidence: &Evidence, source: Source) -> Option<Inequality> {
    let of_source = evidence.conclusions.iter().filter(|claim| claim.source == source);
    let seen = of_source.filter(|claim| claim.granted <= SEEN * claim.observed);
    let told = seen.filter(|claim| claim.overestimation() < f64::INFINITY);
    told.min_by(|a, b| a.overestimation().total_cmp(&b.overestimation())).copied()
}

/// A family that is being searched.
struct Hunt<'a, 'f> {
    family: &'a Family<'f>,
    source: Source,
    evaluations: usize,
    told: usize,
}

impl Search {
    /// Returns the tightest case found in a family; `None` if no case has an overestimation.
    /// `source` selects the paper's conclusions or their sharper companions.
    ///
    /// The search is deterministic: for the same family it always returns the same case.
    ///
    /// # Errors
    ///
    /// [`AdversaryError::Violated`] at the first case in which a conclusion of either source fails.
    /// [`AdversaryError::Evaluation`] if a statement could not be evaluated, unless the solver
    /// refused the problem or found no minimum.
    pub fn tightest(
        &self,
        family: &Family<'_>,
        source: Source,
    ) -> Result<Option<Tightest>, AdversaryError> {
        let mut random = SplitMix::new(self.seed);
        let mut hunt = Hunt { family, source, evaluations: 0, told: 0 };
        let mut best: Option<Place> = None;
        for _ in 0..self.restarts {
            let mut start: Option<Place> = None;
            for _ in 0..self.samples {
                let place = hunt.look(family.parameters.iter().map(|_| random.unit()).collect())?;
                keep_the_tighter(&mut start, place);
            }
            if let Some(start) = start.filter(|start| start.overestimation().is_finite()) {
                keep_the_tighter(&mut best, hunt.climb(start, self.climbs)?);
            }
        }
        let Some(Place { places, found: Some((evidence, conclusion)) }) = best else {
            return Ok(None);
        };
        let overestimation = conclusion.overestimation();
        let edges = hunt.edges(&places, overestimation)?;
        let parameters = family.named(&values(family, &places));
        let Hunt { evaluations, told, .. } = hunt;
        Ok(Some(Tightest {
            parameters,
            evidence,
            conclusion,
            overestimation,
            edges,
            evaluations,
            told,
        }))
    }
}

fn keep_the_tighter(best: &mut Option<Place>, place: Place) {
    if best.as_ref().is_none_or(|best| place.beats(best)) {
        *best = Some(place);
    }
}

fn values(family: &Family<'_>, places: &[f64]) -> Vec<f64> {
    family.parameters.iter().zip(places).map(|(parameter, &place)| parameter.at(place)).collect()
}

impl Hunt<'_, '_> {
    /// Evaluates one case.
    fn look(&mut self, places: Vec<f64>) -> Result<Place, AdversaryError> {
        self.evaluations += 1;
        let family = self.family;
        let (statement, name) = (family.statement, family.name);
        let values = values(family, &places);
        let evidence = match family.evidence(&values) {
            Ok(evidence) => evidence,
            Err(VerifyError::NotConverged { .. } | VerifyError::Solve(_)) => None,
            Err(source) => {
                let parameters = family.named(&values);
                return Err(AdversaryError::Evaluation {
                    statement,
                    family: name,
                    parameters,
                    source,
                });
            }
        };
        if let Some(Finding::Violated(failed)) = evidence.as_ref().map(Evidence::finding) {
            return Err(AdversaryError::Violated {
                statement,
                family: name,
                parameters: family.named(&values),
                conclusion: failed.to_string(),
            });
        }
        let found = evidence.filter(|evidence| evidence.finding() == Finding::Holds);
        let found = found.and_then(|evidence| {
            let conclusion = tightest(&evidence, self.source)?;
            Some((evidence, conclusion))
        });
        self.told += usize::from(found.is_some());
        Ok(Place { places, found })
    }

    /// Ascends from a case until the step is small or `budget` cases have been evaluated.
    fn climb(&mut self, mut here: Place, budget: usize) -> Result<Place, AdversaryError> {
        let [mut step, last] = STEPS;
        let end = self.evaluations + budget;
        while step >= last && self.evaluations < end {
            let before = here.places.clone();
            if !self.explore(&mut here, step, end)? {
                step *= 0.5;
                continue;
            }
            // Continue in the direction that helped.
            while self.evaluations < end {
                let steps = here.places.iter().zip(&before).map(|(new, old)| 2.0 * new - old);
                let ahead = self.family.parameters.iter().zip(steps);
                let ahead = ahead.map(|(parameter, place)| parameter.brought_back(place));
                let place = self.look(ahead.collect())?;
                if !place.beats(&here) {
                    break;
                }
                here = place;
            }
        }
        Ok(here)
    }

    /// Returns the parameters that lie at an end of their range, each with what may be left beyond
    /// it.
    fn edges(&mut self, places: &[f64], overestimation: f64) -> Result<Vec<Edge>, AdversaryError> {
        let mut edges = Vec::new();
        for (k, parameter) in self.family.parameters.iter().enumerate() {
            let Some(end) = parameter.end(parameter.at(places[k])) else { continue };
            let mut out = places.to_vec();
            out[k] = parameter.half_way_out(places[k], end);
            // NaN, which counts as cut off, if there is no other case for comparison.
            let moved = out[k] != places[k];
            let left = if moved {
                self.look(out)?.overestimation() / overestimation - 1.0
            } else {
                f64::NAN
            };
            let left = if left < 0.0 { 0.0 } else { left };
            let beyond = parameter.beyond(end);
            edges.push(Edge { parameter: parameter.name, end, beyond, left });
        }
        Ok(edges)
    }

    /// Tries each parameter a step up and a step down and keeps what is better, until `end`
    /// evaluations are reached.
    fn explore(&mut self, here: &mut Place, step: f64, end: usize) -> Result<bool, AdversaryError> {
        let mut improved = false;
        for (k, parameter) in self.family.parameters.iter().enumerate() {
            for step in [step, -step] {
                let mut places = here.places.clone();
                places[k] = parameter.moved(places[k], step);
                if places[k] == here.places[k] || self.evaluations == end {
                    continue;
                }
                let place = self.look(places)?;
                if place.beats(here) {
                    *here = place;
                    improved = true;
                    break;
                }
            }
        }
        Ok(improved)
    }
}

#[cfg(test)]
mod tests {
    use std::cell::RefCell;

    use tautline_statements::{Evidence, Statement, Unit, VerifyError, prop_7_8};

    use super::{
        super::{Beyond, End, Parameter},
        AdversaryError, Family, GAIN, Search, Source, Tightest,
    };

    /// Returns a family with these overestimations.
    fn family<'a, const P: usize>(
        parameters: [Parameter; P],
        overestimation: impl Fn([f64; P]) -> f64 + 'a,
    ) -> Family<'a> {
        Family::new("test", Statement::Proposition7_8, parameters, move |values| {
            let numbers = [1.0, overestimation(values)];
            let evidence = Evidence::of(Statement::Proposition7_8);
            Ok(Some(evidence.stated("1 ≤ overestimation", Unit::NONE, numbers, 0.0)))
        })
    }

    fn unit_square() -> [Parameter; 2] {
        ["x", "y"].map(|name| Parameter::linear(name, 0.0, 1.0))
    }

    fn tightest(family: &Family<'_>) -> Tightest {
        Search::default().tightest(family, Source::Stated).expect("true").expect("told")
    }

    /// For `1, x, y`, `Σ xₙ³ ≤ (Σ xₙ²)^{3/2}` has the overestimation 1 at `x = y = 0`.
    #[test]
    fn the_corner_of_equality_is_found() {
        let parameters = ["x", "y"].map(|name| Parameter::linear(name, 0.0, 3.0));
        let cubes = Family::new("cubes", Statement::Proposition7_8, parameters, |[x, y]| {
            Ok(Some(prop_7_8(&[1.0, x, y])))
        });
        let found = tightest(&cubes);
        assert!(found.overestimation <= 1.000_001, "{found:?}");
        assert_eq!(found.overestimation, found.evidence.overestimation());
        assert_eq!(found.conclusion.claim, "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}");
        assert_eq!(found.parameter("y"), Some(found.parameters[1].1));
        assert!(found.told == found.evaluations && found.parameter("z").is_none());
    }

    /// The budget may end while one parameter moves or while all of them do.
    #[test]
    fn an_ascent_keeps_to_its_budget_and_returns_the_tightest_of_all_cases() {
        for climbs in 0..60 {
            let seen = RefCell::new(Vec::new());
            let bowl = family(unit_square(), |[x, y]| {
                let overestimation = 1.0 + (x - 0.6).powi(2) + (y - 0.3).powi(2);
                seen.borrow_mut().push(overestimation);
                overestimation
            });
            let search = Search { seed: 5, restarts: 1, samples: 3, climbs };
            let found = search.tightest(&bowl, Source::Stated).expect("true").expect("told");
            let seen = seen.borrow();
            assert!(found.edges.is_empty() && found.evaluations == seen.len());
            assert!(seen.len() <= 3 + climbs, "{} for {climbs}", seen.len());
            let least = |seen: &f64| found.overestimation <= seen * (1.0 + GAIN);
            assert!(seen.iter().all(least), "{climbs}");
        }
    }

    /// The overestimation `1 + |x − y| + (y − 0.7)²` has an edge along the diagonal.
    #[test]
    fn a_narrow_minimum_inside_is_found() {
        let edge = family(unit_square(), |[x, y]| 1.0 + (x - y).abs() + (y - 0.7).powi(2));
        assert!(tightest(&edge).overestimation <= 1.01);
    }

    /// On `[10⁻³, 1]`, the overestimation `2 (1 + s x)` has about `10⁻³ s` of its value left on the
    /// way to 0.
    #[test]
    fn a_case_at_an_edge_says_what_is_left_beyond_it() {
        let side = || Parameter::logarithmic("x", 1e-3, 1.0);
        let limit = side().with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
        let linear = Parameter::linear("x", 0.0, 1.0)
            .with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
        let cases = [(limit, 1.0), (limit, 100.0), (side(), 1.0), (limit, -0.5), (linear, 1.0)];
        let [near, far, open, other, unmoved] = cases.map(|(side, s)| {
            let edges = tightest(&family([side], |[x]| 2.0 * (1.0 + s * x))).edges;
            let [edge] = edges.as_slice() else { panic!("{edges:?}") };
            *edge
        });
        // (1 + 2·10⁻³ s)/(1 + 10⁻³ s) − 1. The case may lie a few last steps before the edge.
        assert!((near.left - 1e-3 / 1.001).abs() <= 1e-5 && !near.is_cut_off(), "{near:?}");
        assert!((far.left - 0.1 / 1.1).abs() <= 1e-3 && far.is_cut_off(), "{far:?}");
        assert!(open.is_cut_off() && open.beyond.is_none(), "{open:?}");
        assert_eq!((other.parameter, other.end), ("x", End::Most));
        // Half of 0 is 0, so nothing is measured.
        assert!(unmoved.left.is_nan() && unmoved.is_cut_off(), "{unmoved:?}");
        assert!(!other.is_cut_off(), "{other:?}");
        let inside = family([side()], |[x]| 1.0 + (x / 0.03).ln().powi(2));
        assert_eq!(tightest(&inside).edges, []);
    }

    #[test]
    fn a_violated_conclusion_is_an_error() {
        let side = [Parameter::linear("x", 0.0, 1.0)];
        // The sharper companion fails only for x > ½, and the search minimises the paper's.
        let wrong = Family::new("wrong", Statement::Proposition7_8, side, |[x]| {
            let evidence = Evidence::of(Statement::Proposition7_8);
            let evidence = evidence.stated("x ≤ 2", Unit::NONE, [x, 2.0], 0.0);
            Ok(Some(evidence.sharper("x ≤ ½", Unit::NONE, [x, 0.5], 0.0)))
        });
        let found = Search::default().tightest(&wrong, Source::Stated);
        let Err(AdversaryError::Violated { family: "wrong", parameters, conclusion, .. }) = found
        else {
            panic!("{found:?}");
        };
        assert!(parameters[0].1 > 0.5 && conclusion.starts_with("x ≤ ½"));
    }

    #[test]
    fn cases_without_evidence_are_skipped_and_other_errors_are_not() {
        let side = [Parameter::linear("x", 0.0, 1.0)];
        let none = Family::new("none", Statement::Proposition7_8, side, |[x]| {
            Ok((x < 0.5).then(|| prop_7_8(&[-1.0, x])))
        });
        assert_eq!(Search::default().tightest(&none, Source::Stated), Ok(None));
        let (name, low, high) = ("x", 2.0, 3.0);
        let error = Family::new("error", Statement::Proposition7_8, side, |[value]| {
            Err(VerifyError::OutOfRange { name, value, low, high })
        });
        let found = Search::default().tightest(&error, Source::Stated);
        assert!(matches!(found, Err(AdversaryError::Evaluation { .. })), "{found:?}");
    }
}
