//! Batches of a black box: all points of a batch are evaluated in one call.

use std::sync::OnceLock;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, is_gram};

use super::{BlackBox, differences::Derivatives};
use crate::{
    batch::{AnyBatches, Batches, Kind, Layout, contiguous, rows},
    program::Registers,
};

/// A black box, ready to be evaluated at many points in one call.
#[derive(Debug)]
pub struct BlackBoxBatches<const D: usize> {
    metric: BlackBox<D>,
    layouts: [OnceLock<Layout>; 4],
}

/// The greatest number of lanes. A call from another language costs as much as some dozen points.
const LANES: usize = 512;

impl<const D: usize> BlackBoxBatches<D> {
    /// Wraps a metric.
    #[must_use]
    pub fn new(metric: BlackBox<D>) -> Self {
        Self { metric, layouts: Default::default() }
    }
}

impl<const D: usize> Batches<D> for BlackBoxBatches<D> {}

impl<const D: usize> AnyBatches for BlackBoxBatches<D> {
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
        let lanes = registers.count();
        let inputs: Vec<_> = (0..lanes).map(|lane| registers.input::<D>(lane)).collect();
        let points: Vec<f64> = inputs.iter().flat_map(|(x, _)| x.iter().copied()).collect();
        let order = match kind {
            Kind::Square | Kind::Checked => 0,
            Kind::Momentum => 1,
            Kind::Contraction => 2,
        };
        let Derivatives { gram, first, second } = self.metric.derivatives(&points, order);
        let layout = self.layout(kind);
        for (lane, (_, d)) in inputs.iter().enumerate() {
            let gram = &gram[lane * D * D..][..D * D];
            let full = SMatrix::<f64, D, D>::from_row_slice(gram);
            let h = SMatrix::<f64, D, D>::from_fn(|i, j| full[(i.min(j), i.max(j))]);
            let hd = h * d;
            registers.set_all(&layout.square, lane, &[d.dot(&hd)]);
            registers.set_all(&layout.momentum, lane, hd.as_slice());
            registers.set_all(&layout.gram, lane, h.as_slice());
            let is_metric = if is_gram(&full) { 1.0 } else { -1.0 };
            registers.set_all(&layout.positive, lane, &[is_metric]);
            if order == 0 {
                continue;
            }
            let first = &first[lane * D * D * D..][..D * D * D];
            // The half i ≤ j is used, as everywhere.
            let turn = |i: usize, k: usize| -> f64 {
                let entry = |j: usize| i.min(j) * D + i.max(j);
                (0..D).map(|j| first[entry(j) * D + k] * d[j]).sum()
            };
            let p = SMatrix::<f64, D, D>::from_fn(turn);
            let g = p.transpose() * d;
            registers.set_all(&layout.slope, lane, g.as_slice());
            registers.set_all(&layout.turn, lane, p.transpose().as_slice());
            if order == 2 {
                let second = &second[lane * D * D * D * D..][..D * D * D * D];
                let bend = |k: usize, l: usize| -> f64 {
                    let of = |i: usize, j: usize| second[((i * D + j) * D + k) * D + l];
                    let weight = |i: usize, j: usize| if i == j { 1.0 } else { 2.0 } * d[i] * d[j];
                    (0..D)
                        .flat_map(|i| (i..D).map(move |j| (i, j)))
                        .map(|(i, j)| weight(i, j) * of(i, j))
                        .sum()
                };
                let q = SMatrix::<f64, D, D>::from_fn(|k, l| bend(k.min(l), k.max(l)));
                registers.set_all(&layout.bend, lane, q.as_slice());
            }
        }
    }
}
