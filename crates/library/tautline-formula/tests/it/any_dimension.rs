//! Formulas in a dimension that is a value, against the same in a dimension that is a type.

use tautline_formula::{AnyBatches, Batch, Formula, Kind, Prepared, PreparedFormula};
use tautline_scalar::ANY;

const KINDS: [Kind; 4] = [Kind::Square, Kind::Checked, Kind::Momentum, Kind::Contraction];

fn bits(metric: &dyn AnyBatches, kind: Kind) -> Vec<u64> {
    let mut batch = Batch::new(metric, kind, 5, 1);
    for i in 0..metric.dimension() {
        let [x, d] = batch.input(i);
        for lane in 0..5 {
            (x[lane], d[lane]) = ((1.0 + (i + 3 * lane) as f64).sin(), 0.1 * (i as f64 - 1.5));
        }
    }
    assert!(batch.evaluate(5));
    let layout = batch.layout();
    let all = [&layout.square, &layout.momentum, &layout.slope, &layout.gram, &layout.turn];
    let registers = all.into_iter().chain([&layout.bend]).flatten();
    registers.flat_map(|&row| batch.row(row)[..5].iter().map(|x| x.to_bits())).collect()
}

fn compare<const D: usize>(text: &str) {
    let typed = Formula::<D>::parse(text, &[("a", 2.0)]).expect(text);
    let any = Formula::parse_in(D, text, &[("a", 2.0)], &[]).expect(text);
    assert_eq!(any, typed.clone().into_any());
    assert_eq!(any.clone().into_dimension::<D>(), Some(typed.clone()));
    assert_eq!(any.to_string(), typed.to_string());
    assert_eq!(Formula::<ANY>::into_dimension::<7>(any.clone()), None);
    let (one, other) = (PreparedFormula::new(any), Prepared::<_, D>::new(typed));
    for kind in KINDS {
        assert_eq!(bits(&one, kind), bits(&other, kind), "{text} {kind:?}");
    }
    let mut grams = [vec![0.0; D * D], vec![0.0; D * D]];
    for (gram, metric) in grams.iter_mut().zip([&one as &dyn AnyBatches, &other]) {
        metric.gram_into(&[0.3; D], gram);
    }
    assert_eq!(grams[0], grams[1]);
}

#[test]
fn the_dimension_of_a_formula_is_a_value_or_a_type_with_the_same_bits() {
    compare::<1>("(a - cos(x1))^2 I");
    compare::<2>("graph(a*exp(-(x1^2 + x2^2)/2))");
    compare::<3>("phi(a + sin(x1)*cos(x2) + x3^2)");
    compare::<9>("phi(a + sin(x1 + x9)*cos(x2))");
}

/// No type has so many coordinates.
#[test]
fn a_formula_may_have_hundreds_of_coordinates() {
    let formula =
        Formula::parse_in(200, "phi(2 + sin(x200)*x1)", &[], &[]).expect("200 coordinates");
    let metric = PreparedFormula::new(formula);
    let mut batch = Batch::new(&metric, Kind::Momentum, 1, 1);
    for i in 0..200 {
        let [x, d] = batch.input(i);
        (x[0], d[0]) = (0.5, if i < 2 { 1.0 } else { 0.0 });
    }
    assert!(batch.evaluate(1));
    // With d = (1, 1, 0, …), Hd = φ d and Gₖ = 2 ∂ₖφ.
    let at = |row: u32| batch.row(row)[0];
    let phi = 2.0 + 0.5_f64.sin() * 0.5;
    assert!((at(batch.layout().momentum[1]) - phi).abs() < 1e-15);
    assert_eq!(at(batch.layout().momentum[2]), 0.0);
    assert!((at(batch.layout().slope[199]) - 2.0 * 0.5_f64.cos() * 0.5).abs() < 1e-15);
    let error = Formula::parse_in(200, "phi(x201)", &[], &[]).unwrap_err();
    assert_eq!(error.to_string(), "at byte 4: there is no x201 in dimension 200");
}
