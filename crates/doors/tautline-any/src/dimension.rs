//! Dimensions that are known when the program runs.

/// The largest dimension of a problem.
pub const LARGEST_DIMENSION: usize = 256;

/// The largest dimension of what is compiled for each dimension: metrics of the gallery, and audits.
pub const LARGEST_FIXED_DIMENSION: usize = 12;

/// The largest dimension in which constants are proved from the formula. Beyond it the boxes of
/// branch and bound are too many for most formulas.
pub const LARGEST_PROVED_DIMENSION: usize = 12;

/// The most numbers in the steps of a formula, each with its first and second derivatives, from which
/// constants are proved in more than six dimensions. Each box costs so many intervals. A box of
/// a larger formula, such as a decoder, costs more, and its bounds are too wide to be of use.
pub const LARGEST_EXPANSION: usize = 1 << 16;

/// What is done in a dimension.
pub trait InDimension {
    /// What it returns.
    type Output;

    /// Does it in the dimension `D`.
    fn run<const D: usize>(self) -> Self::Output;
}

/// Does something in the dimension `d`; returns `None` if it is 0 or above
/// [`LARGEST_FIXED_DIMENSION`].
pub fn in_dimension<T: InDimension>(d: usize, task: T) -> Option<T::Output> {
    Some(match d {
        1 => task.run::<1>(),
        2 => task.run::<2>(),
        3 => task.run::<3>(),
        4 => task.run::<4>(),
        5 => task.run::<5>(),
        6 => task.run::<6>(),
        7 => task.run::<7>(),
        8 => task.run::<8>(),
        9 => task.run::<9>(),
        10 => task.run::<10>(),
        11 => task.run::<11>(),
        12 => task.run::<12>(),
        _ => return None,
    })
}
