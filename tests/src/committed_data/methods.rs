//! `paper/data/methods.csv`, `paper/tables/methods.csv` and `failure_rates.csv`: the comparison of
//! methods, and what the guide says of it.

use std::{collections::BTreeSet, f64::consts::TAU, fs};

use tautline::{KnownDistance, gallery::SpherePatch};

use super::{Row, Table};

const PROBLEMS: [&str; 3] = ["behind a sphere", "stirred space", "six waves"];

/// The method with a start for each homotopy class, which needs a lattice.
const CLASSES: &str = "Tautline, classes";

/// The methods that minimise the trapezoidal energy with the same chords.
const SAME_ENERGY: [&str; 8] = [
    "Tautline, trapezoidal",
    "Tautline, one start",
    CLASSES,
    "L-BFGS, points",
    "L-BFGS, Sobolev",
    "Sobolev gradient",
    "DDP",
    "DDP, Gauss–Newton",
];

/// Errors are printed with three digits.
const PRINTED: f64 = 5e-3;

#[test]
fn every_method_has_an_error_or_a_reason_on_each_problem() {
    for path in ["data/methods.csv", "tables/methods.csv"] {
        let table = Table::read(path);
        let methods = |problem: &str| -> BTreeSet<String> {
            let rows = table.rows().filter(|row| row.text("problem") == problem);
            rows.map(|row| row.text("method").to_owned()).collect()
        };
        let first = methods(PROBLEMS[0]);
        assert!(first.len() >= 16, "{path}: {first:?}");
        assert!(PROBLEMS.iter().all(|problem| methods(problem) == first), "{path}");
        for row in table.rows() {
            assert_ne!(
                row.text("error").is_empty(),
                row.text("reason").is_empty(),
                "{:?}",
                row.record
            );
            assert!(row.number("seconds") > 0.0, "{:?}", row.record);
        }
    }
}

/// The lattices end at three or four dimensions, with an error that says so.
#[test]
fn only_lattices_refuse_six_dimensions() {
    for row in Table::read("data/methods.csv").rows() {
        let method = row.text("method");
        let is_on_a_lattice =
            method.starts_with("fast") || method.starts_with("lattice") || method == CLASSES;
        let is_refused = row.text("reason").contains("dimension 6");
        assert_eq!(
            is_refused,
            is_on_a_lattice && row.text("problem") == "six waves",
            "{:?}",
            row.record
        );
    }
}

/// The error of the trapezoidal rule is of second order, and every method that minimises its energy
/// reaches the same minimum.
#[test]
fn minimisers_of_one_energy_have_one_error_of_second_order() {
    let table = Table::read("data/methods.csv");
    for problem in PROBLEMS {
        let error = |method: &str, n: usize| {
            let setting = format!("{n} chords");
            let mut rows = table.rows().filter(|row| {
                row.text("problem") == problem
                    && row.text("method") == method
                    && row.text("setting") == setting
            });
            rows.next().map(|row| row.number("error"))
        };
        let solver = |n| error(SAME_ENERGY[0], n).expect("a row for each number of chords");
        // At N = 256 the next term is a few per cent of the first one.
        for [coarse, fine] in [[256, 1024], [1024, 4096]] {
            let ratio = solver(coarse) / solver(fine);
            assert!((ratio / 16.0 - 1.0).abs() < 0.05, "{problem}: {ratio}");
        }
        // There is no lattice in six dimensions.
        let answers = |method: &&str| *method != CLASSES || problem != PROBLEMS[2];
        for method in SAME_ENERGY.into_iter().filter(answers) {
            for n in [16, 64] {
                let [one, other] = [solver(n), error(method, n).expect("a row")];
                // A descent leaves the square of its residual of 10⁻⁶.
                let tolerance = 2.0 * PRINTED * one.abs() + 1e-9;
                assert!((one - other).abs() <= tolerance, "{problem}, {method}: {other} for {one}");
            }
        }
    }
}

/// Behind the sphere, shooting and collocation go the long way round, of the length `2π − d`; all
/// others find the short one.
#[test]
fn shooting_and_collocation_find_another_geodesic_behind_the_sphere() {
    let sphere = SpherePatch::new(4.0).expect("a radius");
    let d = sphere.distance(&[1.3, 0.0].into(), &[-1.22, 0.45].into()).expect("in the patch");
    let long = (TAU - d) / d - 1.0;
    for row in Table::read("tables/methods.csv").rows() {
        if row.text("problem") != PROBLEMS[0] {
            continue;
        }
        let error = row.number("error");
        if ["shooting", "collocation"].contains(&row.text("method")) {
            // The patch agrees with the sphere only in the patch, in which the way stays.
            assert!((error - long).abs() <= PRINTED * long, "{:?}, not {long}", row.record);
        } else {
            assert!(error.abs() < 0.1 * long, "{:?}", row.record);
        }
    }
}

fn counts(row: &Row<'_>) -> [f64; 4] {
    ["within_1e-3", "within_1e-2", "farther", "none"].map(|column| row.number(column))
}

#[test]
fn every_random_problem_is_counted_once_for_each_method() {
    let table = Table::read("tables/failure_rates.csv");
    for row in table.rows() {
        let number = row.number("number");
        assert!(number >= 10.0, "{:?}", row.record);
        assert_eq!(counts(&row).iter().sum::<f64>(), number, "{:?}", row.record);
    }
    assert_eq!(table.rows().count(), 4 * 15, "four groups, fifteen methods");
}

/// The page "Which method" has the numbers of the tables.
#[test]
fn the_guide_has_the_numbers_of_the_tables() {
    let page = format!("{}/../guide/pages/which-method.md", env!("CARGO_MANIFEST_DIR"));
    let page = fs::read_to_string(page).expect("a page of the guide");
    let (measured, rates) =
        (Table::read("tables/methods.csv"), Table::read("tables/failure_rates.csv"));
    let of = |table: &Table, method: &str, cell: &dyn Fn(&Row<'_>) -> String| {
        let rows = table.rows().filter(|row| row.text("method") == method);
        rows.map(|row| cell(&row)).collect::<Vec<_>>().join(" | ")
    };
    let methods: Vec<&str> = measured
        .rows()
        .filter(|row| row.text("problem") == PROBLEMS[0])
        .map(|row| row.text("method"))
        .collect();
    for method in methods {
        let cells = of(&measured, method, &|row| {
            if row.text("error").is_empty() {
                return "no answer".to_owned();
            }
            let (error, ms) = (row.number("error").abs(), 1e3 * row.number("seconds"));
            format!("{error:.1e}, {ms:.1} ms")
        });
        let line = format!("| {method} | {cells} |");
        assert!(page.contains(&line), "the guide has no line {line}");
    }
    let counted: BTreeSet<&str> = rates.rows().map(|row| row.text("method")).collect();
    assert!(counted.contains(CLASSES));
    for method in counted {
        let cells = of(&rates, method, &|row| {
            let [nearer, near, farther, none] = counts(row);
            format!("{nearer}, {near}, {farther}, {none}")
        });
        let line = format!("| {method} | {cells} |");
        assert!(page.contains(&line), "the guide has no line {line}");
    }
}
