//! `Precise`: formulas evaluated at real points in high precision with an error bound, with which
//! enclosures are compared.
//!
//! Users of this file also declare `mod reference;` at the same level.

#![allow(dead_code, reason = "each test that shares this uses a part of it")]

mod agreement;
mod ball;
mod boxes;
mod number;

pub(crate) use agreement::Tally;
pub(crate) use ball::Value;
pub(crate) use boxes::Cell;
pub(crate) use number::Precise;
