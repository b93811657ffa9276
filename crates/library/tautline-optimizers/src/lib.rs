//! Computes minimisers of the discrete energies.
//!
//! [`minimise`] searches for the point sequence of least discrete energy from one closed set to
//! another. The Hessian of a discrete energy is block tridiagonal, so that a Newton step costs
//! `O(N D³)`. On smooth data it is enough to take a few steps on a coarse grid, two or three on
//! each finer one, and none on the finest.
//!
//! ```
//! use tautline_discretizations::Rule;
//! use tautline_metrics::gallery::Valleys;
//! use tautline_optimizers::{Options, extrapolate, minimise};
//! use tautline_sets::{Ball, Ends, HalfSpace};
//!
//! // From the ball of radius ½ to the half-space x₁ ≥ 3: d = 5 − sin 3 + sin ½.
//! let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::new([-1.0, 0.0], -3.0)?)?;
//! let minimum = minimise(&Valleys, &ends, Rule::TRAPEZOIDAL, 512, &Options::default())?;
//! assert!(minimum.is_local_minimum());
//! let d2 = extrapolate(&minimum.levels, 2).expect("several grids");
//! assert!((d2.value / 28.497505937440242 - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! `solver.rs` shows the algorithm from top to bottom. A Newton step that would leave the region
//! where the metric is finite and positive definite is shortened. The search leaves a saddle along
//! the direction of most negative curvature.
//!
//! # What a result means
//!
//! A [`Minimum`] is the lowest local minimiser that the starts led to. It reports how the search
//! [stopped](Stop), the [signature of the Hessian](Curvature), the residual, and the energies of
//! all local minimisers that were found. It does not claim to be the global minimiser.
//!
//! On smooth data [`leading_constants`] predicts, from a minimiser, how the errors of both rules
//! decrease with `N`.
//!
//! # Features
//!
//! `serde`, off by default: [`Options`], in which fields may be missing, [`Scope`], [`Minimum`], [`Estimate`],
//! [`LeadingConstants`] and what they hold are written and read by the names of their fields.

mod asymptotics;
mod iterate;
mod minimise;
mod newton;
mod search;
mod solver;
mod trace;
mod watch;

pub use asymptotics::{
    asymptotics_error::AsymptoticsError,
    extrapolation::{Estimate, extrapolate},
    leading_constants::{LeadingConstants, leading_constants},
};
pub use iterate::{Iterate, Watcher};
pub use minimise::{
    Options, minimise, minimise_any, minimise_by_batches, minimise_in, minimise_watched,
};
pub use newton::{
    newton_step::{NewtonStep, newton_step},
    workspace::Workspace,
};
pub use search::{
    candidate::are_apart,
    minimum::{Curvature, Level, Minimum, Other, Stop},
    others::lowest_different,
    scope::Scope,
    solve_error::SolveError,
    starts::{Starts, bent_lines},
};
pub use trace::{Entry, Trace};
