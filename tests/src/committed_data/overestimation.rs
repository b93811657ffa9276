//! `paper/data/overestimation.csv`: every bound holds, and bounds that use more data are smaller.

use std::collections::BTreeSet;

use super::Table;

const BOUNDS: [&str; 6] =
    ["paper", "theorem_a", "theorem_c", "theorem_b", "theorem_d", "a_posteriori"];

#[test]
fn every_bound_holds_in_every_row() {
    let table = Table::read("data/overestimation.csv");
    table.assert_columns(&BOUNDS.join(" "));
    let cases: BTreeSet<&str> = table.rows().map(|row| row.text("case")).collect();
    assert!(cases.contains("valleys_points") && cases.contains("shear_points"), "{cases:?}");
    for row in table.rows() {
        let excess = row.number("excess");
        assert!(excess > 0.0, "{:?}", row.record);
        for bound in BOUNDS {
            assert!(excess <= row.number(bound), "{bound} in {:?}", row.record);
        }
        // The paper's bound is the largest, and the a-posteriori bound is the smallest.
        for bound in &BOUNDS[1..] {
            assert!(row.number(bound) <= row.number("paper"), "{bound} in {:?}", row.record);
            assert!(row.number("a_posteriori") <= row.number(bound), "{bound} in {:?}", row.record);
        }
    }
}

/// Theorem D has the same order as the observed excess: their quotient settles.
#[test]
fn the_overestimation_of_theorem_d_does_not_grow() {
    let table = Table::read("data/overestimation.csv");
    let at = |case, n| {
        let row = table.row(&[("case", case), ("n", n)]);
        row.number("theorem_d") / row.number("excess")
    };
    for case in ["valleys_points", "shear_points", "valleys_ball", "separable_points"] {
        let (before, after) = (at(case, "1024"), at(case, "4096"));
        // The next terms of the bound are smaller by a factor of order N^{-1/2}.
        assert!(after <= before, "{case}: {before} at N = 1024, {after} at N = 4096");
    }
}
