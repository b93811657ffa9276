//! How the error decreases as `N` grows: the data of the convergence figure and table.
//!
//! Every row is one solve. Theorems 1.1 to 1.4 and the sharper theorems are checked on it before
//! its numbers are used. At the end, the observed orders are checked. A distance that has no closed
//! form is proved by a certificate, and rows whose excess it does not resolve are left out.

use indicatif::ProgressBar;
use tautline::{
    Curvature,
    bounds::{first_order_excess, second_order_excess},
};
use tautline_statements::slope;

use crate::{
    Failure,
    case::{Case, PaperRule, paper_bound, subintervals},
    cases::cases,
    data::{Data, Row, Tolerance},
    observation::Observation,
    sweep::Sweep,
};

/// Energies are printed with 13 digits, 12 of which are the same on every machine.
const ENERGY: Tolerance = Tolerance::relative(1e-11);

/// An excess is a difference of energies up to 700, each with an error of 1e-12.
const EXCESS: Tolerance = Tolerance::Close { relative: 1e-6, absolute: 2e-10 };

/// From this `N` on, grids are in the asymptotic range, in which the orders are fitted.
const ASYMPTOTIC: usize = 256;

/// How far a fitted order may deviate from the predicted order.
const ORDER: f64 = 0.05;

/// Runs all cases with both rules for `N = 1, 2, 4, …, 4096`, and checks theorems and orders.
pub(crate) fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("case rule n", Tolerance::Exact),
        ("d_squared discrete_energy energy length_squared", ENERGY),
        ("excess", EXCESS),
        ("quadrature_error", Tolerance::AtMost(1e-10)),
        ("decrement", Tolerance::AtMost(1e-17)),
        ("residual", Tolerance::AtMost(1e-6)),
        ("residual_floor", Tolerance::relative(1e-2)),
        ("paper_bound first_order_bound second_order_bound", ENERGY),
        // This is also a difference of energies, and never less than the excess of the length.
        ("a_posteriori_bound", EXCESS),
        ("reference curvature", Tolerance::Exact),
    ]);
    let cases = cases()?;
    let grids = sweep.powers_of_two(4096);
    let progress = ProgressBar::new((cases.len() * PaperRule::BOTH.len() * grids.len()) as u64);
    for case in &cases {
        for rule in PaperRule::BOTH {
            for &n in &grids {
                let observation = case.solve(rule, n)?;
                // Smaller differences from a proved distance are not known.
                if case.resolves(observation.energy.value - case.distance_squared) {
                    data.push(row(case, rule, &observation)?);
                }
                progress.inc(1);
            }
        }
    }
    progress.finish_and_clear();
    check(&data, &cases)?;
    Ok(data)
}

fn row(case: &Case, rule: PaperRule, seen: &Observation) -> Result<Vec<String>, Failure> {
    let n = subintervals(seen.n)?;
    let second = match rule {
        PaperRule::Trapezoidal => second_order_excess(case.setting, n),
        PaperRule::LeftEndpoint => None,
    };
    let enclosure = case.enclose(rule, seen)?;
    let energy = |value: f64| format!("{value:.12e}");
    let rough = |value: f64| format!("{value:.2e}");
    Ok(vec![
        case.name.to_owned(),
        rule.name().to_owned(),
        seen.n.to_string(),
        energy(case.distance_squared),
        energy(seen.discrete_energy),
        energy(seen.energy.value),
        energy(seen.length_squared.value),
        format!("{:.6e}", seen.energy.value - case.distance_squared),
        rough(seen.energy.error),
        rough(seen.decrement),
        rough(seen.residual),
        rough(seen.residual_floor),
        energy(paper_bound(case.setting, rule, n)),
        energy(first_order_excess(case.setting, rule, n)),
        second.map_or(String::new(), energy),
        format!("{:.6e}", enclosure.width()),
        case.reference.name().to_owned(),
        match seen.curvature {
            Curvature::PositiveDefinite => "positive_definite",
            _ => "degenerate",
        }
        .to_owned(),
    ])
}

/// Checks the order of each series. The theorems have been checked row by row.
fn check(data: &Data, cases: &[Case]) -> Result<(), Failure> {
    for case in cases {
        for rule in PaperRule::BOTH {
            let series = series(data, case.name, rule);
            if series.iter().filter(|row| row.number("n") >= ASYMPTOTIC as f64).count() < 3 {
                continue;
            }
            expect_order(&series, case, rule, "E(γᵖˡ) − d²", 2.0, |row| {
                row.number("excess")
            })?;
            let Some(order) = case.orders.of(rule) else { continue };
            expect_order(&series, case, rule, "|E_N − d²|", order, |row| {
                (row.number("discrete_energy") - row.number("d_squared")).abs()
            })?;
        }
    }
    Ok(())
}

fn expect_order(
    series: &[Row<'_>],
    case: &Case,
    rule: PaperRule,
    quantity: &str,
    order: f64,
    value: impl Fn(&Row<'_>) -> f64,
) -> Result<(), Failure> {
    let points: Vec<(f64, f64)> = series
        .iter()
        .filter(|row| row.number("n") >= ASYMPTOTIC as f64)
        .map(|row| (row.number("n"), value(row)))
        .collect();
    let slope = slope(&points);
    if (slope + order).abs() <= ORDER {
        return Ok(());
    }
    let (case, rule) = (case.name, rule.name());
    Err(Failure::Violated(format!("{case}, {rule}: {quantity} falls with the slope {slope:.3}")))
}

/// Returns the rows of one case and rule, in the order of increasing `N`.
pub(crate) fn series<'a>(data: &'a Data, case: &str, rule: PaperRule) -> Vec<Row<'a>> {
    data.rows_with("case", case).filter(|row| row.text("rule") == rule.name()).collect()
}
