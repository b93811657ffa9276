//! Lemma S.1 and Theorems A and B for eight problems in the plane against reference values, which
//! were computed with 40 digits and rounded to 21 by a program that shares no code with this crate.

use std::num::NonZeroUsize;

use tautline_bounds::{
    Constants, PaperRule, Setting, k2_sharp, theorem_a_constant, theorem_a_excess,
    theorem_a_minimum_gap, theorem_b_constant, theorem_b_excess,
};

/// A problem in numbers, and what the theorems make of them with `ω = 3/2`: `C₁` of both rules,
/// `C₂`, the bounds of the excess at `N = 1` and `N = 64`, and `e` at `N = 64`.
struct Case {
    name: &'static str,
    c1: f64,
    c2: f64,
    l_h: f64,
    m_h: f64,
    distance: f64,
    k2_sharp: f64,
    delta: f64,
    mu: f64,
    c1_tra: f64,
    c1_left: f64,
    c2_tra: f64,
    a_tra: [f64; 2],
    a_left: [f64; 2],
    b: [f64; 2],
    e_tra: f64,
    e_left: f64,
}

const CASES: [Case; 8] = [
    // `H = I`, from (0, 0) to (3, 4).
    Case {
        name: "identity",
        c1: 1.0,
        c2: 1.0,
        l_h: 0.0,
        m_h: 0.0,
        distance: 5.0,
        k2_sharp: 0.0,
        delta: 0.0,
        mu: 0.0,
        c1_tra: 0.0,
        c1_left: 0.0,
        c2_tra: 0.0,
        a_tra: [0.0, 0.0],
        a_left: [0.0, 0.0],
        b: [0.0, 0.0],
        e_tra: 1.0,
        e_left: 1.0,
    },
    // `H = [[2, 1], [1, 2]]`, from (0, 0) to (3, 4).
    Case {
        name: "oblique",
        c1: 1.0,
        c2: 3.0,
        l_h: 0.0,
        m_h: 0.0,
        distance: 8.60232526704262677173,
        k2_sharp: 0.0,
        delta: 0.0,
        mu: 0.0,
        c1_tra: 0.0,
        c1_left: 0.0,
        c2_tra: 0.0,
        a_tra: [0.0, 0.0],
        a_left: [0.0, 0.0],
        b: [0.0, 0.0],
        e_tra: 1.0,
        e_left: 1.0,
    },
    // `H = [[2, 1], [1, 2]]`, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
    Case {
        name: "oblique, from a ball",
        c1: 1.0,
        c2: 3.0,
        l_h: 0.0,
        m_h: 0.0,
        distance: 3.06186217847897262275,
        k2_sharp: 0.0,
        delta: 0.0,
        mu: 0.0,
        c1_tra: 0.0,
        c1_left: 0.0,
        c2_tra: 0.0,
        a_tra: [0.0, 0.0],
        a_left: [0.0, 0.0],
        b: [0.0, 0.0],
        e_tra: 1.0,
        e_left: 1.0,
    },
    // The valleys, from (0, 0) to (4π, 0).
    Case {
        name: "along the valleys",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        m_h: 6.0,
        distance: 25.1327412287183459077,
        k2_sharp: 4172.3976606541013836,
        delta: 110.676285373026788735,
        mu: 3789.92809001831370963,
        c1_tra: 158136645.739805708774,
        c1_left: 314338969.008652326685,
        c2_tra: 896086884685.67194368,
        a_tra: [476940.295641739655954, 5812.1097587435424396],
        a_left: [948827.353830121560295, 11671.5047983993711711],
        b: [8084552.88417765590575, 5593.4381959514445589],
        e_tra: 1.80614638280392738228,
        e_left: 1.86465847947677178699,
    },
    // The valleys, from (0, 0) to (2, 3/2).
    Case {
        name: "across the valleys",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        m_h: 6.0,
        distance: 3.78176205466152140008,
        k2_sharp: 94.4700997015284895321,
        delta: 16.6536301219835887045,
        mu: 85.8103454284663918433,
        c1_tra: 82484.438114057740566,
        c1_left: 163977.25403504695522,
        c2_tra: 10758654.7525872219119,
        a_tra: [1722.09926648561207639, 9.33009516661246021739],
        a_left: [3329.78473906660229698, 19.7444061752205996208],
        b: [4256.33494659052853966, 1.35211449026135146437],
        e_tra: 1.07351709142620051495,
        e_left: 1.13010648532799678675,
    },
    // The valleys, from the ball of radius ½ about 0 to `{x₁ ≥ 3}`.
    Case {
        name: "valleys, from a ball",
        c1: 1.0,
        c2: 9.0,
        l_h: 4.40366947504161167615,
        m_h: 6.0,
        distance: 5.33830553054433577817,
        k2_sharp: 188.240395517284025395,
        delta: 23.5081331133039074414,
        mu: 170.985035624641453739,
        c1_tra: 325568.061042714616795,
        c1_left: 647198.961362706619835,
        c2_tra: 84137357.2807838202631,
        a_tra: [4749.96139757748921318, 27.5369998451663284264],
        a_left: [9271.94274765545648805, 59.1530414088310791113],
        b: [16673.1639017519696541, 5.59853753566805164658],
        e_tra: 1.10869364504930773366,
        e_left: 1.18365728994768677689,
    },
    // `H = diag(1 + ½ sin² x₁, 2)`, from (0.2, 0) to (2.5, 1).
    Case {
        name: "elliptic",
        c1: 1.0,
        c2: 2.0,
        l_h: 0.5,
        m_h: 1.0,
        distance: 2.99629471775761329468,
        k2_sharp: 6.73333652674663163576,
        delta: 1.49814735887880664734,
        mu: 8.97778203566217551435,
        c1_tra: 26.8404929981107435358,
        c1_left: 53.1035500617759975388,
        c2_tra: 92.269944660714009042,
        a_tra: [13.0410140518818320525, 0.185806959991625225852],
        a_left: [22.2813002162861107646, 0.373136668650456555465],
        b: [15.0809305633940728399, 0.00840136054153099435065],
        e_tra: 1.00592063316178597396,
        e_left: 1.01170427624124067693,
    },
    // The shear by `Φ = (x₁ + ½ sin x₂, x₂)`, from (0, 0) to (2, 3).
    Case {
        name: "shear",
        c1: 0.609611796797792431272,
        c2: 1.64038820320220756873,
        l_h: 0.559016994374947424102,
        m_h: 0.809016994374947424102,
        distance: 3.64516374533277156203,
        k2_sharp: 29.9808284239202032139,
        delta: 4.28116542232659681464,
        mu: 28.9257749996325963221,
        c1_tra: 548.280014991241636759,
        c1_left: 1035.67674019982402289,
        c2_tra: 7601.29625379990369196,
        a_tra: [85.2404578375466846885, 1.44209722498150908244],
        a_left: [148.013910203971964684, 2.94330865092338469206],
        b: [138.423317951517088909, 0.143461043675911394083],
        e_tra: 1.01728264011935819276,
        e_left: 1.03344660486192653761,
    },
];

#[test]
fn the_bounds_are_those_of_the_reference() {
    for case in &CASES {
        let constants =
            Constants::new(case.c1, case.c2, case.l_h).and_then(|c| c.with_m_h(case.m_h));
        let setting = Setting::new(constants.expect("in order"), case.distance, 2).expect("valid");
        let close = |what: &str, value: f64, expected: f64| {
            // The inputs are rounded, and enter with powers up to 9.
            let off = (value - expected).abs();
            assert!(off <= 1e-12 * expected, "{}, {what}: {value} is not {expected}", case.name);
        };
        let second = |bound: Option<f64>| bound.expect("M_H is known");
        let (tra, left) = (PaperRule::Trapezoidal, PaperRule::LeftEndpoint);
        close("K₂", k2_sharp(setting), case.k2_sharp);
        close("δ", setting.delta(), case.delta);
        close("μ", setting.mu().expect("M_H is known"), case.mu);
        close("C₁, trapezoidal", theorem_a_constant(setting, tra), case.c1_tra);
        close("C₁, left", theorem_a_constant(setting, left), case.c1_left);
        close("C₂", second(theorem_b_constant(setting)), case.c2_tra);
        for (k, n) in [1, 64].into_iter().enumerate() {
            let n = NonZeroUsize::new(n).expect("positive");
            close("Theorem A, trapezoidal", theorem_a_excess(setting, tra, n), case.a_tra[k]);
            close("Theorem A, left", theorem_a_excess(setting, left, n), case.a_left[k]);
            close("Theorem B", second(theorem_b_excess(setting, n)), case.b[k]);
        }
        let n = NonZeroUsize::new(64).expect("positive");
        let d2 = case.distance * case.distance;
        close("e, trapezoidal", 1.0 + theorem_a_minimum_gap(setting, tra, n) / d2, case.e_tra);
        close("e, left", 1.0 + theorem_a_minimum_gap(setting, left, n) / d2, case.e_left);
    }
}
