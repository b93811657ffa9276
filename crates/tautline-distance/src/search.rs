//! The search for a certificate: levels of smaller and smaller cubes near all short curves.

use std::ops::ControlFlow;

use nalgebra::SVector;
use rayon::prelude::*;
use tautline_check::{Certificate, Chain, Cubes, Level, Place, Proved, length_above};
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    DistanceError,
    fan::Pencil,
    geodesic::Geodesic,
    marching::{Nodes, gram, point},
    seed::seed,
};

/// What is wanted of a certificate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Wanted {
    /// The largest gap `(upper − lower)/upper`.
    pub gap: f64,
    /// The most cubes of all levels together.
    pub cubes: usize,
}

/// A certificate, and what it proves.
#[derive(Clone, Debug)]
pub struct Found<const D: usize> {
    /// The certificate.
    pub certificate: Certificate<D>,
    /// What it proves.
    pub proved: Proved<D>,
    /// Why the search ended.
    pub ended: Ended,
}

/// Why a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum Ended {
    /// The gap is as small as wanted.
    Reached,
    /// Smaller cubes no longer made the gap smaller.
    Stalled,
    /// The next level would have had too many cubes.
    Cubes,
    /// The observer stopped it.
    Stopped,
}

/// What a search has done so far.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// The number of levels.
    pub levels: usize,
    /// The number of cubes of all levels.
    pub cubes: usize,
    /// The lower bound so far, in `m`.
    pub lower: f64,
    /// The length of the curve, in `m`.
    pub upper: f64,
}

/// How much longer than the curve the curves are that are followed, relative to its length. All
/// minimal geodesics are among them.
const LONGER: f64 = 1e-9;

/// How much longer the curves are that the levels keep, so that a checker that rounds differently
/// keeps no other cubes.
pub(crate) const KEPT: f64 = 1e-12;

/// A search.
pub(crate) struct Search<'f, const D: usize> {
    pub(crate) formula: &'f Formula<D>,
    pub(crate) sets: &'f [Shape<D>; 2],
    pub(crate) curve: &'f [SVector<f64, D>],
    pub(crate) length: f64,
    pub(crate) hi: f64,
    pub(crate) pencil: Option<(Geodesic<D>, Pencil<D>)>,
}

/// Searches for a certificate of the distance between two sets, given a polygon between them.
///
/// `observe` is told about every level, and may stop the search.
///
/// # Errors
///
/// [`DistanceError`] if the polygon proves no length, or no region holds the short curves.
pub fn search<const D: usize>(
    formula: &Formula<D>,
    sets: &[Shape<D>; 2],
    curve: &[SVector<f64, D>],
    wanted: Wanted,
    observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
) -> Result<Found<D>, DistanceError> {
    let length = length_above(formula, sets.each_ref(), curve).map_err(DistanceError::Curve)?;
    if !(length > 0.0 && length.is_finite()) {
        return Err(DistanceError::Length { length });
    }
    let pencil = Geodesic::near(formula, curve, length)
        .and_then(|geodesic| Some((geodesic, Pencil::along(formula, sets, &geodesic)?)));
    let hi = length * (1.0 + LONGER);
    Search { formula, sets, curve, length, hi, pencil }.run(wanted, observe)
}

impl<const D: usize> Search<'_, D> {
    fn run(
        &self,
        wanted: Wanted,
        observe: &mut dyn FnMut(Progress) -> ControlFlow<()>,
    ) -> Result<Found<D>, DistanceError> {
        let (region, first, mut chain) = self.first_level()?;
        let mut levels = vec![first];
        let mut cubes = levels[0].cubes().places().len();
        let gap = |chain: &Chain<'_, D>| (self.length - chain.lower()) / self.length;
        let mut stalled = 0;
        let ended = loop {
            let progress =
                Progress { levels: levels.len(), cubes, lower: chain.lower(), upper: self.length };
            if observe(progress).is_break() {
                break Ended::Stopped;
            }
            if gap(&chain) <= wanted.gap {
                break Ended::Reached;
            }
            if stalled >= 3 {
                break Ended::Stalled;
            }
            let exponent = levels[levels.len() - 1].cubes().exponent() - 1;
            let required = chain.required(exponent).map_err(DistanceError::Refused)?;
            let more = required.places().len();
            if more == 0 || cubes + more > wanted.cubes {
                break Ended::Cubes;
            }
            let (level, next) = self.next_level(&chain, required, levels.len())?;
            stalled = if gap(&next) > 0.7 * gap(&chain) { stalled + 1 } else { 0 };
            chain = next;
            cubes += more;
            levels.push(level);
        };
        let certificate = Certificate {
            formula: self.formula.clone(),
            sets: self.sets.clone(),
            hi: self.hi,
            region,
            curve: Some(self.curve.to_vec()),
            levels,
        };
        let proved = chain.proved(Some(self.length)).map_err(DistanceError::Refused)?;
        Ok(Found { certificate, proved, ended })
    }

    /// Returns the best of the levels on these cubes that are proposed.
    fn next_level<'c>(
        &self,
        chain: &Chain<'c, D>,
        cubes: Cubes<D>,
        number: usize,
    ) -> Result<(Level<D>, Chain<'c, D>), DistanceError> {
        let before = (self.length - chain.lower()) / self.length;
        let scale = 1.0 + 0.3 * before.min(0.01);
        let mut best: Option<(Level<D>, Chain<'c, D>)> = None;
        let mut attempt = |values: [Vec<f64>; 2], what: &str| -> Result<f64, DistanceError> {
            let values = values.map(|values| scaled(values, scale));
            let level =
                Level::new(number, cubes.clone(), values).map_err(DistanceError::Refused)?;
            let mut next = chain.clone();
            next.add(&level, self.hi * (1.0 + KEPT)).map_err(DistanceError::Refused)?;
            let lower = next.lower();
            if std::env::var("TRACE").is_ok() {
                eprintln!(
                    "  {what}: {:e} {} -> {}",
                    1.0 - lower / self.length,
                    cubes.places().len(),
                    next.kept().map_or(0, |k| k.places().len())
                );
            }
            if best.as_ref().is_none_or(|(_, best)| lower > best.lower()) {
                best = Some((level, next));
            }
            Ok((self.length - lower) / self.length)
        };
        let spacing = 0.5 * cubes.side();
        let nodes: Vec<SVector<f64, D>> =
            cubes.nodes().iter().map(|place| point(place, spacing)).collect();
        let by = |value: &(dyn Fn(usize, &SVector<f64, D>) -> f64 + Sync)| {
            [0, 1].map(|side| nodes.par_iter().map(|x| value(side, x)).collect())
        };
        if let Some((geodesic, pencil)) = &self.pencil {
            if attempt(by(&|side, x| pencil.fans[side].value_near(x)), "C")? < 0.4 * before {
                return best.ok_or(DistanceError::Stopped);
            }
        }
        let wide = dilated(&cubes, if D == 2 { 4 } else { 3 })?;
        let nodes = Nodes::new(self.formula, &wide);
        for source in [Source::Calibration, Source::Set] {
            let values = [0, 1].map(|side| {
                let all = nodes.march(self.seeds(&nodes, side, source));
                let value = |place: &Place<D>| nodes.value(&all, place).unwrap_or(0.0);
                cubes.nodes().iter().map(value).collect()
            });
            if attempt(values, &format!("B {source:?}"))? < 0.5 * before {
                break;
            }
        }
        best.ok_or(DistanceError::Stopped)
    }

    /// Returns the values from which the distance from a set spreads over the nodes, and infinity at
    /// all other nodes.
    pub(crate) fn seeds(&self, nodes: &Nodes<D>, side: usize, source: Source) -> Vec<f64> {
        let points = nodes.points();
        let band = 4.0 * nodes.spacing();
        let set = &self.sets[side];
        if let Some((geodesic, pencil)) = &self.pencil
            && source == Source::Calibration
            && matches!(set, Shape::Point(_))
        {
            // Everything behind a front a little beyond the point.
            let end = if side == 0 { self.curve[0] } else { self.curve[self.curve.len() - 1] };
            let reach = SOURCE * self.euclidean();
            let front = band * gram(self.formula, &end).trace().sqrt();
            let is_behind = |x: &&SVector<f64, D>| {
                (*x - end).norm() <= reach && pencil.fans[side].value_near(x) <= front
            };
            let behind: Vec<SVector<f64, D>> = points.iter().filter(is_behind).copied().collect();
            let rings = if D == 2 { 6 } else { 3 };
            let wide = pencil.reaching(self.formula, self.sets, geodesic, rings, &behind);
            let fan = wide.as_ref().map_or(&pencil.fans[side], |wide| &wide.fans[side]);
            let value =
                |x: &SVector<f64, D>| if is_behind(&x) { fan.value(x) } else { f64::INFINITY };
            return points.par_iter().map(value).collect();
        }
        let value = |x: &SVector<f64, D>| seed(self.formula, set, band, x).unwrap_or(f64::INFINITY);
        points.par_iter().map(value).collect()
    }

    /// Returns the Euclidean length of the curve.
    pub(crate) fn euclidean(&self) -> f64 {
        self.curve.windows(2).map(|pair| (pair[1] - pair[0]).norm()).sum()
    }
}

/// How far from a point its calibration is used as a source, relative to the length of the curve.
const SOURCE: f64 = 0.25;

/// Where a marched distance starts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    /// The set.
    Set,
    /// For a point, the calibration near it, whose rays meet behind the point. A distance from the
    /// point itself is not smooth there, which costs an order.
    Calibration,
}

/// Returns the values times a factor.
pub(crate) fn scaled(values: Vec<f64>, factor: f64) -> Vec<f64> {
    values.into_iter().map(|value| value * factor).collect()
}

/// Returns the cubes within `by` cubes of these, along the axes.
pub(crate) fn dilated<const D: usize>(
    cubes: &Cubes<D>,
    by: i32,
) -> Result<Cubes<D>, DistanceError> {
    let mut cubes = cubes.clone();
    for axis in 0..D {
        let moved = cubes.places().iter().flat_map(|place| {
            (-by..=by).map(move |step| {
                let mut place = *place;
                place[axis] += step;
                place
            })
        });
        cubes = Cubes::new(cubes.exponent(), moved.collect()).map_err(DistanceError::Refused)?;
    }
    Ok(cubes)
}
