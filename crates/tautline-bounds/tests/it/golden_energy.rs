//! Lemma S.1 and Theorems C and D for seven settings against reference values, which were computed
//! with 45 digits and rounded to 21 by a program that shares no code with this crate: it solves the
//! equations of the theorems for their unknowns as they stand, where the crate avoids cancellation.

use std::num::NonZeroUsize;

use tautline_bounds::{
    Constants, PaperRule, Setting, Spread, theorem_c_deficit, theorem_c_excess,
    theorem_c_length_excess, theorem_d_deficit, theorem_d_excess, theorem_d_length_excess,
    theorem_d_minimum_gap,
};

/// A setting in numbers, and what the theorems make of it for `N = 1`, `3` and `40`.
struct Case {
    name: &'static str,
    /// `c₁`, `c₂`, `L_H` and `M_H`, all of them doubles, as is the distance.
    c: [f64; 4],
    distance: f64,
    dimension: usize,
    isotropic: bool,
    local: bool,
    bend: f64,
    /// Of Theorem C the deficit, the excess of the energy and that of the squared length, each for
    /// the trapezoidal and the left-endpoint rule; of Theorem D the deficit, the gap of the minimum,
    /// the excess of the energy and that of the squared length.
    bounds: [[f64; 10]; 3],
}

#[rustfmt::skip]
const CASES: [Case; 7] = [
    Case {
        name: "plane, global",
        c: [2.0, 7.0, 3.0, 5.0],
        distance: 1.5,
        dimension: 2,
        isotropic: false,
        local: false,
        bend: 2.38648538650459789485,
        bounds: [
            [0.574886952362108057923, 0.864696460589553302813, 3.61531322463144542813, 6.09608578388915771634, 3.61531322463144542813, 6.09608578388915771634, 0.215568342200810366221, 1.60684608243922421057, 2.38159929616978624575, 2.38159929616978624575],
            [0.25, 0.432977602885518642568, 0.982060736373342027059, 2.06717268539380173333, 0.753844935433053077957, 1.44564455792081805617, 0.0285578993435697544377, 0.260868018140193174197, 0.324733230965154107498, 0.297352151268198159376],
            [0.0220452899838856541975, 0.0434565261866104349247, 0.0466127365160501259364, 0.095791780198974200952, 0.0455327550619067843168, 0.0908346556374365384329, 0.000164770786413103941649, 0.000875872876654759382327, 0.00104114353495087388676, 0.00104079612519311362962],
        ],
    },
    Case {
        name: "plane, c2 caps",
        c: [2.0, 2.25, 3.0, 5.0],
        distance: 1.5,
        dimension: 2,
        isotropic: false,
        local: false,
        bend: 2.38648538650459789485,
        bounds: [
            [0.574886952362108057923, 0.864696460589553302813, 1.34912109375, 2.4169921875, 1.34912109375, 2.4169921875, 0.215568342200810366221, 0.28125, 0.614959716796875, 0.614959716796875],
            [0.25, 0.432977602885518642568, 0.823409573430555009623, 1.5143213268727651826, 0.63720703125, 0.9931640625, 0.0285578993435697544377, 0.204431910537044596892, 0.260037409619468531781, 0.239294387408934220107],
            [0.0220452899838856541975, 0.0434565261866104349247, 0.0466127365160501259364, 0.095791780198974200952, 0.0455327550619067843168, 0.0908346556374365384329, 0.000164770786413103941649, 0.000875872876654759382327, 0.00104114353495087388676, 0.00104079612519311362962],
        ],
    },
    Case {
        name: "line, global, delta^2 < mu",
        c: [2.0, 7.0, 3.0, 50.0],
        distance: 1.5,
        dimension: 1,
        isotropic: false,
        local: false,
        bend: 0.74466868119553491639,
        bounds: [
            [0.574886952362108057923, 0.864696460589553302813, 2.75538200465753489902, 6.09608578388915771634, 2.75538200465753489902, 6.09608578388915771634, 0.920545916599330442034, 1.11707463562182362748, 7.02186192825090506107, 7.02186192825090506107],
            [0.25, 0.432977602885518642568, 0.891968305619414127127, 2.06717268539380173333, 0.68779162353382414743, 1.44564455792081805617, 0.234973017396905718899, 0.317140576767702878803, 1.40114874117309559052, 0.698518513161638885607],
            [0.0220452899838856541975, 0.0434565261866104349247, 0.0462932793265443350978, 0.095791780198974200952, 0.0452220592173404911527, 0.0908346556374365384329, 0.00164553964173597026639, 0.00171723564411891917258, 0.00338011754278856734182, 0.00336770130469730217023],
        ],
    },
    Case {
        name: "line, on a region",
        c: [2.0, 7.0, 3.0, 50.0],
        distance: 1.5,
        dimension: 1,
        isotropic: false,
        local: true,
        bend: 0.795495128834865964951,
        bounds: [
            [0.574886952362108057923, 0.864696460589553302813, 2.78162257031170981574, 6.09608578388915771634, 2.78162257031170981574, 6.09608578388915771634, 0.920545916599330442034, 1.13223670743922421057, 7.09032272053783063993, 7.09032272053783063993],
            [0.25, 0.432977602885518642568, 0.894745301833811597667, 2.06717268539380173333, 0.689834636049957816839, 1.44564455792081805617, 0.234973017396905718899, 0.320552819886670769355, 1.41154235594676144039, 0.702945285154455193728],
            [0.0220452899838856541975, 0.0434565261866104349247, 0.0463031686810012844844, 0.095791780198974200952, 0.0452316775617112140599, 0.0908346556374365384329, 0.00164553964173597026639, 0.00172701654030335118761, 0.0033899528409418229382, 0.00337749653933248385743],
        ],
    },
    Case {
        name: "isotropic, global, delta^2 > mu",
        c: [0.5, 40.0, 3.0, 1.25],
        distance: 0.75,
        dimension: 3,
        isotropic: true,
        local: false,
        bend: 0.456435464587638427881,
        bounds: [
            [0.294429108725743163465, 0.366931414370070423497, 5.2985746021487822308, 17.0969686516015359193, 5.2985746021487822308, 17.0969686516015359193, 0.0538920855502025915553, 0.277387777247837394269, 0.424348501908319253711, 0.424348501908319253711],
            [0.172331175388955668232, 0.248652546596646120154, 1.31749290472731647119, 3.65343511725652926388, 0.893130009632384831114, 2.36147359996215419335, 0.00713947483589243860944, 0.0134044988390402738618, 0.0225603562134157837346, 0.0210819523525367122911],
            [0.0211248549306642193608, 0.0400533780168585534969, 0.0521649564087491142006, 0.124833918276999628644, 0.0461849035238648643781, 0.0949373758070965750615, 0.0000411926966032759854122, 0.0000489266241478238753011, 0.0000901610616004321277097, 0.0000901325219142276321191],
        ],
    },
    Case {
        name: "isotropic, on a region",
        c: [0.5, 40.0, 3.0, 1.25],
        distance: 0.75,
        dimension: 3,
        isotropic: true,
        local: true,
        bend: 3.1819805153394638598,
        bounds: [
            [0.294429108725743163465, 0.366931414370070423497, 9.76416329108422012545, 17.0969686516015359193, 9.76416329108422012545, 17.0969686516015359193, 0.0538920855502025915553, 1.84415076993922421057, 3.05081075503277852289, 3.05081075503277852289],
            [0.172331175388955668232, 0.248652546596646120154, 1.56710084853064554111, 3.65343511725652926388, 1.07542336131649833884, 2.36147359996215419335, 0.00713947483589243860944, 0.302825831077357309684, 0.354825052878032248405, 0.320158905010915622591],
            [0.0211248549306642193608, 0.0400533780168585534969, 0.0527934787181767032783, 0.124833918276999628644, 0.0467239895693622990554, 0.0949373758070965750615, 0.0000411926966032759854122, 0.000416774363271740339632, 0.000458193459072860496753, 0.00045803416728991098917],
        ],
    },
    Case {
        name: "far",
        c: [0.5, 40.0, 3.0, 25.0],
        distance: 20.0,
        dimension: 2,
        isotropic: false,
        local: false,
        bend: 254.558441227157108784,
        bounds: [
            [368.847444302602356493, 379.982126333126926377, 12174746.2150465766349, 24317892.4300931532698, 12174746.2150465766349, 24317892.4300931532698, 390.321306209499145697, 31600.0, 4266698266.66666666667, 4266698266.66666666667],
            [338.772218459952306347, 359.845514659014192248, 7042448.73606612625225, 3116711.52644395331929, 4079315.40501552554496, 1804215.9746303888204, 371.666288911461716066, 31600.0, 1422253822.22222222222, 474105674.074074074074],
            [176.81958869094835211, 231.661078155260315753, 25339.2274370575645933, 30442.5341894757284978, 5121.36317718599749564, 5527.7513480884294931, 155.578185696452611432, 1324.26406871192851464, 311020.782678192567896, 9066.67703394894449919],
        ],
    },
];

fn setting(case: &Case) -> Setting {
    let [c1, c2, l_h, m_h] = case.c;
    let constants = Constants::new(c1, c2, l_h).and_then(|c| c.with_m_h(m_h)).expect("in order");
    let constants = if case.isotropic { constants.isotropic() } else { constants };
    let constants = if case.local { constants.on_a_region() } else { constants };
    Setting::new(constants, case.distance, case.dimension).expect("a distance")
}

#[test]
fn the_bounds_of_theorems_c_and_d_are_those_of_the_reference() {
    for case in &CASES {
        let setting = setting(case);
        let close = |what: &str, value: f64, expected: f64| {
            // Some fifty roundings; a variance that is a difference of numbers near 1 is at least
            // a thousandth here.
            let off = (value - expected).abs();
            assert!(off <= 1e-13 * expected, "{}, {what}: {value} is not {expected}", case.name);
        };
        close("G", setting.bend(), case.bend);
        for (count, expected) in [1, 3, 40].into_iter().zip(&case.bounds) {
            let n = NonZeroUsize::new(count).expect("positive");
            let known = |bound: Option<f64>| bound.expect("M_H is known");
            let (tra, left) = (PaperRule::Trapezoidal, PaperRule::LeftEndpoint);
            let found = [
                theorem_c_deficit(setting, tra, n),
                theorem_c_deficit(setting, left, n),
                theorem_c_excess(setting, tra, n),
                theorem_c_excess(setting, left, n),
                theorem_c_length_excess(setting, tra, n),
                theorem_c_length_excess(setting, left, n),
                known(theorem_d_deficit(setting, n)),
                known(theorem_d_minimum_gap(setting, n)),
                known(theorem_d_excess(setting, n)),
                known(theorem_d_length_excess(setting, n)),
            ];
            for (k, (value, &expected)) in found.into_iter().zip(expected).enumerate() {
                close(&format!("number {k} at N = {count}"), value, expected);
            }
        }
    }
}

/// `φ = 1 + x` on `[0, ∞)`: with `c₁ = L_H = 1` and `M_H = 0` there, a geodesic at 0 bends by
/// `|φ′|/2φ^{3/2} = ½` for every unit of length, though no constant metric would. Constants on a
/// region know nothing of where `φ` would have to become negative beyond it.
#[test]
fn on_a_region_an_incline_without_curvature_still_bends_geodesics() {
    let incline = Constants::new(1.0, 2.0, 1.0).and_then(|c| c.with_m_h(0.0)).expect("in order");
    for dimension in [1, 2, 3, 7] {
        for constants in [incline, incline.isotropic()] {
            for m_h in [0.0, 1e-3, 1.0, 1e3] {
                let constants = constants.with_m_h(m_h).expect("nonnegative").on_a_region();
                let setting = Setting::new(constants, 0.25, dimension).expect("a distance");
                assert!(setting.bend() >= 0.5 * 0.25, "{setting:?}");
                assert!(!setting.bend_needs_m_h(), "{setting:?}");
            }
        }
    }
}

/// Along `φ = (2 − cos x)²` with its constants `1`, `L_H` and `6` geodesics of the line bend by
/// `|φ′|/2φ^{3/2} = sin x/(2 − cos x)²`; the bound is `(2 · 6/27)^{1/2} = ⅔`, where `L_H/2` is 2.2.
#[test]
fn the_valleys_bend_geodesics_by_no_more_than_the_bound() {
    let constants = Constants::new(1.0, 9.0, 4.403_669_475_041_612).and_then(|c| c.with_m_h(6.0));
    let constants = constants.expect("in order").isotropic();
    let bend = |x: f64| x.sin() / (2.0 - x.cos()).powi(2);
    let most = (0..3142).map(|k| bend(f64::from(k) * 1e-3)).fold(0.0, f64::max);
    for dimension in [1, 2, 5] {
        let setting = Setting::new(constants, 1.0, dimension).expect("a distance");
        assert!(most <= setting.bend() && setting.bend() < 2.0 * most, "{most} {setting:?}");
    }
}

/// Speeds with known moments obey the bounds that are drawn from their mean and mean square alone:
/// equal ones but for one, which attain them, and others.
#[test]
fn no_speeds_have_larger_moments_than_their_spread_allows() {
    // Steele, Lea and Flood's SplitMix64.
    let mut state = 5_u64;
    let mut draw = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
    };
    for case in 0..4000 {
        let count = 1 + (draw() * 60.0) as usize;
        // The last alone, or with others that are slower the higher the power.
        let power = if case % 4 == 0 { 60.0 } else { 8.0 * draw() };
        let mut u: Vec<f64> = (0..count).map(|_| draw().powf(power)).collect();
        u[0] = if case % 2 == 0 { 1.0 } else { u[0] };
        let mean = |power: i32| u.iter().map(|u| u.powi(power)).sum::<f64>() / count as f64;
        let surplus = draw() * draw();
        // Scaled to the mean square 1 + surplus.
        let scale = ((1.0 + surplus) / mean(2)).sqrt();
        let [m1, m2, m3, m4] = [1, 2, 3, 4].map(|p| scale.powi(p) * mean(p));
        // A setting whose x is no less than 1 − m₁: δ = L_H for c₁ = d = 1.
        let missing = (1.0 - m1).max(0.0) * (1.0 + 1e-12);
        for (rule, k) in PaperRule::BOTH.into_iter().zip([0.25, 0.5]) {
            for wider in [1.0, 1.5, 40.0] {
                let delta = wider * missing * 2.0 * count as f64 / (k * (1.0 + surplus));
                let constants = Constants::new(1.0, 1e9, delta).expect("in order");
                let setting = Setting::new(constants, 1.0, 2).expect("a distance");
                let n = NonZeroUsize::new(count).expect("positive");
                let spread = Spread::of_first_order(setting, rule, n, surplus);
                // Sums of 60 numbers, of which the variance is a difference.
                let grant = 1.0 + 1e-12;
                let greatest = u.iter().map(|u| (scale * u - m1).abs()).fold(0.0, f64::max);
                assert!(m2 - m1 * m1 <= spread.variance + 1e-13 * m2, "{case}: {spread:?}");
                let square = spread.deviation.powi(2) + 1e-11 * m2;
                assert!(greatest.powi(2) <= square, "{case}: {greatest} {spread:?}");
                assert!(m3 <= spread.cube * grant, "{case}: {m3} {spread:?}");
                assert!(m4 <= spread.fourth * grant, "{case}: {m4} {spread:?}");
                // One alone of N has the moments √N ε^{3/2} and N ε², beyond which none goes.
                let (e, n) = (1.0 + surplus, count as f64);
                assert!(spread.cube <= n.sqrt() * e.powf(1.5) * grant, "{case}: {spread:?}");
                assert!(spread.fourth <= n * e * e * grant, "{case}: {spread:?}");
            }
        }
    }
}
