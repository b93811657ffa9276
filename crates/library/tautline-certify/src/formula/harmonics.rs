//! `Harmonics`: waves of a form that share a phase.

use std::collections::BTreeMap;

use tautline_formula::Step;
use tautline_scalar::Interval;

use super::dependence::{LARGEST_RATIO, common_divisor};

/// What a wave reads: the step, and the multiple of the form in it.
pub(super) type Read = (Step, Interval);

/// A phase of each wave, and which multiple of it the wave reads.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Shared {
    /// The wave number of each phase: the phase is this number times the form.
    pub(super) wave_numbers: Vec<Interval>,
    /// For each wave, the number of its phase and the multiple, a nonzero integer.
    pub(super) waves: Vec<(usize, f64)>,
}

/// Wave numbers with a common divisor, in ascending order.
struct Harmonics {
    divisor: f64,
    sizes: Vec<f64>,
}

impl Harmonics {
    /// Adds a larger wave number, unless it would be too large a multiple of the common divisor.
    ///
    /// The divisor is exact. Multiplied by a power of two it does not round, so the comparison is
    /// exact too; where the product overflows, it holds.
    fn add(&mut self, size: f64) -> bool {
        let divisor = common_divisor(self.divisor, size);
        let is_near = size <= LARGEST_RATIO * divisor;
        if is_near {
            self.divisor = divisor;
            self.sizes.push(size);
        }
        is_near
    }

    fn contains(&self, size: f64) -> bool {
        self.sizes.binary_search_by(|known| known.total_cmp(&size)).is_ok()
    }
}

/// Groups the waves of a form by phases, each of which is numbered where its first wave is. Returns
/// `None` if there are more than `most` phases.
///
/// The wave numbers of a phase are integer multiples, by at most [`LARGEST_RATIO`], of their common
/// divisor, as exact numbers: `0.5` is no multiple of the double `0.1`. They are grouped in
/// ascending order, whatever the order of the waves, and a group is never left, so each wave has a
/// phase. A wave number that is no double has a phase of its own, shared only by the waves of the
/// same step.
pub(super) fn shared(waves: &[Read], most: usize) -> Option<Shared> {
    let size = |scale: Interval| (scale.lo() == scale.hi()).then(|| scale.lo().abs());
    let mut sizes: Vec<f64> = waves.iter().filter_map(|&(_, scale)| size(scale)).collect();
    sizes.sort_unstable_by(f64::total_cmp);
    sizes.dedup();
    let mut groups: Vec<Harmonics> = Vec::new();
    for size in sizes {
        if !groups.iter_mut().any(|group| group.add(size)) {
            groups.push(Harmonics { divisor: size, sizes: vec![size] });
        }
        if groups.len() > most {
            return None;
        }
    }
    let mut shared = Shared { wave_numbers: Vec::new(), waves: Vec::with_capacity(waves.len()) };
    let (mut of_groups, mut of_steps) = (vec![None; groups.len()], BTreeMap::new());
    for &(step, scale) in waves {
        let mut next = |wave_number: Interval| {
            shared.wave_numbers.push(wave_number);
            shared.wave_numbers.len() - 1
        };
        let wave = match size(scale) {
            Some(size) => {
                let group = groups.iter().position(|group| group.contains(size))?;
                let divisor = groups[group].divisor;
                let phase = *of_groups[group].get_or_insert_with(|| next(Interval::point(divisor)));
                // An integer of at most ten bits, so the quotient does not round.
                (phase, scale.lo() / divisor)
            }
            None => (*of_steps.entry(step).or_insert_with(|| next(scale)), 1.0),
        };
        if shared.wave_numbers.len() > most {
            return None;
        }
        shared.waves.push(wave);
    }
    Some(shared)
}

/// Returns whether a ratio of two wave numbers is, or may be, a quotient of integers of at most
/// [`LARGEST_RATIO`]. If it is, two phases with these wave numbers depend on each other noticeably.
pub(super) fn may_resonate(a: Interval, b: Interval) -> bool {
    if [a, b].iter().all(|it| it.lo() == it.hi()) {
        let divisor = common_divisor(a.magnitude(), b.magnitude());
        return a.magnitude().max(b.magnitude()) <= LARGEST_RATIO * divisor;
    }
    let ratio = a / b;
    let is_close = |n: u32| {
        let multiple = ratio * f64::from(n);
        let nearest = multiple.midpoint().round();
        nearest.abs() <= LARGEST_RATIO && multiple.contains(nearest)
    };
    ratio.is_undefined() || (1..=LARGEST_RATIO as u32).any(is_close)
}

#[cfg(test)]
mod tests {
    use tautline_scalar::{Interval, Scalar};

    use super::{Read, may_resonate, shared};

    fn points(scales: &[f64]) -> Vec<Read> {
        scales.iter().enumerate().map(|(step, &k)| (step as u32, Interval::point(k))).collect()
    }

    /// Checks that each wave number is exactly its multiple of that of its phase, in integers.
    fn check(scales: &[f64], phases: usize) {
        let shared = shared(&points(scales), 8).expect("few phases");
        assert_eq!(shared.wave_numbers.len(), phases, "{scales:?}: {shared:?}");
        for (&scale, &(phase, multiple)) in scales.iter().zip(&shared.waves) {
            let wave_number = shared.wave_numbers[phase];
            assert_eq!(wave_number.lo(), wave_number.hi());
            assert!(multiple.fract() == 0.0 && (1.0..=1024.0).contains(&multiple.abs()));
            // Integers in the unit of the last place of the wave number.
            let (mantissa, exponent) = integer(wave_number.lo());
            let (of_scale, other) = integer(scale);
            let product = mantissa * multiple as i128;
            let [product, of_scale] = [(product, exponent), (of_scale, other)]
                .map(|(m, e)| m << (e - exponent.min(other)));
            assert_eq!(product, of_scale, "{scale:e} {multiple} {wave_number:?}");
        }
    }

    /// Returns `m` and `e` with `x = m 2ᵉ`, where `m` is odd or `e = −1074`.
    fn integer(x: f64) -> (i128, i32) {
        let bits = x.abs().to_bits();
        let biased = (bits >> 52) as i32;
        let mantissa = (bits & ((1 << 52) - 1)) | if biased > 0 { 1 << 52 } else { 0 };
        let places = (mantissa.trailing_zeros() as i32).min(biased.max(1) - 1);
        let sign = if x < 0.0 { -1 } else { 1 };
        (sign * i128::from(mantissa >> places), biased.max(1) - 1075 + places)
    }

    /// As decimals they are multiples; as doubles all but the third pair are not.
    #[test]
    fn a_decimal_multiple_is_no_multiple_of_a_double() {
        check(&[0.1, 0.5], 2);
        check(&[0.1, 0.1 * 3.0, 0.3], 3);
        check(&[0.1, 0.8], 1);
        check(&[1.0 / 3.0, 2.0 / 3.0, 1.0], 2);
        check(&[0.7, -0.7, 1.4, 2.1], 2);
        check(&[1.0, 5.0_f64.next_up()], 2);
        check(&[0.3, 0.3_f64.next_up()], 2);
    }

    #[test]
    fn exact_multiples_share_a_phase_whatever_their_size_and_sign() {
        for unit in [1.0, 0.1, 1e-300, 5e-324, 2.0_f64.powi(-1070), 1e300, 1.7e305] {
            check(&[-4.0 * unit, 2.0 * unit], 1);
        }
        // A subnormal number has few bits: 7 · 5e-324 is exact.
        check(&[5e-324, 7.0 * 5e-324, -3.0 * 5e-324], 1);
        // 1024 times the divisor overflows.
        check(&[f64::MAX, -f64::MAX], 1);
        check(&[-0.75, 0.5, 1.25, 256.0], 1);
    }

    /// With 1024, 1 and ½, no phase can serve all; ½ and 1 go together, in each order.
    #[test]
    fn the_groups_do_not_depend_on_the_order_of_the_waves() {
        let all = [1024.0, 1.0, 0.5];
        for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
            let scales = order.map(|k| all[k]);
            check(&scales, 2);
            let shared = shared(&points(&scales), 8).expect("few");
            let of = |k: f64| shared.waves[scales.iter().position(|&it| it == k).expect("it")];
            assert_eq!([of(1024.0).1, of(1.0).1, of(0.5).1], [1.0, 2.0, 1.0]);
            assert_eq!(shared.waves[0].0, 0);
        }
    }

    /// `√2` is no double, and neither is `⅓`: what is known of them is an interval.
    #[test]
    fn a_wave_number_that_is_no_double_is_shared_by_the_waves_of_its_step() {
        let third = Interval::point(1.0) / 3.0;
        let waves = [(4, third), (7, third), (4, third), (2, Interval::point(1.0))];
        let shared = shared(&waves, 8).expect("few");
        assert_eq!(shared.waves, [(0, 1.0), (1, 1.0), (0, 1.0), (2, 1.0)]);
        assert_eq!(shared.wave_numbers, [third, third, Interval::point(1.0)]);
    }

    #[test]
    fn too_many_phases_are_refused() {
        let primes = [2.0, 3.0, 5.0, 7.0, 11.0].map(|p: f64| p.sqrt());
        assert!(shared(&points(&primes), 4).is_none());
        assert!(shared(&points(&primes), 5).is_some());
        let third = Interval::point(1.0) / 3.0;
        let thirds: Vec<Read> = (0..5).map(|step| (step, third)).collect();
        assert!(shared(&thirds, 4).is_none() && shared(&thirds, 5).is_some());
    }

    #[test]
    fn phases_resonate_if_their_ratio_is_simple() {
        let point = Interval::point;
        assert!(may_resonate(point(1.0), point(0.5)) && may_resonate(point(512.0), point(0.5)));
        assert!(!may_resonate(point(0.1), point(0.5)) && !may_resonate(point(2048.0), point(1.0)));
        let third = point(1.0) / 3.0;
        assert!(may_resonate(third, third * 2.0) && may_resonate(third, point(5.0)));
        assert!(!may_resonate(point(1.0), point(2.0).sqrt()));
        assert!(may_resonate(Interval::UNDEFINED, point(1.0)));
    }
}
