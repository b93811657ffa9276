//! `Pace`: whether smaller cubes still make the gap smaller.

/// After this many levels in a row that each leave more than `SLOW` of the gap, the search ends.
const SLOW_LEVELS: usize = 2;
const SLOW: f64 = 0.7;

/// How many levels in a row were slow.
#[derive(Clone, Copy, Debug, Default)]
pub(crate) struct Pace {
    slow: usize,
}

impl Pace {
    /// Counts a level, given the gap before it and after it. A level that is not slow ends the row.
    pub(crate) fn add(&mut self, before: f64, after: f64) {
        self.slow = if after <= SLOW * before { 0 } else { self.slow + 1 };
    }

    /// Returns whether too many levels in a row were slow.
    pub(crate) fn is_stalled(self) -> bool {
        self.slow >= SLOW_LEVELS
    }
}

#[cfg(test)]
mod tests {
    use super::Pace;

    /// Returns after how many levels a search with these gaps stalls.
    fn stalls(gaps: &[f64]) -> Option<usize> {
        let mut pace = Pace::default();
        let levels = gaps.windows(2).enumerate();
        let mut stalled = levels.filter_map(|(n, pair)| {
            pace.add(pair[0], pair[1]);
            pace.is_stalled().then_some(n + 1)
        });
        stalled.next()
    }

    #[test]
    fn slow_levels_count_in_a_row_and_not_in_all() {
        // Every other level is slow.
        assert_eq!(stalls(&[0.5, 0.45, 0.1, 0.09, 0.02, 0.019, 0.003]), None);
        // The second and the third are.
        assert_eq!(stalls(&[0.5, 0.1, 0.09, 0.085, 0.01]), Some(3));
        // One of them was slow long ago.
        assert_eq!(stalls(&[0.5, 0.45, 0.1, 0.02, 0.019, 0.001]), None);
    }

    #[test]
    fn a_level_that_leaves_seven_tenths_is_not_slow() {
        assert_eq!(stalls(&[1.0, 0.7, 0.49 - 1e-9, 0.34]), None);
        assert_eq!(stalls(&[1.0, 0.71, 0.71 * 0.71]), Some(2));
        // Neither is a gap without a number better than before.
        assert_eq!(stalls(&[1.0, f64::NAN, f64::NAN]), Some(2));
    }
}
