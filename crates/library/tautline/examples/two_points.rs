//! How far is it from one point to another, and which way is the shortest?

use tautline::{Ends, Problem, Rule, gallery::Bump};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A plane with a bump of high cost around the origin, between the two points.
    let bump = Bump::new(4.0, 0.5)?;
    let problem = Problem::new(bump, Ends::points([-1.5, 0.05], [1.5, -0.1])?);
    let line = problem.solve(Rule::TRAPEZOIDAL, 1000)?;

    println!("length of the curve    {:.9}", line.length().value);
    if let Some(d2) = line.distance_squared_estimate() {
        // The error of d is the error of d² divided by 2d.
        let d = d2.value.sqrt();
        println!("distance, extrapolated {d:.9} ± {:.0e}", d2.error / (2.0 * d));
    }
    let middle = line.curve().at(0.5);
    println!("half way at            ({:.4}, {:.4})", middle[0], middle[1]);
    println!("a local minimum?       {}", line.minimum().is_local_minimum());
    println!(
        "energies of the local minima on the coarsest grid: {:.4?}",
        line.minimum().local_minima
    );
    Ok(())
}
