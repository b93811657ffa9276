//! `paper/data/quantities.csv`: only the discrete energy falls below `d²`.

use super::Table;

#[test]
fn quantities_of_the_curve_are_never_below_d_squared() {
    let table = Table::read("data/quantities.csv");
    let mut below = 0;
    for row in table.rows() {
        let [energy, length] = ["energy_gap", "squared_length_gap"].map(|c| row.number(c));
        // Printed with seven digits.
        assert!(0.0 <= length && length <= energy * (1.0 + 1e-6), "{:?}", row.record);
        below += usize::from(row.number("discrete_energy_gap") < 0.0);
    }
    assert!(below > 0, "the figure shows that the discrete energy may be below");
}

/// The bump: the left rule's first order, hidden by the second, comes out between these two grids.
#[test]
fn quantities_show_where_the_first_order_comes_out() {
    let table = Table::read("data/quantities.csv");
    let at = |n: usize| {
        let mut rows = table.rows().filter(|row| {
            row.text("case") == "bump_points" && row.text("rule") == "left_endpoint" && row.n() == n
        });
        rows.next().unwrap_or_else(|| panic!("N = {n}")).number("discrete_energy_gap")
    };
    assert!(at(1024) < 0.0 && at(2048) > 0.0, "{} and {}", at(1024), at(2048));
}
