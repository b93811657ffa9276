//! `Batch`: a metric at many points at once.

mod batches_in;
mod contraction;
mod interpreted;
mod kernel;
mod known;
mod layout;
mod plain;
mod prepare;
mod prepared;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::quadrature::FEW_ROUNDINGS;

pub use batches_in::BatchesIn;
pub(crate) use contraction::CHUNKED;
pub use known::Known;
pub use layout::{Kind, Layout};
pub use plain::Plain;
pub(crate) use plain::{contiguous, rows};
pub use prepare::Prepare;
pub use prepared::{Prepared, PreparedFormula};

use crate::program::{InstructionSet, Register, Registers};

/// A metric, behind a pointer, that is evaluated in batches. It provides all that a discrete energy
/// needs. What takes it is compiled once for all dimensions.
pub trait AnyBatches: Sync {
    /// Returns the dimension `D` of the space.
    fn dimension(&self) -> usize;

    /// Returns the relative tolerance of integrals along a chord: a few roundings for a metric that is
    /// smooth, more for one whose third derivatives jump, where a quadrature halves many intervals.
    fn quadrature_tolerance(&self) -> f64 {
        FEW_ROUNDINGS
    }

    /// Writes `H(x)` to `gram`, as `D²` numbers column by column, both halves as the metric gives
    /// them.
    fn gram_into(&self, x: &[f64], gram: &mut [f64]);

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

/// Batches of a metric on `R^D`, where `D` is known at compile time.
pub trait Batches<const D: usize>: AnyBatches {
    /// Returns `H(x)`.
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        let mut gram = SMatrix::<f64, D, D>::zeros();
        self.gram_into(x.as_slice(), gram.as_mut_slice());
        gram
    }
}

/// The Gram matrix `H` at many points `x` at once, with its derivatives contracted with a vector
/// `d`. Each point has one lane.
pub struct Batch<'f> {
    registers: Registers,
    metric: &'f dyn AnyBatches,
    kind: Kind,
    dimension: usize,
}

impl<'f> Batch<'f> {
    /// Allocates memory for a batch of this kind. It has room for at least `unit` points, which
    /// must stay together, and for at most `units` times as many.
    #[must_use]
    pub fn new(metric: &'f dyn AnyBatches, kind: Kind, unit: usize, units: usize) -> Self {
        let registers = metric.registers(kind, unit, units);
        Self { registers, metric, kind, dimension: metric.dimension() }
    }

    /// Returns the greatest number of lanes.
    #[must_use]
    pub fn lanes(&self) -> usize {
        self.registers.lanes()
    }

    /// Returns the points and vectors of the first `count` lanes for writing, in a dimension that is
    /// known at compile time.
    ///
    /// # Panics
    ///
    /// If `count` exceeds [`lanes`](Self::lanes), or if there are not `2 D` registers.
    #[inline(always)]
    pub fn inputs<const D: usize>(&mut self, count: usize) -> Inputs<'_, D> {
        let [mut x, mut d] = self.registers.inputs();
        // This tells the compiler that all rows have the same length.
        for i in 0..D {
            x[i] = &mut std::mem::take(&mut x[i])[..count];
            d[i] = &mut std::mem::take(&mut d[i])[..count];
        }
        Inputs { x, d }
    }

    /// Returns coordinate `i` of the points, and of the vectors, of all lanes, for writing.
    ///
    /// # Panics
    ///
    /// If there is no such coordinate.
    #[inline]
    pub fn input(&mut self, i: usize) -> [&mut [f64]; 2] {
        self.registers.input_rows(self.dimension, i)
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
        self.registers.repeat(2 * self.dimension, count, used);
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
}
