//! Writes a scene as PNG, with three pixels per px.

use tiny_skia::{
    Color, FillRule, LineJoin, Mask, Paint as SkiaPaint, PathBuilder, Pixmap, StrokeDash, Transform,
};

use super::scene::{Paint, Scene, Stroke};
use crate::{
    error::DrawingError,
    geometry::{Extent, Path, Segment},
};

/// The number of pixels per px. It gives 288 dots per inch if the text is 11 pt.
pub(crate) const SCALE: f32 = 3.0;

/// Returns the scene as an encoded PNG. The same scene gives the same bytes.
///
/// # Errors
///
/// If the canvas is empty, or too large for the memory.
pub fn png(scene: &Scene) -> Result<Vec<u8>, DrawingError> {
    let failed = |what: &str| DrawingError::Backend(what.to_owned());
    let pixels = |length: f64| (length * f64::from(SCALE)).round() as u32;
    let (width, height) = (pixels(scene.width), pixels(scene.height));
    let mut pixmap =
        Pixmap::new(width, height).ok_or_else(|| failed("the canvas has no possible size"))?;
    pixmap.fill(Color::WHITE);
    let scale = Transform::from_scale(SCALE, SCALE);
    // A mask is as large as the picture, so neighbouring shapes with the same clip share one.
    let mut mask: Option<(Extent, Mask)> = None;
    for shape in scene.shapes() {
        let Some(path) = outline(&shape.path) else { continue };
        match shape.clip {
            None => mask = None,
            Some(clip) if mask.as_ref().is_some_and(|(made_for, _)| *made_for == clip) => {}
            Some(clip) => {
                let mut inside =
                    Mask::new(width, height).ok_or_else(|| failed("the clip has no size"))?;
                if let Some(path) = outline(&Path::rectangle(clip)) {
                    inside.fill_path(&path, FillRule::Winding, true, scale);
                }
                mask = Some((clip, inside));
            }
        }
        let mask = mask.as_ref().map(|(_, mask)| mask);
        if let Some(fill) = shape.fill {
            pixmap.fill_path(&path, &skia_paint(fill), FillRule::Winding, scale, mask);
        }
        if let Some(stroke) = &shape.stroke {
            let line = skia_stroke(stroke);
            pixmap.stroke_path(&path, &skia_paint(stroke.paint), &line, scale, mask);
        }
    }
    pixmap.encode_png().map_err(|error| DrawingError::Backend(error.to_string()))
}

/// Returns the path for tiny-skia, or `None` if there is nothing to paint.
fn outline(path: &Path) -> Option<tiny_skia::Path> {
    let mut builder = PathBuilder::new();
    for segment in path.segments() {
        match *segment {
            Segment::Move(x, y) => builder.move_to(x as f32, y as f32),
            Segment::Line(x, y) => builder.line_to(x as f32, y as f32),
            Segment::Cubic(all) => {
                let [a, b, c, d, x, y] = all.map(|value| value as f32);
                builder.cubic_to(a, b, c, d, x, y);
            }
            Segment::Close => builder.close(),
        }
    }
    builder.finish()
}

fn skia_paint(paint: Paint) -> SkiaPaint<'static> {
    let [red, green, blue] = paint.colour.rgb;
    let alpha = (paint.opacity.clamp(0.0, 1.0) * 255.0).round() as u8;
    let mut skia = SkiaPaint { anti_alias: true, ..SkiaPaint::default() };
    skia.set_color_rgba8(red, green, blue, alpha);
    skia
}

fn skia_stroke(stroke: &Stroke) -> tiny_skia::Stroke {
    tiny_skia::Stroke {
        width: stroke.width as f32,
        line_join: LineJoin::Round,
        dash: StrokeDash::new(stroke.dash.iter().map(|length| *length as f32).collect(), 0.0),
        ..tiny_skia::Stroke::default()
    }
}

#[cfg(test)]
mod tests {
    use super::super::scene::Shape;
    use super::{Extent, Path, Scene, png};
    use crate::colours::Colour;

    #[test]
    fn shapes_land_where_they_should_and_clips_cut_them() {
        let mut scene = Scene::new(20.0, 10.0, "test");
        let all = Path::rectangle(scene.canvas());
        let mut half = Shape::filled(all, Colour::new(200, 0, 0));
        half.clip = Some(Extent { left: 0.0, top: 0.0, right: 10.0, bottom: 10.0 });
        scene.push(half);
        let bytes = png(&scene).expect("a small canvas");
        let pixmap = tiny_skia::Pixmap::decode_png(&bytes).expect("our own PNG");
        assert_eq!((pixmap.width(), pixmap.height()), (60, 30));
        let red = |x: u32| pixmap.pixel(x, 15).expect("inside").green() == 0;
        assert!(red(0) && red(29) && !red(30) && !red(59));
    }

    #[test]
    fn an_empty_canvas_is_an_error() {
        assert!(png(&Scene::new(0.0, 10.0, "test")).is_err());
    }
}
