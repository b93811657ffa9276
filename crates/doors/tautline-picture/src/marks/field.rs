//! A function of two variables, shown as filled contour bands.

use super::{gaps::Gaps, grid::Grid, samples::Samples};
use crate::{
    axes::Scale,
    colours::{Colour, Ramp},
    error::DrawingError,
};

/// A sampled function, with the levels that separate its bands.
#[derive(Clone, Debug)]
#[must_use]
pub struct Field {
    grid: Grid,
    /// The samples; their logarithms if the scale of the values is logarithmic.
    values: Vec<f64>,
    levels: Vec<f64>,
    /// The scale of the colour bar.
    pub(crate) scale: Scale,
    /// Whether the lowest and the highest band hold all values beyond the levels, too.
    pub(crate) open: [bool; 2],
    /// Whether the numbers of the colour bar are levels.
    pub(crate) numbers_are_levels: bool,
    /// Whether there is a colour bar.
    pub(crate) has_bar: bool,
    /// Where there are no values.
    pub(crate) gaps: Option<Gaps>,
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
        check(&levels, Scale::Linear)?;
        let grid = Grid::over(x, y, CELLS)?;
        let mut values = Vec::with_capacity(grid.columns * grid.rows);
        for (a, b) in grid.points() {
            let value = f(a, b);
            if !value.is_finite() {
                return Err(DrawingError::NotFinite { x: a, y: b, value });
            }
            values.push(value);
        }
        Ok(Field::new(grid, values, levels))
    }

    /// Returns the field of these samples. It is hatched where there are none. On a logarithmic
    /// `scale`, the levels must be positive; values that are not belong to the lowest band.
    ///
    /// # Errors
    ///
    /// If the levels are not increasing, or not positive on a logarithmic scale.
    pub fn of_samples(
        samples: Samples,
        scale: Scale,
        levels: Vec<f64>,
    ) -> Result<Field, DrawingError> {
        check(&levels, scale)?;
        let Samples { grid, values, gaps, .. } = samples;
        let on_scale = |value: f64| {
            if scale.is_logarithmic() { value.max(f64::MIN_POSITIVE).log10() } else { value }
        };
        let values = values.into_iter().map(|value| on_scale(value.unwrap_or(levels[0])));
        Ok(Field { scale, gaps, ..Field::new(grid, values.collect(), levels) })
    }

    fn new(grid: Grid, values: Vec<f64>, levels: Vec<f64>) -> Field {
        Field {
            grid,
            values,
            levels,
            scale: Scale::Linear,
            open: [false; 2],
            numbers_are_levels: false,
            has_bar: true,
            gaps: None,
            decades: false,
            line_every: 0,
            label: String::new(),
        }
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

    /// Says that values below the lowest level, or above the highest one, have the colour of the
    /// nearest band. The colour bar has a tip there.
    pub fn open_ended(mut self, below: bool, above: bool) -> Field {
        self.open = [below, above];
        self
    }

    /// Allows numbers at levels only, along the colour bar.
    pub fn numbered_at_levels(mut self) -> Field {
        self.numbers_are_levels = true;
        self
    }

    /// Omits the colour bar.
    pub fn without_bar(mut self) -> Field {
        self.has_bar = false;
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
        let level = if self.scale.is_logarithmic() { level.log10() } else { level };
        let data = |(x, y): (f64, f64)| (if self.decades { 10_f64.powf(x) } else { x }, y);
        let rings = self.grid.rings(&self.values, level)?;
        let ring =
            |ring: Vec<_>| without_straight_points(&ring.into_iter().map(data).collect::<Vec<_>>());
        Ok(rings.into_iter().map(ring).collect())
    }
}

fn check(levels: &[f64], scale: Scale) -> Result<(), DrawingError> {
    let increasing = levels.windows(2).all(|pair| pair[0] < pair[1]);
    let placed = levels.iter().all(|level| level.is_finite());
    let positive = !scale.is_logarithmic() || levels.iter().all(|level| *level > 0.0);
    if increasing && placed && positive && levels.len() >= 2 {
        Ok(())
    } else {
        Err(DrawingError::BadLevels { levels: levels.to_vec() })
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
    use super::{DrawingError, Field, Samples, Scale};

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
    fn contours_on_a_logarithmic_scale_are_exact_for_powers() {
        // log10 f = x is linear, so the contour f = 10^0.3 is at 0.3 up to rounding.
        let unit = (0.0, 1.0);
        let power = |x: f64, _: f64| Some(10_f64.powf(x));
        let samples = Samples::on(unit, unit, 40, power).expect("a rectangle");
        let levels = vec![0.5, 10_f64.powf(0.3), 20.0];
        let field = Field::of_samples(samples, Scale::Decades, levels).expect("positive");
        let rings = field.rings(field.levels()[1]).expect("contours");
        let lefts = rings[0].iter().filter(|point| point.0 < 0.9);
        assert!(lefts.clone().count() >= 2);
        assert!(lefts.clone().all(|point| (point.0 - 0.3).abs() <= 1e-9), "{rings:?}");
        let samples = Samples::on(unit, unit, 40, power).expect("a rectangle");
        let zero = Field::of_samples(samples, Scale::Decades, vec![0.0, 1.0]);
        assert!(matches!(zero, Err(DrawingError::BadLevels { .. })));
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
