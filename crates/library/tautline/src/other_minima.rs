//! The other local minima that a search met, as lines.

use std::sync::Arc;

use tautline_discretizations::{Integral, Interpolation, PointSequence};
use tautline_formula::Prepare;
use tautline_optimizers::{Minimum, Options, Starts, Workspace, are_apart, minimise_any};
use tautline_sets::{AnyEnds, AnySet};

use crate::TautLine;

/// The largest number of chords of another minimum, as many as the search follows several minima
/// to.
const FINEST: usize = 512;

/// Lengths that differ by less than this fraction count as equal: on a coarser grid a curve is a
/// little longer.
pub const TIE: f64 = 1e-5;

/// How much more energy another minimum may have, and be shorter.
const NEAR: f64 = 1.02;

/// The same, where the chords do not resolve the metric.
const NOT_RESOLVED: f64 = 1.2;

impl<M: Prepare<D>, const D: usize> TautLine<M, D> {
    /// Returns whether this line is shorter than another one by more than a [tie](TIE).
    #[must_use]
    pub fn is_shorter_than(&self, other: &Self) -> bool {
        self.length_at_most() <= other.length_at_most() * (1.0 - TIE)
    }

    /// Returns the length with its error, in `m`. Of a chord from far out to far out the quadrature may see
    /// little, and then has a large error.
    pub(crate) fn length_at_most(&self) -> f64 {
        let Integral { value, error } = self.length();
        value + error
    }

    /// Returns the shortest of the [other minima](TautLine::other_minima) if it is
    /// [shorter](TautLine::is_shorter_than) than this line. By the energy of the rule it is no lower. Those
    /// whose energy is far higher are not looked at.
    #[must_use]
    pub fn shorter_minimum(&self) -> Option<Self> {
        let others = &self.minimum().others;
        if others.is_empty() {
            return None;
        }
        let energy = self.discrete_energy().max(self.energy().value);
        let bound = self.length_at_most() * (1.0 - TIE);
        let may_be_shorter = if self.is_resolved() {
            // The polygons of the search are curves too. To follow them to the grid of this line takes as
            // long as to find it.
            others.iter().any(|other| {
                let polygon = Interpolation::new(&other.sequence);
                other.energy <= NEAR * energy
                    && polygon.length_by_batches(&**self.prepared()).value <= bound
            })
        } else {
            others.iter().any(|other| other.energy <= NOT_RESOLVED * energy)
        };
        let mut others = may_be_shorter.then(|| self.other_minima())?;
        (!others.is_empty())
            .then(|| others.swap_remove(0))
            .filter(|other| other.is_shorter_than(self))
    }

    /// Returns the [other local minima](tautline_optimizers::Minimum::others) of the search as
    /// lines of their own, shortest first. Each is solved again from where the search left it, with
    /// `N` chords or 512, whichever is less, and with the default number of steps and threads.
    ///
    /// ```
    /// use tautline::{Ends, Problem, Rule, gallery::TwoChannels};
    ///
    /// let ends = Ends::points([-3.0, 0.0], [3.0, 0.0])?;
    /// let line = Problem::new(TwoChannels::new(2.0, 1.0, 0.5)?, ends).solve(Rule::TRAPEZOIDAL, 256)?;
    /// let [other] = &line.other_minima()[..] else { panic!("one channel besides") };
    /// // The two channels are mirror images, so that they are equally long.
    /// assert!((other.length().value - line.length().value).abs() < 1e-9);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    ///
    /// The ends of each are the pieces of the two sets that it joins, so that bounds on its own
    /// distance are those of the pieces. There are at most eight; those that the search never met
    /// are missing, and those that are none on the finer grid.
    #[must_use]
    pub fn other_minima(&self) -> Vec<Self> {
        let (n, mut workspace) = (self.sequence().n().get().min(FINEST), Workspace::default());
        let mut others: Vec<Self> = Vec::new();
        for other in &self.minimum().others {
            let (metric, rule) = (Arc::clone(self.prepared()), self.rule());
            let Some(ends) = nearest_pair(self.any_ends(), &other.sequence) else { continue };
            let mut from = |starts| {
                let options = Options { starts, ..Options::default() };
                let found = minimise_any(&mut workspace, &*metric, &ends, rule, n, &options, None);
                let found = found.ok().filter(Minimum::is_local_minimum)?;
                let is_new = |line: &Self| are_apart(&found.sequence, line.sequence());
                (is_new(self) && others.iter().all(is_new)).then_some(found)
            };
            let start = || vec![other.sequence.clone()];
            // Coarser grids lead elsewhere from a line whose turns are closer than their chords.
            let is_on_the_grid = other.sequence.n().get() >= n;
            let found = from(Starts::Only(start()))
                .filter(|found| !is_on_the_grid || !are_apart(&found.sequence, &other.sequence))
                .or_else(|| from(Starts::OnTheGrid(is_on_the_grid.then(start)?)));
            if let Some(found) = found {
                let line = Self::new(metric, rule, ends, found);
                let length = line.length_at_most();
                let is_shorter = |other: &Self| other.length_at_most().total_cmp(&length).is_le();
                others.insert(others.partition_point(is_shorter), line);
            }
        }
        others
    }
}

/// Returns the pieces of the two sets that a sequence joins. A search between all pieces would end
/// at the nearest ones.
fn nearest_pair<const D: usize>(ends: &AnyEnds, sequence: &PointSequence<D>) -> Option<AnyEnds> {
    let away = |set: &dyn AnySet, x: &[f64]| {
        let mut nearest = x.to_vec();
        set.project(&mut nearest);
        nearest.iter().zip(x).map(|(y, x)| (y - x) * (y - x)).sum::<f64>().sqrt()
    };
    let (first, last) = (sequence.row(0), sequence.row(sequence.n().get()));
    let pairs = ends.pairs().into_iter().map(|[a, b]| (away(&*a, first) + away(&*b, last), a, b));
    let (_, a, b) = pairs.min_by(|(x, ..), (y, ..)| x.total_cmp(y))?;
    AnyEnds::new(a, b).ok()
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use nalgebra::SMatrix;
    use tautline_discretizations::Rule;
    use tautline_metrics::gallery::{Bump, Constant, Valleys};
    use tautline_optimizers::Other;
    use tautline_sets::{Ball, ClosedSet, Ends, Point, Union};

    use crate::{Problem, TautLine};

    /// A bump between two points has a way on either side. They are mirror images, so that both
    /// have the same length on the same grid.
    #[test]
    fn the_mirror_image_is_a_line_on_the_same_grid() {
        let ends = Ends::points([-2.0, 0.0], [2.0, 0.0]).expect("finite");
        let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
        for (n, chords) in [(64, 64), (256, 256), (1000, 512)] {
            let line = problem.solve(Rule::TRAPEZOIDAL, n).expect("solved");
            let others = line.other_minima();
            let [other] = others.as_slice() else { panic!("{} others", others.len()) };
            assert_eq!(other.sequence().n().get(), chords);
            assert!(other.minimum().is_local_minimum());
            let (middle, mirrored) = (line.curve().at(0.5), other.curve().at(0.5));
            // On different grids they differ by the error of the coarser one, of order 512⁻².
            assert!(middle[1].abs() > 0.3 && (middle[1] + mirrored[1]).abs() < 1e-4, "{middle}");
            if chords == n {
                let [a, b] = [&line, other].map(|line| line.length().value);
                // Two solves to the floor of rounding.
                assert!((a - b).abs() <= 1e-11 * a, "N = {n}: {a} {b}");
            }
        }
    }

    /// Each way to a piece of a set is a minimum of its own, though a shorter one leads to another
    /// piece.
    #[test]
    fn the_ways_to_the_other_pieces_of_a_set_are_lines() {
        let balls =
            [[2.0, 0.0], [0.0, 3.0], [-4.0, 0.0]].map(|x| Ball::new(x, 0.5).expect("a ball"));
        let balls = balls.map(|ball| Arc::new(ball) as Arc<dyn ClosedSet<2>>);
        let target = Union::new(balls.to_vec()).expect("three");
        let ends = Ends::new(Point::new([0.0, 0.0]).expect("finite"), target).expect("bounded");
        let plane = Constant::<2>::new(SMatrix::identity()).expect("positive definite");
        let line = Problem::new(plane, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
        let others = line.other_minima();
        let lengths: Vec<_> =
            [&line].into_iter().chain(&others).map(|l| l.length().value).collect();
        let [nearest, second, third] = *lengths else { panic!("{lengths:?}") };
        for (length, exact) in [(nearest, 1.5), (second, 2.5), (third, 3.5)] {
            assert!((length - exact).abs() < 1e-10, "{lengths:?}");
        }
    }

    /// What a search left on a coarser grid may lead to the line itself, or twice to the same one: each curve
    /// stands once.
    #[test]
    fn what_leads_to_a_known_line_is_no_other_minimum() {
        let ends = Ends::points([-2.0, 0.0], [2.0, 0.0]).expect("finite");
        let problem = Problem::new(Bump::new(4.0, 0.5).expect("a bump"), ends);
        let line = problem.solve(Rule::TRAPEZOIDAL, 64).expect("solved");
        let [other] = &line.minimum().others[..] else { panic!("the mirror image") };
        let coarser = line.resampled(32).expect("points");
        let own = Other { sequence: coarser, energy: line.discrete_energy() };
        let mut minimum = line.minimum().clone();
        minimum.others = vec![own, other.clone(), other.clone()];
        let again = TautLine::<Bump, 2>::new(
            Arc::clone(line.prepared()),
            Rule::TRAPEZOIDAL,
            line.ends().clone(),
            minimum,
        );
        assert_eq!(again.other_minima().len(), 1);
    }

    #[test]
    fn a_single_minimum_has_no_others() {
        let ends = Ends::points([0.0, 0.0], [1.0, 1.0]).expect("finite");
        let line = Problem::new(Valleys, ends).solve(Rule::TRAPEZOIDAL, 64).expect("solved");
        assert!(line.other_minima().is_empty());
    }
}
