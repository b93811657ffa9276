//! What is wrong with a text is said with its place, whatever the text is.

use tautline_chance::{cases, seed};
use tautline_formula::{Formula, Problem, TextError};

use crate::random::Random;

fn error(text: &str) -> TextError {
    Formula::<2>::parse(text, &[("a", 1.5)]).expect_err(text)
}

#[test]
fn each_mistake_is_shown_where_it_is() {
    for (text, wrong, says) in [
        ("", "", "at byte 0: found the end, expected a number, a name, a function or ("),
        ("x1 + I", "I", "at byte 5: nothing is called I"),
        ("x1 + ", "", "at byte 5: found the end, expected a number, a name, a function or ("),
        ("x1", "", "at byte 2: found the end, expected an operator, or the identity I"),
        ("x1 I x2", "x2", "at byte 5: found x2, expected the end"),
        ("cos(x3) I", "x3", "at byte 4: there is no x3 in dimension 2"),
        ("x0 I", "x0", "at byte 0: there is no x0 in dimension 2"),
        ("x01 I", "x01", "at byte 0: there is no x01 in dimension 2"),
        ("y I", "y", "at byte 0: nothing is called y"),
        ("cosine(x1) I", "cosine", "at byte 0: there is no function cosine"),
        ("cos x1 I", "cos", "at byte 0: nothing is called cos"),
        ("cos(x1 I", "I", "at byte 7: found I, expected an operator or )"),
        ("a = 2; a I", "a", "at byte 0: a has a meaning already"),
        ("sin = 2; 1 I", "sin", "at byte 0: sin has a meaning already"),
        ("b = 2; b = 3; 1 I", "b", "at byte 7: b has a meaning already"),
        ("b = 2 1 I", "1", "at byte 6: found 1, expected an operator or ;"),
        ("s, c = cos(x1); 1 I", "cos", "at byte 7: found cos, expected sin_cos or sinh_cosh"),
        (
            "x1^0.5 I",
            "0.5",
            "at byte 3: an exponent is a whole number from -2147483648 to 2147483647",
        ),
        (
            "x1^3000000000 I",
            "3000000000",
            "at byte 3: an exponent is a whole number from -2147483648 to 2147483647",
        ),
        ("1e999 I", "1e999", "at byte 0: a number beyond the range of f64"),
        ("[1, 2]", "[1, 2]", "at byte 0: 1 rows in dimension 2"),
        ("[1, 2, 3; 4, 5]", "1, 2, 3", "at byte 1: 3 entries in a row in dimension 2"),
        ("[1, 2; 3, 4", "", "at byte 11: found the end, expected an operator, a comma, ; or ]"),
        ("1 + é I", "é", "at byte 4: found é, expected a number, a name or a sign"),
        (". I", ".", "at byte 0: found ., expected a number"),
    ] {
        let error = error(text);
        assert_eq!((&text[error.at.clone()], error.to_string().as_str()), (wrong, says), "{text}");
    }
}

#[test]
fn names_of_parameters_have_to_be_new() {
    for name in ["x1", "pi", "I", "tanh", "sin_cos"] {
        let found = Formula::<2>::parse("1 I", &[(name, 1.0)]).expect_err(name);
        assert_eq!(found.problem, Problem::TakenName { name: name.to_owned() });
    }
    let twice = Formula::<2>::parse("1 I", &[("a", 1.0), ("a", 2.0)]).expect_err("twice");
    assert_eq!(twice.problem, Problem::TakenName { name: "a".to_owned() });
}

#[test]
fn brackets_without_end_take_no_stack() {
    let deep = format!("{}x1 I", "(".repeat(1_000_000));
    assert_eq!(error(&deep).problem, Problem::TooDeep { most: 128 });
    let deep = format!("{}x1{} I", "sin(".repeat(127), ")".repeat(127));
    assert!(Formula::<2>::parse(&deep, &[]).is_ok());
    // Signs are no brackets.
    let signs = format!("{}x1 I", "-".repeat(100_000));
    assert!(Formula::<2>::parse(&signs, &[]).is_ok());
}

/// Either a formula that is read back, or an error whose place is in the text.
fn is_read(text: &str) -> bool {
    match Formula::<2>::parse(text, &[("a", 1.5)]) {
        Ok(formula) => {
            assert_eq!(Formula::parse(&formula.to_string(), &[]).as_ref(), Ok(&formula), "{text}");
            true
        }
        Err(error) => {
            assert!(text.get(error.at.clone()).is_some(), "{text}: {error:?}");
            false
        }
    }
}

#[test]
fn no_text_makes_it_panic() {
    const WORDS: [&str; 37] = [
        "pullback",
        "graph",
        "diag",
        "x1",
        "x2",
        "x3",
        "a",
        "b",
        "I",
        "pi",
        "sin",
        "sqrt",
        "exp",
        "number",
        "sin_cos",
        "0",
        "1",
        "2.5",
        "1e5",
        ".",
        "1e",
        "+",
        "-",
        "*",
        "/",
        "^",
        "**",
        "(",
        ")",
        "[",
        "]",
        ",",
        ";",
        "=",
        " ",
        "é",
        "\u{1f600}",
    ];
    const FORMULAS: [&str; 6] = [
        "pullback(x1, x2 + 0.7*sin(1.3*x1), x1/x2)",
        "phi = 2 - tanh(x1*x2); speed(phi - 1)",
        "b = 2 - a*cos(x1); [b^2, 0.5*x2; 0.5*x2, 1 + 3/(1 + x2^-2)]",
        "s, c = sin_cos(x1*x2); [2 + s*c, -c; -c, 4 - s]",
        "(2 - cos(x1))^2*exp(-x2/4)**3 I",
        "[sqr(x1) + 1, tanh(x2); tanh(x2), atan(x1) + sqrt(4 + sinh(x2)^2)]",
    ];
    let mut random = Random(seed(1901));
    let mut read = 0;
    for case in 0..cases(1_000_000) {
        let mut text = String::new();
        if case % 2 == 0 {
            for _ in 0..random.below(24) {
                text += WORDS[random.below(WORDS.len())];
            }
        } else {
            // One or two places of a formula are something else.
            text += FORMULAS[random.below(FORMULAS.len())];
            for _ in 0..=random.below(2) {
                let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
                let at = places[random.below(places.len())];
                let length = text[at..].chars().next().map_or(0, char::len_utf8) * random.below(2);
                text.replace_range(at..at + length, WORDS[random.below(WORDS.len())]);
            }
        }
        read += u32::from(is_read(&text));
    }
    assert!(read > cases(1_000_000) / 60, "{read}");
}
