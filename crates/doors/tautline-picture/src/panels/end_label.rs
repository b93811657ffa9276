//! The names of curves, next to their right ends.

use super::{panel::Panel, plot::Plot, push_apart::push_apart};
use crate::{
    colours::Colour,
    error::DrawingError,
    geometry::Path,
    math_text::{Align, TextBlock, typeset},
    measures::{END_GAP, LEADER_GAP, MARKER, TEXT},
    picture::{Scene, Shape, Stroke},
};

/// A label, the end of its curve, and the height to which the label was pushed.
pub(crate) struct EndLabel {
    text: TextBlock,
    colour: Colour,
    end: (f64, f64),
    centre: f64,
}

/// The smallest white space between two labels, in px.
const APART: f64 = 5.0;

impl EndLabel {
    /// Sets the labels of all named curves, and pushes them apart between `top` and `bottom`.
    pub(crate) fn of_panel(
        panel: &Panel,
        plots: &[Plot<'_>],
        (top, bottom): (f64, f64),
    ) -> Result<Vec<EndLabel>, DrawingError> {
        let mut labels = Vec::new();
        for curve in panel.curves.iter().filter(|curve| !curve.label.is_empty()) {
            let runs = curve.runs(&panel.x, &panel.y);
            let Some(&last) = runs.last().and_then(|run| run.last()) else { continue };
            // A curve that ends outside every stretch has its name at the nearest edge.
            let plot = plots
                .iter()
                .find(|plot| plot.y.holds(last.1))
                .or_else(|| plots.iter().find(|plot| last.1 < plot.y.from))
                .or(plots.last());
            let Some(plot) = plot else { continue };
            let (x, y) = plot.place(last);
            let end = (x.min(plot.clip.right), y.clamp(plot.up.1, plot.up.0));
            let text = typeset(&curve.label, TEXT, Align::Left)?;
            labels.push(EndLabel { text, colour: curve.colour, end, centre: end.1 });
        }
        let wanted: Vec<(f64, f64)> =
            labels.iter().map(|label| (label.end.1, label.text.extent.height())).collect();
        for (label, centre) in labels.iter_mut().zip(push_apart(&wanted, APART, top, bottom)) {
            label.centre = centre;
        }
        Ok(labels)
    }

    /// Returns the width that the labels need to the right of the frame, and the gap before them.
    pub(crate) fn width_and_gap(labels: &[EndLabel]) -> (f64, f64) {
        let widest = labels.iter().map(|label| label.text.extent.right).fold(0.0, f64::max);
        let gap = if labels.iter().any(EndLabel::is_far) { LEADER_GAP } else { END_GAP };
        if labels.is_empty() { (0.0, 0.0) } else { (widest + gap, gap) }
    }

    /// Writes the label with its left end at `x`, with a leader if it is far from its curve.
    pub(crate) fn draw(&self, scene: &mut Scene, x: f64) {
        let start = self.end.0 + MARKER + 2.5;
        // If one label of a panel needs a leader, all labels are so far to the right that they get
        // one.
        if x - start > LEADER_GAP - MARKER {
            let leader = Path::polyline([(start, self.end.1), (x - 3.5, self.centre)], false);
            let mut stroke = Stroke::solid(self.colour, 0.7);
            stroke.paint.opacity = 0.7;
            scene.push(Shape::stroked(leader, stroke));
        }
        let middle = (self.text.extent.top + self.text.extent.bottom) / 2.0;
        scene.write(&self.text, (x, self.centre - middle), self.colour.for_text());
    }

    /// Beyond half an em, the eye no longer connects the label to its curve.
    fn is_far(&self) -> bool {
        (self.centre - self.end.1).abs() > 0.5 * TEXT
    }
}
