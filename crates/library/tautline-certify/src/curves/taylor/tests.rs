//! Taylor coefficients compared with nested jets, over intervals, and where functions are
//! undefined.

use std::sync::Arc;

use tautline_formula::spline::Spline;
use tautline_scalar::{Interval, Jet2, Scalar, Table};

use super::Taylor;

/// Applies every operation of a scalar.
fn functions<S: Scalar>(x: S) -> Vec<(&'static str, S)> {
    vec![
        ("sqr", x.sqr()),
        ("cube", x.powi(3)),
        ("power 6", x.powi(6)),
        ("power -3", x.powi(-3)),
        ("power 0", x.powi(0) * x),
        ("recip", x.recip()),
        ("sqrt", (x + 1.0).sqrt()),
        ("exp", (-x).exp()),
        ("ln", (x + 1.0).ln()),
        ("sin", x.sin()),
        ("cos", (x * 3.0).cos()),
        ("tan", x.tan()),
        ("atan", x.atan()),
        ("sinh", x.sinh()),
        ("cosh", x.cosh()),
        ("tanh", (x - 0.25).tanh()),
        ("quotient", (x.sin() + 2.0) / (x.exp() + 0.5)),
        ("nested", ((x.sqr() + 1.0).sqrt() / 3.0).exp() * x.cos()),
    ]
}

/// A jet of jets, which knows four derivatives.
type Nested = Jet2<Jet2<f64, 1>, 1>;

/// Returns the variable of the line at `x`.
fn nested(x: f64) -> Nested {
    let [inner] = Jet2::<f64, 1>::variables(&[x]);
    let [outer] = Jet2::<_, 1>::variables(&[inner]);
    outer
}

/// Returns the Taylor coefficients of a function of the line.
fn of_jet(jet: &Nested) -> [f64; 5] {
    let (value, second) = (jet.value(), jet.second(0, 0));
    [
        value.value(),
        value.first(0),
        value.second(0, 0) / 2.0,
        second.first(0) / 6.0,
        second.second(0, 0) / 24.0,
    ]
}

/// Nested second-order jets share no recurrence with the Taylor coefficients.
#[test]
fn coefficients_agree_with_nested_jets() {
    for x in [0.125, 0.5, 1.3, -0.7] {
        let ours = functions(Taylor::<f64, 5>::line(x, 1.0));
        for ((name, taylor), (_, jet)) in ours.into_iter().zip(functions(nested(x))) {
            let jets = of_jet(&jet);
            // The tolerance covers about thirty roundings of terms up to eight times the result.
            let size = jets.iter().fold(1.0_f64, |size, c| size.max(c.abs()));
            for k in 0..5 {
                let error = (taylor.coefficient(k) - jets[k]).abs();
                let tolerance = 128.0 * f64::EPSILON * size;
                assert!(error <= tolerance, "{name} at {x}, coefficient {k}: {error:e}");
            }
        }
    }
}

/// The coefficients at each point of an interval lie in the coefficients over the interval.
#[test]
fn an_interval_encloses_the_coefficients_of_its_points() {
    let line = |x| functions(Taylor::<Interval, 5>::line(x, Interval::point(1.0)));
    let range = line(Interval::new(0.5, 1.0).expect("ordered"));
    for x in [0.5, 0.625, 0.8125, 1.0] {
        for ((name, all), (_, one)) in range.iter().zip(line(Interval::point(x))) {
            for k in 0..5 {
                let (all, one) = (all.coefficient(k), one.coefficient(k));
                assert!(all.contains_interval(one), "{name}, {k}: {one:?} in {all:?}");
            }
        }
    }
}

/// A function that is undefined at a point of the interval has no finite value.
#[test]
fn undefined_values_stay_undefined() {
    let across = Interval::new(-1.0, 1.0).expect("ordered");
    let x = Taylor::<Interval, 5>::line(across, Interval::point(1.0));
    let one = Taylor::constant(1.0);
    // The interval is negative throughout: 1/x is defined, but the logarithm is not.
    let negative = x - 2.0;
    let undefined =
        [x.recip(), x.ln(), x.sqrt(), x.powi(-2), one / x, (x * 2.0).tan(), negative.ln()];
    for y in undefined {
        for z in [y, y.powi(0), y * 0.0, y.atan(), one / (y.sqr() + 1.0)] {
            assert!(z.coefficient(0).is_undefined(), "{z:?}");
        }
        assert!((1..5).all(|k| y.coefficient(k).is_undefined()), "{y:?}");
    }
    // The root of an interval that touches zero is defined, but its derivatives are not.
    let touching = Interval::new(0.0, 1.0).expect("ordered");
    let root = Taylor::<Interval, 5>::line(touching, Interval::point(1.0)).sqrt();
    assert_eq!(root.coefficient(0), touching);
    assert!((1..5).all(|k| root.coefficient(k).is_undefined()));
}

/// Returns tables with one, two and three axes of four coefficients each, which are no sums or products
/// of functions of one argument.
fn tables() -> [Arc<dyn Table>; 3] {
    [1_u32, 2, 3].map(|axes| {
        let coefficient = |place: usize| ((7 * place * place + 3 * place) % 11) as f64;
        let coefficients = (0..4_usize.pow(axes)).map(coefficient).collect();
        let table = Spline::new(&vec![4; axes as usize], coefficients).expect("a shape");
        Arc::new(table) as Arc<dyn Table>
    })
}

/// Applies tables, and derivatives of them, to functions of a scalar near 0.45 that stay within one cell.
fn tabulated<S: Scalar>(x: S) -> Vec<(&'static str, S)> {
    let [t, h, f] = tables();
    // These lie in [1, 2], in [0, 1] and in [2, 3].
    let (a, b, c) = (x.sin() + 1.0, x.sqr() + 0.25, x * 0.5 + 2.25);
    vec![
        ("one axis", S::tabulated(&t, [0; 3], &[a])),
        ("one axis, slope", S::tabulated(&t, [1, 0, 0], &[b])),
        ("one axis, bend", S::tabulated(&t, [2, 0, 0], &[c])),
        ("two axes", S::tabulated(&h, [0; 3], &[a, b])),
        ("two axes, the other way", S::tabulated(&h, [0; 3], &[b, a])),
        ("two axes, slope along the first", S::tabulated(&h, [1, 0, 0], &[a, c])),
        ("two axes, slope along the second", S::tabulated(&h, [0, 1, 0], &[a, c])),
        ("two axes, mixed", S::tabulated(&h, [1, 2, 0], &[c, b])),
        ("three axes", S::tabulated(&f, [0; 3], &[a, b, c])),
        ("three axes, another way", S::tabulated(&f, [0; 3], &[c, a, b])),
        ("three axes, slope along the last", S::tabulated(&f, [0, 0, 1], &[b, c, a])),
        ("three axes, mixed", S::tabulated(&f, [1, 0, 1], &[a, b, c])),
    ]
}

#[test]
fn coefficients_of_tables_agree_with_nested_jets() {
    for x in [0.4375, 0.5, 0.4] {
        let ours = tabulated(Taylor::<f64, 5>::line(x, 1.0));
        for ((name, taylor), (_, jet)) in ours.into_iter().zip(tabulated(nested(x))) {
            let jets = of_jet(&jet);
            // Derivatives of a table are known to 2⁻⁴⁷ of 2⁷ times its coefficients, which are at most
            // 10. At most 35 of them enter, with factors of at most 2.
            for k in 0..5 {
                let error = (taylor.coefficient(k) - jets[k]).abs();
                assert!(
                    error <= 1e-9,
                    "{name} at {x}, coefficient {k}: {error:e} of {:e}",
                    jets[k]
                );
            }
        }
    }
}

/// Both enclose the coefficients at a point of the interval.
#[test]
fn an_interval_and_its_points_have_common_coefficients_of_tables() {
    let line = |x| tabulated(Taylor::<Interval, 5>::line(x, Interval::point(1.0)));
    let range = line(Interval::new(0.375, 0.5).expect("ordered"));
    for x in [0.375, 0.4, 0.4375, 0.5] {
        for ((name, all), (_, one)) in range.iter().zip(line(Interval::point(x))) {
            for k in 0..5 {
                let (all, one) = (all.coefficient(k), one.coefficient(k));
                assert!(all.intersection(one).is_some(), "{name}, {k}: {one:?} in {all:?}");
            }
        }
    }
}

/// With too few or too many arguments no coefficient is defined.
#[test]
fn a_table_of_other_arguments_has_no_coefficients() {
    let x = Taylor::<Interval, 5>::line(Interval::point(0.5), Interval::point(1.0)).sqr();
    for (table, axes) in tables().iter().zip(1..) {
        for count in (1..=4).filter(|&count| count != axes) {
            let y = Taylor::tabulated(table, [0; 3], &vec![x; count]);
            assert!((0..5).all(|k| y.coefficient(k).is_undefined()), "{axes} {count}: {y:?}");
        }
    }
}

/// Third derivatives of a table jump at a knot, so that there is no fourth one around it. It adds
/// nothing to the coefficients below, which stay defined, also along the other axes.
#[test]
fn around_a_knot_only_the_last_coefficient_of_a_table_is_undefined() {
    let [t, h, f] = tables();
    let around = Interval::new(0.9375, 1.0625).expect("ordered");
    let x = Taylor::<Interval, 5>::line(around, Interval::point(1.0));
    let inside = x * 0.5 + 1.0;
    for y in [
        Taylor::tabulated(&t, [0; 3], &[x]),
        Taylor::tabulated(&h, [0; 3], &[x, inside]),
        Taylor::tabulated(&h, [0; 3], &[inside, x]),
        Taylor::tabulated(&f, [0; 3], &[inside, inside, x]),
        Taylor::tabulated(&f, [0; 3], &[inside, x, inside]),
    ] {
        assert!((0..4).all(|k| y.coefficient(k).is_finite()), "{y:?}");
        assert!(y.coefficient(4).is_undefined(), "{y:?}");
    }
}
