//! `attempt`: a search whose result, steps and end are all checked.

use std::ops::ControlFlow;

use nalgebra::SVector;
use tautline_distance::{DistanceError, Ended, Found, Progress, Wanted, search};
use tautline_formula::Formula;
use tautline_sets::Shape;

/// Searches, and checks what every search has to keep.
pub(crate) fn attempt<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curves: &[Vec<SVector<f64, D>>],
    wanted: Wanted,
) -> Result<Found<D>, DistanceError> {
    let mut steps: Vec<Progress> = Vec::new();
    let found = search(formula, sets, curves, wanted, &mut |step| {
        steps.push(step);
        ControlFlow::Continue(())
    })?;
    keeps_the_rules(&found, &steps, wanted);
    proves_what_it_says(&found, formula, curves);
    Ok(found)
}

/// The observer is told of every level. The search goes on while the gap is too large, the levels are
/// not slow twice in a row, and there is room for more cubes.
fn keeps_the_rules<const D: usize>(found: &Found<D>, steps: &[Progress], wanted: Wanted) {
    let levels = &found.certificate.levels;
    assert_eq!(steps.len(), levels.len());
    let mut cubes = 0;
    for (n, (step, level)) in steps.iter().zip(levels).enumerate() {
        cubes += level.cubes().places().len();
        assert_eq!((step.levels, step.cubes), (n + 1, cubes));
    }
    assert!(cubes <= wanted.cubes, "{cubes} of {}", wanted.cubes);
    assert!(steps.is_sorted_by(|a, b| a.lower <= b.lower), "{steps:?}");
    let gaps: Vec<f64> = steps.iter().map(|step| 1.0 - step.lower / step.upper).collect();
    let slow: Vec<bool> = gaps.windows(2).map(|pair| pair[1] > 0.7 * pair[0]).collect();
    let last = gaps.len() - 1;
    for n in 0..last {
        assert!(gaps[n] > wanted.gap, "{gaps:?} for {wanted:?}");
        assert!(n < 2 || !(slow[n - 2] && slow[n - 1]), "{gaps:?}");
    }
    assert_eq!(found.ended == Ended::Reached, gaps[last] <= wanted.gap, "{gaps:?}");
    let is_slow = last >= 2 && slow[last - 2] && slow[last - 1];
    match found.ended {
        Ended::Stalled => assert!(is_slow, "{gaps:?}"),
        Ended::TooManyCubes => assert!(!is_slow, "{gaps:?}"),
        _ => {}
    }
}

/// The certificate is of these curves, and the checker finds the same bounds.
fn proves_what_it_says<const D: usize>(
    found: &Found<D>,
    formula: &Formula<D>,
    curves: &[Vec<SVector<f64, D>>],
) {
    let certificate = &found.certificate;
    assert_eq!(certificate.formula, *formula);
    assert_eq!(certificate.curve.as_ref().map(Vec::len), curves.first().map(Vec::len));
    let checked = certificate.check().unwrap_or_else(|error| panic!("{error}"));
    assert_eq!((checked.lower, checked.upper), (found.proved.lower, found.proved.upper));
    let curve = certificate.curve.as_ref().expect("a curve");
    let side = checked.corridor.side();
    // A point on a face belongs to the cubes on both sides.
    let is_kept = |x: &SVector<f64, D>| {
        checked.corridor.places().iter().any(|place| {
            (0..D).all(|i| (x[i] / side - f64::from(place[i]) - 0.5).abs() <= 0.5 + 1e-9)
        })
    };
    assert!(curve.iter().all(is_kept), "the curve leaves the corridor");
}

/// Asserts that the bounds of what was found hold a distance that is known up to `error`, relative to it,
/// and that they are as close as wanted.
pub(crate) fn holds<const D: usize>(found: &Found<D>, d: f64, error: f64, gap: f64) {
    let (lower, upper) = (found.proved.lower, found.proved.upper.expect("a curve"));
    assert!(lower <= d * (1.0 + error), "{lower} above {d}");
    assert!(upper >= d * (1.0 - error), "{upper} below {d}");
    let proved = (upper - lower) / upper;
    let levels = &found.proved.levels;
    assert!(proved <= gap, "a gap of {proved:e}, {:?} at {levels:?}", found.ended);
}
