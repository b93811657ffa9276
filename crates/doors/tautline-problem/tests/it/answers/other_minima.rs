//! The other minima in an answer.

use tautline_problem::{Answer, Example, Grid, Question};

fn answer(name: &str, solve: &str, n: usize) -> Answer {
    let text = Example::named(name).expect("an example").text;
    let mut question = Question::read(&format!("{text}{solve}")).expect("a problem");
    question.set_grid(Grid::Chords(n)).expect("a grid");
    question.solve(&mut |_| ()).expect("solved")
}

/// With three chords the left-endpoint rule prefers a longer way between the obstacles. A local search keeps
/// to these chords, and says so.
#[test]
fn a_shorter_minimum_is_the_upper_bound_and_shows_too_few_chords() {
    let left = "\n[solve]\nrule = \"left_endpoint\"\nscope = \"local\"\n";
    let coarse = answer("obstacles", left, 3);
    let shortest = &coarse.other_minima[0];
    assert!(shortest.is_shorter_than(&coarse) && !shortest.ties_with(&coarse), "{shortest:?}");
    assert!(!coarse.resolved);
    assert!(
        coarse.doubts.iter().any(|doubt| doubt.kind == "shorter_minimum"),
        "{:?}",
        coarse.doubts
    );
    let bounds = coarse.bounds.expect("proved");
    assert_eq!(bounds.upper_by, "the length of another minimum");
    let excess = bounds.upper.value / shortest.length.value - 1.0;
    // A rigorous bound on the length that the quadrature estimates.
    assert!((0.0..1e-9).contains(&excess), "{excess:e}");
    let fine = answer("obstacles", left, 256);
    assert!(fine.resolved && fine.other_minima.iter().all(|other| !other.is_shorter_than(&fine)));
    assert_eq!(fine.bounds.expect("proved").upper_by, "the length of the curve");
    // An automatic search takes more chords, until the shortest curve that it met has the least energy.
    let automatic = answer("obstacles", "\n[solve]\nrule = \"left_endpoint\"\n", 3);
    assert!(
        automatic.n > 3 && automatic.doubts.is_empty(),
        "{} {:?}",
        automatic.n,
        automatic.doubts
    );
    assert!(automatic.length.value < coarse.length.value);
}

/// By claimed constants, too, the length of another minimum is enclosed.
#[test]
fn the_length_of_another_minimum_is_enclosed_also_beside_claims() {
    // The metric is at least 1, and these claims are far from close.
    let claims = "\n[solve]\nrule = \"left_endpoint\"\nscope = \"local\"\n\
                  [certify.constants]\nc1 = 1\nc2 = 1e4\nl_h = 1e6\n";
    let answer = answer("obstacles", claims, 3);
    let (bounds, length) = (answer.bounds.expect("claimed"), &answer.other_minima[0].length);
    assert_eq!(bounds.upper_by, "the length of another minimum");
    let excess = bounds.upper.value / length.value - 1.0;
    assert!((0.0..1e-9).contains(&excess), "{excess:e}");
}

/// The ways on both sides of the hill are mirror images. On the grid of the line they have the
/// same length up to rounding, and on 512 chords the other one is longer by the error of that grid.
#[test]
fn a_tie_is_a_tie_on_every_grid() {
    for n in [256, 2048] {
        let tie = answer("tie", "", n);
        let [other] = &tie.other_minima[..] else { panic!("{} others", tie.other_minima.len()) };
        assert!(other.ties_with(&tie) && !other.is_shorter_than(&tie), "N = {n}");
    }
    // The channels are at different heights: 7.08 and 7.53.
    let channels = answer("two_channels", "", 256);
    let [other] = &channels.other_minima[..] else { panic!("one other") };
    assert!(!other.ties_with(&channels) && !other.is_shorter_than(&channels));
    assert!(other.length.value > channels.length.value * 1.05);
}

#[test]
fn lengths_that_differ_by_more_than_the_error_of_a_grid_are_no_tie() {
    let mut answer = answer("two_channels", "", 64);
    let mut other = answer.other_minima.remove(0);
    answer.length.value = 2.0;
    for (length, ties, shorter) in [
        (2.0, true, false),
        (2.0 + 1e-5, true, false),
        (2.0 - 1e-5, true, false),
        (2.0 + 4e-5, false, false),
        (2.0 - 4e-5, false, true),
    ] {
        other.length.value = length;
        assert_eq!((other.ties_with(&answer), other.is_shorter_than(&answer)), (ties, shorter));
    }
}
