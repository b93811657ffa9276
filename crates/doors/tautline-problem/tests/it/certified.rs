//! Certificates of distances: what is said of the search, and bounds that are those of a certificate.

use core::ops::ControlFlow;

use tautline::{Ends, Formula, Problem, Rule, certify::Accuracy, distance::Ended};
use tautline_problem::{Failure, GlobalMinimum, Question, distance::Wanted};

/// The channel below is the shorter one. From the one above no certificate reaches its gap, and the bounds
/// do not say that one did.
#[test]
fn bounds_say_whether_their_certificate_reached_its_gap() {
    for (through, reached) in [("-0.8", true), ("1", false)] {
        let file = format!(
            "metric = {{ phi = \"1 + 2*(1 - up)*(1 - down)\" }}\n\
             from = {{ point = [-3, 0] }}\nto = {{ point = [3, 0] }}\n\
             [let]\nup = \"exp(-((x2 - 1)/0.5)^2/2)\"\ndown = \"exp(-((x2 + 0.8)/0.5)^2/2)\"\n\
             [solve]\nonly_these_starts = true\nstarts = [[[-3, 0], [0, {through}], [3, 0]]]\n"
        );
        let answer = Question::read(&file).expect("a file").solve(&mut |_| ()).expect("solved");
        let bounds = answer.bounds.expect("proved");
        assert_eq!(bounds.lower_by, "a certificate");
        let certificate = bounds.certificate.as_ref().expect("a certificate");
        assert_eq!(certificate.reached, reached, "{certificate:?}");
        assert_eq!(certificate.ended == "the gap is as small as wanted", reached);
    }
}

/// The set that cannot be written into a certificate is the one that is underlined.
#[test]
fn the_set_without_a_certificate_is_underlined() {
    let point = "point = [0, 0]";
    let sphere = "sphere = { centre = [3, 0], radius = 1 }";
    for (sets, end, section) in
        [([sphere, point], "first", "[from]"), ([point, sphere], "second", "[to]")]
    {
        let file = format!("[metric]\nphi = \"1\"\n[from]\n{}\n[to]\n{}\n", sets[0], sets[1]);
        let question = Question::read(&file).expect("a file");
        let found = question.certify(Wanted::gap(0.1), &mut |_| ControlFlow::Continue(()));
        let Err(Failure::BadInput(wrong)) = found else { panic!("{found:?}") };
        assert!(wrong.message.contains(&format!("the {end} set")), "{wrong}");
        assert_eq!(&file[wrong.at.clone()], section);
    }
}

/// Two chords are too few for the theorems. A certificate takes their place, and the answer says what it is.
#[test]
fn the_certificate_of_bounds_is_that_of_the_library() {
    let file = "[metric]\ncost = \"1.6 - cos(x1)\"\n[from]\npoint = [0]\n[to]\npoint = [3]\n\
                [solve]\nn = 2\nscope = \"local\"\n";
    let answer = Question::read(file).expect("a file").solve(&mut |_| ()).expect("solved");
    let bounds = answer.bounds.expect("proved");
    let metric = Formula::<1>::parse("cost(1.6 - cos(x1))", &[]).expect("a formula");
    let ends = Ends::points([0.0], [3.0]).expect("finite");
    let line = Problem::new(metric, ends).solve(Rule::TRAPEZOIDAL, 2).expect("solved");
    let accuracy = Accuracy { tolerance: 1e-3, budget: 100_000 };
    let proof = line.prove(accuracy).expect("proved");
    let found = proof.found.as_ref().expect("a certificate");
    let certificate = bounds.certificate.as_ref().expect("a certificate");
    let cubes: usize = found.levels().iter().map(|(cubes, _)| cubes).sum();
    assert!(found.levels().len() > 1);
    assert_eq!((certificate.cubes, certificate.reached), (cubes, found.ended() == Ended::Reached));
    assert_eq!(bounds.global_minimum, GlobalMinimum::NotNeeded);
    assert_eq!(bounds.lower_by, "a certificate");
    // The root is rounded down, and the square before it.
    let (lower, upper) = (bounds.lower.value, bounds.upper.value);
    assert!(lower < found.lower() && lower > found.lower() * (1.0 - 1e-14), "{lower}");
    assert!(lower * lower <= proof.enclosure.lower && upper * upper >= proof.enclosure.upper);
    // ∫ (1.6 − cos x) dx from 0 to 3.
    let d = 4.8 - 3.0_f64.sin();
    assert!(lower <= d && d <= upper && !bounds.rests_on_claims(), "{lower} {d} {upper}");
}
