//! The observed orders of convergence of one metric.

use nalgebra::SVector;
use tautline::Bounded;
use tautline_statements::{LIBRARY, PaperRule, Reconstruction, VerifyError};

use super::{
    Case,
    formula::winding,
    problems::{Posed, estimated},
};
use crate::{
    Failure, Fault,
    met::IDLE,
    order::{median, order},
    report::{LawResult, Tried},
    sampling::{COSTLY, for_all},
};

/// The grids of the fits.
const WINDOW: [usize; 4] = [32, 64, 128, 256];

/// How far below the order a slope may be: the next term of the expansion is smaller by some
/// `10/N`, which tilts a line over the window by 0.2 at most.
const TILT: f64 = 0.2;

/// Of so many problems the median is judged: of one, the leading coefficient may happen to be
/// small, and the line is then that of a sum which changes its sign.
const PROBLEMS: usize = 5;

/// The grids and the number of problems: above three dimensions, where a solve costs `D³`, the
/// finest grid and two problems less.
const fn window_and_problems(dimension: usize) -> (&'static [usize], usize) {
    if dimension <= 3 { (&WINDOW, PROBLEMS) } else { (WINDOW.split_at(3).0, PROBLEMS - 2) }
}

/// The errors of one problem: of the discrete energy and of the energy of the curve, for each grid
/// where they are not rounding.
type Errors = [Vec<(usize, f64)>; 2];

/// Fits `|E_N − d²|` and `E(γᵖˡ) − d²` for the rule, and compares with their orders.
pub(super) fn orders<const D: usize>(case: &Case<'_, D>, rule: PaperRule, least: f64) -> LawResult {
    case.solvable()?;
    let (window, problems) = window_and_problems(D);
    let failure = |fault: Fault| Failure { fault, sample: None, seed: case.effort.seed };
    let mut slopes = [Vec::new(), Vec::new()];
    let mut solved = 0;
    let mut stuck = None;
    for k in 0..problems {
        match errors(case, rule, k) {
            Ok(errors) => {
                solved += 1;
                for (slopes, errors) in slopes.iter_mut().zip(errors) {
                    // Two errors above rounding make no line.
                    if errors.len() >= 3 {
                        slopes.push(order(&errors));
                    }
                }
            }
            Err(error @ VerifyError::NotConverged { .. }) => stuck = Some(error),
            Err(error) => return Err(failure(error.into())),
        }
    }
    if let (0, Some(error)) = (solved, stuck) {
        let tried = problems as u64;
        return Err(failure(Fault::NotSolved { failed: tried, tried, error }));
    }
    let [discrete, curve] = slopes.map(median);
    observed([discrete, curve], least, window).map_err(failure)?;
    let word = |order: Option<f64>| match order {
        Some(order) => format!("{order:.2}"),
        None => "exact".to_owned(),
    };
    let note = format!("observed {} and {} over N = {window:?}", word(discrete), word(curve));
    Ok(Tried::cases(solved * window.len() as u64).with_note(note))
}

/// Compares the slopes of both errors with the order of the rule and with 2; there is none where
/// errors are rounding.
fn observed(
    [discrete, curve]: [Option<f64>; 2],
    least: f64,
    window: &[usize],
) -> Result<(), Fault> {
    for (what, found, least) in
        [("|E_N − d²|", discrete, least - TILT), ("E(γᵖˡ) − d²", curve, 2.0 - TILT)]
    {
        if let Some(found) = found
            && !(found >= least)
        {
            return Err(Fault::Order { what, found, least, window: window.to_vec() });
        }
    }
    Ok(())
}

/// Solves the `k`-th problem, between two points of an irrational winding through the region.
fn errors<const D: usize>(
    case: &Case<'_, D>,
    rule: PaperRule,
    k: usize,
) -> Result<Errors, VerifyError> {
    let point =
        |k: usize| case.ends.at(&SVector::from_fn(|i, _| ((k + 1) as f64 * winding(i)).fract()));
    let posed = Posed::between(point(k), point(k + 1));
    let known = case.known(&posed, &[])?;
    let mut errors = [Vec::new(), Vec::new()];
    for &n in window_and_problems(D).0 {
        let seen = Reconstruction::observe(&LIBRARY, &known, rule, n)?;
        let pair = [seen.discrete_energy, seen.energy.value];
        for (errors, energy) in errors.iter_mut().zip(pair) {
            let error = (energy - seen.distance_squared).abs();
            // Ten times what may be wrong about it tilts a line no more than its next term does.
            if error > 10.0 * seen.granted {
                errors.push((n, error));
            }
        }
    }
    Ok(errors)
}

/// `d^g` is zero from a point to itself, symmetric, and the limit of the minimal discrete energies.
pub(super) fn distances<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let Some(distance) = &case.distance else {
        return Ok(Tried::cases(0).with_note("no distance is known"));
    };
    case.solvable()?;
    let metric = &case.metric;
    let pairs = (case.ends.uniform(), case.ends.uniform());
    for_all(&case.effort, case.effort.problems, COSTLY, pairs, |(a, b)| {
        let (Some(d), Some(back)) = (distance(a, b), distance(b, a)) else {
            return Ok(IDLE);
        };
        let point: Vec<f64> = a.iter().chain(b).copied().collect();
        // As in `Known::between`.
        let size = (a.norm() + b.norm()) * metric.constants().c2().sqrt();
        let granted = 32.0 * f64::EPSILON * size;
        Fault::unless_at_most("|d(x, y) − d(y, x)| = 0", [(d - back).abs(), 0.0], granted, &point)?;
        let own = distance(a, a).unwrap_or(0.0);
        Fault::unless_at_most("d(x, x) = 0", [own.abs(), 0.0], granted, &point)?;
        if (b - a).norm() < case.ends.size() / 64.0 {
            return Ok(f64::INFINITY);
        }
        let known =
            match estimated(metric, Posed::between(*a, *b).ends().map_err(VerifyError::from)?, &[])
            {
                Ok(known) => known,
                Err(VerifyError::NotConverged { .. }) => return Ok(IDLE),
                Err(error) => return Err(error.into()),
            };
        let granted = granted + known.distance_error;
        // A solver may miss the shortest curve, but finds none that is shorter.
        Fault::unless_at_most("d(x, y) ≤ length of a curve", [d, known.distance], granted, &point)
    })
}

#[cfg(test)]
mod tests {
    use super::{WINDOW, observed};
    use crate::Fault;

    #[test]
    fn both_orders_are_judged() {
        let judged = |pair, least| observed(pair, least, &WINDOW);
        assert_eq!(judged([Some(1.81), Some(1.81)], 2.0), Ok(()));
        assert_eq!(judged([Some(0.81), Some(1.81)], 1.0), Ok(()));
        assert_eq!(judged([None, None], 2.0), Ok(()));
        for (pair, least, word) in [
            ([Some(1.79), Some(2.0)], 2.0, "|E_N − d²|"),
            ([Some(0.79), Some(2.0)], 1.0, "|E_N − d²|"),
            ([Some(f64::NAN), Some(2.0)], 1.0, "|E_N − d²|"),
            // For the left-endpoint rule too, the curve has order 2.
            ([Some(1.0), Some(1.79)], 1.0, "E(γᵖˡ) − d²"),
            ([None, Some(f64::NAN)], 2.0, "E(γᵖˡ) − d²"),
        ] {
            let Err(Fault::Order { what, .. }) = judged(pair, least) else { panic!("{pair:?}") };
            assert_eq!(what, word);
        }
    }
}
