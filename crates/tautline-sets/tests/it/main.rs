//! The claims of sets about themselves.

mod claims;
