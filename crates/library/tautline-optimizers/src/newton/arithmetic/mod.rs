//! The arithmetic of vectors and of square blocks, in a fixed dimension or in any.

pub(crate) mod blocks;
pub(crate) mod dense;
pub(crate) mod ldl;
pub(crate) mod small;
