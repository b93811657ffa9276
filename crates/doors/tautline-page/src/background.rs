//! `Background`: how much a metric magnifies areas, as filled contour bands.

use std::{cell::Cell, fmt::Write};

use serde::Serialize;
use tautline::{Formula, check_gram};
use tautline_picture::{DrawingError, Field};

use crate::{Complaint, question::read};

/// The contour bands of `√det H`, by which a metric magnifies areas.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Background {
    /// The least value in the view; `None` if the metric is defined nowhere in it.
    pub least: Option<f64>,
    /// The greatest value in the view.
    pub greatest: Option<f64>,
    /// The bands, from the lowest. Each is painted over the ones before it. Their levels are equally
    /// spaced, in the logarithm if the greatest value is more than 8 times the least.
    pub bands: Vec<Band>,
    /// Where `H` is not positive definite, as an SVG path like those of the bands.
    pub undefined: String,
}

/// A region where the value is at least some level.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Band {
    /// The colour, as `#rrggbb`.
    pub colour: String,
    /// The region, as an SVG path. The view is the square from `(0, 0)`, at the top left, to
    /// `(1000, 1000)`. The lowest band is the whole view and has no path.
    pub path: String,
}

/// A rectangle of the plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct View {
    /// The left and the right end.
    pub x: (f64, f64),
    /// The bottom and the top.
    pub y: (f64, f64),
}

/// The number of bands.
const BANDS: usize = 12;

/// If the greatest value is this many times the least, the levels are spaced in the logarithm.
const WIDE: f64 = 8.0;

/// Values that differ by less count as equal: it is the size of the rounding of a long formula.
const FLAT: f64 = 1e-9;

/// The number of intervals along a side at which the range of values is estimated.
const PROBES: usize = 96;

impl Background {
    /// Reads a metric, and computes its bands.
    ///
    /// # Errors
    ///
    /// [`Complaint`] if the formula is broken, with its place, or if the view is empty.
    pub fn new(formula: &str, view: View) -> Result<Self, Complaint> {
        let metric = read(formula)?;
        Self::of(&metric, view).map_err(|error| Complaint::about(&error))
    }

    fn of(metric: &Formula<2>, view: View) -> Result<Self, DrawingError> {
        let Some((least, greatest)) = range(metric, view) else {
            let (bands, undefined) = (Vec::new(), "M0 0H1000V1000H0Z".to_owned());
            return Ok(Self { least: None, greatest: None, bands, undefined });
        };
        let scale = |value: f64| if greatest > WIDE * least { value.ln() } else { value };
        let (low, high) = (scale(least), scale(greatest));
        // A constant metric has a single band.
        let is_flat = !(high - low > FLAT * greatest.abs().max(1.0));
        let step = if is_flat { 1.0 } else { (high - low) / BANDS as f64 };
        let levels: Vec<f64> = (0..=BANDS).map(|k| low + step * k as f64).collect();
        let is_total = Cell::new(true);
        let value = |x, y| {
            let value = magnification(metric, x, y);
            is_total.set(is_total.get() && value.is_some());
            // Between two probes the value may be far beyond their range.
            value.map_or(low, |value| scale(value).clamp(low - step, high + step))
        };
        let field = Field::sample(view.x, view.y, levels, value)?;
        let mut bands = vec![Band { colour: field.colour(0).hex(), path: String::new() }];
        let upper = if is_flat { &[] } else { &field.levels()[1..BANDS] };
        for (k, &level) in upper.iter().enumerate() {
            let colour = field.colour(k + 1).hex();
            bands.push(Band { colour, path: path(&field, level, view)? });
        }
        let undefined = if is_total.get() { String::new() } else { undefined(metric, view)? };
        Ok(Self { least: Some(least), greatest: Some(greatest), bands, undefined })
    }
}

/// Returns the least and the greatest magnification at some points of the view.
fn range(metric: &Formula<2>, View { x, y }: View) -> Option<(f64, f64)> {
    let at = |(from, to): (f64, f64), k: usize| from + (to - from) * k as f64 / PROBES as f64;
    let places = (0..=PROBES).flat_map(|j| (0..=PROBES).map(move |i| (at(x, i), at(y, j))));
    let values = places.filter_map(|(a, b)| magnification(metric, a, b));
    values.map(|value| (value, value)).reduce(|a, b| (a.0.min(b.0), a.1.max(b.1)))
}

/// Returns `√det H`, or `None` where `H` is not positive definite.
fn magnification(metric: &Formula<2>, x: f64, y: f64) -> Option<f64> {
    let determinant = check_gram(metric, &[x, y].into()).ok()?.determinant();
    (determinant > 0.0 && determinant < f64::INFINITY).then(|| determinant.sqrt())
}

/// Returns the region where `H` is not positive definite, as an SVG path.
fn undefined(metric: &Formula<2>, view: View) -> Result<String, DrawingError> {
    let outside = |x, y| if magnification(metric, x, y).is_some() { 0.0 } else { 1.0 };
    path(&Field::sample(view.x, view.y, vec![0.0, 0.5], outside)?, 0.5, view)
}

/// Returns the region above a level as an SVG path. A tenth of a unit is less than a pixel.
fn path(field: &Field, level: f64, View { x, y }: View) -> Result<String, DrawingError> {
    let mut path = String::new();
    for ring in field.rings(level)? {
        for (k, (a, b)) in ring.into_iter().enumerate() {
            let across = 1000.0 * (a - x.0) / (x.1 - x.0);
            let down = 1000.0 * (y.1 - b) / (y.1 - y.0);
            let letter = if k == 0 { 'M' } else { 'L' };
            write!(path, "{letter}{across:.1} {down:.1}").expect("a text takes any length");
        }
        path.push('Z');
    }
    Ok(path)
}

#[cfg(test)]
mod tests {
    use super::{BANDS, Background, View};

    const VIEW: View = View { x: (-2.0, 2.0), y: (-2.0, 2.0) };

    /// Returns the coordinates of a path.
    fn points(path: &str) -> Vec<(f64, f64)> {
        let pairs = path.split(['M', 'L', 'Z']).filter(|pair| !pair.is_empty());
        let number = |text: &str| text.parse::<f64>().expect("a number");
        pairs
            .map(|pair| pair.split_once(' ').expect("a pair"))
            .map(|(a, b)| (number(a), number(b)))
            .collect()
    }

    /// √det H = 3 + |x|² runs from 3 to 11, so the levels are 8/12 apart.
    #[test]
    fn the_contours_of_a_paraboloid_are_circles() {
        let background = Background::new("(3 + x1^2 + x2^2) I", VIEW).expect("defined");
        assert_eq!((background.least, background.greatest), (Some(3.0), Some(11.0)));
        assert_eq!((background.bands.len(), background.undefined.as_str()), (BANDS, ""));
        let mut on_the_circle = 0;
        for (a, b) in points(&background.bands[3].path) {
            let (x, y) = (a / 250.0 - 2.0, 2.0 - b / 250.0);
            // The region above the level reaches beyond the view, where its boundary is no contour.
            if x.abs() < 2.0 && y.abs() < 2.0 {
                on_the_circle += 1;
                // Half a tenth of a unit in each coordinate, and the cells.
                assert!((x.hypot(y) - 2.0_f64.sqrt()).abs() < 5e-4, "({x}, {y})");
            }
        }
        assert!(on_the_circle > 200);
    }

    #[test]
    fn a_constant_metric_has_a_single_band() {
        let background = Background::new("[2, 1; 1, 3]", VIEW).expect("defined");
        let root = 5.0_f64.sqrt();
        assert!(
            background.least.is_some_and(|least| (least - root).abs() < 1e-15),
            "{background:?}"
        );
        assert_eq!(background.bands.len(), 1);
    }

    #[test]
    fn where_the_metric_is_undefined_is_marked() {
        let background = Background::new("x1 I", VIEW).expect("defined on one side");
        // The lowest probe is 4/96 from the line where the metric ends.
        assert!(background.least.is_some_and(|least| (least - 4.0 / 96.0).abs() < 1e-15));
        let edge = points(&background.undefined).into_iter().map(|(a, _)| a).fold(0.0, f64::max);
        // The line is at 500, and a cell has a side of 1000/360.
        assert!((edge - 500.0).abs() < 3.0, "{edge}");
        let nowhere = Background::new("-1 I", VIEW).expect("a picture of nothing");
        assert!(nowhere.bands.is_empty() && nowhere.least.is_none());
        let empty = View { x: (1.0, 1.0), ..VIEW };
        assert!(Background::new("1 I", empty).is_err() && Background::new("x3 I", VIEW).is_err());
    }
}
