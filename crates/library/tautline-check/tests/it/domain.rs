//! Certificates whose curves leave the domain of the metric, through pockets where `H` is indefinite,
//! poles of a step, and cells of a table, and certificates whose curves just do not. None that is
//! accepted is false.
//!
//! With `TAUTLINE_CERTIFICATES` set to a folder, all files are written there, with what this checker
//! says in their names, for `second/check.py`.

use std::{path::PathBuf, sync::Arc};

use nalgebra::{SVector, vector};
use tautline_chance::{Random, cases, seed};
use tautline_check::{AnyCertificate, Certificate, CheckError, Level, Region, length_above};
use tautline_formula::{Formula, spline::Spline};
use tautline_scalar::Table;
use tautline_sets::{Ball, HalfSpace, Shape};

use crate::helpers::{formula, point};

/// Checks a certificate as it is read, and writes it if a folder is named.
fn checked<const D: usize>(
    kind: &str,
    number: usize,
    certificate: &Certificate<D>,
) -> Result<f64, CheckError> {
    let text = certificate.to_string();
    let verdict = AnyCertificate::read(&text).and_then(|certificate| certificate.check());
    if let Some(folder) = std::env::var_os("TAUTLINE_CERTIFICATES") {
        let said = if verdict.is_ok() { "accepted" } else { "refused" };
        let path = PathBuf::from(folder).join(format!("{kind}-{number}-{said}.cert"));
        std::fs::write(&path, &text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }
    verdict.map(|verdict| verdict.upper.expect("a curve"))
}

/// Returns a certificate with this curve. Its cubes prove little, so that all depends on the curve.
fn with_curve<const D: usize>(
    formula: Formula<D>,
    sets: [Shape<D>; 2],
    curve: Vec<SVector<f64, D>>,
) -> Certificate<D> {
    // Any bound above the length of the curve will do.
    let hi = 16.0;
    let region = Region::Declared { c1: 4.0 };
    // A checker that rounds more needs those that are just far enough away.
    let wide = hi * (1.0 + 1e-12);
    let cubes = region.required(sets.each_ref(), wide, 0).expect("bounded sets");
    let values = vec![0.0; cubes.nodes().len()];
    let levels = vec![Level::new(0, cubes, [values.clone(), values]).expect("finite")];
    Certificate { formula, sets, hi, region, curve: Some(curve), levels }
}

/// Returns the points with ends added.
fn between(from: f64, inner: impl IntoIterator<Item = [f64; 2]>, to: f64) -> Vec<SVector<f64, 2>> {
    let inner = inner.into_iter().map(SVector::from);
    [vector![from, 0.0]].into_iter().chain(inner).chain([vector![to, 0.0]]).collect()
}

/// Returns `∫ f` by the midpoint rule.
fn integral(f: impl Fn(f64) -> f64, [from, to]: [f64; 2]) -> f64 {
    let n = 40_000;
    let step = (to - from) / f64::from(n);
    (0..n).map(|k| f(from + (f64::from(k) + 0.5) * step)).sum::<f64>() * step
}

/// `H = diag(1 − a b, 1 − c b)` with `b = exp(−k|x|²)` and `c > 1`: indefinite where `b ≥ 1/c`. In the
/// domain `b ≤ min(1/c, exp(−k x₁²))`, so that no curve from `x₁ = −1` to `x₁ = 1` is shorter than
/// `∫ √(1 − a min(1/c, exp(−k x₁²))) dx₁`. The straight line is.
#[test]
fn curves_through_a_pocket_are_refused() {
    let mut random = Random(seed(91));
    let (mut accepted, mut refused) = (0, 0);
    for number in 0..cases(120) {
        let (a, c) = (random.between(0.1, 0.95), 1.0 + 10.0_f64.powf(random.between(-2.0, 1.0)));
        let k = 10.0_f64.powf(random.between(0.5, 3.0));
        let text = "b = exp(-k*(x1^2 + x2^2)); [1 - a*b, 0; 0, 1 - c*b]";
        let metric = Formula::<2>::parse(text, &[("a", a), ("c", c), ("k", k)]).expect("a formula");
        let radius = (c.ln() / k).sqrt();
        let most = |x: f64| (1.0 / c).min((-k * x * x).exp());
        let least = integral(|x| (1.0 - a * most(x)).sqrt(), [-1.0, 1.0]);
        // Straight through it, or past it at a height that is near its radius; with few chords or many.
        let height = match number % 4 {
            0 => 0.0,
            1 => random.between(0.0, 2.0) * radius,
            2 => radius * (1.0 + random.sign() * 10.0_f64.powf(random.between(-9.0, -1.0))),
            _ => 1.05 * radius,
        };
        let chords = [1, 7, 64][(random.unit() * 3.0) as usize];
        let along =
            (0..=chords).map(|n| [2.0 * radius * (f64::from(n) / f64::from(chords) - 0.5), height]);
        let curve = between(-1.0, along, 1.0);
        let inside = height < radius * (1.0 - 1e-12);
        let certificate = with_curve(metric, [-1.0, 1.0].map(|x| point([x, 0.0])), curve);
        match checked("pocket", number as usize, &certificate) {
            Ok(upper) => {
                assert!(!inside && upper >= least * (1.0 - 1e-7), "{upper} {least} {certificate}");
                accepted += 1;
            }
            Err(error) => {
                assert!(matches!(error, CheckError::CurveDomain { .. }), "{error}");
                // A curve that stays clear of the pocket is no longer than twelve halvings need.
                assert!(number % 4 != 3 || chords == 1, "{error} {certificate}");
                refused += 1;
            }
        }
    }
    assert!(accepted > 20 && refused > 20, "{accepted} {refused}");
}

/// A line `x₁ = w` on which a step is undefined, or `H` is not definite, cuts the domain in two: there
/// is no curve at all from one side to the other.
#[test]
fn no_curve_leads_across_a_line_where_there_is_no_metric() {
    let walls = [
        "[1, 0; 0, 1 + 0/(x1 - w)]",
        "p = (x1 - w)^-1; [1, 0*p; 0*p, 1]",
        "[1 + (1/(x1 - w))^0, 0; 0, 1]",
        "p = 0*ln(sqr(x1 - w)); [1, p; p, 1]",
        "[1, 0; 0, sqr(x1 - w)]",
        "[1, 0; 0, sqr(x1 - w) - t^2]",
        "[1, 0; 0, x1 - w + t]",
        "p = sqrt(1 - sqr((x1 - w)/(2*t))); [1, 1 + 0*p; 1 + 0*p, 1 + sqr(x1 - w) + 0*p]",
        "[1, 0, 0; 0, 1, 1 - sqr(x1 - w); 0, 1 - sqr(x1 - w), 1]",
        "[1, 0; 0, (x1 - w)^2*(x1 + 9)]",
        "p = recip(exp(sqr(x1 - w)) - 1); [1, 0; 0, 1 + 0*p]",
        "[1, 0; 0, tanh(x1 - w)]",
    ];
    let mut random = Random(seed(92));
    let mut seen = 0;
    for number in 0..cases(120) as usize {
        // The knot of the curve may lie on the wall, or near it.
        let w = [0.0, 0.25, random.between(-0.9, 0.9)][number % 3];
        let t = 10.0_f64.powf(random.between(-14.0, -1.0));
        let text = walls[number % walls.len()];
        let x = [w, w - t, w + t, random.between(-1.0, 1.0)][(random.unit() * 4.0) as usize];
        let parameters = [("w", w), ("t", t)];
        if text.contains(", 0, 0;") {
            let metric = Formula::<3>::parse(text, &parameters).expect("a formula");
            let curve = vec![vector![-1.0, 0.0, 0.0], vector![x, 0.1, 0.0], vector![1.0, 0.0, 0.0]];
            let certificate = with_curve(metric, [-1.0, 1.0].map(|x| point([x, 0.0, 0.0])), curve);
            let checked = checked("wall", number, &certificate);
            assert!(matches!(checked, Err(CheckError::CurveDomain { .. })), "{checked:?} {text}");
        } else {
            let metric = Formula::<2>::parse(text, &parameters).expect("a formula");
            let curve = between(-1.0, [[x, 0.1]], 1.0);
            let certificate = with_curve(metric, [-1.0, 1.0].map(|x| point([x, 0.0])), curve);
            let checked = checked("wall", number, &certificate);
            assert!(matches!(checked, Err(CheckError::CurveDomain { .. })), "{checked:?} {text}");
        }
        seen += 1;
    }
    assert!(seen > 60);
}

/// The second derivative of a table, in `H = 1 + s T″(x₁)`, is linear in each cell, and its slope jumps
/// at knots. A curve that ends at a knot, or turns there, or crosses one within a chord, has the length
/// `∫ √H`; and none is accepted where `H` is negative.
#[test]
fn curves_over_the_cells_of_a_table_are_as_long_as_they_are() {
    let mut random = Random(seed(93));
    let (mut accepted, mut refused) = (0, 0);
    for number in 0..cases(120) as usize {
        let c: Vec<f64> = (0..6).map(|_| random.between(-1.0, 1.0)).collect();
        let spline = Spline::new(&[6], c).expect("finite");
        let s = random.between(0.05, 1.5);
        let h = |x: f64| 1.0 + s * spline.value(&[x], [2, 0, 0]);
        let table: [(&str, Arc<dyn Table>); 1] = [("t", Arc::new(spline.clone()))];
        let metric = Formula::<1>::parse_with("[1 + s*t_2(x1)]", &[("s", s)], &table);
        let metric = metric.expect("a formula");
        let knot = |random: &mut Random| (random.unit() * 5.0).floor();
        let mut ends = [knot(&mut random), knot(&mut random)];
        if number % 3 == 0 {
            ends[0] += random.unit();
        }
        if number % 3 == 1 {
            // Beside a knot by a rounding.
            ends[1] = if random.unit() < 0.5 { ends[1].next_up() } else { ends[1].next_down() };
        }
        let chords = [1, 3, 10][(random.unit() * 3.0) as usize];
        let curve: Vec<_> = (0..=chords)
            .map(|n| vector![ends[0] + (ends[1] - ends[0]) * f64::from(n) / f64::from(chords)])
            .collect();
        let sets = [curve[0][0], curve[chords as usize][0]].map(|x| point([x]));
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let exact = integral(|x| h(x).max(0.0).sqrt(), [from, to]);
        let lowest = (0..=400).map(|n| h(from + (to - from) * f64::from(n) / 400.0));
        let lowest = lowest.fold(f64::INFINITY, f64::min);
        let certificate = with_curve(metric, sets, curve);
        match checked("knots", number, &certificate) {
            Ok(upper) => {
                assert!(lowest > -1e-9, "{lowest} {certificate}");
                // The midpoint rule errs by its step squared times the variation.
                assert!(upper >= exact * (1.0 - 1e-5), "{upper} {exact} {certificate}");
                assert!(upper <= exact * 1.003 + 1e-12, "{upper} {exact} {certificate}");
                accepted += 1;
            }
            Err(error) => {
                assert!(matches!(error, CheckError::CurveDomain { .. }), "{error}");
                assert!(lowest < 0.01, "{lowest} {error} {certificate}");
                refused += 1;
            }
        }
    }
    assert!(accepted > 20 && refused > 20, "{accepted} {refused}");
}

/// Halves of a matrix that are written in two ways are refused, also if they are equal: one might be
/// undefined where the other is not. From the upper half alone, the same is proved.
#[test]
fn a_matrix_is_symmetric_by_its_steps() {
    let texts = [
        "[1, 0; 1/x1, 1]",
        "[1, 0; 0/x1, 1]",
        "[1, x1; x2, 1]",
        "[2, sqr(x1)*x2; x2*sqr(x1), 2]",
        "[2, 0; -0, 2]",
        "[2, 0.5*x1; x1/2, 2]",
    ];
    for (number, text) in texts.into_iter().enumerate() {
        let typed = formula::<2>(text);
        let curve = between(-0.5, [[-0.25, 0.125]], 0.75);
        let sets = [-0.5, 0.75].map(|x| point([x, 0.0]));
        let mut certificate = with_curve(typed.clone(), sets.clone(), curve.clone());
        let refused = checked("halves", number, &certificate);
        assert_eq!(refused, Err(CheckError::Halves { row: 0, column: 1 }), "{text}");
        certificate.formula = typed.of_upper_half();
        let upper = checked("half", number, &certificate).expect("a metric near the curve");
        // A proposer has to ask for both halves. Some are known to be equal.
        let of_both = length_above(&typed, sets.each_ref(), &curve);
        match number {
            3 | 4 => assert_eq!(of_both, Ok(upper), "{text}"),
            _ => assert_eq!(of_both, refused, "{text}"),
        }
    }
    let space = formula::<3>("[2, 0, 0; 0, 2, 0.1; 0, x1, 2]");
    let sets = [[0.0; 3], [1.0, 0.0, 0.0]].map(point);
    let certificate = with_curve(space, sets, vec![SVector::zeros(), vector![1.0, 0.0, 0.0]]);
    assert_eq!(checked("halves", 9, &certificate), Err(CheckError::Halves { row: 1, column: 2 }));
}

/// A curve of one point has the length 0, if there is a metric at that point.
#[test]
fn a_curve_of_one_point_lies_in_the_domain() {
    let sets = |x: f64| {
        let wall = HalfSpace::at_least([1.0, 0.0], x).expect("a normal");
        [point([x, 0.0]), Shape::HalfSpace(wall)]
    };
    let metric = "b = exp(-50*(x1^2 + x2^2)); [1 - 0.9*b, 0; 0, 1 - 3*b]";
    let number = std::cell::Cell::new(0);
    let at = |text: &str, x: f64, count: usize| {
        number.set(number.get() + 1);
        let curve = vec![vector![x, 0.0]; count];
        checked("spot", number.get(), &with_curve(formula(text), sets(x), curve))
    };
    for count in [1, 2, 3] {
        let refused = Err(CheckError::CurveDomain { chord: 0 });
        // The chain says that there is a contradiction only if it proves more than 0.
        assert_eq!(at(metric, 0.5, count), Ok(0.0));
        assert_eq!(at(metric, 0.125, count), refused);
        assert_eq!(at("[1, 0; 0, sqr(x1 - 0.125)]", 0.125, count), refused);
        assert_eq!(at("p = 0/(x1 - 0.125); [1, p; p, 1]", 0.125, count), refused);
    }
}

/// Ends on the boundary of a set, and one unit in the last place outside.
#[test]
fn curves_end_in_their_sets_and_nowhere_else() {
    let mut random = Random(seed(94));
    let (mut accepted, mut refused) = (0, 0);
    for number in 0..cases(60) as usize {
        let r = random.between(0.05, 0.5);
        let ball = Shape::Ball(Ball::new([0.0, 0.0], r).expect("finite"));
        let n = random.between(0.5, 2.0);
        let x = random.between(1.0, 2.0);
        let offset = n * x;
        let wall = Shape::HalfSpace(HalfSpace::at_least([n, 0.0], offset).expect("a normal"));
        let beside = |x: f64, random: &mut Random| {
            [x, x.next_up(), x.next_down()][(random.unit() * 3.0) as usize]
        };
        let (first, last) = (beside(r, &mut random), beside(x, &mut random));
        // A product of doubles is exact in a fused operation, up to its last rounding.
        let is_end = n.mul_add(last, -offset) >= 0.0;
        let is_start = first <= r;
        let curve = vec![vector![first, 0.0], vector![last, 0.0]];
        let certificate = with_curve(formula("1 I"), [ball, wall], curve);
        let checked = checked("ends", number, &certificate);
        match (is_start, is_end) {
            (true, true) => assert!(checked.is_ok(), "{checked:?} {certificate}"),
            (false, _) => assert_eq!(checked, Err(CheckError::CurveEnd { end: "first" })),
            (true, false) => assert_eq!(checked, Err(CheckError::CurveEnd { end: "last" })),
        }
        accepted += usize::from(checked.is_ok());
        refused += usize::from(checked.is_err());
    }
    assert!(accepted > 10 && refused > 10, "{accepted} {refused}");
}

/// Rounding does not lead a part of a chord beyond its end: there the root would be undefined.
#[test]
fn a_curve_may_end_where_the_domain_ends() {
    let metric = || formula::<1>("[1 + sqrt(1 - x1)]");
    // ∫ √(1 + √t) dt from 0
    let primitive = |t: f64| {
        let y = 1.0 + t.sqrt();
        2.0 * (0.4 * y.powf(2.5) - y.powf(1.5) / 1.5) + 8.0 / 15.0
    };
    for number in 0..20 {
        let x = 0.05 * f64::from(number) + 1e-3;
        let curve = vec![vector![x], vector![1.0]];
        let sets = [point([x]), point([1.0])];
        let upper = checked("root", number as usize, &with_curve(metric(), sets, curve));
        let exact = primitive(1.0 - x);
        let is_bound = |upper: f64| upper >= exact * (1.0 - 1e-12) && upper <= exact * 1.003;
        assert!(upper.as_ref().is_ok_and(|&upper| is_bound(upper)), "{x}: {upper:?} {exact}");
    }
    // One unit in the last place farther there is none.
    let far = 1.0_f64.next_up();
    let certificate =
        with_curve(metric(), [point([0.5]), point([far])], vec![vector![0.5], vector![far]]);
    let checked = checked("root", 20, &certificate);
    assert_eq!(checked, Err(CheckError::CurveDomain { chord: 0 }));
}

/// Intervals do not see that `x₁ − x₁` is 0, so that no part is known to lie in one cell, and `T″` has a
/// peak at the knot 2: what counts on each part is the greatest speed there.
#[test]
fn without_a_second_derivative_the_greatest_speed_counts() {
    let spline = Spline::new(&[4], vec![0.0, 1.0, 0.0, 1.0]).expect("finite");
    assert_eq!(spline.value(&[2.0], [2, 0, 0]), 2.0);
    let table: [(&str, Arc<dyn Table>); 1] = [("t", Arc::new(spline))];
    let metric = Formula::<1>::parse_with("[1 + 0.4*t_2(2 + (x1 - x1))]", &[], &table);
    let metric = metric.expect("a formula");
    let exact = 1.8_f64.sqrt();
    let curve = vec![vector![0.0], vector![1.0]];
    let certificate = with_curve(metric, [0.0, 1.0].map(|x| point([x])), curve);
    let upper = checked("peak", 0, &certificate).expect("a metric everywhere");
    assert!(upper >= exact * (1.0 - 1e-15) && upper <= exact * 1.001, "{upper} {exact}");
}
