//! How different are two normal distributions? Their metric has constants on balls only.

use tautline::{Ends, KnownDistance, Problem, Rule, SVector, gallery::GaussianFisher};

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // The coordinates are the mean and the logarithm of the standard deviation.
    let [before, after] = [[0.0, 0.0], [0.1, 0.05]];
    let line = Problem::new(GaussianFisher, Ends::points(before, after)?)
        .solve(Rule::TRAPEZOIDAL, 1000)?;

    // diag(e^{−2t}, 2) has no positive bounds on the whole plane. But no curve shorter than this
    // line leaves a certain ball, on which it has positive bounds (Proposition S.8).
    let competitors = line.competitors()?;
    println!("all competitors are within {:.4} of the middle", competitors.within.r());
    let enclosure = line.enclosure_among(&competitors)?;
    println!("{:.9} ≤ d² ≤ {:.9}", enclosure.lower, enclosure.upper);

    let exact = GaussianFisher.distance(&SVector::from(before), &SVector::from(after));
    println!("d² = {:.9}", exact.ok_or("no distance")?.powi(2));
    Ok(())
}
