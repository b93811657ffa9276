//! Certified answers for sets that touch, nearly touch, or do not.

use core::ops::ControlFlow;

use tautline_problem::{CertifiedAnswer, Question, distance::Wanted};

/// Returns the answer for two balls of radius 1 with this distance.
fn balls(distance: &str, gap: f64) -> CertifiedAnswer {
    let file = format!(
        "metric = {{ phi = \"1\" }}\nfrom = {{ ball = {{ centre = [0, 0], radius = 1 }} }}\n\
         to = {{ ball = {{ centre = [\"2 + {distance}\", 0], radius = 1 }} }}\n"
    );
    let question = Question::read(&file).expect("a problem");
    question.certify(Wanted::gap(gap), &mut |_| ControlFlow::Continue(())).expect("an answer")
}

/// A proved common point reaches every gap. Sets that touch up to rounding reach none: their distance may
/// be any number up to the upper one.
#[test]
fn only_a_proof_reaches_the_gap() {
    for gap in [1e-3, 0.5, 0.999] {
        let touching = balls("0", gap);
        assert_eq!((touching.lower.value, touching.upper.value), (0.0, 0.0));
        assert!(touching.reached && touching.gap.value == 0.0);
        assert_eq!(touching.ended, "the sets have a common point");
        let nearly = balls("0.5^51", gap);
        assert_eq!((nearly.lower.value, nearly.gap.value, nearly.reached), (0.0, 1.0, false));
        // Ten times as long as the distance, some roundings of numbers up to 3.
        let apart = 0.5_f64.powi(51);
        let upper = nearly.upper.value;
        assert!(apart <= upper && upper <= 10.0 * apart, "{upper:e}");
        assert_eq!(nearly.ended, "the sets touch up to rounding, and no common point is proved");
        for answer in [&touching, &nearly] {
            assert!(answer.certificate.is_empty() && answer.levels.is_empty());
            assert!(answer.corridor.is_empty() && answer.corridor_cubes == 0);
            assert!(answer.curve.len() > 1);
        }
    }
    for gap in [1e-2, 0.5] {
        let apart = balls("1", gap);
        assert!(apart.reached && apart.gap.value <= gap && !apart.certificate.is_empty());
        assert!(apart.lower.value <= 1.0 && 1.0 <= apart.upper.value);
    }
}

/// A search that is stopped has not reached its gap, and says what it has proved.
#[test]
fn a_search_that_is_stopped_has_not_reached_its_gap() {
    let file = "metric = { cost = \"1 + 4*exp(-2*(x1^2 + x2^2))\" }\n\
                from = { point = [-1.5, 0.05] }\nto = { point = [1.5, -0.1] }\n";
    let question = Question::read(file).expect("a problem");
    let stop = &mut |_| ControlFlow::Break(());
    let stopped = question.certify(Wanted::gap(1e-3), stop).expect("an answer");
    assert_eq!((stopped.reached, stopped.levels.len()), (false, 1));
    assert_eq!(stopped.ended, "stopped before the next level");
    assert!(
        stopped.gap.value > 1e-3 && 0.0 < stopped.lower.value && !stopped.certificate.is_empty()
    );
}
