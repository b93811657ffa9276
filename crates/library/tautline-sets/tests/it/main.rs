//! Tests what sets claim about themselves.

mod claims;
