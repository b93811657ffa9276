//! `paper/tables/corpus.csv`: the counts of the random problems add up, and the goal is reached.

use super::{Row, Table};

const REACHED: [&str; 6] = [
    "touch",
    "steps_1_to_5",
    "steps_6_to_10",
    "steps_11_to_20",
    "steps_21_to_40",
    "steps_41_to_60",
];

const MISSED: [&str; 4] = ["steps_above_60", "above", "stopped", "refused"];

fn sum(row: &Row<'_>, columns: &[&str]) -> f64 {
    columns.iter().map(|column| row.number(column)).sum()
}

#[test]
fn every_random_problem_is_counted_once() {
    let table = Table::read("tables/corpus.csv");
    let rows: Vec<Row<'_>> = table.rows().filter(|row| !row.text("number").is_empty()).collect();
    assert_eq!(rows.len(), 20, "ten groups, from the default starts and from one line");
    for row in &rows {
        let counted = sum(row, &REACHED) + sum(row, &MISSED);
        assert_eq!(counted, row.number("number"), "{}", row.text("problems"));
    }
    for starts in ["default", "straight line"] {
        let of = |group| table.row(&[("starts", starts), ("problems", group)]).number("number");
        assert_eq!(of("all"), 2000.0);
        for parts in [
            ["between points", "between sets"].as_slice(),
            &["left-endpoint rule", "trapezoidal rule"],
            &["D = 1 or 2", "D = 3 to 5", "D = 6 to 8"],
            &["N up to 64", "N above 64"],
        ] {
            assert_eq!(parts.iter().map(|part| of(part)).sum::<f64>(), 2000.0, "{parts:?}");
        }
    }
}

/// At least 99.9 % of the problems reach the goal within 60 steps, and each of the others has a
/// row.
#[test]
fn the_goal_is_reached_and_each_miss_is_named() {
    let table = Table::read("tables/corpus.csv");
    let all = table.row(&[("problems", "all")]);
    assert_eq!(all.text("starts"), "default");
    let missed = sum(&all, &MISSED);
    assert!(missed <= 2.0, "{missed}");
    let named = table.rows().filter(|row| row.text("what").starts_with("problem "));
    assert_eq!(named.count() as f64, missed);
}
