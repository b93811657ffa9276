//! The golden numbers in `tests/golden/` are reference values that another program computed.

use std::{collections::HashMap, num::NonZeroUsize};

use csv::{Reader, ReaderBuilder};
use tautline_bounds::{self as bounds, Constants, PaperRule, Setting};

/// The tables: file name, content, number of rows, and relative tolerance. Where a reference value
/// is 0, the computed value must be exactly 0.
const TABLES: [(&str, &str, usize, f64); 3] = [
    // Rounding an input has a relative error of 2⁻⁵³. The worst result, C of Theorem 1.3, varies at
    // most like d⁹, L_H⁷ and c₁^−13 and takes some 40 roundings. The total error is below
    // 70 · 2⁻⁵³ < 8e-15.
    ("paper.csv", include_str!("../golden/paper.csv"), 64, 2e-14),
    // The inputs are rounded and enter with powers up to 9.
    ("theorems_a_and_b.csv", include_str!("../golden/theorems_a_and_b.csv"), 112, 1e-12),
    // There are some fifty roundings; a variance, which is a difference of numbers near 1, is at
    // least 0.001.
    ("theorems_c_and_d.csv", include_str!("../golden/theorems_c_and_d.csv"), 247, 1e-13),
];

type Row = (String, String, String, Option<NonZeroUsize>, f64);
type Problem = (String, f64, f64, f64, f64, f64, usize, bool, bool);

#[test]
fn the_bounds_have_their_reference_values() {
    let problems = problems();
    for (file, table, count, tolerance) in TABLES {
        let mut compared = 0;
        for row in reader(table).deserialize::<Row>() {
            let row = row.expect("a row of five columns");
            let (problem, name, rule, n, expected) = &row;
            let value = quantity(name, rule, *n, problems[problem]);
            assert!(agrees(value, *expected, tolerance), "{file}, {row:?}: found {value:e}");
            compared += 1;
        }
        assert_eq!(compared, count, "rows of {file}");
    }
}

fn agrees(value: f64, expected: f64, tolerance: f64) -> bool {
    (value - expected).abs() <= tolerance * expected
}

#[test]
fn other_numbers_do_not_agree() {
    assert!(agrees(2.0, 2.0, 0.0) && agrees(2.0, 2.01, 0.01) && agrees(0.0, 0.0, 1.0));
    for (value, expected) in [(2.0, 2.03), (2.03, 2.0), (f64::NAN, 2.0), (1e-300, 0.0)] {
        assert!(!agrees(value, expected, 0.01), "{value} and {expected}");
    }
}

fn reader(table: &'static str) -> Reader<&'static [u8]> {
    ReaderBuilder::new().comment(Some(b'#')).from_reader(table.as_bytes())
}

fn problems() -> HashMap<String, Setting> {
    reader(include_str!("../golden/problems.csv"))
        .deserialize::<Problem>()
        .map(|row| {
            let (name, c1, c2, l_h, m_h, distance, dimension, isotropic, local) =
                row.expect("a row of nine columns");
            let constants = Constants::new(c1, c2, l_h).and_then(|c| c.with_m_h(m_h));
            let constants = constants.expect("in order");
            let constants = if isotropic { constants.isotropic() } else { constants };
            let constants = if local { constants.on_a_region() } else { constants };
            (name, Setting::new(constants, distance, dimension).expect("a distance"))
        })
        .collect()
}

/// Returns the quantity of a row, or NaN if a bound is `None`.
fn quantity(name: &str, rule: &str, n: Option<NonZeroUsize>, s: Setting) -> f64 {
    let rule = || {
        let named = PaperRule::BOTH.into_iter().find(|paper_rule| paper_rule.name() == rule);
        named.unwrap_or_else(|| panic!("{name} needs a rule, not {rule:?}"))
    };
    let n = || n.unwrap_or_else(|| panic!("{name} needs an N"));
    match name {
        "delta" => s.delta(),
        "bend" => s.bend(),
        "k1_g" => bounds::k1_g(s),
        "k2_g" => bounds::k2_g(s),
        "c_tra_g" => bounds::c_tra_g(s, n()),
        "c_tra_sharp_g" => bounds::c_tra_sharp_g(s),
        "k3_bar_g" => bounds::k3_bar_g(s),
        "k4_bar_g" => bounds::k4_bar_g(s),
        "theorem_1_1_constant" => bounds::theorem_1_1_constant(s),
        "theorem_1_3_constant" => bounds::theorem_1_3_constant(s),
        "k2_sharp" => bounds::k2_sharp(s),
        "ceiling" => 1.0 + bounds::theorem_a_minimum_gap(s, rule(), n()) / s.distance().powi(2),
        "theorem_a_excess" => bounds::theorem_a_excess(s, rule(), n()),
        "theorem_a_constant" => bounds::theorem_a_constant(s, rule()),
        "theorem_c_deficit" => bounds::theorem_c_deficit(s, rule(), n()),
        "theorem_c_polyline_gap" => bounds::theorem_c_polyline_gap(s, rule(), n()),
        "theorem_c_excess" => bounds::theorem_c_excess(s, rule(), n()),
        "theorem_c_length_excess" => bounds::theorem_c_length_excess(s, rule(), n()),
        _ => with_m_h(name, n, s).unwrap_or(f64::NAN),
    }
}

fn with_m_h(name: &str, n: impl Fn() -> NonZeroUsize, s: Setting) -> Option<f64> {
    match name {
        "mu" => s.mu(),
        "theorem_b_excess" => bounds::theorem_b_excess(s, n()),
        "theorem_b_constant" => bounds::theorem_b_constant(s),
        "theorem_d_deficit" => bounds::theorem_d_deficit(s, n()),
        "theorem_d_minimum_gap" => bounds::theorem_d_minimum_gap(s, n()),
        "theorem_d_polyline_gap" => bounds::theorem_d_polyline_gap(s, n()),
        "theorem_d_excess" => bounds::theorem_d_excess(s, n()),
        "theorem_d_length_excess" => bounds::theorem_d_length_excess(s, n()),
        _ => panic!("no quantity is called {name}"),
    }
}
