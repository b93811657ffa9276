//! Where the local searches start.

use tautline_discretizations::{ANY, PointSequence};
use tautline_sets::AnySet;

use crate::{
    newton::{
        arithmetic::small::{Vector, dot},
        discrete_energy::DiscreteEnergy,
    },
    search::{line_minimum::line_minimum, prolongation::prolong},
};

/// Where local searches start.
#[derive(Clone, Debug, Default, PartialEq)]
#[non_exhaustive]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Starts<const D: usize> {
    /// Starts from nearest points of the sets, and from further points of nonconvex sets. Between
    /// two such points the starts are the straight line, the line bent to every side, and the best
    /// of all sequences on a grid of the line. In more than seven dimensions these are the twelve
    /// bent lines of least energy.
    #[default]
    Automatic,
    /// Starts from these sequences only, on any grid. Their ends are projected to the sets. Up to
    /// `N = 64` the search begins on the grid of `N` chords itself, beyond that on a coarser one.
    Only(Vec<PointSequence<D>>),
    /// Starts from these sequences only, on the grid of `N` chords itself. Coarser grids cannot carry a
    /// start whose turns are closer together than their chords. Sequences of another number of chords
    /// are divided linearly.
    OnTheGrid(Vec<PointSequence<D>>),
    /// Starts from these sequences in addition to the automatic ones.
    Also(Vec<PointSequence<D>>),
}

/// The height of a bent line, relative to its length. It is near the height of a half circle, ½,
/// which is enough to pass an obstacle in the middle on either side.
const BEND: f64 = 0.4;

/// The largest number of bent lines between two points. A line has `2 (D − 1)` bends, and a search
/// from each would take `D` times as long as the search from the straight line.
const BENDS: usize = 12;

/// The number of alternating projections that search for nearest points. The points only provide a
/// start, so the projections need not converge.
const PROJECTIONS: usize = 50;

impl<const D: usize> Starts<D> {
    /// Returns the given sequences.
    pub(crate) fn given(&self) -> &[PointSequence<D>] {
        match self {
            Starts::Automatic => &[],
            Starts::Only(given) | Starts::OnTheGrid(given) | Starts::Also(given) => given,
        }
    }

    /// Returns the same starts for a dimension that is a value.
    pub(crate) fn in_any(&self) -> Starts<ANY> {
        let any = |given: &[PointSequence<D>]| -> Vec<PointSequence<ANY>> {
            given.iter().map(|sequence| sequence.clone().into_any()).collect()
        };
        match self {
            Starts::Automatic => Starts::Automatic,
            Starts::Only(given) => Starts::Only(any(given)),
            Starts::OnTheGrid(given) => Starts::OnTheGrid(any(given)),
            Starts::Also(given) => Starts::Also(any(given)),
        }
    }
}

impl Starts<ANY> {
    /// Returns the starts between two pieces, on the grid of `n` chords. They are the given ones,
    /// bent lines if `bent`, and the best sequences on lines for each of the numbers of intervals
    /// in `lines`.
    pub(crate) fn between(
        &self,
        energy: &DiscreteEnergy<'_>,
        [first, second]: [&dyn AnySet; 2],
        n: usize,
        bent: bool,
        lines: &[usize],
    ) -> Vec<PointSequence<ANY>> {
        let dimension = energy.dimension();
        let mut starts = self.on_the_grid([first, second], n);
        if !matches!(self, Starts::Only(_) | Starts::OnTheGrid(_)) && (bent || !lines.is_empty()) {
            for [a, b] in end_points(dimension, first, second) {
                if bent {
                    starts.extend(cheapest(energy, bent_lines(&a, &b, n)));
                }
                let line = |&intervals| line_minimum(energy, &a, &b, n, intervals);
                starts.extend(lines.iter().filter_map(line));
            }
        }
        // Sequences with points that are not finite are left out.
        let sequence = |points| PointSequence::from_coordinates(dimension, points).ok();
        starts.into_iter().filter_map(sequence).collect()
    }

    /// Returns the given sequences on the grid of `n` chords, with their ends in the sets.
    fn on_the_grid(&self, [first, second]: [&dyn AnySet; 2], n: usize) -> Vec<Vec<f64>> {
        let on_the_grid = |sequence: &PointSequence<ANY>| {
            let mut points = match self {
                Starts::OnTheGrid(_) => divided(sequence, n),
                _ => prolong(sequence, n),
            };
            let d = sequence.dimension();
            first.project(&mut points[..d]);
            second.project(&mut points[n * d..]);
            points
        };
        self.given().iter().map(on_the_grid).collect()
    }
}

/// Returns `n + 1` points on the polygon of a sequence, at equal distances in its parameter.
fn divided(sequence: &PointSequence<ANY>, n: usize) -> Vec<f64> {
    let coarse = sequence.n().get();
    let at = |k: usize| -> Vector {
        // In integers, so that a point of the sequence remains as it is.
        let (whole, rest) =
            (k as u128 * coarse as u128 / n as u128, k as u128 * coarse as u128 % n as u128);
        let (whole, t) = (whole as usize, rest as f64 / n as f64);
        if rest == 0 {
            return Vector::from_slice(sequence.row(whole));
        }
        let ends = sequence.row(whole).iter().zip(sequence.row(whole + 1));
        ends.map(|(x, y)| x * (1.0 - t) + y * t).collect()
    };
    (0..=n).flat_map(at).collect()
}

/// Returns pairs of end points: nearest points of the sets, and each seed with the point nearest to
/// it.
fn end_points(dimension: usize, first: &dyn AnySet, second: &dyn AnySet) -> Vec<[Vec<f64>; 2]> {
    let nearest = |set: &dyn AnySet, x: &[f64]| {
        let mut x = x.to_vec();
        set.project(&mut x);
        x
    };
    let mut a = nearest(first, &vec![0.0; dimension]);
    let mut b = nearest(second, &a);
    for _ in 0..PROJECTIONS {
        a = nearest(first, &b);
        let next = nearest(second, &a);
        if next == b {
            break;
        }
        b = next;
    }
    let mut pairs = vec![[a, b]];
    // A seed stays in place, since repeated projection would move all seeds to the same point.
    pairs.extend(first.seeds().into_iter().map(|a| {
        let b = nearest(second, &a);
        [a, b]
    }));
    pairs.extend(second.seeds().into_iter().map(|b| [nearest(first, &b), b]));
    pairs
}

/// Returns the straight line, which is the first of these lines, and the [`BENDS`] bends of least energy.
/// The metric need not be defined along a bend, as long as it is along others.
fn cheapest(energy: &DiscreteEnergy<'_>, mut lines: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    if lines.len() <= 1 + BENDS {
        return lines;
    }
    let cost = |line: Vec<f64>| (energy.admissible(&line).unwrap_or(f64::INFINITY), line);
    let mut bends: Vec<_> = lines.drain(1..).map(cost).collect();
    bends.sort_by(|a, b| a.0.total_cmp(&b.0));
    lines.extend(bends.into_iter().take(BENDS).map(|(_, line)| line));
    lines
}

/// Returns the straight line from `a` to `b`, in `n` chords, and its bends to both sides of every axis: the
/// coordinates of their points, in `ℓ`.
#[must_use]
pub fn bent_lines(a: &[f64], b: &[f64], n: usize) -> Vec<Vec<f64>> {
    let d = a.len();
    let chord: Vector = a.iter().zip(b).map(|(a, b)| b - a).collect();
    let line = |bend: &[f64]| -> Vec<f64> {
        let at = |k: usize| {
            let t = k as f64 / n as f64;
            // The ends are exact, while the sine would round.
            let height = (k > 0 && k < n).then(|| (std::f64::consts::PI * t).sin());
            let along = a.iter().zip(b).map(move |(a, b)| a * (1.0 - t) + b * t);
            along.zip(bend).map(move |(x, bend)| height.map_or(x, |height| x + bend * height))
        };
        (0..=n).flat_map(at).collect()
    };
    let mut starts = vec![line(&vec![0.0; d])];
    if n > 1 {
        let squared = dot(&chord, &chord);
        for axis in 0..d {
            let share = chord[axis] / squared;
            let mut bend: Vector = chord.iter().map(|x| -(x * share)).collect();
            bend[axis] = 1.0 - chord[axis] * share;
            let length = dot(&bend, &bend).sqrt();
            // The axis nearest to the chord adds no direction to the others.
            if !(length > 0.5) {
                continue;
            }
            let height = BEND * squared.sqrt();
            let bend: Vector = bend.iter().map(|x| x / length * height).collect();
            let other: Vector = bend.iter().map(|x| -x).collect();
            starts.extend([line(&bend), line(&other)]);
        }
    }
    starts
}

#[cfg(test)]
mod tests {
    use std::sync::LazyLock;

    use nalgebra::SVector;
    use tautline_discretizations::{PointSequence, Rule};
    use tautline_formula::Prepared;
    use tautline_metrics::gallery::{Bump, Valleys};
    use tautline_sets::{Ball, ClosedSet, HalfSpace, InAny, Point, Sphere};

    use super::{BEND, BENDS, Starts};
    use crate::newton::discrete_energy::DiscreteEnergy;

    /// Returns the starts between two sets of the plane, or of space.
    fn between<const D: usize>(
        starts: &Starts<D>,
        energy: &DiscreteEnergy<'_>,
        sets: [&dyn ClosedSet<D>; 2],
        n: usize,
        bent: bool,
        lines: &[usize],
    ) -> Vec<PointSequence<D>> {
        let sets = sets.map(InAny);
        let found = starts.in_any().between(energy, [&sets[0], &sets[1]], n, bent, lines);
        found.into_iter().filter_map(PointSequence::into_dimension).collect()
    }

    /// Returns the energy over the valleys.
    fn valleys() -> DiscreteEnergy<'static> {
        static METRIC: LazyLock<Prepared<Valleys, 2>> = LazyLock::new(|| Prepared::new(Valleys));
        DiscreteEnergy::new(Rule::TRAPEZOIDAL, &*METRIC)
    }

    #[test]
    fn every_start_ends_in_its_sets() {
        let ball = Ball::new([0.0, 2.0], 0.5).expect("positive radius");
        let wall = HalfSpace::new([-1.0, 0.0], -3.0).expect("not zero");
        let given = PointSequence::straight([0.0, 9.0], [9.0, 0.0], 3).expect("finite");
        let starts = Starts::Also(vec![given]);
        let starts = between(&starts, &valleys(), [&ball, &wall], 16, true, &[64]);
        assert_eq!(
            starts.len(),
            1 + 3 + 1,
            "given; straight, bent to both sides, and best on the line"
        );
        for start in starts {
            assert_eq!(start.n().get(), 16);
            assert!(
                (start.first()[0].powi(2) + (start.first()[1] - 2.0).powi(2)).sqrt() <= 0.5 + 1e-15
            );
            assert!(start.last()[0] >= 3.0);
        }
    }

    /// The starts are the given ones, and one sequence for each line and pair of end points.
    #[test]
    fn given_starts_and_lines_are_tried_in_detail() {
        let ball = Ball::new([0.0, 2.0], 0.5).expect("positive radius");
        let wall = HalfSpace::new([-1.0, 0.0], -3.0).expect("not zero");
        let given = PointSequence::straight([0.0, 9.0], [9.0, 0.0], 3).expect("finite");
        let also = Starts::Also(vec![given]);
        let tried = |starts: &Starts<2>, lines: &[usize]| {
            between(starts, &valleys(), [&ball, &wall], 16, false, lines)
        };
        let [start] = tried(&also, &[]).try_into().expect("the given one");
        assert_eq!(start.n().get(), 16);
        assert!((start.first() - nalgebra::vector![0.0, 2.5]).amax() < 1e-15);
        assert_eq!(start.last()[0], 9.0);
        assert_eq!((tried(&also, &[48]).len(), tried(&also, &[48, 64]).len()), (2, 3));
        assert_eq!(
            (tried(&Starts::Automatic, &[]).len(), tried(&Starts::Automatic, &[48]).len()),
            (0, 1)
        );
    }

    /// A polygon with sharp turns: prolonged by polynomials it would swing beside its corners.
    #[test]
    fn starts_on_the_grid_are_divided_linearly() {
        let a = Point::new([0.0, 0.0]).expect("finite");
        let b = Point::new([3.0, 0.0]).expect("finite");
        let corners = [[0.0, 0.0], [1.0, 1.0], [2.0, -1.0], [3.0, 0.0]];
        let polygon = PointSequence::new(corners.map(Into::into).to_vec()).expect("finite");
        let starts = Starts::OnTheGrid(vec![polygon.clone()]);
        let on = |n| {
            let [start] = between(&starts, &valleys(), [&a, &b], n, true, &[48, 64])
                .try_into()
                .expect("the given one");
            start
        };
        assert_eq!(on(3), polygon);
        let fine = on(6);
        let expected = [[0.5, 0.5], [1.5, 0.0], [2.5, -0.5]];
        for (k, x) in expected.into_iter().enumerate() {
            assert_eq!(fine.points()[2 * k], polygon.points()[k]);
            assert_eq!(fine.points()[2 * k + 1], SVector::from(x));
        }
    }

    #[test]
    fn lines_are_bent_to_both_sides_of_every_axis_but_their_own() {
        let a = Point::new([-1.0, 0.0, 0.0]).expect("finite");
        let b = Point::new([1.0, 0.0, 0.0]).expect("finite");
        let metric = Prepared::<_, 3>::new(Valleys);
        let energy = DiscreteEnergy::new(Rule::TRAPEZOIDAL, &metric);
        let middles: Vec<_> = between(&Starts::Automatic, &energy, [&a, &b], 10, true, &[64])
            .iter()
            .map(|start| {
                let middle = start.points()[5];
                [middle[1], middle[2]].map(|x| (x / (2.0 * BEND)).round())
            })
            .collect();
        assert_eq!(middles[..5], [[0.0, 0.0], [1.0, 0.0], [-1.0, 0.0], [0.0, 1.0], [0.0, -1.0]]);
    }

    #[test]
    fn a_sphere_is_tried_from_all_sides() {
        let sphere = Sphere::new([0.0, 0.0], 1.0).expect("positive radius");
        let point = Point::new([0.2, 0.1]).expect("finite");
        let starts = between(&Starts::Automatic, &valleys(), [&sphere, &point], 16, true, &[64]);
        assert!(starts.len() >= 5 * 4, "the nearest point and four seeds, {}", starts.len());
        // If the sphere is the second set, the lines are the same, reversed.
        let back = between(&Starts::Automatic, &valleys(), [&point, &sphere], 16, true, &[64]);
        assert_eq!(back.len(), starts.len());
        let near = |x: &PointSequence<2>, y: &PointSequence<2>| {
            let pairs = x.points().iter().zip(y.points().iter().rev());
            pairs.map(|(x, y)| (x - y).amax()).fold(0.0, f64::max) < 1e-9
        };
        let straight = |starts: &[PointSequence<2>]| -> Vec<_> {
            let even = |x: &PointSequence<2>| {
                let steps: Vec<_> = x.differences().collect();
                steps.iter().all(|step| (step - steps[0]).amax() < 1e-9)
            };
            starts.iter().filter(|x| even(x)).cloned().collect()
        };
        assert!(straight(&starts).len() >= 5);
        for line in straight(&starts) {
            assert!(back.iter().any(|x| near(x, &line)), "{line:?}");
        }
    }

    /// The nearest points of a ball and a half-space lie on the normal through the centre.
    #[test]
    fn the_straight_start_joins_nearest_points() {
        let ball = Ball::new([0.0, 2.0], 1.0).expect("positive radius");
        let wall = HalfSpace::at_least([1.0, 1.0], 6.0).expect("not zero");
        let starts = between(&Starts::Automatic, &valleys(), [&ball, &wall], 4, true, &[64]);
        let r = 0.5_f64.sqrt();
        // Each of the 50 rounds of alternating projections at least halves the error, so only
        // rounding remains.
        assert!((starts[0].first() - nalgebra::vector![r, 2.0 + r]).amax() < 1e-6);
    }

    /// Over the centre of a bump, the bend away from the centre is the cheapest of sixteen, and the bend
    /// through it is left out.
    #[test]
    fn in_nine_dimensions_the_cheapest_twelve_bends_are_tried() {
        let mut end = [0.0; 9];
        (end[0], end[8]) = (1.0, 0.2);
        let b = Point::new(end).expect("finite");
        end[0] = -1.0;
        let a = Point::new(end).expect("finite");
        let bump = Prepared::<_, 9>::new(Bump::new(4.0, 0.5).expect("positive"));
        let energy = DiscreteEnergy::new(Rule::TRAPEZOIDAL, &bump);
        let starts = between(&Starts::Automatic, &energy, [&a, &b], 10, true, &[]);
        assert_eq!(starts.len(), 1 + BENDS);
        let heights: Vec<f64> = starts.iter().map(|start| start.points()[5][8]).collect();
        assert_eq!(heights[..2], [0.2, 0.2 + 2.0 * BEND]);
        assert!(heights[2..].iter().all(|height| *height == 0.2), "{heights:?}");
    }
}
