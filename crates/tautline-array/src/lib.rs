//! Arrays of numbers from the bytes of NPY and PNG files.
//!
//! | file | array |
//! | --- | --- |
//! | NPY, as NumPy writes it | the array, of integers, booleans, or floats of 32 or 64 bits |
//! | grey PNG | the rows of the picture from the top, each with its pixels from the left |
//! | PNG with colours or transparency | the same, with the channels of a pixel as a last axis |
//!
//! A pixel has numbers from 0 to 255, or from 0 to 65535 in a file of sixteen bits. Grey numbers of `b < 8`
//! bits are multiplied by `255/(2ᵇ − 1)`, so that white is 255 however the picture was made smaller. A
//! palette becomes its colours, and transparency a channel.
//!
//! ```
//! use tautline_array::Array;
//!
//! let header = "{'descr': '<i2', 'fortran_order': False, 'shape': (3, 1), }\n";
//! let mut file = b"\x93NUMPY\x01\x00".to_vec();
//! file.extend((header.len() as u16).to_le_bytes());
//! file.extend(header.as_bytes());
//! file.extend([1, 0, 2, 0, 255, 255]);
//! let array = Array::read(&file)?;
//! assert_eq!((array.shape(), array.values()), (&[3, 1][..], &[1.0, 2.0, -1.0][..]));
//! assert_eq!(array.component(&[0])?.shape(), [3]);
//! # Ok::<(), tautline_array::ArrayError>(())
//! ```

mod array;
mod array_error;
mod npy;
mod picture;

pub use array::Array;
pub use array_error::ArrayError;
