//! When a search ends, and with how much work.

use std::ops::ControlFlow;

use nalgebra::{SVector, matrix, vector};
use tautline_check::CheckError;
use tautline_distance::{DistanceError, Ended, Found, Progress, Wanted, search};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    attempt::{attempt, holds},
    flat::{ball, formula, nearest, point},
};

/// The limit is on the cubes of all levels together, the first one among them.
#[test]
fn the_cubes_of_all_levels_keep_to_the_limit() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let sets = [ball([-1.5, -1.0], 0.5), ball([1.25, 1.5], 0.75)];
    let pair = nearest(&h, &sets)[0].clone();
    let mut last = 1.0;
    for cubes in [600, 1200, 1800, 2500, 4000, 6000, 9000] {
        // The attempt asserts the limit.
        let found = attempt(&formula(&h), &sets, &[pair.line(20)], Wanted { gap: 1e-9, cubes });
        let found = found.unwrap_or_else(|error| panic!("{cubes}: {error}"));
        assert_eq!(found.ended, Ended::TooManyCubes, "{cubes}");
        holds(&found, pair.distance, 1e-11, 0.9);
        last = found.proved.gap().expect("a curve");
    }
    assert!(last < 1e-2, "{last}");
    let refused = attempt(&formula(&h), &sets, &[pair.line(20)], Wanted { gap: 1e-3, cubes: 10 });
    let reason = CheckError::TooLarge { most: 10 };
    assert!(
        matches!(&refused, Err(DistanceError::Region { reason: found, .. }) if *found == reason),
        "{refused:?}"
    );
}

/// Returns a hill, a point on either side, and the straight line between them over the top. It is about half
/// as long again as the way around.
fn over_the_hill() -> (Formula<2>, [Shape<2>; 2], Vec<SVector<f64, 2>>) {
    let hill = Formula::parse("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", &[]).expect("a formula");
    let ends = [vector![-1.5, 0.05], vector![1.5, -0.1]];
    let line = |n: i32| ends[0].lerp(&ends[1], f64::from(n) / 200.0);
    (hill, ends.map(point), (0..=200).map(line).collect())
}

/// The way around the hill that is not the shorter one: no certificate says that it is, and smaller cubes
/// do not help.
#[test]
fn a_curve_that_is_not_minimal_stalls() {
    let (hill, sets, curve) = over_the_hill();
    // The attempt asserts that the last two levels were slow, and no two before.
    let found =
        attempt(&hill, &sets, &[curve], Wanted { gap: 1e-3, cubes: 100_000 }).expect("a region");
    assert_ne!(found.ended, Ended::Reached);
    // The distance is 4.67527.
    assert!(found.proved.lower <= 4.67528, "{}", found.proved.lower);
}

/// A level may be slow for the second time and reach the gap: then it is reached.
#[test]
fn a_slow_level_that_reaches_the_gap_has_reached_it() {
    let (hill, sets, curve) = over_the_hill();
    let with = |gap: f64| {
        let wanted = Wanted { gap, cubes: 100_000 };
        attempt(&hill, &sets, std::slice::from_ref(&curve), wanted).expect("a region")
    };
    let stalled = with(1e-3);
    assert_eq!(stalled.ended, Ended::Stalled);
    let (lower, upper) = (stalled.proved.lower, stalled.proved.upper.expect("a curve"));
    // Both searches have the fewest steps along a ray. The gap is rounded.
    let reached = with((upper - lower) / upper * (1.0 + 1e-12));
    assert_eq!((reached.ended, reached.proved.lower), (Ended::Reached, lower));
}

/// Searches for a certificate of a line from 0 to `2^exponent`, under a metric that is the same in these
/// units.
fn along_the_line(exponent: i32, gap: f64) -> Result<Found<1>, DistanceError> {
    let unit = 2.0_f64.powi(exponent);
    let metric = format!("sqr(2 - cos(6*x1/{unit:e})) I");
    let formula = Formula::<1>::parse(&metric, &[]).expect("a formula");
    let curve: Vec<_> = (0..=1024).map(|n| vector![unit * f64::from(n) / 1024.0]).collect();
    let sets = [point([curve[0][0]]), point([curve[1024][0]])];
    attempt(&formula, &sets, &[curve], Wanted::gap(gap))
}

/// The sides of cubes are at least `2^-200`. A search that comes to such cubes returns what it has proved
/// before, on as many cubes as in other units.
#[test]
fn a_search_that_comes_to_the_smallest_cubes_returns_what_it_has() {
    let gap = 1e-5;
    let all = along_the_line(0, gap).expect("found");
    assert_eq!(all.ended, Ended::Reached);
    let last = all.certificate.levels.last().expect("a level").cubes().exponent();
    let first = all.certificate.levels[0].cubes().exponent();
    assert!(first - last >= 4, "{first} {last}");
    for exponent in [-100, -200 - last, -201 - last, -202 - last, -200 - first] {
        let found = along_the_line(exponent, gap).expect("found");
        let has_all = last + exponent >= -200;
        assert_eq!(found.ended == Ended::Reached, has_all, "{exponent}");
        assert_eq!(found.ended == Ended::TooFar, !has_all, "{exponent}");
        let smallest = last.max(-200 - exponent);
        let levels = (first - smallest + 1) as usize;
        assert_eq!(found.proved.levels.len(), levels, "{exponent}");
        let cubes =
            |found: &Found<1>| found.proved.levels[..levels].iter().map(|l| l.0).sum::<usize>();
        assert_eq!(cubes(&found), cubes(&all), "{exponent}");
        assert!(found.proved.gap().expect("a curve") < 0.01, "{exponent}");
    }
    // The first level has fewer cubes than it should have.
    let few = along_the_line(-201 - first, gap).expect("found");
    assert_eq!((few.ended, few.proved.levels.len()), (Ended::TooFar, 1));
    assert!(few.proved.gap().expect("a curve") < 0.1, "{:?}", few.proved);
    // Without a first level nothing is proved.
    let refused = along_the_line(-220, gap).map(|_| ());
    assert!(matches!(refused, Err(DistanceError::Refused(CheckError::Side { .. }))), "{refused:?}");
}

#[test]
fn an_observer_may_stop_a_search_at_any_level() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let sets = [point([-1.5, -1.0]), point([1.25, 1.5])];
    let pair = nearest(&h, &sets)[0].clone();
    for levels in 1..=3 {
        let mut told = 0;
        let observe = &mut |step: Progress| {
            told += 1;
            assert_eq!(step.levels, told);
            if told == levels { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let found = search(&formula(&h), &sets, &[pair.line(20)], Wanted::gap(1e-9), observe);
        let found = found.expect("found");
        assert_eq!((found.ended, found.certificate.levels.len()), (Ended::Stopped, levels));
        assert_eq!(told, levels);
        assert!(found.certificate.check().is_ok());
    }
}

/// Far from the origin, small cubes have no places of 32 bits. What was proved before is returned.
#[test]
fn a_search_far_from_the_origin_ends_with_what_it_has() {
    let waves = Formula::<1>::parse("sqr(2 - cos(x1)) I", &[]).expect("a formula");
    let (x, y) = (1e6_f64, 1e6_f64 + 1.0);
    let curve = (0..=64).map(|n| vector![x + f64::from(n) / 64.0]).collect();
    let sets = [point([x]), point([y])];
    let found = attempt(&waves, &sets, &[curve], Wanted { gap: 1e-9, cubes: 100_000 });
    let found = found.expect("a certificate");
    assert_eq!(found.ended, Ended::TooFar);
    // ∫ (2 − cos x) dx.
    holds(&found, 2.0 - y.sin() + x.sin(), 1e-9, 1e-2);
}

/// The angles of waves far from the origin are reduced with all digits. Otherwise each chord would cost 2¹³
/// parts, and the check of the certificate more than it may: the attempt checks it.
#[test]
fn waves_far_from_the_origin_have_certificates() {
    let waves = Formula::<1>::parse("sqr(2 - cos(6*x1)) I", &[]).expect("a formula");
    for from in [1e6_f64, -1e6 - 0.5] {
        let curve = (0..=1024).map(|n| vector![from + f64::from(n) / 1024.0]).collect();
        let sets = [point([from]), point([from + 1.0])];
        let found = attempt(&waves, &sets, &[curve], Wanted::gap(1e-5)).expect("a certificate");
        // ∫ (2 − cos 6x) dx. Multiples of 6 up to 2²⁸ are doubles.
        let d = 2.0 - ((6.0 * from + 6.0).sin() - (6.0 * from).sin()) / 6.0;
        holds(&found, d, 1e-9, 1e-2);
    }
}

/// A search that is stopped at the level that reaches its gap has reached it. At the level before it is
/// stopped, also where the next one would have too many cubes.
#[test]
fn what_is_reached_is_said_of_a_search_that_is_stopped() {
    let h = matrix![1.2, 0.4; 0.4, 1.1];
    let sets = [point([-1.5, -1.0]), point([1.25, 1.5])];
    let pair = nearest(&h, &sets)[0].clone();
    for gap in [0.2, 1e-2] {
        let until = |last: usize, cubes: usize| {
            let observe = &mut |step: Progress| {
                if step.levels == last { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
            };
            let wanted = Wanted { gap, cubes };
            search(&formula(&h), &sets, &[pair.line(20)], wanted, observe).expect("found")
        };
        let all = until(usize::MAX, 1_000_000);
        let levels = all.certificate.levels.len();
        let cubes =
            |levels: usize| all.proved.levels[..levels].iter().map(|(cubes, _)| cubes).sum();
        for most in [1_000_000, cubes(levels)] {
            let stopped = until(levels, most);
            assert_eq!((all.ended, stopped.ended), (Ended::Reached, Ended::Reached), "{gap}");
            assert_eq!(stopped.proved, all.proved);
        }
        for most in [1_000_000, cubes(levels - 1)].into_iter().filter(|_| levels > 1) {
            let before = until(levels - 1, most);
            assert_eq!(
                (before.ended, before.certificate.levels.len()),
                (Ended::Stopped, levels - 1)
            );
            assert!(before.proved.gap().expect("a curve") > gap);
        }
    }
}
