//! `paper/tables/rates.csv`: no observed order is below a proved one.

use super::Table;

#[test]
fn rates_observed_are_at_least_those_proven() {
    let table = Table::read("tables/rates.csv");
    for row in table.rows() {
        let [least, greatest, proven] =
            ["least_observed_order", "greatest_observed_order", "proven_order"]
                .map(|column| row.number(column));
        // At N = 256 the next term of the expansion is a few per cent of the first one.
        assert!(least >= proven - 0.05 && greatest >= least, "{:?}", row.record);
        assert!(row.number("cases") >= 3.0, "{:?}", row.record);
        // Where the second order is proved, no higher order is observed, so the proof is not too
        // weak.
        if row.text("statement") == "Theorems B and D" {
            assert!(greatest <= 2.05, "{:?}", row.record);
        }
    }
    let proven: Vec<&str> = table.rows().map(|row| row.text("proven_order")).collect();
    for order in ["0.5", "1", "2"] {
        assert!(proven.contains(&order), "no row claims the order {order}");
    }
}
