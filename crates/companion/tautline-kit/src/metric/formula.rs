//! The laws of a formula: `H` is a metric, and its derivatives agree with its values.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Jet1, Metric, MetricError, check_gram, norm_squared};

use super::{
    Case,
    extreme::{first, norm, second},
};
use crate::{
    Claim, Fault, Region,
    difference_test::difference_test,
    region::directions,
    report::{LawResult, Tried},
};

/// Checks that `H(x)` is finite and that its two halves agree to rounding.
pub(super) fn finite_and_symmetric<const D: usize>(case: &Case<'_, D>) -> LawResult {
    case.at_points(|x| match check_gram(&case.metric, x) {
        // Positive definiteness is a separate law.
        Ok(_) | Err(MetricError::NotPositiveDefinite { .. }) => Ok(f64::INFINITY),
        Err(error) => Err(error.into()),
    })
}

/// Checks that `H(x)` is positive definite at random points and at the points where descents of its
/// smallest eigenvalue end.
pub(super) fn positive_definite<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let (metric, effort) = (&case.metric, &case.effort);
    let axis = SVector::from_fn(|i, _| if i == 0 { 1.0 } else { 0.0 });
    let tried = case.at_points(|x| {
        check_gram(metric, x)?;
        Ok(f64::INFINITY)
    })?;
    for k in 1..=effort.ascents {
        let start = Claim::C1.measure(metric, &on_winding(&case.region, k), &axis);
        let lowest = Claim::C1.climb(metric, &case.region, start);
        check_gram(metric, &lowest.point).map_err(|error| effort.failure(error))?;
    }
    Ok(tried.and(Tried::cases(effort.ascents as u64)))
}

/// Checks that `H(x)` is a multiple of the identity, if the constants say so.
pub(super) fn isotropic<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let constants = case.metric.constants();
    if !constants.is_isotropic() {
        return Ok(Tried::none("not isotropic"));
    }
    case.at_points(|x| {
        let h = case.metric.gram(x);
        let off = (h - SMatrix::from_diagonal_element(h[(0, 0)])).amax();
        // Each entry has about a dozen roundings.
        let granted = 1e-14 * constants.c2();
        Fault::unless_zero("H(x) = φ(x) I", off, granted, x.as_slice())?;
        Ok(f64::INFINITY)
    })
}

/// Returns the fractional part of the square root of the `i`-th prime.
pub(super) fn winding(i: usize) -> f64 {
    const PRIMES: [f64; 12] = [2., 3., 5., 7., 11., 13., 17., 19., 23., 29., 31., 37.];
    PRIMES[i % PRIMES.len()].sqrt().fract()
}

/// Returns the `k`-th point of an irrational winding through a region. No period of a formula can
/// be in step with it.
pub(super) fn on_winding<const D: usize>(region: &Region<D>, k: usize) -> SVector<f64, D> {
    region.at(&SVector::from_fn(|i, _| (k as f64 * winding(i)).fract()))
}

/// Checks that first and second derivatives by jets agree with central differences.
pub(super) fn jets<const D: usize>(case: &Case<'_, D>) -> LawResult {
    let metric = &case.metric;
    let samples = (case.region.points(), directions::<D>(), directions::<D>());
    case.effort.for_all(samples, |(x, u, w)| {
        let (point, length) = (x.as_slice(), case.region.size());
        // DH may be a small difference of terms that are as large as DH is elsewhere.
        let terms = metric.constants().l_h();
        let form = |t: f64| norm_squared(metric, &(x + w * t), u);
        let slope = |t: f64| u.dot(&(first(metric, &(x + w * t), w) * u));
        let bent = second(metric, x, w);
        let [size, curvature] = [norm(&metric.gram(x)), norm(&bent)];
        let claimed = slope(0.0);
        // Along the line of a step, uᵀHu is of the size of H plus the change due to its slope.
        let size = size + claimed.abs() * length;
        let law = "|uᵀ DH(x)[w] u − its central difference| = O(h²)";
        difference_test(claimed, form, length, size).map_err(|off| off.of(law, point))?;
        let size = terms + claimed.abs().max(norm(&first(metric, x, w))) + curvature * length;
        let law = "|uᵀ D²H(x)[w, w] u − its central difference| = O(h)";
        difference_test(u.dot(&(bent * u)), slope, length, size)
            .map_err(|off| off.of(law, point))?;
        // The gradient is computed with another number type than the derivative along a line.
        let jet = norm_squared(metric, &Jet1::variables(&(*x).into()).into(), u);
        let along = SVector::<f64, D>::from(*jet.gradient()).dot(w);
        // There are D terms of the size of the derivatives, or of the terms whose differences they
        // are.
        let sizes = jet.gradient().iter().map(|g| g.abs()).sum::<f64>() + claimed.abs();
        let granted = 1e-12 * (sizes + terms);
        let law = "∇(uᵀHu)·w = uᵀ DH(x)[w] u";
        Fault::unless_zero(law, (along - claimed).abs(), granted, point)
    })
}
