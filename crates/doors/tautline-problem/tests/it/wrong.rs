//! What is said of wrong files, and where.

use tautline_problem::{Diagnostic, Failure, Question};

const GOOD: &str = "\
[parameters]
a = 2
[let]
f = \"a - cos(x1)\"
[metric]
matrix = [[\"f\", 0], [0, \"f\"]]
[from]
ball = { centre = [0, 0], radius = 0.5 }
[to]
half_space = { normal = [1, 0], at_least = 3 }
";

/// Returns what is wrong with a file.
#[track_caller]
fn refused(file: &str) -> Diagnostic {
    let solved = Question::read(file).map_err(Failure::from).and_then(|q| q.solve(&mut |_| ()));
    match solved {
        Err(Failure::BadInput(diagnostic)) => diagnostic,
        other => panic!("{file}\n{other:?}"),
    }
}

/// TOML reads `1e-400` as 0, which is another number. Zeros are zeros however they are written.
#[test]
fn a_number_that_doubles_cannot_hold_is_refused_and_not_read_as_zero() {
    for (from, number, to) in [
        ("a = 2", "1e-400", "a = 1e-400"),
        ("[[\"f\", 0], [0", "-0.000_1E-330", "[[\"f\", -0.000_1E-330], [0"),
        ("centre = [0, 0]", "3.5e-324_0", "centre = [0, 3.5e-324_0]"),
        ("radius = 0.5", "4.9e-325", "radius = 4.9e-325"),
    ] {
        let file = GOOD.replacen(from, to, 1);
        let diagnostic = refused(&file);
        assert_eq!(diagnostic.message, "this number is too small for a double", "{to}");
        assert_eq!(&file[diagnostic.at], number, "{to}");
    }
    for zero in ["0e-400", "0.0", "-0.0e5", "5e-324"] {
        let file = GOOD.replacen("centre = [0, 0]", &format!("centre = [0, {zero}]"), 1);
        assert!(Question::read(&file).is_ok(), "{zero}");
    }
}

#[test]
fn each_mistake_is_underlined() {
    assert!(Question::read(GOOD).is_ok_and(|question| question.solve(&mut |_| ()).is_ok()));
    // What is replaced by what, the underlined text, and a part of what is said.
    for (from, to, underlined, says) in [
        ("cos(x1)", "cos(x1", "", "found the end in an expression: expected an operator or )"),
        ("cos(x1)", "cosh(x1) +", "", "found the end"),
        ("cos(x1)", "cos(x3)", "x3", "there is no x3 in dimension 2"),
        ("cos(x1)", "cso(x1)", "cso", "unknown function cso"),
        ("a - cos", "b - cos", "b", "unknown name b"),
        ("cos(x1)", "x1^0.5", "0.5", "an exponent must be an integer"),
        ("f = \"a", "pi = \"a", "pi", "pi is already defined"),
        ("f = \"a", "a = \"a", "a", "a is already defined"),
        ("f = \"a", "f = \"f", "f", "unknown name f"),
        ("a = 2", "a = \"2*b\"", "b", "unknown name b"),
        ("a = 2", "a = \"1/0\"", "\"1/0\"", "1/0 is inf: expected a finite number"),
        ("a = 2", "a = nan", "nan", "finite"),
        ("a = 2", "x1 = 2", "x1", "x1 is already defined"),
        ("\"f\", 0]", "\"f\"]", "[\"f\"]", "1 entry here: expected 2 entries"),
        ("[0, \"f\"]]", "]", "[[\"f\", 0], ]", "1 row here: expected 2 rows"),
        ("matrix", "upper", "[0, \"f\"]", "2 entries here: expected 1 entry"),
        ("matrix = [[\"f\", 0], [0, \"f\"]]", "diag = [\"f\"]", "[\"f\"]", "1 entry here"),
        ("matrix = [[\"f\", 0], [0, \"f\"]]", "pullback = [\"f\"]", "[\"f\"]", "1 function here"),
        ("matrix = [[\"f\", 0], [0, \"f\"]]", "sum = []", "[]", "a sum of no metrics"),
        ("matrix", "matrx", "matrx", "unknown key matrx"),
        ("matrix = [[\"f\", 0], [0, \"f\"]]", "", "[metric]", "no key says what this is"),
        ("[to]", "[metric.gallery]\n[to]", "", "several keys say what this is"),
        ("[0, \"f\"]]", "[0, \"f\"]]\nphi = 1", "[metric]", "matrix and phi say what this is"),
        (
            "{ normal = [1, 0], at_least = 3 }",
            "{ normal = [1, 0], at_least = 3 }\nempty = { point = [0, 0] }",
            "[to]",
            "empty and half_space say what this is",
        ),
        ("radius = 0.5", "radius = -0.5", "-0.5", "radius -0.5 must be ≥ 0"),
        (", radius = 0.5", "", "{ centre = [0, 0] }", "radius is missing"),
        ("[0, 0], radius", "[0], radius", "[1, 0]", "2 coordinates in dimension 1"),
        ("normal = [1, 0]", "normal = [0, 0]", "[0, 0]", "normal of a half-space must not be 0"),
        (", at_least = 3", "", "[1, 0]", "a half-space needs at_least or at_most"),
        ("at_least = 3", "at_least = 3, at_most = 4", "4", "a half-space has one side"),
        ("[to]\nhalf_space = { normal = [1, 0], at_least = 3 }", "", "", "[to] is missing"),
        ("[to]", "[solve]\nn = 0\n[to]", "0", "no chord"),
        ("[to]", "[solve]\nn = 9\ntolerance = 0.1\n[to]", "0.1", "a tolerance besides n"),
        ("[to]", "[solve]\ntolerance = 2\n[to]", "2", "2 is out of range"),
        ("[to]", "[solve]\nstarts = [[[0, 0]]]\n[to]", "[[0, 0]]", "a start of 1 point"),
        ("[to]", "[output]\ncoordinates = [1, 3]\n[to]", "[1, 3]", "no such plane"),
        ("[to]", "[certify]\nwithin = { point = [0, 0] }\n[to]", "", "in a ball or in a box"),
        ("[parameters]", "dimension = 257\n[parameters]", "257", "dimension 257"),
        ("[parameters]", "dimension = 3\n[parameters]", "[0, 0]", "2 coordinates in dimension 3"),
        ("[0, \"f\"]", "[1, \"f\"]", "", "symmetric"),
        ("\"a - cos", "\"-a - cos", "", "not positive definite"),
        ("\"a - cos", "\"ln(x1 - 9) - cos", "[[\"f\", 0], [0, \"f\"]]", "in row 1, column 1"),
        ("a = 2", "a = \"x1\"", "x1", "x1 in a number"),
        ("[0, 0], radius", "0, radius", "0", "found 0: expected a list in brackets"),
        ("[to]", "[solve]\nn = -5\n[to]", "-5", "found -5: expected a whole number"),
        ("[to]", "[solve]\nn = 1000000000000\n[to]", "1000000000000", "expected n of at most"),
        ("[to]", "[solve]\ntolerance = 1e-20\n[to]", "1e-20", "is out of range"),
        (
            "[from]\nball = { centre = [0, 0], radius = 0.5 }",
            "[from]\nball = \"x\"",
            "\"x\"",
            "expected keys and values in braces",
        ),
        (
            "matrix = [[\"f\", 0], [0, \"f\"]]",
            "sum = [{ phi = 1 }, { phi = \"f\", graph = \"f\" }]",
            "{ phi = \"f\", graph = \"f\" }",
            "graph and phi say what this is",
        ),
    ] {
        assert!(GOOD.contains(from), "{from}");
        let file = GOOD.replacen(from, to, 1);
        let diagnostic = refused(&file);
        assert!(diagnostic.to_string().contains(says), "{to}: {diagnostic}");
        let at = diagnostic.at.clone();
        assert!(underlined.is_empty() || file[at] == *underlined, "{to}: {diagnostic:?}");
        assert!(diagnostic.render("problem.toml", &file, false).contains("problem.toml"));
    }
}

/// The end of a text is no factor.
#[test]
fn what_is_missing_at_the_end_is_no_product() {
    let diagnostic = refused(&GOOD.replacen("cos(x1)", "cos(2*x1", 1));
    assert_eq!(
        (diagnostic.message.as_str(), diagnostic.help),
        ("found the end in an expression", None)
    );
}

/// The end of an expression is the place of what is missing.
#[test]
fn the_message_shows_the_line() {
    let file = GOOD.replacen("cos(x1)", "cso(x1)", 1);
    let expected = "\
error: unknown function cso
 --> problem.toml:4:10
  |
4 | f = \"a - cso(x1)\"
  |          ^^^
  |
  = help: did you mean cos?";
    assert_eq!(refused(&file).render("problem.toml", &file, false), expected);
}

#[test]
fn what_was_meant_is_said() {
    for (from, to, help) in [
        ("centre", "center", "did you mean centre?"),
        ("half_space", "halfspace", "did you mean half_space?"),
        ("[from]", "[form]", "did you mean from?"),
        ("a - cos", "abs(x2) - cos", "sqrt(u^2 + e^2)"),
        ("cos(x1)", "cos(x)", "x1, x2 and so on"),
        ("cos(x1)", "x1^0.5", "sqrt(u)"),
        ("a - cos", "beta - cos", "[parameters]"),
        ("[to]", "[solve]\nrule = \"left\"\n[to]", "left_endpoint"),
        ("[to]", "[solve]\nrule = \"simpsons\"\n[to]", "did you mean simpson?"),
        ("[to]", "[solve]\nrule = \"midpoint\"\n[to]", "most books call trapezoidal"),
        ("a - cos", "log(a) - cos", "the natural logarithm is ln"),
        ("a - cos", "max(a, x1) - cos", "a metric must be smooth"),
        ("a - cos", "frobnicate(a) - cos", "the functions are sqr"),
        ("a - cos", "2x1 - cos", "a product has a sign"),
        ("a - cos", "a − cos", "the minus of a formula is -"),
        ("a = 2", "a = \"x1\"", "belongs in [metric] or in [let]"),
        ("f = \"a - cos(x1)\"", "f = a - cos(x1)", "an expression stands in quotes"),
        ("a - cos(x1)", "a - cos", "a function has parentheses, such as cos(x1)"),
        ("f = \"a - cos(x1)\"", "f = \"g\"\ng = \"f\"", "g is not defined before this"),
        ("cos(x1)", "cos(X1)", "did you mean x1?"),
        ("f = \"a - cos(x1)\"", "h = \"x1\"\nf = \"h(x1)\"", "a product has a sign"),
        ("[parameters]", "n = 12\n[parameters]", "n belongs in [solve]"),
        ("a - cos", "2 x1 - cos", "a product has a sign"),
        ("a - cos", "a x1 - cos", "a product has a sign"),
        ("a - cos", "(a - 1)(x1 + 2) - cos", "a product has a sign"),
        ("[0, \"f\"]]", "[0, \"f\"]]\nfrom = { point = [0, 0] }", "belong above [metric]"),
    ] {
        let diagnostic = refused(&GOOD.replacen(from, to, 1));
        let said = format!("{diagnostic} {}", diagnostic.help.clone().unwrap_or_default());
        assert!(said.contains(help), "{to}: {diagnostic:?}");
    }
}

#[test]
fn blocks_of_a_product_share_the_coordinates() {
    let with = |blocks: &str| {
        format!(
            "dimension = 3\n[metric]\nproduct = [{blocks}]\n[from]\npoint = [0, 0, 0]\n[to]\npoint = [1, 1, 1]"
        )
    };
    let block =
        |coordinates: &str| format!("{{ coordinates = {coordinates}, metric = {{ phi = 2 }} }}");
    let good = with(&[block("[3, 1]"), block("[2]")].join(","));
    assert!(Question::read(&good).is_ok_and(|question| question.formula::<3>().is_ok()));
    for (blocks, says) in [
        (vec!["[1]", "[2]"], "coordinate 3 belongs to no block"),
        (vec!["[1, 2]", "[2, 3]"], "coordinate 2 belongs to two blocks"),
        (vec!["[1, 4]", "[2, 3]"], "there is no coordinate 4 here"),
        (vec!["[1, 2, 3]", "[]"], "a block without coordinates"),
    ] {
        let file = with(&blocks.iter().map(|own| block(own)).collect::<Vec<_>>().join(","));
        assert_eq!(refused(&file).message, says);
    }
}

/// The metric is the square, which does not show the sign.
#[test]
fn a_cost_or_a_speed_that_is_negative_on_the_curve_is_refused() {
    let file = |metric: &str| {
        format!(
            "[metric]\n{metric}\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n[solve]\nn = 64\n"
        )
    };
    for (metric, says) in [
        ("cost = \"1 - x1\"", "the cost is -2 at [3.0, 1.0]"),
        ("speed = \"1 - 2*exp(-(x1 - 3)^2)\"", "the speed is -1 at [3.0, 1.0]"),
        ("sum = [{ phi = 1 }, { cost = \"1 - x1\" }]", "the cost is -2 at [3.0, 1.0]"),
        ("scaled = { by = 2, metric = { cost = \"1 - x1\" } }", "the cost is -2 at [3.0, 1.0]"),
        (
            "product = [{ coordinates = [1], metric = { phi = 1 } }, \
             { coordinates = [2], metric = { cost = \"x2 - 2\" } }]",
            "the cost is -2 at [0.0, 0.0]",
        ),
        // One chord, whose ends are right.
        ("cost = \"(x1 - 1.5)^2 - 1\"", "the cost is -1 at [1.5, 0.5]"),
    ] {
        let n = if metric.contains("- 1.5") { "n = 1" } else { "n = 64" };
        let file = file(metric).replace("n = 64", n);
        let diagnostic = refused(&file);
        assert!(diagnostic.message.starts_with(says), "{diagnostic}");
        assert!(file[diagnostic.at].starts_with('"'));
    }
    // In a sum a cost may vanish.
    let sum = file("sum = [{ phi = 1 }, { cost = \"x1\" }]");
    assert!(Question::read(&sum).is_ok_and(|question| question.solve(&mut |_| ()).is_ok()));
    // The same metric, whose formula does not claim to be a cost.
    let square = file("phi = \"(4 - x1)^2\"");
    assert!(Question::read(&square).is_ok_and(|question| question.solve(&mut |_| ()).is_ok()));
}

/// `H = (2 − cos x₁)² I` is `I` at the first end, and 8.94 at the second.
#[test]
fn claims_that_fail_on_the_curve_are_refused() {
    let answer = |c1: f64, c2: f64| {
        let file = format!(
            "[metric]\ncost = \"2 - cos(x1)\"\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n\
             [certify.constants]\nc1 = {c1}\nc2 = {c2}\nl_h = 4.5\nm_h = 6\n"
        );
        let question = Question::read(&file).expect("a problem");
        question.solve(&mut |_| ()).expect("solved").no_bounds
    };
    assert_eq!(answer(1.0, 9.0), None);
    // H is I at the first end, so that c1 = 1 is attained; H = 4 I attains both.
    let constant = "[metric]\nphi = 4\n[from]\npoint = [0, 0]\n[to]\npoint = [3, 1]\n\
                    [certify.constants]\nc1 = 4\nc2 = 4\nl_h = 0\nm_h = 0\n";
    let constant = Question::read(constant).expect("a problem").solve(&mut |_| ());
    assert_eq!(constant.expect("solved").no_bounds, None);
    let why = answer(1.0, 8.0).expect("a reason");
    // The first point of the curve at which H exceeds 8.
    assert!(why.contains("c2 = 8 is wrong") && why.contains("a larger eigenvalue"), "{why}");
    let why = answer(1.01, 9.0).expect("a reason");
    assert!(why.contains("c1 = 1.01 is wrong: H([0.0, 0.0]) has a smaller eigenvalue"), "{why}");
}
