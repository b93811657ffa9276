//! What sets claim of themselves.

mod claims;
