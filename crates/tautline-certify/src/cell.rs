//! `Cell`: a box in `R^D`.

use nalgebra::SVector;
use tautline_scalar::Interval;

use crate::CertifyError;

/// A closed box, the product of `D` finite intervals, in `ℓ`.
///
/// ```
/// use tautline_certify::Cell;
///
/// let cell = Cell::new([0.0, -1.0], [2.0, 1.0])?;
/// assert!(cell.contains(&[1.0, 0.5].into()));
/// assert!(Cell::new([0.0], [-1.0]).is_err());
/// # Ok::<(), tautline_certify::CertifyError>(())
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[doc(alias = "box")]
pub struct Cell<const D: usize> {
    sides: [Interval; D],
}

impl<const D: usize> Cell<D> {
    /// Returns the box between two opposite corners, in `ℓ`. A side may have width 0.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotASide`] if a corner is not finite, or if the lower one exceeds the upper
    /// in some coordinate.
    pub fn new(
        lower: impl Into<SVector<f64, D>>,
        upper: impl Into<SVector<f64, D>>,
    ) -> Result<Self, CertifyError> {
        let (lower, upper) = (lower.into(), upper.into());
        let mut sides = [Interval::point(0.0); D];
        for (coordinate, side) in sides.iter_mut().enumerate() {
            let (lo, hi) = (lower[coordinate], upper[coordinate]);
            let refuse = |cause| CertifyError::NotASide { coordinate, lo, hi, cause };
            *side = Interval::new(lo, hi).map_err(|cause| refuse(Some(cause)))?;
            if !side.is_finite() {
                return Err(refuse(None));
            }
        }
        Ok(Self { sides })
    }

    /// Returns the `D` sides, in `ℓ`.
    #[must_use]
    pub fn sides(&self) -> &[Interval; D] {
        &self.sides
    }

    /// Returns the midpoint, up to rounding, in `ℓ`. It always lies in the box.
    #[must_use]
    pub fn midpoint(&self) -> SVector<f64, D> {
        SVector::from_fn(|i, _| self.sides[i].midpoint())
    }

    /// Returns whether `x`, in `ℓ`, lies in the closed box.
    #[must_use]
    pub fn contains(&self, x: &SVector<f64, D>) -> bool {
        self.sides.iter().zip(x).all(|(side, &x)| side.contains(x))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::Cell;

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
    fn a_cell_contains_its_midpoint() {
        let cell = Cell::new([0.0, -1.0], [2.0, 1.0]).expect("in order");
        assert!(cell.contains(&cell.midpoint()) && !cell.contains(&vector![3.0, 0.5]));
    }
}
