//! Where an axis has ticks, and which of them carry a number.

use super::{
    axis::{Axis, Scale},
    error::DrawingError,
    math_text::{Align, TextBlock, typeset},
    measures::SMALL,
    stretch::Stretch,
};

/// A mark on an axis.
#[derive(Clone, Debug)]
pub(super) struct Tick {
    /// Where it stands.
    pub value: f64,
    /// Its number; a tick without one is drawn shorter.
    pub label: Option<TextBlock>,
}

/// Along which direction labels must not meet.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Direction {
    /// An `x` axis.
    Horizontal,
    /// A `y` axis.
    Vertical,
}

impl Direction {
    /// How the labels of its ticks stand to them.
    fn align(self) -> Align {
        if self == Direction::Horizontal { Align::Centre } else { Align::Right }
    }
}

/// Ticks closer than this, in px, are left out.
const CROWDED: f64 = 2.5;

/// Returns the ticks of a stretch that is `length` px long: the densest numbering that is airy.
///
/// # Errors
///
/// If a label cannot be set, which would be a defect of the font.
pub(super) fn ticks(
    stretch: &Stretch,
    length: f64,
    direction: Direction,
) -> Result<Vec<Tick>, DrawingError> {
    let align = direction.align();
    let mut chosen = Vec::new();
    for set in candidates(stretch) {
        let mut all = Vec::with_capacity(set.len());
        for (value, label) in set {
            let label = label.map(|label| typeset(&label, SMALL, align)).transpose()?;
            all.push(Tick { value, label });
        }
        let fits = airy(&all, stretch, length, direction);
        chosen = all;
        if fits {
            break;
        }
    }
    let place = |tick: &Tick| stretch.place(tick.value, (0.0, length));
    let crowded = chosen.windows(2).any(|pair| (place(&pair[1]) - place(&pair[0])).abs() < CROWDED);
    if crowded {
        // All or none: a few surviving ones would look like data. Unnumbered multiples go first.
        chosen.retain(|tick| tick.label.is_some());
    }
    Ok(chosen)
}

/// Returns one tick for each name of an axis, whether they are airy or not.
///
/// # Errors
///
/// If a name cannot be set.
pub(super) fn named_ticks(axis: &Axis, direction: Direction) -> Result<Vec<Tick>, DrawingError> {
    let align = direction.align();
    let names = axis.names().iter().enumerate();
    let tick = |(k, name): (usize, &String)| {
        Ok(Tick { value: k as f64 + 1.0, label: Some(typeset(name, SMALL, align)?) })
    };
    names.map(tick).collect()
}

/// More labelled multiples of π than this, and fractions only repeat what whole ones say.
const MOST_MULTIPLES: usize = 7;

/// Returns whether neighbouring labels keep their distance.
fn airy(ticks: &[Tick], stretch: &Stretch, length: f64, direction: Direction) -> bool {
    let placed: Vec<(f64, f64)> = ticks
        .iter()
        .filter_map(|tick| {
            let width = tick.label.as_ref()?.extent.width();
            Some((stretch.place(tick.value, (0.0, length)), width))
        })
        .collect();
    if stretch.scale() == Scale::MultiplesOfPi && placed.len() > MOST_MULTIPLES {
        return false;
    }
    placed.windows(2).all(|pair| {
        let ((a, wide_a), (b, wide_b)) = (pair[0], pair[1]);
        let least = match direction {
            Direction::Vertical => 2.1 * SMALL,
            Direction::Horizontal if stretch.scale().is_logarithmic() => {
                (wide_a + wide_b) / 2.0 + 0.9 * SMALL
            }
            // Short numbers could stand closer, but an axis is not a ruler.
            Direction::Horizontal => ((wide_a + wide_b) / 2.0 + SMALL).max(44.0),
        };
        b - a >= least
    })
}

/// Returns possible sets of ticks in increasing order, the one with most labels first.
pub(super) fn candidates(stretch: &Stretch) -> Vec<Vec<(f64, Option<String>)>> {
    match stretch.scale() {
        Scale::Decades => decades(stretch),
        Scale::Octaves => octaves(stretch),
        Scale::Linear => linear(stretch),
        Scale::MultiplesOfPi => multiples_of_pi(stretch),
    }
}

const STRIDES: [i32; 13] = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100];

fn decades(stretch: &Stretch) -> Vec<Vec<(f64, Option<String>)>> {
    let (from, to) = (stretch.from(), stretch.to());
    let exponents = || from.log10().floor() as i32..=to.log10().ceil() as i32;
    // Few digits read better written out.
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

fn octaves(stretch: &Stretch) -> Vec<Vec<(f64, Option<String>)>> {
    let exponents = stretch.from().log2().floor() as i32..=stretch.to().log2().ceil() as i32;
    let number = |e: i32| match e {
        0..=16 => (1_u32 << e).to_string(),
        _ => format!("$2^{{{e}}}$"),
    };
    let set = |stride: i32| {
        let label = |e: i32| (e.rem_euclid(stride) == 0).then(|| number(e));
        let all = exponents.clone().map(|e| (2.0_f64.powi(e), label(e)));
        all.filter(|(value, _)| stretch.holds(*value)).collect::<Vec<_>>()
    };
    let numbered = |set: &Vec<(f64, Option<String>)>| set.iter().any(|(_, label)| label.is_some());
    STRIDES.into_iter().map(set).filter(numbered).collect()
}

fn linear(stretch: &Stretch) -> Vec<Vec<(f64, Option<String>)>> {
    // From a hundredth of the length upwards: a hundred labels never fit.
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

fn multiples_of_pi(stretch: &Stretch) -> Vec<Vec<(f64, Option<String>)>> {
    let mut sets = Vec::new();
    for (numerator, denominator) in [(1, 4), (1, 2), (1, 1), (2, 1), (4, 1), (8, 1), (16, 1)] {
        let step = std::f64::consts::PI * f64::from(numerator) / f64::from(denominator);
        let label = |k: f64| pi_fraction(k as i32 * numerator, denominator);
        sets.push(steps(stretch, step, 2, &label));
    }
    sets
}

/// Returns labelled multiples of `step`, and `parts − 1` unlabelled ticks between them.
fn steps(
    stretch: &Stretch,
    step: f64,
    parts: i32,
    label: &dyn Fn(f64) -> String,
) -> Vec<(f64, Option<String>)> {
    let small = step / f64::from(parts);
    let (first, last) = ((stretch.from() / small).floor(), (stretch.to() / small).ceil());
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
    use super::{Direction, Scale, Stretch, Tick, decimal, pi_fraction, ticks};

    fn chosen(scale: Scale, from: f64, to: f64, length: f64, direction: Direction) -> Vec<Tick> {
        let stretch = Stretch::new(scale, from, to).expect("a range");
        ticks(&stretch, length, direction).expect("labels of digits")
    }

    fn labels(ticks: &[Tick]) -> Vec<String> {
        ticks.iter().filter_map(|tick| Some(tick.label.as_ref()?.spoken.clone())).collect()
    }

    #[test]
    fn labels_thin_out_until_they_fit() {
        let all = chosen(Scale::Decades, 1e-4, 1.0, 300.0, Direction::Vertical);
        assert_eq!(labels(&all), ["10^-4", "10^-3", "10^-2", "10^-1", "10^0"]);
        assert_eq!(all.len(), 4 * 9 + 1, "ticks at 2 to 9 where there is space");
        let few = chosen(Scale::Decades, 1e-12, 1e2, 300.0, Direction::Vertical);
        assert_eq!(
            labels(&few),
            ["10^-12", "10^-10", "10^-8", "10^-6", "10^-4", "10^-2", "10^0", "10^2"]
        );
        assert_eq!(few.len(), 15, "unlabelled decades keep a short tick");
    }

    #[test]
    fn neighbouring_labels_never_overlap() {
        for length in [60.0, 100.0, 180.0, 300.0, 700.0] {
            for (scale, from, to) in [
                (Scale::Decades, 1e-20, 1e14),
                (Scale::Decades, 1.0, 4096.0),
                (Scale::Octaves, 1.0, 4096.0),
                (Scale::Linear, -1.3, 27.0),
                (Scale::MultiplesOfPi, -1.0, 14.0),
            ] {
                let stretch = Stretch::new(scale, from, to).expect("a range");
                let all = chosen(scale, from, to, length, Direction::Horizontal);
                let boxes: Vec<(f64, f64)> = all
                    .iter()
                    .filter_map(|tick| {
                        let extent = tick.label.as_ref()?.extent;
                        let x = stretch.place(tick.value, (0.0, length));
                        Some((x + extent.left, x + extent.right))
                    })
                    .collect();
                assert!(!boxes.is_empty(), "{scale:?} {length}");
                assert!(boxes.windows(2).all(|w| w[0].1 < w[1].0), "{scale:?} {length}: {boxes:?}");
            }
        }
    }

    #[test]
    fn numbers_are_written_as_in_print() {
        let n = chosen(Scale::Octaves, 1.0, 4096.0, 250.0, Direction::Horizontal);
        assert_eq!(labels(&n), ["1", "4", "16", "64", "256", "1024", "4096"]);
        let pi = chosen(Scale::MultiplesOfPi, -1.0, 13.6, 500.0, Direction::Horizontal);
        assert_eq!(labels(&pi), ["0", "π", "2π", "3π", "4π"]);
        let x = chosen(Scale::Linear, -2.0, 2.0, 200.0, Direction::Vertical);
        assert_eq!(labels(&x), ["−2", "−1", "0", "1", "2"]);
        assert_eq!(pi_fraction(-6, 4), "$-3π/2$");
        assert_eq!(decimal(-0.0, 1), "0.0");
    }
}
