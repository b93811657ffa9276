//! From the text of a problem file to numbers and sets.

pub(crate) mod axes;
pub(crate) mod numbers;
pub(crate) mod obstacles;
pub(crate) mod parse;
pub(crate) mod period;
pub(crate) mod pieces;
pub(crate) mod shape;
pub(crate) mod solve;
pub(crate) mod tables;
pub(crate) mod view;
