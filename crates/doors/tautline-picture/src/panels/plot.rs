//! A piece of a panel on the canvas: one stretch of each axis, and the layers that plotters draws.

use std::cell::RefCell;
use std::fmt::Display;

use plotters::coord::cartesian::Cartesian2d;
use plotters::drawing::{DrawingArea, IntoDrawingArea as _};
use plotters::element::{Circle, EmptyElement, PathElement, Polygon};
use plotters::style::{Color as _, RGBAColor, RGBColor, ShapeStyle};

use crate::{
    axes::Stretch,
    colours::{
        Colour,
        palette::{GREY, INK},
    },
    error::DrawingError,
    geometry::{Extent, Path},
    marks::{Curve, Field, Gaps, Marker, Region},
    measures::MARKER,
    picture::{Paint, Recorder, Scene, Shape, Stroke, UNITS, units},
};

/// Coordinates of plotters on a rectangle of the canvas.
pub(crate) struct Plot<'a> {
    pub(crate) scene: &'a RefCell<Scene>,
    pub(crate) x: Stretch,
    pub(crate) y: Stretch,
    /// The left and the right end of the `x` stretch, in px.
    pub(crate) across: (f64, f64),
    /// The lower and the upper end of the `y` stretch, in px. The first is the larger number.
    pub(crate) up: (f64, f64),
    pub(crate) clip: Extent,
}

type Area<'a> = DrawingArea<Recorder<'a>, Cartesian2d<Stretch, Stretch>>;

impl<'a> Plot<'a> {
    /// Returns the position of a data point, in px.
    pub(crate) fn place(&self, (x, y): (f64, f64)) -> (f64, f64) {
        (self.x.place(x, self.across), self.y.place(y, self.up))
    }

    fn area(&self, dash: &[f64]) -> Area<'a> {
        let ends = |(a, b): (f64, f64)| units(a)..units(b);
        let coordinates = Cartesian2d::new(self.x, self.y, (ends(self.across), ends(self.up)));
        Recorder::new(self.scene, Some(self.clip), dash)
            .into_drawing_area()
            .apply_coord_spec(coordinates)
    }

    /// Draws the lines of a curve, run by run.
    pub(crate) fn lines(
        &self,
        curve: &Curve,
        runs: &[Vec<(f64, f64)>],
    ) -> Result<(), DrawingError> {
        if curve.width <= 0.0 {
            return Ok(());
        }
        let area = self.area(&curve.dash);
        let halo = self.area(&[]);
        for run in runs {
            if curve.halo {
                let style = line(Colour::WHITE, 0.9, curve.width + 2.4);
                halo.draw(&PathElement::new(run.clone(), style)).map_err(refused)?;
            }
            let style = line(curve.colour, 1.0, curve.width);
            area.draw(&PathElement::new(run.clone(), style)).map_err(refused)?;
        }
        Ok(())
    }

    /// Draws the markers of a curve.
    pub(crate) fn markers(
        &self,
        curve: &Curve,
        runs: &[Vec<(f64, f64)>],
    ) -> Result<(), DrawingError> {
        let Some(marker) = curve.marker else { return Ok(()) };
        let area = self.area(&[]);
        for &point in runs.iter().flatten() {
            if !(self.x.holds(point.0) && self.y.holds(point.1)) {
                continue;
            }
            if curve.halo {
                draw_marker(&area, marker, point, Colour::WHITE, 1.4)?;
            }
            draw_marker(&area, marker, point, curve.colour, 0.0)?;
            if marker == Marker::Ring {
                let inner = (MARKER - 1.5) * UNITS;
                let white = fill(Colour::WHITE);
                area.draw(&Circle::new(point, inner.round() as i32, white)).map_err(refused)?;
            }
        }
        Ok(())
    }

    /// Fills the bands of a heat-map and draws its contour lines.
    pub(crate) fn field(&self, field: &Field) -> Result<(), DrawingError> {
        let ground = Shape::filled(Path::rectangle(self.clip), field.colour(0));
        self.scene.borrow_mut().push(ground);
        let levels = field.levels();
        // Each region is painted over the lower ones, so that no gap opens between bands.
        for (k, level) in levels.iter().enumerate().take(levels.len() - 1).skip(1) {
            let mut region = Path::default();
            for ring in field.rings(*level)? {
                region.append(&Path::polyline(ring.into_iter().map(|p| self.place(p)), true));
            }
            let mut shape = Shape::filled(region, field.colour(k));
            shape.clip = Some(self.clip);
            self.scene.borrow_mut().push(shape);
        }
        if field.line_every > 0 {
            let area = self.area(&[]);
            for level in levels.iter().step_by(field.line_every) {
                for ring in field.rings(*level)? {
                    let style = line(INK, 0.4, 0.6);
                    area.draw(&PathElement::new(ring, style)).map_err(refused)?;
                }
            }
        }
        match &field.gaps {
            Some(gaps) => self.gaps(gaps),
            None => Ok(()),
        }
    }

    /// Paints what has no value white, and hatches it.
    fn gaps(&self, gaps: &Gaps) -> Result<(), DrawingError> {
        self.push(self.outline(gaps.rings()?), Some(Colour::WHITE.into()), None);
        let mut lines = Path::default();
        for ends in gaps.hatching() {
            lines.append(&Path::polyline(ends.map(|end| self.place(end)), false));
        }
        let mut stroke = Stroke::solid(GREY, 0.7);
        stroke.paint.opacity = 0.6;
        self.push(lines, None, Some(stroke));
        Ok(())
    }

    /// Draws an area with its outline.
    pub(crate) fn region(&self, region: &Region) {
        let path = self.outline(region.rings.clone());
        if region.halo {
            let rim = region.outline.clone().map(|stroke| {
                let width = stroke.width + 2.4;
                Stroke { paint: Paint { colour: Colour::WHITE, opacity: 0.9 }, width, ..stroke }
            });
            self.push(path.clone(), None, rim);
        }
        self.push(path, region.fill, region.outline.clone());
    }

    /// Returns closed rings of data points as a path.
    fn outline(&self, rings: Vec<Vec<(f64, f64)>>) -> Path {
        let mut path = Path::default();
        for ring in rings {
            path.append(&Path::polyline(ring.into_iter().map(|p| self.place(p)), true));
        }
        path
    }

    fn push(&self, path: Path, fill: Option<Paint>, stroke: Option<Stroke>) {
        if !path.segments().is_empty() {
            let shape = Shape { path, fill, stroke, clip: Some(self.clip), label: None };
            self.scene.borrow_mut().push(shape);
        }
    }
}

/// Draws one marker, enlarged by `rim` px on all sides.
fn draw_marker(
    area: &Area<'_>,
    marker: Marker,
    point: (f64, f64),
    colour: Colour,
    rim: f64,
) -> Result<(), DrawingError> {
    match marker.corners() {
        None => {
            let radius = ((MARKER + rim) * UNITS).round() as i32;
            area.draw(&Circle::new(point, radius, fill(colour))).map_err(refused)
        }
        Some(corners) => {
            let corners: Vec<(i32, i32)> =
                corners.into_iter().map(|(x, y)| (units(x), units(y))).collect();
            let mut outline = corners.clone();
            outline.extend(corners.first());
            outline.extend(corners.get(1));
            if rim > 0.0 {
                // The last side is drawn twice, so that the path ends in a join.
                let edge = line(colour, 1.0, 2.0 * rim);
                let path = EmptyElement::at(point) + PathElement::new(outline, edge);
                area.draw(&path).map_err(refused)?;
            }
            let inside = EmptyElement::at(point) + Polygon::new(corners, fill(colour));
            area.draw(&inside).map_err(refused)
        }
    }
}

fn line(colour: Colour, opacity: f64, width: f64) -> ShapeStyle {
    ShapeStyle {
        color: rgba(colour, opacity),
        filled: false,
        // Widths are a few px, so the cast cannot overflow.
        stroke_width: (width * UNITS).round() as u32,
    }
}

fn fill(colour: Colour) -> ShapeStyle {
    rgba(colour, 1.0).filled()
}

fn rgba(colour: Colour, opacity: f64) -> RGBAColor {
    let [red, green, blue] = colour.rgb;
    RGBColor(red, green, blue).mix(opacity)
}

/// Turns an error of plotters into ours.
fn refused(error: impl Display) -> DrawingError {
    DrawingError::Backend(error.to_string())
}

#[cfg(test)]
mod tests {
    use super::{Colour, Curve, Extent, Field, Plot, RefCell, Region, Scene, Shape};
    use crate::{
        axes::{Axis, Scale},
        colours::palette::BLUE,
        marks::{Marker, Samples},
    };

    #[test]
    fn layers_stay_inside_the_frame() {
        let scene = RefCell::new(Scene::new(120.0, 120.0, "test"));
        let clip = Extent { left: 10.0, top: 10.0, right: 110.0, bottom: 110.0 };
        let unit = Axis::new(Scale::Linear, 0.0, 1.0).expect("a range");
        let stretch = unit.stretches[0];
        let (across, up) = ((10.0, 110.0), (110.0, 10.0));
        let plot = Plot { scene: &scene, x: stretch, y: stretch, across, up, clip };
        let levels = vec![0.0, 0.5, 1.0, 1.5];
        let field = Field::sample((0.0, 1.0), (0.0, 1.0), levels, |x, y| x + y).expect("finite");
        plot.field(&field.lined_every(1)).expect("contours");
        let curve = Curve::new([(-1.0, -1.0), (0.5, 0.5), (9.0, 9.0)], BLUE).marked(Marker::Disc);
        let runs = curve.runs(&unit, &unit);
        plot.lines(&curve, &runs).expect("recorded");
        plot.markers(&curve, &runs).expect("recorded");
        let scene = scene.borrow();
        for shape in &scene.shapes()[1..] {
            let inside = shape.path.extent().is_some_and(|extent| clip.contains(&extent));
            assert!(shape.clip == Some(clip) || inside, "{shape:?}");
        }
        // Of the three points, only the one inside the plot has a marker.
        let markers = scene.shapes().iter().filter(|s| s.fill.is_some_and(|f| f.colour == BLUE));
        assert_eq!(markers.count(), 1);
        assert_eq!(plot.place((0.5, 0.25)), (60.0, 85.0));
    }

    #[test]
    fn an_area_has_its_rim_under_its_outline_and_a_gap_is_white() {
        let scene = RefCell::new(Scene::new(120.0, 120.0, "test"));
        let clip = Extent { left: 10.0, top: 10.0, right: 110.0, bottom: 110.0 };
        let stretch = Axis::new(Scale::Linear, 0.0, 1.0).expect("a range").stretches[0];
        let plot = Plot {
            scene: &scene,
            x: stretch,
            y: stretch,
            across: (10.0, 110.0),
            up: (110.0, 10.0),
            clip,
        };
        let square = vec![(0.0, 0.0), (0.5, 0.0), (0.5, 0.5), (0.0, 0.5)];
        plot.region(&Region::new(vec![square]).filled(BLUE, 0.3).outlined(BLUE, 1.5).over_field());
        let unit = (0.0, 1.0);
        let half = |x: f64, _: f64| (x > 0.5).then_some(x);
        let samples = Samples::on(unit, unit, 40, half).expect("a rectangle");
        let field = Field::of_samples(samples, Scale::Linear, vec![0.0, 1.0]).expect("increasing");
        plot.field(&field).expect("contours");
        let scene = scene.borrow();
        let [rim, area, _ground, white, lines] = &scene.shapes()[1..] else {
            panic!("{:?}", scene.shapes())
        };
        let width = |shape: &Shape| shape.stroke.as_ref().map(|stroke| stroke.width);
        assert!(rim.fill.is_none() && width(rim) > width(area));
        let expected = Extent { left: 10.0, top: 60.0, right: 60.0, bottom: 110.0 };
        assert_eq!(area.path.extent(), Some(expected));
        // The gap is found to half a third of a cell, that is 0.4 px.
        let right = white.path.extent().expect("a gap").right;
        assert!((right - 60.0).abs() <= 0.5 && white.fill == Some(Colour::WHITE.into()), "{right}");
        assert!(lines.path.segments().len() > 10);
    }
}
