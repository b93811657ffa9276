//! `Precise`: formulas at real points, in high precision and with a bound of the error, to hold
//! enclosures against.
//!
//! Whoever shares this declares `mod reference;` beside it.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

mod agreement;
mod ball;
mod boxes;
mod number;

pub(crate) use agreement::Tally;
pub(crate) use ball::Value;
pub(crate) use boxes::Cell;
pub(crate) use number::Precise;
