//! The row of a problem is the answer to its file, whoever computes it.

use tautline_problem::Question;
use tautline_problem::sweep::{Block, Plan, Runner, Shard, merged};

use super::{file, plan, whole};

/// Returns the column of this name, for each row of results.
fn column(results: &str, name: &str) -> Vec<String> {
    let block = Block::read(results).expect("results");
    let at = block.head.columns.split(',').position(|column| column == name).expect("a column");
    let mut reader =
        csv::ReaderBuilder::new().has_headers(false).from_reader(block.rows.as_bytes());
    reader.records().map(|record| record.expect("a row")[at].to_owned()).collect()
}

/// The formula changes from row to row and stays the same from row to row.
#[test]
fn rows_are_the_answers_to_the_files_of_their_problems() {
    let plan = plan("vary = { y = [0.1, -0.2], height = [1, 1.5], x = [-2, -1.7] }");
    let results = whole(&plan);
    let columns = ["length", "length_error", "extrapolated", "residual", "newton_steps", "stop"];
    let columns = columns.map(|name| column(&results, name));
    for id in 0..plan.count() {
        let mut question = Question::read(&plan.problem(id)).expect("a problem");
        question.without_bounds();
        let answer = question.solve(&mut |_| ()).expect("solved");
        let expected = [
            format!("{:?}", answer.length.value),
            format!("{:?}", answer.length.error),
            answer.extrapolated.map_or(String::new(), |it| format!("{:?}", it.value)),
            format!("{:?}", answer.search.residual),
            answer.search.newton_steps.to_string(),
            answer.search.stop.to_owned(),
        ];
        let found = columns.each_ref().map(|column| column[id as usize].clone());
        assert_eq!(found, expected, "problem {id}");
    }
    let lengths: std::collections::BTreeSet<&String> = columns[0].iter().collect();
    assert_eq!(lengths.len(), 8, "the parameters have no effect");
}

/// A parameter that is written with another one follows it: the ball has half its height as radius.
#[test]
fn parameters_that_depend_on_others_vary_with_them() {
    let text =
        file("vary = { height = [0.5, 1, 2] }").replace("1 + height*exp(-(x1^2 + x2^2))", "1");
    let results = whole(&Plan::read(&text).expect("a plan"));
    for (length, height) in column(&results, "length").iter().zip([0.5, 1.0, 2.0]) {
        let exact = (16.0_f64 + 0.01).sqrt() - 0.5 * height;
        let length: f64 = length.parse().expect("a number");
        assert!((length - exact).abs() < 1e-12, "{length}, not {exact}");
    }
}

#[test]
fn a_failure_is_a_row_and_the_others_are_as_without_it() {
    let text =
        file("vary = { \"height, x\" = [[1, -2], [-0.2, -2], [1, -2], [1, 1.8], [-3, -2]] }")
            .replace("\"twice/4\"", "\"(height + 0.1)/4\"");
    let results = whole(&Plan::read(&text).expect("a plan"));
    let [status, reason, length] =
        ["status", "reason", "length"].map(|name| column(&results, name));
    assert_eq!(status, ["solved", "failed", "solved", "solved", "failed"]);
    assert!(reason[1].contains("-0.025") && reason[1].contains("radius"), "{}", reason[1]);
    assert_eq!((length[0].as_str(), length[1].as_str()), (length[2].as_str(), ""));
    assert_eq!((length[3].as_str(), reason[0].as_str()), ("0.0", ""));
    let plan = Plan::read(&text).expect("a plan");
    let rows = Runner::new(&plan, 2).expect("threads").rows(0..5).expect("rows");
    assert_eq!((rows.doubtful, rows.failed), (0, 2));
}

/// The cost vanishes on a circle, and is negative in it: the message names a point.
#[test]
fn a_reason_with_a_comma_is_one_field_of_one_line() {
    let text = file("vary = { height = [1, -1.5] }").replace("\"twice/4\"", "0.5");
    let results = whole(&Plan::read(&text).expect("a plan"));
    let reason = &column(&results, "reason")[1];
    assert!(reason.contains(", ") && reason.contains("the cost is -"), "{reason}");
    assert_eq!(column(&results, "status"), ["solved", "failed"]);
}

#[test]
fn a_search_that_is_cut_short_is_doubtful() {
    let text = file("vary = { height = [2, 3] }").replace("n = 16", "n = 16\nsteps = 0");
    let plan = Plan::read(&text).expect("a plan");
    let results = whole(&plan);
    assert_eq!(column(&results, "status"), ["doubtful", "doubtful"]);
    assert_eq!(column(&results, "stop"), ["the number of steps ran out"; 2]);
    assert!(column(&results, "reason")[0].contains("strict minimum"));
    assert_eq!(Runner::new(&plan, 1).expect("a thread").rows(0..2).expect("rows").doubtful, 2);
}

#[test]
fn results_do_not_depend_on_threads_or_shards() {
    let plan = plan(
        "draws = 3\nvary = { height = [1, 2, -1.5], x = { uniform = [-3, -1] }, y = [0, 0.4] }",
    );
    assert_eq!(plan.count(), 18);
    let expected = whole(&plan);
    for threads in [1, 2, 5] {
        let runner = Runner::new(&plan, threads).expect("threads");
        assert_eq!(runner.threads(), threads);
        for shards in [1, 2, 7, 18, 25] {
            let solved = |k| {
                let shard = Shard::new(k, shards).expect("a shard");
                runner.solved(shard.ids(plan.count())).expect("results")
            };
            let texts: Vec<String> = (1..=shards).map(solved).collect();
            let blocks: Vec<Block<'_>> =
                texts.iter().map(|text| Block::read(text).expect("a block")).collect();
            assert_eq!(merged(&blocks).expect("a table"), expected, "{shards} on {threads}");
        }
    }
}
