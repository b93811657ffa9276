//! Checks what the adversary finds in the families of the project.

use tautline_checks::adversary::{AdversaryError, Search, Tightest, families};
use tautline_statements::{LIBRARY, Mutant, Source, Subject};

/// Returns the tightest case that a search finds in a family of a statement.
#[track_caller]
fn tightest(
    search: Search,
    subject: &Subject,
    [number, name]: [&str; 2],
    source: Source,
) -> Result<Option<Tightest>, AdversaryError> {
    let families = families(subject);
    let family = families.iter().find(|family| family.is(number, name)).expect("listed");
    search.tightest(family, source)
}

/// Returns the smallest overestimation that the search finds; `∞` if nothing was observed.
#[track_caller]
fn overestimation(family: [&str; 2], source: Source) -> f64 {
    let found = tightest(Search::default(), &LIBRARY, family, source).expect("no violation");
    found.map_or(f64::INFINITY, |found| found.overestimation)
}

/// Asserts that the search finds an overestimation that is not below the infimum of the family and
/// at most one percent above it.
#[track_caller]
fn assert_found(number: &str, name: &str, source: Source, least: f64) {
    let found = overestimation([number, name], source);
    assert!(least - 1e-9 <= found && found <= 1.01 * least, "{number} on {name}: {found}");
}

#[test]
fn equality_in_props_7_9_8_1_and_8_2_is_found() {
    for source in [Source::Stated, Source::Sharper] {
        assert_found("Proposition 7.9", "tent", source, 1.0);
        assert_found("Proposition 8.1", "incline", source, 1.0);
        assert_found("Proposition 8.2", "incline", source, 1.0);
    }
}

/// Where a wave is steepest, the norm of the whole matrix `∂ₗH` is `L_H`.
#[test]
fn equality_in_prop_7_10_is_found() {
    for name in ["shear", "valleys"] {
        assert_found("Proposition 7.10", name, Source::Sharper, 1.0);
    }
}

/// In dimension 1, as `δ = L_H d / c₁^{3/2} → 0`, the bound `C = C_tra♯ + …` tends to
/// `d² (δ + 6δ + δ/4)`, while the gap of a tent is `d² δ/4`. The overestimation therefore tends to
/// 29.
#[test]
fn theorem_1_1_on_tents_tends_to_29() {
    assert_found("Theorem 1.1", "tent", Source::Stated, 29.0);
}

/// On two routes both gaps add up to `d² δ/2` for the trapezoidal rule and to `d² δ` for the left
/// rule. As `δ → 0`, the overestimation tends to 14½ and 8 for the paper's bounds, and to 1 for the
/// bounds of order `1/N`.
#[test]
fn theorems_1_2_and_1_4_on_two_routes_come_near_the_bounds_of_first_order() {
    assert_found("Theorem 1.2", "two routes", Source::Stated, 14.5);
    assert_found("Theorem 1.4", "two routes", Source::Stated, 8.0);
    assert_found("Theorem 1.2", "two routes", Source::Sharper, 1.0);
    assert_found("Theorem 1.4", "two routes", Source::Sharper, 1.0);
}

#[test]
fn equality_in_lemma_s_2_is_found() {
    for name in ["tent", "incline", "separable, D = 1", "valleys"] {
        assert_found("Lemma S.2", name, Source::Stated, 1.0);
    }
}

/// Equality is approached on a ridge and down an incline as `δ → 0`, and about a crest as `μ → 0`.
#[test]
fn equality_in_lemma_s_4_is_found() {
    for name in ["two routes", "two routes, left", "separable, D = 1, left", "two arcs"] {
        assert_found("Lemma S.4", name, Source::Stated, 1.0);
    }
}

/// Equality is approached on two routes for both rules as `δ → 0`, and on two arcs as `μ → 0`.
#[test]
fn theorems_a_to_d_are_attained() {
    for theorem in ["Theorem A", "Theorem C"] {
        for name in ["two routes", "two routes, left"] {
            assert_found(theorem, name, Source::Stated, 1.0);
        }
    }
    for theorem in ["Theorem B", "Theorem D"] {
        assert_found(theorem, "two arcs", Source::Stated, 1.0);
    }
}

/// The tightest cases of these families are at `a → 0` and at `N = 1`. The ranges end there for a
/// reason, so the search is not cut off.
#[test]
fn a_search_that_ends_at_an_edge_is_not_cut_off() {
    let mut edges = 0;
    for family in [
        ["Theorem 1.1", "tent"],
        ["Theorem 1.3", "incline"],
        ["Theorem B", "two arcs"],
        ["Proposition 7.9", "ramp"],
        ["Proposition 7.11", "anisotropy"],
    ] {
        let found = tightest(Search::default(), &LIBRARY, family, Source::Stated);
        for edge in found.expect("no violation").expect("an overestimation").edges {
            assert!(!edge.is_cut_off(), "{family:?}: {edge}");
            edges += 1;
        }
    }
    assert!(edges > 0);
}

/// In dimension 1 a single chord between two points has length `d`, so no gap is observed.
#[test]
fn the_length_of_one_chord_on_the_line_has_no_overestimation() {
    assert_eq!(overestimation(["Theorem 1.2", "tent"], Source::Stated), f64::INFINITY);
}

#[test]
fn the_same_search_finds_the_same_case() {
    let search = Search { restarts: 1, samples: 20, climbs: 40, ..Search::default() };
    let [first, second, other] = [search, search, Search { seed: 7, ..search }].map(|search| {
        let found = tightest(search, &LIBRARY, ["Theorem 1.2", "shear"], Source::Sharper);
        found.expect("no violation").expect("an overestimation")
    });
    assert_eq!(first, second);
    assert_ne!(first.parameters, other.parameters);
}

/// The mutant has a quarter instead of a half in Proposition 8.2, whose bound is attained by an
/// incline.
#[test]
fn a_wrong_constant_is_found() {
    let wrong = Mutant::HalfOfLeftGap.into();
    let incline = ["Proposition 8.2", "incline"];
    let found = tightest(Search::default(), &wrong, incline, Source::Stated);
    assert!(matches!(found, Err(AdversaryError::Violated { .. })), "{found:?}");
}
