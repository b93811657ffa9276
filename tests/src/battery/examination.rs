//! Which mistakes the bounds of the paper could see.

use tautline_statements::Mutant;
use tautline_suite::battery::{Examination, Scope, Sight};

/// Half an energy is too small; `K̄_{4,g}` may be too small by much before a bound fails; and no
/// bound of the paper has Lemma S.3 or Proposition S.7 in it.
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
