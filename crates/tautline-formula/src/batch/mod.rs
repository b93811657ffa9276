//! `Batch`: a metric at many points at once.

mod contraction;
mod kernel;
mod layout;
mod plain;
mod prepared;

use nalgebra::{SMatrix, SVector};

pub(crate) use contraction::CHUNKED;
pub use layout::{Kind, Layout};
pub use plain::Plain;
pub(crate) use plain::{contiguous, rows};
pub use prepared::Prepared;

use crate::program::{InstructionSet, Register, Registers};

/// A metric, behind a pointer, that is evaluated in batches. It provides all that a discrete energy
/// needs.
pub trait Batches<const D: usize>: Sync {
    /// Returns `H(x)`.
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D>;

    /// Returns the layout of a kind.
    fn layout(&self, kind: Kind) -> &Layout;

    /// Returns registers for the rows of a kind, with the best number of lanes between `unit` and
    /// `unit` times `units`.
    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers;

    /// Returns the instruction set for the caller's own loops.
    fn instruction_set(&self) -> InstructionSet {
        InstructionSet::default()
    }

    /// Fills the rows from the points and vectors in the first registers.
    fn evaluate(&self, kind: Kind, registers: &mut Registers);
}

/// The Gram matrix `H` at many points `x` at once, with its derivatives contracted with a vector
/// `d`. Each point has one lane.
pub struct Batch<'f, const D: usize> {
    registers: Registers,
    metric: &'f dyn Batches<D>,
    kind: Kind,
}

impl<'f, const D: usize> Batch<'f, D> {
    /// Allocates memory for a batch of this kind. It has room for at least `unit` points, which
    /// must stay together, and for at most `units` times as many.
    #[must_use]
    pub fn new(metric: &'f dyn Batches<D>, kind: Kind, unit: usize, units: usize) -> Self {
        Self { registers: metric.registers(kind, unit, units), metric, kind }
    }

    /// Returns the greatest number of lanes.
    #[must_use]
    pub fn lanes(&self) -> usize {
        self.registers.lanes()
    }

    /// Returns the points and vectors of the first `count` lanes for writing.
    ///
    /// # Panics
    ///
    /// If `count` exceeds [`lanes`](Self::lanes).
    #[inline(always)]
    pub fn inputs(&mut self, count: usize) -> Inputs<'_, D> {
        let [mut x, mut d] = self.registers.inputs();
        // This tells the compiler that all rows have the same length.
        for i in 0..D {
            x[i] = &mut std::mem::take(&mut x[i])[..count];
            d[i] = &mut std::mem::take(&mut d[i])[..count];
        }
        Inputs { x, d }
    }

    /// Evaluates the first `count` lanes. Returns whether `H` is finite, symmetric and positive
    /// definite in each of them.
    ///
    /// # Panics
    ///
    /// If `count` is 0 or exceeds [`lanes`](Self::lanes).
    pub fn evaluate(&mut self, count: usize) -> bool {
        assert!(count > 0 && count <= self.lanes(), "{count} of {} lanes", self.lanes());
        let used = self.registers.set_used(count);
        // Unused lanes repeat the last point.
        self.registers.repeat(2 * D, count, used);
        self.metric.evaluate(self.kind, &mut self.registers);
        self.layout().is_metric(&self.registers, count)
    }

    /// Returns the layout of the rows.
    #[must_use]
    pub fn layout(&self) -> &'f Layout {
        self.metric.layout(self.kind)
    }

    /// Returns a row, lane by lane.
    ///
    /// A program fills whole chunks: the lanes beyond the last point, up to the next multiple of
    /// [`WIDTH`](crate::WIDTH), repeat the results of that point. What is in other lanes is left from
    /// earlier batches.
    #[must_use]
    #[inline]
    pub fn row(&self, register: Register) -> &[f64] {
        self.registers.row(register)
    }
}

/// The points `x` and the vectors `d` of the lanes, coordinate by coordinate.
pub struct Inputs<'b, const D: usize> {
    x: [&'b mut [f64]; D],
    d: [&'b mut [f64]; D],
}

impl<const D: usize> Inputs<'_, D> {
    /// Sets the point and the vector of a lane.
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

    /// Sets the points and vectors of lanes `2 pair` and `2 pair + 1`.
    ///
    /// # Panics
    ///
    /// If there are no such lanes.
    #[inline(always)]
    pub fn set_pair(&mut self, pair: usize, x: &[SVector<f64, D>; 2], d: &[SVector<f64, D>; 2]) {
        for i in 0..D {
            self.x[i].as_chunks_mut().0[pair] = [x[0][i], x[1][i]];
            self.d[i].as_chunks_mut().0[pair] = [d[0][i], d[1][i]];
        }
    }
}
