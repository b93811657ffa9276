//! The laws of a rule of numerical integration.

use tautline::{
    Curvature, Options, PointSequence, SMatrix, Stop, energy_gradient,
    gallery::{Constant, Shear},
    minimise,
};
use tautline_statements::{Known, VerifyError};

use super::RuleCase;
use crate::{
    Failure, Fault, Region,
    difference_test::difference_test,
    order::order,
    report::{LawResult, Tried},
};

/// The grids of the fit. They are beyond the first terms of the expansion in `1/N`, and the errors
/// on them are far above rounding.
const WINDOW: [usize; 4] = [128, 256, 512, 1024];

/// The amount by which a slope may be below its exponent. The next term of the expansion is smaller
/// by a factor of about `10/N`, which tilts the line by less than 0.05 over the window.
const TILT: f64 = 0.05;

/// Checks an inequality about the nodes, which does not involve a point.
fn check(case: &RuleCase, law: &'static str, pair: [f64; 2], granted: f64) -> Result<f64, Failure> {
    Fault::unless_at_most(law, pair, granted, &[]).map_err(|fault| case.effort.failure(fault))
}

/// Checks that the weights are nonnegative and add up to 1.
pub(super) fn weights(case: &RuleCase) -> LawResult {
    for node in case.rule.nodes() {
        check(case, "0 ≤ weight", [-node.weight, 0.0], 0.0)?;
    }
    let sum: f64 = case.rule.nodes().iter().map(|node| node.weight).sum();
    // Each weight is rounded, and so is each addition of numbers up to 1.
    let granted = 2.0 * case.rule.nodes().len() as f64 * f64::EPSILON;
    check(case, "|Σ weights − 1| = 0", [(sum - 1.0).abs(), 0.0], granted)?;
    Ok(Tried::cases(case.rule.nodes().len() as u64))
}

/// Checks that all nodes lie on the chord.
pub(super) fn nodes(case: &RuleCase) -> LawResult {
    for node in case.rule.nodes() {
        check(case, "0 ≤ fraction", [-node.fraction, 0.0], 0.0)?;
        check(case, "fraction ≤ 1", [node.fraction, 1.0], 0.0)?;
    }
    Ok(Tried::cases(case.rule.nodes().len() as u64))
}

/// Returns the region in which the random sequences of the laws below lie.
fn region() -> Region<2> {
    Region::cell([-2.0, -2.0], [2.0, 2.0])
}

/// Checks that under a constant metric the discrete energy is `(1/N) Σ βᵀAβ`, the energy of the
/// curve.
pub(super) fn constant_metrics(case: &RuleCase) -> LawResult {
    let matrix = SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 3.0);
    let metric = Constant::new(matrix).expect("positive definite");
    let points = proptest::collection::vec(region().uniform(), 2..=9);
    case.effort.for_all(points, |points| {
        let sequence = PointSequence::new(points.clone()).map_err(VerifyError::from)?;
        let n = sequence.n().get() as f64;
        let exact = sequence.differences().map(|beta| beta.dot(&(matrix * beta))).sum::<f64>() / n;
        let energy = case.rule.energy(&metric, &sequence);
        let law = "|E_N − (1/N) Σ βᵀAβ| = 0 for constant A";
        let point: Vec<f64> = points.iter().flatten().copied().collect();
        // Each term has about a dozen roundings, and each node adds as many.
        let granted = 1e-14 * (1 + case.rule.nodes().len()) as f64 * exact;
        Fault::unless_zero(law, (energy - exact).abs(), granted, &point)
    })
}

/// Checks that the gradient with respect to the `N + 1` points is the gradient of the energy.
pub(super) fn gradient(case: &RuleCase) -> LawResult {
    gradient_of(case, |metric, sequence| case.rule.energy(metric, sequence))
}

/// Does the same for an energy that is claimed to be the one of the rule.
pub(super) fn gradient_of(
    case: &RuleCase,
    energy_of: impl Fn(&Shear, &PointSequence<2>) -> f64,
) -> LawResult {
    let metric = shear();
    let points = proptest::collection::vec((region().uniform(), region().uniform()), 2..=9);
    case.effort.for_all(points, |pairs| {
        let at = |t: f64| -> Result<PointSequence<2>, VerifyError> {
            Ok(PointSequence::new(pairs.iter().map(|(x, v)| x + v * t).collect())?)
        };
        let start = at(0.0)?;
        let (energy, gradient) = energy_gradient(case.rule, &metric, &start);
        let own = energy_of(&metric, &start);
        let point: Vec<f64> = pairs.iter().flat_map(|(x, _)| x).copied().collect();
        let law = "the energy beside the gradient is the energy";
        // Both are sums of the same terms, with about a dozen roundings each.
        Fault::unless_zero(law, (energy - own).abs(), 1e-13 * own.abs(), &point)?;
        let along: f64 = gradient.iter().zip(pairs).map(|(g, (_, v))| g.dot(v)).sum();
        let terms: f64 = gradient.iter().zip(pairs).map(|(g, (_, v))| g.norm() * v.norm()).sum();
        // The steps are at most 1/16, so all points are finite.
        let line = |t: f64| at(t).map_or(f64::NAN, |s| energy_of(&metric, &s));
        let law = "|∇E_N·v − its central difference| = O(h²)";
        difference_test(along, line, 1.0, own + terms).map_err(|off| off.of(law, &point))?;
        Ok(f64::INFINITY)
    })
}

/// Returns the shear of amplitude ½, on which no symmetry hides an order.
fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("a wave number")
}

/// Checks that `E_N,min − d²` falls at least like `N⁻ᑫ` with the claimed `q`, on a shear from
/// `(0, 0)` to `(2, 3)`.
pub(super) fn exponent(case: &RuleCase) -> LawResult {
    let metric = shear();
    let known = Known::between(metric, [0.0, 0.0], [2.0, 3.0]).expect("finite");
    let known = known.expect("a shear knows its distances");
    let d2 = known.distance.powi(2);
    let mut errors = Vec::new();
    for n in WINDOW {
        let minimum = minimise(&metric, &known.ends, case.rule, n, &Options::default())
            .map_err(|error| case.effort.failure(VerifyError::from(error)))?;
        let saddle = matches!(minimum.curvature, Curvature::Indefinite { .. });
        if minimum.stop != Stop::Converged || saddle {
            let (stop, curvature) = (minimum.stop, minimum.curvature);
            return Err(case.effort.failure(VerifyError::NotConverged { n, stop, curvature }));
        }
        let error = (minimum.energy - d2).abs();
        // This is ten times the rounding of sums of N terms and of the points, about 10⁻¹³ d².
        if !(error <= 1e-12 * d2) {
            errors.push((n, error));
        }
    }
    let tried = Tried::cases(WINDOW.len() as u64);
    if errors.len() < 3 {
        return Ok(tried.with_note("observed exact"));
    }
    let (found, least) = (order(&errors), f64::from(case.rule.error_exponent()) - TILT);
    if found >= least {
        return Ok(tried.with_note(format!("observed {found:.3} over {WINDOW:?}")));
    }
    let (what, window) = ("|E_N − d²|", WINDOW.to_vec());
    Err(case.effort.failure(Fault::Order { what, found, least, window }))
}
