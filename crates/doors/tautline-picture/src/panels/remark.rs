//! Draws slope triangles and notes.

use std::cell::RefCell;

use super::plot::Plot;
use crate::{
    colours::palette::GREY,
    error::DrawingError,
    geometry::Path,
    marks::{Note, SlopeTriangle},
    math_text::{Align, half_digit, typeset},
    measures::{FRAME, SMALL, TEXT},
    picture::{Paint, Scene, Shape, Stroke},
};

/// Distance from a leg of a triangle to its number, in px.
const GAP: f64 = 5.0;

/// Draws a triangle in the stretch that contains its start.
pub(crate) fn draw_triangle(
    scene: &RefCell<Scene>,
    plots: &[Plot<'_>],
    triangle: &SlopeTriangle,
) -> Result<(), DrawingError> {
    let corners = triangle.corners();
    let plot = holding(plots, corners[0], "a slope triangle")?;
    holding(plots, corners[1], "the end of a slope triangle")?;
    let [start, end, corner] = corners.map(|point| plot.place(point));
    let scene = &mut *scene.borrow_mut();
    let path = Path::polyline([start, end, corner], true);
    let mut shape = Shape::filled(path, Paint { colour: GREY, opacity: 0.08 });
    shape.stroke = Some(Stroke::solid(GREY, FRAME));
    scene.push(shape);
    let (run, rise) = triangle.numbers();
    let run = typeset(&run, SMALL, Align::Centre)?;
    let under = corner.1 >= start.1.max(end.1);
    let baseline = if under { corner.1 + GAP - run.extent.top } else { corner.1 - GAP };
    scene.write(&run, ((start.0 + end.0) / 2.0, baseline), GREY.for_text());
    let left = corner.0 <= start.0.min(end.0);
    let rise = typeset(&rise, SMALL, if left { Align::Right } else { Align::Left })?;
    let x = if left { corner.0 - GAP } else { corner.0 + GAP };
    scene.write(&rise, (x, (start.1 + end.1) / 2.0 + half_digit(SMALL)), GREY.for_text());
    Ok(())
}

/// Writes a note at its data point.
pub(crate) fn draw_note(
    scene: &RefCell<Scene>,
    plots: &[Plot<'_>],
    note: &Note,
) -> Result<(), DrawingError> {
    let plot = holding(plots, note.at, &note.text)?;
    let text = typeset(&note.text, TEXT, note.align)?;
    let (x, y) = plot.place(note.at);
    let middle = (text.extent.top + text.extent.bottom) / 2.0;
    let at = (x + note.shift.0, y + note.shift.1 - middle);
    scene.borrow_mut().write_with_halo(&text, at, note.colour.for_text());
    Ok(())
}

fn holding<'p, 's>(
    plots: &'p [Plot<'s>],
    (x, y): (f64, f64),
    what: &str,
) -> Result<&'p Plot<'s>, DrawingError> {
    let found = plots.iter().find(|plot| plot.x.holds(x) && plot.y.holds(y));
    found.ok_or_else(|| DrawingError::Outside { what: what.to_owned(), x, y })
}
