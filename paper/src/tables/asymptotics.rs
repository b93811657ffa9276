//! The leading constants of the errors, predicted and measured.

use crate::{
    Failure,
    artefact::Artefact,
    asymptotics::data,
    data::Data,
    layout::{Layout, scientific},
};

pub(super) const TABLE: Artefact = Artefact::table(
    "asymptotics",
    "the leading constants of the errors of both rules, predicted along one geodesic and \
     measured as Q(n) = n^order (error at N = n), for the left rule as 2 Q(n) - Q(n/2), with \
     the difference relative to the prediction, or to d^2 where that is 0; d^2 in closed \
     form, or extrapolated from N = 16, 64, ..., 4096",
    data,
    layout,
);

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
        "case & limit of & predicted & measured & difference",
    );
    for row in data.rows() {
        let name = match (layout.group_by(row.text("case")), row.text("reference")) {
            (false, _) => String::new(),
            (true, "extrapolated") => format!("{}*", row.text("case")),
            (true, _) => row.text("case").to_owned(),
        };
        layout.push([
            name,
            symbol(row.text("quantity")).to_owned(),
            scientific(row.number("predicted"), 4),
            scientific(row.number("measured"), 4),
            scientific(row.number("relative_difference"), 1),
        ]);
    }
    Ok(layout)
}
