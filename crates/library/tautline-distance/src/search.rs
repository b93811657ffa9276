//! The search for a certificate: levels of smaller and smaller cubes near all short curves.

use std::ops::ControlFlow;

use nalgebra::SVector;
use tautline_check::{Certificate, Chain, CheckError, Cubes, Level, in_parallel, length_above};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    DistanceError, Ended, Found, Progress, Wanted,
    any::search_any,
    fan::Pencil,
    geodesic::Geodesic,
    inside::inside,
    marching::point,
    pace::Pace,
    proposal::{Source, scaled},
    seed::distance,
};

/// How much longer than the curve the curves are that are followed, relative to its length. All
/// minimal geodesics are among them.
const LONGER: f64 = 1e-9;

/// How much longer the curves are that the levels keep, so that a checker that rounds differently
/// keeps no other cubes.
pub(crate) const KEPT: f64 = 1e-12;

/// The number of steps along a ray for a gap of `1e-6`; for other gaps as in a method of fourth order.
const STEPS: f64 = 900.0;

/// If a proposal makes the gap smaller by this factor, or as small as is wanted, no other one is tried.
/// Cubes half as large should leave a quarter.
const GOOD: f64 = 0.4;

/// A proposal loses if its gap is this much larger than the best one: a little is less than what a more
/// expensive proposal costs.
const LOST: f64 = 1.5;

/// A search.
#[derive(Debug)]
pub(crate) struct Search<'f, const D: usize> {
    pub(crate) formula: &'f Formula<D>,
    pub(crate) sets: &'f [Shape<D>; 2],
    /// The shortest of the curves, with its ends in the sets.
    pub(crate) curve: Vec<SVector<f64, D>>,
    pub(crate) length: f64,
    pub(crate) hi: f64,
    /// Geodesics near the curves, as far as they have calibrations.
    pub(crate) pencils: Vec<(Geodesic<D>, Pencil<D>)>,
    /// The most work that the check of a certificate may cost.
    pub(crate) budget: fn(&Certificate<D>) -> u64,
}

/// Searches for a certificate of the distance between two sets, given polygons between them. The first
/// one is the curve of the certificate. Further ones help if they are nearly as short.
///
/// If the first set is unbounded, the certificate has the sets in the other order.
///
/// The formula of the certificate is that of [`Formula::of_upper_half`], which is the same matrix.
///
/// `observe` is told about every level, and may stop the search.
///
/// ```
/// use std::ops::ControlFlow;
///
/// use nalgebra::vector;
/// use tautline_distance::{Wanted, search};
/// use tautline_formula::Formula;
/// use tautline_sets::{Point, Shape};
///
/// // Half of the unit sphere in stereographic coordinates.
/// let sphere = Formula::<2>::parse("4/sqr(1 + x1^2 + x2^2) I", &[])?;
/// let sets = [[-0.5, 0.0], [0.5, 0.0]].map(|x| Shape::Point(Point::new(x).expect("finite")));
/// // The straight line is the geodesic.
/// let line = (0..=100).map(|n| vector![f64::from(n) / 100.0 - 0.5, 0.0]).collect();
/// let go_on = &mut |_| ControlFlow::Continue(());
/// let found = search(&sphere, &sets, &[line], Wanted::gap(1e-3), go_on)?;
/// let proved = found.certificate.check()?;
/// let d = 4.0 * 0.5_f64.atan();
/// assert!(proved.lower <= d && d <= proved.upper.expect("a curve") && proved.lower > 0.999 * d);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`DistanceError`] if the gap is not between 0 and 1, the halves of the matrix are not known to be equal
/// ([`Formula::unequal_halves`]), the polygon proves no length above 0, or no
/// region holds the short curves.
pub fn search<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curves: &[Vec<SVector<f64, D>>],
    wanted: Wanted,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Found<D>, DistanceError> {
    let sets = sets.each_ref().map(|set| set.clone().into_any());
    let coordinates = |curve: &Vec<SVector<f64, D>>| curve.iter().flatten().copied().collect();
    let curves: Vec<Vec<f64>> = curves.iter().map(coordinates).collect();
    let found = search_any(&formula.clone().into_any(), &sets, &curves, wanted, observe)?;
    found.into_dimension().ok_or(DistanceError::Refused(CheckError::Dimension { dimension: D }))
}

/// Searches in one dimension.
pub(crate) fn search_in<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curves: &[Vec<SVector<f64, D>>],
    wanted: Wanted,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Found<D>, DistanceError> {
    if !(wanted.gap > 0.0 && wanted.gap < 1.0) {
        return Err(DistanceError::Gap { gap: wanted.gap });
    }
    if let Some((row, column)) = formula.unequal_halves() {
        return Err(DistanceError::Refused(CheckError::Halves { row, column }));
    }
    if is_unbounded(&sets[0]) {
        if is_unbounded(&sets[1]) {
            return Err(DistanceError::Unbounded);
        }
        let sets = [sets[1].clone(), sets[0].clone()];
        let turned = |curve: &Vec<SVector<f64, D>>| curve.iter().rev().copied().collect();
        let curves: Vec<Vec<SVector<f64, D>>> = curves.iter().map(turned).collect();
        return search_in(formula, &sets, &curves, wanted, observe);
    }
    let mut curve = curves.first().filter(|curve| curve.len() > 1).cloned().unwrap_or_default();
    if let [first, .., last] = &mut curve[..] {
        (*first, *last) = (inside(&sets[0], first), inside(&sets[1], last));
    }
    let length = length_above(formula, sets.each_ref(), &curve).map_err(DistanceError::Curve)?;
    if !(length > 0.0 && length.is_finite()) {
        return Err(DistanceError::Length { length });
    }
    // The file has one half of the matrix, and so the checkers read no more.
    let formula = &formula.of_upper_half();
    let steps = (STEPS * (1e-6 / wanted.gap).powf(0.25)).clamp(400.0, 4000.0) as usize;
    let pencil = |curve: &Vec<SVector<f64, D>>| {
        let geodesic = Geodesic::near(formula, curve)?;
        Some((geodesic, Pencil::along(formula, sets, &geodesic, steps)?))
    };
    let pencils = curves.iter().filter(|curve| curve.len() > 1).filter_map(pencil).collect();
    let hi = length * (1.0 + LONGER);
    // A checker whose intervals are a little wider may halve some more boxes of a tube or parts of a chord.
    let budget = |certificate: &Certificate<D>| certificate.budget() / 64 * 63;
    Search { formula, sets, curve, length, hi, pencils, budget }.run(wanted, observe)
}

/// Returns whether there are no cubes of the side that was asked for: it is too small, or too small for the
/// distance from the origin or for the distance between the cubes.
fn has_no_cubes(error: &CheckError) -> bool {
    use CheckError::{Apart, Place, Side, TooFar};
    matches!(error, TooFar { .. } | Place { .. } | Side { .. } | Apart)
}

/// Returns whether a set has a half-space.
fn is_unbounded<const D: usize>(set: &Shape<D>) -> bool {
    set.pieces().iter().any(|piece| matches!(piece, Shape::HalfSpace(_)))
}

impl<const D: usize> Search<'_, D> {
    fn run(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Found<D>, DistanceError> {
        let (region, first, mut chain) = self.first_level(wanted.cubes)?;
        chain.length_above(&self.curve).map_err(DistanceError::Curve)?;
        let mut cubes = first.cubes().places().len();
        let mut certificate = Certificate {
            formula: self.formula.clone(),
            sets: self.sets.clone(),
            hi: self.hi,
            region,
            curve: Some(self.curve.clone()),
            levels: vec![first],
        };
        let budget = (self.budget)(&certificate);
        if chain.work() > budget {
            return Err(DistanceError::Refused(CheckError::Work { budget }));
        }
        let mut pace = Pace::default();
        let mut lost = Vec::new();
        let ended = loop {
            let (lower, upper) = (chain.lower(), self.length);
            let levels = certificate.levels.len();
            let stop = observe(Progress { levels, cubes, lower, upper });
            if self.gap(&chain) <= wanted.gap {
                break Ended::Reached;
            }
            if stop.is_break() {
                break Ended::Stopped;
            }
            if pace.is_stalled() {
                break Ended::Stalled;
            }
            let exponent = certificate.levels[levels - 1].cubes().exponent() - 1;
            let next = match chain.required(exponent) {
                Err(error) if has_no_cubes(&error) => break Ended::TooFar,
                next => next.map_err(DistanceError::Refused)?,
            };
            if cubes + next.places().len() > wanted.cubes {
                break Ended::TooManyCubes;
            }
            let count = next.places().len();
            let proposed = self.next_level(&chain, next, (levels, wanted.gap), &mut lost)?;
            let Some((level, next)) = proposed else { break Ended::TooFar };
            certificate.levels.push(level);
            if next.work() > (self.budget)(&certificate) {
                certificate.levels.pop();
                break Ended::TooMuchWork;
            }
            cubes += count;
            pace.add(self.gap(&chain), self.gap(&next));
            chain = next;
        };
        let proved = chain.proved(Some(self.length)).map_err(DistanceError::Refused)?;
        Ok(Found { certificate, proved, ended })
    }

    /// Returns whether a cube may meet a piece of a set from which no rays start.
    fn meets_others(&self, cubes: &Cubes<D>) -> bool {
        if self.sets.iter().all(|set| set.pieces().len() == 1) {
            return false;
        }
        let half = 0.5 * cubes.side();
        let reach = half * (D as f64).sqrt();
        let centre = |place| point::<D>(place, cubes.side()).add_scalar(half);
        let centres: Vec<SVector<f64, D>> = cubes.places().iter().map(centre).collect();
        let is_near = |piece: &Shape<D>| match piece {
            Shape::Point(at) => {
                let place = at.position().map(|x| (x / cubes.side()).floor() as i32);
                cubes.contains(&place.into())
            }
            _ => in_parallel(centres.len(), &|k| distance(piece, &centres[k]) <= reach)
                .contains(&true),
        };
        [0, 1].into_iter().any(|side| {
            let pieces = self.sets[side].pieces();
            let own: Vec<usize> = (self.pencils.iter())
                .filter_map(|(geodesic, _)| {
                    let (end, _) = geodesic.behind(self.formula, side, 0.0)?;
                    let away = |n: &usize| distance(pieces[*n], &end);
                    (0..pieces.len()).min_by(|a, b| away(a).total_cmp(&away(b)))
                })
                .collect();
            let mut others = pieces.iter().enumerate().filter(|(n, _)| !own.contains(n));
            others.any(|(_, piece)| is_near(piece))
        })
    }

    fn gap(&self, chain: &Chain<'_, D>) -> f64 {
        (self.length - chain.lower()) / self.length
    }

    /// Returns the best level on these cubes of those that are proposed, and the proof with it; `None` if
    /// there are no values, since so far from the origin no cubes have room around them. Sources
    /// that `lost` at the level before are tried last; then it has those that lose at this one.
    fn next_level<'c>(
        &self,
        chain: &Chain<'c, D>,
        cubes: Cubes<D>,
        (number, wanted): (usize, f64),
        lost: &mut Vec<Source>,
    ) -> Result<Option<(Level<D>, Chain<'c, D>)>, DistanceError> {
        let before = self.gap(chain);
        // Slopes above 1 cost less than slopes below 1.
        let scale = 1.0 + 0.3 * before.min(0.01);
        let mut best: Option<(Level<D>, Chain<'c, D>)> = None;
        let mut gaps = Vec::new();
        let mut marched = None;
        let mut sources = vec![Source::Rays, Source::Fans, Source::MarchFromRays, Source::March];
        // Without a point both marches are the same. The rays leave one piece of a set, and say nothing of
        // another one.
        let has_point = self.sets.iter().any(|set| matches!(set, Shape::Point(_)));
        let has_others = self.meets_others(&cubes);
        sources.retain(|source| match source {
            Source::Rays | Source::Fans => !has_others,
            Source::MarchFromRays => has_point,
            Source::March => true,
        });
        if self.is_shared(&cubes) {
            sources.rotate_right(1);
        }
        sources.sort_by_key(|source| lost.contains(source));
        for source in sources {
            let Some(values) = self.propose(&cubes, source, &mut marched) else { continue };
            let values = values.map(|values| scaled(values, scale));
            let level =
                Level::new(number, cubes.clone(), values).map_err(DistanceError::Refused)?;
            let mut next = chain.clone();
            next.add(&level, self.hi * (1.0 + KEPT)).map_err(DistanceError::Refused)?;
            let gap = self.gap(&next);
            gaps.push((source, gap));
            let kept = |chain: &Chain<'c, D>| chain.kept().map_or(0, |kept| kept.places().len());
            // Of two that prove the same, the one that leaves fewer cubes is better.
            let is_better = best.as_ref().is_none_or(|(_, best)| {
                next.lower() > best.lower()
                    || next.lower() == best.lower() && kept(&next) < kept(best)
            });
            if is_better {
                best = Some((level, next));
            }
            if gap < wanted.max(GOOD * before) {
                break;
            }
        }
        let least = gaps.iter().map(|&(_, gap)| gap).fold(f64::INFINITY, f64::min);
        lost.clear();
        lost.extend(
            gaps.into_iter().filter(|&(_, gap)| gap > LOST * least).map(|(source, _)| source),
        );
        Ok(best)
    }
}

#[cfg(test)]
mod tests {
    use std::ops::ControlFlow;

    use nalgebra::vector;
    use tautline_check::{AnyCertificate, Certificate, Chain, CheckError, Cubes};
    use tautline_formula::Formula;
    use tautline_sets::{Ball, Point, Shape};

    use super::{Search, length_above, search};
    use crate::{DistanceError, Ended, Found, Wanted, fan::Pencil, geodesic::Geodesic};

    fn between(text: &str, ends: [[f64; 2]; 2]) -> Result<Found<2>, DistanceError> {
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        let sets = ends.map(|x| Shape::Point(Point::new(x).expect("finite")));
        let [x, y] = ends.map(|x| vector![x[0], x[1]]);
        let line = (0..=64).map(|n| x.lerp(&y, f64::from(n) / 64.0)).collect();
        search(&formula, &sets, &[line], Wanted::gap(0.1), &mut |_| ControlFlow::Continue(()))
    }

    /// Rays from the nearest piece say nothing of a piece beside it, until it is out of the cubes.
    #[test]
    fn cubes_with_a_piece_without_rays_are_known() {
        let flat = Formula::<2>::parse("1 I", &[]).expect("a formula");
        let point = |x: [f64; 2]| Shape::Point(Point::new(x).expect("finite"));
        let ball = Shape::Ball(Ball::new([0.0, 3.0], 1.0).expect("a radius"));
        let union = Shape::Union(vec![point([0.0, 0.0]), point([-1.5, 0.5]), ball]);
        let sets = [union, point([2.0, 0.0])];
        let curve = vec![vector![0.0, 0.0], vector![2.0, 0.0]];
        let geodesic = Geodesic::near(&flat, &curve).expect("a geodesic");
        let pencil = Pencil::along(&flat, &sets, &geodesic, 400).expect("rays");
        let search = |pencils| {
            let (formula, sets, curve) = (&flat, &sets, curve.clone());
            let budget = Certificate::budget;
            Search { formula, sets, curve, length: 2.0, hi: 2.1, pencils, budget }
        };
        let cubes = |places: &[[i32; 2]]| Cubes::new(0, places.to_vec()).expect("in range");
        let one = search(vec![(geodesic, pencil)]);
        assert!(!one.meets_others(&cubes(&[[0, 0], [1, 0], [-1, 0]])));
        assert!(one.meets_others(&cubes(&[[0, 0], [-2, 0]])));
        // The ball reaches down to 2.
        assert!(one.meets_others(&cubes(&[[0, 0], [0, 2]])));
        assert!(!one.meets_others(&cubes(&[[0, 0], [2, 0]])));
        // Without rays every piece is another one.
        assert!(search(Vec::new()).meets_others(&cubes(&[[0, 0]])));
    }

    /// Returns what the check of a certificate costs.
    fn cost(certificate: &Certificate<2>) -> u64 {
        let Certificate { formula, sets, hi, region, curve, levels } = certificate;
        let mut chain = Chain::new(formula, sets, *hi, *region).expect("a region");
        chain.length_above(curve.as_ref().expect("a curve")).expect("a length");
        for level in levels {
            chain.add(level, *hi).expect("all cubes are there");
        }
        chain.work()
    }

    /// A search ends before its certificate costs more than its check may, to the last unit: the curve, the
    /// region and all levels count, and proposals that lost do not.
    #[test]
    fn a_search_keeps_to_the_work_that_a_check_may_cost() {
        let waves = Formula::<2>::parse("cost(2 + cos(3*x1)*sin(2*x2))", &[]).expect("a formula");
        let point = |x: [f64; 2]| Shape::Point(Point::new(x).expect("finite"));
        let two = Shape::Union(vec![point([1.0, 0.5]), point([1.2, -0.5])]);
        let sets = [point([-1.0, 0.0]), two];
        let line = |n: i32| vector![-1.0, 0.0].lerp(&vector![1.0, 0.5], f64::from(n) / 64.0);
        let curve: Vec<_> = (0..=64).map(line).collect();
        let length = length_above(&waves, sets.each_ref(), &curve).expect("a length");
        let run = |budget: fn(&Certificate<2>) -> u64| {
            let (formula, sets, curve, pencils) = (&waves, &sets, curve.clone(), Vec::new());
            let search =
                Search { formula, sets, curve, length, hi: 1.001 * length, pencils, budget };
            search.run(Wanted { gap: 1e-6, cubes: 20_000 }, &mut |_| ControlFlow::Continue(()))
        };
        let all = run(Certificate::budget).expect("a certificate");
        assert!(all.certificate.levels.len() > 2 && all.ended != Ended::TooMuchWork, "{all:?}");
        let exact = run(cost).expect("a certificate");
        assert_eq!((exact.ended, &exact.certificate), (all.ended, &all.certificate));
        let few = run(|found| cost(found) - u64::from(found.levels.len() > 2)).expect("two levels");
        assert_eq!((few.ended, few.certificate.levels.len()), (Ended::TooMuchWork, 2));
        assert_eq!(few.proved.levels, all.proved.levels[..2]);
        assert!(few.certificate.check().is_ok_and(|proved| proved.lower == few.proved.lower));
        let none = run(|found| cost(found) - 1).expect_err("no level");
        assert!(matches!(none, DistanceError::Refused(CheckError::Work { .. })), "{none}");
    }

    /// The halves of the matrix are different steps, of which the file has one. They are equal, since
    /// factors may be in any order.
    #[test]
    fn a_matrix_whose_factors_are_in_another_order_has_a_certificate() {
        let text = "[2 + x1^2, 0.5*x1*x2; x2*x1/2, 3]";
        let refused = between(text, [[-0.5, 0.1], [0.5, 0.2]]).expect_err("another expression");
        let halves = CheckError::Halves { row: 0, column: 1 };
        assert!(matches!(&refused, DistanceError::Refused(error) if *error == halves), "{refused}");
        let text = text.replace("x2*x1/2", "x2*(0.5*x1)");
        let found = between(&text, [[-0.5, 0.1], [0.5, 0.2]]).expect("a certificate");
        let read = AnyCertificate::read(&found.certificate.to_string());
        let verdict = read.and_then(|certificate| certificate.check()).expect("proved");
        assert_eq!((verdict.lower, verdict.upper), (found.proved.lower, found.proved.upper));
        assert!(verdict.gap.expect("a curve") < 0.1);
    }

    /// Under `[2, 0; 3 (x₁ + x₂), 2]` a curve beside the straight one is shorter, if both halves count.
    #[test]
    fn halves_that_may_differ_have_no_certificate() {
        for text in ["[2, 0; 3*(x1 + x2), 2]", "[2, 0; x2, 2]", "[1, 0; 0/x1, 1]"] {
            let refused = between(text, [[0.5, -0.5], [-0.5, 0.5]]).expect_err("two halves");
            let halves = CheckError::Halves { row: 0, column: 1 };
            assert!(
                matches!(&refused, DistanceError::Refused(error) if *error == halves),
                "{refused}"
            );
        }
    }
}
