//! Balls that hold all competitors of known lines.

use tautline_bounds::{
    BoundError, Constants, LocalityError, PaperRule, Setting, competitors, reach_outward,
    theorem_d_length_excess,
};
use tautline_discretizations::PointSequence;
use tautline_metrics::gallery::{GaussianFisher, Hyperbolic, Sphere};
use tautline_metrics::{KnownDistance, LocalError, LocallyBounded};
use tautline_sets::{Ball, ClosedSet, Ends, HalfSpace};

use super::{BoundedEnds, Competitors, Extent, upper};
use crate::{Options, Problem, Rule, SVector, Starts, TautLine};

fn line<M: LocallyBounded<2>>(metric: M, a: [f64; 2], b: [f64; 2], n: usize) -> TautLine<M, 2> {
    let ends = Ends::points(a, b).expect("finite");
    Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, n).expect("solved")
}

/// The radius exceeds `L/2√c₁`, where `c₁` is that of the ball, by a few percent: by the margin
/// of 1 % and by what one more ball would save, which is 2 %.
#[test]
fn the_ball_is_as_large_as_a_competitor_may_reach() {
    let line = line(Sphere, [0.3, 0.1], [0.5, 0.2], 64);
    let Competitors { constants, within: ball, outer } = line.competitors().expect("near");
    assert!((ball.centre() - SVector::from([0.4, 0.15])).norm() < 1e-15, "{ball:?}");
    let reach = 0.5 * line.length().value / constants.c1().sqrt();
    assert!(reach < ball.r() && ball.r() < 1.04 * reach, "{ball:?} for {reach}");
    for (ball, constants) in outer.into_iter().chain([(ball, constants)]) {
        assert_eq!(Ok(constants), Sphere.constants_within(ball.centre(), ball.r()));
        assert!(line.sequence().points().iter().all(|x| ball.project(x) == *x));
    }
}

/// Compares the bounds with those of one ball about an end: on the sphere the bound of Theorem D
/// on the length falls by these factors, and longer lines have a ball.
#[test]
fn the_second_stage_narrows_the_bounds() {
    fn by_one_ball(line: &TautLine<Sphere, 2>) -> Option<f64> {
        let (n, upper) = (line.sequence().n(), super::upper(line.extent()));
        let ends = [line.sequence().first(), line.sequence().last()];
        let balls = ends.map(|end| {
            let within = |radius| Sphere.constants_within(end, radius);
            competitors(2, PaperRule::Trapezoidal, n, upper, within).ok()
        });
        let smallest = balls.into_iter().flatten().min_by(|a, b| a.radius.total_cmp(&b.radius));
        smallest.map(|ball| bound(line, ball.constants))
    }
    fn bound(line: &TautLine<Sphere, 2>, constants: Constants) -> f64 {
        let setting = Setting::new(constants, line.length().value, 2).expect("valid");
        theorem_d_length_excess(setting, line.sequence().n()).expect("M_H")
    }
    for (a, b, factor) in [
        ([0.3, 0.1], [0.45, 0.2], 1.25),
        ([0.1, 0.1], [0.5, 0.3], 1.6),
        ([0.3, 0.1], [0.7, 0.2], 1.8),
        ([-0.2, 0.0], [0.2, 0.0], 13.0),
        ([-0.34, 0.0], [0.34, 0.0], f64::INFINITY),
    ] {
        let line = line(Sphere, a, b, 128);
        let found = line.competitors().expect("near");
        let older = by_one_ball(&line).unwrap_or(f64::INFINITY);
        let gain = older / bound(&line, found.constants);
        assert!(gain >= factor, "{a:?} {b:?}: {gain}");
        let d2 = Sphere.distance(&a.into(), &b.into()).expect("known").powi(2);
        let enclosure = line.enclosure_among(&found).expect("finite");
        assert!(enclosure.lower <= d2 && d2 <= enclosure.upper * (1.0 + 1e-14));
    }
}

/// A curve could leave the ball of half the length about the middle and come back, if it were
/// cheap outside. The larger balls exclude that.
#[test]
fn half_a_ball_needs_the_larger_ones() {
    let line = line(Sphere, [0.3, 0.1], [0.5, 0.2], 64);
    let own = line.competitors().expect("near");
    assert!(!own.outer.is_empty() && line.enclosure_among(&own).is_ok());
    let alone = Competitors { outer: Vec::new(), ..own.clone() };
    let error = line.enclosure_among(&alone).expect_err("it may be left");
    assert!(matches!(error, BoundError::LeavesTheBall { .. }), "{error}");
    // Each ball must be large enough for the one before it.
    for k in 0..own.outer.len() {
        let mut outer = own.outer.clone();
        let (ball, constants) = outer[k].clone();
        let smaller = Ball::new(*ball.centre(), 0.9 * ball.r()).expect("a radius");
        outer[k] = (smaller, constants);
        let smaller = Competitors { outer, ..own.clone() };
        assert!(line.enclosure_among(&smaller).is_err(), "ball {k}");
    }
}

/// The distance between nearby points is enclosed under the single assumption that sequences
/// stay in the ball.
#[test]
fn distances_under_metrics_without_global_constants_are_enclosed() {
    fn check<M>(metric: M, a: [f64; 2], b: [f64; 2])
    where
        M: LocallyBounded<2> + KnownDistance<2> + Copy,
    {
        let d2 = metric.distance(&a.into(), &b.into()).expect("known").powi(2);
        let line = line(metric, a, b, 128);
        let competitors = line.competitors().expect("near");
        let enclosure = line.enclosure_among(&competitors).expect("finite");
        assert!(enclosure.lower <= d2 && d2 <= enclosure.upper * (1.0 + 1e-14));
        assert!(enclosure.is_local && !enclosure.assumes_global_minimum, "{enclosure:?}");
        assert!(enclosure.width() < 1e-3 * d2, "{enclosure:?}");
        let suggested = |tolerance| line.suggest_n_among(&competitors, tolerance);
        let [coarse, fine] = [1.0, 1e-6].map(|part| suggested(part * d2).expect("finite").proven);
        assert_eq!(coarse.map(|(n, _)| n.get()), Some(128));
        assert!(fine.is_some_and(|(n, _)| n.get() > 128), "{fine:?}");
    }
    check(Sphere, [0.3, 0.1], [0.45, 0.2]);
    check(Hyperbolic, [0.3, 0.1], [0.4, 0.15]);
    check(GaussianFisher, [0.0, 0.0], [0.1, 0.05]);
}

/// If both ends are bounded, the ball is centred at the smaller one.
#[test]
fn the_ball_is_about_a_bounded_end() {
    let disc = |x: f64, r: f64| Ball::new([x, 0.2], r).expect("finite");
    let wall = HalfSpace::at_least([1.0, 0.0], 0.5).expect("a normal");
    let ends = Ends::new(wall, disc(0.3, 0.05)).expect("bounded");
    let line = Problem::new(Sphere, ends).solve(Rule::LEFT_ENDPOINT, 16).expect("solved");
    let ball = line.competitors().expect("near").within;
    assert_eq!(*ball.centre(), SVector::from([0.3, 0.2]));
    assert!(ball.r() > 0.2);
    let competitors = line.competitors().expect("near");
    let enclosure = line.enclosure_among(&competitors).expect("finite");
    assert!(enclosure.is_local && enclosure.assumes_global_minimum);
    // Two ends of similar size have a ball about the middle; a small end near a large one has a
    // ball of its own.
    for (r, s, gap, at) in [(0.01, 0.1, 0.19, 0.45), (0.01, 0.3, 0.05, 0.3)] {
        let (near, far) = (disc(0.3, r), disc(0.3 + r + gap + s, s));
        for ends in [Ends::new(near.clone(), far.clone()), Ends::new(far, near)] {
            let problem = Problem::new(Sphere, ends.expect("bounded"));
            let line = problem.solve(Rule::TRAPEZOIDAL, 16).expect("solved");
            let competitors = line.competitors().expect("near");
            let ball = &competitors.within;
            assert!((ball.centre()[0] - at).abs() < 1e-15, "{ball:?}");
            assert!(line.enclosure_among(&competitors).is_ok());
        }
    }
}

/// The radius includes those of the sets: between two discs it is `½ (L/√c₁ + r + s)`.
#[test]
fn the_ball_contains_the_bounded_end() {
    let disc = |x: f64| Ball::new([x, 0.2], 0.02).expect("finite");
    let ends = Ends::new(disc(0.3), disc(0.36)).expect("bounded");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
    let Competitors { constants, within, .. } = line.competitors().expect("near");
    assert_eq!(Ok(constants), Sphere.constants_within(within.centre(), within.r()));
    let reach = 0.5 * (line.length().value / constants.c1().sqrt() + 0.04);
    assert!(reach < within.r() && within.r() < 1.04 * reach, "{within:?}");
}

/// The discrete energy of one chord may be `1 + δ/2` times `d²` for the left rule; for the
/// trapezoidal rule the excess is half as large. A line that is not minimal has more energy
/// than its squared length.
#[test]
fn the_energy_allowed_to_a_sequence_counts() {
    let ends = || Ends::points([0.3, 0.0], [0.32, 0.0]).expect("finite");
    let left = Problem::new(Hyperbolic, ends()).solve(Rule::LEFT_ENDPOINT, 1).expect("solved");
    let Competitors { constants, within, .. } = left.competitors().expect("near");
    let length = left.length().value;
    let delta = constants.l_h() * length / constants.c1().powf(1.5);
    let most = constants.c2() / constants.c1();
    let reach = 0.5 * length * (1.0 + 0.5 * delta).min(most).sqrt() / constants.c1().sqrt();
    assert!(reach < within.r() && within.r() < 1.04 * reach, "{within:?} for {reach}");
    let points = [0.3, 0.3005, 0.32].map(|x| [x, 0.0].into()).to_vec();
    let uneven = PointSequence::new(points).expect("finite");
    let options =
        Options { starts: Starts::Only(vec![uneven]), iterations: 0, ..Options::default() };
    let problem = Problem::new(Hyperbolic, ends());
    let uneven = problem.solve_with(Rule::TRAPEZOIDAL, 2, &options).expect("finite");
    let energy = uneven.discrete_energy();
    assert!(energy > 1.5 * uneven.length().value.powi(2), "{energy}");
    let Competitors { constants, within, .. } = uneven.competitors().expect("near");
    assert!(within.r() > 0.5 * (energy / constants.c1()).sqrt(), "{within:?}");
}

/// The ball of another line is refused, and so is one that is too small.
#[test]
fn competitors_of_another_line_are_refused() {
    let near = line(Hyperbolic, [0.0, 0.0], [0.001, 0.0], 64).competitors().expect("near");
    let far = line(Hyperbolic, [0.5, 0.0], [0.4, 0.02], 4);
    let error = far.enclosure_among(&near).expect_err("another line");
    assert!(matches!(error, BoundError::LeavesTheBall { .. }), "{error}");
    assert_eq!(far.suggest_n_among(&near, 1e-3), Err(error));
    let own = far.competitors().expect("near");
    assert!(far.enclosure_among(&own).is_ok());
    let smaller = Ball::new(*own.within.centre(), 0.9 * own.within.r()).expect("finite");
    let smaller = Competitors { within: smaller, ..own };
    assert!(far.enclosure_among(&smaller).is_err());
    // A line without length has a ball of radius zero.
    let still = line(Hyperbolic, [0.5, 0.0], [0.5, 0.0], 4);
    let own = still.competitors().expect("one point");
    assert_eq!(still.enclosure_among(&own).expect("finite").width(), 0.0);
}

/// A small error in the centre, in the radius or in the size of the end is refused.
#[test]
fn a_ball_that_is_a_little_off_is_refused() {
    let ball = Ball::new([0.3, 0.2], 0.05).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 0.45).expect("a normal");
    for ends in [Ends::new(ball.clone(), wall.clone()), Ends::new(wall, ball)] {
        let ends = ends.expect("one bounded");
        let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 32).expect("solved");
        let own = line.competitors().expect("near");
        assert!(line.enclosure_among(&own).is_ok());
        let with = |away: f64, larger: f64| {
            let centre = own.within.centre() + SVector::from([0.0, away]);
            let within = Ball::new(centre, own.within.r() + larger).expect("a radius");
            line.enclosure_among(&Competitors { within, ..own.clone() })
        };
        // Apart from the radius of the end, the radius of the ball is within one percent of the
        // smallest.
        let margin = 0.015 * (own.within.r() - 0.05);
        for refused in [with(0.0, -margin), with(0.0, -0.05), with(margin, 0.0), with(1.0, 0.0)] {
            let error = refused.expect_err("a competitor may be outside");
            assert!(matches!(error, BoundError::LeavesTheBall { .. }), "{error}");
        }
        assert!(with(0.5, 0.5 + margin).is_ok());
    }
}

#[test]
fn ends_that_are_too_far_apart_are_refused() {
    let far = line(Sphere, [-0.5, 0.0], [0.5, 0.0], 64);
    let error = far.competitors().expect_err("√c₁ R ≤ 1");
    assert!(matches!(error, LocalityError::Escapes { .. }), "{error}");
    let far = line(Hyperbolic, [-0.6, 0.0], [0.6, 0.0], 64);
    let error = far.competitors().expect_err("the ball ends");
    let named = matches!(
        error,
        LocalityError::NoConstants { reason: LocalError::LeavesTheDomain { limit: 1.0, .. }, .. }
    );
    assert!(named, "{error}");
}

/// A sequence of pseudorandom numbers (Knuth's MMIX).
struct Draws(u64);

impl Draws {
    /// Returns a whole number below `2^bits`, of at most 53 bits.
    fn whole(&mut self, bits: u32) -> i128 {
        let mut next = || {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            i128::from(self.0 >> 37)
        };
        ((next() << 27) | next()) >> (54 - bits)
    }
}

/// All numbers are whole in this unit, and smaller than `2^90` of it.
const UNIT: i32 = -80;

/// Returns the number that is so many units times a power of two.
fn double(whole: i128, power: i32) -> f64 {
    whole as f64 * 2.0_f64.powi(power)
}

/// Returns a number that is a whole number of units.
fn units(x: f64) -> i128 {
    (x * 2.0_f64.powi(-UNIT)) as i128
}

/// On the line the least radii are sums and differences, which are known exactly. Those that are found are
/// not smaller, and larger by rounding alone.
#[test]
fn radii_are_rounded_up_from_the_exact_ones() {
    let mut draws = Draws(7);
    for _ in 0..500 {
        let mut place = || double(draws.whole(53) - (1 << 52), -52);
        let (at, centre) = ([place(), place()], place());
        let r = [(); 2].map(|()| double(draws.whole(53), -55));
        let length = double(draws.whole(53), -54);
        let away = [0, 1].map(|k| (units(at[k]) - units(centre)).abs() + units(r[k]));
        let long = units(length);
        // Twice the radii.
        let left = (2 * away[0].min(away[1]) + 2 * long).min(away[0] + away[1] + long);
        let middle = (units(at[0]) + units(at[1]) - 2 * units(centre)).abs();
        let filled = left.min(middle + units(r[0]) + units(r[1]) + long);
        let [one, two] = [0, 1].map(|k| (vec![at[k]], r[k]));
        let (both, centre) = (BoundedEnds(vec![one.clone(), two]), [centre]);
        let first = BoundedEnds(vec![one]);
        for (found, exact) in [
            (both.left_by(length, &centre), left),
            (both.filled_by(length, &centre), filled),
            // With one bounded end, a curve may be on its way to anywhere.
            (first.left_by(length, &centre), 2 * (away[0] + long)),
            (first.filled_by(length, &centre), 2 * (away[0] + long)),
        ] {
            assert!(2 * units(found) >= exact, "{at:?} {r:?} {length} {centre:?}: {found}");
            assert!(found <= double(exact, UNIT - 1) * (1.0 + 1e-14), "{at:?} {r:?}: {found}");
        }
    }
    let both = BoundedEnds(vec![(vec![0.0], 1.0), (vec![1.0], 1.0)]);
    let neither = BoundedEnds(Vec::new());
    let centre = [0.5];
    for infinite in [
        both.left_by(f64::INFINITY, &centre),
        both.filled_by(f64::NAN, &centre),
        neither.left_by(1.0, &centre),
        neither.filled_by(1.0, &centre),
    ] {
        assert_eq!(infinite, f64::INFINITY);
    }
}

/// The bound on both numbers is at least the length and at least the root of the discrete energy.
#[test]
fn the_root_of_the_discrete_energy_is_rounded_up() {
    let ends = Ends::points([0.3, 0.1], [0.5, 0.2]).expect("finite");
    let line = Problem::new(Sphere, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
    let extent = line.extent();
    let of =
        |length: f64, discrete_energy: f64| upper(Extent { length, discrete_energy, ..extent });
    let mut draws = Draws(11);
    for _ in 0..100 {
        // Between 1 and 2, where a root is a whole number of units 2⁻⁵².
        let energy = double((1 << 52) + draws.whole(52), -52);
        let root = of(0.0, energy);
        let whole = (root * 2.0_f64.powi(52)) as u128;
        assert!(whole * whole >= ((energy * 2.0_f64.powi(52)) as u128) << 52, "{energy} {root}");
        assert!(root <= energy.sqrt() * (1.0 + 1e-15), "{energy} {root}");
    }
    assert_eq!([of(3.0, 4.0), of(0.5, 0.0), of(0.0, 0.0)], [3.0, 0.5, 0.0]);
    assert!(of(1.0, 4.0) >= 2.0);
    assert!(of(f64::NAN, 4.0).is_nan() && of(1.0, f64::NAN).is_nan());
}

/// Each ball is as large as the constants of the one before it need, to the last digit: with the radius
/// that they need it is accepted, and with the next smaller one it is refused. Its own constants do not
/// count for its own size, and no competitor may touch the boundary of the first or of the last one.
#[test]
fn each_ball_is_measured_by_the_constants_of_the_ball_before_it() {
    let line = line(Sphere, [0.3, 0.1], [0.5, 0.2], 64);
    let extent = line.extent();
    let own = line.competitors().expect("near");
    let mut balls = own.outer.clone();
    balls.push((own.within, own.constants));
    assert!(balls.len() > 1);
    let bounded = BoundedEnds::of(line.any_ends());
    let long = |constants: Constants| {
        let setting = Setting::new(constants, upper(extent), 2).expect("a length");
        reach_outward(setting, PaperRule::Trapezoidal, line.sequence().n())
    };
    let holds = |balls: &[(Ball<2>, Constants)]| {
        let (outer, own) = balls.split_at(balls.len() - 1);
        let (within, constants) = own[0].clone();
        let chain = Competitors { constants, within, outer: outer.to_vec() };
        chain.hold_those_of(&line, extent).is_ok()
    };
    assert!(holds(&balls));
    for (k, (ball, constants)) in balls.iter().enumerate() {
        let reach = match k {
            0 => bounded.left_by(long(*constants), ball.centre_slice()),
            _ => bounded.filled_by(long(balls[k - 1].1), ball.centre_slice()),
        };
        let with = |r: f64| {
            let mut balls = balls.clone();
            balls[k].0 = Ball::new(*ball.centre(), r).expect("a radius");
            holds(&balls)
        };
        // By the constants of the last ball, competitors are away from its boundary.
        assert_eq!([reach.next_down(), reach, reach.next_up()].map(with), [false, k > 0, true]);
    }
    // If the constants of the last ball are worse than those before, they say less.
    let worse = |c1: f64| Constants::new(c1, own.constants.c2(), own.constants.l_h());
    let worse = worse(0.5 * own.constants.c1()).expect("constants").on_a_region();
    let last = balls.len() - 1;
    balls[last].1 = worse;
    assert!(!holds(&balls));
}
