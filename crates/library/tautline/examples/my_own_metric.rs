//! How do I use a metric of my own, and how wrong can the result be?

use std::num::NonZeroUsize;

use tautline::{
    Bounded, Constants, Ends, Metric, Problem, Rule, SMatrix, SVector, Scalar,
    bounds::{Setting, theorem_1_1_excess},
};

/// `H(x) = diag(1 + ½ sin² x₁, 2)`: a metric needs only its formula.
struct Sheet;

impl Metric<2> for Sheet {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let first = 1.0 + 0.5 * x[0].sin().sqr();
        SMatrix::from_diagonal(&SVector::from([first, S::constant(2.0)]))
    }
}

/// Bounds also need the constants of the metric: `(½ sin²)′ = ½ sin 2x₁`, and
/// `(½ sin²)″ = cos 2x₁`.
impl Bounded<2> for Sheet {
    fn constants(&self) -> Constants {
        Constants::new(1.0, 2.0, 0.5).and_then(|c| c.with_m_h(1.0)).expect("1 ≤ 2")
    }
}

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let problem = Problem::new(Sheet, Ends::points([0.2, 0.0], [2.5, 1.0])?);
    let n = NonZeroUsize::new(512).ok_or("N is positive")?;
    let line = problem.solve(Rule::TRAPEZOIDAL, n.get())?;
    let energy = line.energy();
    println!("E = {:.9} is an upper bound on d², up to {:.0e}", energy.value, energy.error);

    // Every bound grows with d, so an upper bound on d suffices.
    let setting = Setting::new(Sheet.constants(), line.length().value, 2)?;
    let excess = theorem_1_1_excess(setting, n);
    println!("E − d² is at most {excess:.3e} for a global minimiser (Theorem 1.1)");

    // Since M_H = 1, the second derivative of ½ sin², is finite, the sharper theorems give 1/N².
    let enclosure = line.enclosure()?;
    println!("{:.9} ≤ d² ≤ {:.9} (Proposition S.6)", enclosure.lower, enclosure.upper);
    if enclosure.assumes_global_minimum {
        println!("if no other sequence of {n} chords has less discrete energy");
    }
    if let Some(d2) = line.distance_squared_estimate() {
        println!("E − d² is about   {:.3e} (extrapolated)", energy.value - d2.value);
    }
    Ok(())
}
