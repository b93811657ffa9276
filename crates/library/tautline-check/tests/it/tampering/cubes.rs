//! Changed cubes and levels.

use tautline_check::{Certificate, CheckError, Cubes, Level, Place, Region};

use super::BASE;
use crate::helpers::level;

/// Returns the certificate with other cubes at one level, with the same functions.
fn with_cubes(at: usize, keep: impl Fn(&Place<2>) -> bool) -> Certificate<2> {
    let mut certificate = BASE.certificate.clone();
    let cubes = certificate.levels[at].cubes();
    let places = cubes.places().iter().filter(|place| keep(place)).copied().collect();
    let cubes = Cubes::new(cubes.exponent(), places).expect("in range");
    let [x, y] = BASE.ends;
    let functions = [BASE.wave.calibration([x, y], 0.4), BASE.wave.calibration([y, x], 0.4)];
    certificate.levels[at] = level(at, &cubes, [&functions[0], &functions[1]]);
    certificate
}

#[test]
fn a_cube_of_the_geodesic_cannot_be_left_out() {
    for at in 0..4 {
        let side = BASE.certificate.levels[at].cubes().side();
        for x in BASE.wave.geodesic(BASE.ends, 7) {
            let gone = [(x[0] / side).floor() as i32, (x[1] / side).floor() as i32];
            let refused = with_cubes(at, |place| *place != gone).check();
            let is_missing = matches!(&refused, Err(CheckError::Missing { level, place })
                if *level == at && place[..] == gone);
            assert!(is_missing, "{refused:?}");
        }
    }
}

#[test]
fn a_cube_at_the_edge_of_a_level_cannot_be_left_out() {
    for at in 0..4 {
        let places = BASE.certificate.levels[at].cubes().places();
        for gone in [places[0], places[places.len() - 1]] {
            let refused = with_cubes(at, |place| *place != gone).check();
            let missing = CheckError::Missing { level: at, place: gone.to_vec() };
            assert_eq!(refused, Err(missing));
        }
    }
}

#[test]
fn a_smaller_region_is_refused() {
    let within = |place: &Place<2>| place[1].abs() < 8;
    let refused = with_cubes(0, within).check();
    assert!(matches!(refused, Err(CheckError::Missing { level: 0, .. })), "{refused:?}");
    for region in [Region::ExitOne, Region::ExitTwo] {
        let mut certificate = with_cubes(0, within);
        certificate.region = region;
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::Exit { .. })), "{refused:?}");
    }
}

/// More cubes than needed are no error, and prove at most as much.
#[test]
fn cubes_added_far_away_prove_no_more() {
    for at in 0..4 {
        let mut certificate = BASE.certificate.clone();
        let cubes = certificate.levels[at].cubes();
        let mut places = cubes.places().to_vec();
        places.extend((0..9).flat_map(|i| (0..9).map(move |j| [i + 900, j - 700])));
        let cubes = Cubes::new(cubes.exponent(), places).expect("in range");
        let [x, y] = BASE.ends;
        let functions = [BASE.wave.calibration([x, y], 0.4), BASE.wave.calibration([y, x], 0.4)];
        certificate.levels[at] = level(at, &cubes, [&functions[0], &functions[1]]);
        let proved = certificate.check().expect("nothing is missing");
        assert!(proved.lower <= BASE.proved.lower);
        BASE.assert_true(&Ok(proved));
    }
}

#[test]
fn an_intermediate_level_cannot_be_left_out() {
    for at in [1, 2] {
        let mut certificate = BASE.certificate.clone();
        certificate.levels.remove(at);
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::Sides { .. })), "{refused:?}");
    }
    // Without the first one, the next one lacks cubes of the region.
    let mut certificate = BASE.certificate.clone();
    certificate.levels.remove(0);
    let refused = certificate.check();
    assert!(matches!(refused, Err(CheckError::TooLarge { .. })), "{refused:?}");
}

#[test]
fn two_levels_cannot_change_places() {
    for (a, b) in [(0, 1), (1, 2), (2, 3), (0, 3)] {
        let mut certificate = BASE.certificate.clone();
        certificate.levels.swap(a, b);
        let refused = certificate.check();
        let is_refused =
            matches!(refused, Err(CheckError::Sides { .. } | CheckError::TooLarge { .. }));
        assert!(is_refused, "{a} {b}: {refused:?}");
    }
}

/// Cubes of two sizes would let `φ` jump between them. A level has one size, so a cube
/// that is replaced by its halves is missing.
#[test]
fn a_cube_cannot_be_replaced_by_its_halves() {
    let place = BASE.certificate.levels[1].cubes().places()[20];
    let mut certificate = with_cubes(1, |other| *other != place);
    let halves = (0..4).map(|at| [2 * place[0] + at / 2, 2 * place[1] + at % 2]).collect();
    let halves = Cubes::new(-6, halves).expect("in range");
    certificate.levels.insert(2, level(2, &halves, [&|x| x[0], &|x| -x[0]]));
    let refused = certificate.check();
    assert!(matches!(refused, Err(CheckError::Missing { level: 1, .. })), "{refused:?}");
}

/// The side is a power of two, and places are integers, both within bounds.
#[test]
fn sides_and_places_beyond_their_bounds_are_refused() {
    for exponent in [-201, 201, i32::MIN, i32::MAX] {
        assert_eq!(Cubes::new(exponent, vec![[0, 0]]), Err(CheckError::Side { exponent }));
    }
    for place in [(1 << 28) + 1, -(1 << 28) - 1, i32::MAX, i32::MIN] {
        assert_eq!(Cubes::new(0, vec![[0, place]]), Err(CheckError::Place { place }));
    }
    // 2²⁴ · 2²⁴ places, and as many and a row.
    let (corner, wide) = (1 << 24, 1 << 24);
    assert!(Cubes::new(0, vec![[-3, 5], [wide - 4, corner + 4]]).is_ok());
    for far in [[wide - 3, corner + 4], [wide - 4, corner + 5]] {
        assert_eq!(Cubes::new(0, vec![[-3, 5], far]), Err(CheckError::Apart));
    }
    // The product is above 2⁶⁴ here.
    assert_eq!(Cubes::new(0, vec![[-(1 << 28); 4], [1 << 28; 4]]), Err(CheckError::Apart));
    // All cubes moved by one place, or to another side.
    for at in 0..4 {
        let mut certificate = BASE.certificate.clone();
        let old = &BASE.certificate.levels[at];
        let places = old.cubes().places();
        let moved = places.iter().map(|&[i, j]| [i, j + 1]).collect();
        let moved = Cubes::new(old.cubes().exponent(), moved).expect("in range");
        certificate.levels[at] = Level::new(at, moved, old.values().clone()).expect("as many");
        let refused = certificate.check();
        assert!(matches!(refused, Err(CheckError::Missing { .. })), "{refused:?}");
        let larger = Cubes::new(old.cubes().exponent() + 1, places.to_vec()).expect("in range");
        certificate.levels[at] = Level::new(at, larger, old.values().clone()).expect("as many");
        BASE.assert_true(&certificate.check());
    }
}

/// The last level alone proves nothing about all curves.
#[test]
fn the_last_level_alone_is_refused() {
    let mut certificate = BASE.certificate.clone();
    certificate.levels.drain(..3);
    let refused = certificate.check();
    assert!(matches!(refused, Err(CheckError::TooLarge { .. })), "{refused:?}");
    certificate.levels.clear();
    assert_eq!(certificate.check(), Err(CheckError::Empty));
}
