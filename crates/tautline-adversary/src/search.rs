//! `Search`: samples at random, then pattern search, on the logarithm of the overestimation.

use tautline_statements::{Evidence, Finding, Inequality, Source, VerifyError};

use super::{AdversaryError, Edge, Family, Tightest, split_mix::SplitMix};

/// How long a search looks, and from which random numbers.
///
/// The ascent is the pattern search of Hooke and Jeeves (1961): try each parameter a step up and
/// down, keep what is better, go on in the direction that helped; halve the step where nothing
/// does. It needs no derivative, which a minimum over several conclusions does not have, and no
/// continuity, which a tie between two minimisers breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Search {
    /// The seed of the samples.
    pub seed: u64,
    /// How many times samples and ascent are repeated.
    pub restarts: usize,
    /// How many cases are sampled each time; the ascent begins at the best one.
    pub samples: usize,
    /// How many cases an ascent may evaluate.
    pub climbs: usize,
}

impl Default for Search {
    /// Two restarts of 100 samples and an ascent of up to 400 cases, from the seed 1961.
    fn default() -> Self {
        Self { seed: 1961, restarts: 2, samples: 100, climbs: 400 }
    }
}

/// The first step of an ascent, as a part of each side of the box, and the last one:
/// overestimations that vary by a factor of 10⁶ over a side vary by 10⁻³ over the last step.
const STEPS: [f64; 2] = [0.25, 1e-4];

/// What may be granted of an observed number, as a part of it: a search for the least
/// overestimation would find the largest rounding otherwise.
const SEEN: f64 = 1e-4;

/// An overestimation is better where it is less by this part: the last bits, which differ between
/// machines, do not turn a search.
const GAIN: f64 = 1e-6;

/// A point of the unit cube with what was found there.
#[derive(Clone)]
struct Place {
    places: Vec<f64>,
    found: Option<(Evidence, Inequality)>,
}

impl Place {
    /// The overestimation; `∞` where none is told.
    fn overestimation(&self) -> f64 {
        self.found.as_ref().map_or(f64::INFINITY, |(_, conclusion)| conclusion.overestimation())
    }

    /// Whether it is tighter than another one; two without an overestimation are not.
    fn beats(&self, other: &Place) -> bool {
        self.overestimation() < (1.0 - GAIN) * other.overestimation()
    }
}

/// The tightest conclusion of this source of which more than rounding is seen.
fn tightest(evidence: &Evidence, source: Source) -> Option<Inequality> {
    let of_source = evidence.conclusions.iter().filter(|claim| claim.source == source);
    let seen = of_source.filter(|claim| claim.granted <= SEEN * claim.observed);
    let told = seen.filter(|claim| claim.overestimation() < f64::INFINITY);
    told.min_by(|a, b| a.overestimation().total_cmp(&b.overestimation())).copied()
}

/// A family under search.
struct Hunt<'a, 'f> {
    family: &'a Family<'f>,
    source: Source,
    evaluations: usize,
    told: usize,
}

impl Search {
    /// Returns the tightest case that was found of one family, by the least overestimation of the
    /// paper's conclusions or of their sharper companions; `None` if no case tells an
    /// overestimation.
    ///
    /// The same search of the same family returns the same case.
    ///
    /// # Errors
    ///
    /// [`AdversaryError::Violated`] at the first case in which any conclusion fails, of either
    /// source; [`AdversaryError::Evaluation`] where a statement could not be evaluated for another
    /// reason than that the solver refused the problem or found no minimum.
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

    /// Climbs from a case until the step is small or `budget` cases were evaluated.
    fn climb(&mut self, mut here: Place, budget: usize) -> Result<Place, AdversaryError> {
        let [mut step, last] = STEPS;
        let end = self.evaluations + budget;
        while step >= last && self.evaluations < end {
            let before = here.places.clone();
            if !self.explore(&mut here, step, end)? {
                step *= 0.5;
                continue;
            }
            // On in the direction that helped, as long as it does.
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

    /// The parameters that are at an end of their ranges, each with what may be left beyond it.
    fn edges(&mut self, places: &[f64], overestimation: f64) -> Result<Vec<Edge>, AdversaryError> {
        let mut edges = Vec::new();
        for (k, parameter) in self.family.parameters.iter().enumerate() {
            let Some(end) = parameter.end(parameter.at(places[k])) else { continue };
            let mut out = places.to_vec();
            out[k] = parameter.half_way_out(places[k], end);
            // NaN, which is cut off, where there is no other case to compare with.
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

    /// Tries each parameter a step up and down, and keeps what is better, until `end` cases were
    /// evaluated.
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
        AdversaryError, Family, GAIN, Search, Source,
    };

    /// `Σ xₙ³ ≤ (Σ xₙ²)^{3/2}` for `1, x, y` with the overestimation 1 at `x = y = 0`.
    fn cubes<'a>() -> Family<'a> {
        let number = |name| Parameter::linear(name, 0.0, 3.0);
        let parameters = [number("x"), number("y")];
        Family::new("cubes", Statement::Proposition7_8, parameters, |[x, y]| {
            Ok(Some(prop_7_8(&[1.0, x, y])))
        })
    }

    #[test]
    fn the_corner_of_equality_is_found() {
        let found = Search::default().tightest(&cubes(), Source::Stated).expect("true");
        let found = found.expect("told everywhere");
        assert!(found.overestimation <= 1.000_001, "{found:?}");
        assert_eq!(found.overestimation, found.evidence.overestimation());
        assert_eq!(found.conclusion.claim, "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}");
        assert_eq!(found.parameter("y"), Some(found.parameters[1].1));
        assert!(found.told == found.evaluations && found.parameter("z").is_none());
    }

    /// Wherever the budget ends, on the way of one parameter or on that of all.
    #[test]
    fn an_ascent_keeps_to_its_budget_and_returns_the_tightest_of_all_cases() {
        let side = |name| Parameter::linear(name, 0.0, 1.0);
        for climbs in 0..60 {
            let seen = RefCell::new(Vec::new());
            let parameters = [side("x"), side("y")];
            let family = Family::new("bowl", Statement::Proposition7_8, parameters, |[x, y]| {
                let overestimation = 1.0 + (x - 0.6).powi(2) + (y - 0.3).powi(2);
                seen.borrow_mut().push(overestimation);
                let evidence = Evidence::of(Statement::Proposition7_8);
                Ok(Some(evidence.stated(
                    "1 ≤ overestimation",
                    Unit::NONE,
                    [1.0, overestimation],
                    0.0,
                )))
            });
            let search = Search { seed: 5, restarts: 1, samples: 3, climbs };
            let found = search.tightest(&family, Source::Stated).expect("true").expect("told");
            let seen = seen.take();
            assert!(found.edges.is_empty() && found.evaluations == seen.len());
            assert!(seen.len() <= 3 + climbs, "{} for {climbs}", seen.len());
            assert!(
                seen.iter()
                    .all(|overestimation| found.overestimation <= overestimation * (1.0 + GAIN)),
                "{climbs}"
            );
        }
    }

    #[test]
    fn a_narrow_minimum_inside_is_found() {
        // The overestimation 1 + |x − y| + (y − 0.7)² has an edge along the diagonal.
        let side = |name| Parameter::linear(name, 0.0, 1.0);
        let parameters = [side("x"), side("y")];
        let edge = Family::new("edge", Statement::Proposition7_8, parameters, |[x, y]| {
            let overestimation = 1.0 + (x - y).abs() + (y - 0.7).powi(2);
            Ok(Some(Evidence::of(Statement::Proposition7_8).stated(
                "1 ≤ overestimation",
                Unit::NONE,
                [1.0, overestimation],
                0.0,
            )))
        });
        let found = Search::default().tightest(&edge, Source::Stated).expect("true");
        assert!(found.expect("told").overestimation <= 1.01);
    }

    /// The overestimation `2 (1 + s x)` on `[10⁻³, 1]` has the part `10⁻³ s` left on the way to 0.
    #[test]
    fn a_case_at_an_edge_says_what_is_left_beyond_it() {
        let side = || Parameter::logarithmic("x", 1e-3, 1.0);
        let limit = side().with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
        let edges = |side: Parameter, s: f64| {
            let family = Family::new("line", Statement::Proposition7_8, [side], |[x]| {
                let evidence = Evidence::of(Statement::Proposition7_8);
                Ok(Some(evidence.stated("½ ≤ 1 + s x", Unit::NONE, [0.5, 1.0 + s * x], 0.0)))
            });
            let found = Search::default().tightest(&family, Source::Stated).expect("true");
            found.expect("told").edges
        };
        let linear = Parameter::linear("x", 0.0, 1.0)
            .with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
        let cases = [(limit, 1.0), (limit, 100.0), (side(), 1.0), (limit, -0.5), (linear, 1.0)];
        let [near, far, open, other, unmoved] = cases.map(|(side, s)| {
            let found = edges(side, s);
            let [edge] = found.as_slice() else { panic!("{found:?}") };
            *edge
        });
        // (1 + 2·10⁻³ s)/(1 + 10⁻³ s) − 1, at a case that may be some last steps before the edge.
        assert!((near.left - 1e-3 / 1.001).abs() <= 1e-5 && !near.is_cut_off(), "{near:?}");
        assert!((far.left - 0.1 / 1.1).abs() <= 1e-3 && far.is_cut_off(), "{far:?}");
        assert!(open.is_cut_off() && open.beyond.is_none(), "{open:?}");
        assert_eq!((other.parameter, other.end), ("x", End::Most));
        // Half of 0 is 0: nothing is measured.
        assert!(unmoved.left.is_nan() && unmoved.is_cut_off(), "{unmoved:?}");
        assert!(!other.is_cut_off(), "{other:?}");
        let inside = Family::new("valley", Statement::Proposition7_8, [side()], |[x]| {
            let overestimation = 1.0 + (x / 0.03).ln().powi(2);
            let evidence = Evidence::of(Statement::Proposition7_8);
            Ok(Some(evidence.stated("1 ≤ overestimation", Unit::NONE, [1.0, overestimation], 0.0)))
        });
        let found = Search::default().tightest(&inside, Source::Stated).expect("true");
        assert_eq!(found.expect("told").edges, []);
    }

    #[test]
    fn a_violated_conclusion_is_an_error() {
        let side = [Parameter::linear("x", 0.0, 1.0)];
        // The sharper companion fails for x > ½ only, and the search looks at the paper's.
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
    fn what_does_not_apply_or_converge_is_skipped_and_other_errors_are_not() {
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
