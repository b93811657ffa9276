//! The paper's constants, from metrics and sets to `C`, against reference values that were
//! computed with 40 digits by a program which shares no code with this workspace.
//!
//! Here `c₁`, `c₂`, `L_H` and `d` are not put in: they come from the metric and from the solver.

use approx::assert_relative_eq;
use tautline::{
    Ball, Bounded, Ends, HalfSpace, KnownDistance, LeftEndpoint, Metric, Problem, SMatrix, SVector,
    Trapezoidal,
    bounds::{
        Setting, c_tra_sharp_g, k1_g, k2_g, k3_bar_g, k4_bar_g, theorem_1_1_constant,
        theorem_1_3_constant,
    },
    gallery::{Constant, Shear, Valleys},
};

use crate::own::Corrugated;

/// The numbers of one problem in the plane.
struct Golden {
    c1: f64,
    c2: f64,
    l_h: f64,
    d: f64,
    k1: f64,
    k2: f64,
    c_tra_sharp: f64,
    k3_bar: f64,
    theorem_1_1: f64,
    k4_bar: f64,
    theorem_1_3: f64,
}

/// `H = I`, from `(0, 0)` to `(3, 4)`.
const G1A: Golden = Golden {
    c1: 1.0,
    c2: 1.0,
    l_h: 0.0,
    d: 5.0,
    k1: 5.0,
    k2: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 5.0,
    theorem_1_1: 0.0,
    k4_bar: 5.0,
    theorem_1_3: 0.0,
};

/// `H = [[2, 1], [1, 2]]`, from `(0, 0)` to `(3, 4)`.
const G1B: Golden = Golden {
    c1: 1.0,
    c2: 3.0,
    l_h: 0.0,
    d: 8.60232526704262677173,
    k1: 8.60232526704262677173,
    k2: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 8.60232526704262677173,
    theorem_1_1: 0.0,
    k4_bar: 8.60232526704262677173,
    theorem_1_3: 0.0,
};

/// `H = [[2, 1], [1, 2]]`, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
const G1C: Golden = Golden {
    c1: 1.0,
    c2: 3.0,
    l_h: 0.0,
    d: 3.06186217847897262275,
    k1: 3.06186217847897262275,
    k2: 0.0,
    c_tra_sharp: 0.0,
    k3_bar: 3.06186217847897262275,
    theorem_1_1: 0.0,
    k4_bar: 3.06186217847897262275,
    theorem_1_3: 0.0,
};

/// The valleys, from `(0, 0)` to `(4π, 0)`.
const G2A: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 25.1327412287183459077,
    k1: 25.1327412287183459077,
    k2: 16689.5906426164055344,
    c_tra_sharp: 10135545463.1137973013,
    k3_bar: 100675.449314957015348,
    theorem_1_1: 1123386942089022.93376,
    k4_bar: 47400039.5425279619925,
    theorem_1_3: 2.34488114882168972497e+23,
};

/// The valleys, from `(0, 0)` to `(2, 3/2)`.
const G2B: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 3.78176205466152140008,
    k1: 3.78176205466152140008,
    k2: 377.880398806113958128,
    c_tra_sharp: 5239851.42488268681215,
    k3_bar: 2289.07529946197376941,
    theorem_1_1: 13210135110.5917445348,
    k4_bar: 162527.014320882455017,
    theorem_1_3: 9452846476802500.76542,
};

/// The valleys, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`: `d = 5 − sin 3 + sin ½`.
const G2C: Golden = Golden {
    c1: 1.0,
    c2: 9.0,
    l_h: 4.40366947504161167615,
    d: 5.33830553054433577817,
    k1: 5.33830553054433577817,
    k2: 752.961582069136101581,
    c_tra_sharp: 20744598.2276501846371,
    k3_bar: 4554.62695784804335246,
    theorem_1_1: 104039861025.494548766,
    k4_bar: 456134.823798028989389,
    theorem_1_3: 208960809125691188.983,
};

/// `H = diag(1 + ½ sin² x₁, 2)`, from `(0.2, 0)` to `(2.5, 1)`.
const G3A: Golden = Golden {
    c1: 1.0,
    c2: 2.0,
    l_h: 0.5,
    d: 2.99629471775761329468,
    k1: 2.99629471775761329468,
    k2: 26.9333461069865265431,
    c_tra_sharp: 6704.0947528099130508,
    k3_bar: 81.9333420217042972923,
    theorem_1_1: 75457.1532545614073315,
    k4_bar: 379.762016976880619405,
    theorem_1_3: 13836452.7882198856769,
};

/// The shear by `Φ = (x₁ + ½ sin x₂, x₂)`, from `(0, 0)` to `(2, 3)`.
const G4A: Golden = Golden {
    c1: 0.609611796797792431272,
    c2: 1.64038820320220756873,
    l_h: 0.559016994374947424102,
    d: 3.64516374533277156203,
    k1: 4.66863972250296583235,
    k2: 119.923313695680812856,
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
#[track_caller]
fn check(golden: &Golden, metric: &impl Bounded<2>, distance: f64) {
    let constants = metric.constants();
    let setting = Setting::new(constants, distance, 2).expect("a distance");
    for (name, value, expected) in [
        ("c₁", constants.c1(), golden.c1),
        ("c₂", constants.c2(), golden.c2),
        ("L_H", constants.l_h(), golden.l_h),
        ("d", distance, golden.d),
        ("K_{1,g}", k1_g(setting), golden.k1),
        ("K_{2,g}", k2_g(setting), golden.k2),
        ("C_tra♯", c_tra_sharp_g(setting), golden.c_tra_sharp),
        ("K̄_{3,g}", k3_bar_g(setting), golden.k3_bar),
        ("C of Theorem 1.1", theorem_1_1_constant(setting), golden.theorem_1_1),
        ("K̄_{4,g}", k4_bar_g(setting), golden.k4_bar),
        ("C of Theorem 1.3", theorem_1_3_constant(setting), golden.theorem_1_3),
    ] {
        let error = (value - expected).abs();
        assert!(error <= 1e-12 * expected, "{name}: {value:.17e} is not {expected:.17e}");
    }
}

#[track_caller]
fn between(golden: &Golden, metric: &(impl Bounded<2> + KnownDistance<2>), b: [f64; 2]) {
    let distance = metric.distance(&SVector::zeros(), &SVector::from(b)).expect("known");
    check(golden, metric, distance);
}

/// Solves from the ball of radius ½ to `{x₁ ≥ 3}`, where the reference distances have no formula
/// in the library.
fn from_ball(metric: impl Metric<2>) -> f64 {
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
    let ends = Ends::new(ball, wall).expect("bounded");
    let line = Problem::new(metric, ends).solve(Trapezoidal, 1024).expect("a metric");
    // Both reconstructions are straight lines along which the length is exact.
    line.length().value
}

fn oblique() -> Constant<2> {
    Constant::new(SMatrix::<f64, 2, 2>::new(2.0, 1.0, 1.0, 2.0)).expect("positive definite")
}

#[test]
fn golden_constants_of_constant_metrics() {
    let flat = Constant::new(SMatrix::<f64, 2, 2>::identity()).expect("positive definite");
    between(&G1A, &flat, [3.0, 4.0]);
    between(&G1B, &oblique(), [3.0, 4.0]);
    check(&G1C, &oblique(), from_ball(oblique()));
}

#[test]
fn golden_constants_of_the_valleys() {
    between(&G2A, &Valleys, [4.0 * std::f64::consts::PI, 0.0]);
    between(&G2B, &Valleys, [2.0, 1.5]);
    check(&G2C, &Valleys, from_ball(Valleys));
}

#[test]
fn golden_constants_of_the_shear() {
    between(&G4A, &Shear::new(0.5, 1.0).expect("valid"), [2.0, 3.0]);
}

/// A user's metric knows no distance: it is solved for and extrapolated.
#[test]
fn golden_constants_of_a_metric_of_ones_own() {
    let ends = Ends::points([0.2, 0.0], [2.5, 1.0]).expect("finite");
    let problem = Problem::new(Corrugated, ends);
    let line = problem.solve(Trapezoidal, 1000).expect("a metric");
    let d2 = line.distance_squared_estimate().expect("several grids");
    check(&G3A, &Corrugated, d2.value.sqrt());
}

/// The extrapolated solves reproduce every golden distance.
#[test]
fn golden_distances_by_extrapolation() {
    fn extrapolated(metric: impl Metric<2>, a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
        let problem = Problem::new(metric, Ends::points(a, b).expect("finite"));
        let trapezoidal = problem.solve(Trapezoidal, 2048).expect("a metric");
        let left = problem.solve(LeftEndpoint, 2048).expect("a metric");
        let value = |estimate: Option<tautline::Estimate>| estimate.expect("several grids").value;
        [
            value(trapezoidal.distance_squared_estimate()).sqrt(),
            value(left.distance_squared_estimate()).sqrt(),
        ]
    }
    let origin = [0.0, 0.0];
    let shear = Shear::new(0.5, 1.0).expect("valid");
    for (golden, [trapezoidal, left]) in [
        (G1B, extrapolated(oblique(), origin, [3.0, 4.0])),
        (G2B, extrapolated(Valleys, origin, [2.0, 1.5])),
        (G3A, extrapolated(Corrugated, [0.2, 0.0], [2.5, 1.0])),
        (G4A, extrapolated(shear, origin, [2.0, 3.0])),
    ] {
        // Grids 8, 32, 128, 512 and 2048: what is left are terms of N⁻¹⁰ and of N⁻⁵ at the
        // product of the grids, with constants up to 10³, and rounding.
        assert_relative_eq!(trapezoidal, golden.d, max_relative = 1e-11);
        assert_relative_eq!(left, golden.d, max_relative = 1e-7);
    }
}
