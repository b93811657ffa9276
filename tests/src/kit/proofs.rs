//! Constants are proved from the formula, both where none are claimed and where the claims are
//! wrong.

use tautline::{
    CertifyError,
    gallery::{Shear, SineProjections, Valleys},
};
use tautline_kit::{Claim, Fault, MetricCase, Proof, metric, prelude::*};

use super::{claiming, fault, gallery::period, with_wrong};

// H = [[2 + cos x₁, 0.3 sin(x₁ + x₂)], [·, 1.5 + 0.5 sin x₂]]; no constants are claimed.
formula!(Formula, 2, |x| {
    let off = (x[0] + x[1]).sin() * 0.3;
    SMatrix::<S, 2, 2>::new(x[0].cos() + 2.0, off, off, x[1].sin() * 0.5 + 1.5)
});

metric_suite!(
    a_formula_alone: Certified::new(Formula, Accuracy::default()), dimension 2, in period(),
);

#[test]
fn a_constant_that_is_off_by_a_thousandth_is_refused_with_its_witness() {
    let shear = Shear::new(0.5, 1.0).expect("a wave number");
    for constant in Claim::ALL {
        let factor = if constant == Claim::C1 { 1.001 } else { 0.999 };
        let wrong = on_a_period(with_wrong::<_, 2>(shear, constant, factor));
        let Fault::Lie(lie) = fault(metric::no_constant_is_refuted(&wrong)) else {
            panic!("{constant}")
        };
        assert_eq!((lie.constant, lie.point.len(), lie.direction.len()), (constant, 2, 2));
        // The ascent from the box finds the extreme value to six digits.
        let truth = constant.of(&shear.constants()).expect("stated");
        assert!((lie.found / truth - 1.0).abs() < 1e-6, "{lie}");
    }
}

/// Returns the case of a metric on one period.
fn on_a_period<M: Bounded<2>>(metric: M) -> MetricCase<M, 2> {
    MetricCase::new(metric, period(), Effort::default())
}

/// Returns what is proved about one constant of a case.
fn proof<M: Bounded<D>, const D: usize>(case: &MetricCase<M, D>, claim: Claim) -> Proof {
    let outcome = metric::no_constant_is_refuted(case);
    outcome.assert();
    let of = |standing: &&tautline_kit::Standing| standing.claim == claim;
    outcome.standings.iter().find(of).expect("a claim").proof
}

#[test]
fn a_claim_is_proved_or_right_to_the_tolerance() {
    let of =
        |factor| proof(&on_a_period(with_wrong::<_, 2>(Valleys, Claim::LH, factor)), Claim::LH);
    // The constant is attained, and the proof determines it to one percent.
    let Proof::RightTo { percent } = of(1.0) else { panic!("{}", of(1.0)) };
    assert!(percent > 0.0 && percent <= 1.0, "{percent}");
    assert_eq!(of(1.02), Proof::Proved);
}

/// The law passes, but the standings show that nothing was proved.
#[test]
fn undecided_and_untried_claims_do_not_count_as_proved() {
    // For 2 + cos 40x₁ cos 40x₂/2 the second derivative is largest at six thousand places, which
    // are more than there are boxes.
    formula!(Quilt, 2, |x| {
        let [u, v] = [x[0] * 40.0, x[1] * 40.0];
        SMatrix::from_diagonal_element(u.cos() * v.cos() * 0.5 + 2.0)
    });
    let of = |m_h: f64| {
        let mut quilt = claiming(Quilt, [1.499, 2.501, 20.02]);
        quilt.constants = quilt.constants.with_m_h(m_h).expect("in order");
        on_a_period(quilt)
    };
    assert_eq!(proof(&of(801.0), Claim::MH), Proof::NotDecided);
    // The bounds reached so far suffice to refute smaller claims and to prove larger ones.
    assert_eq!(proof(&of(1e4), Claim::MH), Proof::Proved);
    let refuted = fault(metric::no_constant_is_refuted(&of(100.0)));
    let Fault::Refuted { claim: Claim::MH, claimed: 100.0, bound } = refuted else {
        panic!("{refuted}")
    };
    assert!(bound > 100.0 && bound <= 801.0, "{refuted}");
    assert!(refuted.to_string().contains("claims M_H = 100, but it is proved to be at least"));

    // c₁: with w = cos 200x₁ cos 200x₂, the minimum 15/8 of 2 + (w² + w)/2 is attained at forty
    // thousand places, while interval arithmetic over all w gives 3/2.
    formula!(Fine, 2, |x| {
        let [u, v] = [x[0] * 200.0, x[1] * 200.0];
        let wave = u.cos() * v.cos();
        SMatrix::from_diagonal_element((wave.sqr() + wave) * 0.5 + 2.0)
    });
    let of = |c1: f64| on_a_period(claiming(Fine, [c1, 1e3, 1e4]));
    let below = [1.4, 1.7].map(|c1| proof(&of(c1), Claim::C1));
    assert_eq!(below, [Proof::Proved, Proof::NotDecided]);
    let refuted = fault(metric::no_constant_is_refuted(&of(1.9)));
    assert!(matches!(refuted, Fault::Refuted { claim: Claim::C1, .. }), "{refuted}");

    let region = Region::cell([-1.5; 8], [1.5; 8]);
    let many = MetricCase::new(SineProjections::benchmark(), region, Effort::default());
    for claim in [Claim::C1, Claim::C2, Claim::LH] {
        assert_eq!(proof(&many, claim), Proof::NotTried);
    }
}

/// `2 + (sin x₁)/x₁` needs a branch for 0, where the quotient is undefined. No tape contains both
/// branches.
#[test]
fn a_formula_with_branches_is_tested_but_not_proved() {
    formula!(Sinc, 2, |x| {
        let wave = if x[0].is_zero() { S::one() } else { x[0].sin() / x[0] };
        SMatrix::from_diagonal_element(wave + 2.0)
    });
    let mut metric = claiming(Sinc, [1.78, 3.0, 0.4362]);
    metric.constants = metric.constants.with_m_h(0.334).expect("in order");
    let region = Region::cell([0.5, 0.5], [3.5, 3.5]);
    let effort = Effort { cases: 32, problems: 1, subintervals: &[1, 4], ..Effort::default() };
    let report = verify_metric(&metric, &region, &effort);
    assert!(report.holds(), "{report}");
    let case = MetricCase::new(metric, region, effort);
    for claim in Claim::ALL {
        assert_eq!(proof(&case, claim), Proof::NotTried);
    }
}

/// The metric is indefinite only in a spot of width 0.04, where few samples lie.
#[test]
fn a_metric_that_is_indefinite_in_a_corner_is_refused_with_a_point() {
    formula!(Dented, 2, |x| {
        let near = ((x[0] - 1.3).sqr() + (x[1] - 4.1).sqr()) * -5000.0;
        SMatrix::from_diagonal_element(-near.exp() * 1.1 + 1.0)
    });
    let case = on_a_period(claiming(Dented, [1.0, 1.0, 100.0]));
    let fault = fault(metric::no_constant_is_refuted(&case));
    let Fault::Unproved(CertifyError::NotPositiveDefinite { point, eigenvalue }) = fault else {
        panic!("{fault}")
    };
    assert!((point[0] - 1.3).hypot(point[1] - 4.1) < 0.02 && eigenvalue <= 0.0, "{point:?}");
}
