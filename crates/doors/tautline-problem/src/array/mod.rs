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
//! use tautline_problem::array::Array;
//!
//! let header = "{'descr': '<i2', 'fortran_order': False, 'shape': (3, 1), }\n";
//! let mut file = b"\x93NUMPY\x01\x00".to_vec();
//! file.extend((header.len() as u16).to_le_bytes());
//! file.extend(header.as_bytes());
//! file.extend([1, 0, 2, 0, 255, 255]);
//! let array = Array::read(&file)?;
//! assert_eq!((array.shape(), array.values()), (&[3, 1][..], &[1.0, 2.0, -1.0][..]));
//! assert_eq!(array.component(&[0])?.shape(), [3]);
//! # Ok::<(), tautline_problem::array::ArrayError>(())
//! ```

mod array_error;
mod npy;
mod picture;

pub use array_error::ArrayError;

/// Numbers along axes, in memory row by row: the last axis varies fastest.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    shape: Vec<usize>,
    values: Vec<f64>,
}

impl Array {
    /// Returns the array of these numbers.
    ///
    /// # Errors
    ///
    /// [`ArrayError::Count`] if there are not as many numbers as the shape says.
    pub fn new(shape: Vec<usize>, values: Vec<f64>) -> Result<Self, ArrayError> {
        match count(&shape) {
            Some(expected) if expected == values.len() => Ok(Self { shape, values }),
            _ => Err(ArrayError::Count { shape, found: values.len() }),
        }
    }

    /// Reads the bytes of a NPY or PNG file; what it is shows in its first bytes.
    ///
    /// An integer beyond `2⁵³` is rounded to the nearest float.
    ///
    /// # Errors
    ///
    /// [`ArrayError`].
    pub fn read(file: &[u8]) -> Result<Self, ArrayError> {
        if file.starts_with(npy::MAGIC) {
            npy::read(file)
        } else if Self::is_picture(file) {
            picture::read(file)
        } else {
            Err(ArrayError::Unknown)
        }
    }

    /// Returns whether the bytes begin as those of a PNG file, whose last axis, if it has three, are channels.
    #[must_use]
    pub fn is_picture(file: &[u8]) -> bool {
        file.starts_with(picture::MAGIC)
    }

    /// Returns the lengths of the axes.
    #[must_use]
    pub fn shape(&self) -> &[usize] {
        &self.shape
    }

    /// Returns the numbers.
    #[must_use]
    pub fn values(&self) -> &[f64] {
        &self.values
    }

    /// Returns the shape and the numbers.
    #[must_use]
    pub fn into_parts(self) -> (Vec<usize>, Vec<f64>) {
        (self.shape, self.values)
    }

    /// Returns the array of the first axes that has these indices, from 0, on the last ones: one channel
    /// of a picture, or one entry of a matrix at each point.
    ///
    /// # Errors
    ///
    /// [`ArrayError::Component`] if there is no such entry.
    pub fn component(&self, index: &[usize]) -> Result<Self, ArrayError> {
        let wrong = || ArrayError::Component { index: index.to_vec(), shape: self.shape.clone() };
        let first = self.shape.len().checked_sub(index.len()).ok_or_else(wrong)?;
        let (shape, last) = self.shape.split_at(first);
        if index.iter().zip(last).any(|(index, length)| index >= length) {
            return Err(wrong());
        }
        if self.values.is_empty() {
            return Ok(Self { shape: shape.to_vec(), values: Vec::new() });
        }
        let at = index.iter().zip(last).fold(0, |at, (index, length)| at * length + index);
        // The last axes have an entry, and no more than the whole array: a step is at least 1.
        let step = last.iter().product();
        let values = self.values.iter().skip(at).step_by(step).copied().collect();
        Ok(Self { shape: shape.to_vec(), values })
    }
}

/// Returns how many numbers an array of this shape has, if memory could hold them.
pub(crate) fn count(shape: &[usize]) -> Option<usize> {
    shape.iter().try_fold(1_usize, |count, &length| count.checked_mul(length))
}
