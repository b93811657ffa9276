//! The gap between the discrete energy of any rule and that of the reconstructed curve.

use nalgebra::{SMatrix, SVector, vector};
use proptest::prelude::*;
use tautline_discretizations::{Interpolation, PeanoConstants, PointSequence, Rule};
use tautline_metrics::{Bounded, Metric, Scalar, gallery::Valleys};

/// The metric `1 + L x + M x²/2` on a line.
struct Parabola {
    slope: f64,
    bend: f64,
}

impl Metric<1> for Parabola {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_element(x[0].sqr() * (0.5 * self.bend) + x[0] * self.slope + 1.0)
    }
}

/// Returns `E(γᵖˡ) − E_N` and the tolerance for the comparison: the quadrature is exact to rounding
/// for these metrics, and the energies have a few dozen terms.
fn gap<M: Metric<D>, const D: usize>(
    rule: Rule,
    metric: &M,
    sequence: &PointSequence<D>,
) -> (f64, f64) {
    let energy = Interpolation::new(sequence).energy(metric);
    (energy.value - rule.energy(metric, sequence), energy.error + 1e-13 * energy.value)
}

/// A linear metric attains the first constant of a rule with its node at one end, a parabola the
/// second constant of a rule whose kernel has one sign.
#[test]
fn the_gap_bounds_are_attained() {
    for n in [1, 2, 7] {
        let line = PointSequence::straight([0.0], [2.0], n).expect("finite");
        let linear = Parabola { slope: 0.7, bend: 0.0 };
        let left = PeanoConstants::of(Rule::LEFT_ENDPOINT).gap(&line, 0.7);
        let right = PeanoConstants::of(Rule::RIGHT_ENDPOINT).gap(&line, 0.7);
        let parabola = Parabola { slope: 0.2, bend: 0.9 };
        let middle = PeanoConstants::of(Rule::TRAPEZOIDAL).smooth_gap(&line, 0.9);
        let ends = PeanoConstants::of(Rule::TRUE_TRAPEZOID).smooth_gap(&line, 0.9);
        for ((found, rounding), bound) in [
            (gap(Rule::LEFT_ENDPOINT, &linear, &line), left),
            (gap(Rule::RIGHT_ENDPOINT, &linear, &line), -right),
            (gap(Rule::TRAPEZOIDAL, &parabola, &line), middle),
            (gap(Rule::TRUE_TRAPEZOID, &parabola, &line), -ends),
        ] {
            assert!((found - bound).abs() <= rounding, "N = {n}: {found} {bound}");
            assert!(bound.abs() > 100.0 * rounding);
        }
    }
}

/// Each chord has a gap of its own, as its third or fourth power: with chords of different lengths the sum is
/// more than the power of their mean would allow. A sequence that goes on in one direction attains the
/// bounds, whatever its chords.
#[test]
fn the_gap_bounds_are_attained_by_chords_of_different_lengths() {
    let points = [0.0, 0.1, 0.9, 1.0, 2.5].map(|x| vector![x]).to_vec();
    let line = PointSequence::new(points).expect("finite");
    let (linear, parabola) =
        (Parabola { slope: 0.7, bend: 0.0 }, Parabola { slope: 0.2, bend: 0.9 });
    let first = PeanoConstants::of(Rule::LEFT_ENDPOINT).gap(&line, 0.7);
    let second = PeanoConstants::of(Rule::TRAPEZOIDAL).smooth_gap(&line, 0.9);
    for ((found, rounding), bound) in [
        (gap(Rule::LEFT_ENDPOINT, &linear, &line), first),
        (gap(Rule::TRAPEZOIDAL, &parabola, &line), second),
    ] {
        assert!((found - bound).abs() <= rounding, "{found} {bound}");
        assert!(bound > 100.0 * rounding);
    }
}

/// A node at a wrong fraction, or a wrong weight, is not exact for cubic polynomials.
#[test]
fn rules_are_exact_to_their_degree() {
    /// The metric `1 + xᵖ/p` on a line.
    struct Power(i32);
    impl Metric<1> for Power {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            SMatrix::from_element(x[0].powi(self.0) * (1.0 / f64::from(self.0)) + 1.0)
        }
    }
    fn degree(rule: Rule) -> i32 {
        let line = PointSequence::straight([0.1], [1.3], 1).expect("finite");
        let is_exact = |power: &i32| {
            let (found, rounding) = gap(rule, &Power(*power), &line);
            found.abs() <= rounding
        };
        (1..9).take_while(is_exact).count() as i32
    }
    assert_eq!((degree(Rule::LEFT_ENDPOINT), degree(Rule::RIGHT_ENDPOINT)), (0, 0));
    assert_eq!((degree(Rule::TRAPEZOIDAL), degree(Rule::TRUE_TRAPEZOID)), (1, 1));
    assert_eq!(
        (degree(Rule::SIMPSON), degree(Rule::GAUSS_TWO), degree(Rule::GAUSS_THREE)),
        (3, 3, 5)
    );
}

/// The right-endpoint rule is the left-endpoint rule of the reversed sequence, and the mean of both
/// is the true trapezoid.
#[test]
fn the_right_endpoint_rule_is_the_left_one_backwards() {
    let points = vec![vector![0.0, 0.3], vector![1.0, -0.2], vector![1.5, 0.8], vector![1.7, 0.9]];
    let reversed = PointSequence::new(points.iter().rev().copied().collect()).expect("finite");
    let sequence = PointSequence::new(points).expect("finite");
    let right = Rule::RIGHT_ENDPOINT.energy(&Valleys, &sequence);
    // Sums of three terms with a dozen operations each.
    let close = |a: f64, b: f64| (a - b).abs() <= 1e-14 * b;
    assert!(close(right, Rule::LEFT_ENDPOINT.energy(&Valleys, &reversed)));
    let left = Rule::LEFT_ENDPOINT.energy(&Valleys, &sequence);
    assert!(!close(left, right));
    assert!(close(Rule::TRUE_TRAPEZOID.energy(&Valleys, &sequence), 0.5 * (left + right)));
}

proptest! {
    #![proptest_config(tautline_chance::config(61, 128))]

    /// Whatever the sequence, for every rule: far jumps attain a good part of the bounds.
    #[test]
    fn no_gap_exceeds_its_bounds(
        coordinates in proptest::collection::vec(-4.0..4.0_f64, 4..20),
    ) {
        let points: Vec<_> = coordinates.chunks_exact(2).map(|x| vector![x[0], x[1]]).collect();
        let sequence = PointSequence::new(points).expect("finite");
        let constants = Bounded::<2>::constants(&Valleys);
        let (l_h, m_h) = (constants.l_h(), constants.m_h().expect("the valleys have one"));
        fn check(
            rule: Rule,
            sequence: &PointSequence<2>,
            l_h: f64,
            m_h: f64,
        ) -> Result<(), TestCaseError> {
            let (found, rounding) = gap(rule, &Valleys, sequence);
            let constants = PeanoConstants::of(rule);
            let bound = constants.gap(sequence, l_h).min(constants.smooth_gap(sequence, m_h));
            prop_assert!(found.abs() <= bound + rounding, "{rule}: {found} {bound}");
            Ok(())
        }
        for &rule in Rule::ALL {
            check(rule, &sequence, l_h, m_h)?;
        }
    }
}
