//! What the formula of a metric shows when it is read rather than evaluated: periods, directions
//! along which it does not change, and multiples of the identity.
//!
//! What is found is proved for the formula as written, with its doubles as exact numbers. What is
//! missed only costs time.
//!
//! # Comparisons of numbers that a proof rests on
//!
//! Each of them is exact, or errs to the side of "not equal":
//!
//! | is it so | how it is decided | why that is exact |
//! | --- | --- | --- |
//! | a slope is 0, so nothing changes along a coordinate or a direction | both ends of its interval are 0 | an interval without width is exact, since every operation that rounds or underflows widens it |
//! | a wave number or a slope is a double | the ends of its interval are equal | as above; `⅓` and `√2` are not |
//! | a common divisor of wave numbers, hence a period | Euclid's algorithm with `%` | the remainder of two doubles is a double, subnormal numbers included |
//! | a wave reads a multiple of a phase | its number is in the group of that common divisor | all multiples in a group are integers of at most 11 bits, so their quotients do not round |
//! | the divisor is not too small, `LARGEST_RATIO` | a product with a power of two | it does not round; where it overflows, the comparison holds |
//! | two linear forms are parallel | a fused multiply-add is 0 | it rounds once, so it is 0 only if the difference is, or underflows; products below `10⁻²⁵⁰` are not compared |
//! | a form depends only on coordinates that are 0 | slopes, as above | as above |
//! | a step is a wall `1/(d + f eᶻ)` | its operations, and `d`, `f > 0` | these are numbers of the formula |
//! | a step is a hill `e^(−q)` | the lower ends of the squares' factors are positive | intervals; "not positive" is no hill |
//! | entries are the same function, or functions of `x₁² + x₂² + …` | the operations, and the bits of numbers | nothing is computed; `0` and `−0` count as the same number |
//! | a domain is all of space for a metric | it is that which the metric's own formula gives | the ends of its sides are compared as doubles |
//!
//! Sharpness, the choice of cuts, the places where constants are nearly attained and the directions
//! that are tried rest on rounded numbers, and no proof rests on them.

mod dependence;
mod expression;
mod form;
mod harmonics;
mod hill;
mod invariance;
#[cfg(test)]
mod laws;
mod lift;
mod wall;

pub(crate) use dependence::{Along, dependence};
pub use expression::is_isotropic;
pub(crate) use expression::is_radial;
pub(crate) use form::Place;
pub(crate) use invariance::superfluous;
pub(crate) use lift::{Lift, Role};
pub(crate) use wall::Wall;
