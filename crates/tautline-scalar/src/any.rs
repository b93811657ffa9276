//! `ANY`: the dimension of types whose dimension is known only when the program runs.

/// The parameter `D` of a type whose dimension is a value, known when the program runs.
///
/// A `PointSequence<2>` lies in the plane, and the compiler knows it. A `PointSequence<ANY>` carries its
/// dimension with it. What takes the latter is compiled once for all dimensions.
pub const ANY: usize = usize::MAX;
