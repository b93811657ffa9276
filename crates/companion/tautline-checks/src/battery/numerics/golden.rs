//! Compares the paper's constants, from metrics and sets to `C`, with the reference values of
//! `golden_constants.csv`. `c₁`, `c₂` and `L_H` come from the metric, and `d` comes from the metric
//! or from the solver.

use std::{
    f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2},
    num::NonZeroUsize,
};

use nalgebra::{SMatrix, SVector};
use tautline::{
    Ball, Bounded, Ends, HalfSpace, KnownDistance, Metric, Rule,
    bounds::Setting,
    composition::Product,
    extrapolate,
    gallery::{Constant, Corrugated, Shear, Valleys},
};
use tautline_statements::{
    Statement::{
        self, ConstantC1_1, ConstantC1_3, ConstantCTra, ConstantCTraSharp, ConstantK1, ConstantK2,
        ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_3,
    },
    Subject, VerifyError,
};

use crate::battery::harness::{Check, Golden, Outcome, Reference, Trial};

const CONSTANTS: &[Statement] = &[
    ConstantK1,
    ConstantK2,
    ConstantCTra,
    ConstantCTraSharp,
    ConstantK3Bar,
    ConstantC1_1,
    ConstantK4Bar,
    ConstantC1_3,
];

pub(crate) const CHECKS: &[Check] = &[
    Reference.check("golden_constants_of_constant_metrics", CONSTANTS, constant_metrics),
    Reference.check("golden_constants_of_the_valleys", CONSTANTS, valleys),
    Reference.check("golden_constants_of_the_shear", CONSTANTS, sheared),
    Reference.check("golden_constants_of_a_corrugated_metric", CONSTANTS, corrugated),
    Reference.check("golden_distances_by_extrapolation", &[Theorem1_1, Theorem1_3], distances),
];

/// Returns the reference values of a problem.
fn golden(problem: &str) -> Golden {
    Golden::of(include_str!("golden_constants.csv"), problem)
}

/// Compares everything that follows from the constants of `metric` and from `distance`.
///
/// The relative tolerance is `10⁻¹²`: `d` is known to some `10⁻¹⁵`, and it enters the last
/// constant, a product of cubes of sums of cubes, with powers up to 18. If `C = 0`, it is exact.
fn check(subject: &Subject, problem: &str, metric: &impl Bounded<2>, distance: f64) -> Outcome {
    let constants = subject.constants(metric);
    let setting = Setting::new(constants, distance, 2)?;
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    // 12 is not a power of 2, so that no two terms have the same rounding errors.
    let twelve = NonZeroUsize::new(12).expect("positive");
    let computed = [
        ("c1", constants.c1()),
        ("c2", constants.c2()),
        ("l_h", constants.l_h()),
        ("d", distance),
        ("k1", k1),
        ("k2", k2),
        ("c_tra_of_12", subject.c_tra(constants, k1, k2, twelve)),
        ("c_tra_sharp", subject.c_tra_sharp(constants, k1, k2)),
        ("k3_bar", subject.k3_bar_g(setting)),
        ("theorem_1_1", subject.theorem_1_1_constant(setting)),
        ("k4_bar", subject.k4_bar_g(setting)),
        ("theorem_1_3", subject.theorem_1_3_constant(setting)),
    ];
    golden(problem).agrees(&computed, 1e-12)
}

fn between(
    subject: &Subject,
    problem: &str,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    b: [f64; 2],
) -> Outcome {
    let distance = metric.distance(&SVector::zeros(), &SVector::from(b)).expect("known");
    check(subject, problem, metric, distance)
}

/// Solves from the ball of radius ½ to `{x₁ ≥ 3}`, since the library has no formula for this
/// distance.
fn from_ball(subject: &Subject, metric: &impl Metric<2>) -> Result<f64, VerifyError> {
    let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::at_least([1.0, 0.0], 3.0)?)?;
    let line = subject.minimise(Rule::TRAPEZOIDAL, metric, &ends, 1024)?;
    // Both reconstructions are straight lines along which the length is exact.
    Ok(subject.curve_length(metric, &line.sequence).value)
}

fn oblique() -> Constant<2> {
    Constant::new(SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0)).expect("positive definite")
}

fn shear() -> Shear {
    Shear::new(0.5, 1.0).expect("valid")
}

fn constant_metrics(trial: &Trial<'_>) -> Outcome {
    let flat = Constant::new(SMatrix::<f64, 2, 2>::identity()).expect("positive definite");
    between(trial.subject, "identity", &flat, [3.0, 4.0])?;
    between(trial.subject, "oblique", &oblique(), [3.0, 4.0])?;
    let distance = from_ball(trial.subject, &oblique())?;
    check(trial.subject, "oblique-from-ball", &oblique(), distance)
}

fn valleys(trial: &Trial<'_>) -> Outcome {
    between(trial.subject, "along-valleys", &Valleys, [4.0 * std::f64::consts::PI, 0.0])?;
    between(trial.subject, "across-valleys", &Valleys, [2.0, 1.5])?;
    let distance = from_ball(trial.subject, &Valleys)?;
    check(trial.subject, "valleys-from-ball", &Valleys, distance)
}

fn sheared(trial: &Trial<'_>) -> Outcome {
    between(trial.subject, "sheared", &shear(), [2.0, 3.0])
}

/// Returns `diag(1 + ½ cos² x₁, 2)` and two points. This is the elliptic problem of the reference,
/// shifted by `π/2` along `x₁`.
pub(crate) fn corrugated_beside_line() -> (impl Bounded<2> + KnownDistance<2>, [[f64; 2]; 2]) {
    let sheet = Corrugated::new(FRAC_1_SQRT_2, 1.0).expect("a wave number");
    let line = Constant::new(SMatrix::from_diagonal_element(2.0)).expect("positive");
    (Product::<_, _, 1, 1>::new(sheet, line), [[0.2 - FRAC_PI_2, 0.0], [2.5 - FRAC_PI_2, 1.0]])
}

/// The distance comes from an extrapolated solve; the metric knows it too, to within a few
/// roundings.
fn corrugated(trial: &Trial<'_>) -> Outcome {
    let (metric, [a, b]) = corrugated_beside_line();
    let distance = extrapolated(trial.subject, Rule::TRAPEZOIDAL, &metric, [a, b], 1000)?;
    check(trial.subject, "elliptic", &metric, distance)?;
    let known = metric.distance(&a.into(), &b.into()).unwrap_or(f64::NAN);
    golden("elliptic").agrees(&[("d", known)], 1e-14)
}

fn extrapolated(
    subject: &Subject,
    rule: Rule,
    metric: &impl Metric<2>,
    [a, b]: [[f64; 2]; 2],
    n: usize,
) -> Result<f64, VerifyError> {
    let minimum = subject.minimise(rule, metric, &Ends::points(a, b)?, n)?;
    let estimate = extrapolate(&minimum.levels, rule.error_exponent());
    // A single grid gives no estimate.
    Ok(estimate.map_or(f64::NAN, |estimate| estimate.value.sqrt()))
}

/// The extrapolated solves reproduce the reference distances.
///
/// On the grids 8, 32, 128, 512 and 2048 the remaining error is of order `N⁻¹⁰` or `N⁻⁵`, evaluated
/// at the product of the grids, with constants up to 10³, plus rounding.
fn distances(trial: &Trial<'_>) -> Outcome {
    fn one(trial: &Trial<'_>, name: &str, metric: &impl Metric<2>, ends: [[f64; 2]; 2]) -> Outcome {
        let trapezoidal = extrapolated(trial.subject, Rule::TRAPEZOIDAL, metric, ends, 2048)?;
        golden(name).agrees(&[("d", trapezoidal)], 1e-11)?;
        let left = extrapolated(trial.subject, Rule::LEFT_ENDPOINT, metric, ends, 2048)?;
        golden(name).agrees(&[("d", left)], 1e-7)
    }
    one(trial, "oblique", &oblique(), [[0.0, 0.0], [3.0, 4.0]])?;
    one(trial, "across-valleys", &Valleys, [[0.0, 0.0], [2.0, 1.5]])?;
    let (corrugated, ends) = corrugated_beside_line();
    one(trial, "elliptic", &corrugated, ends)?;
    one(trial, "sheared", &shear(), [[0.0, 0.0], [2.0, 3.0]])
}
