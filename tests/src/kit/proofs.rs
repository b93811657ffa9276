//! Constants proved from the formula: where none are stated, and where they are wrong.

use tautline::gallery::{Shear, SineProjections, Valleys};
use tautline_kit::{Claim, Fault, MetricCase, Proof, metric, prelude::*};
use tautline_statements::WithConstants;

use super::gallery::period;

/// `[[2 + cos x₁, 0.3 sin(x₁ + x₂)], [·, 1.5 + 0.5 sin x₂]]`, and no word about its constants.
struct Formula;

impl Metric<2> for Formula {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let off = (x[0] + x[1]).sin() * 0.3;
        SMatrix::<S, 2, 2>::new(x[0].cos() + 2.0, off, off, x[1].sin() * 0.5 + 1.5)
    }
}

metric_suite!(
    a_formula_alone: Certified::new(Formula, Accuracy::default()), dimension 2, in period(),
);

/// The metric with one of its constants multiplied by a factor.
fn liar<M: Bounded<2>>(metric: M, constant: Claim, factor: f64) -> MetricCase<WithConstants<M>, 2> {
    let by = |which| if which == constant { factor } else { 1.0 };
    let factors = [Claim::C1, Claim::C2, Claim::LH, Claim::MH].map(by);
    let constants = metric.constants().times(factors).expect("in order");
    MetricCase::new(WithConstants { metric, constants }, period(), Effort::default())
}

#[test]
fn a_lie_of_a_thousandth_is_refused_with_its_witness() {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    for constant in Claim::ALL {
        let factor = if constant == Claim::C1 { 1.001 } else { 0.999 };
        let outcome = metric::no_constant_is_refuted(&liar(shear, constant, factor));
        let failure = outcome.failure.unwrap_or_else(|| panic!("{constant} passes"));
        let Fault::Lie(lie) = failure.fault else { panic!("{failure}") };
        assert_eq!((lie.constant, lie.point.len(), lie.direction.len()), (constant, 2, 2));
        // The ascent from the box finds the extreme value to six digits.
        let truth = constant.of(&shear.constants()).expect("stated");
        assert!((lie.found / truth - 1.0).abs() < 1e-6, "{lie}");
    }
}

/// What is known of one constant of a case.
fn proof<M: Bounded<D>, const D: usize>(case: &MetricCase<M, D>, claim: Claim) -> Proof {
    let outcome = metric::no_constant_is_refuted(case);
    outcome.assert();
    let of = |standing: &&tautline_kit::Standing| standing.claim == claim;
    outcome.standings.iter().find(of).expect("a claim").proof
}

#[test]
fn what_is_stated_is_proved_or_right_to_the_tolerance() {
    let of = |factor| proof(&liar(Valleys, Claim::LH, factor), Claim::LH);
    // Attained, and known to one percent.
    let Proof::RightTo { percent } = of(1.0) else { panic!("{}", of(1.0)) };
    assert!(percent > 0.0 && percent <= 1.0, "{percent}");
    assert_eq!(of(1.02), Proof::Proved);
}

/// That the law passes says nothing of these: their standings do.
#[test]
fn what_is_not_decided_and_what_is_not_tried_are_not_said_to_be_proved() {
    /// `2 + cos 40x₁ cos 40x₂/2`: six thousand places where the second derivative is largest, more
    /// than there are boxes.
    struct Quilt;
    impl Metric<2> for Quilt {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let [u, v] = [x[0] * 40.0, x[1] * 40.0];
            SMatrix::from_diagonal_element(u.cos() * v.cos() * 0.5 + 2.0)
        }
    }
    let constants = Constants::new(1.499, 2.501, 20.02).and_then(|known| known.with_m_h(801.0));
    let metric = WithConstants { metric: Quilt, constants: constants.expect("in order") };
    let quilt = MetricCase::new(metric, period(), Effort::default());
    assert_eq!(proof(&quilt, Claim::MH), Proof::NotDecided);

    // What the boxes have reached refutes smaller claims, and proves larger ones.
    let of = |m_h: f64| {
        let constants = Constants::new(1.499, 2.501, 20.02).and_then(|known| known.with_m_h(m_h));
        let metric = WithConstants { metric: Quilt, constants: constants.expect("in order") };
        MetricCase::new(metric, period(), Effort::default())
    };
    assert_eq!(proof(&of(1e4), Claim::MH), Proof::Proved);
    let outcome = metric::no_constant_is_refuted(&of(100.0));
    let Some(Fault::Refuted { claim: Claim::MH, claimed: 100.0, bound }) =
        outcome.failure.as_ref().map(|failure| failure.fault.clone())
    else {
        panic!("{outcome}")
    };
    assert!(bound > 100.0 && bound <= 801.0, "{outcome}");
    assert!(outcome.to_string().contains("claims M_H = 100, but it is proved to be at least"));

    // And of c₁: with w = cos 200x₁ cos 200x₂ is 2 + (w² + w)/2 ≥ 15/8, attained in forty thousand
    // places, where an interval that holds all of w says 3/2.
    struct Fine;
    impl Metric<2> for Fine {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let [u, v] = [x[0] * 200.0, x[1] * 200.0];
            let wave = u.cos() * v.cos();
            SMatrix::from_diagonal_element((wave.sqr() + wave) * 0.5 + 2.0)
        }
    }
    let of = |c1: f64| {
        let constants = Constants::new(c1, 1e3, 1e4).expect("in order");
        MetricCase::new(WithConstants { metric: Fine, constants }, period(), Effort::default())
    };
    let below = [1.4, 1.7].map(|c1| proof(&of(c1), Claim::C1));
    assert_eq!(below, [Proof::Proved, Proof::NotDecided]);
    let refuted = metric::no_constant_is_refuted(&of(1.9)).failure.map(|failure| failure.fault);
    assert!(matches!(refuted, Some(Fault::Refuted { claim: Claim::C1, .. })), "{refuted:?}");

    let region = Region::cell([-1.5; 8], [1.5; 8]);
    let many = MetricCase::new(SineProjections::benchmark(), region, Effort::default());
    for claim in [Claim::C1, Claim::C2, Claim::LH] {
        assert_eq!(proof(&many, claim), Proof::NotTried);
    }
}

/// `2 + (sin x₁)/x₁`, with a branch for 0, where the quotient is not defined: no tape stands for both.
#[test]
fn a_formula_with_branches_is_tested_and_nothing_is_proved_of_it() {
    struct Sinc;
    impl Metric<2> for Sinc {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let wave = if x[0].is_zero() { S::one() } else { x[0].sin() / x[0] };
            SMatrix::from_diagonal_element(wave + 2.0)
        }
    }
    let constants = Constants::new(1.78, 3.0, 0.4362).and_then(|known| known.with_m_h(0.334));
    let metric = WithConstants { metric: Sinc, constants: constants.expect("in order") };
    let region = Region::cell([0.5, 0.5], [3.5, 3.5]);
    let effort = Effort { cases: 32, problems: 1, subintervals: &[1, 4], ..Effort::default() };
    let report = verify_metric(&metric, &region, &effort);
    assert!(report.holds(), "{report}");
    let case = MetricCase::new(metric, region, effort);
    for claim in Claim::ALL {
        assert_eq!(proof(&case, claim), Proof::NotTried);
    }
}

/// Indefinite in a strip of width 0.04, where few samples are, and refused all the same.
#[test]
fn a_metric_that_is_indefinite_in_a_corner_is_refused_with_a_point() {
    struct Dented;
    impl Metric<2> for Dented {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let near = ((x[0] - 1.3).sqr() + (x[1] - 4.1).sqr()) * -5000.0;
            SMatrix::from_diagonal_element(-near.exp() * 1.1 + 1.0)
        }
    }
    let constants = Constants::new(1.0, 1.0, 100.0).expect("in order");
    let metric = WithConstants { metric: Dented, constants };
    let case = MetricCase::new(metric, period(), Effort::default());
    let failure = metric::no_constant_is_refuted(&case).failure.expect("indefinite");
    let Fault::Unproved(tautline::CertifyError::NotPositiveDefinite { point, eigenvalue }) =
        failure.fault
    else {
        panic!("{failure}")
    };
    assert!((point[0] - 1.3).hypot(point[1] - 4.1) < 0.02 && eigenvalue <= 0.0, "{point:?}");
}
