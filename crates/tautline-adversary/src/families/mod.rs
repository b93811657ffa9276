//! The families of the project: which statement is searched on which boxes.
//!
//! | what a case is | families | statements: one line each in |
//! | --- | --- | --- |
//! | a problem with a known distance, and `N` | shear, separable, ramp, tent, incline, valleys, two routes, two arcs | `about_problems.rs` |
//! | a metric and a point | shear, valleys, cosines, anisotropy | `points.rs` |
//! | a metric and a point sequence | shear, separable, ramp, tent, incline, valleys | `sequences.rs` |
//!
//! If a change of units or a reflection maps a family to itself, one parameter is left out: a wave
//! number is then 1, and coordinates count in phases, which have no edges. Other ranges end near
//! limits, or where no other case exists, and say so.
//!
//! The paper's statements are searched in all families of their kind except two arcs; ours in those
//! where they come closest to equality, and on the sheared plane.

mod about_problems;
mod points;
mod problems;
mod ranges;
mod sequences;

use tautline_statements::Subject;

use super::Family;

/// Returns all families for a subject, by statement and then in the order above.
#[must_use]
pub fn families(subject: &Subject) -> Vec<Family<'_>> {
    let mut all = problems::of_problems(subject);
    all.extend(sequences::of_sequences(subject));
    all.extend(points::of_points(subject));
    // Stable: the families of a statement stay in their order.
    all.sort_by_key(|family| family.statement);
    all
}
