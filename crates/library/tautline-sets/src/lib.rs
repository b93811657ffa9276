//! Closed sets of `R^D`, each given by its nearest-point map, and pairs of them.
//!
//! A minimal geodesic runs between two closed sets, at least one of which is bounded (Proposition
//! 7.1). Each set has its own file.
//!
//! ```
//! use nalgebra::vector;
//! use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace, SetError};
//!
//! // From the ball of radius ½ about the origin to the half-space x₁ ≥ 3.
//! let ball = Ball::new([0.0, 0.0], 0.5)?;
//! let wall = HalfSpace::new([-1.0, 0.0], -3.0)?;
//! assert_eq!(ball.project(&vector![0.0, 2.0]), vector![0.0, 0.5]);
//! assert_eq!(wall.project(&vector![0.0, 2.0]), vector![3.0, 2.0]);
//!
//! let ends = Ends::new(ball, wall.clone())?;
//! assert_eq!(ends.first().radius(), Some(0.5));
//!
//! // Two half-spaces are refused: curves between them may escape to infinity.
//! assert_eq!(Ends::new(wall.clone(), wall).unwrap_err(), SetError::BothUnbounded);
//! # Ok::<(), SetError>(())
//! ```
//!
//! # The sets
//!
//! `P` is the nearest-point map and `u = (x − c)/|x − c|`. The table gives the derivative outside
//! the set. Inside it is `I`, and by convention also on the boundary.
//!
//! | set | formula | `P(x)` outside | `DP(x)` outside | convex |
//! | --- | --- | --- | --- | --- |
//! | [`Point`] | `{p}` | `p` | `0` | yes |
//! | [`FiniteSet`] | `{p₁, …, pₖ}` | the nearest `pᵢ` | `0` | only if `k = 1` |
//! | [`Ball`] | <code>&#124;x − c&#124; ≤ r</code> | `c + r u` | <code>(r/&#124;x − c&#124;)(I − uuᵀ)</code> | yes |
//! | [`Sphere`] | <code>&#124;x − c&#124; = r</code> | `c + r u` | <code>(r/&#124;x − c&#124;)(I − uuᵀ)</code> | only if `r = 0` |
//! | [`AxisBox`] | `lᵢ ≤ xᵢ ≤ uᵢ` | each `xᵢ` clamped | diagonal of 0 and 1 | yes |
//! | [`Segment`] | `a + s v`, `0 ≤ s ≤ L` | `s` clamped | `vvᵀ`, past the ends `0` | yes |
//! | [`HalfSpace`] | `n·x ≤ b` | `x − (n·x − b) n` | `I − nnᵀ` | yes |
//! | [`AffineSubspace`] | `p + span Q` | `p + QQᵀ(x − p)` | `QQᵀ` | yes |
//! | [`Union`] | union of members | by the nearest member | by the nearest member | only for one convex member |
//! | [`Shape`] | any of these sets, as data | as for that set | as for that set | as that set |
//!
//! # Sets in any dimension
//!
//! The sets of the table but [`Union`] are finitely many numbers. A [`Shape`] is any one of them, or a
//! union of shapes. The parameter `D` is the dimension, or [`ANY`](tautline_scalar::ANY) for
//! sets whose dimension is a value. The latter are made from slices and seen through [`AnySet`], by code
//! that is compiled once for all dimensions. Methods that speak of `SVector<f64, D>` are for a `D` that
//! the compiler knows.
//!
//! ```
//! use tautline_scalar::ANY;
//! use tautline_sets::{AnySet, Ball, SetError, Shape};
//!
//! let ball: Shape<ANY> = Shape::Ball(Ball::from_slice(&[0.0, 0.0], 0.5)?);
//! let mut x = [0.0, 2.0];
//! ball.project(&mut x);
//! assert_eq!(x, [0.0, 0.5]);
//! # Ok::<(), SetError>(())
//! ```
//!
//! # Units and accuracy
//!
//! Coordinates, radii and distances are in `ℓ`; derivatives of `P` are pure numbers. Projections
//! lie in their sets up to a few units in the last place of the largest coordinate;
//! [`ClosedSet::member_near`] returns a box that certainly contains a member. Norms neither
//! overflow nor underflow, but differences of coordinates may: keep coordinates below `2^1021` in
//! magnitude.
//!
//! # Features
//!
//! `serde`, off by default: a [`Shape`] and the sets that it may be are written and read by the names
//! of their parts, as [`kind`] has them, and checked when they are read. Other sets may be closures or types of your own, and
//! are not written.

mod affine_subspace;
mod any_ends;
mod any_set;
mod axis_box;
mod ball;
mod closed_set;
mod common_point;
mod ends;
mod finite_set;
mod half_space;
pub mod kind;
#[cfg(test)]
mod laws;
mod numerics;
mod point;
mod proved_common_point;
mod segment;
mod set_error;
mod shape;
mod sphere;
mod translates;
mod union;

pub use affine_subspace::AffineSubspace;
pub use any_ends::AnyEnds;
pub use any_set::{AnySet, InAny};
pub use axis_box::AxisBox;
pub use ball::Ball;
pub use closed_set::ClosedSet;
pub use common_point::{common_point, common_point_of};
pub use ends::Ends;
pub use finite_set::FiniteSet;
pub use half_space::HalfSpace;
pub use point::Point;
pub use proved_common_point::{proved_common_point, proved_common_point_of};
pub use segment::Segment;
pub use set_error::SetError;
pub use shape::Shape;
pub use sphere::Sphere;
pub use translates::translates;
pub use union::Union;
