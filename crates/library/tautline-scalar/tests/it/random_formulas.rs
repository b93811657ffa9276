//! Random formulas with all operations. Jets over intervals contain the derivatives at points of
//! the box, computed to 192 bits with an error bound.

use crate::formulas::{Formula, attempt};
use crate::precise::{Precise, Tally, Value};
use crate::reference::{FAMILIES, Function, Random, Reference, argument};
use astro_float::{BigFloat, Consts, RoundingMode};
use tautline_chance::{cases, seed};
use tautline_scalar::Scalar;

/// The number of formulas, each with 16 points and 19 enclosures.
const FORMULAS: u32 = 800;

#[test]
fn no_enclosure_misses_a_random_formula() {
    let mut random = Random(seed(31));
    let mut tally = Tally::default();
    for _ in 0..cases(FORMULAS) {
        let depth = 1 + (random.bits() % 6) as u32;
        let formula = Formula::random(depth, &mut random);
        attempt(&formula, &mut random, &mut tally);
    }
    println!("{tally:?}");
    assert!(tally.total() >= u64::from(FORMULAS) * 16 * 19, "{tally:?}");
    assert!(tally.compared > 100_000 && tally.undefined > 5_000, "{tally:?}");
    assert!(tally.unknown < tally.total() / 100, "{tally:?}");
}

/// Returns the value, computed with twice the precision.
fn twice_as_precise(f: Function, x: f64, constants: &mut Consts) -> BigFloat {
    const P: usize = 384;
    const RM: RoundingMode = RoundingMode::ToEven;
    let x = Reference::big(x);
    match f {
        Function::Exp => x.exp(P, RM, constants),
        Function::Ln => x.ln(P, RM, constants),
        Function::Sin => x.sin(P, RM, constants),
        Function::Cos => x.cos(P, RM, constants),
        Function::Tan => x.tan(P, RM, constants),
        Function::Atan => x.atan(P, RM, constants),
        Function::Sinh => x.sinh(P, RM, constants),
        Function::Cosh => x.cosh(P, RM, constants),
        Function::Tanh => x.tanh(P, RM, constants),
    }
}

#[test]
fn balls_contain_values_of_twice_the_precision() {
    const RM: RoundingMode = RoundingMode::None;
    let mut random = Random(seed(32));
    let mut constants = Consts::new().expect("memory for the constants");
    for family in FAMILIES {
        for _ in 0..cases(500) {
            Precise::forget_all();
            let x = argument(family, &mut random);
            for &f in family {
                let value = twice_as_precise(f, x, &mut constants);
                let Value::Within(ball) = f.of(Precise::constant(x)).value() else {
                    panic!("{f:?} is defined at {x:e}");
                };
                let error = value.sub(&ball.centre, 384, RM).abs();
                let within = |bound: &BigFloat| error.cmp(bound).is_some_and(|order| order <= 0);
                assert!(within(&ball.radius), "{f:?}({x:e}) = {value}, off by {error}");
                // The ball must also be narrow.
                let narrow = value.abs().mul(&Reference::big(2.0_f64.powi(-180)), 64, RM);
                assert!(ball.radius.cmp(&narrow).is_some_and(|order| order <= 0), "{f:?}({x:e})");
            }
        }
    }
}

fn is_undefined(x: Precise) -> bool {
    matches!(x.value(), Value::Undefined)
}

#[test]
fn undefined_stays_undefined_and_cancellation_is_unknown() {
    let [zero, two] = [0.0, 2.0].map(Precise::constant);
    for x in [zero.recip(), zero.ln(), (-two).ln(), (-two).sqrt(), two / zero, zero.powi(-3)] {
        assert!(is_undefined(x) && is_undefined(x.atan() * 0.0) && is_undefined(x.powi(0)));
    }
    assert!(is_undefined(Precise::constant(f64::NAN)));
    assert!(is_undefined(Precise::constant(f64::INFINITY) - Precise::constant(f64::INFINITY)));
    // An exact difference is known to be zero, but a rounded one is not.
    assert!(is_undefined((two * 0.1 - Precise::constant(0.1) * 2.0).recip()));
    let third = two / 3.0;
    assert!(matches!((third - third).recip().value(), Value::Unknown));
    assert!(is_undefined((third - third).recip() + zero.recip()));
    // 1 − tanh 70 = 2⁻²⁰⁰·⁹ is below the precision of tanh 70.
    let rest = -(two * 35.0).tanh() + 1.0;
    assert!(matches!(rest.ln().value(), Value::Unknown));
    assert!(matches!(rest.exp().value(), Value::Within(_)));
}
