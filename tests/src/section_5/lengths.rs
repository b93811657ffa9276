//! The discrete lengths: `4π` for every `N`, where the distance is `8π`.

use std::f64::consts::{PI, TAU};

use tautline::{
    Interpolation, KnownDistance, LeftEndpoint, PointSequence, Rule, SVector, Trapezoidal,
    gallery::Valleys,
};

use crate::random::{at_most, for_all, sequence};

/// The minimum of both discrete lengths.
const DISCRETE: f64 = 4.0 * PI;

/// Lengths up to `10³`, a dozen roundings a chord.
const ROUNDING: f64 = 1e-12;

fn on_axis(x1: impl IntoIterator<Item = f64>) -> PointSequence<2> {
    let points = x1.into_iter().map(|x| SVector::from([x, 0.0])).collect();
    PointSequence::new(points).expect("two finite points at least")
}

/// Nondecreasing sequences of the valleys `0, 2π, 4π`.
fn left_minimisers(n: usize) -> Vec<PointSequence<2>> {
    let steps = (1..=n).flat_map(|leave| (leave..=n).map(move |arrive| (leave, arrive)));
    let valley =
        |k: usize, (leave, arrive)| f64::from(u8::from(k >= leave) + u8::from(k >= arrive));
    steps.map(|step| on_axis((0..=n).map(|k| TAU * valley(k, step)))).collect()
}

/// One jump over both ridges, read in the valley between.
fn trapezoidal_minimisers(n: usize) -> Vec<PointSequence<2>> {
    let jump = |at: usize| on_axis((0..=n).map(|k| if k < at { 0.0 } else { 2.0 * TAU }));
    (1..=n).map(jump).collect()
}

#[test]
fn section_5_no_sequence_has_a_discrete_length_below_4_pi() {
    for_all(5101, 1024, sequence::<2>(15.0), |sequence| {
        let mut points = sequence.into_points();
        let last = points.len() - 1;
        (points[0], points[last]) = (SVector::zeros(), SVector::from([2.0 * TAU, 0.0]));
        let sequence = PointSequence::new(points).expect("finite");
        let left = LeftEndpoint.length(&Valleys, &sequence);
        at_most("4π ≤ L_l,N", DISCRETE, left, ROUNDING)?;
        let trapezoidal = Trapezoidal.length(&Valleys, &sequence);
        at_most("4π ≤ L_tra,N", DISCRETE, trapezoidal, ROUNDING)
    });
}

#[test]
fn section_5_the_discrete_lengths_attain_4_pi_for_every_n() {
    for n in [1, 2, 3, 4, 7, 30] {
        let (left, trapezoidal) = (left_minimisers(n), trapezoidal_minimisers(n));
        assert_eq!((left.len(), trapezoidal.len()), (n * (n + 1) / 2, n));
        for line in left {
            assert!((LeftEndpoint.length(&Valleys, &line) - DISCRETE).abs() <= ROUNDING);
        }
        for line in trapezoidal {
            assert!((Trapezoidal.length(&Valleys, &line) - DISCRETE).abs() <= ROUNDING);
        }
    }
}

/// The distance is `8π`, and the curves through those sequences are that long: twice the
/// discrete length, for every `N`.
#[test]
fn section_5_the_curves_of_the_minimisers_are_8_pi_long() {
    let ends = [SVector::zeros(), SVector::from([2.0 * TAU, 0.0])];
    let distance = Valleys.distance(&ends[0], &ends[1]).expect("along x₁");
    assert!((distance - 8.0 * PI).abs() <= ROUNDING);
    for line in left_minimisers(5).iter().chain(&trapezoidal_minimisers(5)) {
        let length = Interpolation::new(line).length(&Valleys).value;
        assert!((length - 8.0 * PI).abs() <= ROUNDING, "{length}");
    }
}

/// All sequences on a grid with detours, steps back and both sides of the ends: exactly the
/// constructed ones attain `4π`.
#[test]
fn section_5_brute_force_counts_the_minimisers() {
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
            let line = PointSequence::new(points).expect("finite");
            // The next longer one is longer by the ridge of π/3, by far more than rounding.
            let attains = |length: f64| usize::from((length - DISCRETE).abs() <= ROUNDING);
            left += attains(LeftEndpoint.length(&Valleys, &line));
            trapezoidal += attains(Trapezoidal.length(&Valleys, &line));
        }
        assert_eq!((left, trapezoidal), (n * (n + 1) / 2, n), "N = {n}");
    }
}
