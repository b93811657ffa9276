//! The grids of a search, from coarse to fine.

/// The largest number of chords of a coarsest grid. It is large enough to distinguish the ways
/// round an obstacle, and small enough that a dozen starts cost less than one pass over a fine
/// grid.
///
/// A grid with at most this many chords is the only one. A discrete minimiser may leap over a ridge
/// there, and it depends on the grid which leaps save energy.
const COARSEST: usize = 32;

/// Up to this many chords, the coarsest grid has half as many chords as the finest. A solve
/// therefore starts on the same coarsest grid as a solve with more chords, and costs no more. Leaps
/// may still save energy; if the energies suggest this, the search looks for leaps once more.
pub(crate) const SMALL: usize = 64;
const DOUBLED: usize = 2;

/// The factors by which `N` grows from one grid to the next. The factor increases at each of the
/// numbers of chords in `FINER`, since a finer grid predicts the next one better.
const REFINEMENT: [usize; 3] = [4, 8, 16];
const FINER: [usize; 2] = [4096, 65_536];

/// Returns the grids on the way to `n` chords, from coarse to fine.
pub(crate) fn grids(n: usize) -> Vec<usize> {
    let mut grids = vec![n];
    let mut grid = n;
    while grid > COARSEST {
        let later = REFINEMENT[FINER.iter().filter(|&&finer| grid >= finer).count()];
        grid = grid.div_ceil(if n <= SMALL { DOUBLED } else { later });
        grids.push(grid);
    }
    grids.reverse();
    grids
}

#[cfg(test)]
mod tests {
    use super::grids;

    #[test]
    fn grids_end_at_n_and_begin_coarse() {
        assert_eq!(grids(1), [1]);
        assert_eq!(grids(32), [32]);
        assert_eq!(grids(33), [17, 33]);
        assert_eq!(grids(64), [32, 64]);
        assert_eq!(grids(65), [17, 65]);
        assert_eq!(grids(1000), [16, 63, 250, 1000]);
        assert_eq!(grids(10_000), [20, 79, 313, 1250, 10_000]);
        assert_eq!(grids(100_000), [13, 49, 196, 782, 6250, 100_000]);
    }
}
