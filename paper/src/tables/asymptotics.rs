//! The leading constants of the errors, predicted and measured.

use super::{Layout, Seed, Table, layout::scientific, no_pages};
use crate::{Failure, asymptotics::data, data::Data};

pub(super) const TABLE: Table = Table {
    id: "asymptotics",
    shows: "the leading constants of the errors of both rules, predicted along one geodesic and \
            measured as Q(n) = n^order (error at N = n), for the left rule as 2 Q(n) - Q(n/2), with \
            the difference relative to the prediction, or to d^2 where that is 0; d^2 in closed \
            form, or extrapolated from N = 16, 64, ..., 4096",
    seed: Seed::None,
    data,
    layout,
    repeatable: true,
    pages: no_pages,
};

fn symbol(quantity: &str) -> &'static str {
    match quantity {
        "discrete_energy_trapezoidal" => "$N^2(E_{\\mathrm{tra},N}-d^2)$",
        "discrete_energy_left" => "$N(E_{\\mathrm{l},N}-d^2)$",
        "energy_trapezoidal" => "$N^2(E(\\gamma^{\\mathrm{pl}}_{\\mathrm{tra}})-d^2)$",
        "length_squared_trapezoidal" => "$N^2(L(\\gamma^{\\mathrm{pl}}_{\\mathrm{tra}})^2-d^2)$",
        "energy_left" => "$N^2(E(\\gamma^{\\mathrm{pl}}_{\\mathrm{l}})-d^2)$",
        _ => "$N^2(L(\\gamma^{\\mathrm{pl}}_{\\mathrm{l}})^2-d^2)$",
    }
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Leading constants of the errors in m², predicted and measured, with their difference \
         relative to the prediction, or to d² where the prediction is 0 (by symmetry, or in one \
         dimension); d² in closed form, or extrapolated where marked by a star.",
        &["case", "limit of", "predicted", "measured", "difference"],
    );
    let mut case = "";
    for row in data.rows() {
        let mut name = String::new();
        if row.text("case") != case {
            case = row.text("case");
            layout.group();
            name = case.to_owned();
            if row.text("reference") == "extrapolated" {
                name += "*";
            }
        }
        layout.push(vec![
            name,
            symbol(row.text("quantity")).to_owned(),
            scientific(row.number("predicted"), 4),
            scientific(row.number("measured"), 4),
            scientific(row.number("relative_difference"), 1),
        ]);
    }
    Ok(layout)
}
