//! Minimisers of the discrete energies.
//!
//! [`minimise`] looks for the point sequence with the least discrete energy among those that
//! begin in one closed set and end in another. The Hessian of a discrete energy is block
//! tridiagonal, so that a Newton step costs `O(N D³)`; a few steps on a coarse grid, two or
//! three on each finer one and none on the finest are enough on smooth data.
//!
//! ```
//! use tautline_discretizations::Trapezoidal;
//! use tautline_metrics::gallery::Valleys;
//! use tautline_optimizers::{Options, extrapolate, minimise};
//! use tautline_sets::{Ball, Ends, HalfSpace};
//!
//! // From the ball of radius ½ to the half-space x₁ ≥ 3: d = 5 − sin 3 + sin ½.
//! let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::new([-1.0, 0.0], -3.0)?)?;
//! let minimum = minimise(&Valleys, &ends, Trapezoidal, 512, &Options::default())?;
//! assert!(minimum.is_local_minimum());
//! let d2 = extrapolate(&minimum.levels, 2).expect("several grids");
//! assert!((d2.value / 28.497505937440242 - 1.0).abs() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # What a result says, and what not
//!
//! A [`Minimum`] is a local minimiser as far as its Hessian and its residual show, and the
//! lowest one that the starts led to. It carries how the search [stopped](Stop), the
//! [signature of the Hessian](Curvature) and the energies of all the local minimisers that
//! were met. That it is the global minimiser is not claimed.
//!
//! On smooth data [`leading_constants`] predicts, along a minimiser, how the errors of both rules
//! fall: it needs the same factorisation for where the left rule has its points.
//!
//! A Newton step that would leave the region where the metric is finite and positive is
//! shortened; a saddle is left along the direction of its most negative curvature.

mod asymptotics;
mod newton;
mod search;

pub use asymptotics::{
    asymptotics_error::AsymptoticsError,
    extrapolation::{Estimate, extrapolate},
    leading_constants::{LeadingConstants, leading_constants},
};
pub use newton::{
    newton_step::{NewtonStep, newton_step},
    workspace::Workspace,
};
pub use search::{
    minimise::{Options, minimise, minimise_by_batches, minimise_in},
    minimum::{Curvature, Level, Minimum, Stop},
    solve_error::SolveError,
    starts::Starts,
};
