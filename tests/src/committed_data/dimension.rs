//! `paper/data/dimension.csv`: the paper's bound grows with the dimension, and the sharper bounds
//! do not.

use tautline_statements::slope;

use super::{Row, Table};

const SHARPER: [&str; 4] = ["theorem_a", "theorem_c", "theorem_b", "theorem_d"];

#[test]
fn only_the_bound_of_the_paper_grows_with_the_dimension() {
    let table = Table::read("data/dimension.csv");
    let rows: Vec<Row<'_>> = table.rows().collect();
    for row in &rows {
        for bound in SHARPER {
            for observed in ["along_axis", "along_diagonal"] {
                assert!(row.number(observed) <= row.number(bound), "{bound}: {:?}", row.record);
            }
            assert!(row.number(bound) <= row.number("paper"), "{bound}: {:?}", row.record);
        }
        // On the line ω is ½, so the bounds differ there.
        if row.number("dimension") >= 2.0 {
            for bound in SHARPER {
                assert_eq!(row.text(bound), rows[1].text(bound), "{:?}", row.record);
            }
        }
        // Along an axis the problem is the same as on the line, up to the error of the
        // minimisation.
        let [here, line] = [row, &rows[0]].map(|row| row.number("along_axis"));
        assert!((here / line - 1.0).abs() <= 1e-6, "{:?}", row.record);
    }
    let tail = &rows[rows.len() - 4..];
    let points = tail.iter().map(|row| (row.number("dimension"), row.number("paper")));
    let order = slope(&points.collect::<Vec<_>>());
    // The leading power is D⁶, through K̄₃³; the next term is smaller by a factor of order D⁻².
    assert!((order - 6.0).abs() <= 0.05, "slope {order}");
}
