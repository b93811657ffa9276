//! Section 1: the chains of Theorems 1.1 to 1.4, every inequality on its own.
//!
//! # Global and local minimisers
//!
//! The theorems speak of a global minimiser `γᵖ` of the discrete energy. A solver returns a local
//! one, and its energy is an upper bound of the minimum. So
//!
//! - `E_N ≤ min E + C/N` is tested for more than the theorem claims: it could fail only because
//!   the solver stopped at a worse local minimiser, and that would be worth knowing;
//! - `min E − C/√N ≤ E_N` and `E(γᵖˡ) − C/√N ≤ E_N` need of the minimiser no more than the
//!   *premise* of `K̄_{3,g}` and `K̄_{4,g}`: `E_tra,N ≤ d² + C_tra♯` and
//!   `E_l,N ≤ d² + C_tra♯ + ½ L_H K̄_{3,g}³`. The premise is tested first, and then they are
//!   theorems for the very sequence that was found;
//! - `d² ≤ L(γᵖˡ)² ≤ E(γᵖˡ)` holds for every curve between the sets.
//!
//! Nothing is added for a residual: no inequality here needs that the sequence is stationary.
//!
//! The constants of the theorems are larger than what is observed by ten decades and more, so
//! that passing these chains says little of the code. What does are the sharp companions: the
//! observed orders and leading constants beside this file, and Sections 7 and 8.

mod chains;
mod leading_constants;
mod observed;
mod orders;
mod points;
mod sets;
mod slope;

pub(crate) use slope::slope;
