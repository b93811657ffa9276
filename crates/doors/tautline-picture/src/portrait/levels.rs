//! Chooses the levels of filled contours: few, at round numbers, around all values.

use crate::Scale;

/// How the values of a field are shown.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Levels {
    /// There is no value.
    None,
    /// All values are the same, up to rounding.
    Constant(f64),
    /// There are bands between levels. Values beyond an open end have the colour of its band.
    Bands { scale: Scale, levels: Vec<f64>, open: [bool; 2] },
}

/// Positive values whose ratio is larger are shown on a logarithmic scale.
const RATIO: f64 = 30.0;
/// A field has at most this many bands, up to two more at its ends.
const BANDS: f64 = 9.0;
/// On a scale with more decades, rare values do not decide on the colours of all others.
const MANY_DECADES: f64 = 6.0;

impl Levels {
    /// Chooses levels for values in increasing order.
    pub(crate) fn of(sorted: &[f64]) -> Levels {
        let [Some(&low), Some(&high)] = [sorted.first(), sorted.last()] else {
            return Levels::None;
        };
        if high - low <= 1e-9 * low.abs().max(high.abs()) {
            return Levels::Constant(sorted[sorted.len() / 2]);
        }
        if low > 0.0 && high / low >= RATIO {
            return logarithmic(sorted, low, high);
        }
        Levels::Bands { scale: Scale::Linear, levels: linear(low, high), open: [false; 2] }
    }
}

fn logarithmic(sorted: &[f64], low: f64, high: f64) -> Levels {
    let at = |share: f64| sorted[(share * (sorted.len() - 1) as f64) as usize];
    let decades = |low: f64, high: f64| high.log10() - low.log10();
    let all = decades(low, high);
    let rare = |tail: f64| all > MANY_DECADES && tail > 0.25 * all;
    let open = [rare(decades(low, at(0.02))), rare(decades(at(0.98), high))];
    let low = if open[0] { at(0.02) } else { low };
    let high = if open[1] { at(0.98) } else { high };
    // Powers of ten as far away as they are numbers.
    let (first, last) = (low.log10().floor() as i32, high.log10().ceil() as i32);
    let power = |e: i32| 10.0_f64.powi(e.clamp(-307, 308));
    let spanned = decades(low, high);
    // Three bands in a decade, or two if there are more decades.
    let digits: &[f64] = if spanned <= 0.3 * BANDS { &[1.0, 2.0, 5.0] } else { &[1.0, 3.0] };
    let levels: Vec<f64> = if spanned <= 0.5 * BANDS {
        let all =
            (first - 1..=last + 1).flat_map(|e| digits.iter().map(move |digit| digit * power(e)));
        let all: Vec<f64> = all.collect();
        let from = all.iter().rposition(|level| *level <= low).unwrap_or(0);
        let to = all.iter().position(|level| *level >= high).unwrap_or(all.len() - 1);
        all[from..=to.max(from + 1)].to_vec()
    } else {
        // These are the strides of the numbers on a logarithmic axis.
        let strides = [1, 2, 3, 4, 5, 6, 8, 10, 15, 20, 30, 50, 100];
        let fits = |stride: &i32| f64::from(last - first) <= BANDS * f64::from(*stride);
        let stride = strides.into_iter().find(fits).unwrap_or(100);
        let ends = (first.div_euclid(stride), (last + stride - 1).div_euclid(stride));
        let mut levels: Vec<f64> = (ends.0..=ends.1).map(|k| power(k * stride)).collect();
        levels.dedup();
        levels
    };
    Levels::Bands { scale: Scale::Decades, levels, open }
}

/// Returns multiples of 1, 2 or 5 times a power of ten, from below `low` to above `high`.
fn linear(low: f64, high: f64) -> Vec<f64> {
    // Each end is divided, since their difference may overflow.
    let least = high / BANDS - low / BANDS;
    let power = 10.0_f64.powi(least.log10().floor() as i32);
    let steps = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power);
    let step = steps.into_iter().find(|step| *step >= least).unwrap_or(steps[3]);
    let (first, last) = ((low / step).floor() as i64, (high / step).ceil() as i64);
    (first..=last).map(|k| k as f64 * step).collect()
}

#[cfg(test)]
mod tests {
    use super::{Levels, Scale};

    #[test]
    fn levels_bracket_all_values() {
        for (low, high) in [
            (1.0, 9.0),
            (1.0, 3.0),
            (-4.0, 11.0),
            (0.0, 1e-12),
            (2e-9, 3e9),
            (1e-300, 1e300),
            (0.999, 1.001),
            (3e8, 5e8),
        ] {
            let sorted: Vec<f64> =
                (0..=100).map(|k| low + (high - low) * f64::from(k) / 100.0).collect();
            let Levels::Bands { levels, open, .. } = Levels::of(&sorted) else {
                panic!("{low} to {high} has no bands")
            };
            assert!(levels.windows(2).all(|pair| pair[0] < pair[1]), "{levels:?}");
            assert!((2..=12).contains(&levels.len()), "{levels:?}");
            assert!(open[0] || levels[0] <= low, "{levels:?} above {low}");
            assert!(open[1] || levels[levels.len() - 1] >= high, "{levels:?} below {high}");
        }
    }

    #[test]
    fn decades_have_a_logarithmic_scale() {
        let Levels::Bands { scale, levels, .. } = Levels::of(&[0.3, 1.0, 12.0]) else { panic!() };
        assert_eq!(scale, Scale::Decades);
        assert_eq!(levels, [0.2, 0.5, 1.0, 2.0, 5.0, 10.0, 20.0]);
        let Levels::Bands { scale, levels, .. } = Levels::of(&[-1.0, 100.0]) else { panic!() };
        assert_eq!((scale, levels[0]), (Scale::Linear, -20.0));
    }

    #[test]
    fn a_pole_does_not_decide_on_all_colours() {
        // The values of x⁻⁴: a few near the pole, most of them between 1 and 10⁴.
        let mut sorted: Vec<f64> = (1..=1000).map(|k| (f64::from(k) / 1000.0).powi(-4)).collect();
        sorted.sort_by(f64::total_cmp);
        let Levels::Bands { levels, open, .. } = Levels::of(&sorted) else { panic!() };
        assert_eq!(open, [false, true]);
        assert!(levels[levels.len() - 1] <= 1e8, "{levels:?}");
    }

    #[test]
    fn constants_have_no_bands() {
        assert_eq!(Levels::of(&[2.0, 2.0, 2.0 + 1e-12]), Levels::Constant(2.0));
        assert_eq!(Levels::of(&[0.0]), Levels::Constant(0.0));
        assert_eq!(Levels::of(&[]), Levels::None);
    }
}
