//! `Row`: the lanes of a register, in recycled memory.

use std::{
    cell::RefCell,
    ops::{Deref, DerefMut},
};

use crate::program::WIDTH;

/// The lanes that are worked on at once.
pub(crate) type Chunk = [f64; WIDTH];

/// A number of chunks.
///
/// When a row is dropped, its memory is reused for the next row of its length on this thread.
/// Otherwise, allocating and clearing the rows of a program would take as long as evaluating about
/// a hundred points. The contents of a new row are arbitrary.
#[derive(Debug)]
pub(crate) struct Row(Box<[Chunk]>);

/// A thread keeps rows of up to `LONGEST` chunks, and at most `KEPT` chunks of each length, or 256
/// kB.
const LONGEST: usize = 16;
const KEPT: usize = 4096;

thread_local! {
    /// The spare rows, by length.
    static SPARE: RefCell<[Vec<Box<[Chunk]>>; LONGEST + 1]> = RefCell::default();
}

impl Row {
    /// Returns a row with arbitrary contents.
    pub(crate) fn new(chunks: usize) -> Self {
        let spare = SPARE.try_with(|spare| spare.borrow_mut().get_mut(chunks)?.pop());
        Self(spare.ok().flatten().unwrap_or_else(|| vec![[0.0; WIDTH]; chunks].into_boxed_slice()))
    }

    /// Returns a row with this number in every lane.
    pub(crate) fn filled(chunks: usize, value: f64) -> Self {
        let mut row = Self::new(chunks);
        row.fill([value; WIDTH]);
        row
    }
}

impl Drop for Row {
    fn drop(&mut self) {
        let row = std::mem::take(&mut self.0);
        // When the thread ends, the list may be gone. The memory is then freed.
        let _ = SPARE.try_with(|spare| {
            if let Some(rows) = spare.borrow_mut().get_mut(row.len())
                && rows.len() * row.len() < KEPT
                && !row.is_empty()
            {
                rows.push(row);
            }
        });
    }
}

impl Clone for Row {
    fn clone(&self) -> Self {
        let mut row = Self::new(self.len());
        row.copy_from_slice(self);
        row
    }
}

impl Deref for Row {
    type Target = [Chunk];

    #[inline(always)]
    fn deref(&self) -> &[Chunk] {
        &self.0
    }
}

impl DerefMut for Row {
    #[inline(always)]
    fn deref_mut(&mut self) -> &mut [Chunk] {
        &mut self.0
    }
}

#[cfg(test)]
mod tests {
    use super::{KEPT, LONGEST, Row, SPARE};

    fn kept(chunks: usize) -> usize {
        SPARE.with(|spare| spare.borrow()[chunks].len())
    }

    #[test]
    fn a_row_reuses_memory_of_its_length() {
        let first = Row::filled(3, 7.0);
        let place = first.as_ptr();
        drop(first);
        assert_eq!((kept(3), kept(2)), (1, 0));
        assert_eq!(Row::new(2).len(), 2);
        let next = Row::filled(3, 1.0);
        assert_eq!((next.as_ptr(), kept(3)), (place, 0));
        assert!(next.as_flattened().iter().all(|&x| x == 1.0));
        assert_eq!(next.clone().as_flattened(), next.as_flattened());
    }

    #[test]
    fn a_thread_keeps_a_bounded_amount() {
        for chunks in [1, 7, LONGEST] {
            drop((0..KEPT).map(|_| Row::new(chunks)).collect::<Vec<_>>());
            assert_eq!(kept(chunks), KEPT.div_ceil(chunks), "{chunks}");
        }
        drop(Row::new(LONGEST + 1));
        assert_eq!(kept(0), 0);
    }
}
