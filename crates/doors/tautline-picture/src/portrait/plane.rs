//! The picture in the plane of two coordinates.

use super::{
    Field, Portrait, PortraitError,
    background::{Background, contours},
    corridor,
    ellipses::ellipses,
    gram::Gram,
    lift::Lift,
    shadow::{Frame, Point, Shadow},
    span::Span,
    style, window,
};
use crate::{Curve, Panel, Region, Scene};

/// Returns the coordinates that are drawn: those that were asked for, or the two along which the
/// curves extend farthest.
pub(crate) fn coordinates(portrait: &Portrait<'_>) -> [usize; 2] {
    if let Some(coordinates) = portrait.coordinates {
        return coordinates;
    }
    let points = || portrait.curve.iter().chain(portrait.others.iter().flatten());
    let extent = |k: usize| {
        let ends = points().fold((f64::INFINITY, f64::NEG_INFINITY), |ends, point| {
            (ends.0.min(point[k]), ends.1.max(point[k]))
        });
        (ends.1 - ends.0).max(0.0)
    };
    let extents: Vec<f64> = (0..portrait.dimension).map(extent).collect();
    let mut order: Vec<usize> = (0..portrait.dimension).collect();
    // The sort is stable: of equal extents, the first coordinates are drawn.
    order.sort_by(|i, j| extents[*j].total_cmp(&extents[*i]));
    [order[0].min(order[1]), order[0].max(order[1])]
}

/// The part of the plane that is drawn.
#[derive(Clone, Copy)]
struct View {
    plane: [usize; 2],
    x: Span,
    y: Span,
}

impl View {
    fn of(portrait: &Portrait<'_>) -> Result<View, PortraitError> {
        let plane = coordinates(portrait);
        let spans = |sides: [[f64; 2]; 2]| -> Result<[Span; 2], PortraitError> {
            Ok([Span::new(plane[0], sides[0])?, Span::new(plane[1], sides[1])?])
        };
        let sides = match portrait.window {
            // A window without an inside is refused before it is made rounder.
            Some(window) => spans(window).map(|_| window)?,
            None => {
                let chosen = window::choose(portrait, &plane)?;
                [chosen[0], chosen[1]]
            }
        };
        let [x, y] = Span::with_equal_units(spans(window::rounder(sides))?);
        Ok(View { plane, x, y })
    }

    /// Returns the numbers on the axes for a point of the plane.
    fn number(&self, (a, b): Point) -> Point {
        (self.x.drawn(a), self.y.drawn(b))
    }

    fn numbers(&self, points: Vec<Point>) -> Vec<Point> {
        points.into_iter().map(|point| self.number(point)).collect()
    }

    /// Returns the projection of a point of `R^D`.
    fn seen(&self, point: &[f64]) -> Point {
        (point[self.plane[0]], point[self.plane[1]])
    }
}

/// What is drawn of the sets.
#[derive(Default)]
struct Sets {
    areas: Vec<Region>,
    lines: Vec<Curve>,
    remarks: Vec<String>,
}

/// Draws the picture of a problem in at least two dimensions.
pub(crate) fn draw(portrait: &Portrait<'_>) -> Result<Scene, PortraitError> {
    let view = View::of(portrait)?;
    let View { plane, x, y } = view;
    let mut background = metric(portrait, view)?;
    let remarks = std::mem::take(&mut background.remarks);
    let [right, up] = plane.map(|k| format!("x_{{{}}}", k + 1));
    let panel = Panel::new(x.axis(&right)?, y.axis(&up)?).equal_units();
    let panel = background.behind(panel);

    let ends = portrait.curve.first().zip(portrait.curve.last());
    let ends = ends.map(|(a, b)| [a, b].map(|point| view.number(view.seen(point))));
    let frame = Frame::new(plane, [x, y]);
    let sets = sets(portrait, view, frame, ends);
    let (corridor, proved) = corridor(portrait, view);
    let remarks = [proved, sets.remarks, remarks].concat();

    let pieces = |curve: &[Vec<f64>]| -> Vec<Vec<Point>> {
        let points: Vec<Point> = curve.iter().map(|point| view.seen(point)).collect();
        let points = thinned(&points, x.length() * style::FINEST);
        frame.pieces(&points).into_iter().map(|piece| view.numbers(piece)).collect()
    };
    let others = portrait.others.iter().map(|other| pieces(other)).collect();
    let curves = style::curves(pieces(portrait.curve), ends, others, portrait.corridor.is_some());
    let panel = corridor.into_iter().chain(sets.areas).fold(panel, Panel::region);
    let panel = sets.lines.into_iter().chain(curves).fold(panel, Panel::curve);

    let title = portrait.title(&format!("in the plane of x{} and x{}", plane[0] + 1, plane[1] + 1));
    style::finished(panel, title, remarks, !portrait.others.is_empty())
}

/// Projects the sets; a point under an end of the curve is left out.
fn sets(portrait: &Portrait<'_>, view: View, frame: Frame, ends: Option<[(f64, f64); 2]>) -> Sets {
    let mut sets = Sets::default();
    let mut any = false;
    for (shapes, colour) in portrait.pieces().into_iter().zip(style::ENDS) {
        for shape in shapes {
            any = true;
            match frame.shadow(shape) {
                Shadow::Area(ring) => sets.areas.extend(style::area(view.numbers(ring), colour)),
                Shadow::Lines(pieces) => {
                    let lines = pieces.into_iter().map(|p| style::line(view.numbers(p), colour));
                    sets.lines.extend(lines);
                }
                Shadow::Points(points) => {
                    let mut points = view.numbers(points);
                    points.retain(|point| !style::is_covered(*point, ends, view.x.ends()));
                    sets.lines.push(style::points(points, colour));
                }
                Shadow::Everything => {
                    let what = shape.name();
                    let remark = format!("Not drawn: {what}, whose projection is the whole plane.");
                    sets.remarks.push(remark);
                }
            }
        }
    }
    if any && portrait.dimension > 2 {
        sets.remarks.insert(0, "Sets are projected.".to_owned());
    }
    sets
}

/// Returns what is seen of the corridor, level by level, and what is proved.
fn corridor(portrait: &Portrait<'_>, view: View) -> (Vec<Region>, Vec<String>) {
    let Some(corridor) = &portrait.corridor else { return (Vec::new(), Vec::new()) };
    let near = (view.x.wider(0.2), view.y.wider(0.2));
    let count = corridor.levels.len();
    let regions = corridor.levels.iter().enumerate().map(|(level, cubes)| {
        let rings = corridor::rings(cubes, portrait.dimension, view.plane, near);
        style::corridor(rings.into_iter().map(|ring| view.numbers(ring)).collect(), level, count)
    });
    let lie = if portrait.dimension > 2 {
        "Every minimal geodesic projects into the darkest orange squares;"
    } else {
        "Every minimal geodesic lies in the darkest orange squares;"
    };
    (regions.collect(), vec![corridor.remark(lie)])
}

/// Returns the metric behind the plane.
fn metric(portrait: &Portrait<'_>, view: View) -> Result<Background, PortraitError> {
    let View { plane, x, y } = view;
    let is_slice = portrait.dimension > 2;
    let gram = Gram::of(portrait);
    if portrait.field == Field::Plain {
        return Ok(Background::default());
    }
    if is_slice && portrait.curve.is_empty() {
        let remark = "$H$ is not shown: without a curve, the other coordinates are not known.";
        return Ok(Background { remarks: vec![remark.to_owned()], ..Background::default() });
    }
    let lift = Lift::new(portrait.curve, plane, 1e-3 * x.length());
    let lifted = |at: [f64; 2]| {
        if is_slice {
            lift.at(at)
        } else {
            let mut point = vec![0.0; 2];
            (point[plane[0]], point[plane[1]]) = (at[0], at[1]);
            point
        }
    };
    let mut background = if portrait.field == Field::Ellipses {
        let which = if is_slice { " for $v$ in this plane" } else { "" };
        ellipses([x, y], which, |at| gram.block(&lifted(at), plane))
    } else {
        contours(x.ends(), y.ends(), "\"det\" H", |a, b| {
            gram.determinant(&lifted([x.data(a), y.data(b)]))
        })?
    };
    gram.check()?;
    if is_slice {
        let remark = "The other coordinates of $H$ are means over the curve, weighted by \
                      $1/\"distance\"^4$.";
        background.remarks.push(remark.to_owned());
    }
    Ok(background)
}

/// Omits points that are closer than `finest` to the last one kept, except the end.
pub(crate) fn thinned(points: &[Point], finest: f64) -> Vec<Point> {
    let mut kept: Vec<Point> = Vec::new();
    for &(x, y) in points {
        if kept.last().is_none_or(|last| (x - last.0).hypot(y - last.1) >= finest) {
            kept.push((x, y));
        }
    }
    match points.last() {
        Some(end) if kept.last() != Some(end) => kept.push(*end),
        _ => {}
    }
    kept
}
