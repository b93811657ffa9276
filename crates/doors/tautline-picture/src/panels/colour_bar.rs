//! The colour scale of a heat-map, to its right.

use crate::{
    axes::{Direction, Stretch, Tick, ticks, ticks_at},
    colours::palette::INK,
    error::DrawingError,
    geometry::{Extent, Path},
    marks::Field,
    math_text::{Align, half_digit, typeset},
    measures::{BAR, SMALL, TEXT, THIN, TICK_GAP},
    picture::{Scene, Shape, Stroke},
};

/// Distance from the frame to the bar, and from the bar to the label above it, in px.
const GAP: f64 = 16.0;
const ABOVE: f64 = 9.0;
/// Height of the tip at an open end, in px.
const TIP: f64 = 11.0;

/// Returns the space that the bar needs to the right of the frame and above it, in px.
pub(crate) fn space(field: &Field, height: f64) -> Result<(f64, f64), DrawingError> {
    let stretch = values(field)?;
    let numbers = numbers(field, &stretch, height - tips(field))?;
    let widths = numbers.iter().filter_map(|tick| Some(tick.label.as_ref()?.extent.width()));
    let label = typeset(&field.label, TEXT, Align::Left)?.extent;
    let right = (BAR + TICK_GAP + widths.fold(0.0, f64::max)).max(label.width());
    Ok((GAP + right, if label.width() > 0.0 { label.height() + ABOVE } else { 0.0 }))
}

/// Draws the bar to the right of `frame`.
pub(crate) fn draw(scene: &mut Scene, field: &Field, frame: Extent) -> Result<(), DrawingError> {
    let stretch = values(field)?;
    let left = frame.right + GAP;
    let [below, above] = field.open.map(|open| if open { TIP } else { 0.0 });
    let bar =
        Extent { left, right: left + BAR, top: frame.top + above, bottom: frame.bottom - below };
    let place = |value: f64| stretch.place(value, (bar.bottom, bar.top));
    for (k, level) in field.levels().iter().enumerate().take(field.levels().len() - 1) {
        // The band extends up to the top, under the bands drawn later, so that no gap opens between
        // them.
        let band = Extent { bottom: place(*level), ..bar };
        scene.push(Shape::filled(Path::rectangle(band), field.colour(k)));
    }
    let middle = (bar.left + bar.right) / 2.0;
    let [lowest, highest] = [0, field.levels().len() - 2].map(|band| field.colour(band));
    let ends = [(bar.bottom, frame.bottom, lowest), (bar.top, frame.top, highest)];
    for (base, tip, colour) in ends.into_iter().filter(|(base, tip, _)| base != tip) {
        let corners = [(bar.left, base), (middle, tip), (bar.right, base)];
        scene.push(Shape::filled(Path::polyline(corners, true), colour));
    }
    let outline = outline(bar, middle, frame);
    scene.push(Shape::stroked(outline, Stroke::solid(INK, 0.6)));
    for tick in numbers(field, &stretch, bar.height())? {
        let Some(label) = tick.label else { continue };
        let y = place(tick.value);
        let mark = Path::polyline([(bar.right, y), (bar.right + 3.0, y)], false);
        scene.push(Shape::stroked(mark, Stroke::solid(INK, THIN)));
        let x = bar.right + TICK_GAP - label.extent.left;
        scene.write(&label, (x, y + half_digit(SMALL)), INK);
    }
    if !field.label.is_empty() {
        let label = typeset(&field.label, TEXT, Align::Left)?;
        scene.write(&label, (bar.left, frame.top - ABOVE - label.extent.bottom), INK);
    }
    Ok(())
}

/// Returns the outline of the bar with its tips.
fn outline(bar: Extent, middle: f64, frame: Extent) -> Path {
    if bar.top == frame.top && bar.bottom == frame.bottom {
        return Path::rectangle(bar);
    }
    let corners = [
        (bar.left, bar.top),
        (middle, frame.top),
        (bar.right, bar.top),
        (bar.right, bar.bottom),
        (middle, frame.bottom),
        (bar.left, bar.bottom),
    ];
    // Where there is no tip, its corner lies on the side of the bar.
    Path::polyline(corners, true)
}

/// Returns the height of all tips together, in px.
fn tips(field: &Field) -> f64 {
    TIP * field.open.into_iter().filter(|open| *open).count() as f64
}

fn numbers(field: &Field, stretch: &Stretch, length: f64) -> Result<Vec<Tick>, DrawingError> {
    if field.numbers_are_levels {
        ticks_at(field.levels(), stretch, length, Direction::Vertical)
    } else {
        ticks(stretch, length, Direction::Vertical)
    }
}

fn values(field: &Field) -> Result<Stretch, DrawingError> {
    let levels = field.levels();
    Stretch::new(field.scale, levels[0], levels[levels.len() - 1])
}

#[cfg(test)]
mod tests {
    use super::{Extent, Field, Scene, draw, space};

    #[test]
    fn open_ends_have_tips_and_numbers_are_levels() {
        let levels = vec![0.0, 2.0, 4.0, 6.0];
        let field = Field::sample((0.0, 9.0), (0.0, 1.0), levels, |x, _| x).expect("finite");
        let field = field.numbered_at_levels().open_ended(false, true);
        let frame = Extent { left: 0.0, top: 20.0, right: 100.0, bottom: 320.0 };
        let (width, _) = space(&field, frame.height()).expect("digits");
        let mut scene = Scene::new(100.0 + width, 330.0, "test");
        draw(&mut scene, &field, frame).expect("digits");
        let labels: Vec<_> = scene.shapes().iter().filter_map(|s| s.label.clone()).collect();
        let texts: Vec<_> = labels.iter().map(|label| label.0.as_str()).collect();
        assert_eq!(texts, ["0", "2", "4", "6"]);
        // The highest number is at the base of the tip, a tip below the top of the frame.
        let middle = (labels[3].1.top + labels[3].1.bottom) / 2.0;
        // Digits have slightly different heights: a quarter of a px.
        assert!((middle - 31.0).abs() <= 0.25, "{middle}");
    }

    #[test]
    fn the_bar_darkens_upwards_beside_the_frame() {
        let levels: Vec<f64> = (0..=4).map(f64::from).collect();
        let field = Field::sample((0.0, 4.0), (0.0, 1.0), levels, |x, _| x).expect("finite");
        let field = field.labelled("$H$");
        let frame = Extent { left: 0.0, top: 50.0, right: 100.0, bottom: 150.0 };
        let (width, height) = space(&field, frame.height()).expect("digits");
        let mut scene = Scene::new(100.0 + width, 160.0, "test");
        draw(&mut scene, &field, frame).expect("digits");
        let colour_at = |y: f64| {
            let covers = |e: Extent| e.left > frame.right && e.top <= y && y <= e.bottom;
            let bands = scene.shapes().iter().filter(|shape| shape.label.is_none());
            let found = bands.filter(|shape| shape.path.extent().is_some_and(covers));
            found.filter_map(|shape| shape.fill).next_back().expect("a band").colour
        };
        assert_eq!(colour_at(frame.bottom - 1.0), field.colour(0));
        assert_eq!(colour_at(frame.top + 1.0), field.colour(3));
        assert_eq!(scene.check_labels(), Ok(()));
        let label = scene.shapes().iter().find_map(|s| s.label.as_ref().filter(|l| l.0 == "H"));
        assert!(label.is_some_and(|(_, place)| place.top >= frame.top - height - 0.01));
    }
}
