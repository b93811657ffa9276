//! Which problems a plan has.

use std::collections::BTreeSet;

use tautline_problem::sweep::{Plan, PlanError};

use super::{file, plan};

#[test]
fn problems_are_all_combinations_and_the_last_axis_varies_fastest() {
    let plan = plan("vary = { height = [1, \"1 + 1\"], \"x, y\" = [[-2, 0], [-3, 1], [-4, 2]] }");
    assert_eq!((plan.count(), plan.names().join(" ").as_str()), (6, "height x y"));
    let rows: Vec<Vec<f64>> = (0..6).map(|id| plan.row(id)).collect();
    let expected = [
        [1.0, -2.0, 0.0],
        [1.0, -3.0, 1.0],
        [1.0, -4.0, 2.0],
        [2.0, -2.0, 0.0],
        [2.0, -3.0, 1.0],
        [2.0, -4.0, 2.0],
    ];
    assert_eq!(rows, expected);
}

#[test]
fn grids_have_both_ends_exactly() {
    let plan = plan(
        "vary = { y = { from = -0.3, to = 0.1, count = 7 }, height = { from = 2, to = 2, count = 1 } }",
    );
    let values: Vec<f64> = (0..7).map(|id| plan.row(id)[0]).collect();
    assert_eq!((values[0], values[6]), (-0.3, 0.1));
    for pair in values.windows(2) {
        assert!((pair[1] - pair[0] - 0.4 / 6.0).abs() < 1e-15, "{values:?}");
    }
}

/// Each problem has draws of its own, also those that differ in other parameters.
#[test]
fn random_values_are_those_of_the_id_and_the_seed() {
    let sweep = "draws = 500\nseed = 7\nvary = { height = [1, 2], x = { uniform = [-3, -2] }, y = { uniform = [0, 1] } }";
    let (drawn, other) = (plan(sweep), plan(&sweep.replace("seed = 7", "seed = 8")));
    assert_eq!(drawn.count(), 1000);
    let mut seen = BTreeSet::new();
    for id in 0..1000 {
        let [height, x, y] = drawn.row(id)[..] else { panic!("three parameters") };
        assert_eq!(height, if id < 500 { 1.0 } else { 2.0 });
        assert!((-3.0..=-2.0).contains(&x) && (0.0..=1.0).contains(&y), "{x} {y}");
        assert!(seen.insert(x.to_bits()) && seen.insert(y.to_bits()), "{id} repeats a number");
        assert_ne!(drawn.row(id)[1], other.row(id)[1]);
        // The axes are unrelated: the same draw on both would give y = x + 3 up to rounding.
        assert!((y - x - 3.0).abs() > 1e-9, "{x} {y}");
    }
    assert_eq!(drawn.row(123), plan(sweep).row(123));
}

/// The file of one problem has its numbers exactly, and everything else as it stands.
#[test]
fn the_file_of_a_problem_is_the_sweep_file_with_its_numbers() {
    let plan = plan("vary = { y = { from = 0, to = 1, count = 4 }, x = [-2.5] }");
    let expected =
        plan.file().replace("y = 0.1", "y = 0.3333333333333333").replace("x = -2\n", "x = -2.5\n");
    assert_eq!(plan.problem(1), expected);
}

#[test]
fn what_is_wrong_in_a_sweep_is_said_with_its_place() {
    for (sweep, place, message) in [
        ("", "[sweep]", "nothing varies"),
        ("vary = { heigth = [1] }", "heigth", "heigth is no parameter"),
        ("vary = { \"x, x\" = [[1, 2]] }", "\"x, x\"", "x varies twice"),
        ("vary = { x = [1], \"y,x\" = [[1, 2]] }", "\"y,x\"", "x varies twice"),
        ("vary = { x = [] }", "[]", "a list of no values"),
        ("vary = { \"x, y\" = [[1, 2], [3]] }", "[3]", "1 number: expected 2 numbers"),
        ("vary = { \"x, y\" = [[1, 2], 3] }", "3", "1 number: expected 2 numbers"),
        ("vary = { \"x, y\" = { uniform = [1, 2] } }", "{ uniform = [1, 2] }", "vary together"),
        ("vary = { x = [\"1 + q\"] }", "q", "unknown name q"),
        ("vary = { x = [nan] }", "nan", "NaN is not a finite number"),
        ("vary = { x = 3 }", "3", "found 3: expected a list"),
        ("vary = { x = { from = 0, to = 1, count = 1 } }", "1", "1 value"),
        ("vary = { x = { from = 0, to = 1, count = 0 } }", "0", "0 values"),
        ("vary = { x = { from = -1e308, to = 1e308, count = 3 } }", "1e308", "too long"),
        (
            "vary = { x = { from = 0, to = 1 } }",
            "{ from = 0, to = 1 }",
            "expected from, to and count",
        ),
        ("vary = { x = { from = 0, to = 1, cuont = 3 } }", "cuont", "unknown key cuont"),
        ("vary = { x = { uniform = [2, 1] } }", "[2, 1]", "from 2 to 1 is no interval"),
        ("draws = 0\nvary = { x = { uniform = [1, 2] } }", "0", "no draws"),
        ("draws = 3\nvary = { x = [1, 2] }", "3", "nothing is random"),
    ] {
        let file = file(sweep);
        let Err(PlanError::File { diagnostic, .. }) = Plan::read(&file) else {
            panic!("{sweep} is accepted, or for another reason")
        };
        assert!(diagnostic.to_string().contains(message), "{sweep}: {diagnostic}");
        assert_eq!(&file[diagnostic.at.clone()], place, "{sweep}");
    }
}

#[test]
fn files_that_are_no_sweeps_are_refused() {
    let good = file("vary = { x = [1] }");
    let (before, _) = good.split_once("[sweep]").expect("a section");
    let ends = good.find("[from]").expect("a section")..good.find("[solve]").expect("a section");
    let mut endless = good.clone();
    endless.replace_range(ends, "");
    let endless = format!("dimension = 2\n{endless}");
    let clash =
        good.replace("x = -2", "x = -2\nlength = 1").replace("{ x = [1] }", "{ length = [1] }");
    let large = "vary = { x = { from = 0, to = 1, count = 3000000000 }, y = { from = 0, to = 1, count = 4000000 } }";
    for (file, message) in [
        (before.to_owned(), "no section [sweep]"),
        (endless, "[from] and [to] are missing"),
        (good.replace("exp", "epx"), "unknown function epx"),
        (good.replace("n = 16", "n = 16\ntime_limit = 1"), "a time limit in a sweep"),
        (clash, "is called length"),
        (self::file(large), "12000000000000000 problems"),
    ] {
        let error = Plan::read(&file).expect_err(message).to_string();
        assert!(error.contains(message), "{error}");
    }
}

/// A shard on another machine must not solve other problems because a file there is another one.
#[test]
fn the_hash_of_a_plan_is_of_its_tables_too() {
    let file =
        file("vary = { y = [0, 1] }").replace("[metric]", "[tables.h]\nfile = \"h.npy\"\n[metric]");
    let npy = |data: &[u8]| {
        let header = "{'descr': '|u1', 'fortran_order': False, 'shape': (2,), }\n";
        let length = (header.len() as u16).to_le_bytes();
        [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), data].concat()
    };
    let plan = |data: &[u8]| Plan::read_with(&file, &mut |_| Ok(npy(data))).expect("a plan");
    let [first, same, other] = [plan(&[1, 2]), plan(&[1, 2]), plan(&[1, 3])];
    assert_eq!(first.hash(), same.hash());
    assert_ne!(first.hash(), other.hash());
    let table = first.head() + &first.lines(0..first.count()).expect("rows");
    assert!(Plan::of_text_with(&table, &mut |_| Ok(npy(&[1, 2]))).is_ok());
    let changed = Plan::of_text_with(&table, &mut |_| Ok(npy(&[1, 3]))).expect_err("a change");
    assert!(changed.to_string().starts_with("the plan or a file with its tables was changed"));
    let nowhere = Plan::of_text(&table).expect_err("no files");
    assert!(nowhere.to_string().contains("which is not read here"), "{nowhere}");
}

/// A draw keeps to its interval and is that of its own id; the values of the other axes are those of the
/// combination to which it belongs, whatever their order in the file.
#[test]
fn draws_stand_beside_the_values_of_their_combination() {
    let sweep = "draws = 3\nvary = { x = { uniform = [-3, -2] }, height = [1, 2], \
                 y = { from = 0, to = 1, count = 5 } }";
    let plan = plan(sweep);
    assert_eq!((plan.count(), plan.names().join(" ").as_str()), (30, "x height y"));
    for id in 0..30 {
        let [x, height, y] = plan.row(id)[..] else { panic!("three parameters") };
        let combination = id / 3;
        assert!((-3.0..=-2.0).contains(&x), "{x}");
        assert_eq!(height, if combination < 5 { 1.0 } else { 2.0 });
        assert_eq!(y, (combination % 5) as f64 / 4.0);
    }
}
