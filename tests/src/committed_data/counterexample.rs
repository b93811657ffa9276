//! `paper/tables/counterexample.csv`: the numbers of Section 5.

use std::f64::consts::PI;

use tautline_checks::GridLine;

use super::Table;

fn table() -> Table {
    Table::read("tables/counterexample.csv")
}

#[test]
fn counterexample_has_lengths_of_4_pi_for_every_n() {
    let table = table();
    let grids: Vec<usize> = table.rows().map(|row| row.n()).collect();
    for n in (0..=10).map(|k| 1 << k) {
        assert!(grids.contains(&n), "there is no row N = {n}");
    }
    assert_eq!(grids.iter().max(), Some(&1024));
    for row in table.rows() {
        for column in ["min_length_left", "min_length_trapezoidal"] {
            // 13 digits are printed, which gives 5e-12 for a number of size 12; it is computed to
            // 1e-12.
            let error = (row.number(column) - 4.0 * PI).abs();
            assert!(error <= 5e-12 + 1e-12, "{column} at N = {}: off by {error:e}", row.n());
        }
    }
}

/// There are `N (N + 1)/2` minimisers for the left rule and `N` for the trapezoidal rule; for
/// `N ≤ 4` they are also counted by brute force.
#[test]
fn counterexample_counts_its_minimisers() {
    for row in table().rows() {
        let n = row.n();
        let (left, trapezoidal) = ((n * (n + 1) / 2).to_string(), n.to_string());
        assert_eq!(row.text("minimisers_left"), left);
        assert_eq!(row.text("minimisers_trapezoidal"), trapezoidal);
        if n <= 4 {
            assert_eq!(row.text("counted_left"), left);
            assert_eq!(row.text("counted_trapezoidal"), trapezoidal);
        }
    }
}

/// The square roots of the discrete energies converge to the distance. For the trapezoidal rule
/// they converge from below like `N⁻²`, with `N² (E_tra,N − d²) → −(8π)³ π/9√3 = −3199.38…`; the
/// left rule is not much worse.
#[test]
fn counterexample_has_energies_that_converge_to_the_distance() {
    for row in table().rows() {
        let squared = (row.n() * row.n()) as f64;
        let distance = row.number("distance");
        assert!((distance - 8.0 * PI).abs() <= 5e-12);
        // √(d² − c/N²) = d − c/(2dN²) − … with c = d³ π/9√3
        let gap = distance - row.number("root_min_energy_trapezoidal");
        assert!(gap >= 0.0, "N = {}", row.n());
        if row.n() >= 128 {
            let leading = (8.0 * PI).powi(2) * PI / (18.0 * 3_f64.sqrt());
            // The next term is below (10/N)² times the first, and the printed digits add 5e-12 N².
            let tolerance = leading * (10.0 / row.n() as f64).powi(2) + 1e-11 * squared;
            assert!((gap * squared - leading).abs() <= tolerance, "N = {}: {gap:e}", row.n());
            let left = distance - row.number("root_min_energy_left");
            assert!(left > 0.0 && left * squared < 3.0 * leading, "N = {}: {left:e}", row.n());
        }
    }
    let last =
        table().rows().map(|row| row.number("root_min_energy_trapezoidal")).fold(0.0, f64::max);
    assert!((last - 8.0 * PI).abs() < 1e-4);
}

/// The energies belong to global minimisers: none exceeds the minimum over all sequences of points
/// on a grid, which dynamic programming finds.
#[test]
fn counterexample_has_the_energies_of_global_minimisers() {
    let d2 = 64.0 * PI * PI;
    let mut above = Vec::new();
    for (column, theta) in [("root_min_energy_left", 0.0), ("root_min_energy_trapezoidal", 0.5)] {
        let minima = GridLine::over_the_valleys(theta).minima(32, d2);
        for row in table().rows().filter(|row| row.n() <= 32) {
            let (root, best) = (row.number(column), minima[row.n() - 1].energy.sqrt());
            // The values are printed with 13 digits.
            if !(root <= best * (1.0 + 1e-12)) {
                above.push(format!("{column} at N = {}: {root}, at most {best}", row.n()));
            }
        }
    }
    assert!(above.is_empty(), "above the global minimum:\n{}", above.join("\n"));
}
