//! A cost that is a table: distances, constants, proofs and certificates.

use std::sync::Arc;

use tautline::{
    CertifiedConstants, Domain, Ends, Formula, Problem, Rule, SVector, Spline, Table,
    certify::Accuracy, check::AnyCertificate,
};

/// A wall across the plane, with a step behind it.
const WALL: [f64; 8] = [1.0, 1.0, 1.0, 4.0, 2.0, 2.0, 3.0, 2.0];

fn wall() -> Arc<dyn Table> {
    Arc::new(Spline::new(&[8], WALL.to_vec()).expect("eight numbers"))
}

fn formula<const D: usize>() -> Formula<D> {
    Formula::parse_with("cost(wall(x1))", &[], &[("wall", wall())]).expect("a formula")
}

/// Returns `∫ f` from 0 to 7 for the spline `f`: a curve crosses all values of `x₁`, and straight ahead
/// is the shortest. Over a cell a B-spline has the integrals `(1, 11, 11, 1)/24`.
fn exact() -> f64 {
    let c = |i: i32| WALL[i.clamp(0, 7) as usize];
    (0..7).map(|i| (c(i - 1) + 11.0 * c(i) + 11.0 * c(i + 1) + c(i + 2)) / 24.0).sum()
}

fn bits<const D: usize>(found: &tautline::distance::Found<D>) -> [u64; 2] {
    [found.proved.lower.to_bits(), found.proved.upper.unwrap_or(0.0).to_bits()]
}

#[test]
fn the_distance_over_a_table_is_the_integral_of_the_spline() {
    let ends = Ends::points([0.0, 0.5], [7.0, 0.5]).expect("finite");
    let line = Problem::new(formula::<2>(), ends).solve(Rule::TRAPEZOIDAL, 448).expect("solved");
    // The midpoint rule with 64 chords a cell is off by |f″|/24 · 64⁻² in each of 7 cells, where
    // |f″| ≤ |1 − 2·4 + 2| = 5. Twice that, since the chords are not equally long.
    let (found, error) = (line.length().value, 10.0 / 24.0 / 64_f64.powi(2) * 7.0);
    assert!((found - exact()).abs() < 1e-12 * exact(), "{found} {}", exact());
    let discrete = line.discrete_energy().sqrt();
    assert!((discrete - exact()).abs() < error && discrete != found, "{discrete} {}", exact());
    // Nothing is assumed: rigorous bounds from constants that are proved.
    let proof = line.prove(Accuracy::default()).expect("proved");
    let enclosure = proof.enclosure;
    assert!(enclosure.lower <= exact().powi(2) && exact().powi(2) <= enclosure.upper);
    assert!(enclosure.upper - exact().powi(2) <= 1e-9 * enclosure.upper, "{enclosure:?}");
}

#[test]
fn constants_of_a_table_hold_on_all_of_space() {
    let formula = formula::<2>();
    let space = Domain::space(&formula);
    assert!(space.is_all_of_space());
    let proved = CertifiedConstants::within_budget(&formula, &space, Accuracy::default());
    let constants = proved.expect("proved").constants().expect("constants");
    let wall = wall();
    let at = |u: f64, order: u8| wall.value(&[u], [order, 0, 0]);
    let sampled = |of: &dyn Fn(f64) -> f64| {
        (-300..1000).map(|n| of(f64::from(n) / 100.0)).fold(f64::NEG_INFINITY, f64::max)
    };
    let (most, least) = (sampled(&|u| at(u, 0).powi(2)), -sampled(&|u| -at(u, 0).powi(2)));
    let slope = sampled(&|u| (2.0 * at(u, 0) * at(u, 1)).abs());
    for (proved, sampled) in [(constants.c2(), most), (constants.l_h(), slope)] {
        // The samples miss the extremes by a square of their distance, and the proof by a thousandth.
        assert!(sampled <= proved && proved <= sampled * 1.002, "{proved} {sampled}");
    }
    let c1 = constants.c1();
    // The samples are rounded.
    assert!(c1 <= least * (1.0 + 1e-14) && least <= c1 * 1.002, "{c1} {least}");
}

/// From point to point, and once more from the text.
#[test]
fn a_certificate_over_a_table_is_checked_from_its_text() {
    let ends = Ends::points([0.0, 0.5], [7.0, 0.5]).expect("finite");
    let line = Problem::new(formula::<2>(), ends).solve(Rule::TRAPEZOIDAL, 448).expect("solved");
    let found = line.certificate(2e-2).expect("found");
    let [lower, upper] = [found.proved.lower, found.proved.upper.expect("a curve")];
    assert!(lower <= exact() && exact() <= upper && upper - lower <= 2e-2 * upper);
    let text = found.certificate.to_string();
    assert!(text.starts_with("tautline-distance 1\ndimension 2\ntable 8\n3ff0000000000000 "));
    let AnyCertificate::Plane(read) = AnyCertificate::read(&text).expect("read") else {
        panic!("in the plane")
    };
    assert!(read == found.certificate);
    let checked = read.check().expect("checked");
    assert_eq!([checked.lower.to_bits(), checked.upper.unwrap_or(0.0).to_bits()], bits(&found));
    // The statement tells tables apart by a hash.
    let statement = read.statement();
    assert!(statement.contains("\ntable 8 sha256 ") && !statement.contains("3ff"), "{statement}");

    // Another number in the table is another metric, or no certificate.
    let higher = text.replacen("4010000000000000", "4010000000000001", 1);
    let AnyCertificate::Plane(other) = AnyCertificate::read(&higher).expect("read") else {
        panic!("in the plane")
    };
    assert_ne!(other.statement(), statement);
    for (wrong, place) in [
        (text.replacen("table 8", "table 7", 1), "a row of a table"),
        (text.replacen("table 8", "table 2 4", 1), "a row of a table"),
        (text.replacen("table 8", "table", 1), "table with one to three lengths"),
        (text.replacen("3ff0000000000000", "7ff0000000000000", 1), "finite numbers"),
        (
            text.replacen("table 8\n", "table 1\n3ff0000000000000\ntable 8\n", 1),
            "a line of a formula",
        ),
        (text.replacen("table1(", "table1_3(", 1), "a line of a formula"),
        (text.replacen("table1(", "table2(", 1), "a line of a formula"),
    ] {
        let error = AnyCertificate::read(&wrong).map(|_| ()).expect_err("refused").to_string();
        assert!(error.contains(place), "{place}: {error}");
    }
}

/// Taylor's formula along an oblique chord needs the mixed derivatives along all axes.
#[test]
fn proved_lengths_over_tables_are_those_of_the_quadrature() {
    let numbers = |count: i32| (0..count).map(|n| f64::from(2 + n * n % 5)).collect();
    let plane: Arc<dyn Table> = Arc::new(Spline::new(&[4, 5], numbers(20)).expect("a shape"));
    let space: Arc<dyn Table> = Arc::new(Spline::new(&[3, 4, 3], numbers(36)).expect("a shape"));
    let tables = [("p", plane), ("s", space)];
    for text in ["cost(p(x1, x2))", "cost(s(x1, x2, x1 + 0.5*x2))"] {
        let formula = Formula::<2>::parse_with(text, &[], &tables).expect("a formula");
        let ends = Ends::points([-0.5, 0.25], [2.5, 3.0]).expect("finite");
        let line = Problem::new(formula, ends).solve(Rule::TRAPEZOIDAL, 16).expect("solved");
        let proved = line.admissible_curve().expect("a curve").length();
        let found = line.length();
        let slack = found.error + 1e-10 * found.value;
        assert!(
            proved.lo() <= found.value + found.error && found.value <= proved.hi() + found.error
        );
        assert!(proved.hi() - proved.lo() <= slack, "{text}: {proved:?} {found:?}");
    }
}

/// The lifted formula sees what lies beyond the array: along the border the cost goes on.
#[test]
fn a_way_round_the_end_of_a_table_is_found() {
    let hill = Spline::new(&[3, 3], vec![1.0, 1.0, 1.0, 1.0, 9.0, 1.0, 1.0, 1.0, 1.0]);
    let hill: Arc<dyn Table> = Arc::new(hill.expect("nine numbers"));
    let formula = Formula::<2>::parse_with("cost(hill(x1, x2))", &[], &[("hill", hill)]);
    let ends = Ends::points([-1.0, 1.0], [3.0, 1.125]).expect("finite");
    let line = Problem::new(formula.expect("a formula"), ends).solve(Rule::TRAPEZOIDAL, 128);
    let line = line.expect("solved");
    let middle: SVector<f64, 2> = line.curve().at(0.5);
    // Over the top it would cost 4 + 8 (2/3) on the line x₂ = 1; around it, where the cost is 1, it is
    // a little longer than straight.
    let round = line.length().value;
    assert!(
        round > 4.0 && round < 4.0 + 8.0 * 2.0 / 3.0 && (middle[1] - 1.0).abs() > 0.5,
        "{round}"
    );
    let found = line.certificate(5e-2).expect("found");
    assert!(found.proved.lower <= round && found.proved.lower > 0.95 * round);
}
