//! The sample points of a heat-map.

use contour::ContourBuilder;

use crate::error::DrawingError;

/// A rectangular grid that extends one cell beyond the rectangle it covers.
///
/// Contours therefore leave the panel through its edge instead of closing along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Grid {
    pub(crate) columns: usize,
    pub(crate) rows: usize,
    pub(crate) origin: (f64, f64),
    pub(crate) step: (f64, f64),
}

/// The shorter side has at least this many cells, however long the other one is.
const FEWEST: f64 = 40.0;

impl Grid {
    /// Returns a grid with `cells` cells along the longer side of the rectangle `x × y`.
    ///
    /// # Errors
    ///
    /// If the ends of a side are not finite and increasing.
    pub(crate) fn over(x: (f64, f64), y: (f64, f64), cells: f64) -> Result<Grid, DrawingError> {
        for (from, to) in [x, y] {
            if !(from < to && (to - from).is_finite()) {
                let want = "a side of a field must be finite and increasing";
                return Err(DrawingError::BadRange { from, to, want });
            }
        }
        let (width, height) = (x.1 - x.0, y.1 - y.0);
        let along = |side: f64| (cells * side / width.max(height)).ceil().max(FEWEST);
        let step = (width / along(width), height / along(height));
        let (columns, rows) = (along(width) as usize + 3, along(height) as usize + 3);
        Ok(Grid { columns, rows, origin: (x.0 - step.0, y.0 - step.1), step })
    }

    /// Returns the grid with `parts` cells in each direction for each cell of this one.
    pub(crate) fn refined(&self, parts: usize) -> Grid {
        let step = (self.step.0 / parts as f64, self.step.1 / parts as f64);
        let (columns, rows) = ((self.columns - 1) * parts + 1, (self.rows - 1) * parts + 1);
        Grid { columns, rows, origin: self.origin, step }
    }

    /// Returns the sample point in column `i` and row `j`; both may be fractions.
    pub(crate) fn point(&self, i: f64, j: f64) -> (f64, f64) {
        (self.origin.0 + i * self.step.0, self.origin.1 + j * self.step.1)
    }

    /// Returns whether a sample point lies in the rectangle that the grid covers.
    pub(crate) fn is_inside(&self, i: usize, j: usize) -> bool {
        (1..self.columns - 1).contains(&i) && (1..self.rows - 1).contains(&j)
    }

    /// Returns all sample points, row by row.
    pub(crate) fn points(&self) -> impl Iterator<Item = (f64, f64)> {
        let rows = 0..self.rows;
        rows.flat_map(move |j| (0..self.columns).map(move |i| self.point(i as f64, j as f64)))
    }

    /// Returns the boundary of `{f ≥ level}` as closed rings, where `f` has the value `values[k]`
    /// at the `k`-th sample point. Outer rings and holes have opposite orientations.
    ///
    /// # Errors
    ///
    /// If the contour library fails; the error contains its message.
    pub(crate) fn rings(
        &self,
        values: &[f64],
        level: f64,
    ) -> Result<Vec<Vec<(f64, f64)>>, DrawingError> {
        let lines = ContourBuilder::new(self.columns, self.rows, true)
            .lines(values, &[level])
            .map_err(|error| DrawingError::Backend(error.to_string()))?;
        let rings = lines.iter().flat_map(|line| line.geometry().0.iter());
        // The library counts in cells, and places the first sample at one half.
        let data = |x: f64, y: f64| self.point(x - 0.5, y - 0.5);
        Ok(rings.map(|ring| ring.0.iter().map(|p| data(p.x, p.y)).collect()).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::Grid;

    #[test]
    fn a_finer_grid_has_the_points_of_the_coarse_one() {
        let grid = Grid::over((0.0, 4.0), (-1.0, 1.0), 80.0).expect("a rectangle");
        let fine = grid.refined(3);
        assert_eq!(grid.points().count(), grid.columns * grid.rows);
        for (i, j) in [(0, 0), (5, 7), (grid.columns - 1, grid.rows - 1)] {
            let (a, b) = grid.point(i as f64, j as f64);
            let (c, d) = fine.point(3.0 * i as f64, 3.0 * j as f64);
            assert!((a - c).abs() <= 1e-12 && (b - d).abs() <= 1e-12, "({i}, {j})");
        }
        assert_eq!(fine.columns, 3 * grid.columns - 2);
    }
}
