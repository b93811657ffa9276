//! The metric is shown as it is.

use tautline_picture::{
    Ramp, Scene, Shape as Drawn,
    portrait::{Field, Portrait},
    svg,
};

use crate::reading::{ROUNDING, labels};

const WINDOW: Option<[[f64; 2]; 2]> = Some([[-1.0, 3.0], [-1.0, 1.0]]);

/// Returns the filled areas inside the frame, without white ones.
fn bands(scene: &Scene) -> Vec<&Drawn> {
    let coloured = |shape: &&Drawn| {
        let fill = shape.fill.map(|fill| fill.colour.rgb);
        shape.clip.is_some() && fill.is_some_and(|rgb| rgb != [255; 3])
    };
    scene.shapes().iter().filter(coloured).collect()
}

fn scalar(phi: f64) -> Option<Vec<f64>> {
    Some(vec![phi, 0.0, 0.0, phi])
}

#[test]
fn ellipses_have_the_axes_of_the_matrix() {
    // vᵀ H v = 4 v₁² + v₂² is constant on ellipses that are twice as tall as wide.
    let gram = |_: &[f64]| Some(vec![4.0, 0.0, 0.0, 1.0]);
    let portrait = Portrait { field: Field::Ellipses, window: WINDOW, ..Portrait::new(2, &gram) };
    let scene = portrait.draw().expect("a picture");
    let fill = Ramp::blue().at(0.3);
    let drawn = |shape: &&Drawn| shape.fill.is_some_and(|paint| paint.colour == fill);
    let ellipses: Vec<_> =
        scene.shapes().iter().filter(drawn).filter_map(|shape| shape.path.extent()).collect();
    assert_eq!(ellipses.len(), 50);
    for (k, ellipse) in ellipses.iter().enumerate() {
        assert!((ellipse.height() - 2.0 * ellipse.width()).abs() <= 0.05, "{ellipse:?}");
        assert!(ellipses[..k].iter().all(|other| !ellipse.overlaps(other)), "{ellipse:?}");
    }
    // c is such that the frame is 4 wide: the taller half-axis is √c.
    let text = labels(&scene).join(" ");
    let c: f64 = text
        .split('=')
        .nth(1)
        .and_then(|c| c.split(". ").next()?.parse().ok())
        .unwrap_or_else(|| panic!("no constant in {text}"));
    let frame = scene.shapes().iter().find_map(|shape| shape.clip).expect("a frame");
    let height = 2.0 * c.sqrt() / 4.0 * frame.width();
    assert!((ellipses[0].height() - height).abs() <= 0.05, "{} and {height}", ellipses[0].height());
}

#[test]
fn contours_of_the_determinant_are_where_it_has_its_levels() {
    // det H = (1 + x₁)² increases from 1 to 9 over 0 ≤ x₁ ≤ 2, in steps of 1.
    let gram = |x: &[f64]| scalar(1.0 + x[0]);
    let window = Some([[0.0, 2.0], [0.0, 1.0]]);
    let scene = Portrait { window, ..Portrait::new(2, &gram) }.draw().expect("a picture");
    let bands = bands(&scene);
    let frame = bands[0].clip.expect("a frame");
    // The lowest band is the ground, without a clip. The others begin where det H = 2, 3, …, 8 and
    // go to the right.
    let lefts: Vec<f64> = bands.iter().filter_map(|band| Some(band.path.extent()?.left)).collect();
    assert_eq!(lefts.len(), 7);
    for (left, level) in lefts.iter().zip(2..) {
        let expected = frame.left + (f64::from(level).sqrt() - 1.0) / 2.0 * frame.width();
        // Across a cell of a sixtieth, linear interpolation of a square is off by 1/14400 at most,
        // and the slope is at least 2: that is 0.01 px.
        assert!((left - expected).abs() <= 0.01 + ROUNDING, "{level}: {left}, not {expected}");
    }
    let names = labels(&scene);
    assert!(names.contains(&"det H".to_owned()) && names.contains(&"8".to_owned()), "{names:?}");
}

#[test]
fn a_constant_has_no_bar_and_is_written_out() {
    let gram = |_: &[f64]| scalar(1.5);
    let scene = Portrait { window: WINDOW, ..Portrait::new(2, &gram) }.draw().expect("a picture");
    let text = labels(&scene).join("|");
    assert!(text.contains("det H=2.25 everywhere.") && !text.contains("det H|"), "{text}");
    assert!(bands(&scene).is_empty());
}

#[test]
fn where_there_is_no_metric_the_picture_is_hatched() {
    let half = |x: &[f64]| if x[1] > 0.0 { scalar(1.0 / x[1]) } else { None };
    let constant = |x: &[f64]| if x[1] > 0.0 { scalar(2.0) } else { None };
    let infinite = |x: &[f64]| scalar(if x[1] > 0.0 { 2.0 } else { f64::INFINITY });
    for gram in [&half as &dyn Fn(&[f64]) -> Option<Vec<f64>>, &constant, &infinite] {
        let portrait = Portrait { window: WINDOW, ..Portrait::new(2, gram) };
        let scene = portrait.draw().expect("a picture");
        let hatched = |shape: &&Drawn| {
            let thin = shape.stroke.as_ref().is_some_and(|stroke| stroke.width == 0.7);
            thin && shape.path.segments().len() > 20
        };
        let hatching = scene.shapes().iter().find(hatched).expect("lines");
        let (frame, lines) = (hatching.clip.expect("a frame"), hatching.path.extent());
        // They cover the lower half, where x₂ ≤ 0, up to a cell.
        let middle = f64::midpoint(frame.top, frame.bottom);
        let top = lines.expect("lines").top;
        assert!((top - middle).abs() <= 3.0, "{top} and {middle}");
        assert!(labels(&scene).join(" ").contains("Hatched: H is not defined."));
    }
    let never = |_: &[f64]| None;
    let scene = Portrait { window: WINDOW, ..Portrait::new(2, &never) }.draw().expect("a picture");
    assert!(labels(&scene).join(" ").contains("not defined in this window"));
}

#[test]
fn in_space_the_metric_is_that_of_the_curve() {
    // The coordinate that is not drawn is 2 on the whole curve, so det H = 8 in the whole picture.
    let gram = |x: &[f64]| {
        let mut matrix = vec![0.0; 9];
        (0..3).for_each(|k| matrix[4 * k] = x[1]);
        Some(matrix)
    };
    let curve = [vec![0.0, 2.0, 0.0], vec![1.0, 2.0, 1.0]];
    let scene = Portrait { curve: &curve, ..Portrait::new(3, &gram) }.draw().expect("a picture");
    let text = labels(&scene).join(" ");
    assert!(text.contains("det H=8 everywhere."), "{text}");
    assert!(text.contains("means over the curve"), "{text}");
}

#[test]
fn two_runs_give_the_same_bytes() {
    let gram = |x: &[f64]| scalar(1.0 + x[0].sin().powi(2) + x[1] * x[1]);
    let curve = [vec![0.0, 0.0], vec![1.0, 0.5], vec![2.0, 0.0]];
    let draw = |field| {
        let portrait = Portrait { curve: &curve, field, ..Portrait::new(2, &gram) };
        svg(&portrait.draw().expect("a picture"))
    };
    assert_eq!(draw(Field::Determinant), draw(Field::Determinant));
    assert_ne!(draw(Field::Determinant), draw(Field::Ellipses));
}
