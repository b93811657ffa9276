//! `CertifiedAnswer`: bounds on a distance, with a certificate.

use core::ops::ControlFlow;

use schemars::JsonSchema;
use serde::Serialize;
use tautline::{
    CertificateError,
    distance::{AnyCubes, AnyFound, Ended, Progress, Wanted},
};
use tautline_picture::portrait::Cubes;

use crate::{Float, Line, answer::points};

/// Bounds on the distance, with a certificate that anybody can check.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "Certified distance")]
pub struct CertifiedAnswer {
    /// No curve between the sets is shorter.
    pub lower: Float,
    /// The proved length of a curve between the sets; 0 if they have a proved common point.
    pub upper: Float,
    /// (upper - lower)/upper.
    pub gap: Float,
    /// Whether the gap is as small as wanted.
    pub reached: bool,
    /// Why the search ended.
    pub ended: &'static str,
    /// The levels, from coarse to fine.
    pub levels: Vec<LevelAnswer>,
    /// The number of cubes that hold every shortest curve.
    pub corridor_cubes: usize,
    /// Their side.
    pub corridor_side: Float,
    /// That a cost or a speed is negative in places, and what this means; absent if no such place is known.
    pub note: Option<String>,
    /// The certificate, which `tautline check` reads; empty if the sets touch, up to rounding.
    #[serde(skip)]
    pub certificate: String,
    /// The points of the curve.
    #[serde(skip)]
    pub curve: Vec<Vec<f64>>,
    /// The points of other local minima.
    #[serde(skip)]
    pub other_minima: Vec<Vec<Vec<f64>>>,
    /// The cubes of each level, from coarse to fine, and those that hold every shortest curve.
    #[serde(skip)]
    pub corridor: Vec<Cubes>,
}

/// What one level proves.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct LevelAnswer {
    /// The number of cubes.
    pub cubes: usize,
    /// The lower bound after this level.
    pub lower: Float,
}

impl CertifiedAnswer {
    /// Searches for a certificate of the distance, given a line.
    ///
    /// # Errors
    ///
    /// [`CertificateError`].
    pub fn of(
        line: &Line,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Self, CertificateError> {
        match line.any_certificate(wanted, observe) {
            Ok(found) => Ok(Self::found(line, &found)),
            Err(CertificateError::Touching) => {
                let ended = "the sets have a common point";
                Ok(without_certificate(line, 0.0, ended))
            }
            Err(CertificateError::NearlyTouching { upper }) => {
                let ended = "the sets touch up to rounding, and no common point is proved";
                Ok(without_certificate(line, upper, ended))
            }
            Err(error) => Err(error),
        }
    }

    fn found(line: &Line, found: &AnyFound) -> Self {
        let levels = found.levels().iter();
        let levels = levels.map(|&(cubes, lower)| LevelAnswer { cubes, lower: Float::from(lower) });
        let corridor = found.corridor();
        let (corridor_cubes, corridor_side) =
            (corridor.places.len() / found.dimension(), Float::from(corridor.side));
        let plain = |AnyCubes { side, places }| Cubes { side, places };
        let others = line.other_minima();
        Self {
            lower: Float::from(found.lower()),
            upper: Float::from(found.upper().unwrap_or(f64::INFINITY)),
            gap: Float::from(found.gap().unwrap_or(f64::INFINITY)),
            reached: found.ended() == Ended::Reached,
            ended: ended(found.ended()),
            levels: levels.collect(),
            corridor_cubes,
            corridor_side,
            note: None,
            certificate: found.certificate(),
            curve: points(line.sequence()),
            other_minima: others.iter().map(|other| points(other.sequence())).collect(),
            corridor: found.cubes().into_iter().chain([corridor]).map(plain).collect(),
        }
    }
}

/// Returns the answer without a certificate, for sets that touch, up to rounding: the distance is at most
/// `upper`.
fn without_certificate(line: &Line, upper: f64, ended: &'static str) -> CertifiedAnswer {
    CertifiedAnswer {
        lower: Float::from(0.0),
        upper: Float::from(upper),
        gap: Float::from(if upper == 0.0 { 0.0 } else { 1.0 }),
        reached: upper == 0.0,
        ended,
        levels: Vec::new(),
        corridor_cubes: 0,
        corridor_side: Float::from(0.0),
        note: None,
        certificate: String::new(),
        curve: points(line.sequence()),
        other_minima: Vec::new(),
        corridor: Vec::new(),
    }
}

/// Says why a search ended.
pub(crate) fn ended(ended: Ended) -> &'static str {
    match ended {
        Ended::Reached => "the gap is as small as wanted",
        Ended::Stalled => {
            "the gap no longer falls: there may be a shorter curve, or another one nearly as short"
        }
        Ended::TooManyCubes => "the next level would have too many cubes",
        Ended::TooFar => {
            "the next cubes would be too small, or too small for their distance from the origin"
        }
        Ended::TooMuchWork => {
            "with the next level, the check would cost more than a certificate of this size may"
        }
        _ => "stopped before the next level",
    }
}
