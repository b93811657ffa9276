//! Searches for tight cases that are known.

use std::cell::RefCell;

use tautline_statements::{Evidence, Statement, Unit, VerifyError, prop_7_8};

use super::{
    super::{Beyond, End, Parameter},
    AdversaryError, Family, GAIN, Search, Source, Tightest,
};

/// Returns a family with these overestimations.
fn family<'a, const P: usize>(
    parameters: [Parameter; P],
    overestimation: impl Fn([f64; P]) -> f64 + 'a,
) -> Family<'a> {
    Family::new("test", Statement::Proposition7_8, parameters, move |values| {
        let numbers = [1.0, overestimation(values)];
        let evidence = Evidence::of(Statement::Proposition7_8);
        Ok(Some(evidence.stated("1 ≤ overestimation", Unit::NONE, numbers, 0.0)))
    })
}

fn unit_square() -> [Parameter; 2] {
    ["x", "y"].map(|name| Parameter::linear(name, 0.0, 1.0))
}

fn tightest(family: &Family<'_>) -> Tightest {
    Search::default().tightest(family, Source::Stated).expect("true").expect("told")
}

/// For `1, x, y`, `Σ xₙ³ ≤ (Σ xₙ²)^{3/2}` has the overestimation 1 at `x = y = 0`.
#[test]
fn the_corner_of_equality_is_found() {
    let parameters = ["x", "y"].map(|name| Parameter::linear(name, 0.0, 3.0));
    let cubes = Family::new("cubes", Statement::Proposition7_8, parameters, |[x, y]| {
        Ok(Some(prop_7_8(&[1.0, x, y])))
    });
    let found = tightest(&cubes);
    assert!(found.overestimation <= 1.000_001, "{found:?}");
    assert_eq!(found.overestimation, found.evidence.overestimation());
    assert_eq!(found.conclusion.claim, "Σ xₙ³ ≤ (Σ xₙ²)^{3/2}");
    assert_eq!(found.parameter("y"), Some(found.parameters[1].1));
    assert!(found.told == found.evaluations && found.parameter("z").is_none());
}

/// The budget may end while one parameter moves or while all of them do.
#[test]
fn an_ascent_keeps_to_its_budget_and_returns_the_tightest_of_all_cases() {
    for climbs in 0..60 {
        let seen = RefCell::new(Vec::new());
        let bowl = family(unit_square(), |[x, y]| {
            let overestimation = 1.0 + (x - 0.6).powi(2) + (y - 0.3).powi(2);
            seen.borrow_mut().push(overestimation);
            overestimation
        });
        let search = Search { seed: 5, restarts: 1, samples: 3, climbs };
        let found = search.tightest(&bowl, Source::Stated).expect("true").expect("told");
        let seen = seen.borrow();
        assert!(found.edges.is_empty() && found.evaluations == seen.len());
        assert!(seen.len() <= 3 + climbs, "{} for {climbs}", seen.len());
        let least = |seen: &f64| found.overestimation <= seen * (1.0 + GAIN);
        assert!(seen.iter().all(least), "{climbs}");
    }
}

/// The overestimation `1 + |x − y| + (y − 0.7)²` has an edge along the diagonal.
#[test]
fn a_narrow_minimum_inside_is_found() {
    let edge = family(unit_square(), |[x, y]| 1.0 + (x - y).abs() + (y - 0.7).powi(2));
    assert!(tightest(&edge).overestimation <= 1.01);
}

/// On `[10⁻³, 1]`, the overestimation `2 (1 + s x)` has about `10⁻³ s` of its value left on the
/// way to 0.
#[test]
fn a_case_at_an_edge_says_what_is_left_beyond_it() {
    let side = || Parameter::logarithmic("x", 1e-3, 1.0);
    let limit = side().with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
    let linear = Parameter::linear("x", 0.0, 1.0)
        .with_ends(Beyond::Limit("x → 0"), Beyond::Nothing("x ≤ 1"));
    let cases = [(limit, 1.0), (limit, 100.0), (side(), 1.0), (limit, -0.5), (linear, 1.0)];
    let [near, far, open, other, unmoved] = cases.map(|(side, s)| {
        let edges = tightest(&family([side], |[x]| 2.0 * (1.0 + s * x))).edges;
        let [edge] = edges.as_slice() else { panic!("{edges:?}") };
        *edge
    });
    // (1 + 2·10⁻³ s)/(1 + 10⁻³ s) − 1. The case may lie a few last steps before the edge.
    assert!((near.left - 1e-3 / 1.001).abs() <= 1e-5 && !near.is_cut_off(), "{near:?}");
    assert!((far.left - 0.1 / 1.1).abs() <= 1e-3 && far.is_cut_off(), "{far:?}");
    assert!(open.is_cut_off() && open.beyond.is_none(), "{open:?}");
    assert_eq!((other.parameter, other.end), ("x", End::Most));
    // Half of 0 is 0, so nothing is measured.
    assert!(unmoved.left.is_nan() && unmoved.is_cut_off(), "{unmoved:?}");
    assert!(!other.is_cut_off(), "{other:?}");
    let inside = family([side()], |[x]| 1.0 + (x / 0.03).ln().powi(2));
    assert_eq!(tightest(&inside).edges, []);
}

#[test]
fn a_violated_conclusion_is_an_error() {
    let side = [Parameter::linear("x", 0.0, 1.0)];
    // The sharper companion fails only for x > ½, and the search minimises the paper's.
    let wrong = Family::new("wrong", Statement::Proposition7_8, side, |[x]| {
        let evidence = Evidence::of(Statement::Proposition7_8);
        let evidence = evidence.stated("x ≤ 2", Unit::NONE, [x, 2.0], 0.0);
        Ok(Some(evidence.sharper("x ≤ ½", Unit::NONE, [x, 0.5], 0.0)))
    });
    let found = Search::default().tightest(&wrong, Source::Stated);
    let Err(AdversaryError::Violated { family: "wrong", parameters, conclusion, .. }) = found
    else {
        panic!("{found:?}");
    };
    assert!(parameters[0].1 > 0.5 && conclusion.starts_with("x ≤ ½"));
}

#[test]
fn cases_without_evidence_are_skipped_and_other_errors_are_not() {
    let side = [Parameter::linear("x", 0.0, 1.0)];
    let none = Family::new("none", Statement::Proposition7_8, side, |[x]| {
        Ok((x < 0.5).then(|| prop_7_8(&[-1.0, x])))
    });
    assert_eq!(Search::default().tightest(&none, Source::Stated), Ok(None));
    let (name, low, high) = ("x", 2.0, 3.0);
    let error = Family::new("error", Statement::Proposition7_8, side, |[value]| {
        Err(VerifyError::OutOfRange { name, value, low, high })
    });
    let found = Search::default().tightest(&error, Source::Stated);
    assert!(matches!(found, Err(AdversaryError::Evaluation { .. })), "{found:?}");
}
