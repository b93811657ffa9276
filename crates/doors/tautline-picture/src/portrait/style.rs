//! Colours and widths of a portrait.

use super::PortraitError;
use crate::{Colour, Curve, Figure, Marker, Panel, Region, Scene, palette};

/// The width of the picture, in px. At 85 mm its smallest numbers, of 13.5 px, are 7.4 pt large.
pub(crate) const WIDTH: f64 = 440.0;
/// The colours of the sets at the start and at the end.
pub(crate) const ENDS: [Colour; 2] = [palette::GREEN, palette::PURPLE];

/// The colour of a corridor.
const CORRIDOR: Colour = palette::ORANGE;
const CURVE: Colour = palette::VERMILLION;

/// Points of a curve that are closer than this share of the width of the window are omitted: a
/// quarter of a px.
pub(crate) const FINEST: f64 = 1.0 / 1500.0;

/// Returns the other minima, and the solution over them. Each is given by its visible pieces. Over a
/// corridor, which may be narrow, the solution is a thin line.
pub(crate) fn curves(
    pieces: Vec<Vec<(f64, f64)>>,
    ends: Option<[(f64, f64); 2]>,
    others: Vec<Vec<Vec<(f64, f64)>>>,
    over_corridor: bool,
) -> Vec<Curve> {
    let count = others.len();
    let name = if count == 0 { "" } else { "shortest found" };
    // The key lists names in the order of the curves, so an empty one keeps the first place.
    let mut curves = solution(vec![Vec::new()], None, name, over_corridor);
    curves.extend(others.into_iter().flat_map(|other_pieces| other(other_pieces, count)));
    curves.extend(solution(pieces, ends, name, over_corridor));
    curves
}

/// Returns the solution, with a ring at its start and a disc at its end. The name is for the key.
fn solution(
    pieces: Vec<Vec<(f64, f64)>>,
    ends: Option<[(f64, f64); 2]>,
    name: &str,
    over_corridor: bool,
) -> Vec<Curve> {
    let line = |piece| {
        let line = Curve::new(piece, CURVE).labelled(name);
        if over_corridor { line.wide(1.2) } else { line.wide(2.6).over_field() }
    };
    let mut curves: Vec<Curve> = pieces.into_iter().map(line).collect();
    if let Some([start, end]) = ends {
        curves.push(marked(vec![end], CURVE, Marker::Disc));
        curves.push(marked(vec![start], CURVE, Marker::Ring));
    }
    curves
}

/// Returns one of `count` other local minima. They all have the same name in the key.
fn other(pieces: Vec<Vec<(f64, f64)>>, count: usize) -> Vec<Curve> {
    let name = if count == 1 { "other local minimum" } else { "other local minima" };
    let line = |piece| {
        Curve::new(piece, palette::INK).wide(1.4).dashed(&[6.0, 3.5]).over_field().labelled(name)
    };
    pieces.into_iter().map(line).collect()
}

/// Returns the area of a set. A white veil under its colour keeps it light over every contour.
pub(crate) fn area(ring: Vec<(f64, f64)>, colour: Colour) -> [Region; 2] {
    let veil = Region::new(vec![ring.clone()]).filled(Colour::WHITE, 0.4);
    let area = Region::new(vec![ring]).filled(colour, 0.3);
    [veil, area.outlined(colour.for_text(), 1.5).over_field()]
}

/// Returns the area of one of `count` levels of a corridor, the last of which is the finest. Levels
/// lie over each other, so that finer ones are darker.
pub(crate) fn corridor(rings: Vec<Vec<(f64, f64)>>, level: usize, count: usize) -> Region {
    let (opacity, width) = if level + 1 == count { (0.8, 0.5) } else { (0.1, 0.5) };
    Region::new(rings).filled(CORRIDOR, opacity).outlined(CORRIDOR, width)
}

/// Returns the lines of a set that has no area.
pub(crate) fn line(points: Vec<(f64, f64)>, colour: Colour) -> Curve {
    Curve::new(points, colour.for_text()).wide(2.0).over_field()
}

/// Returns the points of a finite set.
pub(crate) fn points(points: Vec<(f64, f64)>, colour: Colour) -> Curve {
    marked(points, colour.for_text(), Marker::Square)
}

/// Returns whether the marker at an end of the curve hides a point, in a window with this first
/// range.
pub(crate) fn is_covered(
    (x, y): (f64, f64),
    ends: Option<[(f64, f64); 2]>,
    (from, to): (f64, f64),
) -> bool {
    // A marker is about a hundredth of the picture wide.
    let near = |end: &(f64, f64)| (x - end.0).hypot(y - end.1) <= 2e-3 * (to - from);
    ends.is_some_and(|ends| ends.iter().any(near))
}

/// Draws the panel over the remarks, with a key if there is more than one kind of curve.
pub(crate) fn finished(
    panel: Panel,
    title: String,
    remarks: Vec<String>,
    has_key: bool,
) -> Result<Scene, PortraitError> {
    let figure = Figure::new(WIDTH, title, vec![vec![panel]]);
    let figure = if has_key { figure.keyed() } else { figure };
    let figure = if remarks.is_empty() { figure } else { figure.remark(remarks.join(" ")) };
    Ok(figure.draw()?)
}

fn marked(points: Vec<(f64, f64)>, colour: Colour, marker: Marker) -> Curve {
    Curve::new(points, colour).without_line().marked(marker).over_field()
}
