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
mod tests;
