//! `Asked`: a set of programs of a subject.

use super::Program;

/// A set of programs of a subject, one bit each.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Asked(pub(crate) u64);

impl Asked {
    /// The number of bits for [`Program`]s. The bits for entries of [`Bounds`](super::Bounds)
    /// follow.
    pub(crate) const PROGRAMS: usize = 12;

    pub(crate) const fn add(&mut self, program: Program) {
        self.0 |= 1 << program as usize;
    }

    pub(crate) const fn add_bound(&mut self, entry: usize) {
        self.0 |= 1 << (Self::PROGRAMS + entry);
    }

    /// Returns whether the two sets have a program in common.
    #[must_use]
    pub const fn meets(self, other: Self) -> bool {
        self.0 & other.0 != 0
    }
}
