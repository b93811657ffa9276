//! The observed orders of convergence of one metric.

use tautline::Bounded;
use tautline_statements::{LIBRARY, PaperRule, Reconstruction, VerifyError};

use super::{Case, distances::estimated, formula::on_winding, problems::Posed};
use crate::{
    Fault,
    margin::IDLE,
    order::{median, order},
    report::{LawResult, Tried},
};

/// The grids used for the fits.
const WINDOW: [usize; 4] = [32, 64, 128, 256];

/// The amount by which a slope may fall short of the order. The next term of the expansion is
/// smaller by a factor of about `10/N`, which tilts a line over the window by at most 0.2.
const TILT: f64 = 0.2;

/// The number of problems over which the median is taken. In a single problem the leading
/// coefficient may happen to be small, so that the error changes sign.
const PROBLEMS: usize = 5;

/// The errors of the discrete energy and of the energy of the curve for one problem, on each grid
/// on which they exceed rounding.
type Errors = [Vec<(usize, f64)>; 2];

/// Checks that `|E_N − d²|` falls with the order of the rule, and `E(γᵖˡ) − d²` with order 2.
pub(super) fn orders<const D: usize>(case: &Case<'_, D>, rule: PaperRule, least: f64) -> LawResult {
    case.solvable()?;
    // In more than three dimensions, where a solve costs D³, we omit the finest grid and two
    // problems.
    let (window, problems): (&[usize], _) =
        if D <= 3 { (&WINDOW, PROBLEMS) } else { (&WINDOW[..3], PROBLEMS - 2) };
    let mut slopes = [Vec::new(), Vec::new()];
    let mut solved = 0;
    let mut stuck = None;
    for k in 0..problems {
        match errors(case, rule, window, k) {
            Ok(errors) => {
                solved += 1;
                for (slopes, errors) in slopes.iter_mut().zip(errors) {
                    // Two errors above rounding are not enough for a line.
                    if errors.len() >= 3 {
                        slopes.push(order(&errors));
                    }
                }
            }
            Err(error @ VerifyError::NotConverged { .. }) => stuck = Some(error),
            Err(error) => return Err(case.effort.failure(error)),
        }
    }
    if let (0, Some(error)) = (solved, stuck) {
        let tried = problems as u64;
        return Err(case.effort.failure(Fault::NotSolved { failed: tried, tried, error }));
    }
    let [discrete, curve] = slopes.map(median);
    observed([discrete, curve], least, window).map_err(|fault| case.effort.failure(fault))?;
    let word = |order: Option<f64>| order.map_or("exact".to_owned(), |order| format!("{order:.2}"));
    let note = format!("observed {} and {} over N = {window:?}", word(discrete), word(curve));
    Ok(Tried::cases(solved * window.len() as u64).with_note(note))
}

/// Compares the slope of one error with the order of the rule and the slope of the other with 2. A
/// slope is missing if the errors do not exceed rounding.
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
    window: &[usize],
    k: usize,
) -> Result<Errors, VerifyError> {
    let posed = Posed::between(on_winding(&case.ends, k + 1), on_winding(&case.ends, k + 2));
    let known = case.known(&posed, &[])?;
    let mut errors = [Vec::new(), Vec::new()];
    for &n in window {
        let seen = Reconstruction::observe(&LIBRARY, &known, rule, n)?;
        let pair = [seen.discrete_energy, seen.energy.value];
        for (errors, energy) in errors.iter_mut().zip(pair) {
            let error = (energy - seen.distance_squared).abs();
            // An uncertainty of one tenth tilts a line no more than the next term of the expansion
            // does.
            if error > 10.0 * seen.granted {
                errors.push((n, error));
            }
        }
    }
    Ok(errors)
}

/// Checks that `d^g` is zero from a point to itself, symmetric, and at most the length of the
/// minimisers.
pub(super) fn distances<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let Some(distance) = &case.distance else { return Ok(Tried::none("no distance is known")) };
    case.solvable()?;
    let metric = &case.metric;
    case.effort.for_all_problems((case.ends.uniform(), case.ends.uniform()), |(a, b)| {
        let (Some(d), Some(back)) = (distance(a, b), distance(b, a)) else { return Ok(IDLE) };
        let point: Vec<f64> = a.iter().chain(b).copied().collect();
        // As in `Known::between`.
        let size = (a.norm() + b.norm()) * metric.constants().c2().sqrt();
        let granted = 32.0 * f64::EPSILON * size;
        Fault::unless_zero("|d(x, y) − d(y, x)| = 0", (d - back).abs(), granted, &point)?;
        let own = distance(a, a).unwrap_or(0.0);
        Fault::unless_zero("d(x, x) = 0", own.abs(), granted, &point)?;
        if (b - a).norm() < case.ends.size() / 64.0 {
            return Ok(f64::INFINITY);
        }
        let ends = Posed::between(*a, *b).ends().map_err(VerifyError::from)?;
        let known = match estimated(metric, ends, &[]) {
            Ok(known) => known,
            Err(VerifyError::NotConverged { .. }) => return Ok(IDLE),
            Err(error) => return Err(error.into()),
        };
        let granted = granted + known.distance_error;
        // A solver may miss the shortest curve, but never finds a shorter one.
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
            // The order of the curve is 2 for the left-endpoint rule too.
            ([Some(1.0), Some(1.79)], 1.0, "E(γᵖˡ) − d²"),
            ([None, Some(f64::NAN)], 2.0, "E(γᵖˡ) − d²"),
        ] {
            let Err(Fault::Order { what, .. }) = judged(pair, least) else { panic!("{pair:?}") };
            assert_eq!(what, word);
        }
    }
}
