//! `Sweep`: the numbers of subintervals over which figures and tables run, and how often.

/// The range of `N`, and whether times are measured.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Sweep {
    /// Whether the range is cut short, for a quick run.
    pub quick: bool,
    /// Whether measured times are the least of several runs. For what is compared one run is enough.
    pub repeats: bool,
}

impl Sweep {
    /// Returns `1, 2, 4, …` up to `full`, or up to a sixteenth of it in a quick run.
    #[must_use]
    pub fn powers_of_two(self, full: usize) -> Vec<usize> {
        let last = if self.quick { full / 16 } else { full };
        std::iter::successors(Some(1), |n| Some(2 * n)).take_while(|&n| n <= last).collect()
    }
}
