//! `paper/data/speeds.csv`: the minimiser of the energy has nearly constant speed, and the
//! minimiser of the length makes a single jump.

use std::f64::consts::PI;

use super::{Row, Table};

#[test]
fn speeds_stay_within_lemmas_s_3_and_s_5() {
    let table = Table::read("data/speeds.csv");
    for n in [8, 32, 128] {
        let rows: Vec<Row<'_>> = table.rows().filter(|row| row.n() == n).collect();
        assert_eq!(rows.len(), n, "one speed for each chord");
        let mean = rows.iter().map(|row| row.number("least_energy")).sum::<f64>() / n as f64;
        for row in &rows {
            let speed = row.number("least_energy");
            // The values are printed with ten digits.
            assert!((row.number("mean") - mean).abs() <= 1e-8 * mean, "{:?}", row.record);
            assert!(speed <= row.number("greatest"), "{:?}", row.record);
            assert!((speed - mean).abs() <= row.number("deviation"), "{:?}", row.record);
        }
        // In Section 5 one chord leads from 0 to 4π, and H = 1 where it is evaluated, so the speed
        // is N times 4π.
        let moving: Vec<f64> =
            rows.iter().map(|row| row.number("least_length")).filter(|q| *q != 0.0).collect();
        let [jump] = moving[..] else { panic!("N = {n}: {moving:?}") };
        let expected = 4.0 * PI * n as f64;
        assert!((jump - expected).abs() <= 1e-9 * expected, "N = {n}: {jump}");
    }
}

/// The largest relative deviation of an energy minimiser's speed from its mean decreases with `N`.
#[test]
fn speeds_of_least_energy_become_equal() {
    let table = Table::read("data/speeds.csv");
    let furthest = |n: usize| {
        let rows = table.rows().filter(|row| row.n() == n);
        rows.map(|row| (row.number("least_energy") / row.number("mean") - 1.0).abs())
            .fold(0.0, f64::max)
    };
    let [few, more, many] = [8, 32, 128].map(furthest);
    assert!(many < 0.1 * more && more < 0.1 * few, "{few}, {more}, {many}");
}

/// The minimum over fewer sequences is not below the minimum over all, `E_N = (1/N) Σ |βₙ|²`, and both
/// tend to `d² = (8π)²`.
#[test]
fn equal_speeds_cost_energy_and_ever_less() {
    let table = Table::read("data/speeds.csv");
    let (mut costs, mut errors) = (Vec::new(), Vec::new());
    for n in [8, 32, 128] {
        let rows: Vec<Row<'_>> = table.rows().filter(|row| row.n() == n).collect();
        let free =
            rows.iter().map(|row| row.number("least_energy").powi(2)).sum::<f64>() / n as f64;
        let equal = rows[0].number("equal");
        assert!(rows.iter().all(|row| row.number("equal") == equal), "N = {n}: one speed");
        costs.push(equal.powi(2) - free);
        errors.push((equal / (8.0 * PI) - 1.0).abs());
    }
    // The speeds are printed with ten digits, and their squares are below 700.
    let rounding = 1e-6;
    assert!(costs.iter().all(|&cost| cost >= -rounding), "{costs:?}");
    assert!(costs[0] > costs[1] && costs[1] > costs[2], "{costs:?}");
    // At least of first order, with four times as many chords each.
    assert!(errors.windows(2).all(|pair| pair[1] < 0.25 * pair[0]), "{errors:?}");
}
