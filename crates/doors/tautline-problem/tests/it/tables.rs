//! Tables of numbers in a file, and in files that it names.

use std::sync::Arc;

use tautline::{FineSpline, Formula, Spline, Table};
use tautline_problem::{Diagnostic, Grid, Question};

const GOOD: &str = "\
[tables.h]
values = [[1, 2.5], [3, 4], [2, 1]]
[metric]
cost = \"h(x1, x2)\"
[from]
point = [0, 0]
[to]
point = [2, 1]
";

/// What a file is expected to mean: its text, and the spline that its formula calls.
fn expected(spline: impl Table) -> Formula<2> {
    let table: Arc<dyn Table> = Arc::new(spline);
    Formula::parse_with("cost(h(x1, x2))", &[], &[("h", table)]).expect("a formula")
}

fn formula(file: &str, bytes: &[u8]) -> Formula<2> {
    let question = Question::read_with(file, &mut |_| Ok(bytes.to_vec())).expect("a file");
    question.formula().expect("a formula")
}

/// Returns a NPY file of bytes.
fn npy(shape: &str, data: &[u8]) -> Vec<u8> {
    let header = format!("{{'descr': '|u1', 'fortran_order': False, 'shape': {shape}, }}\n");
    let length = (header.len() as u16).to_le_bytes();
    [b"\x93NUMPY\x01\x00", &length[..], header.as_bytes(), data].concat()
}

#[test]
fn a_table_is_the_spline_of_its_kind() {
    let values = vec![1.0, 2.5, 3.0, 4.0, 2.0, 1.0];
    let of = |kind: &str| GOOD.replace("]]\n", &format!("]]\nspline = \"{kind}\"\n"));
    let monotone = || FineSpline::monotone(&[3, 2], values.clone()).expect("a spline");
    assert_eq!(formula(GOOD, &[]), expected(monotone()));
    assert_eq!(formula(&of("monotone"), &[]), expected(monotone()));
    let cubic = Spline::interpolating(&[3, 2], values.clone()).expect("a spline");
    assert_eq!(formula(&of("cubic"), &[]), expected(cubic));
    let smoothing = Spline::new(&[3, 2], values.clone()).expect("a spline");
    assert_eq!(formula(&of("smoothing"), &[]), expected(smoothing));
}

#[test]
fn a_file_is_opened_by_its_name_and_its_component_counts_from_1() {
    let file = GOOD.replace("values = [[1, 2.5], [3, 4], [2, 1]]", "file = \"data/h.npy\"");
    let mut opened = Vec::new();
    let question = Question::read_with(&file, &mut |name| {
        opened.push(name.to_owned());
        Ok(npy("(3, 2)", &[1, 2, 3, 4, 5, 6]))
    });
    let whole =
        FineSpline::monotone(&[3, 2], vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]).expect("a spline");
    assert_eq!(question.expect("a file").formula::<2>().expect("a formula"), expected(whole));
    assert_eq!(opened, ["data/h.npy"]);

    let file = file.replace("npy\"", "npy\"\ncomponent = [2, 1]");
    let data: Vec<u8> = (0..12).collect();
    let entry = FineSpline::monotone(&[3, 1], vec![2.0, 6.0, 10.0]).expect("a spline");
    assert_eq!(formula(&file, &npy("(3, 1, 2, 2)", &data)), expected(entry));
}

/// The parameters of a sweep change nothing in a table, which is read once.
#[test]
fn other_parameters_keep_the_tables() {
    let file = format!("[parameters]\na = 1\n{GOOD}").replace("\"h(x1, x2)\"", "\"a*h(x1, x2)\"");
    let question = Question::read(&file).expect("a file");
    let other = question.with_parameters(&[("a", 3.0)]).expect("a file");
    let written = Question::read(&file.replace("a = 1", "a = 3")).expect("a file");
    assert_eq!(other.formula::<2>().expect("3"), written.formula::<2>().expect("3"));
    assert_ne!(other.formula::<2>().expect("3"), question.formula::<2>().expect("1"));
}

/// Two files whose formulas have the same text, since it calls tables by their numbers, have programs of
/// their own: that of the other table has another length.
#[test]
fn programs_are_shared_only_with_the_same_tables() {
    let [first, second] = [GOOD.to_owned(), GOOD.replace("[3, 4]", "[3, 5]")].map(|file| {
        let mut question = Question::read(&file).expect("a file");
        question.without_bounds();
        question
    });
    let text = |question: &Question| question.formula::<2>().expect("a formula").to_string();
    assert_eq!(text(&first), text(&second));
    let programs = first.programs(None).expect("a formula");
    let solved = |question: &Question, last| {
        let programs = question.programs(last).expect("a formula");
        question.solve_with(&programs).expect("solved").length
    };
    let [shared, own] = [Some(&programs), None].map(|last| solved(&second, last));
    assert_eq!(shared, own);
    assert_ne!(own, solved(&first, Some(&programs)));
}

/// The caller overrides the file: seven chords, no bounds. With other parameters the question keeps both.
#[test]
fn other_parameters_keep_the_grid_and_the_want_of_bounds() {
    let local = "[solve]\nscope = \"local\"\n";
    let file =
        format!("[parameters]\na = 1\n{GOOD}{local}").replace("\"h(x1, x2)\"", "\"a*h(x1, x2)\"");
    let mut question = Question::read(&file).expect("a file");
    question.set_grid(Grid::Chords(7)).expect("a grid");
    question.without_bounds();
    let other = question.with_parameters(&[("a", 3.0)]).expect("a file");
    let answer = other.solve(&mut |_| ()).expect("solved");
    assert_eq!((answer.n, answer.bounds, answer.no_bounds), (7, None, None));
}

/// Three axes are those of a volume only if the file is no picture.
#[test]
fn a_picture_with_colours_needs_a_component() {
    let mut picture = Vec::new();
    let mut encoder = png::Encoder::new(&mut picture, 2, 3);
    encoder.set_color(png::ColorType::Rgb);
    let mut writer = encoder.write_header().expect("a header");
    writer.write_image_data(&(0..18).collect::<Vec<u8>>()).expect("data");
    writer.finish().expect("an end");
    let file = GOOD.replace("values = [[1, 2.5], [3, 4], [2, 1]]", "file = \"h.png\"");
    let refused = Question::read_with(&file, &mut |_| Ok(picture.clone())).expect_err("colours");
    assert_eq!(refused.message, "h.png: the pixels have 3 numbers each");
    assert!(refused.help.is_some_and(|help| help.contains("component = [1]")));
    let green = file.replace("png\"", "png\"\ncomponent = [2]");
    let values = vec![1.0, 4.0, 7.0, 10.0, 13.0, 16.0];
    assert_eq!(
        formula(&green, &picture),
        expected(FineSpline::monotone(&[3, 2], values).expect("green"))
    );
}

#[test]
fn each_mistake_in_a_table_is_underlined() {
    let refused = |file: &str, bytes: &[u8]| -> Diagnostic {
        let question = Question::read_with(file, &mut |name| {
            if name == "no.npy" { Err("no such file".to_owned()) } else { Ok(bytes.to_vec()) }
        });
        let formula = question.and_then(|question| question.formula::<2>());
        formula.expect_err(file)
    };
    let wrong_type = npy("(3, 2, 1, 1)", &[0; 6]);
    let values = "values = [[1, 2.5], [3, 4], [2, 1]]";
    for (from, to, underlined, says) in [
        (values, "", "h", "a table without numbers"),
        ("[3, 4]", "[3]", "[[1, 2.5], [3], [2, 1]]", "rows of different lengths"),
        ("[3, 4]", "3", "[[1, 2.5], 3, [2, 1]]", "rows of different lengths"),
        ("[[1, 2.5], [3, 4], [2, 1]]", "7", "7", "has 0 axes"),
        ("[[1, 2.5], [3, 4], [2, 1]]", "[]", "[]", "axis 0 of the shape [0] has no coefficient"),
        ("[[1, 2.5], [3, 4], [2, 1]]", "[[[[1]]]]", "[[[[1]]]]", "has 4 axes"),
        ("[3, 4]", "[3, nan]", "[[1, 2.5], [3, nan], [2, 1]]", "the number at [1, 1] is NaN"),
        ("[3, 4]", "[3, \"4\"]", "\"4\"", "expected numbers in brackets"),
        (values, "valeus = [1]", "valeus", "unknown key valeus"),
        ("values", "file = \"h.npy\"\nvalues", "\"h.npy\"", "a file besides values"),
        (values, "file = \"no.npy\"", "\"no.npy\"", "no.npy: no such file"),
        (values, "file = \"h.npy\"", "\"h.npy\"", "the shape [3, 2, 1, 1] has 4 axes"),
        (values, "file = \"h.npy\"\ncomponent = [1, 2]", "[1, 2]", "no such entry"),
        (values, "file = \"h.npy\"\ncomponent = [0, 1]", "[0, 1]", "no such entry"),
        ("h(x1, x2)", "h(x1)", "h(x1)", "2"),
        ("h(x1, x2)", "g(x1, x2)", "g", "unknown function g"),
        ("[tables.h]", "[tables.sin]", "sin", "sin is already defined"),
        ("[tables.h]", "[parameters]\nh = 1\n[tables.h]", "h", "h is already defined"),
        ("[metric]", "[let]\nh = 1\n[metric]", "h", "h is already defined"),
    ] {
        let file = GOOD.replace(from, to);
        let diagnostic = refused(&file, &wrong_type);
        let at = file.get(diagnostic.at.clone()).expect("a place");
        let said = format!("{diagnostic}");
        assert!(at.contains(underlined) && said.contains(says), "{file}\n{at:?}: {said}");
        assert!(at.len() <= underlined.len() + 8, "{file}\n{at:?} is more than {underlined:?}");
    }
    let no_numbers = refused(&GOOD.replace(values, "file = \"h.csv\""), b"1,2\n3,4\n");
    assert_eq!(no_numbers.message, "h.csv: this is neither a NPY nor a PNG file");
}

/// Where no other files are read, a file that names one is refused.
#[test]
fn a_table_elsewhere_needs_to_be_opened() {
    let file = GOOD.replace("values = [[1, 2.5], [3, 4], [2, 1]]", "file = \"h.npy\"");
    let error = Question::read(&file).expect_err("a table elsewhere");
    assert_eq!(&file[error.at.clone()], "\"h.npy\"");
    assert!(error.message.contains("which is not read here"), "{error}");
}
