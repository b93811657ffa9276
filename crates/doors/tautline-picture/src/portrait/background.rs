//! The metric behind the curves, as filled contours.

use super::{levels::Levels, span::number};
use crate::{DrawingError, Field, Panel, Region, Samples, Scale};

/// What is drawn behind the sets and curves, and what must be said about it.
#[derive(Default)]
pub(crate) struct Background {
    pub(crate) field: Option<Field>,
    pub(crate) regions: Vec<Region>,
    pub(crate) remarks: Vec<String>,
}

/// The number of cells along the longer side. A cell is less than 3 px wide, so that a contour that
/// bends with a radius of 20 px is off by less than 0.1 px.
const CELLS: u16 = 120;

impl Background {
    /// Puts the field and its areas on a panel.
    pub(crate) fn behind(self, panel: Panel) -> Panel {
        let panel = match self.field {
            Some(field) => panel.over(field),
            None => panel.boxed(),
        };
        self.regions.into_iter().fold(panel, Panel::region)
    }
}

/// Returns contours of a function on the rectangle `x × y`, whose formula is `name`.
pub(crate) fn contours(
    x: (f64, f64),
    y: (f64, f64),
    name: &str,
    f: impl Fn(f64, f64) -> Option<f64>,
) -> Result<Background, DrawingError> {
    let samples = Samples::on(x, y, CELLS, f)?;
    let mut remarks = Vec::new();
    if samples.has_gaps() && !samples.sorted().is_empty() {
        remarks.push("Hatched: $H$ is not defined.".to_owned());
    }
    let field = match Levels::of(samples.sorted()) {
        Levels::None => {
            remarks.push("$H$ is not defined in this window.".to_owned());
            None
        }
        Levels::Constant(value) => {
            remarks.push(format!("${name}={}$ everywhere.", number(value)));
            let gaps = samples.has_gaps().then(|| nearly_white(samples, value));
            gaps.transpose()?
        }
        Levels::Bands { scale, levels, open } => {
            let (samples, levels, label) = short_numbers(samples, scale, levels, name);
            let field = Field::of_samples(samples, scale, levels)?;
            let field = field.labelled(label).lined_every(1).numbered_at_levels();
            Some(field.open_ended(open[0], open[1]))
        }
    };
    Ok(Background { field, regions: Vec::new(), remarks })
}

/// Returns a field without colour that shows the gaps only.
fn nearly_white(samples: Samples, value: f64) -> Result<Field, DrawingError> {
    let step = if value == 0.0 { 1.0 } else { value.abs() };
    let levels = (0..10).map(|k| value - step / 2.0 + f64::from(k) * step).collect();
    Ok(Field::of_samples(samples, Scale::Linear, levels)?.without_bar())
}

/// Divides the values on a linear scale by a power of ten if their numbers would be long.
fn short_numbers(
    samples: Samples,
    scale: Scale,
    levels: Vec<f64>,
    name: &str,
) -> (Samples, Vec<f64>, String) {
    let most = levels.iter().fold(0.0_f64, |most, level| most.max(level.abs()));
    if scale.is_logarithmic() || (1e-2..1e5).contains(&most) {
        return (samples, levels, format!("${name}$"));
    }
    let exponent = most.log10().floor().clamp(-300.0, 300.0) as i32;
    let unit = 10.0_f64.powi(exponent);
    let levels = levels.into_iter().map(|level| level / unit).collect();
    (samples.divided_by(unit), levels, format!("${name}/10^{{{exponent}}}$"))
}
