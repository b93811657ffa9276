//! The leading constants of the errors, predicted and measured.

use crate::{
    Failure,
    artefact::Artefact,
    asymptotics::{N, Smooth, smooth_problems},
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    parallel,
    sweep::Sweep,
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

/// The quantities and their orders in `1/N`: `E_tra,N`, `E_l,N`, and the energies and squared
/// lengths of both curves.
const QUANTITIES: [(&str, i32); 6] = [
    ("discrete_energy_trapezoidal", 2),
    ("discrete_energy_left", 1),
    ("energy_trapezoidal", 2),
    ("length_squared_trapezoidal", 2),
    ("energy_left", 2),
    ("length_squared_left", 2),
];

/// Predicted and measured constants must agree to three digits.
const AGREEMENT: f64 = 5e-4;

/// Computes both constants for every problem, and fails unless they [agree](AGREEMENT).
fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let close = |absolute| Tolerance::Close { relative: 1e-6, absolute };
    let mut data = Data::new(&[
        ("case quantity order n", Tolerance::Exact),
        ("predicted", close(0.0)),
        // N² times a few ulps of a d² up to 632.
        ("measured", close(5e-6)),
        ("relative_difference", Tolerance::AtMost(AGREEMENT)),
        ("relative_to", Tolerance::Exact),
        ("d_squared", Tolerance::relative(1e-11)),
        ("reference", Tolerance::Exact),
    ]);
    let problems = smooth_problems()?;
    let results = parallel::map(&problems, Smooth::limits);
    for (Smooth { name, .. }, limits) in problems.iter().zip(results) {
        let limits = limits?;
        let predictions = limits.predictions();
        for (k, (quantity, order)) in QUANTITIES.into_iter().enumerate() {
            let (predicted, measured) = (predictions[k], limits.measured[k]);
            let zero = predicted == 0.0;
            let (predicted, scale, relative_to) = if zero {
                (0.0, limits.d_squared, "d_squared")
            } else {
                (predicted, predicted.abs(), "predicted")
            };
            let difference = (measured - predicted).abs() / scale;
            if !(difference <= AGREEMENT) {
                return Err(Failure::Violated(format!(
                    "{name}, {quantity}: predicted {predicted:.6e}, measured {measured:.6e}"
                )));
            }
            data.push(vec![
                (*name).to_owned(),
                quantity.to_owned(),
                order.to_string(),
                N.to_string(),
                if zero { "0".to_owned() } else { format!("{predicted:.6e}") },
                format!("{measured:.6e}"),
                format!("{difference:.1e}"),
                relative_to.to_owned(),
                format!("{:.12e}", limits.d_squared),
                limits.reference.name().to_owned(),
            ]);
        }
    }
    Ok(data)
}

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
