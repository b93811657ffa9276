//! The laws of every metric: `H` is a metric, and all that follows from its formula agrees.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Jet1, Metric, MetricError, check_gram, norm_squared};

use super::{
    Case,
    extreme::{first, norm, second},
};
use crate::{
    Claim, Failure, Fault,
    difference_test::difference_test,
    region::directions,
    report::{LawResult, Tried},
    sampling::{CHEAP, for_all},
};

/// `H(x)` is finite, and its two halves agree to rounding.
pub(super) fn finite_and_symmetric<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let effort = &case.effort;
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        match check_gram(&case.metric, x) {
            // Those have a law of their own.
            Ok(_) | Err(MetricError::NotPositiveDefinite { .. }) => Ok(f64::INFINITY),
            Err(error) => Err(error.into()),
        }
    })
}

/// `H(x)` is positive definite at random points, and where its least eigenvalue descends to.
pub(super) fn positive_definite<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, effort) = (&case.metric, &case.effort);
    let axis = SVector::from_fn(|i, _| if i == 0 { 1.0 } else { 0.0 });
    let tried = for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        check_gram(metric, x)?;
        Ok(f64::INFINITY)
    })?;
    let corners = (0..effort.ascents).map(|k| {
        // The points of an irrational winding, which no period of a formula follows.
        let fractions = SVector::from_fn(|i, _| ((k + 1) as f64 * winding(i)).fract());
        Claim::C1.measure(metric, &case.region.at(&fractions), &axis)
    });
    for start in corners {
        let lowest = Claim::C1.climb(metric, &case.region, start);
        if let Err(error) = check_gram(metric, &lowest.point) {
            return Err(Failure { fault: error.into(), sample: None, seed: effort.seed });
        }
    }
    Ok(tried.and(Tried::cases(effort.ascents as u64)))
}

/// `H(x)` is a multiple of the identity, if the constants say so.
pub(super) fn isotropic<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, effort) = (&case.metric, &case.effort);
    let constants = metric.constants();
    if !constants.is_isotropic() {
        return Ok(Tried::cases(0).with_note("not isotropic".to_owned()));
    }
    for_all(effort, effort.cases, CHEAP, case.region.points(), |x| {
        let h = metric.gram(x);
        let off = (h - SMatrix::from_diagonal_element(h[(0, 0)])).amax();
        // A dozen roundings an entry.
        let granted = 1e-14 * constants.c2();
        let law = "H(x) = φ(x) I";
        Fault::unless_at_most(law, [off, 0.0], granted, x.as_slice())?;
        Ok(f64::INFINITY)
    })
}

/// `√(i + 2)` for different square-free parts, without its whole part.
pub(super) fn winding(i: usize) -> f64 {
    const PRIMES: [f64; 12] = [2., 3., 5., 7., 11., 13., 17., 19., 23., 29., 31., 37.];
    PRIMES[i % PRIMES.len()].sqrt().fract()
}

/// First and second derivatives by jets are those of central differences.
pub(super) fn jets<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, effort) = (&case.metric, &case.effort);
    let samples = (case.region.points(), directions::<D>(), directions::<D>());
    for_all(effort, effort.cases, CHEAP, samples, |(x, u, w)| {
        // DH may be small as a difference of terms that are as large as it is elsewhere.
        let terms = metric.constants().l_h();
        let form = |t: f64| [norm_squared(metric, &(x + w * t), u)];
        let slope = |t: f64| {
            let matrix = first(metric, &(x + w * t), w);
            [u.dot(&(matrix * u))]
        };
        let [size, curvature] = [norm(&metric.gram(x)), norm(&second(metric, x, w))];
        let [claimed] = slope(0.0);
        let length = case.region.size();
        let point = || x.as_slice().to_vec();
        // Along the line that a step walks, uᵀHu is of the size of H and what its slope adds.
        difference_test(&[claimed], form, length, size + claimed.abs() * length).map_err(
            |off| {
                let law = "|uᵀ DH(x)[w] u − its central difference| = O(h²)";
                let [left, right] = [off.error, 0.0];
                Fault::Broken {
                    law,
                    left,
                    right,
                    granted: off.granted,
                    point: point(),
                    other: None,
                }
            },
        )?;
        let second = u.dot(&(second(metric, x, w) * u));
        let size = terms + claimed.abs().max(norm(&first(metric, x, w))) + curvature * length;
        difference_test(&[second], slope, length, size).map_err(|off| {
            let law = "|uᵀ D²H(x)[w, w] u − its central difference| = O(h²)";
            let [left, right] = [off.error, 0.0];
            Fault::Broken { law, left, right, granted: off.granted, point: point(), other: None }
        })?;
        // The gradient, which is another number type than the derivative along a line.
        let jet = norm_squared(metric, &Jet1::variables(&(*x).into()).into(), u);
        let along = SVector::<f64, D>::from(*jet.gradient()).dot(w);
        // D terms of the size of the derivatives, or of what they are differences of.
        let sizes = jet.gradient().iter().map(|g| g.abs()).sum::<f64>() + claimed.abs();
        let granted = 1e-12 * (sizes + terms);
        let law = "∇(uᵀHu)·w = uᵀ DH(x)[w] u";
        Fault::unless_at_most(law, [(along - claimed).abs(), 0.0], granted, x.as_slice())
    })
}
