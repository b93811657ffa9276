//! The frame of a panel: its grid, axes and ticks, and the labels around it.

use std::cell::RefCell;

use super::{end_label::EndLabel, panel::Panel, plot::Plot};
use crate::{
    axes::{Direction, Tick, named_ticks, ticks},
    colours::{
        Colour,
        palette::{GRID, INK},
    },
    error::DrawingError,
    geometry::{Extent, Path},
    math_text::{Align, TextBlock, half_digit, typeset},
    measures::{BREAK, FRAME, INSET, LABEL_GAP, MINOR_TICK, SMALL, TEXT, THIN, TICK, TICK_GAP},
    picture::{Scene, Shape, Stroke},
};

/// The space that a panel needs around its frame, in px.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Margins {
    pub(crate) left: f64,
    pub(crate) right: f64,
    pub(crate) top: f64,
    pub(crate) bottom: f64,
    /// Distance from the frame to the labels at the ends of curves, which is part of `right`.
    pub(crate) end_gap: f64,
}

/// A label of the `y` axis is horizontal if it is at most this wide, in px.
const UPRIGHT: f64 = 26.0;
/// Distance from the frame to the title above it, in px.
const TITLE_GAP: f64 = 10.0;
/// The length of the axis inside a break, in px. The number at its end must not touch the mark.
const BREAK_REACH: f64 = 10.0;

/// Returns the pieces of a panel with this frame, the lowest first. All have the same scale.
pub(crate) fn plots<'a>(panel: &Panel, scene: &'a RefCell<Scene>, frame: Extent) -> Vec<Plot<'a>> {
    let inset = if panel.boxed { 0.0 } else { INSET };
    let aside = if panel.flush { 0.0 } else { inset };
    let stretches = &panel.y.stretches;
    let total: f64 = stretches.iter().map(|stretch| stretch.length()).sum();
    let breaks = BREAK * (stretches.len() - 1) as f64;
    let unit = (frame.height() - 2.0 * inset - breaks) / total;
    let mut low = frame.bottom - inset;
    let mut plots = Vec::with_capacity(stretches.len());
    for (k, stretch) in stretches.iter().enumerate() {
        let up = (low, low - unit * stretch.length());
        let bottom = if k == 0 { frame.bottom } else { low + BREAK_REACH };
        let last = k + 1 == stretches.len();
        let top = if last { frame.top } else { up.1 - BREAK_REACH };
        let clip = Extent { top, bottom, ..frame };
        let across = (frame.left + aside, frame.right - aside);
        plots.push(Plot { scene, x: panel.x.stretches[0], y: *stretch, across, up, clip });
        low = up.1 - BREAK;
    }
    plots
}

/// Measures the space that a panel needs around its frame.
pub(crate) fn margins(
    panel: &Panel,
    plots: &[Plot<'_>],
    ends: &[EndLabel],
    bar: (f64, f64),
) -> Result<Margins, DrawingError> {
    let outwards = outward_tick(panel);
    let mut margins = Margins { left: outwards, bottom: outwards, ..Margins::default() };
    if panel.y.numbered {
        let numbers = y_ticks(panel, plots)?;
        margins.left += TICK_GAP + widest(numbers.iter().map(|(_, tick)| tick));
    }
    if let Some(label) = y_label(panel)? {
        margins.left += LABEL_GAP + label.extent.width();
    }
    let mut half_number: f64 = 0.0;
    if panel.x.numbered {
        let numbers = x_ticks(panel, plots)?;
        margins.bottom += TICK_GAP + tallest(&numbers);
        half_number = widest(numbers.iter()) / 2.0;
    }
    if !panel.x.label.is_empty() {
        let label = typeset(&panel.x.label, TEXT, Align::Centre)?;
        margins.bottom += LABEL_GAP + label.extent.height();
    }
    let (ends_width, gap) = EndLabel::width_and_gap(ends);
    margins.right = ends_width.max(bar.0).max(half_number);
    margins.left = margins.left.max(half_number);
    margins.end_gap = gap;
    margins.top = bar.1.max(half_digit(SMALL));
    if !panel.title.is_empty() {
        let title = typeset(&panel.title, TEXT, Align::Left)?;
        margins.top = margins.top.max(title.extent.height() + TITLE_GAP);
    }
    Ok(margins)
}

/// Draws the grid behind the data.
pub(crate) fn draw_grid(
    scene: &RefCell<Scene>,
    panel: &Panel,
    plots: &[Plot<'_>],
    frame: Extent,
) -> Result<(), DrawingError> {
    if panel.boxed {
        return Ok(());
    }
    for (y, tick) in y_ticks(panel, plots)? {
        if tick.label.is_some() {
            draw_line(&mut scene.borrow_mut(), [(frame.left, y), (frame.right, y)], GRID, THIN);
        }
    }
    Ok(())
}

/// Draws the axes, ticks, numbers, labels and title. The `y` label starts at `label_left`.
pub(crate) fn draw_axes(
    scene: &mut Scene,
    panel: &Panel,
    plots: &[Plot<'_>],
    frame: Extent,
    label_left: f64,
) -> Result<(), DrawingError> {
    let outwards = outward_tick(panel);
    let inwards = if outwards > 0.0 { -1.0 } else { 1.0 };
    let length = |tick: &Tick| inwards * if tick.label.is_some() { TICK } else { MINOR_TICK };
    for (y, tick) in y_ticks(panel, plots)? {
        draw_line(scene, [(frame.left, y), (frame.left + length(&tick), y)], INK, THIN);
        if let Some(label) = tick.label.filter(|_| panel.y.numbered) {
            scene.write(&label, (frame.left - outwards - TICK_GAP, y + half_digit(SMALL)), INK);
        }
    }
    let numbers = x_ticks(panel, plots)?;
    // All numbers have the same baseline, as high as the tallest number allows.
    let baseline = frame.bottom + outwards + TICK_GAP + tallest(&numbers);
    for tick in numbers {
        let x = plots[0].place((tick.value, plots[0].y.from)).0;
        draw_line(scene, [(x, frame.bottom), (x, frame.bottom - length(&tick))], INK, THIN);
        if let Some(label) = tick.label.filter(|_| panel.x.numbered) {
            scene.write(&label, (x, baseline), INK);
        }
    }
    draw_spines(scene, panel, plots, frame);
    if !panel.x.label.is_empty() {
        let label = typeset(&panel.x.label, TEXT, Align::Centre)?;
        let below = if panel.x.numbered { baseline } else { frame.bottom + outwards };
        let x = (frame.left + frame.right) / 2.0;
        scene.write(&label, (x, below + LABEL_GAP - label.extent.top), INK);
    }
    if let Some(label) = y_label(panel)? {
        let middle = (frame.top + frame.bottom) / 2.0;
        let centre = (label.extent.top + label.extent.bottom) / 2.0;
        scene.write(&label, (label_left - label.extent.left, middle - centre), INK);
    }
    if !panel.title.is_empty() {
        let title = typeset(&panel.title, TEXT, Align::Left)?;
        scene.write(&title, (frame.left, frame.top - TITLE_GAP - title.extent.bottom), INK);
    }
    Ok(())
}

/// Draws the axis lines, which are open at the top and right for curves, and closed around a
/// heat-map.
fn draw_spines(scene: &mut Scene, panel: &Panel, plots: &[Plot<'_>], frame: Extent) {
    if panel.boxed {
        scene.push(Shape::stroked(Path::rectangle(frame), Stroke::solid(INK, FRAME)));
        return;
    }
    for (k, plot) in plots.iter().enumerate() {
        let Extent { left, top, right, bottom } = plot.clip;
        let mut spine = vec![(left, top), (left, bottom)];
        spine.extend((k == 0).then_some((right, bottom)));
        scene.push(Shape::stroked(Path::polyline(spine, false), Stroke::solid(INK, FRAME)));
        let cuts = [(k > 0).then_some(bottom), (k + 1 < plots.len()).then_some(top)];
        for y in cuts.into_iter().flatten() {
            draw_line(scene, [(left - 4.5, y + 2.5), (left + 4.5, y - 2.5)], INK, FRAME);
        }
    }
}

/// Returns the length of outward ticks. Over a heat-map inward ticks would not be visible.
fn outward_tick(panel: &Panel) -> f64 {
    if panel.boxed { TICK } else { 0.0 }
}

fn x_ticks(panel: &Panel, plots: &[Plot<'_>]) -> Result<Vec<Tick>, DrawingError> {
    if !panel.x.names.is_empty() {
        return named_ticks(&panel.x, Direction::Horizontal);
    }
    let (from, to) = plots[0].across;
    ticks(&plots[0].x, to - from, Direction::Horizontal)
}

/// Returns the ticks of all stretches of the `y` axis, each with its position.
fn y_ticks(panel: &Panel, plots: &[Plot<'_>]) -> Result<Vec<(f64, Tick)>, DrawingError> {
    let mut all = Vec::new();
    for plot in plots {
        let ticks = if panel.y.names.is_empty() {
            ticks(&plot.y, plot.up.0 - plot.up.1, Direction::Vertical)?
        } else {
            named_ticks(&panel.y, Direction::Vertical)?
        };
        all.extend(ticks.into_iter().map(|tick| (plot.y.place(tick.value, plot.up), tick)));
    }
    Ok(all)
}

fn widest<'t>(ticks: impl Iterator<Item = &'t Tick>) -> f64 {
    ticks.filter_map(|tick| Some(tick.label.as_ref()?.extent.width())).fold(0.0, f64::max)
}

fn tallest(ticks: &[Tick]) -> f64 {
    ticks.iter().filter_map(|tick| Some(-tick.label.as_ref()?.extent.top)).fold(0.0, f64::max)
}

fn y_label(panel: &Panel) -> Result<Option<TextBlock>, DrawingError> {
    if panel.y.label.is_empty() {
        return Ok(None);
    }
    let label = typeset(&panel.y.label, TEXT, Align::Centre)?;
    Ok(Some(if label.extent.width() <= UPRIGHT { label } else { label.upwards() }))
}

fn draw_line(scene: &mut Scene, ends: [(f64, f64); 2], colour: Colour, width: f64) {
    scene.push(Shape::stroked(Path::polyline(ends, false), Stroke::solid(colour, width)));
}

#[cfg(test)]
mod tests {
    use super::{Extent, Panel, RefCell, Scene, plots};
    use crate::axes::{Axis, Scale};

    #[test]
    fn a_broken_axis_keeps_one_scale() {
        let x = Axis::new(Scale::Octaves, 1.0, 64.0).expect("a range");
        let y = Axis::new(Scale::Decades, 1e-8, 1e14).expect("a range");
        let panel = Panel::new(x, y.broken(1e1, 1e12).expect("inside"));
        let scene = RefCell::new(Scene::new(200.0, 200.0, "test"));
        let frame = Extent { left: 10.0, top: 10.0, right: 190.0, bottom: 190.0 };
        let pieces = plots(&panel, &scene, frame);
        let decade = |k: usize| (pieces[k].up.0 - pieces[k].up.1) / pieces[k].y.length();
        assert!((decade(0) - decade(1)).abs() <= 1e-9);
        assert!(!pieces[0].clip.overlaps(&pieces[1].clip) && pieces[0].clip.top < pieces[0].up.1);
        assert!(frame.contains(&pieces[0].clip) && frame.contains(&pieces[1].clip));
        assert_eq!((pieces[0].clip.bottom, pieces[1].clip.top), (frame.bottom, frame.top));
    }
}
