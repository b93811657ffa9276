//! `ANY`: the dimension of types whose dimension is known only when the program runs.

/// The parameter `D` of a type whose dimension is a value, known when the program runs.
///
/// The compiler knows that a `PointSequence<2>` lies in the plane. A `PointSequence<ANY>` stores its
/// dimension, and a function that takes it is compiled once for all dimensions.
pub const ANY: usize = usize::MAX;
