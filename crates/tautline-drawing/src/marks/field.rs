//! A function of two variables, shown as filled contour bands.

use contour::ContourBuilder;

use crate::{
    colours::{Colour, Ramp},
    error::DrawingError,
};

/// A sampled function, with the levels that separate its bands.
#[derive(Clone, Debug)]
#[must_use]
pub struct Field {
    columns: usize,
    rows: usize,
    origin: (f64, f64),
    step: (f64, f64),
    values: Vec<f64>,
    levels: Vec<f64>,
    /// Whether `x` is sampled logarithmically, so that contours are smooth on a logarithmic axis.
    decades: bool,
    pub(crate) line_every: usize,
    pub(crate) label: String,
}

/// The number of cells along the longer side: enough for smooth contours at three pixels per px.
const CELLS: f64 = 360.0;

impl Field {
    /// Samples `f` on the rectangle `x × y`, for bands between neighbouring `levels`.
    ///
    /// The samples extend one cell beyond the rectangle, and `f` must be finite there too. Contours
    /// therefore leave the panel through its edge instead of closing along it.
    ///
    /// # Errors
    ///
    /// If the levels or the ends of a side are not increasing, or if a sample is not finite.
    pub fn sample(
        x: (f64, f64),
        y: (f64, f64),
        levels: Vec<f64>,
        f: impl Fn(f64, f64) -> f64,
    ) -> Result<Field, DrawingError> {
        let increasing = levels.windows(2).all(|pair| pair[0] < pair[1]);
        if !(increasing && levels.len() >= 2 && levels.iter().all(|level| level.is_finite())) {
            return Err(DrawingError::BadLevels { levels });
        }
        for (from, to) in [x, y] {
            if !(from < to && (to - from).is_finite()) {
                let want = "a side of a field must be finite and increasing";
                return Err(DrawingError::BadRange { from, to, want });
            }
        }
        let (width, height) = (x.1 - x.0, y.1 - y.0);
        // The shorter side has at least 40 cells, however long the other one is.
        let cells = |side: f64| (CELLS * side / width.max(height)).ceil().max(40.0);
        let step = (width / cells(width), height / cells(height));
        let (columns, rows) = (cells(width) as usize + 3, cells(height) as usize + 3);
        let origin = (x.0 - step.0, y.0 - step.1);
        let mut values = Vec::with_capacity(columns * rows);
        for j in 0..rows {
            for i in 0..columns {
                let (a, b) = (origin.0 + i as f64 * step.0, origin.1 + j as f64 * step.1);
                let value = f(a, b);
                if !value.is_finite() {
                    return Err(DrawingError::NotFinite { x: a, y: b, value });
                }
                values.push(value);
            }
        }
        let (decades, line_every, label) = (false, 0, String::new());
        Ok(Field { columns, rows, origin, step, values, levels, decades, line_every, label })
    }

    /// Samples `f` as [`sample`](Field::sample) does, for a panel whose `x` axis is logarithmic.
    ///
    /// # Errors
    ///
    /// The errors of `sample`, and an error if `x` is not positive.
    pub fn sample_over_decades(
        x: (f64, f64),
        y: (f64, f64),
        levels: Vec<f64>,
        f: impl Fn(f64, f64) -> f64,
    ) -> Result<Field, DrawingError> {
        let exponents = (x.0.log10(), x.1.log10());
        let field = Field::sample(exponents, y, levels, |x, y| f(10_f64.powf(x), y))?;
        Ok(Field { decades: true, ..field })
    }

    /// Names the quantity in a label above the colour bar.
    pub fn labelled(mut self, label: impl Into<String>) -> Field {
        self.label = label.into();
        self
    }

    /// Draws a contour line at every `k`-th level, starting from the lowest.
    pub fn lined_every(mut self, k: usize) -> Field {
        self.line_every = k;
        self
    }

    /// Returns the levels.
    #[must_use]
    pub fn levels(&self) -> &[f64] {
        &self.levels
    }

    /// Returns the colour between level `k` and the next one.
    pub fn colour(&self, k: usize) -> Colour {
        let bands = self.levels.len() - 1;
        Ramp::blue().at((k as f64 + 0.5) / bands as f64)
    }

    /// Returns the boundary of `{f ≥ level}` as closed rings of data points. Outer rings and holes
    /// have opposite orientations.
    ///
    /// # Errors
    ///
    /// If the contour library fails; the error contains its message.
    pub fn rings(&self, level: f64) -> Result<Vec<Vec<(f64, f64)>>, DrawingError> {
        let lines = ContourBuilder::new(self.columns, self.rows, true)
            .lines(&self.values, &[level])
            .map_err(|error| DrawingError::Backend(error.to_string()))?;
        // The library counts in cells, and places the first sample at one half.
        let data = |x: f64, y: f64| {
            let across = self.origin.0 + (x - 0.5) * self.step.0;
            let across = if self.decades { 10_f64.powf(across) } else { across };
            (across, self.origin.1 + (y - 0.5) * self.step.1)
        };
        let rings = lines.iter().flat_map(|line| line.geometry().0.iter());
        let ring = |points: Vec<(f64, f64)>| without_straight_points(&points);
        Ok(rings.map(|line| ring(line.0.iter().map(|p| data(p.x, p.y)).collect())).collect())
    }
}

/// Removes the inner points of straight pieces. A field that depends on one variable has only
/// straight contours, with a point in each row of cells.
fn without_straight_points(ring: &[(f64, f64)]) -> Vec<(f64, f64)> {
    let mut kept: Vec<(f64, f64)> = Vec::with_capacity(ring.len());
    for &point in ring {
        while let [.., (x0, y0), (x1, y1)] = kept[..] {
            let (dx, dy) = (x1 - x0, y1 - y0);
            let (ex, ey) = (point.0 - x1, point.1 - y1);
            let ahead = dx * ex + dy * ey >= 0.0;
            // Straight up to rounding, so that no error accumulates along a bend.
            if !(ahead && (dx * ey - dy * ex).abs() <= 1e-9 * dx.hypot(dy) * ex.hypot(ey)) {
                break;
            }
            kept.pop();
        }
        kept.push(point);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::{DrawingError, Field};

    #[test]
    fn the_contour_of_a_cone_is_a_circle() {
        let cone = |x: f64, y: f64| 2.0 - x.hypot(y);
        let field = Field::sample((-2.0, 2.0), (-2.0, 2.0), vec![0.0, 1.0], cone).expect("finite");
        let rings = field.rings(1.0).expect("contours");
        assert_eq!(rings.len(), 1);
        // Linear interpolation across a cell of size h = 4/360 misses a circle by at most h²/8.
        for (x, y) in &rings[0] {
            assert!((x.hypot(*y) - 1.0).abs() <= 2e-5, "({x}, {y})");
        }
    }

    #[test]
    fn over_decades_a_power_law_has_straight_contours() {
        let power = |x: f64, y: f64| x.log10() - y;
        let levels = vec![-9.0, 0.5];
        let field = Field::sample_over_decades((1e-2, 1e2), (-2.0, 2.0), levels, power);
        let rings = field.expect("finite").rings(0.5).expect("contours");
        let inside = |&(x, y): &(f64, f64)| (0.011..90.0).contains(&x) && y.abs() < 1.9;
        let crossed: Vec<_> = rings.concat().into_iter().filter(inside).collect();
        // The function is linear between its samples, so this holds up to rounding.
        assert!(crossed.len() > 100);
        assert!(crossed.iter().all(|(x, y)| (x.log10() - y - 0.5).abs() <= 1e-9), "{crossed:?}");
        let unit = (0.0, 1.0);
        assert!(Field::sample_over_decades(unit, unit, vec![0.0, 1.0], |x, _| x).is_err());
    }

    #[test]
    fn straight_contours_have_few_points() {
        let field = Field::sample((0.0, 2.0), (0.0, 1.0), vec![0.0, 1.0], |x, _| x * x);
        let rings = field.expect("finite").rings(1.0).expect("contours");
        assert!(rings.len() == 1 && rings[0].len() <= 12, "{rings:?}");
        assert!(rings[0].iter().any(|point| (point.0 - 1.0).abs() <= 1e-4));
    }

    #[test]
    fn a_hole_runs_the_other_way_round() {
        let rim = |x: f64, y: f64| -(x.hypot(y) - 1.0).abs();
        let field = Field::sample((-2.0, 2.0), (-2.0, 2.0), vec![-1.0, -0.5], rim).expect("finite");
        let rings = field.rings(-0.5).expect("contours");
        let area = |ring: &[(f64, f64)]| -> f64 {
            ring.windows(2).map(|w| w[0].0 * w[1].1 - w[1].0 * w[0].1).sum::<f64>() / 2.0
        };
        let areas: Vec<f64> = rings.iter().map(|ring| area(ring)).collect();
        assert_eq!(areas.len(), 2);
        assert!(areas[0] * areas[1] < 0.0, "{areas:?}");
    }

    #[test]
    fn colours_darken_with_the_value() {
        let levels: Vec<f64> = (0..=8).map(f64::from).collect();
        let field = Field::sample((0.0, 1.0), (0.0, 1.0), levels, |x, _| x).expect("finite");
        let lightness: Vec<f64> = (0..8).map(|k| field.colour(k).oklab()[0]).collect();
        assert!(lightness.windows(2).all(|w| w[1] < w[0]));
    }

    #[test]
    fn what_has_no_colour_is_refused() {
        let unit = (0.0, 1.0);
        let nan = Field::sample(unit, unit, vec![0.0, 1.0], |_, _| f64::NAN);
        assert!(matches!(nan, Err(DrawingError::NotFinite { .. })));
        for levels in [vec![], vec![1.0], vec![1.0, 1.0], vec![0.0, f64::INFINITY]] {
            let bad = Field::sample(unit, unit, levels, |x, _| x);
            assert!(matches!(bad, Err(DrawingError::BadLevels { .. })));
        }
    }
}
