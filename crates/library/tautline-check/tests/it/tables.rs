//! Certificates whose formulas call tables: their text, their hashes, and what they prove.

use std::sync::Arc;

use nalgebra::vector;
use tautline_check::{AnyCertificate, Certificate, CheckError, Region, length_above};
use tautline_formula::{Formula, spline::Spline};
use tautline_scalar::Table;

use crate::helpers::{point, several_levels};

/// The coefficients of a table of two rows, and of one with a single axis.
const ROWS: [f64; 6] = [1.0, 5.0, 2.0, 0.1, -0.0, 3.0];
const LINE: [f64; 4] = [2.0, 1.5, 1.0, 4.0];

fn spline(shape: &[usize], coefficients: &[f64]) -> Arc<dyn Table> {
    Arc::new(Spline::new(shape, coefficients.to_vec()).expect("a shape"))
}

/// Returns a certificate without levels whose formula calls the table of two rows first.
fn certificate(rows: &[usize], coefficients: &[f64]) -> Certificate<2> {
    let tables = [("line", spline(&[4], &LINE)), ("rows", spline(rows, coefficients))];
    let text = "phi(20 + rows(x1, x2) + line_1(x1) + rows_02(x2, x1))";
    let formula = Formula::<2>::parse_with(text, &[], &tables).expect("a formula");
    Certificate {
        formula: formula.of_upper_half(),
        sets: [point([0.0, 0.0]), point([1.0, 0.0])],
        hi: 9.0,
        region: Region::Declared { c1: 1.0 },
        curve: None,
        levels: Vec::new(),
    }
}

fn lines(certificate: &Certificate<2>) -> Vec<String> {
    certificate.to_string().lines().map(str::to_owned).collect()
}

fn read(lines: &[String]) -> Result<AnyCertificate, CheckError> {
    AnyCertificate::read(&(lines.join("\n") + "\n"))
}

/// The tables stand in the order of their first calls, a line for each row.
#[test]
fn tables_are_written_and_read() {
    let certificate = certificate(&[2, 3], &ROWS);
    let lines = lines(&certificate);
    assert_eq!(
        lines[2..7],
        [
            "table 2 3",
            "3ff0000000000000 4014000000000000 4000000000000000",
            "3fb999999999999a 8000000000000000 4008000000000000",
            "table 4",
            "4000000000000000 3ff8000000000000 3ff0000000000000 4010000000000000",
        ]
    );
    assert_eq!(read(&lines), Ok(AnyCertificate::Plane(certificate)));
}

/// The hashes are those of another program, of the numbers as 8 bytes each, the lowest first.
#[test]
fn a_statement_has_the_shape_and_the_hash_of_each_table() {
    let statement = certificate(&[2, 3], &ROWS).statement();
    let lines: Vec<&str> = statement.lines().collect();
    assert_eq!(
        lines[2..4],
        [
            "table 2 3 sha256 8d9cb27f0f6fc95464e37a5bf352ba633b38ffa8a5d6723bac9f5c1b3b6ece0d",
            "table 4 sha256 35ed9f2df397ce8808e9b10768fd11d2fb10f241a8e83ec487697822617c6aeb",
        ]
    );
    // Another shape, other numbers, even another zero, and the same numbers in another order.
    let mut zero = ROWS;
    zero[4] = 0.0;
    let mut swapped = ROWS;
    swapped.swap(0, 1);
    for other in
        [certificate(&[3, 2], &ROWS), certificate(&[2, 3], &zero), certificate(&[2, 3], &swapped)]
    {
        assert_ne!(other.statement(), statement);
    }
}

/// The tables of a file are those that its formula calls, in the order of the first calls.
#[test]
fn tables_that_the_formula_does_not_call_so_are_refused() {
    let good = lines(&certificate(&[2, 3], &ROWS));
    let refused = |change: &dyn Fn(&mut Vec<String>)| {
        let mut lines = good.clone();
        change(&mut lines);
        let refused = read(&lines).map(|_| ());
        assert!(matches!(refused, Err(CheckError::Line { .. })), "{refused:?} {lines:?}");
    };
    let table = |lines: &[String]| [&["table 1".to_owned()], lines].concat();
    let one = ["3ff0000000000000".to_owned()];
    // One more, before, between and after the others.
    for at in [2, 5, 7] {
        refused(&|lines| drop(lines.splice(at..at, table(&one))));
    }
    // One less, or in the other order.
    refused(&|lines| drop(lines.drain(5..7)));
    refused(&|lines| drop(lines.drain(2..5)));
    refused(&|lines| lines[2..7].rotate_left(3));
    // Rows that are missing, too many, too short or too long, and shapes that are none.
    refused(&|lines| drop(lines.remove(3)));
    refused(&|lines| lines.insert(3, lines[3].clone()));
    refused(&|lines| lines[3].truncate(33));
    refused(&|lines| lines[3].push_str(" 3ff0000000000000"));
    for shape in
        ["table", "table 0 3", "table 2 3 1 1", "table 2  3", "table +2 3", "table 3 2", "table 6"]
    {
        refused(&|lines| lines[2] = shape.to_owned());
    }
    // Numbers that are not finite, or too large.
    for bits in ["7ff0000000000000", "7ff8000000000000", "7e80000000000001"] {
        refused(&|lines| lines[3].replace_range(..16, bits));
    }
    // Orders above 2 have no name.
    for name in ["table2_3", "table1_03", "table2_10", "table1_0", "table3"] {
        refused(&|lines| {
            for line in lines.iter_mut() {
                *line = line
                    .replace("table2_1(", &format!("{name}("))
                    .replace("table1_02(", &format!("{name}("));
            }
        });
    }
}

/// Tables are equal if their lengths and their bits are.
#[test]
fn equal_tables_are_refused() {
    let zeros = ["0000000000000000", "8000000000000000"];
    for (one, two, calls, are_equal) in [
        ("1", "1", ["x1", "x2"], [true, false]),
        ("1", "1", ["x1", "x1"], [true, false]),
        ("1", "1 1", ["x1", "x1, x2"], [false, false]),
    ] {
        for (at, are_equal) in are_equal.into_iter().enumerate() {
            let mut lines = lines(&certificate(&[2, 3], &ROWS));
            let sets = lines.iter().position(|line| line.starts_with("from ")).expect("a set");
            let [of_x, of_y] = calls;
            let text = format!(
                "table {one}\n{}\ntable {two}\n{}\nmetric 4\ns1 = table1({of_x});\n\
                 s2 = table2({of_y});\ns3 = s1 + s2;\n[s3, s3; s3, s3]",
                zeros[0], zeros[at]
            );
            lines.splice(2..sets, text.lines().map(str::to_owned));
            assert_eq!(read(&lines).is_err(), are_equal, "{text}");
        }
    }
}

/// Along the line `H = T²` with `T(u) = 1 + u` between the border's cells: from 1.5 to 2.5 the distance
/// is `∫ 1 + u = 3`.
#[test]
fn the_distance_under_a_table_is_proved_from_its_text() {
    let table = [("t", spline(&[6], &[1.0, 2.0, 3.0, 4.0, 5.0, 6.0]))];
    let formula = Formula::<1>::parse_with("[sqr(t(x1))]", &[], &table).expect("a formula");
    let sets = [point([1.5]), point([2.5])];
    let curve = vec![vector![1.5], vector![2.5]];
    let length = length_above(&formula, sets.each_ref(), &curve).expect("a curve");
    let hi = length * (1.0 + 1e-9);
    // Everywhere T ≥ 1.
    let region = Region::Tubes { radius: 0.51 * hi, c1: 1.0 };
    let height = |u: f64| u + 0.5 * u * u;
    let functions = [1.5, 2.5]
        .map(|from| move |x: &nalgebra::SVector<f64, 1>| (height(x[0]) - height(from)).abs());
    let mut certificate = several_levels(
        formula.of_upper_half(),
        sets,
        hi,
        region,
        &[-3, -4],
        [&functions[0], &functions[1]],
    );
    certificate.curve = Some(curve);
    let read = AnyCertificate::read(&certificate.to_string()).expect("a file");
    let verdict = read.check().expect("proved");
    let upper = verdict.upper.expect("a curve");
    assert!(verdict.lower <= 3.0 && 3.0 <= upper, "{verdict:?}");
    // The length of a chord is known to a part of a thousand.
    assert!(verdict.lower > 2.99 && upper < 3.01, "{verdict:?}");
}
