//! Costs and speeds that are negative somewhere on the curve.

use tautline_problem::{Failure, Question, distance::Wanted};

const FILE: &str = "\
[metric]
cost = \"x1 + 0.2\"
[from]
point = [0]
[to]
point = [1]
";

fn refused(file: &str) -> [String; 2] {
    let question = Question::read(file).expect(file);
    let solved = question.solve(&mut |_| ()).map(|_| ());
    let go_on = &mut |_| std::ops::ControlFlow::Continue(());
    let certified = question.certify(Wanted::gap(0.1), go_on).map(|_| ());
    [solved, certified].map(|outcome| match outcome {
        Err(Failure::BadInput(diagnostic)) => {
            let underlined = &file[diagnostic.at.clone()];
            format!("{underlined}: {}", diagnostic.message)
        }
        other => panic!("{file}: {other:?}"),
    })
}

/// The metric is the square of the cost, which does not show its sign. Neither a curve nor a
/// certificate is sought for it.
#[test]
fn a_negative_cost_on_the_curve_is_refused_and_not_certified() {
    let question = Question::read(FILE).expect("a file");
    assert!(question.solve(&mut |_| ()).is_ok());
    let go_on = &mut |_| std::ops::ControlFlow::Continue(());
    assert!(question.certify(Wanted::gap(0.1), go_on).is_ok());
    for (metric, name) in [
        ("cost = \"-1 - x1\"", "cost"),
        ("speed = \"-1 - x1\"", "speed"),
        ("sum = [{ phi = 1 }, { cost = \"-1 - x1\" }]", "cost"),
        ("cost = \"-2 + 0*x1\"", "cost"),
        // In one text it is the same metric.
        ("formula = \"cost(-2 - cos(x1))\"", "cost"),
        ("formula = \"speed(-2 - cos(x1))\"", "speed"),
        ("formula = \"f = -2 - x1; cost(f)\"", "cost"),
        ("formula = \"phi = -2 - x1; cost(phi)\"", "cost"),
        ("sum = [{ phi = 1 }, { formula = \"cost(-2 - x1)\" }]", "cost"),
        ("scaled = { by = 2, metric = { formula = \"cost(-2 - x1)\" } }", "cost"),
        ("product = [{ coordinates = [1], metric = { formula = \"cost(-2 - x1)\" } }]", "cost"),
    ] {
        for message in refused(&FILE.replace("cost = \"x1 + 0.2\"", metric)) {
            assert!(message.contains(&format!("the {name} is -")), "{metric}: {message}");
        }
    }
}

/// Wherever it stands in the metric, and if it is negative in the middle of a chord only.
#[test]
fn a_negative_cost_is_found_in_every_part_of_a_metric() {
    let block = |metric: &str| {
        format!(
            "product = [{{ coordinates = [1], metric = {{ cost = \"1 + x1\" }} }}, \
             {{ coordinates = [2], metric = {{ {metric} }} }}]"
        )
    };
    let scaled = "scaled = { by = 2, metric = { speed = \"-1 - x1\" } }";
    for (metric, name) in [
        (block("cost = \"-1 - x2\""), "cost"),
        (block("sum = [{ phi = 1 }, { speed = \"-1 - x2\" }]"), "speed"),
        (scaled.to_owned(), "speed"),
        (block(scaled), "speed"),
    ] {
        let file = format!("[metric]\n{metric}\n[from]\npoint = [0, 0]\n[to]\npoint = [1, 1]\n");
        for message in refused(&file) {
            assert!(message.contains(&format!("the {name} is -")), "{metric}: {message}");
        }
    }
    // 1 at both ends and −1 in the middle.
    let dip = FILE.replace("x1 + 0.2", "8*(x1 - 0.5)^2 - 1");
    for message in refused(&format!("{dip}[solve]\nn = 1\n")) {
        assert!(message.contains("the cost is -1 at [0.5]"), "{message}");
    }
}

/// What is no cost is not refused: a square that was typed, and a form whose name is defined.
#[test]
fn a_square_that_was_typed_is_a_metric() {
    for metric in ["(-2 - cos(x1))^2 I", "cost = -2 - x1; cost^2 I", "cost(2 + x1)"] {
        let file = FILE.replace("cost = \"x1 + 0.2\"", &format!("formula = \"{metric}\""));
        let answer = Question::read(&file).expect("a file").solve(&mut |_| ());
        assert!(answer.is_ok(), "{metric}: {answer:?}");
    }
}

/// A certificate looks at cubes that the curve does not meet. Where the cost is negative there, it says so.
/// The lower bound is true of the curves on which it is positive: no other leaves 0 for 1.
#[test]
fn a_certificate_tells_that_a_cost_is_negative_beside_the_curve() {
    let certified = |metric: &str| {
        let file = FILE.replace("cost = \"x1 + 0.2\"", metric);
        let question = Question::read(&file).expect("a file");
        let go_on = &mut |_| std::ops::ControlFlow::Continue(());
        question.certify(Wanted::gap(0.1), go_on).expect(metric)
    };
    for metric in ["cost = \"x1 + 0.2\"", "formula = \"cost(x1 + 0.2)\""] {
        let found = certified(metric);
        let note = found.note.expect("a note");
        assert!(note.starts_with("the cost is -") && note.contains("on which it is positive"));
        // ∫ (x + 1/5) dx from 0 to 1.
        assert!(found.lower.value <= 0.7 && found.upper.value >= 0.7);
    }
    let sum = certified("sum = [{ phi = 1 }, { cost = \"x1 + 0.01\" }]").note.expect("a note");
    assert!(sum.ends_with("the sum has its square there"), "{sum}");
    for positive in ["cost = \"x1 + 9\"", "phi = \"(x1 + 0.2)^2\"", "speed = \"2 + sin(x1)\""] {
        assert_eq!(certified(positive).note, None, "{positive}");
    }
}

/// In the half-plane from a thousandth above its edge a step of the search leads below it, where `1/x₂²` is a
/// metric too. The distance is `arcosh(1 + 1/(2 · 10⁻⁶))`.
#[test]
fn a_search_that_steps_over_a_pole_is_sent_back() {
    let exact = (1.0 + 0.5e6_f64).acosh();
    for metric in ["cost = \"1/x2\"", "speed = \"x2\"", "formula = \"cost(1/x2)\""] {
        for n in [64, 1024, 2048, 4096, 16384] {
            let file = format!(
                "[metric]\n{metric}\n[from]\npoint = [0, 1e-3]\n[to]\npoint = [1, 1e-3]\n\
                 [solve]\nn = {n}\n[certify]\nbound = false\n"
            );
            let found = Question::read(&file).expect("a file").solve(&mut |_| ());
            let found = found.unwrap_or_else(|error| panic!("{metric} {n}: {error}"));
            let error = found.length.value / exact - 1.0;
            assert!((0.0..1e-3).contains(&error), "{metric} {n}: {}", found.length.value);
            assert!(found.curve.iter().all(|x| x[1] > 0.0), "{metric} {n}");
        }
    }
}

/// The cost is negative on a strip around 0 that no curve on the line avoids. Between the ends and the middle of
/// a chord the sign is looked at too, also of the second search. Few chords may leap over the strip from far out,
/// and are in doubt.
#[test]
fn a_strip_where_a_cost_is_negative_is_not_leapt_over_without_a_doubt() {
    let metrics = ["cost = \"x1^2 - 1e-6\"", "cost = \"x1^2 - 3e-5\"", "speed = \"x1^2 - 1e-4\""];
    let mut refused = 0;
    for metric in metrics {
        for (n, to) in [16, 255, 256, 257, 1000].into_iter().flat_map(|n| [(n, "1"), (n, "1.1")]) {
            let file = format!(
                "[metric]\n{metric}\n[from]\npoint = [-1]\n[to]\npoint = [{to}]\n[solve]\nn = {n}\n"
            );
            match Question::read(&file).expect("a file").solve(&mut |_| ()) {
                Ok(answer) => assert!(!answer.doubts.is_empty(), "{metric} {n} {to}"),
                Err(failure) => {
                    let message = failure.to_string();
                    assert!(message.contains("is -"), "{metric} {n} {to}: {message}");
                    refused += 1;
                }
            }
        }
    }
    assert!(refused >= 20, "{refused} of 30");
}
