//! How values lie along an axis.

/// The spacing of values along an axis, and where its ticks lie.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Linear, ticks at round numbers.
    Linear,
    /// Linear, ticks at multiples of π.
    MultiplesOfPi,
    /// Logarithmic, ticks at powers of ten.
    Decades,
    /// Logarithmic, ticks at powers of two.
    Octaves,
}

impl Scale {
    /// Returns whether equal ratios have equal lengths.
    #[must_use]
    pub fn is_logarithmic(self) -> bool {
        matches!(self, Scale::Decades | Scale::Octaves)
    }
}
