//! `QuadraticModel`: a discrete energy to second order, with its value, gradient and
//! block-tridiagonal Hessian.

use nalgebra::{SMatrix, SVector};
use tautline_formula::{AnyBatches, Kind, Plain};
use tautline_metrics::Metric;

use crate::{
    BlockTridiagonal, ChordBatch, ChordModels, Node, PointSequence, Rule,
    compensated_sum::CompensatedSum,
};

/// The discrete energy of a point sequence, with its first and second derivatives with respect to
/// the `N + 1` points. It is the sum of the [`ChordModel`](crate::ChordModel)s of the chords.
///
/// Vectors and blocks follow one another, blocks column by column.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct QuadraticModel {
    /// The dimension `D` of the space.
    pub dimension: usize,
    /// The discrete energy, in `m²`.
    pub energy: f64,
    /// The derivatives of the energy with respect to the coordinates of the `N + 1` points, point by
    /// point, in `m²/ℓ`.
    pub slopes: Vec<f64>,
    /// The `N + 1` diagonal blocks of the second derivatives of the energy, in `m²/ℓ²`.
    pub diagonal: Vec<f64>,
    /// The `N` blocks above the diagonal.
    pub upper: Vec<f64>,
    /// The mean of `tr H / D` over the nodes, in `m²/ℓ²`. It measures the size of the metric.
    pub mean_gram: f64,
}

impl QuadraticModel {
    /// Expands the discrete energy of `rule` about `sequence`. The result is NaN if the metric is
    /// NaN.
    #[must_use]
    pub fn new<const D: usize>(
        rule: Rule,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Self {
        let mut model = Self::default();
        model.expand_by_batches(rule.nodes(), &Plain::new(metric), sequence);
        model
    }

    /// Returns the gradients of the energy with respect to each of the `N + 1` points of `R^D`, in
    /// `m²/ℓ`.
    #[must_use]
    pub fn gradient<const D: usize>(&self) -> &[SVector<f64, D>] {
        bytemuck::cast_slice(&self.slopes)
    }

    /// Returns the second derivatives of the energy in `R^D`, in `m²/ℓ²`.
    #[must_use]
    pub fn hessian<const D: usize>(&self) -> BlockTridiagonal<D> {
        let blocks = |list: &[f64]| bytemuck::cast_slice(list).to_vec();
        BlockTridiagonal { diagonal: blocks(&self.diagonal), upper: blocks(&self.upper) }
    }

    /// Expands like [`new`](Self::new), for a metric that is evaluated in batches. The result
    /// overwrites this model and uses its memory.
    pub fn expand_by_batches<const D: usize>(
        &mut self,
        nodes: &'static [Node],
        metric: &dyn AnyBatches,
        sequence: &PointSequence<D>,
    ) {
        let (dimension, points) = (metric.dimension(), sequence.coordinates());
        let n = sequence.n().get();
        self.dimension = dimension;
        self.slopes.resize(points.len(), 0.0);
        self.diagonal.resize(points.len() * dimension, 0.0);
        self.upper.resize(n * dimension * dimension, 0.0);
        let batch = ChordBatch::new(metric, Kind::Contraction, nodes, n as f64, n);
        // Up to three dimensions a model stays in registers.
        let (energy, trace) = match dimension {
            1 => self.expand::<1>(batch, points, n),
            2 => self.expand::<2>(batch, points, n),
            3 => self.expand::<3>(batch, points, n),
            4 => self.expand::<4>(batch, points, n),
            5 => self.expand::<5>(batch, points, n),
            6 => self.expand::<6>(batch, points, n),
            _ => self.expand_any(batch, points, n),
        };
        self.energy = energy.value();
        let factor = n as f64;
        self.mean_gram = trace / (factor * factor * dimension as f64);
    }

    /// Sets the derivatives, and returns the energy and the trace.
    fn expand<const D: usize>(
        &mut self,
        mut batch: ChordBatch<'_>,
        points: &[f64],
        n: usize,
    ) -> (CompensatedSum, f64) {
        let (mut energy, mut trace) = (CompensatedSum::default(), 0.0);
        let gradient: &mut [SVector<f64, D>] = bytemuck::cast_slice_mut(&mut self.slopes);
        let diagonal: &mut [SMatrix<f64, D, D>] = bytemuck::cast_slice_mut(&mut self.diagonal);
        let upper: &mut [SMatrix<f64, D, D>] = bytemuck::cast_slice_mut(&mut self.upper);
        // What the previous chord contributes to the point that it shares with this one.
        let mut carried = (SVector::<f64, D>::zeros(), SMatrix::<f64, D, D>::zeros());
        for begin in (0..n).step_by(batch.capacity()) {
            let chords = begin..n.min(begin + batch.capacity());
            batch.evaluate(&points[chords.start * D..(chords.end + 1) * D]);
            let models = batch.singles().first(chords.len());
            let is_midpoint = models.is_midpoint();
            for k in chords {
                let lane = k - begin;
                let chord =
                    if is_midpoint { models.model_at_midpoint(lane) } else { models.model(lane) };
                energy.add(chord.energy);
                trace += chord.trace;
                gradient[k] = carried.0 + chord.gradient[0];
                diagonal[k] = carried.1 + chord.hessian[0];
                upper[k] = chord.coupling;
                carried = (chord.gradient[1], chord.hessian[1]);
            }
        }
        (gradient[n], diagonal[n]) = carried;
        (energy, trace)
    }

    /// Does the same in any dimension.
    fn expand_any(
        &mut self,
        mut batch: ChordBatch<'_>,
        points: &[f64],
        n: usize,
    ) -> (CompensatedSum, f64) {
        let d = self.dimension;
        let (mut energy, mut trace) = (CompensatedSum::default(), 0.0);
        self.slopes.fill(0.0);
        self.diagonal.fill(0.0);
        let mut models = ChordModels::default();
        for begin in (0..n).step_by(batch.capacity()) {
            let chords = begin..n.min(begin + batch.capacity());
            batch.evaluate(&points[chords.start * d..(chords.end + 1) * d]);
            batch.assemble(0, chords.len(), &mut models);
            for k in chords {
                let chord = k - begin;
                energy.add(models.energy(chord));
                trace += models.trace(chord);
                for end in 0..2 {
                    let slopes = &mut self.slopes[(k + end) * d..][..d];
                    slopes.iter_mut().zip(models.gradient(end, chord)).for_each(|(s, g)| *s += g);
                    let block = &mut self.diagonal[(k + end) * d * d..][..d * d];
                    let hessian = models.hessian(end, chord);
                    for j in 0..d {
                        for i in j..d {
                            block[j * d + i] += hessian[j * d + i];
                            block[i * d + j] = block[j * d + i];
                        }
                    }
                }
                let (upper, lower) = (&mut self.upper[k * d * d..][..d * d], models.lower(chord));
                for j in 0..d {
                    for i in 0..d {
                        upper[j * d + i] = lower[i * d + j];
                    }
                }
            }
        }
        (energy, trace)
    }
}
