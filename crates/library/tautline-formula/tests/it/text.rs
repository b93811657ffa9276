//! A text gives the same formula as the corresponding Rust code.

use std::{f64::consts::PI, hint::black_box};

use nalgebra::{SMatrix, SVector, matrix, vector};
use tautline_chance::seed;
use tautline_formula::{Form, Formula, Number, Operation, Part, Problem, RecordError, Written};
use tautline_metrics::{Metric, Scalar, gallery};
use tautline_scalar::{Interval, Jet1};

use crate::random::Random;

#[test]
fn a_text_records_the_same_tape_as_rust() {
    struct Sheet(f64);
    impl Metric<2> for Sheet {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let wave = 2.0 - self.0 * x[0].cos();
            let well = 1.0 + 3.0 / (1.0 + x[1].powi(2)) - -x[0] / 4.0;
            let off = 0.5 * x[0].sin() * x[1].exp();
            matrix![wave.sqr(), off; off, well * 2.0 * x[1].powi(-2)]
        }
    }
    let text = "wave = 2 - height*cos(x1);
        well = 1 + 3/(1 + x2^2) - -x1/4;
        off = 0.5*sin(x1)*exp(x2);
        [sqr(wave), off; off, well*2*x2**-2]";
    let typed = Formula::<2>::parse(text, &[("height", 0.9)]).expect("a formula");
    assert_eq!(Ok(typed), Formula::record(&Sheet(0.9)));
}

/// A matrix need not be symmetric, and is not made so.
#[test]
fn a_matrix_is_written_row_by_row() {
    let text = "[1, x1, 3; 4, x2, 6; x3, 8, 9]";
    let formula = Formula::<3>::parse(text, &[]).expect("a formula");
    let rows = matrix![1.0, -0.5, 3.0; 4.0, 0.25, 6.0; 7.0, 8.0, 9.0];
    assert_eq!(formula.gram(&vector![-0.5, 0.25, 7.0]), rows);
    let printed = formula.to_string();
    let again = Formula::<3>::parse(&printed, &[]).expect("a formula");
    assert_eq!(again.gram(&vector![-0.5, 0.25, 7.0]), rows, "{printed}");
    assert_eq!(Formula::record(&formula).as_ref(), Ok(&formula));
    assert_eq!((formula.entry(0, 1), formula.entry(2, 0)), (0, 2));
    let upper = matrix![1.0, -0.5, 3.0; -0.5, 0.25, 6.0; 3.0, 6.0, 9.0];
    assert_eq!(formula.of_upper_half().gram(&vector![-0.5, 0.25, 7.0]), upper);
}

#[test]
fn arithmetic_between_numbers_gives_numbers() {
    let of = |text: &str| Formula::<1>::parse(text, &[]).expect("a formula");
    assert_eq!(of("[(1 + 2)*3^2/sqrt(4) - 0.5 + x1]"), of("[13 + x1]"));
    assert_eq!(of("[2^-1*x1]"), of("[0.5*x1]"));
    assert_eq!(of("a = 2*pi; [a*x1]"), of("[6.283185307179586*x1]"));
    assert_eq!(of("1e-3 I"), of("[.001]"));
    // A number that is a step remains a step.
    assert_ne!(of("[number(2)*x1]"), of("[2*x1]"));
}

/// Powers bind more tightly than signs, products more tightly than sums, and operators associate to
/// the left.
#[test]
fn operators_bind_as_in_mathematics() {
    for (text, expected) in [
        ("-x1^2", Some(-9.0)),
        ("(-x1)^2", Some(9.0)),
        ("x1 - x2 - 1", Some(-3.0)),
        ("x1/x2/2", Some(0.3)),
        ("x1 + x2*2", Some(13.0)),
        ("2*-x1", Some(-6.0)),
        ("--x1", Some(3.0)),
        ("x1 - -x2", Some(8.0)),
        ("16/x1^2^1", None),
    ] {
        let formula = Formula::<2>::parse(&format!("{text} I"), &[]).ok();
        let value = formula.map(|formula| formula.gram(&vector![3.0, 5.0])[(0, 0)]);
        assert_eq!(value, expected, "{text}");
    }
}

/// Compares each form with a metric of the gallery, at random points.
#[test]
fn forms_are_the_metrics_of_the_gallery() {
    #[track_caller]
    fn check<const D: usize>(text: &str, metric: &impl Metric<D>) {
        let form = Formula::<D>::parse(text, &[]).expect("a formula");
        let mut random = Random(seed(1907));
        for _ in 0..200 {
            let x = SVector::from_fn(|_, _| 0.5 * random.number());
            let (found, expected) = (form.gram(&x), metric.gram(&x));
            // About ten operations on numbers of the size of the entries.
            let off = (found - expected).amax() / expected.amax();
            assert!(off < 2e-14, "{text} at {x:?}: {found} for {expected}");
        }
    }
    let shear = gallery::Shear::new(0.7, 1.3).expect("a wave number");
    check("pullback(x1 + 0.7*sin(1.3*x2), x2)", &shear);
    check(
        "turn = 1.3*exp(-(x1^2 + x2^2)/(2*0.6^2)); s, c = sin_cos(turn);
        pullback(c*x1 - s*x2, s*x1 + c*x2)",
        &gallery::Swirl::new(1.3, 0.6).expect("a width"),
    );
    let hill = gallery::Hill::new(0.7, 0.6).expect("a width");
    check::<2>("graph(0.7*exp(-(x1^2 + x2^2)/(2*0.6^2)))", &hill);
    check::<3>("graph(0.7*exp(-(x1^2 + x2^2 + x3^2)/(2*0.6^2)))", &hill);
    check::<2>("cost(2 - cos(x1))", &gallery::Valleys);
    check::<2>("speed(1/(2 - cos(x1)))", &gallery::Valleys);
    check::<2>("phi((2 - cos(x1))^2)", &gallery::Valleys);
    let separable = gallery::Separable::new([0.3, -0.4], [1.1, 1.7]).expect("below one");
    check("diag((1 + 0.3*sin(1.1*x1))^2, (1 - 0.4*sin(1.7*x2))^2)", &separable);
}

/// Compares each rule of differentiation with jets.
#[test]
fn gradients_agree_with_jets() {
    let functions = "x1 + x2; x1 - x2*x2; x1*x2; x1/(x2^2 + 1); x1*0.3 - x2/7; (x1 + 3)^-3*x2; \
        (x1*x2)^5; x1^1 + x2^0; -x1*x2; sqr(x1 - x2); recip(x1*x1 + 2)*x2; sqrt(x1^2 + x2^2 + 1); \
        exp(x1*x2/4); ln(x1^2 + 2)*x2; sin(x1*x2); cos(x1 - 2*x2); tan(x1/4)*x2; atan(x1*x2); \
        sinh(x1 - x2); cosh(x1*x2/3); tanh(x1 + x2); 5";
    let pairs = [("sin_cos", "s*x1 + c^2*x2"), ("sinh_cosh", "s*x1/c + c*x2")];
    let of_one = functions.split("; ").map(|f| (String::new(), f.to_owned()));
    let of_pairs = pairs.map(|(pair, f)| (format!("s, c = {pair}(x1*x2 - x1);"), f.to_owned()));
    let mut random = Random(seed(1908));
    for (definitions, f) in of_one.chain(of_pairs) {
        let graph = Formula::<2>::parse(&format!("{definitions} graph({f})"), &[]);
        let itself = Formula::<2>::parse(&format!("{definitions} phi({f})"), &[]);
        let (graph, itself) = (graph.expect("a formula"), itself.expect("a formula"));
        for _ in 0..50 {
            let x = SVector::from_fn(|_, _| 0.375 * random.number());
            let jet = itself.gram(&SVector::from(Jet1::variables(&[x[0], x[1]])))[(0, 0)];
            let g = SVector::from(*jet.gradient());
            let expected = SMatrix::identity() + g * g.transpose();
            let off = (graph.gram(&x) - expected).amax() / expected.amax();
            assert!(off < 1e-14, "{f} at {x:?}: off by {off:e}");
        }
    }
}

#[test]
fn forms_check_their_functions_and_do_not_reserve_their_names() {
    for (text, says) in [
        ("pullback(x1)", "0: pullback takes 2 functions or more in dimension 2, found 1"),
        (" diag(1, 2, x1)", "1: diag takes 2 functions in dimension 2, found 3"),
        ("graph(x1, x2)", "0: graph takes one function in dimension 2, found 2"),
        ("speed(2 x1)", "8: found x1, expected an operator, a comma or )"),
        ("graph(x1) I", "10: found I, expected the end"),
        // An operator is missing.
        ("[2 x1, 0; 0, 1]", "3: found x1, expected an operator, a comma, ; or ]"),
        ("a = 3 exp(x1); a I", "6: found exp, expected an operator or ;"),
    ] {
        let error = Formula::<2>::parse(text, &[]).expect_err(text);
        assert_eq!(error.to_string(), format!("at byte {says}"), "{text}");
    }
    let named = Formula::<2>::parse("phi = 2 - cos(x1); cost(phi)", &[]);
    assert_eq!(named, Formula::parse("graph = 2 - cos(x1); sqr(graph) I", &[]));
}

/// Maps into a space of more dimensions: the sphere, and a helix.
#[test]
fn a_pullback_sums_over_all_functions() {
    let sphere = "s, c = sin_cos(x1); t, d = sin_cos(x2); pullback(s*d, s*t, c)";
    let sphere = Formula::<2>::parse(sphere, &[]).expect("a formula");
    let helix = Formula::<1>::parse("pullback(sin(2*x1), cos(2*x1), x1)", &[]).expect("a formula");
    for x in [0.3, 1.0, -2.0] {
        let expected = matrix![1.0, 0.0; 0.0, f64::sin(x).powi(2)];
        assert!((sphere.gram(&vector![x, 0.7]) - expected).amax() < 1e-15);
        assert!((helix.gram(&vector![x])[(0, 0)] - 5.0).abs() < 2e-15);
    }
}

/// Numbers that are typed or that derivatives bring along are enclosed as they are in real arithmetic, also
/// where `f64` would lose all digits: in a difference, below the smallest number, in a large power.
#[test]
fn arithmetic_that_loses_digits_is_enclosed() {
    // 0.1 is a little more than 1/10: 3 · 0.1 − 0.30000000000000004 is −2⁻⁵⁵.
    let slope = -1e17 * 2.0_f64.powi(-55);
    for (text, expected) in [
        ("(2e16 + 3 - 2e16) I", 3.0),
        ("((1e17 + 1 - 1e17)*2 + 1) I", 3.0),
        ("a = 1e17; b = a + 1; (b - a + 1 + 0*x1) I", 2.0),
        ("(1 + 1e-200*1e-200*1e200*1e200) I", 2.0),
        // By arb: 3.20020505251e248.
        ("1.00000095367431640625^600000001/3.20020505251e248 I", 1.0 + 1e-12),
        ("graph(x1*1e17 + x1 - x1*1e17)", 2.0),
        ("graph(x1*1e-200*1e-200*1e200*1e200)", 2.0),
        ("graph((x1*0.1*3 - x1*0.30000000000000004)*1e17)", 1.0 + slope * slope),
        ("pullback(x1*1e16 + x1 - x1*1e16, x1*0.5)", 1.25),
        // A number that is rounded in its last digit may be all that is left of another one.
        ("graph(x1*(1e16 + 1) - x1*1e16)", 2.0),
        ("a = 1e16 + 1; graph(a*x1 - 1e16*x1)", 2.0),
        ("graph(1e17*(x1*(1 + 1e-17) - x1))", 2.0),
        ("graph(1e17*(x1*(0.1 + 0.2) - x1*0.3))", 1.0 + (1e17 * 2.0_f64.powi(-55)).powi(2)),
        ("cost(2e16 + 3 - 2e16)", 9.0),
    ] {
        let formula =
            Formula::<1>::parse(text, &[]).unwrap_or_else(|error| panic!("{text}: {error}"));
        let h = formula.gram(&vector![Interval::point(0.5)])[(0, 0)];
        // The expected numbers are rounded, too.
        assert!(
            h.lo() <= expected * (1.0 + 4e-16) && expected * (1.0 - 4e-16) <= h.hi(),
            "{text}: {h:?}"
        );
        // Written and read again, it is the same.
        assert_eq!(Formula::parse(&formula.to_string(), &[]), Ok(formula), "{text}");
    }
}

/// Where a number is needed, its last digits are those of `f64`, as in Rust. Beside coordinates the number is
/// enclosed as it was typed.
#[test]
fn numbers_that_are_rounded_are_those_of_f64_and_are_enclosed_beside_coordinates() {
    let a = 0.3;
    for (text, number) in [
        ("2*pi/3", 2.0 * PI / 3.0),
        ("1.05^30", black_box(1.05_f64).powi(30)),
        ("10^-15", black_box(10.0_f64).powi(-15)),
        ("-1/a", -1.0 / a),
        ("sqrt(2)*exp(-a)", 2.0_f64.sqrt() * (-a).exp()),
        ("1 + 1e-17", 1.0),
        ("0.1^3 - a", 0.1_f64.powi(3) - a),
        ("1e-310", 1e-310),
        ("0*1e300", 0.0),
        ("1e17 - 1e17", 0.0),
    ] {
        assert_eq!(tautline_formula::number(text, &[("a", a)]), Ok(number), "{text}");
        let formula = Formula::<1>::parse(&format!("(x1*({text})) I"), &[("a", a)]);
        let formula = formula.expect("a formula");
        assert_eq!(formula.gram(&vector![1.0])[(0, 0)], number, "{text}");
        let h = formula.gram(&vector![Interval::point(1.0)])[(0, 0)];
        assert!(h.lo() <= number && number <= h.hi(), "{text}: {h:?}");
        // Exact results are numbers.
        let is_exact = ["1e-310", "0*1e300", "1e17 - 1e17"].contains(&text);
        assert_eq!(formula.operations().len() == 2, is_exact, "{text}");
    }
    let squares = ["cost(9007199254740992 + 1)", "cost(9007199254740992)"];
    let [rounded, other] = squares.map(|text| Formula::<1>::parse(text, &[]).expect("a formula"));
    assert_ne!(rounded, other, "the square of a rounded number is exact, and another one");
    // Where numbers are needed, they are those of `f64`.
    for (text, number) in [("1e17 + 1 - 1e17", 0.0), ("cos(90*pi/180)", (PI / 2.0).cos())] {
        assert_eq!(tautline_formula::number(text, &[]), Ok(number), "{text}");
    }
    let step = tautline_formula::number("number(2)", &[]).expect_err("a step");
    assert!(matches!(step.problem, Problem::UnknownFunction { .. }), "{step}");
}

/// Steps of numbers that are defined bring no `0·x` along: entries that vanish are the number 0, so that it is
/// seen that `H` is a multiple of the identity.
#[test]
fn derivatives_beside_rounded_numbers_vanish_where_they_should() {
    for text in ["pullback(2/3*x1, 2/3*x2)", "pullback(sqrt(2)*x1, sqrt(2)*x2)", "graph(0.1/3)"] {
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        let off = formula.operations()[formula.entry(0, 1) as usize];
        assert_eq!(off, Operation::Constant(Number::of(0.0)), "{text}");
    }
    let undefined = Formula::<2>::parse("pullback(ln(0.1/3 - 1)*x1, x2)", &[]).expect("a formula");
    assert!(
        undefined.gram(&vector![Interval::point(0.5), Interval::point(0.5)])[(0, 0)].is_undefined()
    );
}

/// `tanh(1/0)` is not 1, and `exp(-1/a^2)` at `a = 0` is not 0: what is undefined stays so.
#[test]
fn there_is_no_arithmetic_with_infinite_numbers() {
    for text in [
        "1 + exp(-1/a^2)",
        "1 + 3*tanh(1/a)*x1",
        "1 + 1/(1/0)",
        "1 + exp(ln(0))",
        "(ln(-1))^0",
        "1 + (1/0)^-1",
        "atan(1/0)",
        "1e200*1e200/1e300",
        "x1 + 0*(0/0)",
    ] {
        let refused = Formula::<1>::parse(&format!("({text}) I"), &[("a", 0.0)]).expect_err("1/0");
        assert!(matches!(refused.problem, Problem::NotFinite { .. }), "{text}: {refused}");
    }
    for text in ["1e-400", "1e400", "0.000e5 + 0.1e-330"] {
        let refused = Formula::<1>::parse(&format!("({text}) I"), &[]).expect_err("out of range");
        assert_eq!(refused.problem, Problem::TooLarge, "{text}");
    }
    let zero = Formula::<1>::parse("(1 + 0e-400 + 0.0) I", &[]);
    assert!(zero.is_ok(), "{zero:?}");
}

/// The derivative `1/a` of a logarithm is defined where the logarithm is not.
#[test]
fn the_metric_of_an_undefined_function_is_undefined() {
    let undefined = [
        "graph(ln(x1))",
        "graph(0*ln(x1) + x2)",
        "pullback(ln(x1), x2)",
        "graph(ln(x1)^0)",
        "graph(ln(x1)/(1/0) + x2)",
        "graph(x2 + 0/0)",
        "graph(ln(-1))",
        "cost(ln(x1))",
        "speed(ln(x1))",
    ];
    for text in undefined {
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        let trace = formula.gram(&vector![-1.0, 0.5]).trace();
        assert!(trace.is_nan(), "{text}: {trace}");
        let over = vector![Interval::new(-2.0, -1.0).expect("ordered"), Interval::point(0.5)];
        assert!(formula.gram(&over).trace().is_undefined(), "{text}");
    }
    // Steps that do not change, so that no derivative reads them.
    let nowhere = [
        "ln(number(-1))",
        "ln(0*x1 - 1)",
        "ln(x2 - x2 - 1)",
        "sqrt(0*x2 - 1)",
        "number(1)/number(0)",
        "number(2)/0",
        "number(0)*(1/0)",
        "number(2)*(0/0)",
        "number(0)^-1",
        "recip(0*x1)",
        "sqrt(ln(0*x1 - 1))",
        "0*ln(0*x2 - 1)",
        "ln(0*x1 - 1)^0",
        "atan(ln(0*x1 - 1))",
    ];
    for step in nowhere {
        for text in [format!("graph(x1 + {step})"), format!("pullback(x1, x2, {step})")] {
            let formula = Formula::<2>::parse(&text, &[]).expect("a formula");
            for x in [vector![1.0, 0.5], vector![-0.25, 0.0]] {
                assert!(formula.gram(&x).trace().is_nan(), "{text}");
                assert!(formula.gram(&x.map(Interval::point)).trace().is_undefined(), "{text}");
            }
        }
    }
    // In a block that does not change with x₂, the function has to be defined at x₂.
    let part = |text| Part { text, id: 0 };
    let block = |i: usize, text| (vec![i], Written::Form(Form::Graph, vec![part(text)]));
    let product = Written::Product(vec![block(0, "x1 + ln(x2)"), block(1, "x2")]);
    let product = Formula::<2>::compose(&[], &[], &[], &product).expect("a formula");
    assert!(product.gram(&vector![0.5, -1.0])[(0, 0)].is_nan());
    assert_eq!(product.gram(&vector![0.5, 1.0]), matrix![2.0, 0.0; 0.0, 2.0]);
    // What does not change, and is defined, changes nothing.
    for text in ["graph(x1 + sqrt(0*x2))", "graph(x1 + 2/number(4))", "graph(x1 + ln(0*x2 + 2))"] {
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        assert_eq!(formula.gram(&vector![3.0, 4.0]), matrix![2.0, 0.0; 0.0, 1.0], "{text}");
    }
    let defined = Formula::<2>::parse("graph(ln(x1))", &[]).expect("a formula");
    let slope = defined.gram(&vector![Interval::point(0.5), Interval::point(0.0)])[(0, 0)];
    assert!(slope.contains(5.0) && slope.width() < 1e-13, "{slope:?}");
}

#[test]
fn powers_at_the_ends_of_the_range_have_their_derivatives() {
    let x = 1.0 + 1e-9;
    for n in [i32::MIN, i32::MIN + 1, -1, 1, i32::MAX] {
        let graph = Formula::<1>::parse(&format!("graph(x1^{n})"), &[]).expect("a formula");
        // n x^{n−1}, computed by logarithms; 1e-9 is rounded by 1e-16, times n.
        let expected =
            1.0 + (f64::from(n) * ((f64::from(n) - 1.0) * 1e-9_f64.ln_1p()).exp()).powi(2);
        let found = graph.gram(&vector![x])[(0, 0)];
        assert!((found / expected - 1.0).abs() < 1e-5, "{n}: {found} for {expected}");
    }
}

/// One text has the same function many times. In another, derivatives make the tape too long.
#[test]
fn long_lists_of_functions_are_read_in_one_pass() {
    let chain = |length: usize| {
        let step = |k: usize| format!("a{} = sin(a{k}*x2 + 0.25);", k + 1);
        format!("a0 = x1; {}", (0..length).map(step).collect::<String>())
    };
    let text = format!("{} pullback({})", chain(1000), ["a1000"; 20_000].join(", "));
    assert!(Formula::<2>::parse(&text, &[]).is_ok());
    // Each definition takes three steps, and its derivatives take six more.
    let text = format!("{} graph(a130000)", chain(130_000));
    let problem = Formula::<2>::parse(&text, &[]).err().map(|error| error.problem);
    assert!(matches!(problem, Some(Problem::Record(RecordError::TooLong { .. }))), "{problem:?}");
    assert!(Formula::<2>::parse(&text.replace("graph", "phi"), &[]).is_ok());
}

/// Two names exchanged would be written and read alike.
#[test]
fn every_name_is_that_of_its_function() {
    let x = 0.3_f64;
    for (name, expected) in [
        ("sqr", x * x),
        ("recip", 1.0 / x),
        ("sqrt", x.sqrt()),
        ("exp", x.exp()),
        ("ln", x.ln()),
        ("sin", x.sin()),
        ("cos", x.cos()),
        ("tan", x.tan()),
        ("atan", x.atan()),
        ("sinh", x.sinh()),
        ("cosh", x.cosh()),
        ("tanh", x.tanh()),
    ] {
        let formula = Formula::<1>::parse(&format!("[{name}(x1)]"), &[]).expect("a formula");
        let found = formula.gram(&vector![x])[(0, 0)];
        assert!((found - expected).abs() <= 1e-15 * expected.abs(), "{name}: {found}");
    }
}
