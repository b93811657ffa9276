//! Extreme numbers give a picture or an error, never a panic.

use proptest::prelude::*;
use tautline::{
    ANY, AffineSubspace, AxisBox, Ball, FiniteSet, HalfSpace, Point, Segment, Shape, Sphere,
};
use tautline_chance::config;
use tautline_picture::{
    pdf,
    portrait::{Field, Portrait, PortraitError},
    svg,
};

use crate::shapes::{ball, half_space, point};

/// A number that is small or large, or a common special case.
fn number() -> impl Strategy<Value = f64> {
    prop_oneof![
        4 => (-1.0..1.0_f64, -10..10_i32).prop_map(|(digits, e)| digits * 10.0_f64.powi(e)),
        2 => -3.0..3.0_f64,
        1 => prop::sample::select(vec![0.0, 1.0, 1e9, 1e9 + 1.0, -1e-9, 1e-300, 1e300, -1e308]),
    ]
}

fn vector(dimension: usize) -> impl Strategy<Value = Vec<f64>> {
    // Sometimes all coordinates have the same size.
    let alike = (prop::collection::vec(-1.0..1.0_f64, dimension), -10..10_i32)
        .prop_map(|(v, e)| v.into_iter().map(|x| x * 10.0_f64.powi(e)).collect());
    prop_oneof![prop::collection::vec(number(), dimension), alike]
}

fn shape(dimension: usize) -> impl Strategy<Value = Shape<ANY>> {
    let v = move || vector(dimension);
    let size = || number().prop_map(f64::abs);
    let shape = prop_oneof![
        v().prop_map(|x| Point::from_slice(&x).map(Shape::Point)),
        prop::collection::vec(v(), 1..4)
            .prop_map(|points| FiniteSet::from_slices(points).map(Shape::FiniteSet)),
        (v(), size()).prop_map(|(centre, r)| Ball::from_slice(&centre, r).map(Shape::Ball)),
        (v(), size()).prop_map(|(centre, r)| Sphere::from_slice(&centre, r).map(Shape::Sphere)),
        (v(), v()).prop_map(|(a, b)| {
            let corner = |of: fn(f64, f64) -> f64| -> Vec<f64> {
                a.iter().zip(&b).map(|(&a, &b)| of(a, b)).collect()
            };
            AxisBox::from_slices(&corner(f64::min), &corner(f64::max)).map(Shape::AxisBox)
        }),
        (v(), number())
            .prop_map(|(normal, b)| HalfSpace::from_slice(&normal, b).map(Shape::HalfSpace)),
        (v(), v()).prop_map(|(a, b)| Segment::from_slices(&a, &b).map(Shape::Segment)),
        (v(), prop::collection::vec(v(), 0..3)).prop_map(|(base, directions)| {
            AffineSubspace::from_slices(&base, directions).map(Shape::AffineSubspace)
        }),
    ];
    // A normal or a direction may be 0, directions may be dependent.
    shape.prop_filter_map("a set", Result::ok)
}

type Case = (usize, Vec<Vec<f64>>, Vec<Vec<Vec<f64>>>, [Vec<Shape<ANY>>; 2], u8, Field);

fn case() -> impl Strategy<Value = Case> {
    (1..=12_usize).prop_flat_map(|dimension| {
        let curve = || prop::collection::vec(vector(dimension), 0..5);
        let shapes = || prop::collection::vec(shape(dimension), 0..3);
        let field = prop::sample::select(vec![Field::Plain, Field::Determinant, Field::Ellipses]);
        let ends = [shapes(), shapes()];
        (Just(dimension), curve(), prop::collection::vec(curve(), 0..3), ends, 0..5_u8, field)
    })
}

/// Metrics from harmless to bad.
fn gram(kind: u8, x: &[f64]) -> Option<Vec<f64>> {
    let square: f64 = x.iter().map(|x| x * x).sum();
    let phi = match kind {
        0 => 1.0,
        1 => 1.0 + square,
        2 => (-square).exp(),
        3 => x[0],
        _ => return (x[0] > 0.0).then(|| vec![1.0 / x[0]; x.len() * x.len()]),
    };
    let n = x.len();
    Some((0..n * n).map(|k| if k % (n + 1) == 0 { phi } else { 0.0 }).collect())
}

proptest! {
    #![proptest_config(config(0x9d2c_5681, 150))]

    #[test]
    fn every_portrait_is_drawn_or_refused((dimension, curve, others, ends, kind, field) in case()) {
        let gram = |x: &[f64]| gram(kind, x);
        let portrait = Portrait {
            ends: [&ends[0], &ends[1]],
            curve: &curve,
            others: &others,
            field,
            ..Portrait::new(dimension, &gram)
        };
        match portrait.draw() {
            Ok(scene) => {
                prop_assert_eq!(scene.check_labels(), Ok(()));
                prop_assert!(scene.height > 100.0 && scene.height < 1000.0);
                let text = String::from_utf8(svg(&scene)).expect("UTF-8");
                prop_assert!(!text.contains("NaN") && !text.contains("inf"));
                prop_assert!(!pdf(&scene).is_empty());
            }
            // A label that does not fit would be a defect of the layout, not of the data.
            Err(PortraitError::Drawing(error)) => prop_assert!(false, "{error}"),
            Err(error) => prop_assert!(!error.to_string().is_empty()),
        }
    }
}

#[test]
fn huge_and_tiny_problems_look_alike() {
    let gram = |_: &[f64]| None;
    let drawn = |scale: f64| {
        let ball = [ball(&[0.0, 0.0], 0.5 * scale)];
        let wall = [half_space(&[-1.0, 0.0], -3.0 * scale)];
        let curve = [vec![0.5 * scale, 0.0], vec![3.0 * scale, 0.0]];
        let portrait = Portrait {
            ends: [&ball, &wall],
            curve: &curve,
            field: Field::Plain,
            ..Portrait::new(2, &gram)
        };
        let scene = portrait.draw().expect("a picture");
        let solution = scene
            .shapes()
            .iter()
            .rev()
            .find(|shape| shape.stroke.as_ref().is_some_and(|stroke| stroke.width == 2.6));
        solution.expect("a curve").path.extent().expect("points").width()
    };
    // Frames differ a little in width, as the numbers on the axes do.
    for scale in [1e-9, 1e-3, 1e4, 1e9] {
        assert!((drawn(scale) / drawn(1.0) - 1.0).abs() <= 0.1, "{scale}");
    }
}

#[test]
fn touching_ends_leave_a_point() {
    let gram = |_: &[f64]| Some(vec![1.0, 0.0, 0.0, 1.0]);
    for at in [0.0, 1e-9, 1.0, 1e9] {
        let curve = [vec![at, at], vec![at, at]];
        let ends = [point(&[at, at])];
        for field in [Field::Plain, Field::Determinant, Field::Ellipses] {
            let portrait = Portrait {
                ends: [&ends, &ends],
                curve: &curve[..1],
                field,
                ..Portrait::new(2, &gram)
            };
            assert!(portrait.draw().is_ok(), "{at} {field:?}");
            assert!(Portrait { curve: &curve, ..portrait }.draw().is_ok(), "{at} {field:?}");
        }
    }
}
