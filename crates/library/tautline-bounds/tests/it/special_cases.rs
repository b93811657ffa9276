//! Settings for which the bounds can be computed by hand.

use approx::relative_eq;
use tautline_bounds::{
    Constants, Setting, c_tra, c_tra_g, c_tra_sharp, c_tra_sharp_g, k1_g, k2_g, k3_bar_g, k4_bar_g,
    polyline_gap_left, polyline_gap_trapezoidal, rule_gap, theorem_1_1_constant,
    theorem_1_1_excess, theorem_1_1_minimum_gap, theorem_1_1_polyline_gap,
    theorem_1_2_length_excess, theorem_1_3_constant, theorem_1_3_excess, theorem_1_3_minimum_gap,
    theorem_1_3_polyline_gap, theorem_1_4_length_excess,
};

use crate::{n, setting};

/// Returns every bound on an energy or a squared length, at `N = 3`.
fn energies(s: Setting) -> [f64; 13] {
    let (c, k1, k2, k3, k4) = (s.constants(), k1_g(s), k2_g(s), k3_bar_g(s), k4_bar_g(s));
    [
        c_tra(c, k1, k2, n(3)),
        c_tra_sharp(c, k1, k2),
        polyline_gap_trapezoidal(c, k3, n(3)),
        rule_gap(c, k3, n(3)),
        polyline_gap_left(c, k4, n(3)),
        c_tra_g(s, n(3)),
        theorem_1_1_minimum_gap(s, n(3)),
        theorem_1_1_polyline_gap(s, n(3)),
        theorem_1_1_excess(s, n(3)) + theorem_1_2_length_excess(s, n(3)),
        theorem_1_3_minimum_gap(s, n(3)),
        theorem_1_3_polyline_gap(s, n(3)),
        theorem_1_3_excess(s, n(3)) + theorem_1_4_length_excess(s, n(3)),
        c_tra_sharp_g(s) + theorem_1_1_constant(s) + theorem_1_3_constant(s),
    ]
}

/// For a constant metric, chords are minimal geodesics and the rules are exact.
#[test]
fn for_a_constant_metric_every_bound_is_zero() {
    for (c1, distance) in [(4.0, 6.0), (4.0, 1e200), (1e-300, 1e300)] {
        let flat = setting(c1, 9.0, 0.0, distance, 3);
        assert_eq!(energies(flat), [0.0; 13]);
        assert_eq!(k2_g(flat), 0.0);
        assert_eq!(k3_bar_g(flat), k1_g(flat));
        assert_eq!(k4_bar_g(flat), k1_g(flat));
    }
    assert_eq!(k1_g(setting(4.0, 9.0, 0.0, 6.0, 3)), 3.0);
}

/// The ends touch, and the minimiser is a constant curve.
#[test]
fn at_distance_zero_everything_is_zero() {
    for (c1, l_h) in [(4.0, 5.0), (1e-300, 1e300)] {
        let touching = setting(c1, 9.0, l_h, 0.0, 3);
        assert_eq!(energies(touching), [0.0; 13]);
        let speeds = [k1_g, k2_g, k3_bar_g, k4_bar_g].map(|k| k(touching));
        assert_eq!(speeds, [0.0; 4]);
    }
}

/// An infinite bound is still a bound.
#[test]
fn overflow_gives_infinity() {
    let far = setting(1e-300, 9.0, 5.0, 1e300, 3);
    assert_eq!(energies(far), [f64::INFINITY; 13]);
    assert_eq!([k1_g, k2_g, k3_bar_g, k4_bar_g].map(|k| k(far)), [f64::INFINITY; 4]);
    // K_{1,g} and K_{2,g} are finite, but their products overflow.
    let bent = setting(1.0, 9.0, 5.0, 1e120, 3);
    assert_eq!(k1_g(bent), 1e120);
    assert!(k2_g(bent).is_finite());
    assert_eq!(energies(bent), [f64::INFINITY; 13]);
}

/// `c₁ = 4`, `c₂ = 5`, `L_H = 8`, `d = 2`, `D = 1`: all numbers are dyadic until the first square
/// root.
#[test]
fn by_hand_in_dimension_one() {
    let s = setting(4.0, 5.0, 8.0, 2.0, 1);
    // 2 / √4 and 3 · 8 · 1 / (2 · 4) · 1².
    assert_eq!(k1_g(s), 1.0);
    assert_eq!(k2_g(s), 3.0);
    // 8 (1 + 2·3) + 4·5·3 = 116 and 4·5·9 = 180.
    assert_eq!(c_tra_sharp_g(s), 296.0);
    assert_eq!(c_tra_g(s, n(2)), 103.0);
    let (hundred, root) = (n(100), 3_f64.sqrt());
    // 296 + 8 · 375 √3 / 4, with the K̄₃ below.
    let constant = 296.0 + 750.0 * root;
    // (4 + 296 + 8 · 375 √3 / 2) / 4 = 75 + 375 √3.
    let fourth = 75.0 + 375.0 * root;
    // 8 · 375 √3 / 2 + 8 K̄₄³ / 2.
    let halves = 1500.0 * root + 4.0 * fourth * fourth.sqrt();
    for (name, value, expected) in [
        // (4 + 296) / 4 = 75: K̄₃ = 5 √3 and K̄₃³ = 375 √3.
        ("K̄₃", k3_bar_g(s), 5.0 * root),
        ("C of 1.1", theorem_1_1_constant(s), constant),
        ("minimum gap of 1.1", theorem_1_1_minimum_gap(s, hundred), constant / 100.0),
        ("polyline gap of 1.1", theorem_1_1_polyline_gap(s, hundred), constant / 10.0),
        ("length excess of 1.2", theorem_1_2_length_excess(s, hundred), constant / 10.0),
        ("excess of 1.1", theorem_1_1_excess(s, hundred), 2.96 + 75.0 * root),
        ("K̄₄", k4_bar_g(s), fourth.sqrt()),
        ("C of 1.3", theorem_1_3_constant(s), 296.0 + halves),
        ("minimum gap of 1.3", theorem_1_3_minimum_gap(s, hundred), (296.0 + halves) / 10.0),
        ("polyline gap of 1.3", theorem_1_3_polyline_gap(s, hundred), (296.0 + halves) / 10.0),
        ("length excess of 1.4", theorem_1_4_length_excess(s, hundred), (296.0 + halves) / 10.0),
        ("excess of 1.3", theorem_1_3_excess(s, hundred), 2.96 + halves / 10.0),
    ] {
        // There are at most ten roundings of 2⁻⁵³ on either side.
        assert!(relative_eq!(value, expected, max_relative = 4e-15), "{name}: {value}, {expected}");
    }
}

/// `K_{2,g}` is proportional to `D²`, and `K_{1,g}` does not depend on `D`.
#[test]
fn dimension_enters_k2_squared() {
    let at = |dimension| setting(4.0, 5.0, 8.0, 2.0, dimension);
    for dimension in 1..=16_usize {
        assert_eq!(k1_g(at(dimension)), 1.0);
        // The values are integers up to 768, so they are exact.
        assert_eq!(k2_g(at(dimension)), 3.0 * (dimension * dimension) as f64);
    }
}

/// `N · C_tra(N)` tends to the coefficient of `1/N`, with an error of `4 c₂ K₂² / N`.
#[test]
fn n_times_c_tra_has_a_limit() {
    // 344 / N + 180 / N², as in the unit test of `c_tra`.
    let constants = Constants::new(1.0, 5.0, 7.0).expect("in order");
    for power in 0..40 {
        let n = n(1 << power);
        // N is a power of two, so everything is exact while 344 + 180/N is a double, up to N = 2⁴⁶.
        let rest = n.get() as f64 * c_tra(constants, 2.0, 3.0, n) - 344.0;
        assert_eq!(rest, 180.0 / n.get() as f64);
    }
}
