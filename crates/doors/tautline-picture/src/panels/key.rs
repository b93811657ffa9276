//! The key of a figure: one sample and one name for each kind of curve.

use std::cell::RefCell;

use super::{panel::Panel, plot::Plot};
use crate::{
    axes::{Scale, Stretch},
    error::DrawingError,
    geometry::Extent,
    marks::Curve,
    math_text::{Align, TextBlock, typeset},
    measures::{EDGE, TEXT},
    picture::Scene,
};

/// The names of curves, placed above several panels in which labels at their ends would repeat.
pub(crate) struct Key {
    rows: Vec<Vec<(Curve, TextBlock)>>,
}

const SAMPLE: f64 = 30.0;
const AFTER_SAMPLE: f64 = 7.0;
const BETWEEN: f64 = 24.0;
const PITCH: f64 = 24.0;

impl Key {
    /// Collects the named curves, each name once, into rows of at most `width` px.
    pub(crate) fn of_panels<'p>(
        panels: impl Iterator<Item = &'p Panel>,
        width: f64,
    ) -> Result<Key, DrawingError> {
        let mut known: Vec<&str> = Vec::new();
        let mut rows: Vec<Vec<(Curve, TextBlock)>> = vec![Vec::new()];
        let mut used = 0.0;
        for curve in panels.flat_map(|panel| &panel.curves) {
            if curve.label.is_empty() || known.contains(&curve.label.as_str()) {
                continue;
            }
            known.push(&curve.label);
            let text = typeset(&curve.label.replace('\n', " "), TEXT, Align::Left)?;
            let needs = SAMPLE + AFTER_SAMPLE + text.extent.width() + BETWEEN;
            if used + needs - BETWEEN > width && used > 0.0 {
                rows.push(Vec::new());
                used = 0.0;
            }
            used += needs;
            rows.last_mut().expect("starts with one row").push((curve.clone(), text));
        }
        Ok(Key { rows })
    }

    /// Returns the height, in px, including the space below.
    pub(crate) fn height(&self) -> f64 {
        self.rows.len() as f64 * PITCH + 10.0
    }

    /// Draws the rows, centred between the edges of the figure, from `top` downwards.
    pub(crate) fn draw(&self, scene: &RefCell<Scene>, top: f64) -> Result<(), DrawingError> {
        let width = scene.borrow().width;
        for (k, row) in self.rows.iter().enumerate() {
            let names: f64 = row.iter().map(|(_, text)| text.extent.width()).sum();
            let samples = row.len() as f64 * (SAMPLE + AFTER_SAMPLE + BETWEEN) - BETWEEN;
            let mut x = ((width - names - samples) / 2.0).max(EDGE);
            let y = top + (k as f64 + 0.5) * PITCH;
            for (curve, text) in row {
                draw_sample(scene, curve, x, y)?;
                x += SAMPLE + AFTER_SAMPLE;
                // Half the height of a small letter, where the eye expects the line.
                scene.borrow_mut().write(text, (x, y + 0.24 * TEXT), curve.colour.for_text());
                x += text.extent.width() + BETWEEN;
            }
        }
        Ok(())
    }
}

/// Draws a piece of line with one marker in its middle, using the same code as the curves.
fn draw_sample(scene: &RefCell<Scene>, curve: &Curve, x: f64, y: f64) -> Result<(), DrawingError> {
    let unit = Stretch::new(Scale::Linear, 0.0, 1.0)?;
    let clip = Extent { left: x, top: y - 9.0, right: x + SAMPLE, bottom: y + 9.0 };
    let (across, up) = ((x, x + SAMPLE), (clip.bottom, clip.top));
    let plot = Plot { scene, x: unit, y: unit, across, up, clip };
    plot.lines(curve, &[vec![(0.0, 0.5), (1.0, 0.5)]])?;
    plot.markers(curve, &[vec![(0.5, 0.5)]])
}

#[cfg(test)]
mod tests {
    use super::{Curve, Key, Panel, Scale};
    use crate::{
        axes::Axis,
        colours::palette::{BLUE, GREEN},
    };

    #[test]
    fn names_appear_once_and_rows_wrap() {
        let axis = || Axis::new(Scale::Linear, 0.0, 1.0).expect("a range");
        let curve = |colour, name: &str| Curve::new([(0.0, 0.0)], colour).labelled(name);
        let panel =
            || Panel::new(axis(), axis()).curve(curve(BLUE, "first")).curve(curve(GREEN, "second"));
        let panels = [panel(), panel()];
        let names = |width: f64| -> Vec<usize> {
            let key = Key::of_panels(panels.iter(), width).expect("ASCII");
            key.rows.iter().map(Vec::len).collect()
        };
        assert_eq!(names(500.0), [2]);
        assert_eq!(names(120.0), [1, 1]);
    }
}
