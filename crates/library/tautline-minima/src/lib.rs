//! All minimal geodesics between two sets, local ones too.
//!
//! A local search finds the minimum next to its start. [`GlobalSearch`] finds starts in four ways, and
//! reports every local minimum to which they lead, with its energy, its curvature and the sides on which
//! it passes the obstacles:
//!
//! | starts | what they need | what they see |
//! | --- | --- | --- |
//! | automatic: straight and bent lines | nothing | what is beside the straight line |
//! | [`class_paths`](tautline::class_paths): the shortest lattice path of each homotopy class | a lattice, two dimensions or more | every way around the [`Punctures`](tautline::Punctures) |
//! | [`pass_paths`](tautline::grid::pass_paths): curves through passes between two distance fields | a lattice, two or three dimensions | curves of two shortest parts |
//! | [`follow`]: minima while the metric rises from a flat one | any dimension | minima that split off |
//!
//! Nothing proves that all minima are among them. Which one is the shortest of all curves, up to a gap, a
//! certificate proves where there is one: [`Minima::ranked`].

mod continuation;
mod error;
mod flattened;
mod minima;
mod search;

pub use continuation::{Branch, follow};
pub use error::MinimaError;
pub use flattened::Flattened;
pub use minima::{LocalMinimum, Minima, Origin, Ranked, Refused, Standing};
pub use search::GlobalSearch;
