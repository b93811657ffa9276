//! Checks, before a step is taken, that there is memory for it.

use std::hint::black_box;

use crate::{SolveError, Workspace};

/// A request for fewer bytes is assumed to succeed: if it failed, the next small list would fail as
/// well.
const SMALL: usize = 1 << 28;

/// Returns whether the system grants this many bytes at once. None of them is touched. A system
/// that promises more than it has would notice only when they are used, and end the process.
fn is_available(bytes: usize) -> bool {
    let mut memory = Vec::<u8>::new();
    // The compiler must not remove the allocation.
    bytes < SMALL || black_box(&mut memory).try_reserve_exact(bytes).is_ok()
}

/// Checks that there is memory for `numbers` numbers at each point of `n` chords, of which `kept`
/// bytes are already allocated.
fn check(n: usize, numbers: usize, kept: usize) -> Result<(), SolveError> {
    let bytes = n.saturating_add(1).saturating_mul(numbers.saturating_mul(8));
    let new = bytes.saturating_sub(kept);
    if is_available(new) { Ok(()) } else { Err(SolveError::OutOfMemory { n, bytes }) }
}

impl Workspace {
    /// Checks that there is memory for the points of this number of sequences of `n` chords in
    /// `R^dimension`.
    ///
    /// # Errors
    ///
    /// [`SolveError::OutOfMemory`].
    pub fn check_points(dimension: usize, n: usize, sequences: usize) -> Result<(), SolveError> {
        check(n, dimension.saturating_mul(sequences), 0)
    }

    /// Checks that there is memory for an undamped step on `n` chords, which overwrites the
    /// factorisation of earlier searches.
    pub(crate) fn check_undamped(&self, dimension: usize, n: usize) -> Result<(), SolveError> {
        check(n, undamped(dimension), self.factorization.bytes())
    }

    /// Checks that there is memory for damped steps on `n` chords, which do not use the workspace.
    pub(crate) fn check_damped(dimension: usize, n: usize) -> Result<(), SolveError> {
        check(n, 4 * undamped(dimension), 0)
    }
}

/// Returns the number of doubles that an undamped Newton step stores for each point, including the
/// coordinates of the point. A damped step stores four times as many, since it assembles, shifts and
/// factorises one after the other.
fn undamped(dimension: usize) -> usize {
    2 * dimension * dimension + 2 * dimension
}

#[cfg(test)]
mod tests {
    use super::{SMALL, is_available};
    use crate::{SolveError, Workspace};

    /// Addresses have at most 57 bits on today's processors, and Rust never requests 2⁶³ bytes.
    #[test]
    fn more_bytes_than_addresses_are_not_available() {
        assert!(is_available(0) && is_available(SMALL - 1) && is_available(SMALL));
        for bytes in [1 << 58, isize::MAX as usize, usize::MAX] {
            assert!(!is_available(bytes), "{bytes}");
        }
    }

    #[test]
    fn the_error_reports_chords_and_bytes() {
        let workspace = Workspace::default();
        let n = 1 << 44;
        let bytes = (n + 1) * (2 * 64 * 64 + 2 * 64) * 8;
        assert_eq!(workspace.check_undamped(64, n), Err(SolveError::OutOfMemory { n, bytes }));
        let damped = Workspace::check_damped(64, n);
        assert_eq!(damped, Err(SolveError::OutOfMemory { n, bytes: 4 * bytes }));
        let all = Workspace::check_damped(64, usize::MAX);
        assert_eq!(all, Err(SolveError::OutOfMemory { n: usize::MAX, bytes: usize::MAX }));
        assert_eq!(
            (workspace.check_undamped(64, 100), Workspace::check_damped(64, 100)),
            (Ok(()), Ok(()))
        );
        let bytes = (n + 1) * 64 * 8 * (1 << 10);
        let points = Workspace::check_points(64, n, 1 << 10);
        assert_eq!(points, Err(SolveError::OutOfMemory { n, bytes }));
        assert_eq!(Workspace::check_points(64, 100, 100), Ok(()));
    }
}
