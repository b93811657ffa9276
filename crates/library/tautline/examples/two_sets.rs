//! Where does the shortest way between two bodies begin and end?

use tautline::{Ball, Ends, FiniteSet, Problem, Rule, gallery::Valleys};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // From a ball to the nearest of three harbours. The one that is nearest in a straight line lies
    // on a ridge of the metric, so the search tries all three.
    let ball = Ball::new([0.0, 0.0], 0.5)?;
    let harbours = FiniteSet::new([[3.0, 0.0], [0.0, 3.5], [-3.0, 1.0]])?;
    let problem = Problem::new(Valleys, Ends::new(ball, harbours)?);
    let line = problem.solve(Rule::TRAPEZOIDAL, 256)?;

    let (first, last) = (line.sequence().first(), line.sequence().last());
    println!("leaves the ball at ({:.4}, {:.4})", first[0], first[1]);
    println!("arrives at         ({:.4}, {:.4})", last[0], last[1]);
    println!("length             {:.6}", line.length().value);
    Ok(())
}
