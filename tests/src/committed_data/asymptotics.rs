//! `paper/tables/asymptotics.csv` has the leading constants of the errors, predicted and measured;
//! `paper/data/asymptotics.csv` shows how the errors approach them.

use std::collections::BTreeMap;
use std::f64::consts::PI;

use tautline_statements::slope;

use super::{Row, Table};

/// The quantities, with their orders in `1/N`.
const QUANTITIES: [(&str, &str); 6] = [
    ("discrete_energy_left", "1"),
    ("discrete_energy_trapezoidal", "2"),
    ("energy_left", "2"),
    ("energy_trapezoidal", "2"),
    ("length_squared_left", "2"),
    ("length_squared_trapezoidal", "2"),
];

/// The relative difference at which two numbers agree to three digits.
const AGREEMENT: f64 = 5e-4;

fn table() -> Table {
    Table::read("tables/asymptotics.csv")
}

/// Returns the difference between measurement and prediction, relative to the prediction, or
/// relative to `d²` if the prediction is 0.
fn difference(row: &Row<'_>) -> f64 {
    let (predicted, measured) = (row.number("predicted"), row.number("measured"));
    let scale = if predicted == 0.0 { row.number("d_squared") } else { predicted.abs() };
    (measured - predicted).abs() / scale
}

#[test]
fn asymptotics_has_every_quantity_of_every_case() {
    let table = table();
    table.assert_columns("case quantity order n predicted measured relative_difference");
    let mut cases: BTreeMap<&str, Vec<(&str, &str)>> = BTreeMap::new();
    for row in table.rows() {
        let quantities = cases.entry(row.text("case")).or_default();
        quantities.push((row.text("quantity"), row.text("order")));
        assert!(row.n() >= 1024, "{:?}", row.record);
    }
    for (case, mut quantities) in cases {
        quantities.sort_unstable();
        assert_eq!(quantities, QUANTITIES, "{case}");
    }
}

/// They agree in every row, and each quantity is nonzero in at least eight cases.
#[test]
fn asymptotics_agree_to_three_digits() {
    let table = table();
    for (quantity, _) in QUANTITIES {
        let mut agreeing = 0;
        for row in table.rows().filter(|row| row.text("quantity") == quantity) {
            let difference = difference(&row);
            assert!(difference <= AGREEMENT, "{difference:e} in {:?}", row.record);
            // The predicted and measured values are printed with seven digits, the difference with
            // two.
            let printed = row.number("relative_difference");
            let tolerance = 0.05 * printed + 2e-6;
            assert!((printed - difference).abs() <= tolerance, "{:?}", row.record);
            agreeing += usize::from(row.number("predicted") != 0.0);
        }
        assert!(agreeing >= 8, "{quantity}: {agreeing} cases");
    }
}

/// With `c = (8π)³ π/18√3`, the constants for the trapezoidal rule are `−2c`, 0, `c` and 0. For the
/// left rule, whose curve also runs along the segment, they are `13c` and 0.
#[test]
fn asymptotics_over_the_valleys_are_explicit() {
    let table = table();
    let c = (8.0 * PI).powi(3) * PI / (18.0 * 3_f64.sqrt());
    let rows: Vec<_> = table.rows().filter(|row| row.text("case") == "valleys_points").collect();
    assert_eq!(rows.len(), 6);
    for row in rows {
        let expected = match row.text("quantity") {
            "discrete_energy_trapezoidal" => -2.0 * c,
            "energy_trapezoidal" => c,
            "energy_left" => 13.0 * c,
            _ => 0.0,
        };
        // The values are printed with seven digits.
        let error = (row.number("predicted") - expected).abs();
        assert!(error <= 5e-7 * expected.abs(), "{:?}", row.record);
    }
}

/// The next term of the expansion has two more powers of `1/N` for the trapezoidal rule, and one
/// more for the left rule. Extrapolating the trapezoidal energy from two grids leaves an error of
/// order `1/N⁴`, and from three grids an error of order `1/N⁶`.
#[test]
fn asymptotics_are_approached_at_the_next_order() {
    let figure = Table::read("data/asymptotics.csv");
    let mut seen = 0;
    for case in ["valleys_oblique", "shear_points", "sphere_patch", "lens_balls", "valleys_points"]
    {
        // These grids are fine enough for the next term to dominate, and coarse enough for it to
        // exceed rounding. The symmetric valleys are long and deep and need finer grids.
        let window = if case == "valleys_points" { 256..=1024 } else { 32..=128 };
        let of_case = |row: &Row<'_>| row.text("case") == case && window.contains(&row.n());
        let rows: Vec<_> = figure.rows().filter(of_case).collect();
        assert_eq!(rows.len(), 3, "{case}");
        let order = |distance: &dyn Fn(&Row<'_>) -> f64| {
            slope(&rows.iter().map(|row| (row.n() as f64, distance(row))).collect::<Vec<_>>())
        };
        let quantities = [
            ("trapezoidal", "limit_trapezoidal", -2.0),
            ("left", "limit_left", -1.0),
            ("energy", "limit_energy", -2.0),
        ];
        for (column, limit, expected) in quantities {
            let found = order(&|row| (row.number(column) - row.number(limit)).abs());
            // The term after the next changes the slope by some hundredths; another order would
            // change it by 1.
            assert!((found - expected).abs() <= 0.1, "{case}, {column}: {found}");
            seen += 1;
        }
        for (column, expected) in [("two_grids", -4.0), ("three_grids", -6.0)] {
            if rows.iter().all(|row| !row.text(column).is_empty()) {
                let found = order(&|row| row.number(column).abs());
                assert!((found - expected).abs() <= 0.1, "{case}, {column}: {found}");
                seen += 1;
            }
        }
    }
    // For the balls under the lens the exact distance is not known.
    assert_eq!(seen, 5 * 3 + 4 * 2);
}

/// The figure shows the same prediction, relative to `d²`.
#[test]
fn asymptotics_have_the_same_limits_in_the_figure() {
    let (table, figure) = (table(), Table::read("data/asymptotics.csv"));
    let mut seen = 0;
    for row in figure.rows().filter(|row| row.n() == 2048) {
        for (quantity, limit) in [
            ("discrete_energy_trapezoidal", "limit_trapezoidal"),
            ("discrete_energy_left", "limit_left"),
            ("energy_trapezoidal", "limit_energy"),
        ] {
            let other = table.row(&[("case", row.text("case")), ("quantity", quantity)]);
            let predicted = other.number("predicted");
            let error = (row.number(limit) * other.number("d_squared") - predicted).abs();
            // The table prints seven digits.
            assert!(error <= 6e-7 * predicted.abs(), "{:?} {:?}", row.record, other.record);
            seen += 1;
        }
    }
    assert_eq!(seen, 15);
}
