//! Levels, the curve and the hypothesis, where a condition less would prove something false.

use nalgebra::{SVector, vector};
use tautline_check::{Certificate, Chain, CheckError, Cubes, Region, length_above};

use tautline_scalar::Interval;

use crate::helpers::{Function, formula, level, one_level, point, proves_at_most};

const REGION: Region = Region::Declared { c1: 1.0 };

/// A level of the line from 0.5 to 3.5, with the distances from the ends.
fn line() -> Certificate<1> {
    let sets = [point([0.5]), point([3.5])];
    one_level(formula("1 I"), sets, 4.0, REGION, -2, [&|x| x[0] - 0.5, &|x| 3.5 - x[0]])
}

/// A level may have cubes of the side of the level before, but all that this has kept.
#[test]
fn a_level_of_the_same_side_has_the_cubes_that_were_kept() {
    let mut certificate = line();
    let cubes = Cubes::new(-2, vec![[2]]).expect("in range");
    certificate.levels.push(level(1, &cubes, [&|_| 0.0, &|_| 0.0]));
    proves_at_most(&certificate.check(), 3.0);
}

/// Curves shorter than `hi` are kept, even if only shorter ones are asked for.
#[test]
fn fewer_curves_than_those_below_hi_are_never_followed() {
    let Certificate { formula, sets, hi, levels, .. } = line();
    for keep in [2.0, 0.0, f64::NAN] {
        let mut chain = Chain::new(&formula, &sets, hi, REGION).expect("a bound");
        chain.add(&levels[0], keep).expect("the required cubes");
        assert!(!chain.is_closed(), "{keep}");
    }
}

/// All curves shorter than 5/2 leave no cube, but those as long as 2 may leave the cubes themselves.
#[test]
fn no_more_than_hi_is_proved_whatever_is_kept() {
    let sets = [point([0.5]), point([3.5])];
    let region = Region::Declared { c1: 0.25 };
    let functions: [Function<'_, 1>; 2] = [&|x| x[0] - 0.5, &|x| 3.5 - x[0]];
    let Certificate { formula, sets, hi, levels, .. } =
        one_level(formula("1 I"), sets, 2.0, region, -2, functions);
    for keep in [2.0, 2.0_f64.next_up(), 2.5] {
        let mut chain = Chain::new(&formula, &sets, hi, region).expect("a bound");
        chain.add(&levels[0], keep).expect("the required cubes");
        assert!(chain.is_closed(), "{keep}");
        let (lower, proved) = (chain.lower(), chain.proved(None).expect("a level"));
        assert_eq!((lower, proved.lower, proved.levels[0].1), (hi, hi, hi), "{keep}");
    }
}

/// Only a curve that is shorter than `hi` shows that the corridor holds the shortest ones.
#[test]
fn a_curve_as_long_as_hi_is_refused() {
    let sets = [point([0.0]), point([1.0])];
    let curve = vec![vector![0.0], vector![1.0]];
    let hi = length_above(&formula::<1>("1 I"), sets.each_ref(), &curve).expect("a length");
    let functions: [Function<'_, 1>; 2] = [&|x| 0.9 * x[0], &|x| 0.9 - 0.9 * x[0]];
    let mut certificate = one_level(formula("1 I"), sets, hi, REGION, -2, functions);
    certificate.curve = Some(curve);
    assert_eq!(certificate.check(), Err(CheckError::CurveLength { length: hi, hi }));
}

/// `√H = x²`, whose integral the midpoint rule underestimates.
#[test]
fn the_length_of_a_chord_is_bounded_from_above() {
    let h = 0.5_f64.powi(6);
    let points = [vector![1.0], vector![1.0 + h]];
    let ends = points.map(|x| point([x[0]]));
    let length = length_above(&formula::<1>("x1^4 I"), ends.each_ref(), &points);
    let (length, exact) = (length.expect("a length"), h + h * h + h * h * h / 3.0);
    assert!(exact <= length && length < exact * (1.0 + 1e-5), "{length} {exact}");
}

#[test]
fn a_declared_constant_is_printed_as_a_hypothesis() {
    let mut certificate = line();
    for curve in [None, Some(vec![vector![0.5], vector![3.5]])] {
        certificate.curve = curve;
        let proved = certificate.check().expect("proved");
        let text = certificate.verdict(&proved).to_string();
        assert!(text.contains("hypothesis   H >= 1e0 I everywhere"), "{text}");
    }
}

/// Each further chord is less than half a unit in the last place of the sum.
#[test]
fn lengths_of_chords_are_added_upward() {
    let (count, step) = (1 << 12, 2.0_f64.powi(-54));
    let mut points = vec![vector![-1.0]];
    points.extend((0..=count).map(|k| vector![f64::from(k) * step]));
    let exact = 1.0 + f64::from(count) * step;
    for _ in 0..2 {
        let ends = [points[0], points[points.len() - 1]].map(|x| point([x[0]]));
        let length = length_above(&formula::<1>("1 I"), ends.each_ref(), &points);
        assert!(length.as_ref().is_ok_and(|&length| length >= exact), "{length:?} {exact}");
        points.reverse();
    }
}

/// The distance from the centre of a ball rounds to its radius from both sides.
#[test]
fn an_end_lies_in_its_set_or_it_does_not() {
    use tautline_sets::{Ball, HalfSpace, Shape};
    let to = point([3.0, 4.0]);
    let ends_in = |set: &Shape<2>, x: [f64; 2]| {
        let curve = [SVector::from(x), vector![3.0, 4.0]];
        length_above(&formula::<2>("1 I"), [set, &to], &curve).is_ok()
    };
    let ball = Shape::Ball(Ball::new([0.1, 0.2], 0.3).expect("finite"));
    // 0.1 + 0.3 as doubles, and its neighbours: |x − c| is 0.3 only up to rounding.
    let within = |x: f64| Interval::point(x) - 0.1;
    let mut x = 0.1 + 0.3;
    assert!(within(x).contains(0.3));
    while within(x).hi() > 0.3 {
        x = x.next_down();
    }
    assert!(ends_in(&ball, [x, 0.2]));
    while within(x).lo() <= 0.3 {
        x = x.next_up();
    }
    assert!(!ends_in(&ball, [x, 0.2]));
    let ball = Shape::Ball(Ball::new([0.0, 0.0], 0.1).expect("finite"));
    assert!(ends_in(&ball, [0.1, 0.0]) && !ends_in(&ball, [0.1_f64.next_up(), 0.0]));
    assert!(!ends_in(&ball, [0.1, 1e-300]) && ends_in(&ball, [0.1_f64.next_down(), 1e-300]));
    // 3 · 0.1 > 0.3, and 0.1 + 0.2 > 0.3, in exact numbers.
    let wall = Shape::HalfSpace(HalfSpace::new([3.0, 0.0], 0.3).expect("a normal"));
    assert!(!ends_in(&wall, [0.1, 0.0]) && ends_in(&wall, [0.1_f64.next_down(), 0.0]));
    let wall = Shape::HalfSpace(HalfSpace::new([1.0, 1.0], 0.3).expect("a normal"));
    assert!(!ends_in(&wall, [0.1, 0.2]) && ends_in(&wall, [0.1, 0.2_f64.next_down()]));
}

/// A chord is one also if some coordinates of its ends are equal.
#[test]
fn chords_along_all_axes_have_their_lengths() {
    let mut points = vec![SVector::<f64, 3>::zeros()];
    for axis in [0, 1, 2, 1, 0, 2] {
        let mut next = points[points.len() - 1];
        points.push(next);
        next[axis] += 0.5;
        points.push(next);
    }
    let ends = [points[0], points[points.len() - 1]].map(|x| point(x.into()));
    // Two chords of half a unit along each axis have the lengths 2, 4 and 8.
    let metric = formula::<3>("[4, 1, 0; 1, 16, 0; 0, 0, 64]");
    let length = length_above(&metric, ends.each_ref(), &points).expect("a metric");
    assert!((14.0..14.0 + 1e-13).contains(&length), "{length}");
}

/// Under `H = h I` the square of the length of a chord between points with integer coordinates is an
/// integer.
#[test]
fn the_length_of_a_chord_is_not_below_its_root() {
    for (a, b, h) in (0..12).flat_map(|a| (1..12).flat_map(move |b| [1, 2, 7].map(|h| (a, b, h)))) {
        let points = [vector![0.0, 0.0], vector![f64::from(a), f64::from(b)]];
        let ends = points.map(|x| point(x.into()));
        let metric = formula::<2>(&format!("{h} I"));
        let length = length_above(&metric, ends.each_ref(), &points).expect("a metric");
        let square = f64::from(h * (a * a + b * b));
        // A fused operation is rounded once, which keeps its sign.
        assert!(length.mul_add(length, -square) >= 0.0, "{a} {b} {h}: {length}");
        assert!(length * length <= square * (1.0 + 1e-14), "{a} {b} {h}: {length}");
    }
}
