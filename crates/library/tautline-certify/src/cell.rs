//! `Cell`: a box in space.

use tautline_scalar::Interval;

use crate::CertifyError;

/// A closed box, the product of finite intervals, in `ℓ`. Its dimension is a value.
///
/// ```
/// use tautline_certify::Cell;
///
/// let cell = Cell::new([0.0, -1.0], [2.0, 1.0])?;
/// assert!(cell.contains(&[1.0, 0.5]));
/// assert!(Cell::new([0.0], [-1.0]).is_err());
/// # Ok::<(), tautline_certify::CertifyError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
#[doc(alias = "box")]
pub struct Cell {
    sides: Vec<Interval>,
}

impl Cell {
    /// Returns the box between two opposite corners, in `ℓ`. A side may have width 0.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotASide`] if a corner is not finite, or if the lower one exceeds the upper
    /// in some coordinate; [`CertifyError::Coordinates`] if the corners have different numbers of
    /// coordinates.
    pub fn new(lower: impl AsRef<[f64]>, upper: impl AsRef<[f64]>) -> Result<Self, CertifyError> {
        let (lower, upper) = (lower.as_ref(), upper.as_ref());
        CertifyError::check_coordinates("a corner", upper.len(), lower.len())?;
        let side = |(coordinate, (&lo, &hi)): (usize, (&f64, &f64))| {
            let refuse = |cause| CertifyError::NotASide { coordinate, lo, hi, cause };
            let side = Interval::new(lo, hi).map_err(|cause| refuse(Some(cause)))?;
            if side.is_finite() { Ok(side) } else { Err(refuse(None)) }
        };
        let sides = lower.iter().zip(upper).enumerate().map(side).collect::<Result<_, _>>()?;
        Ok(Self { sides })
    }

    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.sides.len()
    }

    /// Returns the sides, in `ℓ`.
    #[must_use]
    pub fn sides(&self) -> &[Interval] {
        &self.sides
    }

    /// Returns the midpoint, up to rounding, in `ℓ`. It always lies in the box.
    #[must_use]
    pub fn midpoint(&self) -> Vec<f64> {
        self.sides.iter().map(|side| side.midpoint()).collect()
    }

    /// Returns whether `x`, in `ℓ`, lies in the closed box.
    #[must_use]
    pub fn contains(&self, x: &[f64]) -> bool {
        x.len() == self.sides.len() && self.sides.iter().zip(x).all(|(side, &x)| side.contains(x))
    }
}

#[cfg(test)]
mod tests {
    use super::Cell;
    use crate::CertifyError;

    #[test]
    fn corners_out_of_order_or_infinite_are_refused() {
        for (lo, hi) in
            [(1.0, 0.0), (f64::NAN, 1.0), (0.0, f64::INFINITY), (f64::NEG_INFINITY, 0.0)]
        {
            let error = Cell::new([0.0, lo], [1.0, hi]).expect_err("not a box");
            assert!(error.to_string().contains("side 1"), "{error}");
        }
    }

    #[test]
    fn corners_in_different_spaces_are_refused() {
        let error = Cell::new([0.0, 0.0], [1.0]).expect_err("one coordinate is missing");
        assert_eq!(error, CertifyError::Coordinates { what: "a corner", found: 1, dimension: 2 });
    }

    #[test]
    fn a_cell_contains_its_midpoint() {
        let cell = Cell::new([0.0, -1.0], [2.0, 1.0]).expect("in order");
        assert!(cell.contains(&cell.midpoint()) && !cell.contains(&[3.0, 0.5]));
    }
}
