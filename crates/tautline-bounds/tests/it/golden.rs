//! The constants of eight problems in the plane against reference values, which were computed
//! with 40 digits and rounded to 21 by a program that shares no code with this crate.

use approx::assert_relative_eq;
use tautline_bounds::{
    Constants, Setting, c_tra_sharp_g, k1_g, k2_g, k3_bar_g, k4_bar_g, theorem_1_1_constant,
    theorem_1_3_constant,
};

/// A problem in numbers, and what the paper makes of them.
struct Case {
    name: &'static str,
    c1: f64,
    c2: f64,
    l_h: f64,
    distance: f64,
    k1: f64,
    k2: f64,
    c_tra_sharp: f64,
    k3_bar: f64,
    constant_1_1: f64,
    k4_bar: f64,
    constant_1_3: f64,
}

const CASES: [Case; 8] = [
    // `H = I`, from (0, 0) to (3, 4).
    Case {
        name: "identity",
        c1: 1.0,
        c2: 1.0,
        l_h: 0.0,
        distance: 5.0,
        k1: 5.0,
        k2: 0.0,
        c_tra_sharp: 0.0,
        k3_bar: 5.0,
        constant_1_1: 0.0,
        k4_bar: 5.0,
        constant_1_3: 0.0,
    },
    // `H = [[2, 1], [1, 2]]`, from (0, 0) to (3, 4).
    Case {
        name: "oblique",
        c1: 1.0,
        c2: 3.0,
        l_h: 0.0,
        distance: 8.60232526704262677173,
        k1: 8.60232526704262677173,
        k2: 0.0,
        c_tra_sharp: 0.0,
        k3_bar: 8.60232526704262677173,
        constant_1_1: 0.0,
        k4_bar: 8.60232526704262677173,
        constant_1_3: 0.0,
    },
    // `H = [[2, 1], [1, 2]]`, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
    Case {
        name: "oblique, from a ball",
        c1: 1.0,
        c2: 3.0,
        l_h: 0.0,
        distance: 3.06186217847897262275,
        k1: 3.06186217847897262275,
        k2: 0.0,
        c_tra_sharp: 0.0,
        k3_bar: 3.06186217847897262275,
        constant_1_1: 0.0,
        k4_bar: 3.06186217847897262275,
        constant_1_3: 0.0,
    },
    // `H = (2 − cos x₁)² I`, from (0, 0) to (4π, 0).
    Case {
        name: "along the valleys",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        distance: 25.1327412287183459077,
        k1: 25.1327412287183459077,
        k2: 16689.5906426164055344,
        c_tra_sharp: 10135545463.1137973013,
        k3_bar: 100675.449314957015348,
        constant_1_1: 1123386942089022.93376,
        k4_bar: 47400039.5425279619925,
        constant_1_3: 2.34488114882168972497e+23,
    },
    // `H = (2 − cos x₁)² I`, from (0, 0) to (2, 3/2).
    Case {
        name: "across the valleys",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        distance: 3.78176205466152140008,
        k1: 3.78176205466152140008,
        k2: 377.880398806113958128,
        c_tra_sharp: 5239851.42488268681215,
        k3_bar: 2289.07529946197376941,
        constant_1_1: 13210135110.5917445348,
        k4_bar: 162527.014320882455017,
        constant_1_3: 9452846476802500.76542,
    },
    // `H = (2 − cos x₁)² I`, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
    Case {
        name: "valleys, from a ball",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        distance: 5.33830553054433577817,
        k1: 5.33830553054433577817,
        k2: 752.961582069136101581,
        c_tra_sharp: 20744598.2276501846371,
        k3_bar: 4554.62695784804335246,
        constant_1_1: 104039861025.494548766,
        k4_bar: 456134.823798028989389,
        constant_1_3: 208960809125691188.983,
    },
    // `H = diag(1 + ½ sin² x₁, 2)`, from (0.2, 0) to (2.5, 1).
    Case {
        name: "elliptic integral",
        c1: 1.0,
        c2: 2.0,
        l_h: 0.5,
        distance: 2.99629471775761329468,
        k1: 2.99629471775761329468,
        k2: 26.9333461069865265431,
        c_tra_sharp: 6704.0947528099130508,
        k3_bar: 81.9333420217042972923,
        constant_1_1: 75457.1532545614073315,
        k4_bar: 379.762016976880619405,
        constant_1_3: 13836452.7882198856769,
    },
    // `H = [[1, k], [k, 1 + k²]]` with `k = ½ cos x₂`, from (0, 0) to (2, 3).
    Case {
        name: "shear",
        c1: 0.609611796797792431272,
        c2: 1.64038820320220756873,
        l_h: 0.559016994374947424102,
        distance: 3.64516374533277156203,
        k1: 4.66863972250296583235,
        k2: 119.923313695680812856,
        c_tra_sharp: 101018.592246393430246,
        k3_bar: 407.101342692377162805,
        constant_1_1: 9530170.31177448533165,
        k4_bar: 5576.79746781764716454,
        constant_1_3: 48497510575.9135915282,
    },
];

// An input rounded to `f64` is off by 2⁻⁵³. The worst result, C of Theorem 1.3, moves like d⁹,
// L_H⁷ and c₁^−13 at most, and takes some 40 roundings on its way: together below 70 · 2⁻⁵³,
// which is 8e-15. A wrong factor misses even the 1e-12 asked for by ten decades or so.
const TOLERANCE: f64 = 2e-14;

#[test]
fn constants_of_the_paper_have_their_reference_values() {
    for case in &CASES {
        let setting = Constants::new(case.c1, case.c2, case.l_h)
            .map(|constants| Setting::new(constants, case.distance, 2).expect("a distance"))
            .expect("in order");
        let compare = |what: &str, value: f64, reference: f64| {
            println!("{} {what}: {value:e}, reference {reference:e}", case.name);
            assert_relative_eq!(value, reference, max_relative = TOLERANCE);
        };
        compare("K_{1,g}", k1_g(setting), case.k1);
        compare("K_{2,g}", k2_g(setting), case.k2);
        compare("C_tra♯", c_tra_sharp_g(setting), case.c_tra_sharp);
        compare("K̄_{3,g}", k3_bar_g(setting), case.k3_bar);
        compare("C of Theorem 1.1", theorem_1_1_constant(setting), case.constant_1_1);
        compare("K̄_{4,g}", k4_bar_g(setting), case.k4_bar);
        compare("C of Theorem 1.3", theorem_1_3_constant(setting), case.constant_1_3);
    }
}
