//! Values of a function that need not be defined everywhere.

use super::{gaps::Gaps, grid::Grid};
use crate::error::DrawingError;

/// The values of a function on a rectangle, from which a [`Field`](super::Field) is made once its
/// levels are chosen.
#[derive(Clone, Debug)]
#[must_use]
pub struct Samples {
    pub(super) grid: Grid,
    /// The samples. Those next to the edge of a gap are continued into it, so that contours reach
    /// the edge.
    pub(super) values: Vec<Option<f64>>,
    pub(super) gaps: Option<Gaps>,
    /// The samples inside the rectangle, without continuation, in increasing order.
    sorted: Vec<f64>,
}

impl Samples {
    /// Samples `f` on the rectangle `x × y`, with `cells` cells along the longer side. The samples
    /// extend one cell beyond the rectangle. A value that is not finite counts as not defined.
    ///
    /// # Errors
    ///
    /// If the ends of a side are not finite and increasing.
    pub fn on(
        x: (f64, f64),
        y: (f64, f64),
        cells: u16,
        f: impl Fn(f64, f64) -> Option<f64>,
    ) -> Result<Samples, DrawingError> {
        let grid = Grid::over(x, y, f64::from(cells))?;
        let f = |x: f64, y: f64| f(x, y).filter(|value| value.is_finite());
        let mut values: Vec<Option<f64>> = grid.points().map(|(x, y)| f(x, y)).collect();
        let inside = |k: &usize| grid.is_inside(k % grid.columns, k / grid.columns);
        let mut sorted: Vec<f64> =
            (0..values.len()).filter(inside).filter_map(|k| values[k]).collect();
        sorted.sort_by(f64::total_cmp);
        let known: Vec<bool> = values.iter().map(Option::is_some).collect();
        let gaps = Gaps::find(&grid, &known, |x, y| f(x, y).is_some());
        if gaps.is_some() {
            values = continued(&grid, &values);
        }
        Ok(Samples { grid, values, gaps, sorted })
    }

    /// Returns the values inside the rectangle, in increasing order.
    #[must_use]
    pub fn sorted(&self) -> &[f64] {
        &self.sorted
    }

    /// Returns the samples of `f` divided by a positive number.
    pub fn divided_by(mut self, unit: f64) -> Samples {
        let all = self.values.iter_mut().flatten().chain(&mut self.sorted);
        all.for_each(|value| *value /= unit);
        self
    }

    /// Returns whether the function is not defined at some sample.
    #[must_use]
    pub fn has_gaps(&self) -> bool {
        self.gaps.is_some()
    }
}

/// Gives each sample that is missing the mean of its neighbours.
fn continued(grid: &Grid, values: &[Option<f64>]) -> Vec<Option<f64>> {
    let near = |k: usize, count: usize| k.saturating_sub(1)..(k + 2).min(count);
    let mean = |i: usize, j: usize| {
        let rows = near(j, grid.rows);
        let cells = rows.flat_map(|j| near(i, grid.columns).map(move |i| j * grid.columns + i));
        let known: Vec<f64> = cells.filter_map(|k| values[k]).collect();
        // Divided before they are added, since the sum may overflow.
        (!known.is_empty()).then(|| known.iter().map(|value| value / known.len() as f64).sum())
    };
    let all = values.iter().enumerate();
    all.map(|(k, value)| value.or_else(|| mean(k % grid.columns, k / grid.columns))).collect()
}

#[cfg(test)]
mod tests {
    use super::Samples;

    #[test]
    fn only_defined_values_count() {
        let root = |x: f64, _: f64| (x >= 0.0).then(|| x.sqrt());
        let samples = Samples::on((-1.0, 1.0), (0.0, 1.0), 100, root).expect("a rectangle");
        assert!(samples.has_gaps());
        let sorted = samples.sorted();
        assert!(sorted[0] == 0.0 && sorted.windows(2).all(|pair| pair[0] <= pair[1]));
        let infinite = Samples::on((-1.0, 1.0), (0.0, 1.0), 100, |x, _| Some(1.0 / x.max(0.0)));
        let infinite = infinite.expect("a rectangle");
        assert!(infinite.has_gaps() && infinite.sorted().iter().all(|value| value.is_finite()));
    }
}
