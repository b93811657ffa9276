//! `Sweep`: a look at a point sequence, by elimination from its first point to its last.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{ChordModel, CompensatedSum, PointSequence, Rule};
use tautline_metrics::Metric;
use tautline_sets::ClosedSet;

use crate::{
    end_frame::{EndFrame, EndRow},
    factorization::{Factorization, Pivot, Regulariser},
    magnitude::Magnitude,
    residual::Residual,
    rounding::margin,
    stationarity::Stationarity,
};

/// What one pass over the chords finds out where the Hessian is positive definite.
#[derive(Clone, Debug)]
pub(crate) struct Sweep<const D: usize> {
    pub(crate) stationarity: Stationarity,
    /// The coordinates of the ends in which their blocks are eliminated.
    pub(crate) frames: [EndFrame<D>; 2],
    /// That of the frames.
    pub(crate) tau: f64,
}

/// Sums up and eliminates in one pass; `None` if the Hessian, less the [`margin`], is not positive
/// definite or not finite.
///
/// Each block is eliminated as soon as the chords on both sides of its point are known, so that
/// neither gradient nor Hessian is ever stored. The pivots and the right hand side after elimination,
/// which is all that a Newton step needs, are written to `memory`, if there is some. `about` is what
/// is known of the magnitude beforehand: it scales the margin and what is taken for a chord at the
/// ends.
pub(crate) fn sweep<R: Rule, const D: usize>(
    rule: R,
    metric: &impl Metric<D>,
    ends: [&dyn ClosedSet<D>; 2],
    sequence: &PointSequence<D>,
    about: Magnitude,
    mut memory: Option<(&mut Factorization<D>, &mut Vec<SVector<f64, D>>)>,
) -> Option<Sweep<D>> {
    // Not a generic parameter: a formula is inlined here once, and would not be twice.
    let mut keep = |pivot, z| {
        if let Some((factorization, eliminated)) = &mut memory {
            factorization.push(pivot);
            eliminated.push(z);
        }
    };
    let count = sequence.n().get();
    let n = count as f64;
    let points = sequence.points();
    let regulariser = Regulariser { n, weight: -margin(count) * about.mean_gram };
    let identity = SMatrix::<f64, D, D>::identity();
    let beside = identity * regulariser.upper();
    let tau = about.tau(count);
    let (mut energy, mut trace) = (CompensatedSum::default(), 0.0);
    let mut is_metric = true;
    let mut square = 0.0;
    let mut residual = Residual::new(count, about);
    let mut first = None;
    // What the chord before leaves for the point between, and what is eliminated of it.
    let mut block = identity * regulariser.diagonal(1.0);
    let (mut right, mut carried) = (SVector::<f64, D>::zeros(), SVector::<f64, D>::zeros());
    for (k, (x, d)) in sequence.chords().enumerate() {
        let chord = ChordModel::new(rule, metric, x, &d, n);
        energy.add(chord.energy);
        trace += chord.trace;
        is_metric &= chord.is_metric;
        let mut lower = chord.coupling.transpose() + beside;
        let last = k + 1 == count;
        let shift = regulariser.diagonal(if last { 1.0 } else { 2.0 });
        let mut next = chord.hessian[1] + identity * shift;
        let mut next_right = -chord.gradient[1];
        block += chord.hessian[0];
        right -= chord.gradient[0];
        residual.push(k, &(carried + chord.gradient[0]));
        carried = chord.gradient[1];
        if k == 0 {
            let frame = EndFrame::new(ends[0], x, &chord.gradient[0], tau);
            // It has the force on the end.
            let right_of_end = SVector::zeros();
            let coupling = lower.transpose();
            let row = EndRow { block, coupling, right: right_of_end, beside: next_right };
            let row = frame.enter(row, tau);
            (block, right, next_right) = (row.block, row.right, row.beside);
            lower = row.coupling.transpose();
            first = Some(frame);
        }
        let mut end = None;
        if last {
            residual.push(count, &carried);
            let frame = EndFrame::new(ends[1], &points[count], &chord.gradient[1], tau);
            let row = EndRow {
                block: next,
                coupling: lower,
                right: next_right + chord.gradient[1],
                beside: right,
            };
            let row = frame.enter(row, tau);
            (next, next_right, right) = (row.block, row.right, row.beside);
            lower = row.coupling;
            end = Some(frame);
        }
        let pivot = Pivot::new(&block, &lower, &mut next)?;
        let [y, z] = pivot.diagonal.forward(right);
        square += y.dot(&z);
        if let Some(lower) = &pivot.lower {
            next_right -= lower * y;
        }
        keep(pivot, z);
        (block, right) = (next, next_right);
        if let (Some(first), Some(end)) = (&first, end) {
            let pivot = Pivot::last(&block)?;
            let [y, z] = pivot.diagonal.forward(right);
            square += y.dot(&z);
            keep(pivot, z);
            let mean_gram = trace / (n * n * D as f64);
            let magnitude = Magnitude { energy: energy.value(), mean_gram };
            let (residual, residual_floor) = residual.value(ends, sequence, magnitude);
            let decrement = 0.5 * square;
            let stationarity =
                Stationarity { magnitude, is_metric, decrement, residual, residual_floor };
            return Some(Sweep { stationarity, frames: [first.clone(), end], tau });
        }
    }
    None
}
