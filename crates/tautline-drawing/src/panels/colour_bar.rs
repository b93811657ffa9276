//! The colour scale of a heat-map, to its right.

use crate::{
    axes::{Direction, Scale, Stretch, ticks},
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

/// Returns the space that the bar needs to the right of the frame and above it, in px.
pub(crate) fn space(field: &Field, height: f64) -> Result<(f64, f64), DrawingError> {
    let stretch = values(field)?;
    let numbers = ticks(&stretch, height, Direction::Vertical)?;
    let widths = numbers.iter().filter_map(|tick| Some(tick.label.as_ref()?.extent.width()));
    let label = typeset(&field.label, TEXT, Align::Left)?.extent;
    let right = (BAR + TICK_GAP + widths.fold(0.0, f64::max)).max(label.width());
    Ok((GAP + right, if label.width() > 0.0 { label.height() + ABOVE } else { 0.0 }))
}

/// Draws the bar to the right of `frame`.
pub(crate) fn draw(scene: &mut Scene, field: &Field, frame: Extent) -> Result<(), DrawingError> {
    let stretch = values(field)?;
    let left = frame.right + GAP;
    let bar = Extent { left, right: left + BAR, ..frame };
    let place = |value: f64| stretch.place(value, (bar.bottom, bar.top));
    for (k, level) in field.levels().iter().enumerate().take(field.levels().len() - 1) {
        // The band extends up to the top, under the bands drawn later, so that no gap opens between
        // them.
        let band = Extent { bottom: place(*level), ..bar };
        scene.push(Shape::filled(Path::rectangle(band), field.colour(k)));
    }
    scene.push(Shape::stroked(Path::rectangle(bar), Stroke::solid(INK, 0.6)));
    for tick in ticks(&stretch, bar.height(), Direction::Vertical)? {
        let Some(label) = tick.label else { continue };
        let y = place(tick.value);
        let mark = Path::polyline([(bar.right, y), (bar.right + 3.0, y)], false);
        scene.push(Shape::stroked(mark, Stroke::solid(INK, THIN)));
        let x = bar.right + TICK_GAP - label.extent.left;
        scene.write(&label, (x, y + half_digit(SMALL)), INK);
    }
    if !field.label.is_empty() {
        let label = typeset(&field.label, TEXT, Align::Left)?;
        scene.write(&label, (bar.left, bar.top - ABOVE - label.extent.bottom), INK);
    }
    Ok(())
}

fn values(field: &Field) -> Result<Stretch, DrawingError> {
    let levels = field.levels();
    Stretch::new(Scale::Linear, levels[0], levels[levels.len() - 1])
}

#[cfg(test)]
mod tests {
    use super::{Extent, Field, Scene, draw, space};

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
