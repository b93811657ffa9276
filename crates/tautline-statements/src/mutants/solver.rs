//! The mistakes of the mutants that are about the solver.

use tautline::{
    Curvature, Ends, Interpolation, LeftEndpoint, Metric, Minimum, Options, PointSequence, Rule,
    SolveError, Starts, Stop, Trapezoidal, TrueTrapezoid, minimise,
};

use super::{Mutant, formula, programs::is_trapezoidal};

pub(crate) fn minimise_with<R: Rule, const D: usize>(
    mutant: Mutant,
    rule: R,
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
    let with = |minimum: Minimum<D>, sequence: PointSequence<D>| {
        let mut minimum = believed(minimum);
        minimum.energy = rule.energy(metric, &sequence);
        minimum.sequence = sequence;
        minimum
    };
    match mutant {
        Mutant::RulesExchanged if is_trapezoidal::<R>() => {
            minimise(metric, ends, LeftEndpoint, n, options)
        }
        Mutant::RulesExchanged => minimise(metric, ends, Trapezoidal, n, options),
        Mutant::TrueTrapezoid if is_trapezoidal::<R>() => {
            minimise(metric, ends, TrueTrapezoid, n, options)
        }
        Mutant::StopsEarly => {
            let once = Options { iterations: 1, ..options.clone() };
            minimise(metric, ends, rule, n, &once).map(believed)
        }
        Mutant::NotOptimised => {
            let minimum = genuine(n)?;
            let straight = straightened(&minimum.sequence);
            Ok(with(minimum, straight))
        }
        Mutant::NotRefined => {
            let minimum = genuine(n.div_ceil(2))?;
            let finer = resampled(&minimum.sequence, n);
            Ok(with(minimum, finer))
        }
        Mutant::LocalForGlobal => {
            let straight = straightened(&genuine(n)?.sequence);
            let one = Options { starts: Starts::Only(vec![straight]), ..options.clone() };
            minimise(metric, ends, rule, n, &one).map(believed)
        }
        Mutant::EndRelaxed => {
            let minimum = genuine(n)?;
            let moved = first_point_moved(&minimum.sequence, 1e-6);
            Ok(with(minimum, moved))
        }
        _ => {
            let misread = formula::minimise(mutant, rule, metric, ends, n, options);
            misread.unwrap_or_else(|| genuine(n))
        }
    }
}

/// Equidistant points between the ends of a sequence.
fn straightened<const D: usize>(sequence: &PointSequence<D>) -> PointSequence<D> {
    PointSequence::straight(*sequence.first(), *sequence.last(), sequence.n().get())
        .expect("finite ends")
}

/// `n + 1` points on the interpolation of a sequence, at equal times.
fn resampled<const D: usize>(sequence: &PointSequence<D>, n: usize) -> PointSequence<D> {
    let curve = Interpolation::new(sequence);
    let points = (0..=n).map(|k| curve.at(k as f64 / n as f64)).collect();
    PointSequence::new(points).expect("finite")
}

/// The sequence with its first point moved along the first axis, by a fraction of its size.
fn first_point_moved<const D: usize>(
    sequence: &PointSequence<D>,
    fraction: f64,
) -> PointSequence<D> {
    let mut points = sequence.points().to_vec();
    let size = points[0].norm() + sequence.k3();
    points[0][0] += fraction * size;
    PointSequence::new(points).expect("finite")
}
