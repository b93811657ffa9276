//! Metrics written as several texts.

use nalgebra::vector;
use tautline_formula::{Form, Formula, Part, Problem, Weight, Written, WrittenError, number};
use tautline_metrics::{Metric, gallery};

fn part(id: usize, text: &str) -> Part<'_> {
    Part { text, id }
}

fn parts<'a>(texts: &[&'a str]) -> Vec<Part<'a>> {
    texts.iter().enumerate().map(|(id, text)| part(id, text)).collect()
}

#[track_caller]
fn assert_is<const D: usize>(written: &Written<'_>, text: &str) {
    let composed = Formula::<D>::compose(&[("a", 0.5)], &[], &[], written);
    assert_eq!(composed, Ok(Formula::parse(text, &[("a", 0.5)]).expect(text)), "{text}");
}

#[test]
fn each_way_of_writing_records_the_tape_of_one_text() {
    let rows = |rows: &[&[&'static str]]| rows.iter().map(|row| parts(row)).collect();
    assert_is::<2>(
        &Written::Matrix(rows(&[&["1 + a", "sin(x1)"], &["sin(x1)", "3"]])),
        "[1 + a, sin(x1); sin(x1), 3]",
    );
    assert_is::<2>(
        &Written::Upper(rows(&[&["1 + a", "sin(x1)"], &["3"]])),
        "[1 + a, sin(x1); sin(x1), 3]",
    );
    for (form, functions, text) in [
        (Form::Diag, &["1 + x1^2", "2"][..], "diag(1 + x1^2, 2)"),
        (Form::Phi, &["2 + cos(x2)"], "phi(2 + cos(x2))"),
        (Form::Cost, &["2 + cos(x2)"], "cost(2 + cos(x2))"),
        (Form::Speed, &["2 + cos(x2)"], "speed(2 + cos(x2))"),
        (Form::Graph, &["a*sin(x1)"], "graph(a*sin(x1))"),
        (Form::Pullback, &["x1", "x2 + a*x1", "x1*x2"], "pullback(x1, x2 + a*x1, x1*x2)"),
    ] {
        assert_is::<2>(&Written::Form(form, parts(functions)), text);
    }
    assert_is::<2>(&Written::Whole(part(0, "c = cos(x1); c I")), "cos(x1) I");
    let sum = [Form::Phi, Form::Diag].map(|form| {
        let functions: &[&str] = if form == Form::Phi { &["2"] } else { &["x1^2", "x2^2"] };
        Written::Form(form, parts(functions))
    });
    let h = Formula::<2>::compose(&[], &[], &[], &Written::Sum(sum.to_vec())).expect("a metric");
    assert_eq!(h.gram(&vector![0.5, -3.0]), nalgebra::matrix![2.25, 0.0; 0.0, 11.0]);
    let scaled = Written::Scaled(part(0, "exp(x1)"), Box::new(Written::Whole(part(1, "2 I"))));
    let h =
        Formula::<2>::compose(&[], &[], &[], &scaled).expect("a metric").gram(&vector![0.5, 0.0]);
    assert_eq!(h, (2.0 * 0.5_f64.exp() * nalgebra::matrix![1.0, 0.0; 0.0, 1.0]));
}

/// No matrix is made symmetric, and neither are blocks.
#[test]
fn each_entry_is_in_its_row_and_column() {
    let rows = |rows: &[&[&'static str]]| rows.iter().map(|row| parts(row)).collect::<Vec<_>>();
    let full = rows(&[&["1", "2", "3"], &["4", "x1", "6"], &["7", "8", "x2"]]);
    assert_is::<3>(&Written::Matrix(full), "[1, 2, 3; 4, x1, 6; 7, 8, x2]");
    let upper = rows(&[&["1", "2", "3", "4"], &["5", "x1", "6"], &["7", "8"], &["9"]]);
    let text = "[1, 2, 3, 4; 2, 5, x1, 6; 3, x1, 7, 8; 4, 6, 8, 9]";
    assert_is::<4>(&Written::Upper(upper), text);
    let block = Written::Matrix(rows(&[&["1", "x4"], &["3", "4"]]));
    let rest = Written::Matrix(rows(&[&["5", "6"], &["x1", "8"]]));
    let product = Written::Product(vec![(vec![2, 0], block), (vec![1, 3], rest)]);
    let h = Formula::<4>::compose(&[], &[], &[], &product).expect("a metric");
    let expected = nalgebra::matrix![
        4.0, 0.0, 3.0, 0.0;
        0.0, 5.0, 0.0, 6.0;
        2.5, 0.0, 1.0, 0.0;
        0.0, 0.5, 0.0, 8.0
    ];
    assert_eq!(h.gram(&vector![0.5, 1.5, -1.0, 2.5]), expected);
    let recorded = Written::Recorded(h.clone().into_any());
    let again = Formula::<4>::compose(&[], &[], &[], &recorded).expect("a metric");
    assert_eq!(again.gram(&vector![0.5, 1.5, -1.0, 2.5]), expected);
}

/// The texts of a block read all coordinates, but its rows and derivatives are those of the block.
#[test]
fn a_product_has_its_blocks_on_the_diagonal() {
    let graph = Written::Form(Form::Graph, vec![part(0, "x1*x2*x3")]);
    let line = Written::Form(Form::Phi, vec![part(1, "2 + sin(x1)")]);
    let product = Written::Product(vec![(vec![2, 0], graph), (vec![1], line)]);
    let x = vector![0.3, 0.7, -1.1];
    let h = Formula::<3>::compose(&[], &[], &[], &product).expect("a metric").gram(&x);
    let (by_1, by_3) = (x[1] * x[2], x[0] * x[1]);
    let expected = nalgebra::matrix![
        1.0 + by_1 * by_1, 0.0, by_1 * by_3;
        0.0, 2.0 + x[0].sin(), 0.0;
        by_1 * by_3, 0.0, 1.0 + by_3 * by_3];
    assert!((h - expected).amax() < 1e-15, "{h}");
}

/// A block need not be symmetric: entries keep their side of the diagonal, in a matrix and in a recorded
/// formula, and under a sum and a factor.
#[test]
fn a_block_of_a_product_is_not_transposed() {
    let text = "[2, x1; x2, 3]";
    let recorded = Written::Recorded(Formula::<2>::parse(text, &[]).expect(text).into_any());
    let whole = Written::Whole(part(0, "[2, x3; x1, 3]"));
    let matrix = Written::Matrix(vec![parts(&["2", "x3"]), parts(&["x1", "3"])]);
    let x = vector![0.1, 0.2, 0.3];
    let line = || (vec![1], Written::Form(Form::Phi, vec![part(0, "5")]));
    let gram = |block: &Written<'static>| {
        let product = Written::Product(vec![(vec![2, 0], block.clone()), line()]);
        Formula::<3>::compose(&[], &[], &[], &product).expect("a metric").gram(&x)
    };
    // The rows and columns of the block are x₃ and x₁, in this order. A recorded formula calls the
    // coordinates of its block x₁ and x₂.
    let expected = nalgebra::matrix![3.0, 0.0, 0.1; 0.0, 5.0, 0.0; 0.3, 0.0, 2.0];
    for block in [&recorded, &whole, &matrix] {
        assert_eq!(gram(block), expected, "{block:?}");
    }
    let twice = Written::Scaled(part(0, "2"), Box::new(matrix.clone()));
    let thrice = gram(&Written::Sum(vec![matrix, twice]));
    assert!((thrice[(2, 0)] - 0.9).abs() < 1e-15 && (thrice[(0, 2)] - 0.3).abs() < 1e-15);
}

#[test]
fn a_recorded_formula_is_a_block_with_the_same_bits() {
    let shear = gallery::Shear::new(0.7, 1.3).expect("a wave number");
    let recorded = Formula::<2>::record(&shear).expect("recorded");
    let recorded = Written::Recorded(recorded.clone().into_any());
    let alone = Formula::<2>::compose(&[], &[], &[], &recorded).expect("a metric");
    assert_eq!(Ok(alone), Formula::record(&shear));
    let line = Written::Form(Form::Phi, vec![part(0, "x2^2 + 1")]);
    let product = Written::Product(vec![(vec![1], line), (vec![2, 0], recorded.clone())]);
    let h = Formula::<3>::compose(&[], &[], &[], &product)
        .expect("a metric")
        .gram(&vector![0.1, 0.2, 0.3]);
    let block = shear.gram(&vector![0.3, 0.1]);
    assert_eq!([h[(2, 2)], h[(2, 0)], h[(0, 0)]], [block[(0, 0)], block[(0, 1)], block[(1, 1)]]);
    let refused = Formula::<3>::compose(&[], &[], &[], &recorded).expect_err("two coordinates");
    assert!(matches!(refused.error.problem, Problem::Shape { found: 2, dimension: 3, .. }));
}

#[test]
fn definitions_use_those_before_them() {
    let definitions = [[part(0, "f"), part(1, "a + x1")], [part(2, "g"), part(3, "f^2")]];
    let metric = Written::Form(Form::Phi, vec![part(4, "g")]);
    let composed = Formula::<1>::compose(&[("a", 3.0)], &[], &definitions, &metric);
    assert_eq!(composed, Ok(Formula::parse("(3 + x1)^2 I", &[]).expect("a formula")));
    // The definitions of a whole text are not those of the next one.
    let whole = |id| Written::Whole(part(id, "own = 1 + x1^2; own I"));
    let sum = Written::Sum(vec![whole(4), whole(5)]);
    assert!(Formula::<1>::compose(&[], &[], &[], &sum).is_ok());
}

#[test]
fn an_error_names_the_text_and_the_bytes() {
    let refused = |definitions: &[[Part<'_>; 2]], metric: Written<'_>| {
        let error =
            Formula::<2>::compose(&[("a", 1.0)], &[], definitions, &metric).expect_err("wrong");
        let WrittenError { id, error } = error;
        (id, error.at, error.problem.to_string())
    };
    let phi = |text| Written::Form(Form::Phi, vec![part(7, text)]);
    assert_eq!(refused(&[], phi("1 + y")), (7, 4..5, "unknown name y".into()));
    // An expression cannot close a bracket that it did not open.
    let found = "found ), expected an operator or the end";
    assert_eq!(refused(&[], phi("1) + (2")), (7, 1..2, found.into()));
    assert_eq!(refused(&[], phi("1; [1, 0; 0, 1]")).1, 1..2);
    let taken = [[part(1, "a"), part(2, "3")]];
    assert_eq!(refused(&taken, phi("a")), (1, 0..1, "a is already defined".into()));
    let two_words = [[part(1, "b c"), part(2, "3")]];
    assert_eq!(refused(&two_words, phi("1")).1, 2..3);
    let later = [[part(1, "b"), part(2, "c + 1")], [part(3, "c"), part(4, "1")]];
    assert_eq!(refused(&later, phi("b")), (2, 0..1, "unknown name c".into()));
    let diag = Written::Form(Form::Diag, vec![part(3, "1")]);
    let says = "diag takes 2 functions in dimension 2, found 1";
    assert_eq!(refused(&[], diag), (3, 0..0, says.into()));
    for rows in [vec![parts(&["1", "0"])], vec![parts(&["1", "0"]), parts(&["0"])]] {
        assert!(refused(&[], Written::Matrix(rows)).2.contains("in dimension 2"));
    }
    let long = Written::Upper(vec![parts(&["1", "0"]), parts(&["0", "1"])]);
    assert_eq!(refused(&[], long).2, "2 entries in a row in dimension 2");
    assert_eq!(refused(&[], Written::Sum(Vec::new())).2, "0 terms in dimension 2");
    for blocks in [
        &[vec![0]][..],
        &[vec![0], vec![0]],
        &[vec![0], vec![2]],
        &[vec![0, 1], vec![1]],
        &[vec![0, 0], vec![1]],
    ] {
        let product = blocks.iter().map(|block| (block.clone(), phi("1"))).collect();
        assert!(refused(&[], Written::Product(product)).2.contains("of a"), "{blocks:?}");
    }
}

#[test]
fn a_number_is_an_expression_without_coordinates() {
    assert_eq!(number("2*pi/3 + a^2", &[("a", 2.0)]), Ok(2.0 * std::f64::consts::PI / 3.0 + 4.0));
    assert_eq!(number("-exp(0)", &[]), Ok(-1.0));
    for (text, at) in
        [("x1 + 1", 0..2), ("1 + b", 4..5), ("number(2)", 0..9), ("", 0..0), ("1 2", 2..3)]
    {
        assert_eq!(number(text, &[]).expect_err(text).at, at, "{text}");
    }
}

/// A recorded function is its first entry, at all coordinates.
#[test]
fn a_weight_of_a_recorded_function_is_that_of_its_text() {
    let compose = |weight| {
        let metric = Box::new(Written::Whole(part(0, "(2 + x2) I")));
        let weighted = Written::Weighted(vec![weight], part(1, "1 + u1^2"), metric);
        Formula::<2>::compose(&[], &[], &[], &weighted)
    };
    let of = |text| Formula::parse_in(2, text, &[], &[]).expect("a formula");
    let [text, recorded] = [Weight::Text(part(2, "x1*x2")), Weight::Recorded(of("x1*x2 I"))]
        .map(|weight| compose(weight).expect("a metric").gram(&vector![1.5, -0.7]));
    assert_eq!(text, recorded);
    let line = Formula::parse_in(1, "x1 I", &[], &[]).expect("a formula");
    let refused = compose(Weight::Recorded(line)).expect_err("another dimension");
    assert!(matches!(refused.error.problem, Problem::Shape { found: 1, dimension: 2, .. }));
}

/// The values of a weight are named for the weight alone, which knows no other name.
#[test]
fn a_weight_has_names_of_its_own() {
    let compose = |weight: &'static str, value: &'static str, metric: &'static str| {
        let metric = Box::new(Written::Whole(part(3, metric)));
        let values = vec![Weight::Text(part(0, "2 + x1")), Weight::Text(part(1, value))];
        let definitions = [[part(4, "u1"), part(5, "7*x2")]];
        let weighted = Written::Weighted(values, part(2, weight), metric);
        Formula::<2>::compose(&[("a", 0.5)], &[], &definitions, &weighted)
    };
    let found = compose("1 + u1*u2", "a + u1", "u1 I").expect("a metric");
    // 1 + (2 + x1)(1/2 + 7 x2) with x = (1, 2), times 14.
    assert_eq!(found.gram(&vector![1.0, 2.0])[(0, 0)], (1.0 + 3.0 * 14.5) * 14.0);
    let name = |id: usize, name: &str| {
        let problem = Problem::UnknownName { name: name.to_owned() };
        (id, problem)
    };
    for (weight, value, metric, expected) in [
        ("u1", "1", "u2 I", name(3, "u2")),
        ("u1", "u2", "1 I", name(1, "u2")),
        ("u1 + a", "1", "1 I", name(2, "a")),
    ] {
        let WrittenError { id, error } = compose(weight, value, metric).expect_err("unknown");
        assert_eq!((id, error.problem), expected);
    }
}

/// `f² I` and `f⁻² I` do not show the sign of `f`. What is no form is not one because of a name.
#[test]
fn the_function_of_a_cost_or_a_speed_is_found() {
    let squared = |text: &'static str| {
        let definitions = [[part(1, "g"), part(2, "a - x1")]];
        Formula::<2>::squared_in(&[("a", 0.5)], &[], &definitions, part(0, text)).expect(text)
    };
    for (text, form, function) in [
        ("cost(-2 - cos(x1))", Form::Cost, "-2 - cos(x1)"),
        ("speed(g)", Form::Speed, "0.5 - x1"),
        ("f = -x2; h = 2*f; cost(h)", Form::Cost, "2*(-x2)"),
        ("phi = x1; cost(phi)", Form::Cost, "x1"),
        ("cost(-3)", Form::Cost, "-3"),
    ] {
        let expected = Formula::parse(&format!("phi({function})"), &[]).expect(function);
        assert_eq!(squared(text), Some((form, expected)), "{text}");
    }
    for text in ["phi(g)", "(-2 - x1)^2 I", "cost = 2; cost I", "[1, 0; 0, 1]", "diag(1, 2)"] {
        assert_eq!(squared(text), None, "{text}");
    }
    let error = Formula::<1>::squared_in(&[], &[], &[], part(6, "cost(y)")).expect_err("unknown");
    assert_eq!((error.id, error.error.at), (6, 5..6));
}
