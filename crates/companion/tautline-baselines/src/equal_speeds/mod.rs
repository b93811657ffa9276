//! Minimisers among the sequences of equal discrete speeds, as of Liu et al.
//!
//! A geodesic has constant speed. Liu et al. demand it of the discrete curve:
//!
//! ```text
//! minimise E_N(x)   subject to   e₀ = e₁ = … = e_{N−1},     eₙ = βₙᵀ H βₙ
//! ```
//!
//! by the left-endpoint rule; here by any rule, with `eₙ` at its nodes. Since `E_N` is the mean of
//! the `eₙ`, its value on such a sequence is the square of the discrete length. The minimum is that
//! of `E_N` over fewer sequences, so that it is not below the minimum without constraints.

mod kkt_step;
mod search;

pub use search::{EqualSpeeds, equal_speeds};
