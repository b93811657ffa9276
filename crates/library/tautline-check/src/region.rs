//! `Region`: why short curves cannot leave the cubes of the first level.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_scalar::Interval;
use tautline_sets::Shape;

use crate::{
    CheckError, Cubes, Place,
    lattice::{self, halves},
    rounding::{add_down, div_up, mul_down, sqrt_down},
    set::{Piece, Spot, bounding_box, distance_below},
    steps,
    sweep::Sweep,
    vertex_test::{Decomposed, gram},
    work::{UNLIMITED, Work},
};

/// The most cubes of the first level.
pub(crate) const MOST: usize = 1 << 23;

/// The most boxes on which `c₁` is proved.
const BOXES: usize = 1 << 18;

/// Why curves from the first set `X⁽⁰⁾` to the second set `X⁽¹⁾` that are shorter than `hi` stay in
/// the cubes of the first level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Region {
    /// `H ≥ c₁ I` within `radius` of each bounded set, which the checker proves. Curves shorter than
    /// `hi` cannot leave these tubes, since `2 √c₁ radius ≥ hi`; with a single tube, about a bounded
    /// first set, `√c₁ radius ≥ hi`. So they stay where
    /// `√c₁ (dist(x, X⁽⁰⁾) + dist(x, X⁽¹⁾)) < hi`.
    Tubes {
        /// The radius, in `ℓ`.
        radius: f64,
        /// A lower bound on the eigenvalues of `H`.
        c1: f64,
    },
    /// `H ≥ c₁ I` everywhere, as declared by whoever wrote the certificate: a hypothesis.
    Declared {
        /// The constant.
        c1: f64,
    },
    /// Every curve in the cubes from the first set to the boundary of the cubes, outside the second
    /// set, has length at least `hi`.
    ExitOne,
    /// Both sets lie in the cubes, and the lengths of curves from the boundary to the first and to
    /// the second set add up to at least `hi`.
    ExitTwo,
}

impl Region {
    /// Proves the constant of tubes.
    ///
    /// # Errors
    ///
    /// [`CheckError::Tubes`] if the tubes are too thin, [`CheckError::Constant`] if `c₁` is not proved
    /// on them, [`CheckError::Unbounded`] if their radius is not a positive number,
    /// [`CheckError::Declared`] if a declared `c₁` is not, and [`CheckError::Halves`] if two entries that
    /// mirror each other are not known to be equal.
    pub fn prove<const D: usize>(
        &self,
        formula: &Formula<D>,
        sets: [&Shape<D>; 2],
        hi: f64,
    ) -> Result<(), CheckError> {
        if let Some((row, column)) = formula.unequal_halves() {
            return Err(CheckError::Halves { row, column });
        }
        steps::prove_region(*self, formula, sets, hi, &UNLIMITED)
    }

    /// Does the same, for no more than this work.
    pub(crate) fn prove_within<const D: usize>(
        &self,
        formula: &Formula<D>,
        sets: [&Shape<D>; 2],
        hi: f64,
        work: &Work<'_>,
    ) -> Result<(), CheckError> {
        match *self {
            Region::Tubes { radius, c1 } => prove_tubes(formula, sets, hi, [radius, c1], work),
            Region::Declared { c1 } if !(c1 > 0.0 && c1.is_finite()) => {
                Err(CheckError::Declared { c1 })
            }
            _ => Ok(()),
        }
    }

    /// Returns the cubes of side `2^exponent` that the first level has to contain.
    ///
    /// # Errors
    ///
    /// [`CheckError::Unbounded`] if a set is unbounded that must be bounded, [`CheckError::TooLarge`]
    /// if there are too many cubes, [`CheckError::TooFar`] and [`CheckError::Place`] if they are too
    /// far from the origin for their side, [`CheckError::Side`] if that is out of range.
    pub fn required<const D: usize>(
        &self,
        sets: [&Shape<D>; 2],
        hi: f64,
        exponent: i32,
    ) -> Result<Cubes<D>, CheckError> {
        steps::required(*self, sets, hi, (exponent, MOST, &UNLIMITED))
    }

    /// Does the same, given the exponent, if there are no more than so many cubes.
    pub(crate) fn required_within<const D: usize>(
        &self,
        sets: [&Shape<D>; 2],
        hi: f64,
        limits: (i32, usize, &Work<'_>),
    ) -> Result<Cubes<D>, CheckError> {
        let exponent = limits.0;
        let meets = |set: usize| {
            move |cube: &SVector<Interval, D>| !(distance_below(sets[set], cube) > 0.0)
        };
        let cubes = match *self {
            Region::ExitOne => cubes_in(sets[0], 0.0, limits, meets(0))?,
            Region::ExitTwo => {
                let mut cubes = cubes_in(sets[0], 0.0, limits, meets(0))?;
                cubes.extend(cubes_in(sets[1], 0.0, limits, meets(1))?);
                cubes
            }
            Region::Tubes { c1, .. } | Region::Declared { c1 } => {
                let reach = div_up(hi, sqrt_down(c1));
                let near = |cube: &SVector<Interval, D>| {
                    let both =
                        add_down(distance_below(sets[0], cube), distance_below(sets[1], cube));
                    !(mul_down(sqrt_down(c1), both) >= hi)
                };
                let bounded = sets.into_iter().find(|set| bounding_box(set).is_some());
                cubes_in(bounded.ok_or(CheckError::Unbounded)?, reach, limits, near)?
            }
        };
        Cubes::new(exponent, cubes)
    }

    /// Proves that no curve shorter than `hi` leaves the cubes, if that follows from the values on
    /// them.
    pub(crate) fn prove_exit<const D: usize>(
        &self,
        sets: [&Shape<D>; 2],
        hi: f64,
        sweep: &Sweep<'_, D>,
    ) -> Result<(), CheckError> {
        let least = match self {
            Region::Tubes { .. } | Region::Declared { .. } => return Ok(()),
            Region::ExitOne => {
                let in_set = |near: &[&Piece<D>], spot: Spot<'_, D>, k| {
                    near.iter().any(|piece| piece.holds_facet(spot, k))
                };
                sweep.to_the_boundary(Some(sets[1]), in_set)?[0]
            }
            Region::ExitTwo => {
                let [first, second] = sweep.to_the_boundary(None, |_, _, _| false)?;
                add_down(first, second)
            }
        };
        if least >= hi { Ok(()) } else { Err(CheckError::Exit { least, hi }) }
    }
}

/// Returns the places of cubes of side `2^exponent` within `reach` of a bounded set that `counts`.
/// If `counts` is false for a larger cube, it must be false for the cubes in it.
fn cubes_in<const D: usize>(
    set: &Shape<D>,
    reach: f64,
    (exponent, most, work): (i32, usize, &Work<'_>),
    counts: impl Fn(&SVector<Interval, D>) -> bool,
) -> Result<Vec<Place<D>>, CheckError> {
    let around = bounding_box(set).ok_or(CheckError::Unbounded)?;
    let reach = Interval::new(-reach, reach).map_err(|_| CheckError::Unbounded)?;
    let around = around.map(|side| side + reach);
    // A cube that touches the box only from outside counts too.
    let meets = |cube: &SVector<Interval, D>| {
        cube.iter().zip(&around).all(|(a, b)| a.lo() <= b.hi() && b.lo() <= a.hi())
    };
    // The largest cubes are as large as the box: at most 3 along each axis meet it.
    let width = around.iter().fold(0.0, |width: f64, side| width.max(side.width()));
    let mut largest = exponent;
    while lattice::side(largest) < width {
        largest += 1;
        if largest > exponent + 28 {
            return Err(CheckError::TooLarge { most });
        }
    }
    let first = |i: usize| (around[i].lo() / lattice::side(largest)).floor() - 1.0;
    // All places down to the smallest cubes are integers of 32 bits. Places that wrap around would be
    // lost, and with them the proof.
    let farthest = lattice::side(30 - (largest - exponent)) - 4.0;
    if (0..D).any(|i| !(first(i).abs() <= farthest)) {
        return Err(CheckError::TooFar { exponent });
    }
    let required = |largest: i32, place: &Place<D>| {
        let cube = lattice::cube(largest, place);
        meets(&cube) && counts(&cube)
    };
    let mut left: Vec<(i32, Place<D>)> = (0..4_usize.pow(D as u32))
        .map(|at| std::array::from_fn(|i| first(i) as i32 + (at >> (2 * i) & 3) as i32))
        .map(|place| (largest, place))
        .collect();
    let (mut found, mut seen) = (Vec::new(), 0);
    // The halves of a cube come before the other cubes, so that few are kept in memory.
    while let Some((size, place)) = left.pop() {
        work.spend_seen()?;
        seen += 1;
        if !work.is_limited() && seen > (most << D).saturating_mul(2) {
            return Err(CheckError::TooLarge { most });
        }
        if !required(size, &place) {
            continue;
        }
        if size > exponent {
            left.extend(halves(&place).map(|half| (size - 1, half)));
        } else if found.len() < most {
            found.push(place);
        } else {
            return Err(CheckError::TooLarge { most });
        }
    }
    Ok(found)
}

/// Proves that curves shorter than `hi` stay in the tubes, and that `H ≥ c₁ I` there.
fn prove_tubes<const D: usize>(
    formula: &Formula<D>,
    sets: [&Shape<D>; 2],
    hi: f64,
    [radius, c1]: [f64; 2],
    work: &Work<'_>,
) -> Result<(), CheckError> {
    let tubes: Vec<&Shape<D>> =
        sets.into_iter().filter(|set| bounding_box(set).is_some()).collect();
    // One tube has to be as wide as the curves are long, two together. Half of `hi` might underflow.
    let together = mul_down(tubes.len() as f64, mul_down(sqrt_down(c1), radius));
    if !(together >= hi) || tubes.is_empty() {
        return Err(CheckError::Tubes { radius, c1, hi });
    }
    for tube in tubes {
        let reach = Interval::new(-radius, radius).map_err(|_| CheckError::Unbounded)?;
        let around = bounding_box(tube).ok_or(CheckError::Unbounded)?.map(|side| side + reach);
        let mut left = vec![around];
        for _ in 0..BOXES {
            let Some(part) = left.pop() else { break };
            work.spend(work.formula + work.pieces)?;
            if distance_below(tube, &part) > radius || is_at_least(formula, &part, c1) {
                continue;
            }
            let (low, high) = halved(&part);
            left.extend([low, high]);
        }
        if !left.is_empty() {
            return Err(CheckError::Constant { c1, radius });
        }
    }
    Ok(())
}

/// Returns whether `H ≥ c₁ I` is proved on a box.
fn is_at_least<const D: usize>(formula: &Formula<D>, x: &SVector<Interval, D>, c1: f64) -> bool {
    // If all pivots of the matrix of intervals are positive, so are those of every matrix in it.
    Decomposed::new(gram(formula, x), Interval::point(c1)).is_some()
}

/// Returns the halves of a box, cut across its longest side.
fn halved<const D: usize>(
    x: &SVector<Interval, D>,
) -> (SVector<Interval, D>, SVector<Interval, D>) {
    let longest = (1..D).fold(0, |a, b| if x[b].width() > x[a].width() { b } else { a });
    let middle = Interval::point(x[longest].midpoint());
    let (mut low, mut high) = (*x, *x);
    low[longest] = Interval::point(x[longest].lo()).hull(middle);
    high[longest] = middle.hull(Interval::point(x[longest].hi()));
    (low, high)
}
