//! Constants that are known in closed form, and metrics without constants.

use std::sync::{Arc, Mutex};

use nalgebra::{SMatrix, SVector};
use tautline_formula::{Formula, RecordError, spline::Spline};
use tautline_metrics::{
    Metric,
    gallery::{CoupledCosines, Hyperbolic, Sphere, Valleys},
};
use tautline_scalar::{Scalar, Table};

use super::{
    CertifiedConstant, CertifiedConstants, Quantity, certify, certify_by_formula, recorded,
};
use crate::{Accuracy, Cell, Certified, CertifyError, Domain, Progress, Watch, testing::parsed};

const CLOSE: Accuracy = Accuracy { tolerance: 1e-6, budget: 100_000 };

#[test]
fn the_constants_of_the_valleys_to_six_digits() {
    let space = Domain::space::<2>(&Valleys);
    let proved = CertifiedConstants::new::<2>(&Valleys, &space, CLOSE).expect("constants");
    let exact = [
        (proved.c1(), 1.0),
        (proved.c2(), 9.0),
        (proved.l_h(), 4.403_669_475_041_611_676_15),
        (proved.m_h().expect("second derivatives"), 6.0),
    ];
    for (found, exact) in exact {
        assert!(found.contains(exact) && found.looseness() <= 1.0 + 1e-6, "{found:?} {exact}");
    }
    let constants = proved.constants().expect("constants");
    assert!(!constants.is_local() && constants.is_isotropic());
}

/// The second derivative of `φ = 20 − (2 − cos x₁)²` is largest in absolute value where it is
/// positive: it is `6` at `π`. For the valleys it is largest where it is negative.
#[test]
fn a_second_derivative_counts_with_either_sign() {
    let ridges = parsed::<2>("20 - sqr(2 - cos(x1)) I");
    let of = |found: &CertifiedConstant| found.contains(6.0) && found.looseness() < 1.000_01;
    let space = Domain::space(&ridges);
    let ridges = certify(&ridges, Quantity::MH, &space, CLOSE).expect("a constant");
    let valleys = certify::<2>(&Valleys, Quantity::MH, &space, CLOSE).expect("a constant");
    assert!(of(&ridges) && of(&valleys), "{ridges:?} {valleys:?}");
}

#[test]
fn in_three_dimensions_the_norm_of_the_derivative_is_nearly_exact() {
    let space = Domain::space(&CoupledCosines);
    let accuracy = Accuracy { tolerance: 1e-2, budget: 50_000 };
    let found = certify(&CoupledCosines, Quantity::LH, &space, accuracy).expect("a constant");
    assert!(found.contains(0.12_f64.sqrt()) && found.looseness() < 1.02, "{found:?}");
}

#[test]
fn a_ball_has_constants_where_space_has_none() {
    let ball = Domain::ball([0.0, 0.0], 0.5).expect("a radius");
    let accuracy = Accuracy { tolerance: 1e-3, budget: 100_000 };
    let proved = CertifiedConstants::new::<2>(&Hyperbolic, &ball, accuracy).expect("constants");
    // φ = 4 / (1 − r²)² is 4 at the centre and 64/9 at the rim, where its slope 16 r / (1 − r²)³ is
    // 512/27.
    for (found, exact) in
        [(proved.c1(), 4.0), (proved.c2(), 64.0 / 9.0), (proved.l_h(), 512.0 / 27.0)]
    {
        assert!(found.contains(exact) && found.looseness() < 1.0011, "{found:?} {exact}");
    }
    assert!(proved.constants().expect("constants").is_local());
}

#[test]
fn a_metric_that_is_not_defined_is_refused_with_the_point() {
    let ball = Domain::ball([0.0, 0.0], 1.5).expect("a radius");
    match certify::<2>(&Hyperbolic, Quantity::C2, &ball, Accuracy::default()) {
        Err(CertifyError::Undefined { point }) => {
            assert!(SVector::<f64, 2>::from_row_slice(&point).norm() >= 1.0, "{point:?}");
        }
        other => panic!("{other:?}"),
    }
    // The metric is undefined for negative x₁.
    let root = parsed::<2>("diag(sqrt(x1) + 1, 1)");
    let cell = Domain::cell(Cell::new([-1.0, 0.0], [3.0, 1.0]).expect("in order"));
    for quantity in Quantity::ALL {
        match certify(&root, quantity, &cell, Accuracy::default()) {
            Err(CertifyError::Undefined { point }) => assert!(point[0] < 0.0, "{point:?}"),
            other => panic!("{quantity}: {other:?}"),
        }
    }
}

/// The derivatives are finite everywhere, but the metric is defined nowhere.
#[test]
fn a_constant_that_is_not_a_number_is_refused_for_each_quantity() {
    let nowhere = parsed::<2>("cos(x1) + 2 + 0/0 I");
    let space = Domain::space(&nowhere);
    for quantity in Quantity::ALL {
        let error = certify(&nowhere, quantity, &space, CLOSE).expect_err("nowhere defined");
        assert!(matches!(error, CertifyError::Undefined { .. }), "{quantity}: {error}");
    }
}

/// A metric that reads a second derivative of a table has kinks, and so no `M_H`. Boxes are cut at the knots,
/// and would not show them.
#[test]
fn there_is_no_m_h_where_first_derivatives_jump() {
    let table: Arc<dyn Table> =
        Arc::new(Spline::new(&[5], vec![1.0, 1.0, 1.0, 2.0, 3.0]).expect("a table"));
    let box_ = Domain::cell(Cell::new([-2.0, -1.0], [2.0, 1.0]).expect("in order"));
    let of = |text: &str, quantity| {
        let tables = [("t", Arc::clone(&table))];
        let metric = Formula::<2>::parse_with(text, &[], &tables).expect("a formula");
        certify(&metric, quantity, &box_, Accuracy { tolerance: 0.5, budget: 2000 })
    };
    for text in ["phi(1 + 0.1*t_2(0.5*x1 + 2) + 0.3*sin(x2))", "graph(t_1(x1 + 2))"] {
        assert_eq!(of(text, Quantity::MH), Err(CertifyError::Jumps), "{text}");
        assert!(of(text, Quantity::LH).is_ok(), "{text}");
    }
    for text in ["phi(9 + t_1(x1 + 2))", "graph(0.1*t(x1 + 2))"] {
        let found = of(text, Quantity::MH);
        assert!(!matches!(found, Err(CertifyError::Jumps)), "{text}: {found:?}");
    }
}

/// Constants are those of one half. If the other one may differ, nothing is proved.
#[test]
fn a_matrix_with_two_halves_has_no_constants() {
    let space = |text: &str| {
        let metric = parsed::<2>(text);
        certify(&metric, Quantity::C1, &Domain::space(&metric), CLOSE)
    };
    let halves = RecordError::Halves { row: 0, column: 1 };
    for text in ["[2, 0; 1.5, 2]", "[2, 0; 3*sin(x1 + x2), 2]", "[1, 0; 0/(x1 - 0.1), 1]"] {
        assert_eq!(space(text), Err(CertifyError::NotRecorded(halves)), "{text}");
        let metric = parsed::<2>(text);
        let new = Certified::new(metric.clone(), CLOSE).map(|_| ());
        assert_eq!(new, Err(CertifyError::NotRecorded(halves)), "{text}");
        let settled = Domain::settled_space(&metric).map(|_| ());
        assert_eq!(settled, Err(CertifyError::NotRecorded(halves)), "{text}");
    }
    assert!(space("[3, sin(x1)*cos(x2); cos(x2)*sin(x1), 3]").is_ok());
}

/// A metric that is indefinite where `|a x₁| > 1`.
fn leaning(a: f64) -> Formula<2> {
    Formula::parse("[1, x1*a; x1*a, 1]", &[("a", a)]).expect("a formula")
}

#[test]
fn an_indefinite_metric_is_refused_with_a_point() {
    let cell = Domain::cell(Cell::new([-1.0, 0.0], [1.0, 1.0]).expect("in order"));
    match certify(&leaning(1.001), Quantity::C1, &cell, Accuracy::default()) {
        Err(CertifyError::NotPositiveDefinite { point, eigenvalue }) => {
            assert!(point[0].abs() > 1.0 / 1.001, "{point:?}");
            assert!((1.0 - 1.001..=0.0).contains(&eigenvalue), "{eigenvalue}");
        }
        other => panic!("{other:?}"),
    }
    let least = certify(&leaning(0.999), Quantity::C1, &cell, Accuracy::default());
    assert!(least.as_ref().is_ok_and(|c1| c1.contains(1.0 - 0.999)), "{least:?}");
    // The matrix is just singular, neither positive nor indefinite, so the cutting never ends.
    let accuracy = Accuracy { budget: 1000, ..Accuracy::default() };
    match certify(&leaning(1.0), Quantity::C1, &cell, accuracy) {
        Err(CertifyError::BudgetSpent { lower, upper, .. }) => {
            assert!(lower <= 0.0 && 0.0 <= upper);
        }
        other => panic!("{other:?}"),
    }
}

#[test]
fn a_constant_that_is_infinite_is_not_bounded() {
    let growing = parsed::<1>("exp(x1) + 1 I");
    let space = Domain::space(&growing);
    let accuracy = Accuracy { budget: 10_000, ..Accuracy::default() };
    for quantity in [Quantity::C2, Quantity::LH, Quantity::MH] {
        match certify(&growing, quantity, &space, accuracy) {
            Err(CertifyError::BudgetSpent { upper, .. }) => assert_eq!(upper, f64::INFINITY),
            other => panic!("{other:?}"),
        }
    }
    assert!(certify(&growing, Quantity::C1, &space, accuracy).is_ok_and(|c1| c1.contains(1.0)));
}

/// The domain made for another metric represents only itself.
#[test]
fn constants_on_the_domain_of_another_metric_are_local() {
    let still = parsed::<2>("1 I");
    let point = Domain::space(&still);
    let of = |proved: CertifiedConstants| proved.constants().expect("constants").is_local();
    assert!(of(CertifiedConstants::new::<2>(&Valleys, &point, CLOSE).expect("a point")));
    assert!(!of(CertifiedConstants::new(&still, &point, CLOSE).expect("a point")));
}

#[test]
fn no_budget_and_no_tolerance_are_refused() {
    let space = Domain::space::<2>(&Valleys);
    let none = Accuracy { budget: 0, ..Accuracy::default() };
    match certify::<2>(&Valleys, Quantity::C1, &space, none) {
        Err(CertifyError::BudgetSpent { lower, upper, boxes: 0, .. }) => {
            assert_eq!((lower, upper), (f64::NEG_INFINITY, f64::INFINITY));
        }
        other => panic!("{other:?}"),
    }
    for tolerance in [0.0, 1.0, f64::NAN] {
        let error =
            certify::<2>(&Valleys, Quantity::C1, &space, Accuracy { tolerance, budget: 10 });
        assert!(matches!(error, Err(CertifyError::NotATolerance { .. })));
    }
}

#[test]
fn a_domain_in_another_space_is_refused() {
    let line = Domain::cell(Cell::new([0.0], [1.0]).expect("in order"));
    let refused = Err(CertifyError::Coordinates { what: "a domain", found: 1, dimension: 2 });
    for quantity in Quantity::ALL {
        assert_eq!(certify::<2>(&Valleys, quantity, &line, CLOSE), refused);
    }
}

#[test]
fn no_dimension_is_refused() {
    struct Nowhere;
    impl Metric<0> for Nowhere {
        fn gram<S: Scalar>(&self, _: &SVector<S, 0>) -> SMatrix<S, 0, 0> {
            SMatrix::from_element(S::zero())
        }
    }
    let space = Domain::space(&Nowhere);
    let error = certify(&Nowhere, Quantity::C1, &space, CLOSE);
    assert_eq!(error, Err(CertifyError::NoDimension));
}

#[test]
fn a_constant_metric_has_no_derivative() {
    let flat = parsed::<2>("[2, 0.5; 0.5, 1]");
    let space = Domain::space(&flat);
    let proved = CertifiedConstants::new(&flat, &space, CLOSE).expect("constants");
    let m_h = proved.m_h().expect("a constant");
    assert_eq!([proved.l_h().upper, m_h.upper], [0.0, 0.0]);
    assert_eq!(proved.l_h().looseness(), 1.0);
    let root = 0.5_f64.sqrt();
    assert!(proved.c1().contains(1.5 - root) && proved.c2().contains(1.5 + root), "{proved:?}");
    assert!(space.is_all_of_space());
}

/// Whatever the budget, the constants hold: those that are closer lie within them.
#[test]
fn constants_within_a_small_budget_are_wider_and_hold() {
    fn check(metric: &impl Metric<2>, centre: [f64; 2], radius: f64) {
        let ball = Domain::ball(centre, radius).expect("a radius");
        let accuracy = Accuracy { tolerance: 1e-4, budget: 200_000 };
        let close = CertifiedConstants::new(metric, &ball, accuracy).expect("constants");
        let mut wide = 0;
        for budget in [60, 200, 600] {
            let few = Accuracy { tolerance: 1e-9, budget };
            assert!(CertifiedConstants::new(metric, &ball, few).is_err(), "{budget}");
            let found = CertifiedConstants::within_budget(metric, &ball, few).expect("constants");
            let of = found.constants().expect("constants");
            let m_h = of.m_h().expect("proved");
            let close_m_h = close.m_h().expect("proved");
            // The least and the largest values that the close bounds allow.
            assert!(of.c1() <= close.c1().upper && of.c2() >= close.c2().lower, "{budget}");
            assert!(of.l_h() >= close.l_h().lower && m_h >= close_m_h.lower, "{budget}");
            wide += usize::from(m_h > 1.001 * close_m_h.upper);
        }
        assert!(wide > 0, "some budget is too small for the tolerance of the close bounds");
    }
    check(&Hyperbolic, [0.1, -0.2], 0.4);
    check(&Sphere, [0.3, 0.1], 0.5);
}

#[test]
fn a_budget_without_a_positive_c1_gives_no_constants() {
    // The factor is at least 0.95, but intervals know less on a large box.
    let metric = parsed::<2>("1.2 - x1*(1 - x1) I");
    let ball = Domain::ball([0.5, 0.0], 1.0).expect("a radius");
    let few = Accuracy { tolerance: 1e-3, budget: 1 };
    match CertifiedConstants::within_budget(&metric, &ball, few) {
        Err(CertifyError::BudgetSpent { quantity: Quantity::C1, lower, .. }) => {
            assert!(lower <= 0.0, "{lower}");
        }
        other => panic!("{other:?}"),
    }
}

/// `n (n − 1)` for `n = 2³¹ − 3` has 62 bits, and is no double.
#[test]
fn the_bend_of_a_high_power_is_proved_at_a_point() {
    let power = parsed::<1>("1 + x1^2147483645 I");
    let point = Domain::ball([1.0], 0.0).expect("a radius");
    let found = certify(&power, Quantity::MH, &point, CLOSE).expect("a constant");
    let exact = 2_147_483_645_i128 * 2_147_483_644;
    assert!(found.lower as i128 <= exact && exact <= found.upper as i128, "{found:?}");
    assert!(found.upper as i128 - found.lower as i128 <= 1 << 12, "{found:?}");
}

/// All reports are in the unit of the constant: it lies between the bound and the value, and both are
/// close to it at the end. The cell holds a period, and its middle is none of the places that count.
#[test]
fn a_search_tells_of_bounds_on_the_constant_itself() {
    let cell = Domain::cell(Cell::new([-0.7, 0.0], [5.9, 0.0]).expect("in order"));
    let valleys = recorded::<2>(&Valleys).expect("a formula");
    for (quantity, exact) in [
        (Quantity::C1, 1.0),
        (Quantity::C2, 9.0),
        (Quantity::LH, 4.403_669_475_041_611_676_15),
        (Quantity::MH, 6.0),
    ] {
        let told = Mutex::new(Vec::new());
        let watch = |progress: Progress| {
            told.lock().expect("no panic").push(progress);
            true
        };
        let watched = certify_by_formula(&valleys, quantity, &cell, CLOSE, &watch);
        assert_eq!(
            watched,
            certify::<2>(&Valleys, quantity, &cell, CLOSE),
            "watching changes nothing"
        );
        let told = told.into_inner().expect("no panic");
        assert!(told.len() > 5, "{quantity}: {told:?}");
        let mut boxes = 0;
        for progress in &told {
            let &Progress { bound, value, .. } = progress;
            let (low, high) =
                if quantity == Quantity::C1 { (bound, value) } else { (value, bound) };
            // They are rounded, by a few units in the last place.
            let [low, high] = [low * (1.0 - 1e-14), high * (1.0 + 1e-14)];
            assert!(low <= exact && exact <= high, "{progress:?}");
            assert!(progress.quantity == quantity && progress.boxes > boxes, "{progress:?}");
            boxes = progress.boxes;
        }
        let last = told[told.len() - 1];
        let is_near = |x: f64| (x / exact - 1.0).abs() < 1e-2;
        assert!(is_near(last.bound) && is_near(last.value), "{last:?}");
    }
}

/// A search that is ended leaves bounds, as one that spent its budget does.
#[test]
fn a_search_that_is_ended_leaves_the_bounds_it_told_of() {
    let ball = Domain::ball([0.1, -0.2], 0.4).expect("a radius");
    let hyperbolic = recorded::<2>(&Hyperbolic).expect("a formula");
    for quantity in Quantity::ALL {
        let told = Mutex::new(Vec::new());
        let watch = |progress: Progress| {
            let mut told = told.lock().expect("no panic");
            told.push(progress);
            told.len() < 3
        };
        let ended = certify_by_formula(&hyperbolic, quantity, &ball, CLOSE, &watch);
        let Err(CertifyError::BudgetSpent { quantity: of, lower, upper, boxes }) = ended else {
            panic!("{ended:?}")
        };
        let told = told.into_inner().expect("no panic");
        assert!(of == quantity && told.len() == 3 && told[2].boxes == boxes, "{told:?}");
        let close = certify::<2>(&Hyperbolic, quantity, &ball, CLOSE).expect("a constant");
        assert!(lower <= close.upper && close.lower <= upper, "{lower} {upper} {close:?}");
        // The error carries the bound of the last report, which is rounded on its way.
        let proved = if quantity == Quantity::C1 { lower } else { upper };
        assert!((proved / told[2].bound - 1.0).abs() < 1e-14, "{proved} {:?}", told[2]);
        assert!(boxes < close.boxes, "{boxes} {close:?}");
    }
}

/// `M_H` may have no bound, or not be needed; the other constants stay.
#[test]
fn a_watch_that_needs_no_second_derivative_gets_none() {
    struct Without(Mutex<Vec<Quantity>>);
    impl Watch for Without {
        fn goes_on(&self, progress: Progress) -> bool {
            let mut seen = self.0.lock().expect("no panic");
            seen.push(progress.quantity);
            true
        }
        fn needs_m_h(&self) -> bool {
            false
        }
    }
    let space = Domain::space::<2>(&Valleys);
    let valleys = recorded::<2>(&Valleys).expect("a formula");
    let without = Without(Mutex::new(Vec::new()));
    let found = CertifiedConstants::within_budget_by_formula(&valleys, &space, CLOSE, &without);
    let found = found.expect("constants");
    let all = CertifiedConstants::within_budget::<2>(&Valleys, &space, CLOSE).expect("constants");
    assert_eq!((found.c1(), found.c2(), found.l_h()), (all.c1(), all.c2(), all.l_h()));
    assert!(found.m_h().is_none() && all.m_h().is_some());
    assert!(found.constants().expect("constants").m_h().is_none());
    assert!(!without.0.into_inner().expect("no panic").contains(&Quantity::MH));
    // One that ends every search leaves what the first boxes prove.
    let never = |_: Progress| false;
    let few = CertifiedConstants::within_budget_by_formula(&valleys, &space, CLOSE, &never);
    let few = few.expect("constants").constants().expect("constants");
    assert!(0.0 < few.c1() && few.c1() <= 1.0 && few.c2() >= 9.0, "{few:?}");
    assert!(few.l_h() >= 4.403 && few.m_h().is_none_or(|m_h| m_h >= 6.0), "{few:?}");
}
