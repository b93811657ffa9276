//! The newcomer's metric with one mistake in it: these tests show what finds it, and what the
//! message says.

use tautline::MetricError;
use tautline_kit::{Claim, Fault, MetricCase, metric, prelude::*};

use super::Egg;
use crate::kit::{broken, claiming, fault};

/// Returns the case of a metric on the newcomer's region.
fn case<M: Bounded<2>>(metric: M) -> MetricCase<M, 2> {
    MetricCase::new(metric, Region::cell([0.0, 0.0], [6.3, 6.3]), Effort::default())
}

/// `L_H = ½` is claimed, but the true value is 1. It is attained in the direction of either axis:
/// for the first, `‖DH(x)[w]‖ = |sin x₁|` is 1 at `x₁ = π/2` or `3π/2`; for the second, `|cos x₂|`
/// is 1 at `x₂ = 0`, `π` or `2π`. Both laws about `L_H` find the mistake, and so does every
/// statement that needs `L_H`.
#[test]
fn half_of_l_h_is_refused_with_the_witness() {
    let case = case(claiming(&Egg, [1.0, 4.0, 0.5]));
    let outcome = metric::l_h_bounds_the_derivative(&case);
    let message = outcome.to_string();
    let Fault::Lie(lie) = fault(outcome) else { panic!("{message}") };
    assert_eq!((lie.constant, lie.claimed), (Claim::LH, 0.5));
    // The last step of the ascent has length 6.3 · 2⁻¹⁶ = 1e-4, so the error is about 1 − cos 1e-4.
    assert!((lie.found - 1.0).abs() <= 1e-8, "{lie}");
    let axis = usize::from(lie.direction[1].abs() > 0.5);
    let slope = if axis == 0 { lie.point[0].sin() } else { lie.point[1].cos() };
    assert!((slope.abs() - lie.found).abs() <= 1e-12 && lie.direction[axis].abs() > 0.999_999);
    for part in ["L_H = 0.5", "FAILS", "smallest random sample", "seed 1"] {
        assert!(message.contains(part), "{message}");
    }

    let Fault::Lie(lie) = fault(metric::l_h_bounds_differences(&case)) else { panic!("a lie") };
    assert!(lie.constant == Claim::LH && lie.found > 0.5 && lie.found <= 1.0 + 1e-12, "{lie}");
    // The message shows the difference quotient, with its second point.
    let text = lie.to_string();
    let other = SVector::<f64, 2>::from_column_slice(lie.other.as_deref().expect("a point y"));
    let point = SVector::<f64, 2>::from_column_slice(&lie.point);
    let [h, k]: [SMatrix<f64, 2, 2>; 2] = [point, other].map(|x| Egg.gram(&x));
    let quotient = (h - k).amax() / (point - other).norm();
    assert!((quotient - lie.found).abs() <= 1e-12 * lie.found, "{text}");
    assert!(text.contains("‖H(x) − H(y)‖/|x − y| = ") && text.contains(" and y = ["), "{text}");
    let note = metric::refuses_a_smaller_l_h(&case).note;
    assert_eq!(note.as_deref(), Some("the claim itself does not hold"));
    let statement = fault(metric::prop_7_9(&case));
    let Fault::Statement { hypothesis: true, inequality, .. } = statement else {
        panic!("{statement}")
    };
    assert!(inequality.claim.contains("L_H"), "{statement}");
}

/// `H₂₂ = 3 + 3.00001 sin x₂` is negative on an interval of length 0.005 around `3π/2`, which
/// contains one random point in a thousand.
#[test]
fn an_indefinite_metric_is_refused_with_the_point() {
    formula!(Cracked, 2, |x| SMatrix::from_diagonal(
        &[x[0].cos() + 2.0, x[1].sin() * 3.000_01 + 3.0].into()
    ));
    let cracked = WithConstants { metric: Cracked, constants: Egg.constants() };
    let found = fault(metric::is_positive_definite(&case(cracked)));
    let Fault::Metric(MetricError::NotPositiveDefinite { point, eigenvalue }) = found else {
        panic!("{found}")
    };
    let least = 3.0 + 3.000_01 * point[1].sin();
    // The eigenvalue is a sum of two numbers of size 3.
    assert!(eigenvalue <= 0.0 && (eigenvalue - least).abs() <= 1e-14, "{point:?}, {eigenvalue}");
    assert!((point[1] - 4.712).abs() <= 0.01, "{point:?}");
}

/// Either the two off-diagonal entries differ, or one entry is NaN.
#[test]
fn asymmetric_and_nan_entries_are_refused() {
    enum Scrambled {
        Halves,
        NotFinite,
    }
    impl Metric<2> for Scrambled {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            let mut h: SMatrix<S, 2, 2> = Egg.gram(x);
            match self {
                Self::Halves => h[(0, 1)] += x[0] * 1e-6,
                // To the right of x₁ = 6 this is the logarithm of a negative number.
                Self::NotFinite => h[(1, 1)] += (-x[0] + 6.0).ln() * 0.0,
            }
            h
        }
    }
    let law = |metric| {
        let case = case(WithConstants { metric, constants: Egg.constants() });
        fault(metric::is_finite_and_symmetric(&case))
    };
    let halves = law(Scrambled::Halves);
    assert!(matches!(halves, Fault::Metric(MetricError::NotSymmetric { .. })), "{halves}");
    let not_finite = law(Scrambled::NotFinite);
    // The point is shrunk to the edge of the domain, and its other coordinate to 0.
    let Fault::Metric(MetricError::NotFinite { point, .. }) = not_finite else {
        panic!("{not_finite}")
    };
    assert!(point[0] >= 6.0 && point[0] <= 6.0 + 6.3 / 65536.0 && point[1] == 0.0, "{point:?}");
}

/// In the long region the ripple is finer than the smallest step of the differences, which is a
/// 65536th of an edge. The law then fails, so the user has to choose the region to suit the metric.
#[test]
fn a_ripple_finer_than_the_steps_in_the_region_is_refused() {
    formula!(Rippled, 1, |x| SMatrix::from_diagonal_element((x[0] * 1e6).sin() * 1e-3 + 2.0));
    let law = |length: f64| {
        let (metric, region) =
            (claiming(Rippled, [1.999, 2.001, 1e3]), Region::cell([0.0], [length]));
        metric::jets_agree_with_differences(&MetricCase::new(metric, region, Effort::default()))
    };
    assert!(!law(6.3).holds());
    let fine = law(6.3e-6);
    assert!(fine.holds(), "{fine}");
}

/// `H` is 2 plus teeth of slope 1 and width `2⁻¹²`, and `L_H = ½` is claimed. Two points more than
/// `2⁻¹⁰` apart do not reveal the mistake.
#[test]
fn teeth_that_are_finer_than_the_samples_are_refused() {
    formula!(Saw, 2, |x| SMatrix::from_diagonal(
        &[(x[0] * 4096.0).sin() / 4096.0 + 2.0, S::constant(2.0)].into()
    ));
    let case = case(claiming(Saw, [1.99, 2.01, 0.5]));
    let Fault::Lie(lie) = fault(metric::l_h_bounds_differences(&case)) else { panic!("a lie") };
    let other = lie.other.expect("a point y");
    let step = (lie.point[0] - other[0]).hypot(lie.point[1] - other[1]);
    assert!(lie.found > 0.5 && lie.found <= 1.0 + 1e-6 && step < 1.0 / 1024.0, "{step}");
}

/// `x₁/x₁` is 1 except on a line in the middle of the region, where no uniform sample lies.
#[test]
fn a_nan_in_the_middle_of_the_region_is_refused() {
    formula!(Split, 2, |x| SMatrix::from_diagonal_element(x[0] / x[0] + 1.0));
    for region in [Region::cell([-3.0, -3.0], [3.0, 3.0]), Region::cell([-1.0, -3.0], [7.0, 3.0])] {
        let case = MetricCase::new(claiming(Split, [2.0, 2.0, 0.0]), region, Effort::default());
        let found = fault(metric::is_finite_and_symmetric(&case));
        let Fault::Metric(MetricError::NotFinite { point, .. }) = found else { panic!("{found}") };
        assert_eq!(point[0], 0.0);
    }
}

/// `H = 4` on the line, with known distances that are wrong by factors and by a constant.
struct Misjudged {
    factor: f64,
    /// An additional factor for distances from right to left.
    back: f64,
    more: f64,
}

impl Metric<1> for Misjudged {
    fn gram<S: Scalar>(&self, _: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        SMatrix::from_diagonal_element(S::constant(4.0))
    }
}

impl KnownDistance<1> for Misjudged {
    fn distance(&self, x: &SVector<f64, 1>, y: &SVector<f64, 1>) -> Option<f64> {
        let back = if x[0] > y[0] { self.back } else { 1.0 };
        Some(2.0 * self.factor * back * (x - y).norm() + self.more)
    }
}

fn misjudged(factor: f64, back: f64, more: f64) -> MetricCase<WithConstants<Misjudged>, 1> {
    let metric = claiming(Misjudged { factor, back, more }, [4.0, 4.0, 0.0]);
    let region = Region::cell([0.0], [1.0]);
    MetricCase::new(metric, region, Effort::default()).with_known_distance()
}

#[test]
fn distances_that_are_not_symmetric_or_not_zero_are_refused() {
    let law =
        |back, more| broken(metric::known_distances_are_distances(&misjudged(1.0, back, more)));
    // This distance does not exceed the length of any curve.
    assert_eq!(law(0.999, 0.0), "|d(x, y) − d(y, x)| = 0");
    assert_eq!(law(1.0, 1e-6), "d(x, x) = 0");
}

/// The distances are one percent too long, or one percent too short.
#[test]
fn distances_of_another_metric_are_refused() {
    let case = |factor| misjudged(factor, 1.0, 0.0);
    assert!(metric::known_distances_are_distances(&case(1.0)).holds());
    let long = fault(metric::known_distances_are_distances(&case(1.01)));
    let Fault::Broken { left, right, .. } = long else { panic!("{long}") };
    assert!((left / right - 1.01).abs() <= 1e-9, "{long}");
    // With a distance that is too small, no curve is shorter than it claims; but the theorems fail,
    // and there is no nearest pair.
    for law in [metric::theorem_1_1, metric::prop_6_2] {
        assert!(law(&case(1.0)).holds());
        assert!(!law(&case(0.99)).holds());
    }
    // If the distance is too large, some curve is shorter.
    assert!(metric::prop_6_3(&case(1.0)).holds());
    assert!(!metric::prop_6_3(&case(1.01)).holds());
}
