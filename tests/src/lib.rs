//! The statements of the paper as tests, one module per section, and the tidiness of the workspace.
//!
//! | module | shows |
//! | --- | --- |
//! | `battery` | every check of the project's own suite, by its name |
//! | `adversary` | what the search for the tightest cases finds |
//! | `kit` | the kit on the whole gallery, all sets and rules, and on what has to be rejected |
//! | `own` | a metric, a rule and a closed set of one's own, through the face |
//! | `bad_input`, `touching_ends` | what is refused, and how; what is not |
//! | `promoted_cases` | random cases that caught a mistake, kept by name |
//! | `committed_data` | what the project claims of the data in its repository |
//! | `tidiness` | the shape of the workspace |
//!
//! Random cases are the same in every run, unless `TAUTLINE_SEED` or `TAUTLINE_CASES` is set
//! (`docs/testing.md`); a failure names its seed.

#[cfg(test)]
mod adversary;
#[cfg(test)]
mod bad_input;
#[cfg(test)]
mod battery;
#[cfg(test)]
mod committed_data;
#[cfg(test)]
mod kit;
#[cfg(test)]
mod own;
#[cfg(test)]
mod promoted_cases;
#[cfg(test)]
mod tidiness;
#[cfg(test)]
mod touching_ends;
