//! The picture in one dimension: a graph over time.

use super::{
    Field, Portrait, PortraitError,
    background::{Background, contours},
    gram::Gram,
    plane::thinned,
    shadow::intervals,
    span::Span,
    style, window,
};
use crate::{Axis, Panel, Scale, Scene};

/// The width of the strips at both sides that show the ends, in units of time.
const STRIP: f64 = 0.06;
/// The height of the graph, in px.
const HEIGHT: f64 = 250.0;

/// Draws the picture of a problem on the line.
pub(crate) fn draw(portrait: &Portrait<'_>) -> Result<Scene, PortraitError> {
    let side = match portrait.window {
        Some(window) => window[0],
        None => window::choose(portrait, &[0])?[0],
    };
    let x = Span::new(0, side)?;
    let (from, to) = (-STRIP, 1.0 + STRIP);
    let mut background = metric(portrait, (from, to), x)?;
    let remarks = std::mem::take(&mut background.remarks);
    let time = Axis::new(Scale::Linear, from, to)?.labelled("time $t$");
    let mut panel = background.behind(Panel::new(time, x.axis("x")?).tall(HEIGHT));

    let ends = portrait.curve.first().zip(portrait.curve.last());
    let ends = ends.map(|(a, b)| [(0.0, x.drawn(a[0])), (1.0, x.drawn(b[0]))]);
    let mut lines = Vec::new();
    let strips = [(from, 0.0), (1.0, to)];
    for ((shapes, colour), strip) in portrait.pieces().into_iter().zip(style::ENDS).zip(strips) {
        for [low, high] in shapes.into_iter().flat_map(intervals) {
            let at = if strip.0 < 0.0 { strip.1 } else { strip.0 };
            if low == high {
                if !style::is_covered((at, x.drawn(low)), ends, x.ends()) {
                    lines.push(style::points(vec![(at, x.drawn(low))], colour));
                }
                continue;
            }
            // Ends beyond the window are moved to where their outline is not visible.
            let (bottom, top) = x.wider(0.2);
            let (low, high) = (low.clamp(bottom, top), high.clamp(bottom, top));
            if low < high {
                let (low, high) = (x.drawn(low), x.drawn(high));
                let ring = vec![(strip.0, low), (strip.1, low), (strip.1, high), (strip.0, high)];
                panel = style::area(ring, colour).into_iter().fold(panel, Panel::region);
            }
        }
    }
    let graph = |curve: &[Vec<f64>]| -> Vec<(f64, f64)> {
        let last = (curve.len() - 1).max(1) as f64;
        let points: Vec<(f64, f64)> = curve
            .iter()
            .enumerate()
            .map(|(k, point)| (k as f64 / last, (point[0] - x.from) / x.length()))
            .collect();
        // Both directions have length 1 here, so that one distance serves both.
        let points = thinned(&points, style::FINEST);
        points.into_iter().map(|(t, s)| (t, x.drawn(x.from + s * x.length()))).collect()
    };
    let inside = |curve: &[Vec<f64>]| {
        if curve.is_empty() {
            return Vec::new();
        }
        let (low, high) = x.wider(0.2);
        crate::clip::polyline(&graph(curve), (0.0, 1.0), (x.drawn(low), x.drawn(high)))
    };
    let others = portrait.others.iter().map(|other| inside(other)).collect();
    let curves = style::curves(inside(portrait.curve), ends, others, false);
    let panel = lines.into_iter().chain(curves).fold(panel, Panel::curve);

    let proved = portrait.corridor.iter().map(|corridor| corridor.remark("Proved:"));
    let remarks = proved.chain(remarks).collect();
    let title = portrait.title("over time");
    style::finished(panel, title, remarks, !portrait.others.is_empty())
}

fn metric(portrait: &Portrait<'_>, time: (f64, f64), x: Span) -> Result<Background, PortraitError> {
    if portrait.field == Field::Plain {
        return Ok(Background::default());
    }
    let gram = Gram::of(portrait);
    let background = contours(time, x.ends(), "H", |_, u| gram.determinant(&[x.data(u)]))?;
    gram.check()?;
    Ok(background)
}
