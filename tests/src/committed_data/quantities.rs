//! `paper/data/quantities.csv`: only the discrete energy can be less than `d²`.

use super::Table;

#[test]
fn quantities_of_the_curve_are_never_below_d_squared() {
    let table = Table::read("data/quantities.csv");
    let mut below = 0;
    for row in table.rows() {
        let [energy, length] = ["energy_gap", "squared_length_gap"].map(|c| row.number(c));
        // The values are printed with seven digits.
        assert!(0.0 <= length && length <= energy * (1.0 + 1e-6), "{:?}", row.record);
        below += usize::from(row.number("discrete_energy_gap") < 0.0);
    }
    assert!(below > 0, "the figure shows that the discrete energy may be below");
}

/// The case is the ridge. Between these two grids, the first-order term of the left rule overtakes
/// the second-order term.
#[test]
fn quantities_show_where_the_first_order_takes_over() {
    let table = Table::read("data/quantities.csv");
    let [before, after] = ["512", "1024"].map(|n| {
        let row = table.row(&[("case", "valleys_ridge"), ("rule", "left_endpoint"), ("n", n)]);
        row.number("discrete_energy_gap")
    });
    assert!(before < 0.0 && after > 0.0, "{before} and {after}");
}
