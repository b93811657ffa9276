//! Section 5: over the valleys, from `(0, 0)` to `(4π, 0)`, the minima of the discrete lengths do
//! not converge to the distance `8π`, but the minima of the discrete energies do.

use std::f64::consts::{PI, TAU};

use nalgebra::SVector;
use proptest::prelude::Strategy;
use tautline::{Ends, KnownDistance, PointSequence, Rule, gallery::Valleys};
use tautline_statements::{
    Evidence, LIBRARY,
    Statement::{self, Section5Left, Section5Trapezoidal, Theorem1_1, Theorem1_3},
    Subject, Units, VerifyError, section_5_left, section_5_trapezoidal,
    witnesses::valley_jump,
};

use crate::battery::{
    cases::admissible,
    harness::{
        Check, Dropped, Failure, Homogeneous, Order, Outcome, Random, Trial, Witness, all, close,
        fails_without,
    },
};
use crate::strategies::sequence;

const BOTH: &[Statement] = &[Section5Left, Section5Trapezoidal];

pub(crate) const CHECKS: &[Check] = &[
    Random.check("section_5_no_sequence_has_a_discrete_length_below_4_pi", BOTH, random),
    Homogeneous.check("section_5_is_homogeneous", BOTH, homogeneous),
    Witness.check("section_5_the_discrete_lengths_attain_4_pi_for_every_n", BOTH, attained),
    Witness.check("section_5_brute_force_counts_the_minimisers", BOTH, counted),
    Witness.check(
        "section_5_the_left_rule_reads_the_point_where_a_chord_begins",
        BOTH,
        left_is_left,
    ),
    Dropped.check("section_5_fails_between_other_ends", BOTH, other_ends),
    Witness.check("section_5_one_jump_undershoots_for_n_up_to_3", &[Theorem1_1], one_jump),
    Order.check(
        "section_5_the_roots_of_the_energies_converge_to_the_distance",
        &[Theorem1_1, Theorem1_3],
        roots_converge,
    ),
];

fn evidence(
    subject: &Subject,
    units: Units,
    sequence: &PointSequence<2>,
) -> Result<[Evidence; 2], VerifyError> {
    let sequence = units.sequence(sequence)?;
    Ok([
        section_5_left(subject, units, &sequence)?,
        section_5_trapezoidal(subject, units, &sequence)?,
    ])
}

/// Evaluates both claims on sequences with detours, and on sequences that lead from valley to
/// valley, as the minimisers of the lengths do.
fn random(trial: &Trial<'_>) -> Outcome {
    all([
        trial.for_all(5101, 768, sequence::<2>(15.0), |subject, sequence| {
            evidence(subject, Units::ONE, &admissible(&LIBRARY, &valleys()?, sequence)?)
        }),
        trial.for_all(5102, 512, near_valleys(), |subject, sequence| {
            evidence(subject, Units::ONE, &admissible(&LIBRARY, &valleys()?, sequence)?)
        }),
    ])
}

/// Draws points that are at most a hundredth away from the valleys `−2π, 0, …, 6π` and from the
/// axis.
fn near_valleys() -> impl Strategy<Value = PointSequence<2>> {
    let point = (-1..4_i32, -0.01..0.01, -0.01..0.01);
    proptest::collection::vec(point, 2..20).prop_map(|drawn| {
        let at = |(k, off, x2): (i32, f64, f64)| SVector::from([TAU * f64::from(k) + off, x2]);
        let points = drawn.into_iter().map(at).collect();
        PointSequence::new(points).expect("two finite points at least")
    })
}

fn homogeneous(trial: &Trial<'_>) -> Outcome {
    trial.homogeneous(5110, 128, sequence::<2>(15.0), |subject, sequence, units| {
        evidence(subject, units, &admissible(&LIBRARY, &valleys()?, sequence)?)
    })
}

/// Every minimiser of either length has length `4π` by the rule, and length `8π` along the curve.
fn attained(trial: &Trial<'_>) -> Outcome {
    let ends = [SVector::zeros(), SVector::from([2.0 * TAU, 0.0])];
    let distance = Valleys.distance(&ends[0], &ends[1]);
    // The distance has two roundings of a number of size 25.
    close("d", distance.unwrap_or(f64::NAN), 8.0 * PI, 1e-14)?;
    // The overestimation is 1 up to rounding, far below that of the next longer sequences.
    const ONE: f64 = 1.0 + 1e-12;
    let attained = |evidence: Evidence, claim| {
        evidence.claim_is_attained(claim, ONE)?.claim_is_attained("8π ≤ L(γᵖˡ)", ONE)
    };
    let mut found = Vec::new();
    for n in [1, 2, 3, 4, 7, 30] {
        for (arrive, leave) in (1..=n).flat_map(|arrive| (1..=arrive).map(move |k| (arrive, k))) {
            let line = valley_jump(n, leave, arrive);
            let [left, trapezoidal] = evidence(trial.subject, Units::ONE, &line)?;
            found.push(attained(left, "4π ≤ L_l,N(γᵖ)")?);
            if leave == arrive {
                found.push(attained(trapezoidal, "4π ≤ L_tra,N(γᵖ)")?);
            }
        }
    }
    trial.one(found)
}

/// Tries all sequences on a grid, including detours, backward steps and points beyond either end.
/// Exactly `N (N + 1)/2` of them attain `4π` for the left rule, and exactly `N` for the trapezoidal
/// rule: those constructed above.
fn counted(trial: &Trial<'_>) -> Outcome {
    let grid: Vec<SVector<f64, 2>> = (-3..=15)
        .flat_map(|k| [0.0, 0.5].map(|x2| SVector::from([f64::from(k) * PI / 3.0, x2])))
        .collect();
    for n in 1..=4_usize {
        let (mut left, mut trapezoidal) = (0, 0);
        for index in 0..grid.len().pow(n as u32 - 1) {
            let inner = (1..n).map(|k| grid[index / grid.len().pow(k as u32 - 1) % grid.len()]);
            let mut points = vec![SVector::zeros()];
            points.extend(inner);
            points.push(SVector::from([2.0 * TAU, 0.0]));
            let line = PointSequence::new(points)?;
            // The next longer sequence crosses the ridge at π/3, which adds far more than rounding.
            let attains = |length: f64| usize::from((length - 4.0 * PI).abs() <= 1e-12);
            left += attains(trial.subject.discrete_length(Rule::LEFT_ENDPOINT, &Valleys, &line));
            trapezoidal +=
                attains(trial.subject.discrete_length(Rule::TRAPEZOIDAL, &Valleys, &line));
        }
        if (left, trapezoidal) != (n * (n + 1) / 2, n) {
            let message = format!("N = {n}: {left} and {trapezoidal} minimisers");
            return Err(Failure::new(message));
        }
    }
    Ok(Default::default())
}

/// One chord leads from a valley up to a ridge, `0, π`, or back down, `π, 0`. Its length is `π` and
/// `3π`, respectively, for the left rule, and `π f(π/2) = 2π` both ways for the trapezoidal rule.
/// The minima alone do not distinguish the left end of a chord from the right end.
fn left_is_left(trial: &Trial<'_>) -> Outcome {
    for ([a, b], left, trapezoidal) in [([0.0, PI], PI, 2.0 * PI), ([PI, 0.0], 3.0 * PI, 2.0 * PI)]
    {
        let line = PointSequence::straight([a, 0.0], [b, 0.0], 1)?;
        let found = trial.subject.discrete_length(Rule::LEFT_ENDPOINT, &Valleys, &line);
        close("L_l,1", found, left, 1e-14)?;
        let found = trial.subject.discrete_length(Rule::TRAPEZOIDAL, &Valleys, &line);
        close("L_tra,1", found, trapezoidal, 1e-14)?;
    }
    Ok(Default::default())
}

/// On one chord up to the first ridge, from 0 to `π`, the left rule evaluates `H` in the valley and
/// the trapezoidal rule half-way up, which gives the lengths `π` and `2π`. One chord down from the
/// last ridge, from `3π` to `4π`, has the lengths `3π` and `2π`. All of these are less than `4π`.
fn other_ends(_: &Trial<'_>) -> Outcome {
    for ([a, b], clause, lengths) in [
        ([0.0, PI], "γᵖ ends at (4π, 0)", [PI, TAU]),
        ([3.0 * PI, 2.0 * TAU], "γᵖ begins at (0, 0)", [3.0 * PI, TAU]),
    ] {
        let line = PointSequence::straight([a, 0.0], [b, 0.0], 1)?;
        let claims = ["4π ≤ L_l,N(γᵖ)", "4π ≤ L_tra,N(γᵖ)"];
        let seen = evidence(&LIBRARY, Units::ONE, &line)?;
        for ((evidence, claim), length) in seen.into_iter().zip(claims).zip(lengths) {
            close(claim, evidence.conclusion(claim).bound, length, 1e-14)?;
            fails_without(&[clause], evidence)?;
        }
    }
    Ok(Default::default())
}

fn valleys() -> Result<Ends<2>, VerifyError> {
    Ok(Ends::points([0.0, 0.0], [2.0 * TAU, 0.0])?)
}

/// One jump has the discrete energy `16π²N`, which is less than `d² = 64π²` for `N ≤ 3`, while the
/// energy of the curve is `72π²N`. For small `N` the minima of the discrete energies are therefore
/// also less than `d²`.
fn one_jump(trial: &Trial<'_>) -> Outcome {
    let (subject, d2) = (trial.subject, 64.0 * PI * PI);
    for n in 1..=8 {
        let jump = valley_jump(n, 1, 1);
        let (count, energy) =
            (n as f64, subject.discrete_energy(Rule::TRAPEZOIDAL, &Valleys, &jump));
        let expected = 16.0 * PI * PI * count;
        close("E_tra,N", energy, expected, 1e-14 * expected)?;
        if (energy < d2) != (n <= 3) {
            return Err(Failure::new(format!("N = {n}: {energy} beside {d2}")));
        }
        let curve = subject.curve_energy(&Valleys, &jump).value;
        close("E(γᵖˡ)", curve, 4.5 * expected, 1e-14 * 4.5 * expected)?;
        let minimum = subject.minimise(Rule::TRAPEZOIDAL, &Valleys, &valleys()?, n);
        let found = minimum?.energy;
        if !(found <= energy * (1.0 + 1e-14)) {
            return Err(Failure::new(format!("N = {n}: {found} is above {energy}")));
        }
        if n == 1 {
            // With one chord between two points there is only one sequence.
            close("min E_tra,1", found, expected, 1e-14 * expected)?;
        }
    }
    Ok(Default::default())
}

/// `√E_N → 8π`, unlike the discrete lengths. With `γ̇ = d/f` and `dt = f dx/d` the leading
/// constants are
///
/// ```text
/// (1/12) ∫ γ̈ᵀHγ̈ dt = (d³/12) ∫ f′²/f³ dx = (d³/24) ∫ f″/f² dx = d³ π/18√3
/// N² (E_tra,N − d²) → −(d³/12) ∫ f″/f² dx = −d³ π/9√3,   ∫ cos x/(2 − cos x)² dx = 4π/3√3 on [0, 4π]
/// ```
fn roots_converge(trial: &Trial<'_>) -> Outcome {
    let (subject, ends, d2) = (trial.subject, valleys()?, 64.0 * PI * PI);
    let scaled = |n: usize| -> Result<[f64; 2], VerifyError> {
        let line = subject.minimise(Rule::TRAPEZOIDAL, &Valleys, &ends, n)?.sequence;
        let discrete = subject.discrete_energy(Rule::TRAPEZOIDAL, &Valleys, &line);
        let curve = subject.curve_energy(&Valleys, &line).value;
        Ok([discrete, curve].map(|e| (n * n) as f64 * (e - d2)))
    };
    // Another program measured these values at N = 256, to six decimals. Rounding contributes 2^16
    // times a few ulps of 632, which are 1e-13. The energy of the curve is not stationary:
    // decrements of 1e-18 of 632 change it by 2 (632e-18 · 0.024)^{1/2} = 8e-9, times 2^16.
    let [discrete, curve] = scaled(256)?;
    close("N² (E_tra,N − d²) at 256", discrete, -3201.762884, 1e-6)?;
    close("N² (E(γᵖˡ) − d²) at 256", curve, 1604.101685, 6e-4)?;
    // After one extrapolation the next term is smaller by the factor (10/256)⁴.
    let (coarse, fine) = (scaled(512)?, scaled(1024)?);
    let [discrete, curve] = [0, 1].map(|i| (4.0 * fine[i] - coarse[i]) / 3.0);
    let expected = (8.0 * PI).powi(3) * PI / (9.0 * 3_f64.sqrt());
    close("N² (E_tra,N − d²)", discrete, -expected, 1e-5 * expected)?;
    close("N² (E(γᵖˡ) − d²)", curve, 0.5 * expected, 1e-5 * expected)?;
    let left = subject.minimise(Rule::LEFT_ENDPOINT, &Valleys, &ends, 4096)?;
    let root = subject.discrete_energy(Rule::LEFT_ENDPOINT, &Valleys, &left.sequence).sqrt();
    // By symmetry this error is of order 2 too, with about ten times the constant.
    close("√E_l,N", root, 8.0 * PI, 1e4 / (4096.0 * 4096.0))
}
