//! The families of the project, which say on which boxes each statement is searched.
//!
//! | a case is | families | the statements are listed, one per line, in |
//! | --- | --- | --- |
//! | a problem with a known distance, and `N` | shear, separable, ramp, tent, incline, valleys, two routes, two arcs | `about_problems.rs` |
//! | a metric and a point | shear, valleys, cosines, anisotropy | `points.rs` |
//! | a metric and a point sequence | shear, separable, ramp, tent, incline, valleys | `sequences.rs` |
//!
//! Where a change of units or a reflection maps a family to itself, one parameter is left out. For
//! example, one wave number is fixed at 1, and coordinates are measured as phases, which have no
//! edges. Every other range ends near a limit, or where no further cases exist, and declares which.
//!
//! The paper's statements are searched in all families of their kind except the two arcs. Ours are
//! searched in the families in which they come closest to equality, and on the sheared plane.

mod about_problems;
mod points;
mod problems;
mod ranges;
mod sequences;

use tautline_statements::Subject;

use super::Family;

/// Returns all families for a subject, sorted by statement; within a statement, in the order above.
#[must_use]
pub fn families(subject: &Subject) -> Vec<Family<'_>> {
    let mut all = problems::of_problems(subject);
    all.extend(sequences::of_sequences(subject));
    all.extend(points::of_points(subject));
    // The sort is stable, so that the families of a statement keep their order.
    all.sort_by_key(|family| family.statement);
    all
}
