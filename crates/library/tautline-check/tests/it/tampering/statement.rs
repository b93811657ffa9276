//! Changed statements: the region, `hi`, the sets and the metric.

use nalgebra::{SVector, vector};
use tautline_check::{Chain, CheckError, Level, Region};
use tautline_formula::Formula;
use tautline_sets::{Ball, FiniteSet, HalfSpace, Shape, Sphere};

use super::BASE;
use crate::{
    helpers::{level, lower, point},
    wave::Wave,
};

/// The declared constant: it is a hypothesis, and is returned as one.
#[test]
fn a_declared_constant_is_returned_as_a_hypothesis() {
    for c1 in [BASE.wave.c1(), 2.0 * BASE.wave.c1()] {
        let mut certificate = BASE.certificate.clone();
        certificate.region = Region::Declared { c1 };
        let proved = certificate.check().expect("the cubes suffice");
        assert_eq!(proved.declared, Some(c1));
        assert!(certificate.statement() != BASE.certificate.statement());
    }
    assert_eq!(BASE.proved.declared, None);
}

/// The tubes: a radius or a constant that is not proved.
#[test]
fn thin_tubes_and_large_constants_are_refused() {
    let Region::Tubes { radius, c1 } = BASE.certificate.region else { panic!("tubes") };
    let check = |radius: f64, c1: f64| {
        let mut certificate = BASE.certificate.clone();
        certificate.region = Region::Tubes { radius, c1 };
        certificate.check().map(|proved| proved.lower)
    };
    for factor in [0.5, 0.0, -1.0, f64::NAN] {
        let refused = check(factor * radius, c1);
        assert!(matches!(refused, Err(CheckError::Tubes { .. })), "{refused:?}");
        let refused = check(radius, factor * c1);
        assert!(matches!(refused, Err(CheckError::Tubes { .. })), "{refused:?}");
    }
    let refused = check(radius, 2.0 * c1);
    assert!(matches!(refused, Err(CheckError::Constant { .. })), "{refused:?}");
    let refused = check(radius, f64::INFINITY);
    assert!(refused.is_err(), "{refused:?}");
}

/// A declared constant that is no number, or none that bounds, gives no region.
#[test]
fn a_declared_constant_that_bounds_nothing_is_refused() {
    let refused = |c1| {
        let mut certificate = BASE.certificate.clone();
        certificate.region = Region::Declared { c1 };
        certificate.check().expect_err("refused")
    };
    for c1 in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let error = refused(c1);
        assert!(matches!(error, CheckError::Declared { .. }), "{c1}: {error}");
    }
    // So small a constant asks for cubes without end.
    assert!(matches!(refused(1e-300), CheckError::TooLarge { .. }), "{}", refused(1e-300));
}

/// Below the distance, `hi` itself is what is proved.
#[test]
fn a_bound_below_the_distance_is_not_exceeded() {
    for factor in [0.3, 0.9, 0.97, 0.999] {
        let mut certificate = BASE.certificate.clone();
        certificate.hi = factor * BASE.d;
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::CurveLength { .. })), "{refused:?}");
        certificate.curve = None;
        let proved = certificate.check().expect("the cubes suffice");
        assert!(proved.lower <= certificate.hi, "{factor}");
        assert!(factor > 0.98 || proved.lower == certificate.hi, "{factor}: {}", proved.lower);
    }
    for hi in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let mut certificate = BASE.certificate.clone();
        certificate.hi = hi;
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::Bound { .. })), "{refused:?}");
    }
}

/// `hi` stands in the file once. A larger one needs more cubes at the first level, and
/// keeps more.
#[test]
fn a_larger_bound_needs_more_cubes() {
    for factor in [1.01, 1.5, 10.0] {
        let mut certificate = BASE.certificate.clone();
        certificate.hi *= factor;
        let refused = certificate.check();
        let is_refused =
            matches!(refused, Err(CheckError::Tubes { .. } | CheckError::Missing { .. }));
        assert!(is_refused, "{refused:?}");
    }
}

/// A curve that is not as short as it claims, or that ends elsewhere.
#[test]
fn a_wrong_curve_is_refused() {
    let check = |change: &dyn Fn(&mut Vec<SVector<f64, 2>>)| {
        let mut certificate = BASE.certificate.clone();
        change(certificate.curve.as_mut().expect("a curve"));
        certificate.check().map(|proved| proved.upper)
    };
    let long = check(&|curve| curve[100][1] += 0.1);
    assert!(matches!(long, Err(CheckError::CurveLength { .. })), "{long:?}");
    let (first, last) =
        (check(&|curve| curve.rotate_left(1)), check(&|curve| curve.truncate(curve.len() - 1)));
    assert_eq!(first, Err(CheckError::CurveEnd { end: "first" }));
    assert_eq!(last, Err(CheckError::CurveEnd { end: "last" }));
    assert_eq!(check(&|curve| curve.clear()), Err(CheckError::CurveEnd { end: "first" }));
    let unknown = check(&|curve| curve[9][0] = f64::NAN);
    assert!(matches!(unknown, Err(CheckError::CurveLength { .. })), "{unknown:?}");
}

/// Returns one level whose cubes suffice for other sets too, with the functions of the base.
fn wide_level() -> Vec<Level<2>> {
    let region = BASE.wave.declared();
    let sets = BASE.certificate.sets.each_ref();
    let cubes = region.required(sets, 1.4 * BASE.certificate.hi, -4).expect("a region");
    let [x, y] = BASE.ends;
    let functions = [BASE.wave.calibration([x, y], 0.4), BASE.wave.calibration([y, x], 0.4)];
    vec![level(0, &cubes, [&functions[0], &functions[1]])]
}

/// The answer is true for the other end.
#[test]
fn another_end_gives_an_answer_about_that_end() {
    let mut answers = 0;
    for side in [1.0 / 128.0, 1.0 / 16.0] {
        for step in [vector![side, 0.0], vector![-side, 0.0], vector![0.0, side]] {
            let end = BASE.ends[1] + step;
            let mut certificate = BASE.certificate.clone();
            certificate.sets[1] = point(end.into());
            assert_ne!(certificate.statement(), BASE.certificate.statement());
            let refused = certificate.check();
            assert_eq!(refused, Err(CheckError::CurveEnd { end: "last" }));
            let d = BASE.wave.distance(&BASE.ends[0], &end);
            for levels in [certificate.levels.clone(), wide_level()] {
                (certificate.curve, certificate.levels) = (None, levels);
                let checked = certificate.check();
                assert!(lower(&checked) <= d, "{} > {d}", lower(&checked));
                answers += usize::from(checked.is_ok());
            }
        }
    }
    assert!(answers > 0);
}

/// The answer is true for the larger set.
#[test]
fn a_larger_set_gives_an_answer_about_that_set() {
    let mut answers = 0;
    for r in [1e-6, 1e-3, 0.05, 0.2] {
        let mut certificate = BASE.certificate.clone();
        certificate.sets[0] = Shape::Ball(Ball::new(BASE.ends[0], r).expect("a ball"));
        assert_ne!(certificate.statement(), BASE.certificate.statement());
        let boundary = (0..360).map(|n| {
            let angle = f64::from(n).to_radians();
            let x = BASE.ends[0] + vector![angle.cos(), angle.sin()] * (r * (1.0 - 1e-12));
            BASE.wave.distance(&x, &BASE.ends[1])
        });
        let d = boundary.fold(f64::INFINITY, f64::min);
        for levels in [certificate.levels.clone(), wide_level()] {
            (certificate.curve, certificate.levels) = (None, levels);
            let checked = certificate.check();
            assert!(lower(&checked) <= d, "{r}: {} > {d}", lower(&checked));
            answers += usize::from(checked.is_ok());
        }
    }
    assert!(answers > 0);
}

/// The answer is true for the other metric.
#[test]
fn another_constant_of_the_metric_gives_an_answer_about_that_metric() {
    let mut answers = 0;
    for change in [1e-6, -1e-6, 1e-3, -1e-3, 0.1, -0.1] {
        for in_amplitude in [true, false] {
            let mut wave: Wave = BASE.wave;
            *(if in_amplitude { &mut wave.amplitude } else { &mut wave.wave_number }) += change;
            let mut certificate = BASE.certificate.clone();
            certificate.formula = wave.formula();
            assert_ne!(certificate.statement(), BASE.certificate.statement());
            let checked = certificate.check();
            let d = wave.distance(&BASE.ends[0], &BASE.ends[1]);
            assert!(lower(&checked) <= d, "{change}: {} > {d}", lower(&checked));
            certificate.curve = None;
            let checked = certificate.check();
            assert!(lower(&checked) <= d, "{change}: {} > {d}", lower(&checked));
            answers += usize::from(checked.is_ok());
        }
    }
    assert!(answers > 0);
}

/// A curve that is shorter than the distance does not exist, so one of the two is wrong.
#[test]
fn a_proof_that_contradicts_its_curve_is_refused() {
    // This metric is not the one of the curve's length, which is smaller here than the lower bound.
    let mut chain = tautline_check::Chain::new(
        &BASE.certificate.formula,
        &BASE.certificate.sets,
        BASE.certificate.hi,
        BASE.certificate.region,
    )
    .expect("a region");
    for level in &BASE.certificate.levels {
        chain.add(level, BASE.certificate.hi).expect("no cube is missing");
    }
    let upper = 0.9 * BASE.d;
    let refused = chain.proved(Some(upper));
    assert_eq!(refused, Err(CheckError::Contradiction { lower: BASE.proved.lower, upper }));
}

/// Spheres, segments, subspaces and finite sets are in no file. A finite set is a union of points.
#[test]
fn sets_without_lines_in_a_file_are_refused() {
    let [from, _] = &BASE.certificate.sets;
    let sphere = Shape::Sphere(Sphere::new([3.0, 0.0], 0.5).expect("a radius"));
    let points = Shape::FiniteSet(FiniteSet::new([[3.0, 0.0], [4.0, 0.0]]).expect("finite"));
    let begun = |set: Shape<2>| {
        let region = Region::Declared { c1: BASE.wave.c1() };
        let sets = [from.clone(), Shape::Union(vec![from.clone(), set])];
        Chain::new(&BASE.certificate.formula, &sets, 1.0, region).map(|_| ())
    };
    assert_eq!(begun(sphere), Err(CheckError::Set { kind: "a sphere" }));
    assert_eq!(begun(points.clone()), Err(CheckError::Set { kind: "a finite set" }));
    assert_eq!(begun(points.into_elementary().expect("points")), Ok(()));
}

/// The quotient of offset and normal is a double for every half-space that a file may have.
#[test]
fn half_spaces_are_not_too_far() {
    let power = |n: i32| 2.0_f64.powi(n);
    let [from, _] = &BASE.certificate.sets;
    for (normal, offset, is_near) in [
        ([power(-100), power(-3)], power(997), true),
        ([power(-100), -power(-3)], -power(997), true),
        ([power(-100), power(-3)], power(997).next_up(), false),
        ([-power(-3), 0.0], -power(997).next_up(), false),
        ([0.0, power(-1074)], -power(-74), true),
        ([power(-1074), 0.0], power(-74).next_up(), false),
    ] {
        let wall = Shape::HalfSpace(HalfSpace::new(normal, offset).expect("a double"));
        let sets = [from.clone(), Shape::Union(vec![from.clone(), wall])];
        let region = Region::Declared { c1: BASE.wave.c1() };
        let begun = Chain::new(&BASE.certificate.formula, &sets, 1.0, region);
        match begun {
            Ok(_) => assert!(is_near, "{normal:?} {offset:e}"),
            Err(error) => {
                let normal = normal[0].abs().max(normal[1].abs());
                assert!(!is_near && error == CheckError::HalfSpace { offset, normal }, "{error}");
            }
        }
    }
}

#[test]
fn a_formula_has_at_most_500_000_lines() {
    let sets = [point([0.0]), point([1.0])];
    for (steps, is_short) in [(499_999, true), (500_000, false)] {
        let next = |n: usize| format!("s{} = s{n} + 1;\n", n + 1);
        let text: String = (1..steps).map(next).collect();
        let text = format!("s1 = x1 + 1;\n{text}[s{steps}]");
        let formula = Formula::<1>::parse(&text, &[]).expect("a formula");
        let begun = Chain::new(&formula, &sets, 1.0, Region::Declared { c1: 1.0 }).err();
        let refused = CheckError::Formula { lines: steps + 1, most: 500_000 };
        assert_eq!(begun, (!is_short).then_some(refused));
    }
}
