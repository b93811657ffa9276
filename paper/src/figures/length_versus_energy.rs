//! Minimising the discrete length fails for every `N`; minimising the discrete energy does not.

use std::f64::consts::PI;

use tautline::{Rule, gallery::Valleys};

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Tolerance},
    drawing::{self, Axis, Curve, Marker, Panel, Scale, Scene, palette},
    section_5::{
        DISTANCE, LENGTH, along_the_axis, left_minimisers, problem, trapezoidal_minimisers,
    },
    sweep::Sweep,
};

pub(super) const FIGURE: Artefact = Artefact::figure(
    "length_versus_energy",
    "the minima of the discrete lengths, 4 pi for every N, and the square roots of the \
     minima of the discrete energies, which converge to the distance 8 pi (Section 5)",
    data,
    draw,
);

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("n", Tolerance::Exact),
        ("length_left length_trapezoidal", LENGTH),
        ("root_energy_left root_energy_trapezoidal", LENGTH),
        ("reconstructed_length_trapezoidal", LENGTH),
    ]);
    let problem = problem()?;
    for n in sweep.powers_of_two(1024) {
        let trapezoidal = problem.solve(Rule::TRAPEZOIDAL, n)?;
        let left = problem.solve(Rule::LEFT_ENDPOINT, n)?;
        let none = || Failure::Data("N = 0".to_owned());
        let first_left = along_the_axis(&left_minimisers(n).next().ok_or_else(none)?)?;
        let first = along_the_axis(&trapezoidal_minimisers(n).next().ok_or_else(none)?)?;
        let row = [
            Rule::LEFT_ENDPOINT.length(&Valleys, &first_left),
            Rule::TRAPEZOIDAL.length(&Valleys, &first),
            left.discrete_energy().sqrt(),
            trapezoidal.discrete_energy().sqrt(),
            trapezoidal.length().value,
        ];
        let cells = row.map(|value| format!("{value:.12e}"));
        data.push(std::iter::once(n.to_string()).chain(cells));
    }
    Ok(data)
}

fn draw(data: &Data) -> Result<Scene, Failure> {
    let points = |column: &str| -> Vec<(f64, f64)> {
        data.rows().map(|row| row.point("n", column)).collect()
    };
    let last = data.greatest("n");
    let x = Axis::new(Scale::Octaves, 1.0, last)?.labelled("number of subintervals $N$");
    let y = Axis::new(Scale::MultiplesOfPi, 3.4 * PI, 8.6 * PI)?.labelled("length");
    let panel = Panel::new(x, y)
        .tall(300.0)
        .curve(Curve::level(DISTANCE, palette::GREY).labelled("distance $d = 8π$"))
        .curve(
            Curve::new(points("root_energy_trapezoidal"), palette::VERMILLION)
                .marked(Marker::Disc)
                .labelled("$√{\"min\" E_{\"tra\",N}}$"),
        )
        .curve(
            Curve::new(points("root_energy_left"), palette::BLUE)
                .marked(Marker::Ring)
                .labelled("$√{\"min\" E_{\"l\",N}}$"),
        )
        .curve(
            Curve::new(points("length_trapezoidal"), palette::GREEN)
                .marked(Marker::Square)
                .labelled("$\"min\" L_{\"tra\",N} = \"min\" L_{\"l\",N}$"),
        );
    let title = "Minimal discrete lengths and energies of the counterexample against N";
    Ok(drawing::Figure::new(560.0, title, vec![vec![panel]]).draw()?)
}
