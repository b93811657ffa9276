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
