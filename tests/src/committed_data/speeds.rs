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
