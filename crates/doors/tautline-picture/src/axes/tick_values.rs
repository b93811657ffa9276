//! The values at which an axis may have ticks, and the numbers of these ticks.

use super::{scale::Scale, stretch::Stretch};

/// Ticks in increasing order, some of which have a number.
pub(super) type TickValues = Vec<(f64, Option<String>)>;

/// Returns possible sets of ticks, starting with the set that has most labels.
pub(super) fn candidates(stretch: &Stretch) -> Vec<TickValues> {
    match stretch.scale {
        Scale::Decades => decades(stretch),
        Scale::Octaves => octaves(stretch),
        Scale::Linear => linear(stretch),
        Scale::MultiplesOfPi => multiples_of_pi(stretch),
    }
}

const STRIDES: [i32; 13] = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100];

fn decades(stretch: &Stretch) -> Vec<TickValues> {
    let (from, to) = (stretch.from, stretch.to);
    let exponents = || from.log10().floor() as i32..=to.log10().ceil() as i32;
    // Numbers with few digits are easier to read when written out.
    let plain = to <= 1.001e4 && (from >= 0.99 || (stretch.length() < 2.0 && from >= 9.9e-4));
    let number = |digit: i32, e: i32| match (digit, plain) {
        (_, true) => decimal(f64::from(digit) * 10.0_f64.powi(e), (-e).max(0) as usize),
        (1, false) => format!("$10^{{{e}}}$"),
        (_, false) => format!("${digit}·10^{{{e}}}$"),
    };
    let mut sets = Vec::new();
    let mut add = |labelled: &dyn Fn(i32, i32) -> bool, digits: i32| {
        let all = exponents().flat_map(|e| (1..=digits).map(move |digit| (digit, e)));
        let set: Vec<_> = all
            .map(|(digit, e)| {
                let label = labelled(digit, e).then(|| number(digit, e));
                (f64::from(digit) * 10.0_f64.powi(e), label)
            })
            .filter(|(value, _)| stretch.holds(*value))
            .collect();
        if set.iter().any(|(_, label)| label.is_some()) {
            sets.push(set);
        }
    };
    if stretch.length() < 2.0 {
        add(&|digit, _| matches!(digit, 1 | 2 | 5), 9);
    }
    add(&|digit, _| digit == 1, 9);
    for stride in STRIDES {
        add(&|_, e| e.rem_euclid(stride) == 0, 1);
    }
    sets
}

fn octaves(stretch: &Stretch) -> Vec<TickValues> {
    let exponents = stretch.from.log2().floor() as i32..=stretch.to.log2().ceil() as i32;
    let number = |e: i32| match e {
        0..=16 => (1_u32 << e).to_string(),
        _ => format!("$2^{{{e}}}$"),
    };
    let set = |stride: i32| {
        let label = |e: i32| (e.rem_euclid(stride) == 0).then(|| number(e));
        let all = exponents.clone().map(|e| (2.0_f64.powi(e), label(e)));
        all.filter(|(value, _)| stretch.holds(*value)).collect::<Vec<_>>()
    };
    let numbered = |set: &TickValues| set.iter().any(|(_, label)| label.is_some());
    STRIDES.into_iter().map(set).filter(numbered).collect()
}

fn linear(stretch: &Stretch) -> Vec<TickValues> {
    // Steps start at a hundredth of the length, since a hundred labels never fit.
    let start = stretch.length().log10().floor() as i32 - 2;
    let mut sets = Vec::new();
    for e in start..start + 4 {
        for (digit, parts) in [(1.0, 2), (2.0, 2), (5.0, 5)] {
            let decimals = (-e).max(0) as usize;
            let step = digit * 10.0_f64.powi(e);
            sets.push(steps(stretch, step, parts, &|k| decimal(k * step, decimals)));
        }
    }
    sets
}

fn multiples_of_pi(stretch: &Stretch) -> Vec<TickValues> {
    let mut sets = Vec::new();
    for (numerator, denominator) in [(1, 4), (1, 2), (1, 1), (2, 1), (4, 1), (8, 1), (16, 1)] {
        let step = std::f64::consts::PI * f64::from(numerator) / f64::from(denominator);
        let label = |k: f64| pi_fraction(k as i32 * numerator, denominator);
        sets.push(steps(stretch, step, 2, &label));
    }
    sets
}

/// Returns labelled multiples of `step`, and `parts − 1` unlabelled ticks between them.
fn steps(stretch: &Stretch, step: f64, parts: i32, label: &dyn Fn(f64) -> String) -> TickValues {
    let small = step / f64::from(parts);
    let (first, last) = ((stretch.from / small).floor(), (stretch.to / small).ceil());
    let mut set = Vec::new();
    let mut k = first;
    while k <= last {
        let whole = k.rem_euclid(f64::from(parts)) == 0.0;
        set.push((k * small, whole.then(|| label(k / f64::from(parts)))));
        k += 1.0;
    }
    set.retain(|(value, _)| stretch.holds(*value));
    set
}

/// Returns a multiple of π in lowest terms.
fn pi_fraction(numerator: i32, denominator: i32) -> String {
    let divisor = (1..=denominator).rev().find(|d| numerator % d == 0 && denominator % d == 0);
    let divisor = divisor.unwrap_or(1);
    let (numerator, denominator) = (numerator / divisor, denominator / divisor);
    let over = if denominator == 1 { String::new() } else { format!("/{denominator}") };
    match numerator {
        0 => "0".to_owned(),
        1 => format!("$π{over}$"),
        -1 => format!("$-π{over}$"),
        n => format!("${n}π{over}$"),
    }
}

/// Returns a number with a true minus sign.
fn decimal(value: f64, decimals: usize) -> String {
    // Adding zero turns −0 into 0.
    format!("{:.decimals$}", value + 0.0).replace('-', "−")
}

#[cfg(test)]
mod tests {
    use super::{decimal, pi_fraction};

    #[test]
    fn fractions_are_in_lowest_terms_and_zero_has_no_sign() {
        assert_eq!(pi_fraction(-6, 4), "$-3π/2$");
        assert_eq!(decimal(-0.0, 1), "0.0");
    }
}
