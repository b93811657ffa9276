//! The Gram matrix as the drawing needs it.

use std::cell::RefCell;

use super::{Portrait, PortraitError, determinant::determinant};

/// Evaluates the Gram matrix, and remembers the first matrix of the wrong size.
pub(crate) struct Gram<'a> {
    portrait: &'a Portrait<'a>,
    wrong: RefCell<Option<PortraitError>>,
}

impl<'a> Gram<'a> {
    pub(crate) fn of(portrait: &'a Portrait<'a>) -> Gram<'a> {
        Gram { portrait, wrong: RefCell::new(None) }
    }

    /// Returns `H(x)`, column by column, if it is defined and finite.
    fn at(&self, x: &[f64]) -> Option<Vec<f64>> {
        let dimension = self.portrait.dimension;
        let matrix = (self.portrait.gram)(x)?;
        if matrix.len() != dimension * dimension {
            let (at, length) = (x.to_vec(), matrix.len());
            self.wrong.borrow_mut().get_or_insert(PortraitError::Gram { at, length, dimension });
            return None;
        }
        matrix.iter().all(|entry| entry.is_finite()).then_some(matrix)
    }

    /// Returns `det H(x)`.
    pub(crate) fn determinant(&self, x: &[f64]) -> Option<f64> {
        Some(determinant(self.at(x)?, self.portrait.dimension))
    }

    /// Returns the entries `Hᵢᵢ`, `Hᵢⱼ` and `Hⱼⱼ` at `x`.
    pub(crate) fn block(&self, x: &[f64], [i, j]: [usize; 2]) -> Option<[f64; 3]> {
        let (matrix, n) = (self.at(x)?, self.portrait.dimension);
        Some([matrix[i * n + i], (matrix[i * n + j] + matrix[j * n + i]) / 2.0, matrix[j * n + j]])
    }

    /// Returns the error of the first matrix of the wrong size, if there was one.
    pub(crate) fn check(self) -> Result<(), PortraitError> {
        self.wrong.into_inner().map_or(Ok(()), Err)
    }
}
