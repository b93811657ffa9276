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

/// A longer side is cut at the geometric mean of its ends, in `ℓ`.
///
/// If the length scale of a metric differs much from this unit, a few more cuts are needed.
const UNIT: f64 = 1.0;

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

    /// Returns the point of the box nearest to `x`, both in `ℓ`.
    pub(crate) fn nearest(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        SVector::from_fn(|i, _| x[i].clamp(self.sides[i].lo(), self.sides[i].hi()))
    }

    /// Cuts the box across `coordinate`. Returns `None` if there is no double strictly between the
    /// ends of that side.
    pub(crate) fn halves(&self, coordinate: usize) -> Option<[Self; 2]> {
        let side = self.sides[coordinate];
        let (lo, hi) = (side.lo(), side.hi());
        let cut = if lo < 0.0 && hi > 0.0 && side.width() > 4.0 * UNIT {
            0.0
        } else if side.mignitude().max(UNIT) < 0.25 * side.magnitude() {
            let geometric = side.mignitude().max(UNIT).sqrt() * side.magnitude().sqrt();
            geometric.copysign(if hi > 0.0 { 1.0 } else { -1.0 })
        } else {
            side.midpoint()
        };
        if !(lo < cut && cut < hi) {
            return None;
        }
        Some([(lo, cut), (cut, hi)].map(|(lo, hi)| {
            let mut half = *self;
            half.sides[coordinate] = Interval::new(lo, hi).expect("ends in order");
            half
        }))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::Cell;

    #[test]
    fn halves_cover_the_cell_and_shrink() {
        let far = 2.0_f64.powi(100);
        for (lo, hi) in
            [(0.0, 1.0), (-far, far), (0.0, far), (-far, -1e-3), (-1e-9, 5.0), (3.0, far)]
        {
            let mut cells = vec![Cell::new([lo], [hi]).expect("in order")];
            for _ in 0..12 {
                cells = cells
                    .iter()
                    .flat_map(|cell| {
                        let [a, b] = cell.halves(0).expect("wide");
                        assert_eq!(a.sides()[0].hi(), b.sides()[0].lo());
                        let (x, y) = (cell.sides()[0], a.sides()[0].hull(b.sides()[0]));
                        assert_eq!((x.lo(), x.hi()), (y.lo(), y.hi()));
                        [a, b]
                    })
                    .collect();
            }
            // A geometric cut halves the exponent: after 12 cuts every cell either has width at
            // most 4, or its two ends have a ratio of at most 4.
            for cell in cells {
                let side = cell.sides()[0];
                let narrow = side.width() <= 4.0 || side.magnitude() <= 4.0 * side.mignitude();
                assert!(narrow, "{side:?} of [{lo}, {hi}]");
            }
        }
    }

    #[test]
    fn a_side_without_a_double_inside_has_no_halves() {
        let cell = Cell::new([1.0, 0.0], [1.0_f64.next_up(), 0.0]).expect("in order");
        assert_eq!(cell.halves(0), None);
        assert_eq!(cell.halves(1), None);
    }

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
    fn the_nearest_point_of_a_cell_is_clamped() {
        let cell = Cell::new([0.0, -1.0], [2.0, 1.0]).expect("in order");
        assert_eq!(cell.nearest(&vector![3.0, 0.5]), vector![2.0, 0.5]);
        assert!(cell.contains(&cell.midpoint()) && !cell.contains(&vector![3.0, 0.5]));
    }
}
