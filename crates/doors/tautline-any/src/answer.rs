//! `Answer`: what is computed and proved for a problem.

use core::ops::ControlFlow;

use schemars::JsonSchema;
use serde::Serialize;
use tautline::{
    ANY, Constants, Curvature, Doubt, Integral, PointSequence, Stop, TIE, certify::Watch,
    decimal::shortly_down, distance::Progress,
};

use crate::{
    Float, Line,
    bounds::{Proving, bounds},
};

/// A curve between the two sets, and bounds on their distance.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "An answer of Tautline")]
pub struct Answer {
    /// The number of coordinates.
    pub dimension: usize,
    /// The rule of numerical integration.
    pub rule: &'static str,
    /// The number of chords.
    pub n: usize,
    /// The length of the curve, an upper bound on the distance up to the error of its quadrature, and of
    /// its ends if the sets touch up to rounding.
    pub length: Estimated,
    /// The energy of the curve, an upper bound on the squared distance up to the error of its
    /// quadrature; none if it is infinite, as from a pole of the metric.
    pub energy: Option<Estimated>,
    /// The energy of the points by the rule. It may be on either side of the squared distance.
    pub discrete_energy: f64,
    /// The distance by extrapolation over several grids: an estimate, not a bound.
    pub extrapolated: Option<Estimated>,
    /// How the search ended.
    pub search: Search,
    /// Whether the chords resolve the metric. Otherwise the metric changes between the points at
    /// which the rule evaluates it, or another minimum is shorter than the curve; the distance may
    /// be any smaller number.
    pub resolved: bool,
    /// Whether the length is within the tolerance of the length of the minimum that was found, by
    /// extrapolation; absent if no tolerance was given. That no other minimum is shorter is assumed.
    pub within_tolerance: Option<bool>,
    /// Bounds on the distance; absent if they were not asked for or time ran out.
    pub bounds: Option<Bounds>,
    /// Why there are no bounds.
    pub no_bounds: Option<String>,
    /// The points of the curve, from the first set to the second.
    pub curve: Vec<Vec<f64>>,
    /// Other local minima that were met, shortest first, with `n` chords or 512, whichever is less.
    pub other_minima: Vec<OtherMinimum>,
    /// Why the curve may not be a shortest one, or its numbers not what they seem; empty if no reason is
    /// known.
    pub doubts: Vec<DoubtAnswer>,
}

/// A reason why a curve may not be a shortest one, or its numbers not what they seem.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct DoubtAnswer {
    /// Which kind of reason it is.
    pub kind: &'static str,
    /// The reason, in words.
    pub text: String,
}

impl From<&Doubt> for DoubtAnswer {
    fn from(doubt: &Doubt) -> Self {
        Self { kind: doubt.key(), text: doubt.to_string() }
    }
}

impl Answer {
    /// Returns what is known of a line on its own: neither other minima nor bounds. `tolerance` is the
    /// relative error of the length that was asked for.
    #[must_use]
    pub fn of(line: &Line, tolerance: Option<f64>) -> Self {
        let (minimum, mut doubts) = (line.minimum(), line.own_doubts());
        let n = minimum.sequence.n().get();
        let within_tolerance = tolerance.map(|tolerance| line.is_within(tolerance));
        if within_tolerance == Some(false) {
            doubts.push(Doubt::Tolerance { chords: n });
        }
        Self {
            dimension: minimum.sequence.dimension(),
            rule: line.rule().name(),
            n,
            length: line.length().into(),
            energy: Some(line.energy().into())
                .filter(|energy: &Estimated| energy.value.is_finite()),
            discrete_energy: minimum.energy,
            extrapolated: extrapolated(line),
            search: search(line),
            resolved: line.is_resolved(),
            within_tolerance,
            bounds: None,
            no_bounds: None,
            curve: points(&minimum.sequence),
            other_minima: Vec::new(),
            doubts: doubts.iter().map(DoubtAnswer::from).collect(),
        }
    }

    /// Adds the other minima of the line, and what is proved of the distance, if anything shall be.
    /// `solved` is called before anything is proved, which may take longer; `watch` and `observe` may end
    /// the proofs.
    pub fn complete(
        mut self,
        line: &Line,
        proving: Option<Proving>,
        watch: &dyn Watch,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
        solved: &mut dyn FnMut(&Self),
    ) -> Self {
        let others = line.other_minima();
        let minima = others.iter().map(|other| OtherMinimum {
            length: other.length().into(),
            curve: points(other.sequence()),
        });
        self.other_minima = minima.collect();
        let shorter = self.other_minima.iter().find(|other| other.is_shorter_than(&self));
        if let Some(length) = shorter.map(|other| other.length.value) {
            self.is_not_resolved(&Doubt::Shorter { length });
        }
        solved(&self);
        let Some(proving) = proving else { return self };
        match bounds(proving, line, &others, watch, observe) {
            Ok(bounds) => {
                if bounds.exceed(&self.length) {
                    self.is_not_resolved(&Doubt::Longer { upper: bounds.upper.value });
                }
                // An estimate beyond a proved bound is wrong by at least the difference.
                if let Some(extrapolated) = &mut self.extrapolated {
                    let value = extrapolated.value;
                    extrapolated.value = value.max(bounds.lower.value).min(bounds.upper.value);
                    let beyond = (extrapolated.value - value).abs();
                    extrapolated.error = extrapolated.error.max(beyond);
                }
                (self.bounds, self.no_bounds) = (Some(bounds), None);
            }
            Err(reason) => self.no_bounds = Some(reason),
        }
        self
    }

    /// Says that the distance is not what the energies of the curve tend to.
    fn is_not_resolved(&mut self, doubt: &Doubt) {
        (self.resolved, self.extrapolated) = (false, None);
        self.within_tolerance = self.within_tolerance.and(Some(false));
        self.doubts.push(doubt.into());
    }
}

/// A number, and an estimate of its error.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Estimated {
    /// The number.
    pub value: f64,
    /// The estimated error.
    pub error: f64,
}

impl From<Integral> for Estimated {
    fn from(Integral { value, error, .. }: Integral) -> Self {
        Self { value, error }
    }
}

/// How a search ended.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Search {
    /// Whether it converged to a strict local minimum, or to ends that touch, up to rounding.
    pub converged: bool,
    /// Why it stopped.
    pub stop: &'static str,
    /// The Hessian of the discrete energy at the result.
    pub hessian: String,
    /// The residual of the discrete geodesic equation, relative to the momentum.
    pub residual: f64,
    /// The residual that rounding alone is predicted to cause.
    pub residual_floor: f64,
    /// The number of Newton steps, from all starts and on all grids.
    pub newton_steps: usize,
}

/// Bounds on the distance.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Bounds {
    /// The lower bound.
    pub lower: Float,
    /// The upper bound.
    pub upper: Float,
    /// What the lower bound rests on besides the constants.
    pub global_minimum: GlobalMinimum,
    /// The constants; absent if the lower bound is that of a certificate, because none were proved.
    pub constants: Option<UsedConstants>,
    /// The statement that gives the lower bound.
    pub lower_by: String,
    /// What the upper bound is.
    pub upper_by: String,
    /// The certificate of the lower bound; absent if a theorem gives that bound.
    pub certificate: Option<CertificateAnswer>,
}

/// What a lower bound leaves open where the coordinates have periods.
const FARTHER: &str = "; farther translates by the period were not tried";

impl Bounds {
    /// Says that the lower bound is about the translates of the second set that were tried, unless a constant
    /// `c₁` on all of space shows that a curve to a farther translate is longer than the bound. Each farther
    /// translate is at least `reach` from the first set, in `ℓ`.
    pub fn to_near_translates(&mut self, reach: f64) {
        let everywhere =
            |constants: &&UsedConstants| constants.within.is_none() && !constants.if_it_settles;
        let c1 = self.constants.as_ref().filter(everywhere).map_or(0.0, |constants| constants.c1);
        // The root and the product are rounded.
        if !(c1.sqrt() * reach * (1.0 - 4.0 * f64::EPSILON) >= self.lower.value) {
            self.lower_by += FARTHER;
        }
    }

    /// Says what the lower bound leaves open, after a semicolon; nothing if no curve is shorter.
    #[must_use]
    pub fn left_open(&self) -> &'static str {
        if self.lower_by.ends_with(FARTHER) { FARTHER } else { "" }
    }
}

/// The certificate that gives a lower bound.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct CertificateAnswer {
    /// The number of its cubes.
    pub cubes: usize,
    /// Whether its gap is as small as wanted. Otherwise there may be a shorter curve.
    pub reached: bool,
    /// Why the search for it ended.
    pub ended: &'static str,
}

/// Whether the computed minimum is known to be the global one.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum GlobalMinimum {
    /// Convexity proves it: the discrete energy has one local minimum only, and the search converged
    /// to it.
    Proved,
    /// The lower bound does not need it: it holds for all curves, whichever was found.
    NotNeeded,
    /// It is assumed.
    Assumed,
    /// It is refuted: another curve is shorter, or by convexity some sequence of points has less
    /// energy. The lower bound does not need it.
    Refuted,
}

/// Constants of the metric, and where they hold.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct UsedConstants {
    /// A lower bound on the eigenvalues of `H`.
    pub c1: f64,
    /// An upper bound on the eigenvalues of `H`.
    pub c2: f64,
    /// A Lipschitz constant of `H`.
    pub l_h: f64,
    /// A Lipschitz constant of the derivative of `H`.
    pub m_h: Option<f64>,
    /// Whether they are proved from the formula, or claimed in the file.
    pub proved: bool,
    /// The ball in which they hold; absent if that is all of space.
    pub within: Option<BallAnswer>,
    /// Whether they hold only if the metric settles: if it does not change farther out than `2¹⁰⁰`,
    /// where nothing is proved.
    pub if_it_settles: bool,
}

impl UsedConstants {
    /// Returns constants, with how they are known and the ball in which they hold.
    #[must_use]
    pub fn new(constants: Constants, proved: bool, within: Option<BallAnswer>) -> Self {
        Self {
            c1: constants.c1(),
            c2: constants.c2(),
            l_h: constants.l_h(),
            m_h: constants.m_h(),
            proved,
            within,
            if_it_settles: false,
        }
    }
}

/// A ball.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct BallAnswer {
    /// The centre.
    pub centre: Vec<f64>,
    /// The radius.
    pub radius: f64,
}

impl BallAnswer {
    /// Returns a ball of fewer digits that lies in this one: its centre to four places, if it is not
    /// much smaller then, and its radius to this many digits.
    #[must_use]
    pub fn shortened(&self, digits: usize) -> (Vec<f64>, String) {
        let round = |x: &f64| format!("{x:.4}").parse().unwrap_or(*x) + 0.0;
        let short: Vec<f64> = self.centre.iter().map(round).collect();
        let moved: f64 = short.iter().zip(&self.centre).map(|(a, b)| (a - b).abs()).sum();
        // Decimals of the centre are read as doubles, and a dozen moves are added: each step is off by
        // less than ε of the radius and the coordinates.
        let size = self.centre.iter().fold(self.radius, |size, x| size.max(x.abs()));
        let rounding = 64.0 * f64::EPSILON * size;
        let is_near = moved <= 0.1 * self.radius;
        let (centre, moved) = if is_near { (short, moved) } else { (self.centre.clone(), 0.0) };
        (centre, shortly_down((self.radius - moved - rounding).max(0.0), digits))
    }
}

/// A local minimum besides the result.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct OtherMinimum {
    /// The length of its curve.
    pub length: Estimated,
    /// The points of its curve.
    pub curve: Vec<Vec<f64>>,
}

/// Returns whether a length is shorter than another one by more than a tie.
pub(crate) fn is_shorter(length: f64, than: f64) -> bool {
    length <= than * (1.0 - TIE)
}

impl OtherMinimum {
    /// Returns whether the curve is as short as that of an answer.
    #[must_use]
    pub fn ties_with(&self, answer: &Answer) -> bool {
        (self.length.value / answer.length.value - 1.0).abs() < TIE
    }

    /// Returns whether the curve is shorter than that of an answer.
    #[must_use]
    pub fn is_shorter_than(&self, answer: &Answer) -> bool {
        is_shorter(self.length.value, answer.length.value)
    }
}

/// Returns an estimate of the distance.
pub(crate) fn extrapolated(line: &Line) -> Option<Estimated> {
    let square = line.distance_squared_estimate()?;
    let value = square.value.max(0.0).sqrt();
    // An estimate that may be 0 is none, nor is one above the length, which is an upper bound: the grids
    // disagree.
    let length = line.length();
    let is_known =
        square.error < square.value && value <= (length.value + length.error) * (1.0 + ROUNDING);
    is_known.then(|| Estimated { value, error: 0.5 * square.error / value })
}

/// How far above the length an estimate may be for rounding, relative to it: where the length is exact, as
/// on a straight line, it takes nothing off.
const ROUNDING: f64 = 1e-9;

/// Returns how the search for a minimum ended.
pub(crate) fn search(line: &Line) -> Search {
    let minimum = line.minimum();
    let is_contact = minimum.stop == Stop::EndsTouch && line.proved_contact().is_none();
    Search {
        converged: minimum.is_local_minimum(),
        stop: if is_contact { "the sets touch, up to rounding" } else { stop(minimum.stop) },
        hessian: hessian(minimum.curvature),
        residual: minimum.residual,
        residual_floor: minimum.residual_floor,
        newton_steps: minimum.iterations,
    }
}

/// Returns the points of a sequence, from the first to the last.
pub(crate) fn points(sequence: &PointSequence<ANY>) -> Vec<Vec<f64>> {
    sequence.coordinates().chunks_exact(sequence.dimension()).map(<[f64]>::to_vec).collect()
}

fn stop(stop: Stop) -> &'static str {
    match stop {
        Stop::Converged => "converged",
        Stop::EndsTouch => "the sets touch",
        Stop::Stalled => "stalled",
        Stop::IterationLimit => "the number of steps ran out",
        _ => "stopped",
    }
}

fn hessian(curvature: Curvature) -> String {
    match curvature {
        Curvature::PositiveDefinite => "positive definite".to_owned(),
        Curvature::Degenerate => "degenerate".to_owned(),
        Curvature::Indefinite { negative } => format!("{negative} negative eigenvalues"),
        _ => "unknown".to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::BallAnswer;

    /// A centre that is cut moves the ball, and the radius falls by at least as much.
    #[test]
    fn a_shortened_ball_lies_in_the_ball() {
        for (centre, radius) in [
            (vec![1.0 / 3.0, -2.0 / 3.0], 1.0),
            (vec![0.333_349_999, 7.0], 0.001),
            (vec![0.0], 0.1),
            (vec![1e-7, 1e-7], 1e-6),
            (vec![123_456.123_456], 0.000_2),
            (vec![0.5, 0.25, 0.125], 3.0),
        ] {
            let ball = BallAnswer { centre: centre.clone(), radius };
            let (short, text) = ball.shortened(5);
            let printed: f64 = text.parse().expect("a number");
            let moved = short.iter().zip(&centre).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
            assert!(printed + moved <= radius && printed >= 0.89 * radius, "{centre:?}: {text}");
        }
        let half = BallAnswer { centre: vec![0.25], radius: 2.0_f64.sqrt() };
        assert_eq!(half.shortened(5), (vec![0.25], "1.4142".to_owned()));
    }

    /// With all digits, to the last one: on the line, what the centre moved and the radius that is printed
    /// are together no more than the radius, as whole numbers of the unit `10⁻¹⁷ 2⁻⁵⁶`.
    #[test]
    fn a_shortened_interval_lies_in_the_interval_exactly() {
        let (ten, two) = (10_i128.pow(17), 1_i128 << 56);
        let mut state = 9_u64;
        let mut moved_places = 0;
        for _ in 0..500 {
            // Knuth's MMIX; a centre between 1/16 and 1/8, so that the radius less its move is rounded.
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            let centre = ((1_u64 << 52) + (state >> 12)) as f64 / (1_u64 << 56) as f64;
            let radius = 1.0;
            let (short, text) = BallAnswer { centre: vec![centre], radius }.shortened(17);
            // Numbers next to each other: the difference is exact.
            let moved = ((short[0] - centre).abs() * two as f64) as i128;
            // One digit, a point, sixteen digits and e-1.
            let digits = text.strip_suffix("e-1").expect("between 0.1 and 1").replace('.', "");
            let printed: i128 = format!("{digits:0<17}").parse().expect("17 digits");
            assert!(printed * two + moved * ten <= two * ten, "{centre} {short:?} {text}");
            moved_places += usize::from(moved > 0);
        }
        assert!(moved_places > 400, "{moved_places}");
    }
}
