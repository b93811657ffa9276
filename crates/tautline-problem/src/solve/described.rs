//! What the library found, as the numbers and the words of an answer.

use tautline::{ANY, Curvature, Integral, Known, PointSequence, Stop, TautLine};

use crate::{Estimated, Search};

pub(crate) fn estimated(Integral { value, error, .. }: Integral) -> Estimated {
    Estimated { value, error }
}

/// Returns an estimate of the distance.
pub(crate) fn extrapolated(line: &TautLine<Known, ANY>) -> Option<Estimated> {
    let square = line.distance_squared_estimate()?;
    let value = square.value.max(0.0).sqrt();
    // An estimate that may be 0 is none.
    let is_known = square.error < square.value;
    is_known.then(|| Estimated { value, error: 0.5 * square.error / value })
}

/// Returns how the search for a minimum ended.
pub(crate) fn search(line: &TautLine<Known, ANY>) -> Search {
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
