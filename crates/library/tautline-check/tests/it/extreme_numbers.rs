//! Places and values near the largest numbers: they prove nothing false, and nothing panics.

use tautline_check::{Certificate, CheckError, Cubes, Level, Region};
use tautline_formula::Formula;

use crate::helpers::point;

fn flat_line() -> Formula<1> {
    Formula::parse("1 I", &[]).expect("a formula")
}

/// The cubes near `10⁸` would have places beyond the integers. If they wrapped around, none would
/// be required, and no cubes at all would prove that the distance 1 is at least 5.
#[test]
fn places_beyond_the_integers_are_refused() {
    let sets = [point([1e8]), point([1e8 + 1.0])];
    for exponent in [-8, -24, -60, -150, -200] {
        let cubes = Cubes::new(exponent, Vec::new()).expect("no cubes");
        let levels = vec![Level::new(0, cubes, [Vec::new(), Vec::new()]).expect("no values")];
        for region in [Region::Declared { c1: 1.0 }, Region::ExitOne, Region::ExitTwo] {
            let (formula, sets, hi) = (flat_line(), sets.clone(), 5.0);
            let levels = levels.clone();
            let certificate = Certificate { formula, sets, hi, region, curve: None, levels };
            let refused = certificate.check().expect_err("no cubes");
            let is_range =
                matches!(refused, CheckError::TooFar { .. } | CheckError::TooLarge { .. });
            assert!(is_range, "{exponent} {region:?}: {refused}");
        }
    }
}

/// The level a tenth beyond the largest value overflows. A bound that is unknown for that reason
/// must not be taken for one that holds: the distance is 100.
#[test]
fn levels_that_overflow_do_not_prove_an_exit() {
    let cubes = Cubes::new(0, vec![[-2], [-1], [0], [1]]).expect("in range");
    let (start, low, high) = (0.2e308, -0.5e308, f64::MAX);
    let half = vec![high, 0.0, low, 0.0, start, 0.0, low, 0.0, high];
    for values in [half.clone(), half.iter().map(|v| 0.999 * v).collect()] {
        let levels = vec![Level::new(0, cubes.clone(), [values.clone(), values]).expect("finite")];
        let certificate = Certificate {
            formula: flat_line(),
            sets: [point([0.0]), point([100.0])],
            hi: 1e6,
            region: Region::ExitOne,
            curve: None,
            levels,
        };
        let refused = certificate.check().expect_err("short curves leave the cubes");
        assert!(matches!(refused, CheckError::Exit { .. }), "{refused}");
    }
}
