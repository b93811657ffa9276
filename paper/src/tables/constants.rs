//! The constants of the paper for every case.

use tautline::bounds::{
    c_tra_sharp_g, k1_g, k2_g, k3_bar_g, k4_bar_g, theorem_1_1_constant, theorem_1_3_constant,
};

use crate::{
    Failure,
    artefact::Artefact,
    cases::cases,
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "constants",
    "the constants of Theorems 1.1 to 1.4 and of the estimates behind them",
    data,
    layout,
);

/// Closed forms of closed forms. They have only rounding errors, which are raised to the ninth
/// power.
const VALUE: Tolerance = Tolerance::relative(1e-9);

const NUMBERS: &str = "c1 c2 l_h m_h d k1 k2 c_sharp k3_bar k4_bar c_tra c_left";

fn data(_sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[("case dimension reference", Tolerance::Exact), (NUMBERS, VALUE)]);
    for case in cases()? {
        let (setting, constants) = (case.setting, case.setting.constants());
        let numbers = [
            constants.c1(),
            constants.c2(),
            constants.l_h(),
            constants.m_h().unwrap_or(f64::NAN),
            setting.distance(),
            k1_g(setting),
            k2_g(setting),
            c_tra_sharp_g(setting),
            k3_bar_g(setting),
            k4_bar_g(setting),
            theorem_1_1_constant(setting),
            theorem_1_3_constant(setting),
        ];
        let dimension = setting.dimension().to_string();
        let mut row = vec![case.name.to_owned(), dimension, case.reference.name().to_owned()];
        let cell = |value: f64| {
            if value.is_nan() { String::new() } else { format!("{value:.11e}") }
        };
        row.extend(numbers.map(cell));
        data.push(row);
    }
    Ok(data)
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Constants of the paper, with the distance as length unit m and coordinates in ℓ.",
        "case & $D$ & $c_1$ & $c_2$ & $L_H$ & $M_H$ & $d$ & $K_{1,g}$ & $K_{2,g}$ & \
         $C_{\\mathrm{tra}}^\\sharp$ & $\\overline K_{3,g}$ & $\\overline K_{4,g}$ & $C$ \
         (1.1, 1.2) & $C$ (1.3, 1.4)",
    );
    for row in data.rows() {
        let mut cells = row.texts("case dimension");
        cells.extend(NUMBERS.split(' ').map(|name| scientific(row.number(name), 3)));
        layout.push(cells);
    }
    Ok(layout)
}
