//! The paper's statements, section by section, checked on random cases, in other units, on
//! witnesses and on counterexamples.

pub(super) mod dropped;
pub(super) mod existence;
pub(super) mod point_sequences;
pub(super) mod section_1;
pub(super) mod section_3;
pub(super) mod section_4;
pub(super) mod section_5;
pub(super) mod section_6;
pub(super) mod section_7_algebra;
pub(super) mod section_7_apriori;
pub(super) mod section_7_morrey;
pub(super) mod section_7_sampling;
pub(super) mod section_9;
pub(super) mod theorem_witnesses;
