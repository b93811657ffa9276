//! Ten thousand hard arguments of each elementary function (close to multiples of `π/2`, to powers
//! of two and to the ends of the range), and as many ordinary ones.

use crate::reference::{FAMILIES, Function, Random, Reference, Widest, argument, attempt};
use tautline_chance::{cases, seed};

const EACH: u32 = 10_000;

/// `⌊2²⁰/(π/2)⌋` and `⌊2³⁸/(π/2)⌋`.
const MILLION: u64 = 667_544;
const MOST: u64 = 174_992_710_547;

/// Angles within `2⁻⁵¹` of a multiple of `π/2`, by convergents of `2ⁿ/(π/2)`.
const CLOSEST: [f64; 6] = [
    f64::from_bits(0x4139_eb71_48f3_54d6),
    f64::from_bits(0x416b_951f_1572_eba5),
    f64::from_bits(0x41d5_5202_aefd_e314),
    f64::from_bits(0x4205_c950_8c58_aafa),
    f64::from_bits(0x421d_e5e5_054e_921b),
    f64::from_bits(0x4244_6546_a5bd_73cc),
];

/// Returns an angle close to a multiple of `π/2`, up to the largest angle.
fn near_quarters(random: &mut Random) -> f64 {
    let k = match random.bits() % 6 {
        0 => 1 + random.bits() % 64,
        1 => 1 + random.bits() % MILLION,
        // Beyond 2²⁰ angles are reduced in another way.
        2 => MILLION + 1000 - random.bits() % 2000,
        3 => 1 + random.bits() % MOST,
        4 => MOST - random.bits() % 1000,
        _ => return random.sign() * CLOSEST[random.bits() as usize % CLOSEST.len()],
    };
    let mut x = k as f64 * std::f64::consts::FRAC_PI_2;
    for _ in 0..random.bits() % 4 {
        x = x.next_down();
    }
    for _ in 0..random.bits() % 4 {
        x = x.next_up();
    }
    // Odd multiples of π/4 are included, where the integer of the reduction changes.
    if random.bits().is_multiple_of(8) { random.sign() * x / 2.0 } else { random.sign() * x }
}

/// Returns a number close to a boundary between cases, roundings or ranges.
fn special(family: &[Function], random: &mut Random) -> f64 {
    let powers = || (-40..=38).map(|e| 2.0_f64.powi(e));
    let common: Vec<f64> = match family[0] {
        Function::Exp => {
            let ends =
                [708.0, 709.0, 709.78, 709.782_712_893_384, 710.0, 710.475, 711.0, 745.13, 746.0];
            let halves = (0..80).map(|k| f64::from(2 * k + 1) * std::f64::consts::LN_2 / 2.0);
            ends.into_iter().chain(halves).chain(powers().filter(|&x| x < 700.0)).collect()
        }
        Function::Ln => {
            let scales = [1.0, 2.0, 0.5, 1e300, f64::MIN_POSITIVE, f64::MAX, 5e-324];
            scales.into_iter().chain(powers()).chain(powers().map(|x| x * 2.0_f64.sqrt())).collect()
        }
        Function::Sin => powers().chain([LARGEST, std::f64::consts::FRAC_PI_4, 1.0]).collect(),
        _ => {
            let odd = (0..17).map(|j| f64::from(2 * j + 1) / 16.0);
            let ends = [1.0, 1e300, f64::MAX, f64::MIN_POSITIVE, 16.0, 20.0];
            powers().chain(odd.clone()).chain(odd.map(f64::recip)).chain(ends).collect()
        }
    };
    let mut x = common[random.bits() as usize % common.len()];
    for _ in 0..random.bits() % 4 {
        x = if random.bits() & 1 == 0 { x.next_down() } else { x.next_up() };
    }
    match family[0] {
        Function::Ln => x.clamp(5e-324, f64::MAX),
        Function::Sin => random.sign() * x.min(LARGEST),
        Function::Exp => random.sign() * x,
        _ => random.sign() * x.min(f64::MAX),
    }
}

const LARGEST: f64 = 274_877_906_944.0;

fn hard(family: &[Function], random: &mut Random) -> f64 {
    match random.bits() % 8 {
        // Subnormal numbers.
        0 if family[0] == Function::Ln => f64::from_bits(1 + random.bits() % (1 << 52)),
        // Numbers near one, the zero of the logarithm.
        1 | 2 if family[0] == Function::Ln => 1.0 + random.sign() * random.with_exponent(-53, -2),
        0 | 1 if family[0] == Function::Exp => random.sign() * random.between(690.0, 750.0),
        0..=3 if family[0] == Function::Sin => near_quarters(random),
        _ => special(family, random),
    }
}

fn try_family(which: usize) {
    let family = FAMILIES[which];
    let mut reference = Reference::new();
    let mut random = Random(seed(20 + which as u64));
    let mut widest = vec![[Widest::default(); 2]; family.len()];
    for i in 0..cases(2 * EACH) {
        let x = if i % 2 == 0 { hard(family, &mut random) } else { argument(family, &mut random) };
        attempt(family, x, &mut reference, &mut random, &mut widest);
    }
    for (f, [rigorous, fast]) in family.iter().zip(&widest) {
        println!("{f:?}: rigorous {rigorous:?}, fast {fast:?}");
        // Widths are in units of 2⁻⁵², absolute for sine and cosine, relative for the others.
        let width = match f {
            Function::Sin | Function::Cos => rigorous.absolute,
            _ => rigorous.relative,
        };
        assert!(width <= 8.0, "{f:?}: {width}");
        // One neighbour on either side is at most two ulps.
        assert!(fast.relative <= 2.0, "{f:?}: {fast:?}");
    }
}

#[test]
fn exponential_and_hyperbolic_functions_are_enclosed() {
    try_family(0);
}

#[test]
fn logarithms_are_enclosed() {
    try_family(1);
}

#[test]
fn circular_functions_are_enclosed() {
    try_family(2);
}

#[test]
fn arctangents_are_enclosed() {
    try_family(3);
}
