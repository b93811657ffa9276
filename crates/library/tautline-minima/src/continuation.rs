//! Local minima that are followed through a family of metrics.

use nalgebra::SVector;
use tautline::{
    Ends, Metric, Minimum, Options, PointSequence, Problem, Rule, SolveError, Starts, TautLine,
    are_apart,
};

/// The least step to either side of a followed minimum, as a part of the extent of the curve.
const LEAST_STEP: f64 = 0.05;

/// A local minimum that was followed to the last metric of a family.
#[derive(Clone, Debug)]
pub struct Branch<M: Metric<D>, const D: usize> {
    /// The line under the last metric.
    pub line: TautLine<M, D>,
    /// The parameter from which on it was known: where it split off another one, or the first.
    pub since: f64,
}

/// Follows local minima through a family of metrics, from the first parameter to the last, and returns
/// those of the last metric, shortest first, at most `most` of them.
///
/// A bump that rises under a curve makes it unstable: where it was there is a saddle, with a minimum on
/// either side. Therefore each minimum is followed from where it was, and also from its last step
/// continued and turned round, which leads to the other side. Of minima along the same curve one is
/// followed. At least one is followed, also if `most` is 0.
///
/// # Errors
///
/// Those of [`Problem::solve`] for the first metric, and [`SolveError::NoStart`] without parameters. A
/// branch along which a later metric cannot be solved ends; if all do, the error of the last is returned.
/// Without a minimum under the last metric the list is empty.
pub fn follow<M: Metric<D>, const D: usize>(
    family: impl Fn(f64) -> M,
    parameters: &[f64],
    ends: &Ends<D>,
    rule: Rule,
    n: usize,
    most: usize,
) -> Result<Vec<Branch<M, D>>, SolveError> {
    let Some((&first, later)) = parameters.split_first() else { return Err(SolveError::NoStart) };
    let line = Problem::new(family(first), ends.clone()).solve(rule, n)?;
    let others = line.other_minima();
    let mut branches: Vec<Branch<M, D>> = Vec::new();
    for line in std::iter::once(line).chain(others) {
        keep(&mut branches, Branch { line, since: first });
    }
    branches.truncate(most.max(1));
    for &parameter in later {
        let problem = Problem::new(family(parameter), ends.clone());
        let mut failure = SolveError::NoStart;
        let mut next = Vec::new();
        let mut from = |start: PointSequence<D>, since: f64| {
            let starts = Starts::OnTheGrid(vec![start]);
            match problem.solve_with(rule, n, &Options { starts, ..Options::default() }) {
                Ok(line) => {
                    let sequence = line.sequence().clone();
                    keep(&mut next, Branch { line, since });
                    Some(sequence)
                }
                Err(error) => {
                    failure = error;
                    None
                }
            }
        };
        // A side of one branch may be another branch, which has its age if it is followed first.
        let step = |branch: &Branch<M, D>| {
            let before = branch.line.sequence();
            sides(before, &from(before.clone(), branch.since)?)
        };
        let sides: Vec<_> = branches.iter().filter_map(step).flatten().collect();
        for side in sides {
            from(side, parameter);
        }
        if next.is_empty() {
            return Err(failure);
        }
        next.truncate(most.max(1));
        branches = next;
    }
    branches.retain(|branch| is_minimum(branch.line.minimum()));
    Ok(branches)
}

/// Returns whether a search converged, to a minimum that may be degenerate.
pub(crate) fn is_minimum<const D: usize>(minimum: &Minimum<D>) -> bool {
    use tautline::{Curvature, Stop};
    let is_flat_at_most = !matches!(minimum.curvature, Curvature::Indefinite { .. });
    minimum.is_local_minimum() || minimum.stop == Stop::Converged && is_flat_at_most
}

/// Inserts a branch by its length, unless it runs along one that is there.
fn keep<M: Metric<D>, const D: usize>(branches: &mut Vec<Branch<M, D>>, branch: Branch<M, D>) {
    let energy = branch.line.discrete_energy();
    if branches.iter().all(|known| are_apart(branch.line.sequence(), known.line.sequence())) {
        let is_shorter = |known: &Branch<M, D>| known.line.discrete_energy() <= energy;
        branches.insert(branches.partition_point(is_shorter), branch);
    }
}

/// Returns starts on both sides of where a minimum was, in the direction of its step: the step, and the
/// one turned round. `None` if it did not move.
fn sides<const D: usize>(
    before: &PointSequence<D>,
    after: &PointSequence<D>,
) -> Option<[PointSequence<D>; 2]> {
    let step: Vec<SVector<f64, D>> =
        after.points().iter().zip(before.points()).map(|(new, old)| new - old).collect();
    let largest = step.iter().map(|step| step.amax()).fold(0.0, f64::max);
    let from = before.first();
    let extent = before.points().iter().map(|x| (x - from).amax()).fold(0.0, f64::max);
    let scale = (LEAST_STEP * extent / largest).max(1.0);
    let side = |sign: f64| {
        let points = before.points().iter().zip(&step);
        PointSequence::new(points.map(|(x, step)| x + step * (sign * scale)).collect()).ok()
    };
    Some([side(1.0)?, side(-1.0)?])
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline::{
        Curvature, Ends, PointSequence, Problem, Rule, Stop,
        gallery::{Bump, Valleys},
    };

    use super::{Branch, LEAST_STEP, is_minimum, keep, sides};

    /// A line of length 2 whose middle is at a height.
    fn tent(height: f64) -> PointSequence<2> {
        PointSequence::new(vec![vector![-1.0, 0.0], vector![0.0, height], vector![1.0, 0.0]])
            .expect("finite")
    }

    /// A small step is enlarged, a large one is not, and none has no direction.
    #[test]
    fn sides_are_beside_where_a_minimum_was() {
        let heights = |before: f64, after: f64| {
            let sides = sides(&tent(before), &tent(after))?;
            let ends = [tent(0.0).points()[0], tent(0.0).points()[2]];
            assert!(sides.iter().all(|side| [side.points()[0], side.points()[2]] == ends));
            let middle = |side: &PointSequence<2>| -> SVector<f64, 2> { side.points()[1] };
            Some([middle(&sides[0])[1], middle(&sides[1])[1]])
        };
        assert_eq!(heights(0.0, 0.5), Some([0.5, -0.5]));
        assert_eq!(heights(0.25, 0.75), Some([0.75, -0.25]));
        let [there, back] = heights(0.0, 1e-6).expect("a step");
        // The extent is 2, with two roundings.
        assert!((there - 2.0 * LEAST_STEP).abs() < 1e-15 && back == -there, "{there} {back}");
        assert_eq!(heights(0.25, 0.25), None);
    }

    /// A curve that comes back to where it begins is as large as its farthest point is away, although its ends
    /// are not apart.
    #[test]
    fn a_closed_curve_has_the_extent_of_its_farthest_point() {
        let loop_of = |height: f64| {
            let points = vec![vector![0.0, 0.0], vector![0.0, 3.0 + height], vector![0.0, 0.0]];
            PointSequence::new(points).expect("finite")
        };
        let [there, back] = sides(&loop_of(0.0), &loop_of(1e-6)).expect("a step");
        let steps = [there, back].map(|side| side.points()[1][1] - 3.0);
        // Each of numbers of the size 3, rounded a few times.
        assert!((steps[0] - 3.0 * LEAST_STEP).abs() < 4e-15, "{steps:?}");
        assert!((steps[1] + 3.0 * LEAST_STEP).abs() < 4e-15, "{steps:?}");
    }

    /// What converged is a minimum unless its Hessian has a negative eigenvalue.
    #[test]
    fn a_saddle_is_no_minimum() {
        let ends = Ends::points([0.0, 0.0], [1.0, 0.5]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 8).expect("solved");
        let of = |stop, curvature| {
            let mut minimum = line.minimum().clone();
            (minimum.stop, minimum.curvature) = (stop, curvature);
            is_minimum(&minimum)
        };
        let saddle = Curvature::Indefinite { negative: 1 };
        assert!(of(Stop::Converged, Curvature::PositiveDefinite));
        assert!(of(Stop::Converged, Curvature::Degenerate));
        assert!(!of(Stop::Converged, saddle));
        for stop in [Stop::Stalled, Stop::IterationLimit] {
            assert!(!of(stop, Curvature::PositiveDefinite) && !of(stop, Curvature::Degenerate));
        }
    }

    /// Branches stand in the order of their energies, whichever is met first, and each curve once.
    #[test]
    fn branches_stand_in_the_order_of_their_energies() {
        let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
        let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
        let near = problem.solve(Rule::TRAPEZOIDAL, 64).expect("solved");
        let [far] = &near.other_minima()[..] else { panic!("the other side") };
        let energies = [near.discrete_energy(), far.discrete_energy()];
        assert!(energies[0] < energies[1], "{energies:?}");
        for order in [[&near, far, &near], [far, &near, far]] {
            let mut branches = Vec::new();
            for (k, line) in order.into_iter().enumerate() {
                keep(&mut branches, Branch { line: line.clone(), since: k as f64 });
            }
            let kept = branches.iter().map(|branch| branch.line.discrete_energy());
            assert_eq!(kept.collect::<Vec<_>>(), energies);
            // The one that was there first is kept, with its age.
            assert!(branches.iter().all(|branch| branch.since < 2.0));
        }
    }
}
