//! `Batch`: a metric at many places at once.

mod layout;
mod programs;

use nalgebra::SVector;

pub use layout::{Kind, Layout};
pub use programs::Programs;

use crate::program::{Register, Registers};

/// What fills the rows of a [`Batch`]: behind a pointer, once for all lanes.
pub trait Evaluate: Sync {
    /// Returns where the rows are.
    fn layout(&self) -> &Layout;

    /// Returns registers in which the rows will be, for at most so many lanes.
    fn registers(&self) -> Registers;

    /// Fills the rows of the lanes in use by the places and chords in the first registers.
    fn evaluate(&self, registers: &mut Registers);
}

/// A metric by batches: what a discrete energy needs of it.
pub trait Batches<const D: usize>: Sync {
    /// Returns what fills the rows of this kind.
    fn evaluator(&self, kind: Kind) -> &dyn Evaluate;

    /// Returns memory for a batch of this kind.
    fn batch(&self, kind: Kind) -> Batch<'_, D> {
        let how = self.evaluator(kind);
        Batch { registers: how.registers(), how }
    }
}

/// The Gram matrix `H` at many places `x` at once, with its derivatives contracted with a vector `d` at
/// each: a lane for each place.
pub struct Batch<'f, const D: usize> {
    registers: Registers,
    how: &'f dyn Evaluate,
}

impl<const D: usize> Batch<'_, D> {
    /// Returns the greatest number of lanes.
    #[must_use]
    pub fn lanes(&self) -> usize {
        self.registers.lanes()
    }

    /// Returns the places and vectors of the lanes, to be written.
    #[inline]
    pub fn inputs(&mut self) -> Inputs<'_, D> {
        let [x, d] = self.registers.inputs();
        Inputs { x, d }
    }

    /// Evaluates at the first `count` lanes. Returns whether `H` is finite, symmetric and positive definite
    /// at each of them.
    ///
    /// # Panics
    ///
    /// If that is no lane, or more than [`lanes`](Self::lanes).
    pub fn evaluate(&mut self, count: usize) -> bool {
        assert!(count > 0 && count <= self.lanes(), "{count} of {} lanes", self.lanes());
        let used = self.registers.set_used(count);
        // The others are the last once more: no place where there is nothing.
        let Inputs { x, d } = self.inputs();
        for row in x.into_iter().chain(d) {
            let last = row[count - 1];
            row[count..used].fill(last);
        }
        self.how.evaluate(&mut self.registers);
        self.how.layout().is_metric(&self.registers, count)
    }

    /// Returns where the rows are.
    #[must_use]
    pub fn layout(&self) -> &Layout {
        self.how.layout()
    }

    /// Returns the numbers of a row, lane by lane.
    #[must_use]
    #[inline]
    pub fn row(&self, register: Register) -> &[f64] {
        self.registers.row(register)
    }
}

/// The places `x` and the vectors `d` of the lanes, coordinate by coordinate.
pub struct Inputs<'b, const D: usize> {
    x: [&'b mut [f64]; D],
    d: [&'b mut [f64]; D],
}

impl<const D: usize> Inputs<'_, D> {
    /// Sets the place and the vector of a lane.
    ///
    /// # Panics
    ///
    /// If there is no such lane.
    #[inline(always)]
    pub fn set(&mut self, lane: usize, x: &SVector<f64, D>, d: &SVector<f64, D>) {
        for i in 0..D {
            self.x[i][lane] = x[i];
            self.d[i][lane] = d[i];
        }
    }
}
