//! Where an axis has ticks, and which of them have a number.

use super::{
    axis::Axis,
    scale::Scale,
    stretch::Stretch,
    tick_values::{TickValues, candidates},
};
use crate::{
    error::DrawingError,
    math_text::{Align, TextBlock, typeset},
    measures::SMALL,
};

/// A mark on an axis.
#[derive(Clone, Debug)]
pub(crate) struct Tick {
    /// Its value.
    pub value: f64,
    /// Its number; a tick without a number is drawn shorter.
    pub label: Option<TextBlock>,
}

/// The direction of an axis; labels along it must not overlap.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// An `x` axis.
    Horizontal,
    /// A `y` axis.
    Vertical,
}

impl Direction {
    /// The alignment of labels with their ticks.
    fn align(self) -> Align {
        if self == Direction::Horizontal { Align::Centre } else { Align::Right }
    }
}

/// Ticks that are closer together than this, in px, are omitted.
const CROWDED: f64 = 2.5;

/// Returns the ticks of a stretch that is `length` px long, with the densest numbering that has
/// enough space.
///
/// # Errors
///
/// If a label cannot be set, which is a defect of the font.
pub(crate) fn ticks(
    stretch: &Stretch,
    length: f64,
    direction: Direction,
) -> Result<Vec<Tick>, DrawingError> {
    fitting(candidates(stretch), stretch, length, direction)
}

/// Does the same with numbers at some of the `values` only, and no other ticks. If no round numbers
/// are among the values, there are no ticks.
///
/// # Errors
///
/// The same as those of [`ticks`].
pub(crate) fn ticks_at(
    values: &[f64],
    stretch: &Stretch,
    length: f64,
    direction: Direction,
) -> Result<Vec<Tick>, DrawingError> {
    let is_value = |at: f64| values.iter().any(|value| (value - at).abs() <= 1e-9 * at.abs());
    let mut sets = candidates(stretch);
    for set in &mut sets {
        set.retain(|(_, label)| label.is_some());
    }
    sets.retain(|set| set.iter().all(|(at, _)| is_value(*at)));
    fitting(sets, stretch, length, direction)
}

fn fitting(
    sets: Vec<TickValues>,
    stretch: &Stretch,
    length: f64,
    direction: Direction,
) -> Result<Vec<Tick>, DrawingError> {
    let align = direction.align();
    let mut chosen = Vec::new();
    let last = sets.len().saturating_sub(1);
    for (k, set) in sets.into_iter().enumerate() {
        let labels = set.iter().filter(|(_, label)| label.is_some()).count();
        // Setting labels takes most of the time of a figure, so hopeless sets are not set. The last
        // one is drawn even if it does not fit.
        let room = length + 1.0;
        if k < last && labels.saturating_sub(1) as f64 * least_gap(stretch, direction) > room {
            continue;
        }
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
        // Either all or none are kept: a few unnumbered ticks would look like data.
        chosen.retain(|tick| tick.label.is_some());
    }
    Ok(chosen)
}

/// Returns one tick for each name of an axis, even if they are crowded.
///
/// # Errors
///
/// If a name cannot be set.
pub(crate) fn named_ticks(axis: &Axis, direction: Direction) -> Result<Vec<Tick>, DrawingError> {
    let align = direction.align();
    let names = axis.names.iter().enumerate();
    let tick = |(k, name): (usize, &String)| {
        Ok(Tick { value: k as f64 + 1.0, label: Some(typeset(name, SMALL, align)?) })
    };
    names.map(tick).collect()
}

/// Returns the smallest distance between two labelled ticks, in px, however narrow their labels.
fn least_gap(stretch: &Stretch, direction: Direction) -> f64 {
    match direction {
        Direction::Vertical => 2.1 * SMALL,
        Direction::Horizontal if stretch.scale.is_logarithmic() => 0.9 * SMALL,
        // Short numbers could be closer together, but an axis is not a ruler.
        Direction::Horizontal => 44.0,
    }
}

/// The largest number of labelled multiples of π. Beyond it whole multiples serve as well as
/// fractions.
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
    if stretch.scale == Scale::MultiplesOfPi && placed.len() > MOST_MULTIPLES {
        return false;
    }
    placed.windows(2).all(|pair| {
        let ((a, wide_a), (b, wide_b)) = (pair[0], pair[1]);
        let (gap, widths) = (least_gap(stretch, direction), (wide_a + wide_b) / 2.0);
        let least = match direction {
            Direction::Vertical => gap,
            Direction::Horizontal if stretch.scale.is_logarithmic() => widths + gap,
            Direction::Horizontal => (widths + SMALL).max(gap),
        };
        b - a >= least
    })
}

#[cfg(test)]
mod tests {
    use super::{Direction, Scale, Stretch, Tick, ticks, ticks_at};

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
    }

    #[test]
    fn numbers_can_be_confined_to_values() {
        let stretch = Stretch::new(Scale::Linear, 0.0, 10.0).expect("a range");
        let at = |values: &[f64]| {
            labels(&ticks_at(values, &stretch, 300.0, Direction::Vertical).expect("digits"))
        };
        assert_eq!(at(&[0.0, 2.0, 4.0, 6.0, 8.0, 10.0]), ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(at(&[0.0, 5.0, 10.0]), ["0", "5", "10"]);
        assert!(at(&[0.3, 0.7]).is_empty());
    }
}
