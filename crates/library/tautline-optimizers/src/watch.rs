//! Who is told of the iterates of a solve, and whether it has been asked to end.

use std::{
    cell::{Cell, RefCell},
    ops::ControlFlow,
    sync::atomic::{AtomicBool, Ordering},
};

use tautline_discretizations::ANY;

use crate::{Iterate, Watcher};

/// Told of each iterate by the local searches, which share it.
pub(crate) trait Watch {
    /// Tells the watcher of an iterate, unless it has ended the solve before or there is none, and
    /// returns whether the search goes on. The iterate is computed only if there is somebody to see
    /// it.
    fn goes_on<'i>(&self, iterate: &dyn Fn() -> Iterate<'i, ANY>) -> bool;

    /// Returns whether the watcher has ended the solve.
    fn has_ended(&self) -> bool;
}

/// Nobody watches.
pub(crate) struct Unwatched;

impl Watch for Unwatched {
    fn goes_on<'i>(&self, _: &dyn Fn() -> Iterate<'i, ANY>) -> bool {
        true
    }

    fn has_ended(&self) -> bool {
        false
    }
}

/// A flag ends the solve once it is true.
pub(crate) struct Flagged<'w>(pub(crate) &'w AtomicBool);

impl Watch for Flagged<'_> {
    fn goes_on<'i>(&self, _: &dyn Fn() -> Iterate<'i, ANY>) -> bool {
        !self.has_ended()
    }

    fn has_ended(&self) -> bool {
        self.0.load(Ordering::Relaxed)
    }
}

/// A watcher, and whether it has ended the solve.
pub(crate) struct Watched<'w> {
    watcher: RefCell<&'w mut Watcher<'w, ANY>>,
    ended: Cell<bool>,
}

impl<'w> Watched<'w> {
    pub(crate) fn by(watcher: &'w mut Watcher<'w, ANY>) -> Self {
        Self { watcher: RefCell::new(watcher), ended: Cell::new(false) }
    }
}

impl Watch for Watched<'_> {
    fn goes_on<'i>(&self, iterate: &dyn Fn() -> Iterate<'i, ANY>) -> bool {
        if !self.ended.get() {
            let answer = (self.watcher.borrow_mut())(&iterate());
            self.ended.set(answer == ControlFlow::Break(()));
        }
        !self.ended.get()
    }

    fn has_ended(&self) -> bool {
        self.ended.get()
    }
}
