//! Small files that ask for much work are refused soon.

use std::time::Instant;

use tautline_check::{AnyCertificate, Certificate, CheckError, Region};
use tautline_sets::Shape;

use crate::helpers::{formula, level, point};

/// Returns the text of a certificate whose formula has so many steps. That `c₁` is proved needs more
/// boxes than there may be.
pub(crate) fn long_tubes(steps: usize) -> String {
    let mut text =
        format!("tautline-distance 1\ndimension 1\nmetric {}\ns1 = sin(x1);\n", steps + 2);
    for step in 2..=steps {
        text += &format!("s{step} = sin(s{});\n", step - 1);
    }
    let bits = |x: f64| format!("{:016x}", x.to_bits());
    text += &format!("s{} = s{steps} + 1.0;\n[s{0}]\n", steps + 1);
    text += &format!("from point {0}\nto point {1}\nhi {1}\n", bits(0.0), bits(1.0));
    text += &format!("region tubes {} {}\n", bits(2.0), bits(1.0));
    text + &format!("level 0 1 3\n0 1\n{0} {0}\n{0} {0}\n{0} {0}\nend\n", bits(0.0))
}

/// The most seconds that a file may take: some minutes for each megabyte. Tests share the processor with
/// others, so these are many.
fn most(text: &str) -> f64 {
    10.0 + 3600.0 * text.len() as f64 / 1e6
}

/// Returns why a text is refused, after asserting that this did not take long.
fn soon(text: &str) -> CheckError {
    let begun = Instant::now();
    let checked = AnyCertificate::read(text).and_then(|certificate| certificate.check());
    let seconds = begun.elapsed().as_secs_f64();
    assert!(seconds < most(text), "{seconds} s, {} bytes", text.len());
    checked.expect_err("refused")
}

#[test]
fn a_long_formula_on_many_boxes_is_refused_soon() {
    let refused = soon(&long_tubes(300));
    assert!(matches!(refused, CheckError::Work { .. }), "{refused}");
}

/// Every chord is halved as often as it may be, since the metric oscillates.
#[test]
fn a_curve_that_is_halved_everywhere_is_refused_soon() {
    let metric = formula::<1>("(2 + sin(1e9*x1)) I");
    let points: Vec<_> = (0..300).map(|k| [f64::from(k) * 1e3].into()).collect();
    let region = Region::Declared { c1: 1.0 };
    let sets = [point([0.0]), point([299e3])];
    let cubes = tautline_check::Cubes::new(0, vec![[0]]).expect("in range");
    let levels = vec![level(0, &cubes, [&|_| 0.0, &|_| 0.0])];
    let hi = 1e7;
    let certificate =
        Certificate { formula: metric, sets, hi, region, curve: Some(points), levels };
    let refused = soon(&certificate.to_string());
    assert!(matches!(refused, CheckError::Work { .. }), "{refused}");
}

/// Millions of cubes are required, and for each of them all pieces would have to be looked at.
#[test]
fn many_pieces_and_a_wide_region_are_refused_soon() {
    let many = (0..3000).map(|k| point([f64::from(k) * 1e-3, 0.0])).collect();
    let sets = [Shape::Union(many), point([600.0, 0.0])];
    let cubes = tautline_check::Cubes::new(-2, vec![[0, 0]]).expect("in range");
    let levels = vec![level(0, &cubes, [&|_| 0.0, &|_| 0.0])];
    let region = Region::Declared { c1: 1.0 };
    let formula = formula("1 I");
    let certificate = Certificate { formula, sets, hi: 700.0, region, curve: None, levels };
    let refused = soon(&certificate.to_string());
    assert!(matches!(refused, CheckError::TooLarge { .. }), "{refused}");
}

/// Curves shorter than `hi`, a little less than the distance, are in no cube of the level's side, but in more
/// and more cubes of smaller and smaller sides.
#[test]
fn a_search_for_required_cubes_that_finds_none_ends() {
    let sets = [point([0.0, 0.0]), point([1.0, 0.75])];
    let cubes = tautline_check::Cubes::new(-25, vec![[0, 0]]).expect("in range");
    let levels = vec![level(0, &cubes, [&|_| 0.0, &|_| 0.0])];
    let region = Region::Declared { c1: 1.0 };
    let hi = 1.25 * (1.0 - 0.5_f64.powi(24));
    let certificate =
        Certificate { formula: formula("1 I"), sets, hi, region, curve: None, levels };
    let refused = soon(&certificate.to_string());
    assert!(matches!(refused, CheckError::Work { .. }), "{refused}");
}

/// Between ends that are farther apart than `hi` no cube is required, but large cubes meet both: there may be
/// more of those than the level has.
#[test]
fn more_large_cubes_may_be_looked_at_than_the_level_has() {
    let comb = |shift: f64| {
        Shape::Union((0..100).map(|k| point([10.0 * f64::from(k) + shift, 0.0])).collect())
    };
    let sets = [comb(0.0), comb(3.0)];
    let cubes = tautline_check::Cubes::new(-3, vec![[56, 0]]).expect("in range");
    let levels = vec![level(0, &cubes, [&|_| 0.0, &|_| 0.0])];
    let region = Region::Declared { c1: 1.0 };
    let certificate =
        Certificate { formula: formula("1 I"), sets, hi: 2.0, region, curve: None, levels };
    assert_eq!(certificate.check().map(|proved| proved.lower), Ok(2.0));
}

/// All pieces meet all cubes.
#[test]
fn pieces_that_meet_all_cubes_cost_their_work() {
    let ball = |k: i32| {
        let centre = [f64::from(k) * 1e-3, 0.0];
        Shape::Ball(tautline_sets::Ball::new(centre, 40.0).expect("a ball"))
    };
    let sets = [point([0.5, 0.5]), Shape::Union((0..1500).map(ball).collect())];
    let places = (-12..12).flat_map(|i| (-12..12).map(move |j| [i, j])).collect();
    let cubes = tautline_check::Cubes::new(0, places).expect("in range");
    let levels = vec![level(0, &cubes, [&|_| 0.0, &|_| 0.0])];
    let formula = formula("1 I");
    let region = Region::ExitOne;
    let certificate = Certificate { formula, sets, hi: 1.0, region, curve: None, levels };
    let begun = Instant::now();
    let checked = certificate.check();
    let seconds = begun.elapsed().as_secs_f64();
    assert!(seconds < most(&certificate.to_string()), "{seconds} {checked:?}");
}

/// What a count in the file says is not taken for memory.
#[test]
fn counts_without_what_they_count_are_refused() {
    let good = long_tubes(2);
    let huge = usize::MAX.to_string();
    for (old, new) in [
        ("metric 4".to_owned(), format!("metric {huge}")),
        ("level 0 1 3".to_owned(), format!("level 0 {huge} 3")),
        ("level 0 1 3".to_owned(), format!("level 0 1 {huge}")),
        ("0 1\n".to_owned(), "0 2147483647\n".to_owned()),
        ("metric 4".to_owned(), format!("table {huge} {huge}\nmetric 4")),
        ("metric 4".to_owned(), format!("table {huge}\nmetric 4")),
        ("level".to_owned(), format!("curve {huge}\nlevel")),
    ] {
        let text = good.replacen(&old, &new, 1);
        assert_ne!(text, good);
        let refused = soon(&text);
        assert!(matches!(refused, CheckError::Line { .. }), "{new}: {refused}");
    }
    // Lines without anything in them are no nodes.
    let text = good.replace("level 0 1 3\n0 1\n", "level 0 1 900000\n0 899000\n");
    let refused = soon(&(text + &"\n".repeat(1_000_000)));
    assert!(matches!(refused, CheckError::Line { expected: "no more nodes than lines", .. }));
    let tables = "table 1\n3ff0000000000000\n".repeat(2000);
    let refused = soon(&good.replacen("metric", &format!("{tables}metric"), 1));
    assert!(matches!(refused, CheckError::Line { expected: "at most 1024 tables", .. }));
}

/// No line of a formula is read by going deeper and deeper.
#[test]
fn formulas_of_many_brackets_are_refused() {
    let good = long_tubes(2);
    for (open, close) in [("(", ")"), ("-", ""), ("sin(", ")")] {
        let deep = format!("{}x1{}", open.repeat(200_000), close.repeat(200_000));
        let refused = soon(&good.replacen("sin(x1)", &deep, 1));
        assert!(matches!(refused, CheckError::Line { .. }), "{refused}");
    }
}
