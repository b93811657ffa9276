//! Errors in texts: each error gives its place, and no text causes a panic.

use tautline_chance::{cases, seed};
use tautline_formula::{Formula, Problem, TextError};

use crate::random::Random;

fn error(text: &str) -> TextError {
    Formula::<2>::parse(text, &[("a", 1.5)]).expect_err(text)
}

#[test]
fn each_error_names_its_place() {
    let table = include_str!("broken_text.txt").lines().skip(1);
    assert_eq!(table.clone().count(), 25);
    for row in table {
        let [text, wrong, says] =
            row.split(" | ").collect::<Vec<_>>().try_into().expect("three columns");
        let error = error(text);
        assert_eq!((&text[error.at.clone()], error.to_string().as_str()), (wrong, says), "{text}");
    }
}

#[test]
fn names_of_parameters_must_be_new() {
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
    // Signs do not count as brackets.
    let signs = format!("{}x1 I", "-".repeat(100_000));
    assert!(Formula::<2>::parse(&signs, &[]).is_ok());
}

/// Returns whether the text parses. A parsed formula is printed and parsed again, and the place of
/// an error must lie in the text.
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
    let words: Vec<&str> =
        "pullback|graph|diag|x1|x2|x3|a|b|I|pi|sin|sqrt|exp|number|sin_cos|0|1|2.5|\
        1e5|.|1e|+|-|*|/|^|**|(|)|[|]|,|;|=| |é|\u{1f600}"
            .split('|')
            .collect();
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
                text += words[random.below(words.len())];
            }
        } else {
            // One or two places of a formula are changed.
            text += FORMULAS[random.below(FORMULAS.len())];
            for _ in 0..=random.below(2) {
                let places: Vec<usize> = text.char_indices().map(|(at, _)| at).collect();
                let at = places[random.below(places.len())];
                let length = text[at..].chars().next().map_or(0, char::len_utf8) * random.below(2);
                text.replace_range(at..at + length, words[random.below(words.len())]);
            }
        }
        read += u32::from(is_read(&text));
    }
    assert!(read > cases(1_000_000) / 60, "{read}");
}
