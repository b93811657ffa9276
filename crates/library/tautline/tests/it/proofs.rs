//! Proofs whose lower bound is that of a certificate, since the theorems would assume a global
//! minimum.

use tautline::{
    Ball, Constants, Ends, Formula, HalfSpace, Options, PointSequence, Problem, Proof, Rule,
    Sphere, Starts, TautLine,
    bounds::{Enclosure, FromBelow},
    certify::Accuracy,
    distance::Ended,
    gallery::Valleys,
};

fn line(
    metric: &str,
    [from, to]: [[f64; 2]; 2],
    through: Option<[f64; 2]>,
) -> TautLine<Formula<2>, 2> {
    let ends = Ends::points(from, to).expect("finite");
    let start = |x| PointSequence::new([from, x, to].map(Into::into).to_vec()).expect("finite");
    let only = |x| Options { starts: Starts::Only(vec![start(x)]), ..Options::default() };
    let options = through.map_or_else(Options::default, only);
    let metric = Formula::parse(metric, &[]).expect("a formula");
    Problem::new(metric, ends).solve_with(Rule::TRAPEZOIDAL, 256, &options).expect("solved")
}

/// Returns the bounds on the distance that a certificate proves of a line.
fn certified(line: &TautLine<Formula<2>, 2>, gap: f64) -> [f64; 2] {
    let proved = line.certificate(gap).expect("found").certificate.check().expect("proved");
    [proved.lower, proved.upper.expect("a curve")]
}

/// Returns the bounds that the theorems give with the constants of a proof.
fn by_theorems(line: &TautLine<Formula<2>, 2>, proof: &Proof<'_, 2>) -> Enclosure {
    let proved = proof.constants;
    let claimed = Constants::new(proved.c1(), proved.c2(), proved.l_h());
    let claimed = claimed.and_then(|claimed| claimed.with_m_h(proved.m_h().expect("proved")));
    line.enclosure_given(claimed.expect("constants"), None).expect("bounds")
}

fn is_checked<const D: usize>(proof: &Proof<'_, D>) {
    let found = proof.found.as_ref().expect("a certificate");
    let lower = found.check().expect("proved").lower;
    // The product may have been rounded up; the double below it is below the square.
    let square = lower * lower;
    assert!(proof.enclosure.lower <= square.next_down());
    assert!(proof.enclosure.lower >= square * (1.0 - 1e-15));
    assert_eq!(proof.enclosure.from_below, FromBelow::Certificate);
    assert!(!proof.enclosure.assumes_global_minimum);
}

/// Two channels lead from left to right, and the shorter one is 6 % shorter. By the theorems alone
/// the enclosure of the longer curve begins above the distance.
#[test]
fn a_proof_from_the_wrong_channel_contains_the_distance() {
    let channels = "up = exp(-((x2 - 1)/0.5)^2/2); down = exp(-((x2 + 0.8)/0.5)^2/2); \
                    (1 + 2*(1 - up)*(1 - down)) I";
    let ends = [[-3.0, 0.0], [3.0, 0.0]];
    let [least, most] = certified(&line(channels, ends, None), 1e-3);
    let wrong = line(channels, ends, Some([0.0, 1.0]));
    let proof = wrong.prove(Accuracy::default()).expect("proved");
    assert!(most * most < 0.9 * proof.enclosure.upper);
    assert!(proof.enclosure.lower <= least * least);
    assert_ne!(proof.found.as_ref().map(|found| found.ended()), Some(Ended::Reached));
    is_checked(&proof);
    let assumed = by_theorems(&wrong, &proof);
    assert!(assumed.assumes_global_minimum && assumed.lower > most * most);
}

/// From the right channel, the bounds are as close as those under the assumption.
#[test]
fn a_certificate_takes_the_place_of_an_assumption() {
    let hill = line("cost(1 + 4*exp(-2*(x1^2 + x2^2)))", [[-1.5, 0.05], [1.5, -0.1]], None);
    let proof = hill.prove(Accuracy::default()).expect("proved");
    is_checked(&proof);
    let assumed = by_theorems(&hill, &proof);
    assert!(assumed.assumes_global_minimum);
    assert!(proof.enclosure.width() < assumed.width(), "{:?} {assumed:?}", proof.enclosure);
    // d = 4.6752711724…
    let d = 4.675_271_172_4_f64;
    assert!(proof.enclosure.lower <= d * d && d * d <= proof.enclosure.upper);
}

/// Where the theorems prove the minimum to be global, nothing is searched for.
#[test]
fn a_proof_without_an_assumption_has_no_certificate() {
    let near = line("cost(2 - cos(x1))", [[0.0, 0.0], [0.2, 0.1]], None);
    let proof = near.prove(Accuracy::default()).expect("proved");
    assert!(proof.found.is_none() && !proof.enclosure.assumes_global_minimum);
    assert_eq!(proof.enclosure.from_below, FromBelow::Convexity);
}

/// A few chords are too few for the theorems: their bound is that of Euclid, and a certificate is
/// better.
#[test]
fn a_trivial_bound_is_replaced() {
    let ends = Ends::points([0.0, 0.0], [3.0, 1.0]).expect("finite");
    let metric = Formula::<2>::parse("cost(1.6 - cos(x1))", &[]).expect("a formula");
    let coarse = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 2).expect("solved");
    let proof = coarse.prove(Accuracy::default()).expect("proved");
    is_checked(&proof);
    assert!(proof.enclosure.lower > 2.0 * 0.36 * 10.0, "{:?}", proof.enclosure);
}

/// A set that cannot be written into a certificate leaves the assumption.
#[test]
fn without_a_certificate_the_assumption_is_said() {
    let ball = Ball::new([0.0, 0.0], 0.5).expect("a radius");
    let wall = HalfSpace::at_least([1.0, 0.0], 3.0).expect("a normal");
    let around = Sphere::new([0.0, 0.0], 3.0).expect("a radius");
    let solved = |ends| Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
    let sets = solved(Ends::new(ball.clone(), wall).expect("bounded"));
    is_checked(&sets.prove(Accuracy::default()).expect("proved"));
    let sphere = solved(Ends::new(ball, around).expect("bounded"));
    let proof = sphere.prove(Accuracy::default()).expect("proved");
    assert!(proof.enclosure.assumes_global_minimum && proof.found.is_none());
}

/// Points that are unevenly spaced have more energy than the square of their length, so that another sequence
/// of points has less. That is said beside a certificate too, which needs no minimum; of even points it is not.
#[test]
fn a_minimum_that_is_not_global_is_so_beside_a_certificate() {
    let metric = Formula::<2>::parse("(2 - cos(x1)) I", &[]).expect("a formula");
    let ball = |x: f64| Ball::new([x, 0.0], 0.0).expect("a radius");
    let ends = Ends::new(ball(-1.0), ball(2.0)).expect("bounded");
    // At the time t the curve is at 3t² − 1.
    let at = |n: i32| [3.0 * (f64::from(n) / 64.0).powi(2) - 1.0, 0.0].into();
    let uneven = PointSequence::new((0..=64).map(at).collect()).expect("finite");
    let problem = Problem::new(metric, ends);
    let solved = |starts, iterations| {
        let options = Options { starts, iterations, ..Options::default() };
        problem.solve_with(Rule::TRAPEZOIDAL, 64, &options).expect("solved")
    };
    let uneven = solved(Starts::OnTheGrid(vec![uneven]), 0);
    let even = solved(Starts::Automatic, Options::<2>::default().iterations);
    for (line, is_not_global) in [(uneven, true), (even, false)] {
        let proof = line.prove(Accuracy::default()).expect("proved");
        assert_eq!(by_theorems(&line, &proof).is_not_global, is_not_global);
        is_checked(&proof);
        assert_eq!(proof.enclosure.is_not_global, is_not_global);
        assert_eq!(proof.enclosure.upper, proof.curve.distance_squared_at_most());
    }
}
