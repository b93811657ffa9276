//! Formulas with numbers at the ends of the range of doubles: constants or an error, and no panic.

use tautline_certify::{Accuracy, CertifiedConstants, Domain};
use tautline_formula::Formula;

use crate::reference::Random;

const NUMBERS: [&str; 16] = [
    "0", "1", "0.1", "0.5", "1024", "3", "1e308", "1.7e308", "5e-324", "1e-310", "1e-160", "1e160",
    "(0/0)", "(1/0)", "sqrt(2)", "(1/3)",
];

const FUNCTIONS: [&str; 12] =
    ["sin", "cos", "tan", "tanh", "atan", "exp", "sqr", "recip", "ln", "sqrt", "sinh", "cosh"];

const POWERS: [&str; 6] = ["2", "3", "(-1)", "2147483647", "(-2147483648)", "0"];

fn one_of<'t>(texts: &[&'t str], random: &mut Random) -> &'t str {
    texts[(random.bits() % texts.len() as u64) as usize]
}

/// Returns a linear form, with extreme coefficients.
fn linear(dimension: u64, random: &mut Random) -> String {
    let term = |random: &mut Random| {
        let number = one_of(&NUMBERS, random);
        format!("x{}*{number}", 1 + random.bits() % dimension)
    };
    let terms: Vec<String> = (0..1 + random.bits() % 2).map(|_| term(random)).collect();
    terms.join(" - ")
}

fn tree(depth: u32, dimension: u64, random: &mut Random) -> String {
    if depth == 0 || random.bits().is_multiple_of(4) {
        return match random.bits() % 4 {
            0 => one_of(&NUMBERS, random).to_owned(),
            _ => linear(dimension, random),
        };
    }
    let mut below = || format!("({})", tree(depth - 1, dimension, random));
    let (a, b) = (below(), below());
    match random.bits() % 9 {
        0 => format!("{a} + {b}"),
        1 => format!("{a}*{b}"),
        2 => format!("{a}/{b}"),
        3 => format!("1/(1 + exp{a})"),
        4 => format!("exp(-sqr{a} - {b})"),
        5 => format!("{a}^{}", one_of(&POWERS, random)),
        _ => format!("{}{a}", one_of(&FUNCTIONS, random)),
    }
}

/// Tries a formula; returns whether it has constants on all of space.
fn has_constants<const D: usize>(random: &mut Random) -> bool {
    let phi = |random: &mut Random| tree(1 + random.bits() as u32 % 3, D as u64, random);
    let terms: Vec<String> = (0..1 + random.bits() % 3).map(|_| phi(random)).collect();
    let text = format!("3 + {} I", terms.join(" + "));
    let Ok(formula) = Formula::<D>::parse(&text, &[]) else { return false };
    let accuracy = Accuracy { tolerance: 1e-2, budget: 60 };
    let space = Domain::space(&formula);
    let proved = CertifiedConstants::within_budget(&formula, &space, accuracy);
    // Errors are expected: many of these formulas are undefined or unbounded.
    let _ = Domain::settled_space(&formula);
    let ball = Domain::ball([1.0; D], 1e300).expect("a radius");
    let _ = CertifiedConstants::within_budget(&formula, &ball, accuracy);
    let is_settled = proved.is_ok() && space.is_all_of_space();
    assert!(
        !is_settled || proved.is_ok_and(|found| found.c1().lower <= found.c2().upper),
        "{text}"
    );
    is_settled
}

#[test]
fn extreme_numbers_make_errors_and_no_panic() {
    let mut random = Random(tautline_chance::seed(74));
    let cases = tautline_chance::cases(120);
    let mut settled = 0;
    for _ in 0..cases {
        settled += u32::from(has_constants::<1>(&mut random));
        settled += u32::from(has_constants::<2>(&mut random));
        settled += u32::from(has_constants::<3>(&mut random));
    }
    assert!(settled > cases / 8, "{settled}");
}
