//! The statements of the paper as tests, one module per section, and the tidiness of the workspace.
//!
//! | module | shows |
//! | --- | --- |
//! | `section_1` | observed orders and leading constants |
//! | `section_3` | geodesics have constant speed; distances between the Euclidean ones |
//! | `section_5` | the counterexample: discrete lengths, and global minima of the discrete energies |
//! | `section_6` | no curve has less energy than `d²` |
//! | `section_7` | the propositions on geodesics |
//! | `battery` | every check of the project's own suite, by its name |
//! | `golden` | the paper's constants against values computed with 40 digits |
//! | `kit` | the kit on the whole gallery, all sets and rules, and on what has to be rejected |
//! | `own` | a metric, a rule and a closed set of one's own, through the face |
//! | `bad_input`, `touching_ends` | what is refused, and how; what is not |
//! | `committed_data` | what the project claims of the data in its repository |
//! | `tidiness` | the shape of the workspace |
//!
//! Everything goes through the public face, `tautline`. Nothing here is random: property tests
//! have fixed seeds, the first argument of `for_all`.

#[cfg(test)]
mod bad_input;
#[cfg(test)]
mod battery;
#[cfg(test)]
mod committed_data;
#[cfg(test)]
mod families;
#[cfg(test)]
mod golden;
#[cfg(test)]
mod kit;
#[cfg(test)]
mod own;
#[cfg(test)]
mod random;
#[cfg(test)]
mod section_1;
#[cfg(test)]
mod section_3;
#[cfg(test)]
mod section_5;
#[cfg(test)]
mod section_6;
#[cfg(test)]
mod section_7;
#[cfg(test)]
mod tidiness;
#[cfg(test)]
mod touching_ends;
