//! How values are spaced along an axis.

/// The spacing of values along an axis, and the places of its ticks.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// A linear scale with ticks at round numbers.
    Linear,
    /// A linear scale with ticks at multiples of π.
    MultiplesOfPi,
    /// A logarithmic scale with ticks at powers of ten.
    Decades,
    /// A logarithmic scale with ticks at powers of two.
    Octaves,
}

impl Scale {
    /// Returns whether equal ratios appear as equal lengths.
    #[must_use]
    pub fn is_logarithmic(self) -> bool {
        matches!(self, Scale::Decades | Scale::Octaves)
    }
}
