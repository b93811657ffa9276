//! The corridor of a certified answer.

use core::ops::ControlFlow;
use std::collections::HashSet;

use tautline_picture::portrait::Cubes;
use tautline_problem::{Question, check::AnyCertificate, distance::Wanted};

const HILL: &str = "[metric]\ncost = \"1 + 4*exp(-2*(x1^2 + x2^2))\"\n\
                    [from]\npoint = [-1.5, 0.05]\n[to]\npoint = [1.5, -0.1]\n";

#[test]
fn the_corridor_of_an_answer_is_that_of_its_certificate() {
    let question = Question::read(HILL).expect("a problem");
    let go_on = &mut |_| ControlFlow::Continue(());
    let answer = question.certify(Wanted::gap(1e-2), go_on).expect("certified");
    let places = |cubes: &Cubes| -> HashSet<[i32; 2]> {
        cubes.places.chunks(2).map(|place| [place[0], place[1]]).collect()
    };
    let sets: Vec<_> = answer.corridor.iter().map(places).collect();
    let (corridor, levels) = sets.split_last().expect("a corridor");
    let cubes: Vec<usize> = answer.levels.iter().map(|level| level.cubes).collect();
    assert_eq!(levels.iter().map(HashSet::len).collect::<Vec<_>>(), cubes);
    let AnyCertificate::Plane(certificate) =
        AnyCertificate::read(&answer.certificate).expect("a certificate")
    else {
        panic!("the hill is in the plane")
    };
    // The search keeps a cube whose bound is `hi` up to rounding.
    let proved = certificate.check().expect("a proof").corridor;
    let side = answer.corridor[levels.len()].side;
    assert!(proved.side() == side && proved.places().iter().all(|place| corridor.contains(place)));
    assert!(corridor.len() - proved.places().len() <= 2, "{} cubes", corridor.len());
    for x in &answer.curve {
        let place = [x[0], x[1]].map(|x| (x / side).floor() as i32);
        assert!(sets.iter().zip(&answer.corridor).all(|(set, cubes)| {
            let larger = (cubes.side / side) as i32;
            set.contains(&place.map(|k| k.div_euclid(larger)))
        }));
    }
}

/// The numbers of an answer are those that the checker finds in its certificate.
#[test]
fn the_numbers_of_an_answer_are_those_of_its_certificate() {
    let question = Question::read(HILL).expect("a problem");
    // The second search is stopped after its first level, with a larger gap.
    for (gap, stop) in [(1e-2, false), (1e-6, true)] {
        let observe =
            &mut |_| if stop { ControlFlow::Break(()) } else { ControlFlow::Continue(()) };
        let answer = question.certify(Wanted::gap(gap), observe).expect("certified");
        let read = AnyCertificate::read(&answer.certificate).expect("a certificate");
        let verdict = read.check().expect("a proof");
        let [lower, upper, found] = [&answer.lower, &answer.upper, &answer.gap].map(|it| it.value);
        assert_eq!((lower, Some(upper)), (verdict.lower, verdict.upper));
        assert!((found - (upper - lower) / upper).abs() < 1e-14, "{found}");
        assert_eq!(answer.reached, !stop);
        assert_eq!(answer.reached, found <= gap);
        assert_eq!(answer.ended.contains("stopped"), stop, "{}", answer.ended);
        // Each level proves at least as much as the one before, and the last one all.
        let lowers: Vec<f64> = answer.levels.iter().map(|level| level.lower.value).collect();
        assert!(lowers.is_sorted() && lowers.last() == Some(&lower), "{lowers:?}");
        assert!(answer.levels.len() == 1 || !stop);
        let corridor = answer.corridor.last().expect("a corridor");
        assert_eq!(answer.corridor_cubes * 2, corridor.places.len());
        assert_eq!(answer.corridor_side.value, corridor.side);
    }
}
