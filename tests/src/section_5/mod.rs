//! Section 5: on the valleys, from `(0, 0)` to `(4π, 0)`, the discrete lengths have minima that do
//! not converge to the distance `8π`, and the discrete energies have minima that do.

mod dynamic_programming;
mod energies;
mod lengths;

pub(crate) use energies::axis;
