//! The bridge from plotters: a backend that records shapes into a [`Scene`].

use std::cell::RefCell;

use plotters_backend::text_anchor::{HPos, VPos};
use plotters_backend::{
    BackendColor, BackendCoord, BackendStyle, BackendTextStyle, DrawingBackend, DrawingErrorKind,
};

use super::scene::{Paint, Scene, Shape, Stroke};
use crate::{
    colours::Colour,
    error::DrawingError,
    geometry::{Extent, Path},
    math_text::{Align, typeset},
};

/// The number of canvas units of plotters in one px.
///
/// plotters counts in whole units, and rounding to a hundredth of a px is invisible.
pub(crate) const UNITS: f64 = 100.0;

/// Converts px to the canvas units of plotters.
pub(crate) fn units(px: f64) -> i32 {
    (px * UNITS).round() as i32
}

/// Records what plotters draws, with the same clip and the same dash pattern for everything.
///
/// Styles of plotters have only a colour and a width, so each clipped or dashed layer has its own
/// recorder. All recorders of a figure share its scene.
pub(crate) struct Recorder<'a> {
    scene: &'a RefCell<Scene>,
    clip: Option<Extent>,
    dash: Vec<f64>,
}

type Outcome = Result<(), DrawingErrorKind<DrawingError>>;

impl<'a> Recorder<'a> {
    /// Returns a recorder that draws into `scene` and shows only what lies inside `clip`.
    pub(crate) fn new(
        scene: &'a RefCell<Scene>,
        clip: Option<Extent>,
        dash: &[f64],
    ) -> Recorder<'a> {
        Recorder { scene, clip, dash: dash.to_vec() }
    }

    fn record(&self, path: Path, style: &impl BackendStyle, fill: bool) -> Outcome {
        let BackendColor { alpha, rgb: (red, green, blue) } = style.color();
        if alpha <= 0.0 {
            return Ok(());
        }
        let paint = Paint { colour: Colour::new(red, green, blue), opacity: alpha };
        let width = f64::from(style.stroke_width()) / UNITS;
        let stroke = Stroke { paint, width, dash: self.dash.clone() };
        let mut shape =
            if fill { Shape::filled(path, paint) } else { Shape::stroked(path, stroke) };
        shape.clip = self.clip;
        self.scene.borrow_mut().push(shape);
        Ok(())
    }
}

fn px((x, y): BackendCoord) -> (f64, f64) {
    (f64::from(x) / UNITS, f64::from(y) / UNITS)
}

impl DrawingBackend for Recorder<'_> {
    type ErrorType = DrawingError;

    fn get_size(&self) -> (u32, u32) {
        let scene = self.scene.borrow();
        // Canvases are a few thousand px wide, so the cast cannot overflow.
        ((scene.width * UNITS).ceil() as u32, (scene.height * UNITS).ceil() as u32)
    }

    fn ensure_prepared(&mut self) -> Outcome {
        Ok(())
    }

    fn present(&mut self) -> Outcome {
        Ok(())
    }

    fn draw_pixel(&mut self, point: BackendCoord, color: BackendColor) -> Outcome {
        let (left, top) = px(point);
        let pixel = Extent { left, top, right: left + 1.0, bottom: top + 1.0 };
        self.record(Path::rectangle(pixel), &color, true)
    }

    fn draw_line<S: BackendStyle>(
        &mut self,
        from: BackendCoord,
        to: BackendCoord,
        style: &S,
    ) -> Outcome {
        self.record(Path::polyline([px(from), px(to)], false), style, false)
    }

    fn draw_rect<S: BackendStyle>(
        &mut self,
        upper_left: BackendCoord,
        bottom_right: BackendCoord,
        style: &S,
        fill: bool,
    ) -> Outcome {
        let ((left, top), (right, bottom)) = (px(upper_left), px(bottom_right));
        self.record(Path::rectangle(Extent { left, top, right, bottom }), style, fill)
    }

    fn draw_path<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        path: I,
        style: &S,
    ) -> Outcome {
        self.record(Path::polyline(path.into_iter().map(px), false), style, false)
    }

    fn draw_circle<S: BackendStyle>(
        &mut self,
        center: BackendCoord,
        radius: u32,
        style: &S,
        fill: bool,
    ) -> Outcome {
        self.record(Path::circle(px(center), f64::from(radius) / UNITS), style, fill)
    }

    fn fill_polygon<S: BackendStyle, I: IntoIterator<Item = BackendCoord>>(
        &mut self,
        vert: I,
        style: &S,
    ) -> Outcome {
        self.record(Path::polyline(vert.into_iter().map(px), true), style, true)
    }

    fn draw_text<S: BackendTextStyle>(
        &mut self,
        text: &str,
        style: &S,
        pos: BackendCoord,
    ) -> Outcome {
        let BackendColor { rgb: (red, green, blue), .. } = style.color();
        let anchor = style.anchor();
        let align = match anchor.h_pos {
            HPos::Left => Align::Left,
            HPos::Center => Align::Centre,
            HPos::Right => Align::Right,
        };
        let block =
            typeset(text, style.size() / UNITS, align).map_err(DrawingErrorKind::DrawingError)?;
        let (x, y) = px(pos);
        let y = match anchor.v_pos {
            VPos::Top => y - block.extent.top,
            VPos::Center => y - (block.extent.top + block.extent.bottom) / 2.0,
            VPos::Bottom => y - block.extent.bottom,
        };
        self.scene.borrow_mut().write(&block, (x, y), Colour::new(red, green, blue));
        Ok(())
    }

    fn estimate_text_size<S: BackendTextStyle>(
        &self,
        text: &str,
        style: &S,
    ) -> Result<(u32, u32), DrawingErrorKind<DrawingError>> {
        let extent = typeset(text, style.size() / UNITS, Align::Left)
            .map_err(DrawingErrorKind::DrawingError)?
            .extent;
        Ok(((extent.width() * UNITS) as u32, (extent.height() * UNITS) as u32))
    }
}

#[cfg(test)]
mod tests {
    use super::{Recorder, RefCell, Scene};
    use crate::geometry::{Extent, Segment};
    use plotters::prelude::*;

    #[test]
    fn plotters_draws_in_hundredths_of_a_px() {
        let scene = RefCell::new(Scene::new(10.0, 10.0, "test"));
        let clip = Extent { left: 1.0, top: 1.0, right: 9.0, bottom: 9.0 };
        let area = Recorder::new(&scene, Some(clip), &[2.0, 1.0]).into_drawing_area();
        let style = RGBColor(1, 2, 3).stroke_width(150);
        area.draw(&PathElement::new(vec![(0, 0), (123, 456)], style)).expect("records");
        drop(area);
        let scene = scene.into_inner();
        let shape = &scene.shapes()[1];
        assert_eq!(shape.path.segments(), [Segment::Move(0.0, 0.0), Segment::Line(1.23, 4.56)]);
        let stroke = shape.stroke.as_ref().expect("a line");
        assert_eq!((stroke.width, &stroke.dash[..]), (1.5, &[2.0, 1.0][..]));
        assert_eq!(shape.clip, Some(clip));
    }

    #[test]
    fn text_of_plotters_becomes_a_label() {
        let scene = RefCell::new(Scene::new(100.0, 50.0, "test"));
        let area = Recorder::new(&scene, None, &[]).into_drawing_area();
        let style = ("serif", 1200).into_text_style(&area);
        area.draw(&Text::new("$x^2$", (1000, 1000), style)).expect("records");
        drop(area);
        let label = scene.borrow().shapes()[1].label.clone().expect("a label");
        assert_eq!(label.0, "x^2");
        assert!((label.1.left - 10.0).abs() < 0.01 && (label.1.top - 10.0).abs() < 0.01);
    }
}
