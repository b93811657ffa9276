//! Side by side.
use nalgebra::SVector;
use tautline_discretizations::{PointSequence, Rule};
use tautline_formula::Batches;
use tautline_metrics::Metric;
use tautline_sets::ClosedSet;

use crate::{Workspace, newton::{magnitude::Magnitude, sweep::sweep, sweep_batches::sweep_batches}};

fn about<const D: usize>(metric: &impl Metric<D>, sequence: &PointSequence<D>) -> Magnitude {
    let points = sequence.points();
    let mean_gram = metric.gram(&points[points.len() / 2]).trace() / D as f64;
    Magnitude { energy: mean_gram * (sequence.last() - sequence.first()).norm_squared(), mean_gram }
}

/// Energy, decrement and residual, by the compiled formula.
#[inline(never)]
pub fn compiled<R: Rule, const D: usize>(rule: R, metric: &impl Metric<D>, ends: [&dyn ClosedSet<D>; 2], sequence: &PointSequence<D>, at_once: bool, memory: Option<(&mut Workspace<D>, &mut Vec<SVector<f64, D>>)>) -> Option<[f64; 3]> {
    let (workspace, eliminated) = match memory { Some((w, e)) => (Some(w), Some(e)), None => (None, None) };
    let memory = workspace.map(|w| &mut w.factorization).zip(eliminated);
    let s = sweep(rule, metric, ends, sequence, about(metric, sequence), at_once, memory)?;
    let s = s.stationarity;
    Some([s.magnitude.energy, s.decrement, s.residual])
}

/// The same by batches.
#[inline(never)]
pub fn batches<R: Rule, const D: usize>(_: R, metric: &impl Metric<D>, batches: &dyn Batches<D>, ends: [&dyn ClosedSet<D>; 2], sequence: &PointSequence<D>, at_once: bool, memory: Option<(&mut Workspace<D>, &mut Vec<SVector<f64, D>>)>) -> Option<[f64; 3]> {
    let (workspace, eliminated) = match memory { Some((w, e)) => (Some(w), Some(e)), None => (None, None) };
    let memory = workspace.map(|w| &mut w.factorization).zip(eliminated);
    let s = sweep_batches(R::NODES, batches, ends, sequence, about(metric, sequence), at_once, memory)?;
    let s = s.stationarity;
    Some([s.magnitude.energy, s.decrement, s.residual])
}
