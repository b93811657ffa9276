//! `Asked`: which programs of a subject have been asked.

use super::Program;

/// A set of programs of a subject: one bit for each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked(pub(super) u64);

impl Asked {
    /// So many bits are those of [`Program`]s; the entries of [`Bounds`](super::Bounds) follow.
    pub(super) const PROGRAMS: usize = 12;

    pub(crate) const fn add(&mut self, program: Program) {
        self.0 |= 1 << program as usize;
    }

    pub(super) const fn add_bound(&mut self, entry: usize) {
        self.0 |= 1 << (Self::PROGRAMS + entry);
    }

    /// Returns whether a program is in both sets.
    #[must_use]
    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}
