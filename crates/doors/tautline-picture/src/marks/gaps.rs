//! The part of a panel in which a field has no value.

use super::grid::Grid;
use crate::error::DrawingError;

/// Where a field is not defined, on a grid finer than that of the field.
#[derive(Clone, Debug)]
pub(crate) struct Gaps {
    grid: Grid,
    /// One where the field is not defined, zero elsewhere.
    missing: Vec<f64>,
}

/// The number of cells across one cell of the field. A cell is then about 1 px wide.
const PARTS: usize = 3;
/// Number of cells between two lines of the hatching.
const APART: usize = 9;

impl Gaps {
    /// Finds the gaps of a field that is defined at the `k`-th point of `coarse` if `known[k]`;
    /// `None` if it is defined at all of them.
    ///
    /// The function `is_defined` is called only in cells whose corners differ.
    pub(crate) fn find(
        coarse: &Grid,
        known: &[bool],
        is_defined: impl Fn(f64, f64) -> bool,
    ) -> Option<Gaps> {
        if known.iter().all(|known| *known) {
            return None;
        }
        let grid = coarse.refined(PARTS);
        let known = |i: usize, j: usize| known[j * coarse.columns + i];
        let mut missing = Vec::with_capacity(grid.columns * grid.rows);
        for j in 0..grid.rows {
            for i in 0..grid.columns {
                let (low, high) = ((i / PARTS, j / PARTS), (i.div_ceil(PARTS), j.div_ceil(PARTS)));
                let first = known(low.0, low.1);
                let corners = [(high.0, low.1), (low.0, high.1), high];
                let same = corners.into_iter().all(|(i, j)| known(i, j) == first);
                let (x, y) = grid.point(i as f64, j as f64);
                let defined = if same { first } else { is_defined(x, y) };
                missing.push(f64::from(u8::from(!defined)));
            }
        }
        Some(Gaps { grid, missing })
    }

    /// Returns the boundary of the gaps as closed rings.
    pub(crate) fn rings(&self) -> Result<Vec<Vec<(f64, f64)>>, DrawingError> {
        self.grid.rings(&self.missing, 0.5)
    }

    /// Returns the rising diagonal lines that cover the gaps.
    pub(crate) fn hatching(&self) -> Vec<[(f64, f64); 2]> {
        let Grid { columns, rows, .. } = self.grid;
        let mut lines = Vec::new();
        for start in (0..columns + rows).step_by(APART) {
            // The diagonal i − j = start − rows, from the lower left to the upper right.
            let mut open: Option<(usize, usize)> = None;
            let mut last = None;
            for j in 0..rows {
                let Some(i) = (start + j).checked_sub(rows).filter(|i| *i < columns) else {
                    continue;
                };
                if self.missing[j * columns + i] > 0.5 {
                    open = open.or(Some((i, j)));
                    last = Some((i, j));
                } else if let (Some(from), Some(to)) = (open.take(), last) {
                    lines.push(self.line(from, to));
                }
            }
            if let (Some(from), Some(to)) = (open, last) {
                lines.push(self.line(from, to));
            }
        }
        lines
    }

    fn line(&self, from: (usize, usize), to: (usize, usize)) -> [(f64, f64); 2] {
        [from, to].map(|(i, j)| self.grid.point(i as f64, j as f64))
    }
}

#[cfg(test)]
mod tests {
    use super::{Gaps, Grid};

    #[test]
    fn a_hole_is_found_to_a_third_of_a_cell() {
        let grid = Grid::over((-1.0, 1.0), (-1.0, 1.0), 100.0).expect("a rectangle");
        let outside = |x: f64, y: f64| x.hypot(y) > 0.5;
        let known: Vec<bool> = grid.points().map(|(x, y)| outside(x, y)).collect();
        let gaps = Gaps::find(&grid, &known, outside).expect("a hole");
        let rings = gaps.rings().expect("contours");
        assert_eq!(rings.len(), 1);
        // A ring runs half-way between neighbours of the fine grid, whose diagonal is √2 · 0.02/3.
        assert!(rings[0].iter().all(|(x, y)| (x.hypot(*y) - 0.5).abs() <= 0.0095));
        let lines = gaps.hatching();
        assert!(lines.len() > 5);
        assert!(lines.concat().iter().all(|(x, y)| x.hypot(*y) <= 0.5 + 1e-12));
        assert!(Gaps::find(&grid, &vec![true; known.len()], outside).is_none());
    }
}
