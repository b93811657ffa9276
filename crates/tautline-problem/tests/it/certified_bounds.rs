//! Bounds of a file that are those of a certificate.

use tautline::{Ends, Formula, Problem, Trapezoidal, certify::Accuracy, distance::Ended};
use tautline_problem::{GlobalMinimum, Question};

/// Two chords are too few for the theorems. A certificate takes their place, and the answer says what it is.
#[test]
fn the_certificate_of_bounds_is_that_of_the_library() {
    let file = "[metric]\ncost = \"1.6 - cos(x1)\"\n[from]\npoint = [0]\n[to]\npoint = [3]\n\
                [solve]\nn = 2\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let bounds = answer.bounds.expect("proved");
    let metric = Formula::<1>::parse("cost(1.6 - cos(x1))", &[]).expect("a formula");
    let ends = Ends::points([0.0], [3.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Trapezoidal, 2).expect("solved");
    let accuracy = Accuracy { tolerance: 1e-3, budget: 100_000 };
    let proof = line.prove(accuracy).expect("proved");
    let found = proof.found.as_ref().expect("a certificate");
    let certificate = bounds.certificate.expect("a certificate");
    let cubes: usize = found.proved.levels.iter().map(|(cubes, _)| cubes).sum();
    assert!(found.proved.levels.len() > 1);
    assert_eq!((certificate.cubes, certificate.reached), (cubes, found.ended == Ended::Reached));
    assert_eq!(bounds.global_minimum, GlobalMinimum::NotNeeded);
    assert_eq!(bounds.lower_by, "a certificate");
    // The root is rounded down, and the square before it.
    let (lower, upper) = (bounds.lower.value, bounds.upper.value);
    assert!(lower < found.proved.lower && lower > found.proved.lower * (1.0 - 1e-14), "{lower}");
    assert!(lower * lower <= proof.enclosure.lower && upper * upper >= proof.enclosure.upper);
    // ∫ (1.6 − cos x) dx from 0 to 3.
    let d = 4.8 - 3.0_f64.sin();
    assert!(lower <= d && d <= upper && bounds.constants.proved, "{lower} {d} {upper}");
}
