//! The counterexample of Section 5 in numbers, for every `N`.

use tautline::{PointSequence, Rule, gallery::Valleys};

use crate::{
    Failure,
    artefact::Artefact,
    data::{Data, Tolerance},
    layout::{Layout, scientific},
    section_5::{
        DISCRETE_LENGTH, DISTANCE, LENGTH, along_the_axis, grid_sequences, left_minimisers,
        problem, trapezoidal_minimisers,
    },
    sweep::Sweep,
};

pub(super) const TABLE: Artefact = Artefact::table(
    "counterexample",
    "the minima of the discrete lengths, 4 pi for every N, and of the square roots of the \
     discrete energies, which converge to 8 pi (Section 5); minimisers counted by brute \
     force on a grid for N up to 4",
    data,
    layout,
);

/// The largest `N` for the brute force, which takes `26^{N−1}` sequences.
const COUNTED: usize = 4;

/// How far a length may be from `4π`, due to the rounding of at most 1024 chords.
const ROUNDING: f64 = 1e-12;

fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("n", Tolerance::Exact),
        ("min_length_left min_length_trapezoidal", LENGTH),
        ("minimisers_left minimisers_trapezoidal", Tolerance::Exact),
        ("counted_left counted_trapezoidal", Tolerance::Exact),
        ("root_min_energy_left root_min_energy_trapezoidal distance", LENGTH),
    ]);
    let problem = problem()?;
    let mut grids = sweep.powers_of_two(1024);
    grids.insert(2, 3);
    for n in grids {
        // For the largest N, a thousand of the half million sequences, evenly spread. They differ
        // in where they rest, not in their chords.
        let stride = (n * (n + 1) / 2).div_ceil(1000);
        let lengths_left = lengths(left_minimisers(n).step_by(stride), Rule::LEFT_ENDPOINT)?;
        let lengths_trapezoidal = lengths(trapezoidal_minimisers(n), Rule::TRAPEZOIDAL)?;
        let (left, trapezoidal) = (checked(&lengths_left, n)?, checked(&lengths_trapezoidal, n)?);
        let counted = |count: usize| if n <= COUNTED { count.to_string() } else { String::new() };
        let (grid_left, grid_trapezoidal) = if n <= COUNTED { count(n)? } else { (0, 0) };
        let length = |value: f64| format!("{value:.12e}");
        data.push(vec![
            n.to_string(),
            length(left),
            length(trapezoidal),
            (n * (n + 1) / 2).to_string(),
            n.to_string(),
            counted(grid_left),
            counted(grid_trapezoidal),
            length(problem.solve(Rule::LEFT_ENDPOINT, n)?.discrete_energy().sqrt()),
            length(problem.solve(Rule::TRAPEZOIDAL, n)?.discrete_energy().sqrt()),
            length(DISTANCE),
        ]);
    }
    Ok(data)
}

/// Returns the lengths of the sequences along the axis.
fn lengths(sequences: impl Iterator<Item = Vec<f64>>, rule: Rule) -> Result<Vec<f64>, Failure> {
    sequences.map(|x1| Ok(rule.length(&Valleys, &along_the_axis(&x1)?))).collect()
}

/// Returns the smallest of the lengths, all of which must be `4π`.
fn checked(lengths: &[f64], n: usize) -> Result<f64, Failure> {
    let (low, high) = lengths
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &l| (low.min(l), high.max(l)));
    if low >= DISCRETE_LENGTH - ROUNDING && high <= DISCRETE_LENGTH + ROUNDING {
        Ok(low)
    } else {
        Err(Failure::Violated(format!("N = {n}: lengths from {low} to {high}, not all 4π")))
    }
}

/// Counts the sequences on the grid whose left length is `4π`, and those whose trapezoidal length
/// is.
fn count(n: usize) -> Result<(usize, usize), Failure> {
    let (mut left, mut trapezoidal) = (0, 0);
    for points in grid_sequences(n) {
        let sequence = PointSequence::new(points)?;
        let attained = |length: f64| usize::from((length - DISCRETE_LENGTH).abs() <= ROUNDING);
        left += attained(Rule::LEFT_ENDPOINT.length(&Valleys, &sequence));
        trapezoidal += attained(Rule::TRAPEZOIDAL.length(&Valleys, &sequence));
    }
    if (left, trapezoidal) == (n * (n + 1) / 2, n) {
        Ok((left, trapezoidal))
    } else {
        Err(Failure::Violated(format!("N = {n}: counted {left} and {trapezoidal} minimisers")))
    }
}

fn layout(data: &Data) -> Result<Layout, Failure> {
    let mut layout = Layout::new(
        "Minimal discrete lengths and energies from (0, 0) to (4π, 0); the distance is 8π.",
        "$N$ & $\\min L_{\\mathrm l,N}/\\pi$ & $\\min L_{\\mathrm{tra},N}/\\pi$ & \
         minimisers (left) & minimisers (trap.) & $\\sqrt{\\min E_{\\mathrm l,N}}/\\pi$ & \
         $\\sqrt{\\min E_{\\mathrm{tra},N}}/\\pi$ & $8-\\sqrt{\\min \
         E_{\\mathrm{tra},N}}/\\pi$",
    );
    for row in data.rows() {
        let over_pi = |column: &str| row.number(column) / std::f64::consts::PI;
        let plain = |column: &str| format!("${:.9}$", over_pi(column));
        layout.push(vec![
            row.text("n").to_owned(),
            plain("min_length_left"),
            plain("min_length_trapezoidal"),
            row.text("minimisers_left").to_owned(),
            row.text("minimisers_trapezoidal").to_owned(),
            plain("root_min_energy_left"),
            plain("root_min_energy_trapezoidal"),
            scientific(over_pi("distance") - over_pi("root_min_energy_trapezoidal"), 3),
        ]);
    }
    Ok(layout)
}
