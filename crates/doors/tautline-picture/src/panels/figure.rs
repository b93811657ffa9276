//! A figure: panels in rows, arranged around their measured labels.

use std::cell::RefCell;

use super::{
    colour_bar,
    end_label::EndLabel,
    foot::Foot,
    frame::{self, Margins},
    key::Key,
    panel::{Height, Panel},
    remark,
};
use crate::{
    error::DrawingError,
    geometry::Extent,
    marks::Field,
    measures::{EDGE, GUTTER, LEADER_GAP},
    picture::Scene,
};

/// A figure of given width. Its height follows from the panels.
#[derive(Clone, Debug)]
#[must_use]
pub struct Figure {
    width: f64,
    title: String,
    rows: Vec<Vec<Panel>>,
    keyed: bool,
    remarks: Vec<String>,
}

/// The columns of a figure: what each panel needs, what each column needs to the left and right of
/// its frames, and the width of every frame, in px.
struct Columns {
    needs: Vec<Vec<Margins>>,
    left: Vec<f64>,
    right: Vec<f64>,
    frame_width: f64,
}

/// A frame narrower than this, in px, has no readable axis.
const NARROWEST: f64 = 90.0;

impl Figure {
    /// Returns a figure that is `width` px wide and has rows with the same number of panels each.
    ///
    /// The title describes the picture to readers who cannot see it; it is not drawn.
    pub fn new(width: f64, title: impl Into<String>, rows: Vec<Vec<Panel>>) -> Figure {
        Figure { width, title: title.into(), rows, keyed: false, remarks: Vec::new() }
    }

    /// Names the curves in a key above the panels instead of at their ends.
    pub fn keyed(mut self) -> Figure {
        self.keyed = true;
        self
    }

    /// Adds a remark below the panels, broken into lines at its spaces. The syntax is that of
    /// [`typeset`](crate::math_text::typeset).
    pub fn remark(mut self, remark: impl Into<String>) -> Figure {
        self.remarks.push(remark.into());
        self
    }

    /// Draws the figure.
    ///
    /// # Errors
    ///
    /// If a label cannot be set, if the labels leave no room for the panels, or if in the finished
    /// drawing two labels overlap or a label is cut off.
    pub fn draw(&self) -> Result<Scene, DrawingError> {
        let columns = self.rows.first().map_or(0, Vec::len);
        if columns == 0 || self.rows.iter().any(|row| row.len() != columns) {
            return Err(DrawingError::NoPanels);
        }
        // The labels of a frame depend on its height, which may depend on its width, and that is
        // what the labels leave. The first width is a guess.
        let guess = self.columns(0.7 * self.width / columns as f64)?;
        let Columns { needs, left, right, frame_width } = self.columns(guess.frame_width)?;
        let key = if self.keyed {
            Some(Key::of_panels(self.rows.iter().flatten(), self.width - 2.0 * EDGE)?)
        } else {
            None
        };
        let mut top = EDGE + key.as_ref().map_or(0.0, Key::height);
        let mut placed = Vec::new();
        for (row, needs) in self.rows.iter().zip(&needs) {
            top += needs.iter().map(|m| m.top).fold(0.0, f64::max);
            let mut x = EDGE;
            let mut below: f64 = 0.0;
            for (column, (panel, margins)) in row.iter().zip(needs).enumerate() {
                let height = panel.frame_height(frame_width);
                x += left[column];
                let frame = Extent { left: x, top, right: x + frame_width, bottom: top + height };
                placed.push((panel, frame, x - left[column], margins.end_gap));
                x += frame_width + right[column] + GUTTER;
                below = below.max(height + margins.bottom);
            }
            top += below + GUTTER;
        }
        let bottom = top - GUTTER + EDGE;
        let foot = Foot::of_remarks(&self.remarks, self.width - 2.0 * EDGE)?;
        let height = (bottom + foot.height()).ceil();
        let scene = RefCell::new(Scene::new(self.width, height, &self.title));
        foot.draw(&mut scene.borrow_mut(), (EDGE, bottom));
        if let Some(key) = key {
            key.draw(&scene, EDGE)?;
        }
        for (panel, frame, label_left, end_gap) in placed {
            self.draw_panel(&scene, panel, frame, label_left, end_gap)?;
        }
        let scene = scene.into_inner();
        scene.check_labels()?;
        Ok(scene)
    }

    /// Measures the labels around frames of about this width, and the width that they leave.
    fn columns(&self, frame_width: f64) -> Result<Columns, DrawingError> {
        let columns = self.rows[0].len();
        let mut needs = Vec::with_capacity(self.rows.len());
        for row in &self.rows {
            let measured: Result<Vec<Margins>, _> =
                row.iter().map(|panel| self.measure(panel, frame_width)).collect();
            needs.push(measured?);
        }
        // The frames in a column have the same left and right sides, so that rows align.
        let most = |side: fn(&Margins) -> f64, column: usize| {
            needs.iter().map(|row| side(&row[column])).fold(0.0, f64::max)
        };
        let left: Vec<f64> = (0..columns).map(|c| most(|m| m.left, c)).collect();
        let right: Vec<f64> = (0..columns).map(|c| most(|m| m.right, c)).collect();
        let labels: f64 = left.iter().chain(&right).sum();
        let gutters = GUTTER * (columns - 1) as f64;
        let frame_width = (self.width - 2.0 * EDGE - labels - gutters) / columns as f64;
        if !(frame_width >= NARROWEST) {
            return Err(DrawingError::TooNarrow { left: frame_width });
        }
        Ok(Columns { needs, left, right, frame_width })
    }

    fn measure(&self, panel: &Panel, frame_width: f64) -> Result<Margins, DrawingError> {
        let height = panel.frame_height(frame_width);
        let trial = RefCell::new(Scene::new(self.width, height, ""));
        let frame = Extent { left: 0.0, top: 0.0, right: self.width / 3.0, bottom: height };
        let plots = frame::plots(panel, &trial, frame);
        let ends = self.end_labels(panel, &plots, frame)?;
        let bar = panel.barred().map(|field| colour_bar::space(field, height));
        frame::margins(panel, &plots, &ends, bar.transpose()?.unwrap_or((0.0, 0.0)))
    }

    fn end_labels(
        &self,
        panel: &Panel,
        plots: &[super::plot::Plot<'_>],
        frame: Extent,
    ) -> Result<Vec<EndLabel>, DrawingError> {
        if self.keyed {
            return Ok(Vec::new());
        }
        EndLabel::of_panel(panel, plots, (frame.top, frame.bottom))
    }

    fn draw_panel(
        &self,
        scene: &RefCell<Scene>,
        panel: &Panel,
        frame: Extent,
        label_left: f64,
        end_gap: f64,
    ) -> Result<(), DrawingError> {
        let plots = frame::plots(panel, scene, frame);
        frame::draw_grid(scene, panel, &plots, frame)?;
        for plot in &plots {
            if let Some(field) = &panel.field {
                plot.field(field)?;
            }
            panel.regions.iter().for_each(|region| plot.region(region));
            // All markers are drawn over all lines, so that no line crosses a point.
            let runs: Vec<_> =
                panel.curves.iter().map(|curve| curve.runs(&panel.x, &panel.y)).collect();
            for (curve, runs) in panel.curves.iter().zip(&runs) {
                plot.lines(curve, runs)?;
            }
            for (curve, runs) in panel.curves.iter().zip(&runs) {
                plot.markers(curve, runs)?;
            }
        }
        for triangle in &panel.triangles {
            remark::draw_triangle(scene, &plots, triangle)?;
        }
        frame::draw_axes(&mut scene.borrow_mut(), panel, &plots, frame, label_left)?;
        for note in &panel.notes {
            remark::draw_note(scene, &plots, note)?;
        }
        for label in self.end_labels(panel, &plots, frame)? {
            label.draw(&mut scene.borrow_mut(), frame.right + end_gap.min(LEADER_GAP));
        }
        match panel.barred() {
            Some(field) => colour_bar::draw(&mut scene.borrow_mut(), field, frame),
            None => Ok(()),
        }
    }
}

impl Panel {
    /// Returns the field, if it has a colour bar.
    fn barred(&self) -> Option<&Field> {
        self.field.as_ref().filter(|field| field.has_bar)
    }

    /// Returns the height of a frame of this width, in px.
    fn frame_height(&self, width: f64) -> f64 {
        match self.height {
            Height::Px(height) => height,
            Height::EqualUnits => {
                width * (self.y.to() - self.y.from()) / (self.x.to() - self.x.from())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{DrawingError, Figure, Panel};
    use crate::{
        axes::{Axis, Scale},
        colours::palette::{BLUE, GREY},
        marks::{Curve, Note, SlopeTriangle},
        math_text::Align,
    };

    fn panel() -> Panel {
        let x = Axis::new(Scale::Octaves, 1.0, 64.0).expect("a range").labelled("$N$");
        let y = Axis::new(Scale::Decades, 1e-3, 1.0).expect("a range").labelled("error");
        Panel::new(x, y)
    }

    fn curve(last: f64, label: &str) -> Curve {
        Curve::new([(1.0, 1.0), (64.0, last)], BLUE).labelled(label)
    }

    #[test]
    fn labels_at_one_place_are_pushed_apart() {
        let crowded =
            (0..5).fold(panel(), |panel, k| panel.curve(curve(0.1, &format!("curve {k}"))));
        let scene = Figure::new(400.0, "test", vec![vec![crowded]]).draw().expect("no overlap");
        let names = scene.shapes().iter().filter_map(|shape| shape.label.as_ref());
        assert_eq!(names.filter(|(name, _)| name.starts_with("curve")).count(), 5);
    }

    #[test]
    fn margins_follow_the_labels() {
        let left_of_axis = |label: &str| {
            let panel = panel().curve(curve(0.1, label));
            let scene = Figure::new(500.0, "test", vec![vec![panel]]).draw().expect("fits");
            let labels = scene.shapes().iter().filter_map(|shape| shape.label.clone());
            labels.map(|(_, place)| place.right).fold(0.0, f64::max)
        };
        for label in ["a", "a rather long name of a curve"] {
            let right = left_of_axis(label);
            assert!((right - 492.0).abs() <= 0.1, "{label} ends at {right}");
        }
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let figure = Figure::new(150.0, "test", vec![vec![panel().curve(curve(0.1, "long name"))]]);
        assert!(matches!(figure.draw(), Err(DrawingError::TooNarrow { .. })));
        assert_eq!(Figure::new(400.0, "test", vec![]).draw(), Err(DrawingError::NoPanels));
    }

    fn square() -> Panel {
        let axis = || Axis::new(Scale::Decades, 1e-2, 1e2).expect("a range");
        Panel::new(axis(), axis())
    }

    #[test]
    fn remarks_outside_the_panel_are_refused() {
        let outside = [
            square().note(Note::new((1.0, 1e3), "too high", GREY, Align::Left)),
            square().note(Note::new((-1.0, 1.0), "no place", GREY, Align::Left)),
            square().triangle(SlopeTriangle::below(-2.0, 1.0, 10.0, 1e3)),
            square().triangle(SlopeTriangle::below(-2.0, 0.1, 100.0, 1.0)),
        ];
        for panel in outside {
            let drawn = Figure::new(400.0, "test", vec![vec![panel]]).draw();
            assert!(matches!(drawn, Err(DrawingError::Outside { .. })), "{drawn:?}");
        }
    }

    #[test]
    fn the_numbers_stand_on_the_sides_of_their_legs() {
        let panel = square().triangle(SlopeTriangle::below(-2.0, 1.0, 10.0, 1.0));
        let scene = Figure::new(400.0, "test", vec![vec![panel]]).draw().expect("inside");
        let triangle = scene.shapes().iter().find(|s| s.fill.is_some_and(|f| f.opacity < 0.5));
        let triangle = triangle.expect("drawn").path.extent().expect("three corners");
        let place = |name: &str| {
            let labels = scene.shapes().iter().filter_map(|shape| shape.label.as_ref());
            labels.filter(|(text, _)| text == name).map(|(_, place)| *place).next_back()
        };
        let (run, rise) = (place("1").expect("a number"), place("2").expect("a number"));
        assert!(run.top > triangle.bottom && rise.right < triangle.left, "{run:?} {rise:?}");
    }

    #[test]
    fn labels_are_measured_at_the_height_of_the_frame() {
        // The taller the frame, the more digits its numbers have.
        for top in [0.8, 1.9, 3.3, 7.0] {
            let axis = |to| Axis::new(Scale::Linear, -0.3, to).expect("a range");
            let panel = Panel::new(axis(3.0).labelled("$x$"), axis(top).labelled("$y$"));
            let figure = Figure::new(440.0, "test", vec![vec![panel.equal_units().boxed()]]);
            let scene = figure.draw().expect("space");
            let labels: Vec<_> = scene.shapes().iter().filter_map(|s| s.label.clone()).collect();
            let of = |name: &str| labels.iter().find(|label| label.0 == name).map(|label| label.1);
            let y = of("y").expect("a label");
            let numbers = labels.iter().filter(|(name, _)| name.parse::<f64>().is_ok());
            let left = numbers.map(|(_, place)| place.left).fold(f64::INFINITY, f64::min);
            assert!(left >= y.right + 10.0, "{top}: numbers from {left}, {y:?}");
        }
    }

    #[test]
    fn remarks_make_the_figure_taller() {
        let figure = || Figure::new(400.0, "test", vec![vec![panel()]]);
        let plain = figure().draw().expect("space");
        let scene = figure().remark("What the reader must know.").draw().expect("space");
        assert!(scene.height > plain.height + 10.0);
        let last = scene.shapes().iter().filter_map(|s| s.label.as_ref());
        let lowest = last.map(|(_, place)| place.top).fold(0.0, f64::max);
        assert!(lowest > plain.height - 8.0, "{lowest}");
    }
}
