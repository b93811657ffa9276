//! `Plain`: batches evaluated with the compiled formula, lane by lane.

use std::sync::OnceLock;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, is_gram, norm_squared};

use crate::{
    batch::{
        AnyBatches, Batches, Kind, Layout,
        contraction::{Contraction, momentum},
    },
    program::{Register, Registers},
};

/// Batches evaluated with the compiled formula, one point after another. They serve formulas that
/// cannot be recorded, and comparisons.
#[derive(Debug)]
pub struct Plain<M, const D: usize> {
    metric: M,
    layouts: [OnceLock<Layout>; 4],
}

impl<M: Metric<D>, const D: usize> Plain<M, D> {
    /// Wraps a metric.
    #[must_use]
    pub fn new(metric: M) -> Self {
        Self { metric, layouts: Default::default() }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        &self.metric
    }
}

/// Returns the rows of a kind, which are contiguous. The last row is positive if `H` is a Gram
/// matrix.
pub(crate) fn contiguous(kind: Kind, dimension: usize) -> Layout {
    let mut next = 2 * dimension;
    let mut take = |count: usize| -> Vec<Register> {
        let rows = next..next + count;
        next = rows.end;
        rows.map(|row| row as Register).collect()
    };
    let square = dimension * dimension;
    let mut layout = Layout::default();
    match kind {
        Kind::Square => layout.square = take(1),
        Kind::Checked => {
            layout.square = take(1);
            layout.positive = take(1);
        }
        Kind::Momentum => {
            layout.square = take(1);
            layout.momentum = take(dimension);
            layout.slope = take(dimension);
            layout.positive = take(1);
        }
        Kind::Contraction => {
            layout.gram = take(square);
            layout.slope = take(dimension);
            layout.turn = take(square);
            layout.bend = take(square);
            layout.positive = take(1);
        }
    }
    layout
}

/// Returns the number of rows of a layout, including the points and vectors.
pub(crate) fn rows(layout: &Layout, dimension: usize) -> usize {
    let Layout { square, momentum, slope, gram, turn, bend, positive, .. } = layout;
    let all = [square, momentum, slope, gram, turn, bend, positive];
    2 * dimension + all.into_iter().map(Vec::len).sum::<usize>()
}

/// The number of lanes: few enough for a cache in many dimensions, and enough for a chord in one
/// pass.
const LANES: usize = 16;

impl<M: Metric<D>, const D: usize> Batches<D> for Plain<M, D> {}

impl<M: Metric<D>, const D: usize> AnyBatches for Plain<M, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        let h = self.metric.gram(&SVector::from_column_slice(x));
        gram.copy_from_slice(h.as_slice());
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.layouts[kind as usize].get_or_init(|| contiguous(kind, D))
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        let lanes = unit.saturating_mul(units).clamp(unit, unit.max(LANES));
        Registers::empty(rows(self.layout(kind), D), lanes)
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        evaluate(&self.metric, self.layout(kind), kind, registers);
    }
}

/// A metric at one point, behind a pointer.
trait AtPlace<const D: usize> {
    fn square(&self, x: &SVector<f64, D>, d: &SVector<f64, D>) -> f64;
    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D>;
    fn momentum(
        &self,
        x: &SVector<f64, D>,
        d: &SVector<f64, D>,
    ) -> (SMatrix<f64, D, D>, SVector<f64, D>);
    fn contraction(&self, x: &SVector<f64, D>, d: &SVector<f64, D>) -> Contraction<D>;
}

impl<M: Metric<D>, const D: usize> AtPlace<D> for M {
    fn square(&self, x: &SVector<f64, D>, d: &SVector<f64, D>) -> f64 {
        norm_squared(self, x, d)
    }

    fn gram(&self, x: &SVector<f64, D>) -> SMatrix<f64, D, D> {
        Metric::gram(self, x)
    }

    fn momentum(
        &self,
        x: &SVector<f64, D>,
        d: &SVector<f64, D>,
    ) -> (SMatrix<f64, D, D>, SVector<f64, D>) {
        momentum(self, x, d)
    }

    fn contraction(&self, x: &SVector<f64, D>, d: &SVector<f64, D>) -> Contraction<D> {
        Contraction::new(self, x, d)
    }
}

/// This function is compiled once for each dimension.
fn evaluate<const D: usize>(
    metric: &dyn AtPlace<D>,
    layout: &Layout,
    kind: Kind,
    registers: &mut Registers,
) {
    for lane in 0..registers.count() {
        let (x, d) = registers.input::<D>(lane);
        let sign = |registers: &mut Registers, is_metric: bool| {
            registers.set_all(&layout.positive, lane, &[if is_metric { 1.0 } else { -1.0 }]);
        };
        match kind {
            Kind::Square => {
                let square = metric.square(&x, &d);
                registers.set_all(&layout.square, lane, &[square]);
            }
            Kind::Checked => {
                let h = metric.gram(&x);
                registers.set_all(&layout.square, lane, &[d.dot(&(h * d))]);
                sign(registers, is_gram(&h));
            }
            Kind::Momentum => {
                let (h, g) = metric.momentum(&x, &d);
                let hd = h * d;
                registers.set_all(&layout.square, lane, &[d.dot(&hd)]);
                registers.set_all(&layout.momentum, lane, hd.as_slice());
                registers.set_all(&layout.slope, lane, g.as_slice());
                sign(registers, is_gram(&h));
            }
            Kind::Contraction => {
                let Contraction { h, g, p, q, is_metric } = metric.contraction(&x, &d);
                // The upper half is used; it equals the lower half up to rounding.
                let h = SMatrix::<f64, D, D>::from_fn(|i, j| h[(i.min(j), i.max(j))]);
                registers.set_all(&layout.gram, lane, h.as_slice());
                registers.set_all(&layout.slope, lane, g.as_slice());
                registers.set_all(&layout.turn, lane, p.transpose().as_slice());
                registers.set_all(&layout.bend, lane, q.as_slice());
                sign(registers, is_metric);
            }
        }
    }
}
