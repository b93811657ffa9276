//! How far is each of many points from each of the others?

use tautline::{Ends, Options, Problem, Rule, gallery::Bump, solve_all};

const COUNT: usize = 12;

fn main() -> Result<(), Box<dyn std::error::Error>> {
    // A dozen points on a spiral that winds out of a bump of high cost.
    let bump = Bump::new(4.0, 0.5)?;
    let points = std::array::from_fn::<_, COUNT, _>(|k| {
        let (sin, cos) = (k as f64).sin_cos();
        [0.15 * k as f64 * cos, 0.15 * k as f64 * sin]
    });
    let pairs: Vec<_> = (0..COUNT).flat_map(|i| (i + 1..COUNT).map(move |j| (i, j))).collect();
    let mut problems = Vec::new();
    for &(i, j) in &pairs {
        problems.push(Problem::new(&bump, Ends::points(points[i], points[j])?));
    }

    let mut distances = [[0.0; COUNT]; COUNT];
    let lines = solve_all(&problems, Rule::TRAPEZOIDAL, 128, &Options::default());
    for (&(i, j), line) in pairs.iter().zip(lines) {
        distances[i][j] = line?.length().value;
        distances[j][i] = distances[i][j];
    }
    for row in &distances {
        println!("{}", row.map(|distance| format!("{distance:5.3}")).join(" "));
    }
    Ok(())
}
