//! `paper/data/sandwich.csv`: the bounds of each distance close on it, level after level.

use super::Table;

#[test]
fn lower_bounds_rise_and_distances_stay_between_the_bounds() {
    let table = Table::read("data/sandwich.csv");
    let (mut problem, mut lower, mut cubes) = (String::new(), 0.0, 0.0);
    for row in table.rows() {
        if row.text("problem") != problem {
            (problem, lower, cubes) = (row.text("problem").to_owned(), 0.0, 0.0);
        }
        let [next, upper, d] = ["lower", "upper", "d"].map(|column| row.number(column));
        // Closed forms are computed with a few roundings, and the extrapolated length of the hill is
        // good to nine digits or so.
        let slack = if row.text("known") == "closed form" { 1e-12 * d } else { 1e-8 * d };
        assert!(lower < next && next <= d + slack && d - slack <= upper, "{:?}", row.record);
        assert!(cubes < row.number("cubes"), "{:?}", row.record);
        (lower, cubes) = (next, row.number("cubes"));
    }
}

#[test]
fn in_each_problem_the_gap_falls_by_three_orders() {
    let table = Table::read("data/sandwich.csv");
    for problem in ["valleys", "hill", "shear", "sphere"] {
        let gaps: Vec<f64> = table
            .rows()
            .filter(|row| row.text("problem") == problem)
            .map(|row| row.number("gap"))
            .collect();
        assert!(gaps[gaps.len() - 1] < 1e-3 * gaps[0], "{problem}: {gaps:?}");
    }
}
