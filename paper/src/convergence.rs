//! How the error falls as `N` grows: the data of the convergence figure and table.
//!
//! Every row is one solve. The observed orders and the chains of Theorems 1.1 to 1.4 are
//! checked as soon as the data are there.

use indicatif::ProgressBar;
use tautline::{
    Curvature,
    bounds::{theorem_1_2_length_excess, theorem_1_4_length_excess},
};

use crate::{
    Failure,
    case::{Case, PaperRule, cases},
    data::{Data, Row, Tolerance},
    observation::Observation,
    sweep::Sweep,
};

/// Energies are printed with 13 digits, of which rounding leaves 12 the same everywhere.
const ENERGY: Tolerance = Tolerance::Close { relative: 1e-11, absolute: 0.0 };

/// An excess is a difference of energies up to 700 with an error of 1e-12 each.
const EXCESS: Tolerance = Tolerance::Close { relative: 1e-6, absolute: 2e-10 };

/// Grids from here on are in the asymptotic range, where the orders are fitted.
const ASYMPTOTIC: usize = 256;

/// How far a fitted order may be from the predicted one.
const ORDER: f64 = 0.05;

/// Runs all cases with both rules for `N = 1, 2, 4, …, 4096`, and checks what it finds.
///
/// # Errors
///
/// If a solve fails, or an observation violates a theorem or misses its order.
pub fn data(sweep: Sweep) -> Result<Data, Failure> {
    let mut data = Data::new(&[
        ("case", Tolerance::Exact),
        ("rule", Tolerance::Exact),
        ("n", Tolerance::Exact),
        ("d_squared", ENERGY),
        ("discrete_energy", ENERGY),
        ("energy", ENERGY),
        ("length_squared", ENERGY),
        ("excess", EXCESS),
        ("quadrature_error", Tolerance::AtMost(1e-10)),
        ("decrement", Tolerance::AtMost(1e-17)),
        ("residual", Tolerance::AtMost(1e-6)),
        ("residual_floor", Tolerance::Close { relative: 1e-2, absolute: 0.0 }),
        ("paper_bound", ENERGY),
        ("first_order_bound", ENERGY),
        ("second_order_bound", ENERGY),
        ("reference", Tolerance::Exact),
        ("curvature", Tolerance::Exact),
    ]);
    let cases = cases()?;
    let grids = sweep.powers_of_two(4096);
    let progress = ProgressBar::new((cases.len() * PaperRule::BOTH.len() * grids.len()) as u64);
    for case in &cases {
        for rule in PaperRule::BOTH {
            for &n in &grids {
                let observation = case.solve(rule, n)?;
                data.push(row(case, rule, &observation)?);
                progress.inc(1);
            }
        }
    }
    progress.finish_and_clear();
    check(&data, &cases)?;
    Ok(data)
}

fn row(case: &Case, rule: PaperRule, seen: &Observation) -> Result<Vec<String>, Failure> {
    let n = std::num::NonZeroUsize::new(seen.n).ok_or_else(|| Failure::Data("N = 0".to_owned()))?;
    // C/√N bounds the excess of the energy and of the squared length alike.
    let bound = match rule {
        PaperRule::Trapezoidal => theorem_1_2_length_excess(case.setting, n),
        PaperRule::LeftEndpoint => theorem_1_4_length_excess(case.setting, n),
    };
    let energy = |value: f64| format!("{value:.12e}");
    let rough = |value: f64| format!("{value:.2e}");
    Ok(vec![
        case.name.to_owned(),
        rule.name().to_owned(),
        seen.n.to_string(),
        energy(case.distance_squared),
        energy(seen.discrete_energy),
        energy(seen.energy.value),
        energy(seen.length.value.powi(2)),
        format!("{:.6e}", seen.energy.value - case.distance_squared),
        rough(seen.energy.error),
        rough(seen.decrement),
        rough(seen.residual),
        rough(seen.residual_floor),
        energy(bound),
        String::new(),
        String::new(),
        case.reference.name().to_owned(),
        match seen.curvature {
            Curvature::PositiveDefinite => "positive_definite",
            _ => "degenerate",
        }
        .to_owned(),
    ])
}

/// Checks each row against the theorems, and each series against its order.
fn check(data: &Data, cases: &[Case]) -> Result<(), Failure> {
    for row in data.rows() {
        check_row(&row)?;
    }
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

/// The chains of Theorems 1.1 to 1.4, each inequality on its own, up to the quadrature error
/// and the rounding of printed numbers.
fn check_row(row: &Row<'_>) -> Result<(), Failure> {
    let [d2, discrete, energy, length2, excess, bound] =
        ["d_squared", "discrete_energy", "energy", "length_squared", "excess", "paper_bound"]
            .map(|column| row.number(column));
    let error = row.number("quadrature_error") + 1e-12 * d2;
    let upper = if row.text("rule") == "trapezoidal" {
        // Theorem 1.1 has C/N here.
        bound / row.number("n").sqrt()
    } else {
        bound
    };
    for (holds, inequality) in [
        (excess >= 0.0, "0 ≤ E(γᵖˡ) − d²"),
        (excess <= bound, "E(γᵖˡ) − d² ≤ C/√N"),
        (energy - bound <= discrete + error, "E(γᵖˡ) − C/√N ≤ E_N"),
        (discrete <= d2 + upper + error, "E_N ≤ d² + C/N (left rule: C/√N)"),
        (d2 <= length2 + error, "d² ≤ L(γᵖˡ)²"),
        (length2 <= energy + error, "L(γᵖˡ)² ≤ E(γᵖˡ)"),
        (length2 - d2 <= bound, "L(γᵖˡ)² − d² ≤ C/√N"),
    ] {
        if !holds {
            let (case, rule, n) = (row.text("case"), row.text("rule"), row.text("n"));
            return Err(Failure::Violated(format!("{case}, {rule}, N = {n}: not {inequality}")));
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

/// Returns the slope of the least-squares line through `(log x, log y)`.
#[must_use]
pub fn slope(points: &[(f64, f64)]) -> f64 {
    let count = points.len() as f64;
    let (x, y): (Vec<f64>, Vec<f64>) = points.iter().map(|(x, y)| (x.ln(), y.ln())).unzip();
    let (mean_x, mean_y) = (x.iter().sum::<f64>() / count, y.iter().sum::<f64>() / count);
    let covariance: f64 = x.iter().zip(&y).map(|(x, y)| (x - mean_x) * (y - mean_y)).sum();
    covariance / x.iter().map(|x| (x - mean_x).powi(2)).sum::<f64>()
}

/// Returns the rows of one case and rule, by growing `N`.
#[must_use]
pub fn series<'a>(data: &'a Data, case: &str, rule: PaperRule) -> Vec<Row<'a>> {
    data.rows().filter(|row| row.text("case") == case && row.text("rule") == rule.name()).collect()
}

#[cfg(test)]
mod tests {
    use super::{check_row, slope};
    use crate::data::{Data, Tolerance};

    #[test]
    fn the_slope_of_a_power_is_its_exponent() {
        let points: Vec<_> = [1.0, 2.0, 8.0].map(|n: f64| (n, 3.0 * n.powf(-1.5))).to_vec();
        assert!((slope(&points) + 1.5).abs() < 1e-14);
    }

    const COLUMNS: [&str; 9] = [
        "rule",
        "n",
        "d_squared",
        "discrete_energy",
        "energy",
        "length_squared",
        "excess",
        "paper_bound",
        "quadrature_error",
    ];

    fn row(cells: [&str; 9]) -> Data {
        let mut columns = COLUMNS.map(|name| (name, Tolerance::Exact)).to_vec();
        columns.push(("case", Tolerance::Exact));
        let mut data = Data::new(&columns);
        data.push(cells.into_iter().chain(["made_up"]).map(str::to_owned).collect());
        data
    }

    #[test]
    fn each_inequality_of_the_chains_is_checked() {
        let verdict = |cells| check_row(&row(cells).rows().next().expect("one row"));
        let good = ["trapezoidal", "4", "1.0", "0.9", "1.2", "1.1", "0.2", "4.0", "0"];
        assert!(verdict(good).is_ok());
        for (column, cell, broken) in [
            (6, "-0.1", "0 ≤"),
            (6, "5.0", "≤ C/√N"),
            (3, "-3.0", "≤ E_N"),
            (3, "3.1", "C/N"),
            (5, "0.9", "d² ≤ L"),
            (5, "1.3", "≤ E("),
            (6, "NaN", "0 ≤"),
        ] {
            let mut cells = good;
            cells[column] = cell;
            let error = verdict(cells).expect_err(broken).to_string();
            assert!(error.contains(broken), "{error} does not mention {broken}");
        }
        // The left rule has only C/√N above.
        let mut left = good;
        (left[0], left[3]) = ("left_endpoint", "3.1");
        assert!(verdict(left).is_ok());
    }
}
