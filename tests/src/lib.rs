//! The statements of the paper as tests, one module per section, and the invariants of the
//! workspace.
//!
//! | module | shows |
//! | --- | --- |
//! | `battery` | every check of the project's own suite, by name |
//! | `adversary` | what the search for the tightest cases finds |
//! | `kit` | the kit on the whole gallery, all sets and rules, and on what must be refused |
//! | `own` | a user's metric, rule and closed set, through the `tautline` crate |
//! | `bad_input`, `touching_ends` | what is refused, and how; and what is accepted |
//! | `promoted_cases` | random cases that caught a mistake, kept by name |
//! | `saved` | options and results that are written and read, with the feature `serde` |
//! | `committed_data` | what the project claims about the data in its repository |
//! | `tidiness` | the invariants of the architecture |
//!
//! The random cases are the same in every run unless `TAUTLINE_SEED` or `TAUTLINE_CASES` is set
//! (`docs/testing.md`). A failing test shows its seed.

#![cfg(test)]

mod adversary;
mod bad_input;
mod battery;
mod committed_data;
mod kit;
mod own;
mod promoted_cases;
mod saved;
mod tidiness;
mod touching_ends;
