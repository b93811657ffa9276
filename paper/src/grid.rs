//! `Grid`: numbers on a rectangular grid, and a smooth function that interpolates them.

use crate::Failure;

/// Values at the crossings of equidistant lines, with at least four lines in each direction.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    x: Lines,
    y: Lines,
    /// The value at the `i`-th `x` and the `j`-th `y` is `values[j * x.count + i]`.
    values: Vec<f64>,
}

/// A family of equidistant lines.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lines {
    /// The first line.
    pub from: f64,
    /// The last line.
    pub to: f64,
    /// The number of lines.
    pub count: usize,
}

impl Lines {
    /// Returns the place of the `k`-th line.
    #[must_use]
    pub fn at(&self, k: usize) -> f64 {
        self.from + (self.to - self.from) * k as f64 / (self.count - 1) as f64
    }

    /// Returns all lines.
    pub fn all(self) -> impl Iterator<Item = f64> {
        (0..self.count).map(move |k| self.at(k))
    }

    /// Returns the first of the four lines around `place`, and the weights of the four.
    ///
    /// The weights are those of Lagrange's cubic, which is exact for polynomials of degree 3. Near
    /// the edge and slightly beyond it, the cubic through the last four lines is used.
    fn weights(&self, place: f64) -> (usize, [f64; 4]) {
        let s = (place - self.from) / (self.to - self.from) * (self.count - 1) as f64;
        let first = (s.floor() - 1.0).clamp(0.0, (self.count - 4) as f64);
        let t = s - first;
        let weights = [
            -(t - 1.0) * (t - 2.0) * (t - 3.0) / 6.0,
            t * (t - 2.0) * (t - 3.0) / 2.0,
            -t * (t - 1.0) * (t - 3.0) / 2.0,
            t * (t - 1.0) * (t - 2.0) / 6.0,
        ];
        (first as usize, weights)
    }
}

impl Grid {
    /// Returns the grid with the given values, row by row from the lowest `y`.
    ///
    /// # Errors
    ///
    /// [`Failure::Data`] unless there are four lines in each direction and one finite value at each
    /// crossing.
    pub fn new(x: Lines, y: Lines, values: Vec<f64>) -> Result<Grid, Failure> {
        let complete = x.count >= 4 && y.count >= 4 && values.len() == x.count * y.count;
        if complete && values.iter().all(|value| value.is_finite()) {
            return Ok(Grid { x, y, values });
        }
        let (rows, columns) = (y.count, x.count);
        Err(Failure::Data(format!("{} values for a grid of {columns} × {rows}", values.len())))
    }

    /// Returns the value of the function at a point. The function is continuous, and cubic in each
    /// direction.
    #[must_use]
    pub fn at(&self, x: f64, y: f64) -> f64 {
        let ((i, across), (j, up)) = (self.x.weights(x), self.y.weights(y));
        let value = |p: usize, q: usize| self.values[(j + q) * self.x.count + i + p];
        (0..4).map(|q| up[q] * (0..4).map(|p| across[p] * value(p, q)).sum::<f64>()).sum()
    }

    /// Returns the grid point with the smallest value, and that value.
    #[must_use]
    pub fn least(&self) -> ((f64, f64), f64) {
        let all = self.values.iter().enumerate();
        let (k, value) = all.min_by(|a, b| a.1.total_cmp(b.1)).expect("sixteen values at least");
        ((self.x.at(k % self.x.count), self.y.at(k / self.x.count)), *value)
    }
}
