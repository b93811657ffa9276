//! Formulas that call tables: the values and derivatives of the spline, in every way of evaluation.

use std::{any::Any, sync::Arc};

use nalgebra::{SMatrix, SVector, vector};
use tautline_chance::{cases, seed};
use tautline_formula::{
    AnyBatches, Batch, Formula, Kind, Operation, Part, Plain, Prepared, Problem, Written,
    spline::Spline,
};
use tautline_metrics::{Metric, is_gram};
use tautline_scalar::{Interval, Jet1, Jet2, Scalar, Table};

use crate::{programs::evaluate, random::Random};

/// Returns a table of this shape with coefficients in `[1, 5]`.
fn table(shape: &[usize], random: &mut Random) -> Arc<dyn Table> {
    let count = shape.iter().product();
    let coefficients = (0..count).map(|_| 3.0 + random.number() / 2.0).collect();
    Arc::new(Spline::new(shape, coefficients).expect("a shape"))
}

/// A metric in Rust that calls a table.
struct Cost(Arc<dyn Table>);

impl Metric<2> for Cost {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let height = S::tabulated(&self.0, [0; 3], &[x[0] * 2.0, x[1] + x[0]]);
        SMatrix::from_diagonal_element(height.sqr())
    }
}

#[test]
fn a_text_records_the_formula_of_rust() {
    let height = table(&[5, 7], &mut Random(seed(31)));
    let recorded = Formula::record(&Cost(Arc::clone(&height))).expect("a formula");
    let text = "sqr(height(x1*2, x2 + x1)) I";
    let tables = [("height", Arc::clone(&height))];
    assert_eq!(Formula::parse_with(text, &[], &tables), Ok(recorded.clone()));
    // Printed, it calls its tables by their numbers.
    let numbered = [("table1", Arc::clone(&height))];
    assert_eq!(Formula::parse_with(&recorded.to_string(), &[], &numbered), Ok(recorded.clone()));
    assert_eq!(Formula::record(&recorded), Ok(recorded.clone()));
    // Another table is another formula, even with the same steps.
    let other = table(&[5, 7], &mut Random(seed(32)));
    let other = Formula::record(&Cost(other)).expect("a formula");
    assert!(other.operations() == recorded.operations() && other != recorded);
}

/// Compares with the spline's own derivatives, by the chain rule by hand.
#[test]
fn jets_have_the_derivatives_of_the_table() {
    let mut random = Random(seed(33));
    for _ in 0..cases(64) {
        let height = table(&[5, 7], &mut random);
        let cost = Cost(Arc::clone(&height));
        let x = [random.number(), random.number()];
        let u = [2.0 * x[0], x[1] + x[0]];
        let of = |a: u8, b: u8| height.value(&u, [a, b, 0]);
        let (f, fu, fv) = (of(0, 0), of(1, 0), of(0, 1));
        // ∂₁u = 2, ∂₁v = ∂₂v = 1.
        let (first, second) = ([2.0 * fu + fv, fv], {
            let (uu, uv, vv) = (of(2, 0), of(1, 1), of(0, 2));
            [4.0 * uu + 4.0 * uv + vv, 2.0 * uv + vv, vv]
        });
        let jet = cost.gram(&SVector::from(Jet2::variables(&x)))[(0, 0)];
        // Numbers of 100 at most, in a dozen operations.
        let assert_close = |found: f64, expected: f64| {
            assert!((found - expected).abs() <= 1e-11, "{found} {expected} at {x:?}");
        };
        assert_close(jet.value(), f * f);
        for k in 0..2 {
            assert_close(jet.first(k), 2.0 * f * first[k]);
            for l in k..2 {
                let expected = 2.0 * (first[k] * first[l] + f * second[k + l]);
                assert_close(jet.second(k, l), expected);
            }
        }
        let once = cost.gram(&SVector::from(Jet1::variables(&x)))[(0, 0)];
        assert_eq!((once.value(), once.first(0)), (jet.value(), jet.first(0)));
    }
}

#[test]
fn intervals_contain_the_derivatives_of_the_table() {
    let mut random = Random(seed(34));
    for _ in 0..cases(64) {
        let cost = Cost(table(&[5, 7], &mut random));
        let corner = [random.number(), random.number()];
        let width = [1e-3, 0.1, 1.0, 4.0][random.below(4)];
        let sides = corner.map(|x| Interval::new(x, x + width).expect("ordered"));
        let bounds = cost.gram(&SVector::from(Jet2::variables(&sides)))[(0, 0)];
        for _ in 0..8 {
            let x = corner.map(|x| x + width * random.below(257) as f64 / 256.0);
            let jet = cost.gram(&SVector::from(Jet2::variables(&x)))[(0, 0)];
            // The value in doubles is off by its own rounding.
            let holds = |bounds: Interval, value: f64| {
                let slack = 1e-11 * bounds.magnitude().max(1.0);
                bounds.lo() - slack <= value && value <= bounds.hi() + slack
            };
            assert!(holds(bounds.value(), jet.value()));
            for (k, l) in [(0, 0), (0, 1), (1, 1)] {
                assert!(holds(bounds.first(k), jet.first(k)));
                assert!(holds(bounds.second(k, l), jet.second(k, l)), "{sides:?} {x:?}");
            }
        }
    }
    // A third derivative jumps at a node: between two nodes the fourth is 0, and across one it is none.
    let height = table(&[4], &mut random);
    let [side, across] = [(0.0, 1.0), (0.5, 1.5)].map(|(lo, hi)| Interval::new(lo, hi));
    let (side, across) = (side.expect("ordered"), across.expect("ordered"));
    let fourth = |side| Interval::tabulated(&height, [4, 0, 0], &[side]);
    assert!(fourth(side) == Interval::constant(0.0) && fourth(across).is_undefined());
    let third = Interval::tabulated(&height, [3, 0, 0], &[across]);
    let both = [0.75, 1.25].map(|u| height.value(&[u], [3, 0, 0]));
    assert!(both[0] != both[1] && both.iter().all(|&value| third.contains(value)));
    assert!(Interval::tabulated(&height, [0; 3], &[side, side]).is_undefined());
    assert!(f64::tabulated(&height, [0; 3], &[]).is_nan());
}

/// All rows of programs against those of the formula point by point, for tables on one to three
/// axes, under forms that differentiate them.
#[test]
fn programs_have_the_rows_of_the_formula() {
    let mut random = Random(seed(35));
    let texts = [
        "cost(h(x1, x2))",
        "graph(h(x1*x2, x2) + g(x1))",
        "[5 + h(x1, x2), 0.25*g(x1); 0.25*g(x1), 3 + sqr(f(x1, x2, x1 + x2))]",
        "pullback(x1 + 0.1*h(x1, x2), x2, 0.5*f(x2, x1, 1 + x1))",
    ];
    for text in texts {
        for _ in 0..cases(16) {
            let tables = [
                ("f", table(&[3, 4, 5], &mut random)),
                ("g", table(&[6], &mut random)),
                ("h", table(&[5, 7], &mut random)),
            ];
            let formula = Formula::<2>::parse_with(text, &[], &tables).expect("a formula");
            let (prepared, plain) = (Prepared::new(formula.clone()), Plain::new(formula.clone()));
            let place = |random: &mut Random| {
                let [a, b] = [random.number(), random.number()];
                (vector![a, b] * 0.5 + vector![1.0, 2.0], vector![0.5, -1.0])
            };
            let places: Vec<_> = (0..5).map(|_| place(&mut random)).collect();
            for kind in [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction] {
                assert!(prepared.size(kind).is_some(), "{text} has a program");
                let [found, expected] = [&prepared as &dyn AnyBatches, &plain].map(|metric| {
                    let mut batch = tautline_formula::Batch::new(metric, kind, 5, 1);
                    let is_metric = evaluate(&mut batch, &places);
                    let layout = batch.layout();
                    let lists = [
                        &layout.square,
                        &layout.momentum,
                        &layout.slope,
                        &layout.gram,
                        &layout.turn,
                        &layout.bend,
                    ];
                    let row = |&row| batch.row(row)[..5].to_vec();
                    (is_metric, lists.map(|list| list.iter().flat_map(row).collect::<Vec<_>>()))
                });
                // Of a square alone it is not known whether it belongs to a metric.
                let all = places.iter().all(|(x, _)| is_gram(&formula.gram(x)));
                assert!(all && expected.0 && found.0, "{text} {kind:?}");
                for (found, expected) in found.1.iter().zip(&expected.1) {
                    assert_eq!(found.len(), expected.len());
                    for (found, expected) in found.iter().zip(expected) {
                        // Sums of some hundred products of numbers below 500.
                        let tolerance = 1e-10 * expected.abs().max(100.0);
                        assert!((found - expected).abs() <= tolerance, "{text} {kind:?}");
                    }
                }
            }
        }
    }
}

#[test]
fn derivatives_have_names() {
    let mut random = Random(seed(36));
    let tables = [("h", table(&[5, 7], &mut random))];
    let h = |a: u8, b: u8| tables[0].1.value(&[1.25, 2.5], [a, b, 0]);
    let at = |text: &str| {
        let text = format!("[{text}]");
        let formula = Formula::<1>::parse_with(&text, &[], &tables).expect("a formula");
        // Printed and read again it is the same.
        let numbered = [("table1", Arc::clone(&tables[0].1))];
        assert_eq!(Formula::parse_with(&formula.to_string(), &[], &numbered), Ok(formula.clone()));
        formula.gram(&vector![1.25])[(0, 0)]
    };
    assert_eq!(at("h(x1, 2.5)"), h(0, 0));
    assert_eq!(at("h_10(x1, 2.5)"), h(1, 0));
    assert_eq!(at("h_02(x1, 2.5)"), h(0, 2));
    // A form differentiates: I + (∂h)².
    let graph = Formula::<1>::parse_with("graph(h(x1, 2.5))", &[], &tables).expect("a formula");
    assert!((graph.gram(&vector![1.25])[(0, 0)] - (1.0 + h(1, 0).powi(2))).abs() < 1e-12);
    let call = |operation: &&Operation| matches!(operation, Operation::Table(_));
    assert_eq!(graph.operations().iter().filter(call).count(), 1, "the derivative alone");
}

/// A form may differentiate a table twice along each axis. Third derivatives jump, so a form of one is
/// undefined everywhere, in every number type, unless the argument does not change.
#[test]
fn a_form_takes_no_third_derivative_of_a_table() {
    let tables = [("h", table(&[5, 7], &mut Random(seed(40))))];
    let h = |a: u8, b: u8| tables[0].1.value(&[1.25, 2.5], [a, b, 0]);
    let parsed = |text: &str| Formula::<1>::parse_with(text, &[], &tables).expect(text);
    for (text, slope) in [
        ("graph(h(x1, 2.5))", h(1, 0)),
        ("graph(h_10(x1, 2.5))", h(2, 0)),
        ("graph(h_02(x1, 2.5))", h(1, 2)),
        ("graph(h_12(x1, 2.5))", h(2, 2)),
        ("graph(h_21(1.25, 2*x1))", 2.0 * h(2, 2)),
        ("graph(3*x1 + h_22(1.25, 2.5))", 3.0),
    ] {
        let found = parsed(text).gram(&vector![1.25])[(0, 0)];
        // The slopes are below 100, and their squares have a few roundings.
        assert!((found - (1.0 + slope * slope)).abs() < 1e-11, "{text}: {found} {slope}");
    }
    for text in [
        "graph(h_20(x1, 2.5))",
        "graph(h_02(1.25, 2*x1))",
        "graph(h_20(x1, 2*x1))",
        "graph(h_02(x1, 2*x1))",
        "pullback(x1 + sqr(h_21(x1, 2.5)))",
    ] {
        let formula = parsed(text);
        assert!(formula.gram(&vector![1.25])[(0, 0)].is_nan(), "{text}");
        let side = Interval::new(1.25, 1.5).expect("ordered");
        assert!(formula.gram(&vector![side])[(0, 0)].is_undefined(), "{text}");
    }
}

#[test]
fn wrong_calls_are_refused_where_they_stand() {
    let tables = [("h", table(&[5, 7], &mut Random(seed(37))))];
    let cases = [
        ("[h(x1)]", 1..6, "h takes 2 arguments, found 1"),
        ("[h(x1, x1, x1)]", 1..14, "h takes 2 arguments, found 3"),
        ("[h]", 2..3, "found ], expected ("),
        ("[h_1(x1, x1)]", 1..4, "unknown function h_1"),
        ("[h_30(x1, x1)]", 1..5, "unknown function h_30"),
        ("[g(x1, x1)]", 1..2, "unknown function g"),
        ("h = 2; [h]", 0..1, "h is already defined"),
    ];
    for (text, at, problem) in cases {
        let error = Formula::<1>::parse_with(text, &[], &tables).expect_err("refused");
        assert_eq!((error.at, error.problem.to_string()), (at, problem.to_owned()), "{text}");
    }
    let twice = [("h", Arc::clone(&tables[0].1)), ("h", Arc::clone(&tables[0].1))];
    let error = Formula::<1>::parse_with("[1]", &[], &twice).expect_err("refused");
    assert!(matches!(error.problem, Problem::TakenName { .. }), "{error}");
    // `h_10` is a derivative, and nothing else may have its name; `h_1` and `h_x` are none.
    let [h, other] = [("h", Arc::clone(&tables[0].1)), ("h_10", Arc::clone(&tables[0].1))];
    for (tables, parameters, text) in [
        (vec![h.clone(), other.clone()], vec![], "[1]"),
        (vec![other, h.clone()], vec![], "[1]"),
        (vec![h.clone()], vec![("h_10", 1.0)], "[1]"),
        (vec![h.clone()], vec![], "h_10 = 2; [1]"),
    ] {
        let error = Formula::<1>::parse_with(text, &parameters, &tables).expect_err("taken");
        let problem = Problem::TakenName { name: "h_10".to_owned() };
        assert_eq!(error.problem, problem, "{parameters:?} {text}");
    }
    let free = Formula::<1>::parse_with("h_1 = 2; h_x = 3; [h_1*h_x]", &[("h_", 1.0)], &[h]);
    assert!(free.is_ok(), "{free:?}");
}

#[test]
fn texts_together_and_recorded_formulas_call_tables() {
    let tables = [("h", table(&[5, 7], &mut Random(seed(38))))];
    let part = |text| Part { text, id: 0 };
    let metric = Written::Form(tautline_formula::Form::Cost, vec![part("h(x1, x2)")]);
    let composed = Formula::<2>::compose(&[], &tables, &[], &metric).expect("a formula");
    let parsed = Formula::<2>::parse_with("cost(h(x1, x2))", &[], &tables).expect("a formula");
    assert_eq!(composed, parsed);
    let recorded = Written::Recorded(parsed.clone().into_any());
    let twice = Written::Sum(vec![recorded, metric]);
    let twice = Formula::<2>::compose(&[], &tables, &[], &twice).expect("a formula");
    let x = vector![1.5, 2.25];
    assert_eq!(twice.gram(&x), parsed.gram(&x) * 2.0);
    assert_eq!(twice.tables().len(), 1, "the table is the same");
}

/// A table whose value no entry needs is none of the formula, and the others are numbered by their
/// first calls.
#[test]
fn tables_are_those_that_are_called() {
    let mut random = Random(seed(39));
    let tables = ["a", "b", "c"].map(|name| (name, table(&[4], &mut random)));
    let text = "idle = a(x1); third = c(x1); second = b(x1); [second + third]";
    let formula = Formula::<1>::parse_with(text, &[], &tables).expect("a formula");
    assert_eq!(formula.tables(), [Arc::clone(&tables[2].1), Arc::clone(&tables[1].1)]);
    let expected = tables[1].1.value(&[1.5], [0; 3]) + tables[2].1.value(&[1.5], [0; 3]);
    assert_eq!(formula.gram(&vector![1.5])[(0, 0)], expected);
    assert!(formula.to_string().contains("table2(x1)") && !formula.to_string().contains("table3"));
}

/// A table with the constant value of its field. All have the same fingerprint.
#[derive(Debug)]
struct Level(f64);

impl Table for Level {
    fn axes(&self) -> usize {
        1
    }
    fn value(&self, _: &[f64], orders: [u8; 3]) -> f64 {
        if orders == [0; 3] { self.0 } else { 0.0 }
    }
    fn bounds(&self, sides: &[(f64, f64)], orders: [u8; 3]) -> Option<(f64, f64)> {
        let value = self.value(&[sides[0].0], orders);
        Some((value, value))
    }
    fn fingerprint(&self) -> u64 {
        7
    }
    fn is_same(&self, other: &dyn Table) -> bool {
        (other as &dyn Any).downcast_ref::<Self>().is_some_and(|other| self.0 == other.0)
    }
}

/// Other tables may have the same fingerprint, by accident or because somebody looked for such a pair.
#[test]
fn tables_with_the_same_fingerprint_are_not_taken_for_each_other() {
    let [two, three, also_two] =
        [2.0, 3.0, 2.0].map(|value| Arc::new(Level(value)) as Arc<dyn Table>);
    let tables = [("a", Arc::clone(&two)), ("b", Arc::clone(&three)), ("c", also_two)];
    let parsed = |text: &str| Formula::<1>::parse_with(text, &[], &tables).expect(text);
    let both = parsed("[a(x1) + 10*b(x1) + 100*c(x1)]");
    assert_eq!(both.gram(&vector![0.5])[(0, 0)], 232.0);
    assert_eq!(
        both.tables(),
        [Arc::clone(&two), Arc::clone(&three)],
        "the first and the last are one"
    );
    let [a, b, c] = ["[a(x1)]", "[b(x1)]", "[c(x1)]"].map(parsed);
    assert!(a != b && a == c && a.operations() == b.operations());
    // Neither are those of recorded formulas that are put together.
    let recorded = [a, b].map(|one| Written::Recorded(one.into_any()));
    let sum = Formula::<1>::compose(&[], &[], &[], &Written::Sum(recorded.to_vec()));
    let sum = sum.expect("a formula");
    assert_eq!((sum.gram(&vector![0.5])[(0, 0)], sum.tables().len()), (5.0, 2));
    let prepared = Prepared::new(both);
    let mut batch = Batch::new(&prepared, Kind::Checked, 1, 1);
    batch.inputs(1).set(0, &vector![0.5], &vector![1.0]);
    assert!(batch.evaluate(1) && batch.row(batch.layout().square[0])[0] == 232.0);
}
