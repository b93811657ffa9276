//! Sets and curves are where the axes say.

use tautline::Shape;
use tautline_picture::{
    Extent, Scene,
    palette::{GREEN, INK, PURPLE, VERMILLION},
    portrait::{Field, Portrait},
};

use crate::reading::{ROUNDING, Reading, assert_same_box, labels};
use crate::shapes::{axis_box, ball, half_space, line, point, points, segment, sphere};

const WINDOW: [[f64; 2]; 2] = [[-1.0, 3.0], [-1.0, 1.0]];

fn nothing(_: &[f64]) -> Option<Vec<f64>> {
    None
}

fn drawn(portrait: Portrait<'_>) -> Scene {
    let portrait = Portrait { window: Some(WINDOW), field: Field::Plain, ..portrait };
    portrait.draw().expect("a picture")
}

#[test]
fn each_bounded_set_has_its_box() {
    let ball = [ball(&[0.0, 0.25], 0.5)];
    let rectangle = [axis_box(&[1.5, -0.5], &[2.0, f64::MAX])];
    let scene = drawn(Portrait { ends: [&ball, &rectangle], ..Portrait::new(2, &nothing) });
    let reading = Reading::new(&scene, WINDOW);
    assert_eq!(reading.areas(GREEN).len(), 1);
    // The polygon of 96 or more corners has corners at the extrema of the circle.
    assert_same_box(
        reading.areas(GREEN)[0],
        reading.place_box([-0.5, 0.5], [-0.25, 0.75]),
        ROUNDING,
    );
    let expected = reading.place_box([1.5, 2.0], [-0.5, 1.0]);
    let found = reading.areas(PURPLE)[0];
    assert!(found.top < reading.frame().top, "the box has no upper side: {found:?}");
    assert_same_box(found, Extent { top: found.top, ..expected }, ROUNDING);
}

#[test]
fn a_half_space_begins_at_its_boundary() {
    // x₁ ≥ 2, whose normal is not of length 1.
    let wall = [half_space(&[-4.0, 0.0], -8.0)];
    let scene = drawn(Portrait { ends: [&[], &wall], ..Portrait::new(2, &nothing) });
    let reading = Reading::new(&scene, WINDOW);
    let area = reading.areas(PURPLE)[0];
    assert!((area.left - reading.place(2.0, 0.0).0).abs() <= ROUNDING, "{area:?}");
    assert!(area.right > reading.frame().right && area.top < reading.frame().top);
}

#[test]
fn a_very_large_ball_is_as_straight_as_it_looks() {
    // The sagitta of a sphere of radius 10⁹ over a window of size 4 is 10⁻⁸ of its length.
    let radius = 1e9;
    let ball = [ball(&[2.0 + radius, 0.0], radius)];
    let sphere = [sphere(&[0.5 - radius, 0.0], radius)];
    let scene = drawn(Portrait { ends: [&ball, &sphere], ..Portrait::new(2, &nothing) });
    let reading = Reading::new(&scene, WINDOW);
    // The radius has a rounding error of 10⁻⁷.
    assert!((reading.areas(GREEN)[0].left - reading.place(2.0, 0.0).0).abs() <= ROUNDING);
    let line = &reading.lines(PURPLE.for_text())[0];
    let x = reading.place(0.5, 0.0).0;
    assert!(line.len() == 2 && line.iter().all(|p| (p.0 - x).abs() <= ROUNDING), "{line:?}");
}

#[test]
fn lines_and_points_are_seen_too() {
    let from = [segment(&[-0.5, -0.5], &[0.5, 0.5]), line(&[9.0, 0.5], &[-3.0, 0.0])];
    // A union of one's own has the same picture as its pieces.
    let to = [Shape::Union(vec![point(&[1.0, 0.0]), points(&[[2.0, 0.5], [2.5, 0.0]])])];
    let scene = drawn(Portrait { ends: [&from, &to], ..Portrait::new(2, &nothing) });
    let reading = Reading::new(&scene, WINDOW);
    let lines = reading.lines(GREEN.for_text());
    for (found, (x, y)) in lines[0].iter().zip([(-0.5, -0.5), (0.5, 0.5)]) {
        let expected = reading.place(x, y);
        assert!((found.0 - expected.0).abs().max((found.1 - expected.1).abs()) <= ROUNDING);
    }
    let level = reading.place(0.0, 0.5).1;
    assert!(lines[1].iter().all(|point| (point.1 - level).abs() <= ROUNDING));
    assert!(lines[1].iter().any(|point| point.0 < reading.frame().left));
    assert_eq!(reading.markers(PURPLE.for_text()).len(), 3);
}

#[test]
fn the_curve_runs_through_its_points() {
    let curve: Vec<Vec<f64>> =
        (0..=20).map(|k| f64::from(k) / 10.0).map(|x| vec![x, 0.5 * x.sin()]).collect();
    let other = [vec![vec![0.0, 0.0], vec![1.0, -0.8], vec![2.0, 0.5]]];
    let scene = drawn(Portrait { curve: &curve, others: &other, ..Portrait::new(2, &nothing) });
    let reading = Reading::new(&scene, WINDOW);
    let line = &reading.lines(VERMILLION)[0];
    assert_eq!(line.len(), curve.len());
    for (found, point) in line.iter().zip(&curve) {
        let expected = reading.place(point[0], point[1]);
        assert!((found.0 - expected.0).abs().max((found.1 - expected.1).abs()) <= ROUNDING);
    }
    let ends = [&curve[0], &curve[20]].map(|point| reading.place(point[0], point[1]));
    for (found, expected) in reading.ends().into_iter().zip(ends) {
        assert!((found.0 - expected.0).hypot(found.1 - expected.1) <= 2.0 * ROUNDING);
    }
    assert_eq!(reading.lines(INK).len(), 1);
    let names = labels(&scene);
    let at = |name: &str| names.iter().position(|label| label == name);
    assert!(at("shortest found") < at("other local minimum"), "{names:?}");
}

#[test]
fn both_directions_have_the_same_scale() {
    let scene = drawn(Portrait::new(2, &nothing));
    let curve = [vec![0.0, 0.0], vec![1.0, 0.0]];
    let chosen = Portrait { curve: &curve, field: Field::Plain, ..Portrait::new(2, &nothing) };
    for scene in [scene, chosen.draw().expect("a picture")] {
        // The frame is the only unfilled rectangle with a stroke of 0.9 px.
        let frames = scene.shapes().iter().filter(|shape| {
            shape.fill.is_none() && shape.stroke.as_ref().is_some_and(|s| s.width == 0.9)
        });
        let boxes: Vec<_> = frames.filter_map(|shape| shape.path.extent()).collect();
        assert_eq!(boxes.len(), 1);
        let ratio = boxes[0].height() / boxes[0].width();
        assert!((0.4..=1.2).contains(&ratio), "{ratio}");
    }
    let ball = [ball(&[1.0, 0.0], 0.7)];
    let scene = drawn(Portrait { ends: [&ball, &[]], ..Portrait::new(2, &nothing) });
    let area = Reading::new(&scene, WINDOW).areas(GREEN)[0];
    assert!((area.width() - area.height()).abs() <= 2.0 * ROUNDING, "{area:?}");
}

#[test]
fn the_coordinates_with_the_largest_extents_are_drawn() {
    let curve = [vec![0.0, 0.0, 0.0, 0.0], vec![0.1, 3.0, 0.2, -5.0]];
    let portrait = Portrait { curve: &curve, ..Portrait::new(4, &nothing) };
    assert_eq!(portrait.drawn_coordinates(), Ok([1, 3]));
    let names = labels(&portrait.draw().expect("a picture"));
    assert!(names.contains(&"x_2".to_owned()) && names.contains(&"x_4".to_owned()), "{names:?}");
    let swapped = Portrait { coordinates: Some([3, 0]), ..portrait };
    assert_eq!(swapped.drawn_coordinates(), Ok([3, 0]));
    assert!(labels(&swapped.draw().expect("a picture")).contains(&"x_1".to_owned()));
}

#[test]
fn sets_in_space_are_projected_or_named() {
    let from = [ball(&[0.0, 7.0, 0.5], 0.25)];
    let to = [half_space(&[-1.0, 0.0, 0.0], -2.0), half_space(&[-1.0, -1.0, 0.0], -2.0)];
    let scene = drawn(Portrait {
        ends: [&from, &to],
        coordinates: Some([0, 2]),
        ..Portrait::new(3, &nothing)
    });
    let reading = Reading::new(&scene, WINDOW);
    let disc = reading.place_box([-0.25, 0.25], [0.25, 0.75]);
    assert_same_box(reading.areas(GREEN)[0], disc, ROUNDING);
    assert_eq!(reading.areas(PURPLE).len(), 1);
    let text = labels(&scene).join(" ");
    assert!(text.contains("half-space, whose projection is the whole plane"), "{text}");
}

#[test]
fn on_the_line_time_runs_to_the_right() {
    let from = [ball(&[0.0], 0.25)];
    let to = [half_space(&[-2.0], -4.0)];
    let curve = [vec![0.25], vec![1.0], vec![2.0]];
    let scene = drawn(Portrait { ends: [&from, &to], curve: &curve, ..Portrait::new(1, &nothing) });
    let reading = Reading::new(&scene, [[-0.06, 1.06], WINDOW[0]]);
    let line = &reading.lines(VERMILLION)[0];
    for (found, (t, x)) in line.iter().zip([(0.0, 0.25), (0.5, 1.0), (1.0, 2.0)]) {
        let expected = reading.place(t, x);
        assert!((found.0 - expected.0).hypot(found.1 - expected.1) <= 2.0 * ROUNDING);
    }
    let start = reading.place_box([-0.06, 0.0], [-0.25, 0.25]);
    assert_same_box(reading.areas(GREEN)[0], start, ROUNDING);
    let end = reading.areas(PURPLE)[0];
    assert!((end.bottom - reading.place(1.0, 2.0).1).abs() <= ROUNDING, "{end:?}");
    assert!(labels(&scene).contains(&"time t".to_owned()));
}
