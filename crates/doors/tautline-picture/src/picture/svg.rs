//! Writes a scene as SVG that contains only outlines, so that no viewer needs a font.

use super::scene::{Paint, Scene, Shape};
use crate::geometry::{Extent, Path, Segment};

/// Returns the scene as a stand-alone SVG document. The same scene gives the same bytes.
#[must_use]
pub fn svg(scene: &Scene) -> Vec<u8> {
    let (width, height) = (number(scene.width), number(scene.height));
    let mut out = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\">\n<title>{}</title>\n",
        escaped(&scene.title)
    );
    let mut clips: Vec<Extent> = Vec::new();
    for clip in scene.shapes().iter().filter_map(|shape| shape.clip) {
        if !clips.contains(&clip) {
            clips.push(clip);
        }
    }
    for (k, clip) in clips.iter().enumerate() {
        let path = path_data(&Path::rectangle(*clip));
        out += &format!("<clipPath id=\"clip{k}\"><path d=\"{path}\"/></clipPath>\n");
    }
    let mut open: Option<Extent> = None;
    for shape in scene.shapes() {
        if shape.clip != open {
            out.push_str(if open.is_some() { "</g>\n" } else { "" });
            if let Some(k) = clips.iter().position(|clip| Some(*clip) == shape.clip) {
                out += &format!("<g clip-path=\"url(#clip{k})\">\n");
            }
            open = shape.clip;
        }
        write_shape(&mut out, shape);
    }
    out.push_str(if open.is_some() { "</g>\n" } else { "" });
    out.push_str("</svg>\n");
    out.into_bytes()
}

fn write_shape(out: &mut String, shape: &Shape) {
    out.push_str("<path");
    if let Some((label, _)) = &shape.label {
        *out += &format!(" role=\"img\" aria-label=\"{}\"", escaped(label));
    }
    match shape.fill {
        Some(paint) => write_paint(out, "fill", paint),
        None => out.push_str(" fill=\"none\""),
    }
    if let Some(stroke) = &shape.stroke {
        write_paint(out, "stroke", stroke.paint);
        *out += &format!(" stroke-width=\"{}\"", number(stroke.width));
        out.push_str(" stroke-linejoin=\"round\"");
        if !stroke.dash.is_empty() {
            let dash: Vec<String> = stroke.dash.iter().map(|length| number(*length)).collect();
            *out += &format!(" stroke-dasharray=\"{}\"", dash.join(" "));
        }
    }
    *out += &format!(" d=\"{}\"/>\n", path_data(&shape.path));
}

fn write_paint(out: &mut String, what: &str, paint: Paint) {
    *out += &format!(" {what}=\"{}\"", paint.colour.hex());
    if paint.opacity < 1.0 {
        *out += &format!(" {what}-opacity=\"{}\"", number(paint.opacity));
    }
}

fn path_data(path: &Path) -> String {
    let mut out = String::new();
    for segment in path.segments() {
        let (letter, numbers): (char, &[f64]) = match segment {
            Segment::Move(x, y) => ('M', &[*x, *y]),
            Segment::Line(x, y) => ('L', &[*x, *y]),
            Segment::Cubic(all) => ('C', all),
            Segment::Close => ('Z', &[]),
        };
        out.push(letter);
        let numbers: Vec<String> = numbers.iter().map(|value| number(*value)).collect();
        out.push_str(&numbers.join(" "));
    }
    out
}

/// Returns a number to two decimals, that is, to a hundredth of a px, without trailing zeros.
fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    if text == "-0" { "0".to_owned() } else { text.to_owned() }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::super::scene::Scene;
    use super::{Extent, Path, Shape, escaped, number, svg};
    use crate::{
        colours::Colour,
        math_text::{Align, typeset},
    };

    #[test]
    fn numbers_are_short_and_never_minus_zero() {
        assert_eq!(number(1.0), "1");
        assert_eq!(number(-0.001), "0");
        assert_eq!(number(12.345_6), "12.35");
        assert_eq!(number(100.0), "100");
    }

    #[test]
    fn labels_are_outlines_with_a_reading() {
        let mut scene = Scene::new(100.0, 40.0, "a < b");
        let text = typeset("$a<b$", 12.0, Align::Left).expect("in the font");
        scene.write(&text, (5.0, 20.0), Colour::new(0, 0, 0));
        let text = String::from_utf8(svg(&scene)).expect("UTF-8");
        assert!(text.contains("<title>a &lt; b</title>"));
        assert!(text.contains("aria-label=\"a&lt;b\""));
        assert!(!text.contains("<text") && !text.contains("font"));
        assert_eq!(escaped("\"&\""), "&quot;&amp;&quot;");
    }

    #[test]
    fn clips_are_declared_once_and_groups_are_closed() {
        let mut scene = Scene::new(100.0, 40.0, "test");
        let clip = Extent { left: 1.0, top: 1.0, right: 9.0, bottom: 9.0 };
        for clip in [Some(clip), Some(clip), None, Some(clip)] {
            let mut shape = Shape::filled(Path::circle((5.0, 5.0), 5.0), Colour::new(0, 0, 0));
            shape.clip = clip;
            scene.push(shape);
        }
        let text = String::from_utf8(svg(&scene)).expect("UTF-8");
        assert!(text.contains("width=\"100\" height=\"40\" viewBox=\"0 0 100 40\""));
        assert_eq!(text.matches("<clipPath id=\"clip0\">").count(), 1);
        assert_eq!(text.matches("<g clip-path=\"url(#clip0)\">").count(), 2);
        assert_eq!(text.matches("</g>").count(), 2);
    }
}
