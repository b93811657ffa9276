//! Cases that caught a mistake: they were drawn at random, shrunk, and kept by name.
//!
//! The library passes each case, and a program with the mistake does not. The random checks of the
//! suite may one day draw other cases, but these stay. When a check fails on a random case, it
//! prints a test of that case, which can be pasted here unchanged.

use std::{any::Any, f64::consts::TAU};

use tautline::{
    Ball, Bounded, Constants, Ends, HalfSpace, PointSequence, SMatrix,
    gallery::{Constant, Shear},
};
use tautline_checks::battery::{Given, Scope, Trial, suite};
use tautline_kit::Chance;
use tautline_statements::{
    Evidence, Finding, Known, LIBRARY, Mutant, PaperRule, Reconstruction, Subject, Units,
    constant_c_tra, constant_k3_bar, critical_point, prop_7_9, section_5_left, theorem_1_1,
    theorem_1_2,
};

/// Asserts that the library passes the case and the mutant does not.
#[track_caller]
fn tells_apart(mutant: Mutant, case: impl Fn(&Subject) -> Evidence) {
    let sound = case(&LIBRARY);
    assert_eq!(sound.finding(), Finding::Holds, "{sound:?}");
    let wrong = case(&mutant.into());
    assert_ne!(wrong.finding(), Finding::Holds, "{mutant:?} passes: {wrong:?}");
}

/// Asserts the same for a statement about the trapezoidal minimiser with `n` subintervals.
#[track_caller]
fn minimiser_tells_apart<M: Bounded<2>>(
    mutant: Mutant,
    known: &Known<M, 2>,
    n: usize,
    statement: impl Fn(&Subject, &Reconstruction<2>) -> Evidence,
) {
    tells_apart(mutant, |subject| {
        let seen = Reconstruction::observe(subject, known, PaperRule::Trapezoidal, n);
        statement(subject, &seen.expect("a minimiser"))
    });
}

/// Runs a check of the suite on this case, which replaces the random cases of one family. The
/// family is named by its seed. `cargo xtask nightly` prints calls of this function.
#[track_caller]
fn holds(check: &str, family: u64, case: impl Any) {
    let found = suite().into_iter().find(|known| known.name == check);
    let given = Given::new(family, case);
    let trial = Trial { given: Some(&given), ..Trial::new(&LIBRARY, Scope::Everything, u32::MAX) };
    let outcome = found.unwrap_or_else(|| panic!("no check is called {check}")).run(&trial);
    assert!(given.was_taken(), "{check} draws no case of this type from the seed {family}");
    if let Err(failure) = outcome {
        panic!("{failure}");
    }
}

/// Returns the problem `H = ¼ I` from 0 to a point near `(1, 2)`. Since `C = 0`, every error shows.
fn quarter() -> Known<Constant<2>, 2> {
    let metric = Constant::new(SMatrix::identity() * 0.25).expect("positive definite");
    Known::between(metric, [0.0, 0.0], [0.9, 1.9136]).expect("finite").expect("known everywhere")
}

/// Returns a shear between two points.
fn shear(amplitude: f64, wave_number: f64, [a, b]: [[f64; 2]; 2]) -> Known<Shear, 2> {
    let metric = Shear::new(amplitude, wave_number).expect("a wave number");
    Known::between(metric, a, b).expect("finite").expect("known everywhere")
}

/// Returns a shear from the origin to the half-plane `{x₂ ≥ 1/5}`; the geodesic runs straight up.
fn straight_up(amplitude: f64) -> Known<Shear, 2> {
    let metric = Shear::new(amplitude, 0.5).expect("a wave number");
    let point = Ball::new([0.0, 0.0], 0.0).expect("a point");
    let half_plane = HalfSpace::at_least([0.0, 1.0], 0.2).expect("a direction");
    let ends = Ends::new(point, half_plane).expect("one is bounded");
    Known { metric, ends, distance: 0.2, distance_error: 2e-14 }
}

/// Generates one test per minimiser from the mutant, the problem, the number of subintervals and
/// the statement.
macro_rules! minimisers {
    ($($(#[$doc:meta])* $name:ident: $mutant:ident, $known:expr, $n:literal, $statement:expr;)*) => {
        $($(#[$doc])*
        #[test]
        fn $name() {
            minimiser_tells_apart(Mutant::$mutant, &$known, $n, $statement);
        })*
    };
}

minimisers! {
    half_of_the_energy_on_a_straight_line: EnergyHalved, quarter(), 1, theorem_1_1;
    the_energy_of_all_chords_but_the_last_on_a_straight_line:
        LastChordLost, quarter(), 2, theorem_1_1;
    k3_bar_without_the_distance_on_a_straight_line:
        DistanceForgotten, quarter(), 1, constant_k3_bar;
    an_end_point_a_millionth_off_on_a_straight_line: EndRelaxed, quarter(), 1, theorem_1_1;
    /// The energy of one chord on a shear, evaluated at one node, is less than the square of the
    /// distance.
    one_node_of_a_chord_on_a_shear:
        QuadratureOfOneNode,
        shear(
            0.577_034_596_844_456, 0.5,
            [[0.0, 0.0], [-1.782_908_291_752_968, 0.166_017_112_013_032_04]],
        ),
        1, theorem_1_1;
    /// The geodesic passes the steepest place of this shear.
    a_lipschitz_constant_a_tenth_too_small_on_a_shear:
        LipschitzTooSmall,
        shear(
            0.374_169_547_927_881_2, 0.5,
            [[-1.971_790_881_159_051_2, 0.0], [-2.031_890_739_852_592_7, 2.205_841_535_059_412_7]],
        ),
        3, theorem_1_1;
    /// The energy of the straight line exceeds what the bounds allow for a minimum.
    a_straight_line_on_a_shear:
        NotOptimised,
        shear(
            0.255_151_814_396_990_14, 0.5,
            [[-0.786_559_023_454_842_9, 0.0], [0.0, -2.261_642_456_117_900_5]],
        ),
        200, theorem_1_1;
    /// With one node per chord, the square of a length exceeds its energy.
    one_node_of_a_chord_from_a_point_to_a_half_plane:
        QuadratureOfOneNode, straight_up(0.182_596_145_964_421_17), 1, theorem_1_2;
}

/// From a point to a half-plane, the mutant uses the mean of `H` over the ends of a chord instead
/// of `H` at its midpoint. Its minimiser meets the line at a slant.
#[test]
fn the_mean_over_the_ends_of_a_chord_from_a_point_to_a_half_plane() {
    let known = straight_up(-0.303_127_440_325_200_7);
    minimiser_tells_apart(Mutant::TrueTrapezoid, &known, 2, |subject, seen| {
        critical_point(subject, &known, seen)
    });
}

#[test]
fn sums_of_squares_for_lengths_on_one_chord_over_the_valleys() {
    let chord = PointSequence::straight([0.0, 0.0], [2.0 * TAU, 0.0], 1).expect("finite");
    for mutant in [Mutant::RootLost, Mutant::LengthFromEnergy] {
        tells_apart(mutant, |subject| {
            section_5_left(subject, Units::ONE, &chord).expect("a sequence")
        });
    }
}

/// `c₁ = c₂ = ⅛`, `L_H = d = 1/16` and `D = 1` are the smallest numbers that reveal the mutant.
#[test]
fn c_tra_without_its_term_of_second_order() {
    let constants = Constants::new(0.125, 0.125, 0.0625).expect("in order");
    let k1 = 0.0625 / 0.125_f64.sqrt();
    let k2 = 1.5 * 0.0625 / 0.125 * k1 * k1;
    let two = std::num::NonZeroUsize::MIN.saturating_add(1);
    tells_apart(Mutant::SecondOrderForgotten, |subject| {
        constant_c_tra(subject, constants, [k1, k2], two)
    });
}

/// The quotient `0 / 0` must not pass for a bound.
#[test]
fn a_sequence_that_stays_where_it_is() {
    let metric = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
    let still = PointSequence::straight([0.0, 0.0], [0.0, 0.0], 1).expect("finite");
    tells_apart(Mutant::PowerOfK3Lost, |subject| {
        prop_7_9(subject, &metric, &still).expect("a sequence")
    });
}

#[test]
fn one_node_of_a_chord_on_a_shear_as_it_is_printed() {
    use tautline::Ends;
    use tautline::gallery::Shear;
    use tautline_statements::Known;
    let case: (Known<Shear, 2>, usize) = (
        Known {
            metric: Shear::new(0.577034596844456, 0.5).expect("drawn"),
            ends: Ends::points([0.0, 0.0], [-1.782908291752968, 0.16601711201303204])
                .expect("drawn"),
            distance: 1.742988927412305,
            distance_error: 7.345127415241092e-15,
        },
        1,
    );
    holds("theorems_1_1_and_1_2_hold_between_points", 1102, case);
}

#[test]
fn a_sequence_that_stays_where_it_is_as_it_is_printed() {
    use tautline::PointSequence;
    use tautline::SVector;
    use tautline::gallery::Shear;
    let case: (Shear, PointSequence<2>) = (
        Shear::new(0.12162467933478455, 0.5).expect("drawn"),
        PointSequence::new(vec![
            SVector::from([0.0, 1.3588237330161674]),
            SVector::from([0.0, 1.3588237330161674]),
        ])
        .expect("drawn"),
    );
    holds("props_7_9_8_1_and_8_2_hold_for_random_sequences", 7901, case);
}

#[test]
fn christoffel_symbols_twice_too_large_as_they_are_printed() {
    use tautline::SVector;
    use tautline::gallery::Shear;
    let case: (Shear, SVector<f64, 2>) = (
        Shear::new(-0.2300024275066365, 0.5).expect("drawn"),
        SVector::from([0.0, 3.2172474783902647]),
    );
    holds("props_7_10_and_7_11_hold_for_random_metrics", 7101, case);
}

/// The three tests above are what the checks print for these mutants, apart from line breaks and
/// names. This shows that the printed tests compile and are about the case that failed.
#[test]
fn what_a_failing_check_prints_stands_above() {
    let words = |text: &str| {
        let text: String = text.split_whitespace().collect();
        text.replace(",)", ")").replace(",]", "]").replace(",}", "}")
    };
    let above = words(include_str!("promoted_cases.rs"));
    for (mutant, check) in [
        (Mutant::QuadratureOfOneNode, "theorems_1_1_and_1_2_hold_between_points"),
        (Mutant::PowerOfK3Lost, "props_7_9_8_1_and_8_2_hold_for_random_sequences"),
        (Mutant::ChristoffelDoubled, "props_7_10_and_7_11_hold_for_random_metrics"),
    ] {
        let subject = mutant.into();
        let trial = Trial::new(&subject, Scope::Everything, u32::MAX);
        let found = suite().into_iter().find(|known| known.name == check).expect("listed");
        let failure = found.run(&trial).expect_err("a mutant");
        let said = failure.of_check(check, Chance::FIXED);
        assert!(said.contains(&format!("again: cargo test -p tests {check}\n")), "{said}");
        let asked = Chance::new(Some("7"), Some("2")).expect("numbers");
        let again =
            format!("again: TAUTLINE_SEED=7 TAUTLINE_CASES=2 cargo test -p tests {check}\n");
        assert!(failure.of_check(check, asked).contains(&again));
        let (_, printed) = said.split_once("\n#[test]\n").expect("a random case");
        let (_, body) = printed.split_once('{').expect("a function");
        assert!(above.contains(&words(body)), "{mutant:?} prints\n{printed}");
    }
}
