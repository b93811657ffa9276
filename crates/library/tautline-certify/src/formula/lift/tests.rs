//! Lifted formulas have the values of their formulas, and little else.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use super::{Lift, Place};
use crate::{
    Accuracy, CertifiedConstants, Domain, Quantity, certify,
    constants::{Expansion, Order, lifted},
    patch::{Patch, Region},
    testing::{parsed, tables},
};

type Expanded = Expansion<Jet1<Interval, 2>>;

/// Formulas in two coordinates, with all kinds of roles.
const FORMULAS: [&str; 13] = [
    "1 + exp(x1 - sqr(x1)*2)",
    "4 + tanh(x1*3 - 1) + sin(x2)",
    "cos(x1) + sin(x1*0.7 + x2*0.4) + 3",
    "3 + sin(x1*2) + cos(x1*3 + 1) + cos(x1*sqrt(2)) + tan(sin(x2))",
    "2 + exp(-sqr(x1 - 1))*sin(x1*5)",
    "2 + exp(-(x1 - 1)*(x1*2 + 3) - x2^2/3 + x2)*cos(x2*2 + 1)*atan(x1)",
    "1 + 1/(1 + exp(-(x1 + x2*2)*3)) + atan(x1/3 - x2)",
    "2 - 2/(2 + 5*exp(x1)) + recip(exp(x2*4 - 1) + 3) + (1 + exp(x1 - x2))^-1",
    "tanh(x1)*atan(x2)*sin(x1 + x2) + tanh(x1*0.5 + x2*0.5)",
    "sqrt(2 + tanh(x1)*sin(x2 - x1)) + ln(2 + exp(-sqr(x1 + x2)))",
    "sin(x1/3) + cos(x1/3 + 1) + cos(x1*7 - 2)*tanh(x1)",
    "x2*(1 + 1/(2*exp(-x1) + 0.5)) + x1",
    "exp(-(sqr(x1) + sqr(x2))/2)*(3 - 4*exp(2*x1 - sqr(x1)))",
];

/// Returns the lifted formula of all of space.
fn lift<const D: usize>(formula: &Formula<D>) -> Option<Lift> {
    Lift::new(&formula.clone().into_any(), vec![false; D])
}

/// Expands the first entry on a patch.
fn expanded(lift: &Lift, patch: &Patch) -> Expanded {
    lifted::expansion(lift, &seeded(patch), patch.chart, Order::Second)
}

impl Lift {
    /// Returns a patch without width, up to rounding, with the values of the variables at `x`.
    fn variables_at<const D: usize>(&self, x: [f64; D]) -> Patch {
        let value = |direction: &[Interval]| {
            (0..D).fold(Interval::point(0.0), |sum, i| sum + direction[i] * x[i])
        };
        let chart = (0..self.charts.len()).find(|&chart| {
            self.forms.iter().zip(&self.charts[chart]).all(|(form, place)| {
                let y = value(&form.direction).midpoint();
                match place {
                    Place::Anywhere => true,
                    Place::Near => y.abs() <= form.reach,
                    Place::Far(sign) => y * sign > form.reach,
                }
            })
        });
        let mut sides = vec![Interval::point(0.0); self.variables];
        for form in self.forms.iter().filter(|form| !form.is_still) {
            let y = value(&form.direction);
            if let Some(variable) = form.variable {
                sides[variable] = y;
            }
            for phase in &form.phases {
                let angle = y * phase.wave_number;
                let turns = (angle.midpoint() / std::f64::consts::TAU).floor();
                sides[phase.variable] = angle - Interval::point(1.0).atan() * 8.0 * turns;
            }
        }
        Patch { sides, chart: chart.expect("a chart for every point") }
    }
}

/// Widens the sides of a patch at random; some become half-lines.
fn widened(patch: &Patch, mut below: impl FnMut(u64) -> u64) -> Patch {
    let mut wide = patch.clone();
    for side in &mut wide.sides {
        let mut away = || match below(6) {
            0 => f64::INFINITY,
            1 => 0.0,
            k => 10.0_f64.powi(k as i32 - 4),
        };
        let (lo, hi) = (side.lo() - away(), side.hi() + away());
        *side = Interval::new(lo, hi).expect("in order");
    }
    wide
}

fn same_place(a: Interval, b: Interval) -> bool {
    a.intersection(b).is_some()
}

/// Both enclosures contain the truth, in every chart and with every order of derivatives. A patch
/// around the point contains both, even if it reaches to infinity.
#[test]
fn a_lifted_formula_has_the_values_and_derivatives_of_its_formula() {
    let mut state = tautline_chance::seed(61);
    let mut below = move |n: u64| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
        (state >> 33) % n
    };
    let (mut far, mut bounded) = (0, 0);
    for text in FORMULAS {
        let formula = parsed::<2>(&format!("{text} I"));
        let lift = lift(&formula).expect("few variables");
        for case in 0..tautline_chance::cases(300) {
            let scale = [0.5, 2.0, 10.0, 60.0][case as usize % 4];
            let x = [0; 2].map(|_| (below(2001) as f64 - 1000.0) * 1e-3 * scale);
            let exact = formula.gram(&SVector::from(Jet2::variables(&x.map(Interval::point))));
            let narrow = lift.variables_at(x);
            far += usize::from(narrow.chart > 0);
            for patch in [narrow.clone(), widened(&narrow, &mut below)] {
                let (found, exact) = (expanded(&lift, &patch), &exact[(0, 0)]);
                let name = || format!("{text} at {x:?} in {patch:?}: {found:?} {exact:?}");
                // A root of a number that may be negative is undefined.
                let agree = |found: Jet1<Interval, 2>, exact: Interval| {
                    found.value().is_undefined() || same_place(found.value(), exact)
                };
                assert!(agree(found.value(0, 0), exact.value()), "{}", name());
                for (k, l) in [(0, 0), (0, 1), (1, 1)] {
                    assert!(agree(found.first(k, 0, 0), exact.first(k)), "{}", name());
                    assert!(agree(found.second(k, l, 0, 0), exact.second(k, l)), "{}", name());
                    bounded += usize::from(
                        found.second(k, l, 0, 0).value().is_finite()
                            && patch.sides.iter().any(|side| !side.is_finite()),
                    );
                }
            }
        }
    }
    assert!(far > 200 && bounded > 2000, "{far} {bounded}");
}

/// Returns the first two variables as such, and the others as numbers.
fn seeded(patch: &Patch) -> Vec<Jet1<Interval, 2>> {
    let seed = |(k, &side): (usize, &Interval)| {
        let slope = |i: usize| Interval::point(f64::from(u8::from(i == k)));
        Jet1::new(side, std::array::from_fn(slope))
    };
    patch.sides.iter().enumerate().map(seed).collect()
}

/// The derivatives by the variables of the search: between two patches that differ in one variable,
/// each coefficient changes by no more than its slope allows, also if the slope is that on a
/// half-line.
#[test]
fn the_slopes_of_a_search_bound_its_changes() {
    for text in FORMULAS {
        let lift = lift(&parsed::<2>(&format!("{text} I"))).expect("few");
        for x in [[0.3, -0.7], [1.5, 2.0], [-40.0, 30.0], [70.0, -45.0]] {
            let (from, mut to) = (lift.variables_at(x), lift.variables_at(x));
            to.sides[0] += Interval::point(0.25);
            let both = from.sides[0].hull(to.sides[0]);
            let infinity = Interval::new(both.hi(), f64::INFINITY).expect("in order");
            let of = |patch: &Patch| expanded(&lift, patch);
            let [before, after] = [&from, &to].map(of);
            for side in [both, both.hull(infinity), both.hull(-infinity)] {
                let mut hull = from.clone();
                hull.sides[0] = side;
                let hull = of(&hull);
                let check = |of: fn(&Expanded) -> Jet1<Interval, 2>| {
                    let change = of(&after).value() - of(&before).value();
                    let bound = of(&hull).first(0) * 0.25;
                    assert!(same_place(change, bound), "{text} at {x:?}: {change:?} {bound:?}");
                };
                check(|h| h.value(0, 0));
                check(|h| h.first(0, 0, 0));
                check(|h| h.second(0, 1, 0, 0));
                check(|h| h.second(1, 1, 0, 0));
            }
        }
    }
}

/// A form may change slowly in space, and the hill quickly with the form. On a half-line the slope by
/// the variable, which is the form, still bounds what the hill changes.
#[test]
fn a_steep_hill_of_a_form_that_changes_slowly_has_its_slope() {
    let text = "2 + exp(-250000*sqr(0.001*x1 + 0.001*x2)) I";
    let lift = lift(&parsed::<2>(text)).expect("few");
    for x in [[0.7, 0.7], [-2.0, 0.5], [0.1, 0.0]] {
        let (from, mut to) = (lift.variables_at(x), lift.variables_at(x));
        // The hill is about 1/500 wide.
        let step = 2.0_f64.powi(-16);
        to.sides[0] += Interval::point(step);
        let both = from.sides[0].hull(to.sides[0]);
        let infinity = Interval::new(both.hi(), f64::INFINITY).expect("in order");
        let of = |patch: &Patch| expanded(&lift, patch);
        let [before, after] = [&from, &to].map(of);
        for side in [both.hull(infinity), both.hull(-infinity)] {
            let mut hull = from.clone();
            hull.sides[0] = side;
            let hull = of(&hull);
            for of in [|h: &Expanded| h.value(0, 0), |h: &Expanded| h.first(0, 0, 0)] {
                let change = of(&after).value() - of(&before).value();
                let bound = of(&hull).first(0) * step;
                assert!(same_place(change, bound), "at {x:?}: {change:?} {bound:?}");
            }
        }
    }
}

/// Returns the constants of a metric on all of space, to one percent.
fn constants<const D: usize>(text: &str) -> CertifiedConstants {
    let formula = parsed::<D>(text);
    let space = Domain::space(&formula);
    assert!(space.is_all_of_space() && space.is_sharp(), "{text}");
    let accuracy = Accuracy { tolerance: 1e-2, budget: 100_000 };
    CertifiedConstants::new(&formula, &space, accuracy).expect(text)
}

fn check<const D: usize>(text: &str, exact: [f64; 4]) {
    let found = constants::<D>(text);
    assert!(!found.constants().expect(text).is_local());
    let m_h = found.m_h().expect("second derivatives");
    for (found, exact) in [found.c1(), found.c2(), found.l_h(), m_h].into_iter().zip(exact) {
        // The closed form is rounded.
        let holds = found.lower <= exact * (1.0 + 1e-14) && exact * (1.0 - 1e-14) <= found.upper;
        assert!(holds && found.looseness() <= 1.02, "{text}: {found:?} {exact}");
    }
}

#[test]
fn walls_waves_and_hills_have_constants_on_all_of_space() {
    let root = f64::sqrt;
    let half_turn = std::f64::consts::FRAC_PI_2;
    // The steepest logistic wall has slope ¼ and bend 1/(6 √3).
    let bend = 1.0 / (6.0 * root(3.0));
    check::<2>("4 + tanh(x1) + sin(x2) I", [2.0, 6.0, root(2.0), 1.0]);
    check::<2>("2.5 + 0.5*tanh(x1) + 0.5*sin(2*x2) I", [1.5, 3.5, root(1.25), 2.0]);
    // The gradients of both phases, and the sum of their squares as matrices.
    let norm = 0.825 + root(0.665 * 0.665 + 0.28 * 0.28);
    check::<2>("cos(x1) + sin(x1*0.7 + x2*0.4) + 3 I", [1.0, 5.0, root(3.05), norm]);
    check::<1>("3 + cos(x1) + cos(x1*sqrt(2)) I", [1.0, 5.0, 1.0 + root(2.0), 3.0]);
    let steep = 3.0 * root(3.0) / 8.0;
    check::<2>("3 + atan(x1 - x2) I", [3.0 - half_turn, 3.0 + half_turn, root(2.0), 2.0 * steep]);
    check::<1>("2 + 1/(1 + exp(-4*(x1 - 1))) I", [2.0, 3.0, 1.0, 16.0 * bend]);
    check::<1>("3 - 2/(2 + 5*exp(x1*0.5)) I", [2.0, 3.0, 0.125, 0.25 * bend]);
    check::<2>("1 + exp(-(sqr(x1) + sqr(x2))/2) I", [1.0, 2.0, (-0.5_f64).exp(), 1.0]);
    // e^(−|s|²/2) with s = B x: the largest singular value of B counts.
    let square = (9.0 + root(65.0)) / 2.0;
    let hill = "1 + exp(-(sqr(x1 - 1) + 4*sqr(x2 + x1))/2) I";
    check::<2>(hill, [1.0, 2.0, root(square) * (-0.5_f64).exp(), square]);
    // An eigenvalue of a full matrix.
    let full = "s = 0.5*sin(x1 + 0.3*x2); [3 + tanh(x1), s; s, 1]";
    let c1 = 1.5 - root(0.25 + 0.25);
    let found = constants::<2>(full);
    assert!(found.c1().contains(c1) && found.c1().looseness() < 1.02, "{found:?}");
}

/// A full matrix of logistic walls, with three normals that are not along the axes.
#[test]
fn a_full_matrix_of_walls_has_constants_in_three_dimensions() {
    let walls = "a = 1/(1 + exp(-(x1 + x2)*3)); b = 1/(1 + exp(-(x2 - x3 + 0.3)*2));
        c = 1/(1 + exp((x3 - 0.2)*4));
        [2 + a, 0.3*a*b, 0.2*c; 0.3*a*b, 1.5 + b, 0.25*b*c; 0.2*c, 0.25*b*c, 1.2 + c]";
    let formula = parsed::<3>(walls);
    let space = Domain::space(&formula);
    assert!(space.is_all_of_space() && space.is_sharp());
    let accuracy = Accuracy { tolerance: 1e-2, budget: 20_000 };
    for quantity in [Quantity::C1, Quantity::C2, Quantity::LH] {
        let found = certify(&formula, quantity, &space, accuracy).expect("a constant");
        assert!(found.looseness() < 1.0102, "{quantity}: {found:?}");
    }
    // Where all walls are down, the matrix is diagonal, with 1.2 in a corner.
    let c1 = certify(&formula, Quantity::C1, &space, accuracy).expect("a constant");
    assert!(c1.lower <= 1.2 && c1.upper <= 1.2 + 1e-12, "{c1:?}");
}

/// Near the origin the phase of a wave is that of its form. A phase of its own would give
/// `c₂ = 3` for the packet. If each wave had its own, `c₂` would be 8 for their sum.
#[test]
fn phases_are_shared_where_they_depend_on_each_other() {
    let packet = |x: f64| 2.0 + (-x * x).exp() * (5.0 * x).sin();
    let most = (0..4000).map(|k| packet(f64::from(k) * 1e-3)).fold(0.0, f64::max);
    let found = constants::<1>("2 + exp(-sqr(x1))*sin(5*x1) I");
    let c2 = found.c2();
    // Between the samples it is larger by at most ½ · 25.5 · (5e-4)².
    assert!(c2.upper >= most && c2.upper <= most * 1.02 && c2.lower <= most + 4e-6, "{c2:?}");
    let found = constants::<2>("5 + sin(x1) + cos(2*x1) + tanh(x2) I");
    let c2 = found.c2();
    assert!(c2.contains(6.0 + 9.0 / 8.0) && c2.looseness() < 1.02, "{c2:?}");
}

#[test]
fn what_does_not_settle_is_not_all_of_space() {
    for text in [
        "2 + sqr(x1) I",
        "2 + tanh(x1)*x2 I",
        "2 + exp(x1) I",
        "2 + exp(sqr(x1) - sqr(x2)) I",
        "2 + sin(x1*x2) I",
        "2 + exp(-x1) I",
        "2 + 1/(exp(x1) - 1) I",
        "2 + sin(sqr(x1)) I",
        "diag(2 + tanh(x1), x2)",
    ] {
        assert!(!Domain::space::<2>(&parsed(text)).is_all_of_space(), "{text}");
    }
    // Many variables would make the search hopeless.
    let many: Vec<_> = (1..10).map(|k| format!("tanh(x1 + {k}*x2)")).collect();
    let formula: Formula<2> = parsed(&format!("20 + {} I", many.join(" + ")));
    assert!(lift(&formula).is_none());
    assert!(!Domain::space(&formula).is_all_of_space());
}

/// An entry that is linear grows without bound wherever it stands, also if no other step reads its
/// form.
#[test]
fn a_linear_entry_off_the_diagonal_is_not_all_of_space() {
    for text in [
        "[2 + tanh(x1), 0.1*x2, 0; 0.1*x2, 3, 0; 0, 0, 1]",
        "[2 + tanh(x1), 0, 0.1*x1; 0, 3, 0; 0.1*x1, 0, 1]",
        "[2 + tanh(x1), 0, 0; 0, 3, x2 - x3; 0, x2 - x3, 1]",
        "[2, 0, 0; 0, 3, x3; 0, x3, 1 + exp(-sqr(x2))]",
    ] {
        assert!(!Domain::space::<3>(&parsed(text)).is_all_of_space(), "{text}");
    }
}

/// A product of linear functions of one form is a parabola. Products of more of them, or of
/// different forms, and quotients are not, and what they do far out is another matter.
#[test]
fn an_exponent_of_another_kind_is_no_hill() {
    let hills = |text: &str| {
        let formula = parsed::<2>(&format!("2 + {text} I"));
        let lift = lift(&formula).expect("few variables");
        (lift.hills.len(), Domain::space(&formula).is_all_of_space())
    };
    assert_eq!(hills("exp(x1*(1 - x1) - sqr(x2))"), (1, true));
    for text in [
        // In each of the first five, the linear parts alone have the product −x₁².
        "exp(x1*(sqr(x1) - x1))",
        "exp((sqr(x1) - x1)*x1)",
        "exp((x1 - sqr(x1))*(sqr(x1) - x1))",
        "exp((x1 + x1^2)*-x1 - sqr(x2))",
        "exp(sqr(x1 - sqr(x1))*-1)",
        "exp(-x1*x2)",
        "exp((x1 - x2)*(x2 + x1))",
        "exp(-(x1^3))",
        "exp(-sqr(x1)/(2 + x1))",
    ] {
        assert_eq!(hills(text), (0, false), "{text}");
    }
}

/// What stands above a wall counts: a function that settles keeps its values, and one that grows
/// still grows where the wall is down.
#[test]
fn a_numerator_of_a_wall_is_read() {
    for text in [
        "2 + x2/(1 + exp(x1)) I",
        "2 + x1/(1 + exp(x1)) I",
        "2 + (x1 - x2)/(2 + 3*exp(x2 - x1)) I",
        "2 + sqr(x2)/(1 + exp(x1)) I",
        "[2, x2/(1 + exp(x1)); 0, 2]",
    ] {
        assert!(!Domain::space::<2>(&parsed(text)).is_all_of_space(), "{text}");
    }
    let bend = 4.0 / (3.0 * 3_f64.sqrt());
    check::<2>("3 + tanh(x2)/(1 + exp(x1)) I", [2.0, 4.0, 1.0, bend]);
    check::<2>("3 + sin(x2)/(1 + 2*exp(x1)) I", [2.0, 4.0, 1.0, 1.0]);
}

/// The constants and the linear parts of an exponent may stand in any of its terms. The tops of these
/// hills are at no midpoint, so that the search finds them only by the bounds.
#[test]
fn a_hill_has_all_terms_of_its_exponent() {
    // e^(a − |s|²/2) is at most eᵃ, and has the slope e^(a − ½) and the bend eᵃ.
    let hill = |a: f64| [1.0, 1.0 + a.exp(), (a - 0.5).exp(), a.exp()];
    for (exponent, a) in [
        ("(1 - sqr(x1 - 0.3)/2) + (2 - sqr(x2 + 0.7)/2)", 3.0),
        ("(1 - sqr(x1 - 0.3)/2) - (sqr(x2 + 0.7)/2 - 2)", 3.0),
        ("2 - (sqr(x1 - 0.3) - 1)/2 - (sqr(x2 + 0.7) - 1)*0.5", 3.0),
        ("(0.3*x1 - sqr(x1)/2) + (x1 - 0.5*sqr(x2 + 0.7))", 0.845),
        ("(1.3*x1 - sqr(x1)/2) + (0.7*x2 - 0.5*sqr(x2))", 1.09),
        ("(x1 - sqr(x1 - 0.3)/2) - sqr(x2 - 0.7)/2", 0.8),
        ("(0.3 - x1)*(x1 + 3)/2 - sqr(x2 + 0.7)/2", 1.36125),
    ] {
        check::<2>(&format!("1 + exp({exponent}) I"), hill(a));
    }
}

/// The forms `x₁`, `x₂` and `x₁ + x₂` count as independent, so that the bounds may be too large, but
/// they hold; the lower one is that of a point of space.
#[test]
fn dependent_forms_are_overestimated_and_enclosed() {
    let formula = parsed::<2>("4 + tanh(x1) + tanh(x2) - tanh(x1 + x2) I");
    let accuracy = Accuracy { tolerance: 1e-2, budget: 100_000 };
    let space = Domain::space(&formula);
    let c2 = certify(&formula, Quantity::C2, &space, accuracy).expect("a constant");
    assert!(c2.contains(5.0) && c2.upper < 7.1 && c2.lower <= 5.0, "{c2:?}");
    assert!(!space.is_sharp());
    let value = formula.gram_at(&c2.at)[0];
    assert!((value / c2.lower - 1.0).abs() < 1e-14 && value > 4.5, "{c2:?}");
}

/// Along each argument of a table the constants are those of `g`, the function of one axis with the
/// coefficients 1, 5 and 2. It is 1 far to the left and 2 far to the right, and largest and steepest
/// between.
#[test]
fn tables_have_constants_on_all_of_space_along_each_of_their_arguments() {
    let tables = tables();
    // At steps of 2⁻¹⁰. Second differences of the coefficients are at most 7, and third ones 11, so that
    // the maxima are larger by at most 7 · 2⁻²³ and 11 · 2⁻²³, less than 10⁻⁵ of them.
    let most = |order: u8| {
        let at = |k: i32| tables[0].1.value(&[f64::from(k) / 1024.0], [order, 0, 0]).abs();
        (-2048..4096).map(at).fold(0.0, f64::max)
    };
    let (largest, steepest) = (most(0), most(1));
    let middle = tables[0].1.value(&[0.5], [0; 3]);
    let accuracy = Accuracy { tolerance: 1e-2, budget: 100_000 };
    for (text, [c1, c2, l_h]) in [
        ("t(x1)", [1.0, largest, steepest]),
        ("t(x2)", [1.0, largest, steepest]),
        ("h(0.5, x1)", [1.0 + middle, largest + middle, steepest]),
        ("h(x2, 0.5)", [1.0 + middle, largest + middle, steepest]),
        ("h(x1, x2)", [2.0, 2.0 * largest, 2_f64.sqrt() * steepest]),
        ("f(0.5, 0.5, 2*x2)", [1.0 + 2.0 * middle, largest + 2.0 * middle, 2.0 * steepest]),
        ("f(x2, 0.5, x1)", [2.0 + middle, 2.0 * largest + middle, 2_f64.sqrt() * steepest]),
    ] {
        let formula = Formula::<2>::parse_with(&format!("{text} I"), &[], &tables).expect(text);
        let space = Domain::space(&formula);
        assert!(space.is_all_of_space(), "{text}");
        for (quantity, exact) in [(Quantity::C1, c1), (Quantity::C2, c2), (Quantity::LH, l_h)] {
            let found = certify(&formula, quantity, &space, accuracy).expect(text);
            let holds = found.lower <= exact * (1.0 + 1e-5) && exact * (1.0 - 1e-14) <= found.upper;
            assert!(holds && found.looseness() <= 1.02, "{text}, {quantity}: {found:?} {exact}");
        }
    }
}

/// A network has thousands of sums, and each partial sum is linear. Only what is read counts.
#[test]
fn partial_sums_are_no_variables() {
    let sum: Vec<_> = (1..40).map(|k| format!("x1*{k} + x2*{k}")).collect();
    let formula = parsed::<2>(&format!("2 + tanh({}) I", sum.join(" + ")));
    let lift = lift(&formula).expect("one variable");
    assert_eq!((lift.forms.len(), lift.variables), (1, 1));
    assert!(Domain::space(&formula).is_all_of_space());
}

#[test]
fn charts_cover_all_values_of_a_form() {
    let lift = lift(&parsed::<1>("2 + tanh(x1)*sin(x1) I")).expect("two variables");
    let sides: Vec<_> = lift.patches().iter().map(|patch| patch.sides[0]).collect();
    let [near, left, right] = sides[..] else { panic!("{sides:?}") };
    assert_eq!([left.hi(), right.lo()], [near.lo(), near.hi()]);
    assert!(left.lo() == f64::NEG_INFINITY && right.hi() == f64::INFINITY);
    assert!(lift.patches().iter().skip(1).all(|patch| patch.sides[1].hi() > std::f64::consts::TAU));
}

/// The common divisor of 1024, 1 and ½ is too small for one phase; whichever comes last, each wave
/// has a phase.
#[test]
fn every_wave_has_a_phase_in_whatever_order_they_come() {
    let waves = ["cos(1024*x1)", "cos(x1)", "cos(0.5*x1)"];
    for order in [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]] {
        let [a, b, c] = order.map(|k| waves[k]);
        let formula = parsed::<1>(&format!("6 + {a} + {b} + {c} + tanh(x1) I"));
        let lift = lift(&formula).expect("three variables");
        assert_eq!((lift.variables, lift.forms[0].phases.len()), (3, 2), "{order:?}");
        let space = Domain::space(&formula);
        assert!(space.is_all_of_space() && space.is_sharp());
        let accuracy = Accuracy { tolerance: 1e-2, budget: 100_000 };
        // The waves are 3 together at the origin of their phases, where tanh is 1.
        let c2 = certify(&formula, Quantity::C2, &space, accuracy).expect("a constant");
        assert!(c2.upper >= 10.0 - 1e-9 && c2.upper < 10.1, "{order:?}: {c2:?}");
    }
    // The first two share a phase of wave number 3/2, which is not free of that of the third.
    let dependent = parsed::<1>("9 + cos(1027.5*x1) + cos(1029*x1) + cos(x1) + tanh(x1) I");
    let space = Domain::space(&dependent);
    assert!(space.is_all_of_space() && !space.is_sharp());
}

/// What is read off an exponent is read once for each step: this one has 2⁶⁰ paths, and 40 000
/// steps one above the other.
#[test]
fn an_exponent_of_many_steps_is_read_in_their_order() {
    let mut doubled = String::from("a0 = sqr(x1) + 2.5;");
    for k in 1..=60 {
        doubled += &format!(" a{k} = a{} + a{};", k - 1, k - 1);
    }
    let steps: Vec<&str> = vec!["x1^2"; 40_000];
    for (text, top) in [
        (format!("{doubled} 1 + exp(2.5 - a60*2^-60) I"), 2.0),
        (format!("1 + exp(-({})/40000) I", steps.join(" + ")), 2.0),
    ] {
        let formula = parsed::<1>(&text);
        let lift = lift(&formula).expect("one variable");
        assert_eq!(lift.hills.len(), 1);
        let space = Domain::space(&formula);
        assert!(space.is_all_of_space());
        let accuracy = Accuracy { tolerance: 1e-2, budget: 200 };
        let c2 = certify(&formula, Quantity::C2, &space, accuracy).expect("a constant");
        assert!(c2.lower <= top + 1e-9 && top <= c2.upper && c2.looseness() < 1.02, "{c2:?}");
    }
}

/// The phases of the smallest wave numbers are met nowhere among doubles; the constants stand.
#[test]
fn a_wave_that_hardly_moves_has_constants() {
    let formula = parsed::<2>("3 + tanh(x2) + cos(1e-310*x1) I");
    let space = Domain::space(&formula);
    assert!(space.is_all_of_space());
    let accuracy = Accuracy { tolerance: 1e-2, budget: 10_000 };
    let c2 = certify(&formula, Quantity::C2, &space, accuracy).expect("a constant");
    assert!(c2.upper >= 5.0 && c2.upper < 5.1, "{c2:?}");
}

/// Five times the double `0.1` is not `0.5`, so these forms are not parallel, and no variable serves
/// both; with dyadic numbers one does.
#[test]
fn forms_are_parallel_only_if_all_coefficients_are_exactly_so() {
    let forms = |text: &str| {
        let lift = lift(&parsed::<2>(&format!("3 + {text} I")));
        let lift = lift.expect("few variables");
        lift.forms.iter().map(|form| form.phases.len()).collect::<Vec<_>>()
    };
    for (text, phases) in [
        ("cos(0.1*x1 + 0.2*x2) + cos(0.5*x1 + x2)", vec![1, 1]),
        ("cos(0.1*x1 - 0.2*x2) + cos(x2*0.4 - x1*0.2)", vec![1]),
        ("cos(0.25*x1 + 0.5*x2) + cos(0.75*x1 + 1.5*x2)", vec![1]),
        // The second coefficients are one double apart.
        ("cos(x1 + x2) + cos(x1 + x2*1.0000000000000002)", vec![1, 1]),
        // Where products may underflow, forms are not compared.
        ("cos(5e-324*x1 + 5e-324*x2) + cos(x1*1e-300 + x2*1e-300)", vec![1, 1]),
        ("cos(0.1*x1) + cos(0.5*x1)", vec![2]),
        ("cos(0.1*x1) + cos(-0.8*x1)", vec![1]),
    ] {
        assert_eq!(forms(text), phases, "{text}");
    }
}
