//! The paper's constants, from metrics and sets to `C`, against reference values that were
//! computed with 40 digits by a program which shares no code with this workspace.
//!
//! Here `c₁`, `c₂`, `L_H` and `d` are not put in: they come from the metric and from the solver.

use std::{
    f64::consts::{FRAC_1_SQRT_2, FRAC_PI_2},
    num::NonZeroUsize,
};

use nalgebra::{SMatrix, SVector};
use tautline::{
    Ball, Bounded, Ends, HalfSpace, KnownDistance, LeftEndpoint, Metric, Rule, Trapezoidal,
    bounds::Setting,
    composition::Product,
    extrapolate,
    gallery::{Constant, Corrugated, Shear, Valleys},
};
use tautline_statements::{
    Statement,
    Statement::{
        ConstantC1_1, ConstantC1_3, ConstantCTra, ConstantCTraSharp, ConstantK1, ConstantK2,
        ConstantK3Bar, ConstantK4Bar, Theorem1_1, Theorem1_3,
    },
    Subject, VerifyError,
};

use super::{Check, Failure, Kind, Outcome, Trial, close::close};

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

pub(super) fn checks() -> Vec<Check> {
    let constants = |name, run| Check::new(name, Kind::Reference, CONSTANTS, run);
    vec![
        constants("golden_constants_of_constant_metrics", constant_metrics),
        constants("golden_constants_of_the_valleys", valleys),
        constants("golden_constants_of_the_shear", sheared),
        constants("golden_constants_of_a_corrugated_metric", corrugated),
        Check::new(
            "golden_distances_by_extrapolation",
            Kind::Reference,
            &[Theorem1_1, Theorem1_3],
            distances,
        ),
    ]
}

/// The numbers of one problem in the plane.
struct Golden {
    c1: f64,
    c2: f64,
    l_h: f64,
    d: f64,
    k1: f64,
    k2: f64,
    /// `C_tra(12)`.
    c_tra_of_12: f64,
    c_tra_sharp: f64,
    k3_bar: f64,
    theorem_1_1: f64,
    k4_bar: f64,
    theorem_1_3: f64,
}

/// `H = I`, from `(0, 0)` to `(3, 4)`.
const IDENTITY: Golden = Golden {
    c1: 1.0,
    c2: 1.0,
    l_h: 0.0,
    d: 5.0,
    k1: 5.0,
    k2: 0.0,
    c_tra_of_12: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 5.0,
    theorem_1_1: 0.0,
    k4_bar: 5.0,
    theorem_1_3: 0.0,
};

/// `H = [[2, 1], [1, 2]]`, from `(0, 0)` to `(3, 4)`.
const OBLIQUE: Golden = Golden {
    c1: 1.0,
    c2: 3.0,
    l_h: 0.0,
    d: 8.60232526704262677173,
    k1: 8.60232526704262677173,
    k2: 0.0,
    c_tra_of_12: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 8.60232526704262677173,
    theorem_1_1: 0.0,
    k4_bar: 8.60232526704262677173,
    theorem_1_3: 0.0,
};

/// `H = [[2, 1], [1, 2]]`, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
const OBLIQUE_FROM_BALL: Golden = Golden {
    c1: 1.0,
    c2: 3.0,
    l_h: 0.0,
    d: 3.06186217847897262275,
    k1: 3.06186217847897262275,
    k2: 0.0,
    c_tra_of_12: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 3.06186217847897262275,
    theorem_1_1: 0.0,
    k4_bar: 3.06186217847897262275,
    theorem_1_3: 0.0,
};

/// The valleys, from `(0, 0)` to `(4π, 0)`.
const ALONG_VALLEYS: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 25.1327412287183459077,
    k1: 25.1327412287183459077,
    k2: 16689.5906426164055344,
    c_tra_of_12: 78637090.0930164601071,
    c_tra_sharp: 10135545463.1137973013,
    k3_bar: 100675.449314957015348,
    theorem_1_1: 1123386942089022.93376,
    k4_bar: 47400039.5425279619925,
    theorem_1_3: 2.34488114882168972497e+23,
};

/// The valleys, from `(0, 0)` to `(2, 3/2)`.
const ACROSS_VALLEYS: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 3.78176205466152140008,
    k1: 3.78176205466152140008,
    k2: 377.880398806113958128,
    c_tra_of_12: 43971.8969517543065726,
    c_tra_sharp: 5239851.42488268681215,
    k3_bar: 2289.07529946197376941,
    theorem_1_1: 13210135110.5917445348,
    k4_bar: 162527.014320882455017,
    theorem_1_3: 9452846476802500.76542,
};

/// The valleys, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`: `d = 5 − sin 3 + sin ½`.
const VALLEYS_FROM_BALL: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 5.33830553054433577817,
    k1: 5.33830553054433577817,
    k2: 752.961582069136101581,
    c_tra_of_12: 169600.872772693672439,
    c_tra_sharp: 20744598.2276501846371,
    k3_bar: 4554.62695784804335246,
    theorem_1_1: 104039861025.494548766,
    k4_bar: 456134.823798028989389,
    theorem_1_3: 208960809125691188.983,
};

/// `H = diag(1 + ½ sin² x₁, 2)`, from `(0.2, 0)` to `(2.5, 1)`.
const ELLIPTIC: Golden = Golden {
    c1: 1.0,
    c2: 2.0,
    l_h: 0.5,
    d: 2.99629471775761329468,
    k1: 2.99629471775761329468,
    k2: 26.9333461069865265431,
    c_tra_of_12: 115.371426194937802355,
    c_tra_sharp: 6704.0947528099130508,
    k3_bar: 81.9333420217042972923,
    theorem_1_1: 75457.1532545614073315,
    k4_bar: 379.762016976880619405,
    theorem_1_3: 13836452.7882198856769,
};

/// The shear by `Φ = (x₁ + ½ sin x₂, x₂)`, from `(0, 0)` to `(2, 3)`.
const SHEARED: Golden = Golden {
    c1: 0.609611796797792431272,
    c2: 1.64038820320220756873,
    l_h: 0.559016994374947424102,
    d: 3.64516374533277156203,
    k1: 4.66863972250296583235,
    k2: 119.923313695680812856,
    c_tra_of_12: 1209.72996813983554231,
    c_tra_sharp: 101018.592246393430246,
    k3_bar: 407.101342692377162805,
    theorem_1_1: 9530170.31177448533165,
    k4_bar: 5576.79746781764716454,
    theorem_1_3: 48497510575.9135915282,
};

/// Compares everything that follows from the constants of `metric` and from `distance`.
///
/// Up to `1e-12`, relatively: `d` is known to some `1e-15`, and enters the last constant, a product
/// of cubes of sums of cubes, with the power 18 at most. `C = 0` is exact.
fn check(
    subject: &Subject,
    golden: &Golden,
    metric: &impl Bounded<2>,
    distance: f64,
) -> Result<(), Failure> {
    let constants = subject.constants(metric);
    let setting = Setting::new(constants, distance, 2).map_err(VerifyError::from)?;
    let (k1, k2) = (subject.k1_g(setting), subject.k2_g(setting));
    // No power of 2, so that no two terms round alike.
    let twelve = NonZeroUsize::new(12).expect("positive");
    for (name, value, expected) in [
        ("c₁", constants.c1(), golden.c1),
        ("c₂", constants.c2(), golden.c2),
        ("L_H", constants.l_h(), golden.l_h),
        ("d", distance, golden.d),
        ("K_{1,g}", k1, golden.k1),
        ("K_{2,g}", k2, golden.k2),
        ("C_tra(12)", subject.c_tra(constants, k1, k2, twelve), golden.c_tra_of_12),
        ("C_tra♯", subject.c_tra_sharp(constants, k1, k2), golden.c_tra_sharp),
        ("K̄_{3,g}", subject.k3_bar_g(setting), golden.k3_bar),
        ("C of Theorem 1.1", subject.theorem_1_1_constant(setting), golden.theorem_1_1),
        ("K̄_{4,g}", subject.k4_bar_g(setting), golden.k4_bar),
        ("C of Theorem 1.3", subject.theorem_1_3_constant(setting), golden.theorem_1_3),
    ] {
        close(name, value, expected, 1e-12 * expected)?;
    }
    Ok(())
}

fn between(
    subject: &Subject,
    golden: &Golden,
    metric: &(impl Bounded<2> + KnownDistance<2>),
    b: [f64; 2],
) -> Result<(), Failure> {
    let distance = metric.distance(&SVector::zeros(), &SVector::from(b)).expect("known");
    check(subject, golden, metric, distance)
}

/// Solves from the ball of radius ½ to `{x₁ ≥ 3}`, where the reference distances have no formula
/// in the library.
fn from_ball(subject: &Subject, metric: &impl Metric<2>) -> Result<f64, VerifyError> {
    let ball = Ball::new([0.0, 0.0], 0.5)?;
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0)?;
    let line = subject.minimise(Trapezoidal, metric, &Ends::new(ball, wall)?, 1024)?;
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
    between(trial.subject, &IDENTITY, &flat, [3.0, 4.0])?;
    between(trial.subject, &OBLIQUE, &oblique(), [3.0, 4.0])?;
    let distance = from_ball(trial.subject, &oblique())?;
    check(trial.subject, &OBLIQUE_FROM_BALL, &oblique(), distance)?;
    Ok(Default::default())
}

fn valleys(trial: &Trial<'_>) -> Outcome {
    between(trial.subject, &ALONG_VALLEYS, &Valleys, [4.0 * std::f64::consts::PI, 0.0])?;
    between(trial.subject, &ACROSS_VALLEYS, &Valleys, [2.0, 1.5])?;
    let distance = from_ball(trial.subject, &Valleys)?;
    check(trial.subject, &VALLEYS_FROM_BALL, &Valleys, distance)?;
    Ok(Default::default())
}

fn sheared(trial: &Trial<'_>) -> Outcome {
    between(trial.subject, &SHEARED, &shear(), [2.0, 3.0])?;
    Ok(Default::default())
}

/// `diag(1 + ½ cos² x₁, 2)`, and two points: the sheet of the golden values, moved by `π/2` along
/// `x₁`.
pub(super) fn corrugated_beside_line() -> (impl Bounded<2> + KnownDistance<2>, [[f64; 2]; 2]) {
    let sheet = Corrugated::new(FRAC_1_SQRT_2, 1.0).expect("a wave number");
    let line = Constant::new(SMatrix::from_diagonal_element(2.0)).expect("positive");
    (Product::<_, _, 1, 1>::new(sheet, line), [[0.2 - FRAC_PI_2, 0.0], [2.5 - FRAC_PI_2, 1.0]])
}

/// The distance is solved for and extrapolated; and the metric knows it, up to some roundings.
fn corrugated(trial: &Trial<'_>) -> Outcome {
    let (metric, [a, b]) = corrugated_beside_line();
    let distance = extrapolated(trial.subject, Trapezoidal, &metric, [a, b], 1000)?;
    check(trial.subject, &ELLIPTIC, &metric, distance)?;
    let known = metric.distance(&a.into(), &b.into()).unwrap_or(f64::NAN);
    close("d by arc length", known, ELLIPTIC.d, 1e-14 * ELLIPTIC.d)?;
    Ok(Default::default())
}

fn extrapolated<R: Rule>(
    subject: &Subject,
    rule: R,
    metric: &impl Metric<2>,
    [a, b]: [[f64; 2]; 2],
    n: usize,
) -> Result<f64, VerifyError> {
    let minimum = subject.minimise(rule, metric, &Ends::points(a, b)?, n)?;
    let estimate = extrapolate(&minimum.levels, R::ERROR_EXPONENT);
    // No grid but one is no estimate, and no distance.
    Ok(estimate.map_or(f64::NAN, |estimate| estimate.value.sqrt()))
}

/// The extrapolated solves reproduce every golden distance.
///
/// Grids 8, 32, 128, 512 and 2048: what is left are terms of `N⁻¹⁰` and of `N⁻⁵` at the product of
/// the grids, with constants up to 10³, and rounding.
fn distances(trial: &Trial<'_>) -> Outcome {
    fn one(
        subject: &Subject,
        golden: &Golden,
        metric: &impl Metric<2>,
        points: [[f64; 2]; 2],
    ) -> Result<(), Failure> {
        let trapezoidal = extrapolated(subject, Trapezoidal, metric, points, 2048)?;
        close("d, trapezoidal", trapezoidal, golden.d, 1e-11 * golden.d)?;
        let left = extrapolated(subject, LeftEndpoint, metric, points, 2048)?;
        close("d, left", left, golden.d, 1e-7 * golden.d)
    }
    one(trial.subject, &OBLIQUE, &oblique(), [[0.0, 0.0], [3.0, 4.0]])?;
    one(trial.subject, &ACROSS_VALLEYS, &Valleys, [[0.0, 0.0], [2.0, 1.5]])?;
    let (corrugated, points) = corrugated_beside_line();
    one(trial.subject, &ELLIPTIC, &corrugated, points)?;
    one(trial.subject, &SHEARED, &shear(), [[0.0, 0.0], [2.0, 3.0]])?;
    Ok(Default::default())
}
