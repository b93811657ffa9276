//! Measures the search for certificates of distances, and their check, on one thread.
//!
//! `cargo bench --package tautline --bench certificate -- P1 sphere` runs some of the problems. All
//! of them make up `paper/tables/certificates.csv`, which `cargo xtask bench certificate` writes.

mod measurement;
#[path = "../../examples/peers/problems.rs"]
mod problems;

use std::error::Error;

use measurement::Measured;
use problems::{Peer, pose};
use rayon::ThreadPoolBuilder;
use tautline::{
    Ends, Formula, KnownDistance, Metric, PointSequence, SVector,
    gallery::{Bump, RotatingAnisotropy, Shear, Sphere},
};

/// The wanted gaps, in the plane and in space.
const PLANE: [f64; 3] = [1e-3, 1e-6, 1e-8];
const SPACE: [f64; 2] = [1e-2, 1e-5];

/// The amplitudes and wave numbers of the sheared space: the pullback of the Euclidean metric by
/// `(x₁ + a₁ sin k₁x₂, x₂ + a₂ sin k₂x₃, x₃)`, which is a bijection.
const SHEARS: [[f64; 2]; 2] = [[0.3, 2.0], [0.2, 1.5]];

/// Measures a problem between two points, with its distance if that is known.
fn between<M: Metric<D>, const D: usize>(
    problem: &'static str,
    metric: M,
    [from, to]: [[f64; D]; 2],
    d: Option<f64>,
    gaps: &[f64],
) -> Result<(), Box<dyn Error>> {
    let measured = Measured { problem, gaps, d };
    measured.solve(metric, Ends::points(from, to)?, PointSequence::straight(from, to, 1)?)
}

/// Does the same with a metric that knows the distance.
fn known<M: KnownDistance<D>, const D: usize>(
    problem: &'static str,
    metric: M,
    ends: [[f64; D]; 2],
    gaps: &[f64],
) -> Result<(), Box<dyn Error>> {
    let [x, y] = ends.map(SVector::from);
    let d = metric.distance(&x, &y).ok_or_else(|| format!("{problem}: no known distance"))?;
    between(problem, metric, ends, Some(d), gaps)
}

/// The sheared space, where distances are Euclidean between the images of points.
fn sheared_space(problem: &'static str) -> Result<(), Box<dyn Error>> {
    let [[a1, k1], [a2, k2]] = SHEARS;
    let text = format!("pullback(x1 + {a1}*sin({k1}*x2), x2 + {a2}*sin({k2}*x3), x3)");
    let image = |[x1, x2, x3]: [f64; 3]| {
        SVector::from([x1 + a1 * (k1 * x2).sin(), x2 + a2 * (k2 * x3).sin(), x3])
    };
    let ends = [[-0.5, -0.3, -0.4], [0.6, 0.4, 0.5]];
    let d = (image(ends[0]) - image(ends[1])).norm();
    between(problem, Formula::<3>::parse(&text, &[])?, ends, Some(d), &SPACE)
}

/// Measures the problem of this name.
fn measure(problem: &'static str) -> Result<(), Box<dyn Error>> {
    match problem {
        "shear" => known(problem, Shear::new(0.6, 3.0)?, [[-0.5, -0.3], [0.5, 0.4]], &PLANE),
        "long shear" => known(problem, Shear::new(0.6, 3.0)?, [[-1.0, -0.7], [1.0, 0.5]], &PLANE),
        "rotating anisotropy" => {
            let metric = RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5])?;
            between(problem, metric, [[-1.5, -1.0], [1.5, 1.0]], None, &PLANE)
        }
        "sphere" => known(problem, Sphere, [[-0.3, -0.1, 0.1], [0.4, 0.2, -0.1]], &SPACE),
        "sheared space" => sheared_space(problem),
        // The ends are so near to opposite sides of the bump that curves around it in all planes
        // through the axis are nearly as short as the shortest.
        "around a bump" => {
            let ends = [[-1.5, 0.05, 0.0], [1.5, -0.1, 0.05]];
            between(problem, Bump::new(4.0, 0.5)?, ends, None, &SPACE)
        }
        "P1" => {
            // Along x₁ the speed is 2 − cos x₁, over two periods, and it depends on x₁ alone.
            let d = Some(8.0 * std::f64::consts::PI);
            pose(problem, 1, Measured { problem, gaps: &PLANE, d })
        }
        // The ends are those of `problems.rs`.
        "P6" => {
            let d = Sphere.distance(&SVector::from([-0.8, 0.3]), &SVector::from([1.1, 0.6]));
            pose(problem, 1, Measured { problem, gaps: &PLANE, d })
        }
        _ => pose(problem, 1, Measured { problem, gaps: &PLANE, d: None }),
    }
}

fn main() -> Result<(), Box<dyn Error>> {
    let words: Vec<String> = std::env::args().skip(1).filter(|w| !w.starts_with('-')).collect();
    let wanted = |word: &str| words.is_empty() || words.iter().any(|w| w == word);
    println!("problem,d,gap_wanted,gap,seconds,cubes,lo,hi,checker_seconds");
    let pool = ThreadPoolBuilder::new().num_threads(1).build()?;
    let problems = [
        "P1",
        "P2",
        "P4",
        "P6",
        "shear",
        "long shear",
        "rotating anisotropy",
        "sphere",
        "sheared space",
        "around a bump",
    ];
    for problem in problems.into_iter().filter(|problem| wanted(problem)) {
        // An error that is boxed here cannot leave the thread of the pool.
        pool.install(|| measure(problem).map_err(|error| format!("{problem}: {error}")))?;
    }
    Ok(())
}
