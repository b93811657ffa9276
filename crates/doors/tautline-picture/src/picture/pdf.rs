//! Writes a scene as a one-page vector PDF.

use pdf_writer::{
    Content, Filter, Finish as _, Name, Pdf, Rect, Ref, TextStr, types::LineJoinStyle,
};

use super::scene::{Scene, Shape};
use crate::geometry::{Path, Segment};

/// The number of points in one px, as in CSS: 96 px and 72 pt are an inch.
const POINTS: f64 = 0.75;

/// Returns the scene as a PDF document. The same scene gives the same bytes.
///
/// The document has no date and no identifier.
#[must_use]
pub fn pdf(scene: &Scene) -> Vec<u8> {
    let (catalog, pages, page) = (Ref::new(1), Ref::new(2), Ref::new(3));
    let (contents, information) = (Ref::new(4), Ref::new(5));
    let opacities = opacities(scene);
    let mut pdf = Pdf::new();
    pdf.catalog(catalog).pages(pages);
    pdf.pages(pages).kids([page]).count(1);
    let mut sheet = pdf.page(page);
    let (width, height) = ((scene.width * POINTS) as f32, (scene.height * POINTS) as f32);
    sheet.media_box(Rect::new(0.0, 0.0, width, height)).parent(pages).contents(contents);
    let mut resources = sheet.resources();
    let mut states = resources.ext_g_states();
    for (k, opacity) in opacities.iter().enumerate() {
        let opacity = *opacity as f32;
        let name = format!("opacity{k}");
        let mut state = states
            .insert(Name(name.as_bytes()))
            .start::<pdf_writer::writers::ExtGraphicsState<'_>>();
        state.stroking_alpha(opacity).non_stroking_alpha(opacity);
    }
    states.finish();
    resources.finish();
    sheet.finish();
    let stream = miniz_oxide::deflate::compress_to_vec_zlib(&content(scene, &opacities), 9);
    pdf.stream(contents, &stream).filter(Filter::FlateDecode);
    pdf.document_info(information).title(TextStr(&scene.title));
    pdf.finish()
}

/// Returns the opacities that occur, in order of appearance.
fn opacities(scene: &Scene) -> Vec<f64> {
    let mut found: Vec<f64> = Vec::new();
    for shape in scene.shapes() {
        let paints = [shape.fill, shape.stroke.as_ref().map(|stroke| stroke.paint)];
        for paint in paints.into_iter().flatten() {
            if !found.contains(&paint.opacity) {
                found.push(paint.opacity);
            }
        }
    }
    found
}

/// Returns the drawing operators, uncompressed.
fn content(scene: &Scene, opacities: &[f64]) -> Vec<u8> {
    let mut out = Content::new();
    // From here on, coordinates are those of the scene: in px, with y pointing downwards.
    let points = POINTS as f32;
    out.transform([points, 0.0, 0.0, -points, 0.0, (scene.height * POINTS) as f32]);
    out.set_line_join(LineJoinStyle::RoundJoin);
    for shape in scene.shapes() {
        write_shape(&mut out, shape, opacities);
    }
    out.finish().into_vec()
}

fn write_shape(out: &mut Content, shape: &Shape, opacities: &[f64]) {
    out.save_state();
    if let Some(clip) = shape.clip {
        write_path(out, &Path::rectangle(clip));
        out.clip_nonzero().end_path();
    }
    let opacity_name = |opacity: f64| {
        let k = opacities.iter().position(|known| *known == opacity);
        format!("opacity{}", k.expect("`opacities` lists those of all shapes"))
    };
    if let Some(paint) = shape.fill {
        let [red, green, blue] = paint.colour.rgb.map(|byte| f32::from(byte) / 255.0);
        out.set_parameters(Name(opacity_name(paint.opacity).as_bytes()));
        out.set_fill_rgb(red, green, blue);
        write_path(out, &shape.path);
        out.fill_nonzero();
    }
    if let Some(stroke) = &shape.stroke {
        let [red, green, blue] = stroke.paint.colour.rgb.map(|byte| f32::from(byte) / 255.0);
        out.set_parameters(Name(opacity_name(stroke.paint.opacity).as_bytes()));
        out.set_stroke_rgb(red, green, blue);
        out.set_line_width(rounded(stroke.width));
        if !stroke.dash.is_empty() {
            out.set_dash_pattern(stroke.dash.iter().map(|length| rounded(*length)), 0.0);
        }
        write_path(out, &shape.path);
        out.stroke();
    }
    out.restore_state();
}

fn write_path(out: &mut Content, path: &Path) {
    for segment in path.segments() {
        match *segment {
            Segment::Move(x, y) => out.move_to(rounded(x), rounded(y)),
            Segment::Line(x, y) => out.line_to(rounded(x), rounded(y)),
            Segment::Cubic(all) => {
                let [a, b, c, d, x, y] = all.map(rounded);
                out.cubic_to(a, b, c, d, x, y)
            }
            Segment::Close => out.close_path(),
        };
    }
}

/// Rounds to a hundredth of a px, as the SVG does, so that both contain the same numbers.
fn rounded(value: f64) -> f32 {
    ((value * 100.0).round() / 100.0) as f32
}

#[cfg(test)]
mod tests {
    use super::super::{
        scene::{Shape, Stroke},
        svg::svg,
    };
    use super::{Scene, content, opacities, pdf};
    use crate::{colours::Colour, geometry::Path};

    fn scene() -> Scene {
        let mut scene = Scene::new(30.0, 20.0, "three shapes");
        let mut stroke = Stroke::solid(Colour::new(0, 114, 178), 1.5);
        stroke.paint.opacity = 0.5;
        stroke.dash = vec![3.0, 1.0];
        scene.push(Shape::stroked(Path::polyline([(1.0, 2.0), (28.123_4, 18.0)], false), stroke));
        scene.push(Shape::filled(Path::circle((10.0, 10.0), 4.0), Colour::new(213, 94, 0)));
        scene
    }

    /// Returns the coordinates of all points in order, skipping other operators.
    fn coordinates(operators: &str, letters: &[&str]) -> Vec<f64> {
        let mut found = Vec::new();
        let mut pending = Vec::new();
        for word in operators.split_whitespace() {
            if let Ok(value) = word.parse::<f64>() {
                pending.push(value);
            } else if letters.contains(&word) {
                found.append(&mut pending);
            } else {
                pending.clear();
            }
        }
        found
    }

    #[test]
    fn pdf_and_svg_hold_the_same_points() {
        let scene = scene();
        let operators = content(&scene, &opacities(&scene));
        let operators = String::from_utf8(operators).expect("operators are ASCII");
        let in_pdf = coordinates(&operators, &["m", "l", "c"]);
        let text = String::from_utf8(svg(&scene)).expect("UTF-8");
        let data: Vec<&str> =
            text.split(" d=\"").skip(1).filter_map(|d| d.split('"').next()).collect();
        // Numbers precede their operator in PDF, and follow it in SVG.
        let in_svg: Vec<f64> = data
            .join(" ")
            .replace(['M', 'L', 'C', 'Z'], " ")
            .split_whitespace()
            .map(|word| word.parse().expect("a number"))
            .collect();
        assert!(in_pdf.len() >= 8 + 4 + 26);
        assert_eq!(in_pdf.len(), in_svg.len());
        for (a, b) in in_pdf.iter().zip(&in_svg) {
            // PDF numbers are f32, with seven digits for a few hundred px. A tie between two
            // hundredths may be rounded either way.
            assert!((a - b).abs() <= 0.0101, "{a} and {b}");
        }
    }

    #[test]
    fn the_document_is_complete_and_timeless() {
        let bytes = pdf(&scene());
        assert!(bytes.starts_with(b"%PDF-") && bytes.trim_ascii_end().ends_with(b"%%EOF"));
        let text = String::from_utf8_lossy(&bytes);
        assert!(text.contains("/MediaBox [0 0 22.5 15]"), "{text}");
        assert!(!text.contains("Date") && !text.contains("/ID"));
        assert_eq!(bytes, pdf(&scene()));
    }
}
