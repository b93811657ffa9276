//! Mistakes in the solver.

use tautline::{
    Curvature, Ends, Interpolation, Metric, Minimum, Options, PointSequence, Rule, SolveError,
    Starts, Stop, Workspace, minimise, minimise_by_batches,
};

use super::{Mutant, formula, programs::mistaken_rule};

pub(crate) fn minimise_with<const D: usize>(
    mutant: Mutant,
    rule: Rule,
    metric: &impl Metric<D>,
    ends: &Ends<D>,
    n: usize,
    options: &Options<D>,
) -> Result<Minimum<D>, SolveError> {
    let genuine = |n| minimise(metric, ends, rule, n, options);
    let believed = |mut minimum: Minimum<D>| {
        (minimum.stop, minimum.curvature) = (Stop::Converged, Curvature::PositiveDefinite);
        minimum
    };
    let with = |sequence: PointSequence<D>, minimum: Minimum<D>| {
        let mut minimum = believed(minimum);
        (minimum.energy, minimum.sequence) = (rule.energy(metric, &sequence), sequence);
        minimum
    };
    match mutant {
        Mutant::RulesExchanged | Mutant::TrueTrapezoid => {
            minimise(metric, ends, mistaken_rule(mutant, rule), n, options)
        }
        Mutant::StopsEarly => {
            let once = Options { iterations: 1, ..options.clone() };
            minimise(metric, ends, rule, n, &once).map(believed)
        }
        Mutant::NotOptimised => {
            genuine(n).map(|minimum| with(straightened(&minimum.sequence), minimum))
        }
        Mutant::NotRefined => {
            genuine(n.div_ceil(2)).map(|minimum| with(resampled(&minimum.sequence, n), minimum))
        }
        Mutant::LocalForGlobal => {
            let straight = straightened(&genuine(n)?.sequence);
            let one = Options { starts: Starts::Only(vec![straight]), ..options.clone() };
            minimise(metric, ends, rule, n, &one).map(believed)
        }
        Mutant::EndRelaxed => {
            genuine(n).map(|minimum| with(first_point_moved(&minimum.sequence, 1e-6), minimum))
        }
        _ => match formula::batches(mutant, metric) {
            Some(batches) => {
                minimise_by_batches(&mut Workspace::default(), &*batches, ends, rule, n, options)
            }
            None => genuine(n),
        },
    }
}

/// Returns equidistant points between the ends of a sequence.
fn straightened<const D: usize>(sequence: &PointSequence<D>) -> PointSequence<D> {
    PointSequence::straight(*sequence.first(), *sequence.last(), sequence.n().get())
        .expect("finite ends")
}

/// Returns `n + 1` points on the interpolation of a sequence, equally spaced in time.
fn resampled<const D: usize>(sequence: &PointSequence<D>, n: usize) -> PointSequence<D> {
    let curve = Interpolation::new(sequence);
    let points = (0..=n).map(|k| curve.at(k as f64 / n as f64)).collect();
    PointSequence::new(points).expect("finite")
}

/// Moves the first point along the first axis by a fraction of the size of the sequence.
fn first_point_moved<const D: usize>(
    sequence: &PointSequence<D>,
    fraction: f64,
) -> PointSequence<D> {
    let mut points = sequence.points().to_vec();
    let size = points[0].norm() + sequence.k3();
    points[0][0] += fraction * size;
    PointSequence::new(points).expect("finite")
}
