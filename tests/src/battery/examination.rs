//! Which mistakes the bounds of the paper can detect.

use tautline_checks::battery::{Check, Examination, Scope, Sight, Trial, suite};
use tautline_statements::{LIBRARY, Mutant, Subject};

/// Half of an energy violates a bound. `K̄_{4,g}` may be far too small before a bound fails. No
/// bound of the paper contains Lemma S.3 or Proposition S.7.
#[test]
fn a_mistake_is_killed_or_passes_or_is_not_seen_at_all() {
    let paper = Examination::new(Scope::PaperAlone, 4).expect("the library passes");
    for (mutant, expected) in [
        (Mutant::EnergyHalved, Sight::Killed),
        (Mutant::K4IsK3, Sight::Passes),
        (Mutant::OmegaHalved, Sight::Unseen),
        (Mutant::StepHalved, Sight::Unseen),
        (Mutant::SlopeForgotten, Sight::Unseen),
    ] {
        assert_eq!(paper.sight(mutant), expected, "{mutant:?}");
    }
}

/// Both runs use the same cases, and a few cases suffice.
#[test]
fn a_check_that_is_not_run_computes_what_it_computed_for_the_library() {
    let (scope, cases) = (Scope::PaperAlone, 2);
    let examination = Examination::new(scope, cases).expect("the library passes");
    let suite: Vec<Check> = suite().into_iter().filter(|check| check.is_in(scope)).collect();
    for mutant in [Mutant::DistanceForgotten, Mutant::LipschitzTooSmall, Mutant::EndRelaxed] {
        let wrong = Subject::from(mutant);
        let asking: Vec<&str> = examination.asking_for(mutant).map(|check| check.name).collect();
        let left = suite.iter().filter(|check| !asking.contains(&check.name));
        for check in left.clone() {
            let [genuine, wrong] = [&LIBRARY, &wrong]
                .map(|subject| check.run(&Trial::new(subject, scope, cases)).expect("it passes"));
            assert_eq!(genuine, wrong, "{mutant:?}: {}", check.name);
        }
        assert!(!asking.is_empty() && left.count() > 0, "{mutant:?}: {asking:?}");
    }
}
