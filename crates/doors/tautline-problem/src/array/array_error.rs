//! `ArrayError`: why a file is no array.

use thiserror::Error;

/// Why the bytes of a file are no array, or an array has no such part.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum ArrayError {
    /// The first bytes are those of another format.
    #[error("this is neither a NPY nor a PNG file")]
    Unknown,
    /// A NPY file has a header that is not of its format.
    #[error("the header of the NPY file is wrong: {what}")]
    Header {
        /// What is wrong.
        what: String,
    },
    /// A NPY file holds something else than real numbers.
    #[error("the NPY file holds {descr}; expected integers, booleans, or floats of 32 or 64 bits")]
    Type {
        /// How the file describes its entries.
        descr: String,
    },
    /// A file ends too early, or does not end with the array.
    #[error(
        "the NPY file has {found} bytes after its header; its shape {shape:?} needs {expected}"
    )]
    Length {
        /// The shape in the header.
        shape: Vec<usize>,
        /// The bytes that it needs.
        expected: usize,
        /// The bytes that are there.
        found: usize,
    },
    /// A picture cannot be decoded.
    #[error("the picture cannot be read: {what}")]
    Picture {
        /// What the decoder says.
        what: String,
    },
    /// A shape and a list of numbers do not belong together.
    #[error("{found} numbers for an array of shape {shape:?}")]
    Count {
        /// The shape.
        shape: Vec<usize>,
        /// How many numbers there are.
        found: usize,
    },
    /// The last axes have no entry with these indices.
    #[error("an array of shape {shape:?} has no entry {index:?} on its last axes")]
    Component {
        /// The indices, from 0.
        index: Vec<usize>,
        /// The shape of the whole array.
        shape: Vec<usize>,
    },
}
