//! Batches of a black box: all points of a batch are evaluated in one call.

use std::sync::OnceLock;

use tautline_metrics::are_gram;
use tautline_scalar::ANY;

use super::{BlackBox, differences::Derivatives};
use crate::{
    batch::{AnyBatches, Kind, Layout, contiguous, rows},
    program::Registers,
};

/// A black box, ready to be evaluated at many points in one call.
#[derive(Debug)]
pub struct BlackBoxBatches {
    metric: BlackBox<ANY>,
    layouts: [OnceLock<Layout>; 4],
}

/// The greatest number of lanes. A call from another language costs as much as some dozen points.
const LANES: usize = 512;

/// The greatest number of second derivatives of a batch, of which a point has `D⁴`: 64 MB, unless eight
/// points have more. Differences take twice as many values.
const SECOND_DERIVATIVES: usize = 1 << 23;

impl BlackBoxBatches {
    /// Wraps a metric.
    #[must_use]
    pub fn new(metric: BlackBox<ANY>) -> Self {
        Self { metric, layouts: Default::default() }
    }
}

impl AnyBatches for BlackBoxBatches {
    fn dimension(&self) -> usize {
        self.metric.dimension()
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        let (d, rows) = (self.dimension(), self.metric.gram_at(x));
        for (place, entry) in gram.iter_mut().enumerate() {
            *entry = rows[place % d * d + place / d];
        }
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.layouts[kind as usize].get_or_init(|| contiguous(kind, self.dimension()))
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        let second = self.dimension().pow(if self.metric.values.is_along() { 2 } else { 4 });
        let most = LANES.min(SECOND_DERIVATIVES / second);
        let lanes = unit.saturating_mul(units).clamp(unit, unit.max(most));
        Registers::empty(rows(self.layout(kind), self.dimension()), lanes)
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        let (n, lanes) = (self.dimension(), registers.count());
        let input = |lane: usize, k: usize| registers.row(k as u32)[lane];
        let inputs = |from: usize| -> Vec<f64> {
            let places = (0..lanes).flat_map(|lane| (from..from + n).map(move |k| (lane, k)));
            places.map(|(lane, k)| input(lane, k)).collect()
        };
        let (points, vectors) = (inputs(0), inputs(n));
        let order = match kind {
            Kind::Square | Kind::Checked => 0,
            Kind::Momentum => 1,
            Kind::Contraction => 2,
        };
        let along = self.metric.along(&points, &vectors, order);
        let order = if along.is_some() { 0 } else { order };
        let Derivatives { gram, first, second } = self.metric.derivatives(&points, order);
        let layout = self.layout(kind);
        for lane in 0..lanes {
            let d = &vectors[lane * n..][..n];
            let full = &gram[lane * n * n..][..n * n];
            // The half i ≤ j is used, as everywhere.
            let half = |i: usize, j: usize| i.min(j) * n + i.max(j);
            let sum = |of: &dyn Fn(usize) -> f64| (0..n).map(of).fold(0.0, |sum, term| sum + term);
            let hd: Vec<f64> = (0..n).map(|i| sum(&|j| full[half(i, j)] * d[j])).collect();
            registers.set_all(&layout.square, lane, &[sum(&|i| d[i] * hd[i])]);
            registers.set_all(&layout.momentum, lane, &hd);
            let h: Vec<f64> = (0..n * n).map(|place| full[half(place / n, place % n)]).collect();
            registers.set_all(&layout.gram, lane, &h);
            let is_metric = if are_gram(&transposed(full, n), n) { 1.0 } else { -1.0 };
            registers.set_all(&layout.positive, lane, &[is_metric]);
            if let Some(along) = &along {
                let turn = &along.first[lane * n * n..][..n * n];
                registers.set_all(&layout.slope, lane, &slope(turn, d));
                registers.set_all(&layout.turn, lane, turn);
                if let Some(bend) = along.second.get(lane * n * n..(lane + 1) * n * n) {
                    registers.set_all(&layout.bend, lane, bend);
                }
            }
            if order == 0 {
                continue;
            }
            let first = &first[lane * n * n * n..][..n * n * n];
            // Pᵢₖ, row by row.
            let turn: Vec<f64> = (0..n * n)
                .map(|place| sum(&|j| first[half(place / n, j) * n + place % n] * d[j]))
                .collect();
            registers.set_all(&layout.slope, lane, &slope(&turn, d));
            registers.set_all(&layout.turn, lane, &turn);
            if order == 2 {
                let second = &second[lane * n * n * n * n..][..n * n * n * n];
                let bend = |k: usize, l: usize| -> f64 {
                    let of = |i: usize, j: usize| second[((i * n + j) * n + k) * n + l];
                    let weight = |i: usize, j: usize| if i == j { 1.0 } else { 2.0 } * d[i] * d[j];
                    (0..n)
                        .flat_map(|i| (i..n).map(move |j| (i, j)))
                        .map(|(i, j)| weight(i, j) * of(i, j))
                        .sum()
                };
                let q: Vec<f64> = (0..n * n)
                    .map(|place| bend((place % n).min(place / n), (place % n).max(place / n)))
                    .collect();
                registers.set_all(&layout.bend, lane, &q);
            }
        }
    }
}

/// Returns `Gₖ = Σᵢ dᵢ Pᵢₖ`.
fn slope(turn: &[f64], d: &[f64]) -> Vec<f64> {
    let rows = || d.iter().zip(turn.chunks(d.len()));
    (0..d.len()).map(|k| rows().fold(0.0, |sum, (d, row)| sum + row[k] * d)).collect()
}

/// Returns the transpose of a matrix.
fn transposed(a: &[f64], n: usize) -> Vec<f64> {
    (0..n * n).map(|place| a[place % n * n + place / n]).collect()
}
