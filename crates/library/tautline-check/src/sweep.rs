//! One level of the proof: a lower bound on the distance, and the simplices that short curves may
//! meet.

mod parallel;

pub use parallel::in_parallel;

use nalgebra::{SMatrix, SVector};
use tautline_formula::Formula;
use tautline_scalar::Interval;
use tautline_sets::Shape;

use self::parallel::in_chunks;
use crate::{
    CheckError, Level, Place,
    kuhn::{Simplex, simplices},
    lattice::{self, numbers},
    level_sets::{Growth, LevelSets, least_sum},
    quadratic::{Bernstein, gradient},
    rounding::mul_up,
    set::{Piece, Spot, distance_below},
    vertex_test::{Decomposed, curvature, gram},
    work::Work,
};

/// How often the functions of the level sets are made from the simplices that are left.
const ROUNDS: usize = 10;

/// What is proved of `φ` and `ψ` on a simplex.
#[derive(Clone, Copy, Debug)]
struct Tested {
    growths: [Growth; 2],
    /// A lower bound on `φ + ψ`.
    sum: f64,
}

/// A simplex that a set may meet, with values on the part of the set in it.
#[derive(Clone, Copy, Debug)]
struct Meeting {
    simplex: usize,
    /// An upper bound on the set's own function.
    own: f64,
    /// A lower bound on the other function.
    other: f64,
}

/// The simplices of a level, with what is proved on each.
#[derive(Debug)]
pub(crate) struct Sweep<'l, const D: usize> {
    level: &'l Level<D>,
    work: &'l Work<'l>,
    simplices: Vec<Simplex>,
    /// Cube by cube, the simplices of each in order.
    tested: Vec<Tested>,
    /// For each set, the simplices that it may meet.
    meetings: [Vec<Meeting>; 2],
}

/// The result of a level.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Swept<const D: usize> {
    /// Every curve shorter than `hi` has at least this length, or `hi`.
    pub(crate) lower: f64,
    /// The places of cubes with a simplex that such a curve may meet.
    pub(crate) kept: Vec<Place<D>>,
}

impl<'l, const D: usize> Sweep<'l, D> {
    /// Tests every simplex, for no more than this work.
    pub(crate) fn new(
        formula: &Formula<D>,
        sets: [&Shape<D>; 2],
        level: &'l Level<D>,
        work: &'l Work<'l>,
    ) -> Result<Self, CheckError> {
        let simplices = simplices(D);
        let cubes = level.cubes();
        work.spend_cubes::<D>(cubes.places().len())?;
        let corners = cubes.corners();
        let exponent = cubes.exponent();
        let grams: Vec<SMatrix<Interval, D, D>> = in_chunks(corners.len(), &|range| {
            let gram_at = |place: &Place<D>| {
                work.go_on()?;
                Ok(gram(formula, &lattice::point(exponent, place).map(Interval::point)))
            };
            corners[range].iter().map(gram_at).collect::<Result<_, CheckError>>()
        })?;
        let tested = in_chunks(cubes.places().len(), &|range| {
            let (mut scratch, mut found) = (Scratch::default(), Vec::new());
            for place in &cubes.places()[range] {
                work.go_on()?;
                let shift = shift(formula, exponent, place);
                numbers(&corners, place, 1, &mut scratch.numbers);
                let mut decomposed: Vec<_> = corner_order(D)
                    .map(|at| Decomposed::new(grams[scratch.numbers[at]], shift))
                    .collect();
                if decomposed.iter().any(Option::is_none) {
                    // The cube is too large for the vertex test, but H may still have bounds on it.
                    let whole = gram(formula, &lattice::cube(exponent, place));
                    decomposed.fill(Decomposed::new(whole, Interval::point(0.0)));
                }
                let values = scratch.values(level, place);
                let test = |simplex| tested(simplex, &values, &decomposed, 1.0 / cubes.side());
                found.extend(simplices.iter().map(test));
            }
            Ok::<_, CheckError>(found)
        })?;
        let meetings = [
            meetings(&simplices, (sets[0], 0), level, work)?,
            meetings(&simplices, (sets[1], 1), level, work)?,
        ];
        Ok(Self { level, work, simplices, tested, meetings })
    }

    /// Returns a lower bound on the length of the curves from set to set that stay in the cubes and
    /// are shorter than `hi`, and the cubes that they may meet.
    pub(crate) fn shorter_than(&self, hi: f64) -> Result<Swept<D>, CheckError> {
        let mut kept = vec![true; self.tested.len()];
        let mut lower = 0.0_f64;
        for _ in 0..ROUNDS {
            self.work.go_on()?;
            let Some([start, end]) = self.ends(&kept) else {
                return Ok(Swept { lower: hi, kept: Vec::new() });
            };
            let sets = [0, 1].map(|i| {
                let left = self.tested.iter().zip(&kept).filter(|&(_, &kept)| kept);
                LevelSets::new(left.map(|(tested, _)| tested.growths[i]), start[i], end[i])
            });
            lower = lower.max(sets[0].below(end[0])).max(sets[1].below(end[1]));
            let dropped = in_parallel(kept.len(), &|k| {
                let ranges = self.tested[k].growths.map(|growth| growth.range);
                kept[k] && least_sum([&sets[0], &sets[1]], ranges, self.tested[k].sum) >= hi
            });
            let changed = dropped.contains(&true);
            for (kept, dropped) in kept.iter_mut().zip(dropped) {
                *kept &= !dropped;
            }
            if !changed {
                break;
            }
        }
        let places = self.level.cubes().places().iter().zip(kept.chunks(self.simplices.len()));
        let kept = places.filter(|(_, kept)| kept.contains(&true)).map(|(place, _)| *place);
        let kept: Vec<_> = kept.collect();
        let lower = if kept.is_empty() { hi } else { lower.min(hi) };
        Ok(Swept { lower, kept })
    }

    /// Returns, for `φ` and for `ψ`, an upper bound on its own set and a lower bound on the other
    /// one; `None` if no kept simplex meets one of the sets.
    fn ends(&self, kept: &[bool]) -> Option<[[f64; 2]; 2]> {
        let (mut start, mut end) = ([f64::NEG_INFINITY; 2], [f64::INFINITY; 2]);
        for set in [0, 1] {
            let mut meets = false;
            for meeting in self.meetings[set].iter().filter(|meeting| kept[meeting.simplex]) {
                meets = true;
                start[set] = start[set].max(meeting.own);
                end[1 - set] = end[1 - set].min(meeting.other);
            }
            if !meets {
                return None;
            }
        }
        Some([start, end])
    }

    /// Returns lower bounds on the lengths of curves in the cubes from the first set to a boundary
    /// facet of the cubes, and from the second set. Facets do not count that are `ignored`, given the
    /// pieces of a set, if there is one, that the cube may meet.
    pub(crate) fn to_the_boundary(
        &self,
        set: Option<&Shape<D>>,
        ignored: impl Fn(&[&Piece<D>], Spot<'_, D>, usize) -> bool,
    ) -> Result<[f64; 2], CheckError> {
        // If the second set does not meet the cubes, no level is 0 on it, and its function is 0.
        let start = self.meetings.each_ref().map(|meetings| {
            meetings.iter().fold(f64::NEG_INFINITY, |start, meeting| start.max(meeting.own))
        });
        let (exponent, cubes) = (self.level.cubes().exponent(), self.level.cubes());
        let functions = [0, 1].map(|i| {
            let growths = self.tested.iter().map(|tested| tested.growths[i]);
            let finite = growths.clone().map(|g| g.range.1).filter(|t| t.is_finite());
            let end = finite.fold(start[i], f64::max);
            LevelSets::new(growths, start[i], end)
        });
        let pieces = set.map(pieces_of).unwrap_or_default();
        let mut scratch = Scratch::default();
        let mut least = [f64::INFINITY; 2];
        for place in cubes.places() {
            self.work.go_on()?;
            let low = lattice::point(exponent, place);
            let cube = lattice::cube(exponent, place);
            let near: Vec<&Piece<D>> = near(&pieces, &cube).map(|(_, piece)| piece).collect();
            let values = scratch.values(self.level, place);
            for simplex in &self.simplices {
                for (k, outward) in [(D, simplex.axes[D - 1]), (0, simplex.axes[0])] {
                    // Without its last vertex the simplex lies in the low face of the last axis,
                    // without its first one in the high face of the first axis.
                    let mut beside = *place;
                    beside[outward] += if k == 0 { 1 } else { -1 };
                    let spot = Spot { simplex, low: &low, side: cubes.side() };
                    if cubes.contains(&beside) || ignored(&near, spot, k) {
                        continue;
                    }
                    for i in [0, 1] {
                        let facet = Bernstein::<D>::of(simplex, values[i]).range_opposite(k);
                        least[i] = least[i].min(functions[i].below(facet.lo()));
                    }
                }
            }
        }
        Ok(least)
    }
}

/// Returns `ε = C a²/8`, undefined if `C` is unknown.
fn shift<const D: usize>(formula: &Formula<D>, exponent: i32, place: &Place<D>) -> Interval {
    let curvature = curvature(formula, &lattice::cube(exponent, place));
    Interval::point(mul_up(curvature, lattice::side(exponent).powi(2) / 8.0))
}

/// Returns the numbers of the corners in lexicographic order, by their bits.
fn corner_order(dimension: usize) -> impl Iterator<Item = usize> {
    (0..1 << dimension)
        .map(move |bits: usize| (0..dimension).fold(0, |at, axis| 2 * at + (bits >> axis & 1)))
}

fn tested<const D: usize>(
    simplex: &Simplex,
    values: &[&[f64]; 2],
    corners: &[Option<Decomposed<D>>],
    inverse_side: f64,
) -> Tested {
    let forms = values.map(|values| Bernstein::<D>::of(simplex, values));
    let growths = [0, 1].map(|i| {
        let range = forms[i].range();
        let mut q = 0.0_f64;
        for (k, &corner) in simplex.corners.iter().enumerate() {
            let square = corners[corner].as_ref().map_or(f64::INFINITY, |decomposed| {
                decomposed.inverse_square(&gradient(simplex, values[i], k, inverse_side))
            });
            q = q.max(square);
        }
        Growth { range: (range.lo(), range.hi()), q }
    });
    Tested { growths, sum: forms[0].plus(&forms[1]).range().lo() }
}

/// A piece of a set, with what it is on simplices.
type Both<'s, const D: usize> = (&'s Shape<D>, Piece<D>);

fn pieces_of<const D: usize>(set: &Shape<D>) -> Vec<Both<'_, D>> {
    set.pieces().into_iter().zip(Piece::of(set)).collect()
}

/// Returns the pieces that a cube may meet.
fn near<'p, const D: usize>(
    pieces: &'p [Both<'_, D>],
    cube: &SVector<Interval, D>,
) -> impl Iterator<Item = &'p Both<'p, D>> {
    pieces.iter().filter(move |(shape, _)| !(distance_below(shape, cube) > 0.0))
}

/// Returns the simplices that a set may meet.
fn meetings<const D: usize>(
    simplices: &[Simplex],
    (set, own): (&Shape<D>, usize),
    level: &Level<D>,
    work: &Work<'_>,
) -> Result<Vec<Meeting>, CheckError> {
    let pieces = pieces_of(set);
    let cubes = level.cubes();
    let of_cube = |scratch: &mut Scratch, n: usize| {
        work.go_on()?;
        let place = &cubes.places()[n];
        let cube = lattice::cube(cubes.exponent(), place);
        let near: Vec<_> = near(&pieces, &cube).collect();
        if near.is_empty() {
            return Ok::<_, CheckError>(Vec::new());
        }
        near.iter().try_for_each(|(shape, _)| work.spend_meeting(shape))?;
        let low = lattice::point(cubes.exponent(), place);
        let values = scratch.values(level, place);
        let mut meetings = Vec::new();
        for (s, simplex) in simplices.iter().enumerate() {
            let spot = Spot { simplex, low: &low, side: cubes.side() };
            let forms = values.map(|values| Bernstein::<D>::of(simplex, values));
            let values = |piece: &Piece<D>| piece.values(spot, [&forms[own], &forms[1 - own]]);
            let found = near
                .iter()
                .map(|(_, piece)| piece)
                .filter_map(values)
                .map(|[a, b]| (a.hi(), b.lo()));
            // One for all pieces, of which there may be as many as cubes.
            if let Some((own, other)) = found.reduce(|a, b| (a.0.max(b.0), a.1.min(b.1))) {
                meetings.push(Meeting { simplex: n * simplices.len() + s, own, other });
            }
        }
        Ok(meetings)
    };
    in_chunks(cubes.places().len(), &|range| {
        let (mut scratch, mut found) = (Scratch::default(), Vec::new());
        for n in range {
            found.extend(of_cube(&mut scratch, n)?);
        }
        Ok(found)
    })
}

/// Memory for one cube.
#[derive(Debug, Default)]
struct Scratch {
    numbers: Vec<usize>,
    values: [Vec<f64>; 2],
}

impl Scratch {
    /// Returns the values of `φ` and `ψ` at the `3^D` nodes of a cube.
    fn values<const D: usize>(&mut self, level: &Level<D>, place: &Place<D>) -> [&[f64]; 2] {
        let Self { numbers: at, values } = self;
        numbers(level.nodes(), place, 2, at);
        for (values, all) in values.iter_mut().zip(level.values()) {
            values.clear();
            values.extend(at.iter().map(|&n| all[n]));
        }
        [&self.values[0], &self.values[1]]
    }
}

#[cfg(test)]
mod tests;
