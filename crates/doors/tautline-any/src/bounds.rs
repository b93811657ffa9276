//! Bounds on the distance, for an answer.

use core::ops::ControlFlow;

use tautline::{
    ANY, CertifyError, Constants, Interval, Known, LocalError, PointSequence, ProofError,
    RayleighQuotient, Rule, Short, Stop, are_gram,
    bounds::{Enclosure, FromAbove, FromBelow, LocalityError},
    certify::{Accuracy, Watch},
    distance::{AnyFound, Ended, Progress},
};

use crate::{
    BallAnswer, Bounds, CertificateAnswer, Estimated, GlobalMinimum, Line, UsedConstants,
    certified::ended, constants::are_provable,
};

/// Returns bounds on the distance, or why there are none. `others` are the other minima of the line.
pub(crate) fn bounds(
    proving: Proving,
    line: &Line,
    others: &[Line],
    watch: &dyn Watch,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Bounds, String> {
    let is_in_the_paper = line.rule().paper_rule().is_ok();
    let of_another_rule;
    let (about, line_itself) = if is_in_the_paper {
        (line, None)
    } else {
        // The theorems are about the minimum of a rule of the paper; the curve is a bound from above.
        if proving.claimed.is_none()
            && let Some(bounds) = by_certificate(line, others, observe)
        {
            return Ok(bounds);
        }
        let found = line.by_rule(Rule::TRAPEZOIDAL);
        of_another_rule = found.map_err(|error| error.to_string())?;
        (&of_another_rule, Some(line))
    };
    let found = match proving.claimed {
        Some(_) if proving.is_in_a_region => Err(IN_A_REGION.to_owned()),
        Some(claimed) => by_claims(claimed, about, others),
        None => by_proof(proving.accuracy, about, others, watch, observe).or_else(|reason| {
            let certified = is_in_the_paper.then(|| by_certificate(line, others, observe));
            certified.flatten().ok_or(reason)
        }),
    };
    let found = found?.and_no_longer_than(line_itself.into_iter().filter_map(length_above));
    if proving.claimed.is_some() { found.without_contradiction() } else { Ok(found) }
}

/// Returns bounds by constants that are claimed.
fn by_claims(claimed: Constants, line: &Line, others: &[Line]) -> Result<Bounds, String> {
    line.metric().formula().map_err(|error| error.to_string())?;
    check_claims(claimed, line.metric(), line.sequence())?;
    let curve = line.admissible_curve().ok();
    let enclosure = line.enclosure_given(claimed, curve.as_ref());
    let enclosure = enclosure.map_err(|error| error.to_string())?;
    let constants = UsedConstants::new(claimed, false, None);
    let mut found = in_words(enclosure, Some(constants), line.minimum().is_local_minimum());
    if curve.is_none() {
        let quadrature = ", with the estimated error of quadrature";
        found.upper_by += quadrature;
        if found.lower_by != NOTHING {
            found.lower_by += quadrature;
        }
    }
    found = found.after(line.minimum().stop);
    let lengths = others.iter().map(|other| {
        length_above(other).unwrap_or_else(|| {
            let length = other.length();
            length.value + length.error
        })
    });
    found.and_no_longer_than(lengths).without_contradiction()
}

/// Returns bounds by constants that are proved from the formula.
fn by_proof(
    accuracy: Accuracy,
    line: &Line,
    others: &[Line],
    watch: &dyn Watch,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Bounds, String> {
    let formula = line.metric().formula().map_err(|error| error.to_string())?;
    are_provable(formula).map_err(|error| error.to_string())?;
    let proof = line.prove_watched(accuracy, watch, observe).map_err(|error| no_proof(&error))?;
    let within = proof
        .within
        .map(|ball| BallAnswer { centre: ball.centre_slice().to_vec(), radius: ball.r() });
    let constants = UsedConstants::new(proof.constants, true, within);
    let mut found = in_words(proof.enclosure, Some(constants), line.minimum().is_local_minimum());
    if proof.enclosure.from_below == FromBelow::Certificate {
        found.certificate = proof.found.as_ref().map(CertificateAnswer::of);
    }
    found = found.after(line.minimum().stop);
    Ok(found.and_no_longer_than(others.iter().filter_map(length_above)))
}

/// Returns bounds by a certificate, which needs neither constants nor a rule; `None` if there is none.
fn by_certificate(
    line: &Line,
    others: &[Line],
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Option<Bounds> {
    // Before the first level: if time has run out, there is none.
    let start = Progress { levels: 0, cubes: 0, lower: 0.0, upper: line.length().value };
    if observe(start).is_break() {
        return None;
    }
    // The least gap takes some seconds too.
    let found = line.quick_certificate(0.0, observe).ok()?;
    let upper = found.upper().filter(|_| found.lower() > 0.0)?;
    let bounds = Bounds {
        lower: found.lower().into(),
        upper: upper.into(),
        global_minimum: GlobalMinimum::NotNeeded,
        constants: None,
        lower_by: BY_CERTIFICATE.to_owned(),
        upper_by: BY_LENGTH.to_owned(),
        certificate: Some(CertificateAnswer::of(&found)),
    };
    Some(bounds.and_no_longer_than([line].into_iter().chain(others).filter_map(length_above)))
}

impl CertificateAnswer {
    /// Says how large the certificate is, and why the search for it ended.
    fn of(found: &AnyFound) -> Self {
        Self {
            cubes: found.levels().iter().map(|(cubes, _)| cubes).sum(),
            reached: found.ended() == Ended::Reached,
            ended: ended(found.ended()),
        }
    }
}

/// Returns a proved upper bound on the length of a line, if there is one.
fn length_above(line: &Line) -> Option<f64> {
    let curve = line.admissible_curve().ok()?;
    Some(curve.length().hi())
}

/// What bounds rest on: constants that are claimed, or how they are proved.
#[derive(Clone, Copy, Debug)]
pub struct Proving {
    /// The constants that are claimed.
    pub claimed: Option<Constants>,
    /// Whether the claims are about a region only, beyond which curves may run.
    pub is_in_a_region: bool,
    /// How closely constants are proved, and at what cost.
    pub accuracy: Accuracy,
}

/// How much longer than its quadrature a curve may be by a bound with outward rounding, relative to
/// it.
const WIDTH: f64 = 1e-6;

impl Bounds {
    /// Returns whether the lower bound rests on constants that are claimed.
    #[must_use]
    pub fn rests_on_claims(&self) -> bool {
        self.constants.as_ref().is_some_and(|used| !used.proved)
    }

    /// Returns whether the curve is longer than its quadrature says, which then has missed a part of
    /// the metric.
    pub(crate) fn exceed(&self, length: &Estimated) -> bool {
        self.upper.value > length.value * (1.0 + WIDTH) + length.error
    }

    /// Takes into account how the search ended. One that ran out of steps came to no minimum, so that its
    /// energy is not assumed to be the least.
    fn after(mut self, stop: Stop) -> Self {
        if stop == Stop::IterationLimit && self.global_minimum == GlobalMinimum::Assumed {
            self.give_up(GlobalMinimum::NotNeeded);
        }
        self
    }

    /// Gives up the assumption that the minimum is global, and the lower bound that rests on it.
    fn give_up(&mut self, global_minimum: GlobalMinimum) {
        self.global_minimum = global_minimum;
        self.lower = 0.0.into();
        NOTHING.clone_into(&mut self.lower_by);
    }

    /// Takes the lengths of other curves between the sets into account. One that is shorter than the
    /// lower bound refutes what that bound assumes.
    fn and_no_longer_than(mut self, lengths: impl Iterator<Item = f64>) -> Self {
        let shortest = lengths.fold(f64::INFINITY, f64::min);
        if shortest < self.upper.value {
            self.upper = shortest.into();
            "the length of another minimum".clone_into(&mut self.upper_by);
        }
        if self.lower.value > self.upper.value && self.global_minimum == GlobalMinimum::Assumed {
            self.give_up(GlobalMinimum::Refuted);
        }
        self
    }
}

impl Bounds {
    /// Refuses bounds from claimed constants that contradict each other. The upper one is that of a
    /// curve, so that a claim is wrong.
    fn without_contradiction(self) -> Result<Self, String> {
        let [lower, upper] = [self.lower.value, self.upper.value];
        if lower <= upper {
            return Ok(self);
        }
        Err(format!(
            "the claimed constants are wrong: by them the distance is at least {lower}, but a curve \
             has length {upper}; `tautline audit` finds which one is wrong"
        ))
    }
}

/// Why there are no bounds by constants that are claimed in a region.
const IN_A_REGION: &str = "the constants are claimed in the region of `within` in [certify], and curves \
    may leave it; without `constants` they are proved where shorter curves may run, and without `within` \
    they are claims on all of space";

/// What gives the lower bound of a certificate.
const BY_CERTIFICATE: &str = "a certificate";

/// What gives the upper bound, unless the energy is closer.
const BY_LENGTH: &str = "the length of the curve";

/// What gives a lower bound of 0.
const NOTHING: &str = "nothing: a distance is not negative";

/// Refuses claims about the eigenvalues of `H` that fail at a point of the curve.
fn check_claims(
    claimed: Constants,
    metric: &Known,
    sequence: &PointSequence<ANY>,
) -> Result<(), String> {
    let refuse = |name, claim: f64, x: &[f64], what| {
        let claim = format!("{claim:?}");
        let claim = claim.trim_end_matches(".0");
        Err(format!(
            "the claim {name} = {claim} is wrong: H({x:?}) has a {what} eigenvalue; \
             `tautline audit` tests all claims"
        ))
    };
    let d = sequence.dimension();
    for x in sequence.coordinates().chunks_exact(d) {
        let h = metric.gram(x);
        // Returns `sign H + by I`. Halves that differ by a rounding would not be symmetric relative to
        // what remains.
        let shifted = |sign: f64, by: f64| -> Vec<f64> {
            let places = (0..d * d).map(|place| (place % d, place / d));
            let entry = |(i, j): (usize, usize)| {
                sign * h[i.max(j) * d + i.min(j)] + if i == j { by } else { 0.0 }
            };
            places.map(entry).collect()
        };
        let (c1, c2) = (claimed.c1(), claimed.c2());
        let (lowest, highest) = (c1 * (1.0 - ATTAINED), c2 * (1.0 + ATTAINED));
        let rounding = ROUNDING * h.iter().fold(0.0, |most: f64, entry| most.max(entry.abs()));
        let is_low = !are_gram(&shifted(1.0, rounding - lowest), d);
        let is_high = !are_gram(&shifted(-1.0, highest + rounding), d);
        if !is_low && !is_high {
            continue;
        }
        // Intervals have the last word. Of a black box they know nothing.
        let place: Vec<Interval> = x.iter().map(|&x| Interval::point(x)).collect();
        let enclosed = metric
            .formula()
            .map_or_else(|_| vec![Interval::UNDEFINED; d * d], |formula| formula.gram_at(&place));
        let extreme = RayleighQuotient::extreme_of(&h, &enclosed, d);
        let Some([least, greatest]) = extreme else { continue };
        let is_unknown = least.value.is_undefined();
        if is_low && (is_unknown || least.value.hi() < lowest) {
            return refuse("c1", c1, x, "smaller");
        }
        if is_high && (is_unknown || greatest.value.lo() > highest) {
            return refuse("c2", c2, x, "larger");
        }
    }
    Ok(())
}

/// How far an eigenvalue may be beyond a claim that is meant to be attained, relative to the claim: it
/// was typed to so many digits.
const ATTAINED: f64 = 1e-9;

/// How far rounding may move a computed eigenvalue, relative to the largest entry.
const ROUNDING: f64 = 1e-14;

/// Says why nothing is proved, and what may help.
fn no_proof(error: &ProofError) -> String {
    let nearer = "ends that are closer or more chords may help";
    let more = "ends that are closer, more chords, or more `boxes` in [certify] may help";
    match error {
        ProofError::Constants(error @ CertifyError::BudgetSpent { .. }) => {
            format!("{error}; {more}")
        }
        ProofError::Competitors(LocalityError::NoConstants {
            reason: LocalError::NotProved { radius, reason, budget_spent },
            ..
        }) => {
            let radius = Short(*radius);
            let may_help = if *budget_spent { more } else { nearer };
            format!("they need constants on a ball of radius {radius}, and {reason}; {may_help}")
        }
        ProofError::Competitors(error) => format!("{error}; {nearer}"),
        _ => error.to_string(),
    }
}

/// Turns bounds on the squared distance into bounds on the distance, rounded outwards. `converged`
/// says whether the line is a local minimum.
fn in_words(enclosure: Enclosure, constants: Option<UsedConstants>, converged: bool) -> Bounds {
    let lower = enclosure.lower.max(0.0).sqrt();
    let lower = if lower > 0.0 { lower.next_down() } else { lower };
    let upper = enclosure.upper.sqrt();
    let upper = if upper > 0.0 { upper.next_up() } else { upper };
    let global_minimum = match (enclosure.is_not_global, enclosure.assumes_global_minimum) {
        (true, _) => GlobalMinimum::Refuted,
        (false, true) => GlobalMinimum::Assumed,
        (false, false) => match enclosure.from_below {
            // There is one local minimum only, and this is one.
            FromBelow::Minimum | FromBelow::Convexity
                if enclosure.has_known_minimum && converged =>
            {
                GlobalMinimum::Proved
            }
            // The bounds hold for all curves between the sets, whichever was found.
            _ => GlobalMinimum::NotNeeded,
        },
    };
    let lower_by = match enclosure.from_below {
        FromBelow::Euclidean => "Proposition 3.3",
        FromBelow::Minimum => "Lemma S.4",
        FromBelow::Convexity => "Proposition S.9",
        FromBelow::Certificate => BY_CERTIFICATE,
        _ => NOTHING,
    };
    let upper_by = match enclosure.from_above {
        FromAbove::Length => BY_LENGTH,
        FromAbove::Energy => "the root of the energy of the curve",
    };
    Bounds {
        lower: lower.into(),
        upper: upper.into(),
        global_minimum,
        constants,
        lower_by: lower_by.to_owned(),
        upper_by: upper_by.to_owned(),
        certificate: None,
    }
}

#[cfg(test)]
mod tests;
