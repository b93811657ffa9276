//! `Certificate`: what a proof of a distance needs, as data.

use nalgebra::SVector;
use tautline_formula::Formula;
use tautline_sets::Shape;

use crate::{
    CheckError, Cubes, Level, Place, Region,
    region::MOST,
    steps::{self, Lengths},
    work::{self, UNLIMITED, Work, lines},
};

/// The most lines of a formula. No reader has to know formulas of any length.
const MOST_LINES: usize = 500_000;

/// How many times as large as its normal the offset of a half-space may be: `2¹⁰⁰⁰`. The quotient is then
/// a double.
const FARTHEST_WALL: f64 = f64::from_bits((1023 + 1000) << 52);

/// A certificate of the distance between two sets under a metric.
///
/// Every number in it is data. What it proves is computed by [`check`](Certificate::check).
#[derive(Clone, Debug, PartialEq)]
pub struct Certificate<const D: usize> {
    /// The metric. The entries above the diagonal and those below it have to be the same steps, as those
    /// of [`Formula::of_upper_half`] are.
    pub formula: Formula<D>,
    /// The sets `X⁽⁰⁾` and `X⁽¹⁾`.
    pub sets: [Shape<D>; 2],
    /// The length, in `m`, below which every curve is followed. Nothing beyond it is proved.
    pub hi: f64,
    /// Why such curves stay in the cubes of the first level.
    pub region: Region,
    /// The points of a polygon from set to set that is shorter than `hi`, if there is one.
    pub curve: Option<Vec<SVector<f64, D>>>,
    /// The levels, from coarse to fine.
    pub levels: Vec<Level<D>>,
}

/// What a certificate proves.
#[derive(Clone, Debug, PartialEq)]
pub struct Proved<const D: usize> {
    /// A lower bound on the distance, in `m`. Every curve between the sets is at least as long.
    pub lower: f64,
    /// An upper bound on the length of the curve, and hence on the distance, in `m`.
    pub upper: Option<f64>,
    /// `H ≥ c₁ I`, if that is a hypothesis and not proved.
    pub declared: Option<f64>,
    /// The cubes of the last level that curves shorter than `hi` may meet. If there is a curve, they
    /// contain every minimal geodesic.
    pub corridor: Cubes<D>,
    /// What the levels prove, from coarse to fine: the number of cubes, and the lower bound so far, in
    /// `m`.
    pub levels: Vec<(usize, f64)>,
}

impl<const D: usize> Proved<D> {
    /// Returns `(upper − lower)/upper`, how much longer than a minimal one the curve can be, relative
    /// to its length; `None` without a curve, and 0 if it has length 0.
    #[must_use]
    pub fn gap(&self) -> Option<f64> {
        self.upper.map(|upper| if upper == 0.0 { 0.0 } else { (upper - self.lower) / upper })
    }
}

impl<const D: usize> Certificate<D> {
    /// Proves a lower bound on the distance, and an upper one if there is a curve.
    ///
    /// The bounds are about curves that stay where every entry of `H` is defined and `H` is positive
    /// definite. The time is at most some minutes for each megabyte of the file: a certificate that
    /// asks for more is refused.
    ///
    /// # Errors
    ///
    /// [`CheckError`] if the certificate proves nothing.
    pub fn check(&self) -> Result<Proved<D>, CheckError> {
        self.check_while(&|| true)
    }

    /// Does the same as long as `go_on`, which is often asked, returns true.
    ///
    /// # Errors
    ///
    /// [`CheckError::Stopped`] if it returned false, with what was checked until then; the others of
    /// [`check`](Certificate::check).
    pub fn check_while(&self, go_on: &(dyn Fn() -> bool + Sync)) -> Result<Proved<D>, CheckError> {
        let (chain, upper) = self.proof(Work::limited(self, go_on))?;
        chain.proved(upper)
    }

    /// Returns the most units of work that its check may cost. Every level raises it.
    #[must_use]
    pub fn budget(&self) -> u64 {
        work::budget(self)
    }

    /// Returns the proof with all levels, and the length of the curve, for no more than this work.
    pub(crate) fn proof<'c>(
        &'c self,
        work: Work<'c>,
    ) -> Result<(Chain<'c, D>, Option<f64>), CheckError> {
        let mut chain = Chain::within(&self.formula, &self.sets, self.hi, self.region, work)?;
        let upper = match &self.curve {
            None => None,
            Some(points) => {
                let length = chain.length_above(points)?;
                if !(length < self.hi) {
                    return Err(CheckError::CurveLength { length, hi: self.hi });
                }
                Some(length)
            }
        };
        if self.levels.is_empty() {
            return Err(CheckError::Empty);
        }
        for level in &self.levels {
            if chain.is_closed() {
                break;
            }
            chain.add(level, self.hi)?;
        }
        Ok((chain, upper))
    }
}

/// A proof, level by level.
///
/// All curves shorter than `hi` stay in the cubes of the first level. If they stay in those of a
/// level, they stay in the cubes that it keeps, and the next level has to contain these.
#[derive(Clone, Debug)]
pub struct Chain<'c, const D: usize> {
    formula: &'c Formula<D>,
    sets: &'c [Shape<D>; 2],
    hi: f64,
    region: Region,
    work: Work<'c>,
    lower: f64,
    /// The cubes kept by the last level.
    kept: Option<Cubes<D>>,
    levels: Vec<(usize, f64)>,
}

impl<'c, const D: usize> Chain<'c, D> {
    /// Begins a proof about curves shorter than `hi`.
    ///
    /// # Errors
    ///
    /// [`CheckError::Bound`] unless `hi` is positive and finite, [`CheckError::Dimension`] in more
    /// than four dimensions, [`CheckError::Formula`] for more than 500,000 lines, [`CheckError::Halves`]
    /// if two entries of the matrix that mirror each other are different steps, [`CheckError::Set`] for a
    /// set that is not elementary, [`CheckError::HalfSpace`] if one has an offset above `2¹⁰⁰⁰` times its normal, and the errors of
    /// [`Region::prove`].
    pub fn new(
        formula: &'c Formula<D>,
        sets: &'c [Shape<D>; 2],
        hi: f64,
        region: Region,
    ) -> Result<Self, CheckError> {
        Self::within(formula, sets, hi, region, Work::counted(formula, sets))
    }

    fn within(
        formula: &'c Formula<D>,
        sets: &'c [Shape<D>; 2],
        hi: f64,
        region: Region,
        work: Work<'c>,
    ) -> Result<Self, CheckError> {
        if !(1..=crate::LARGEST_DIMENSION).contains(&D) {
            return Err(CheckError::Dimension { dimension: D });
        }
        if !(hi > 0.0 && hi.is_finite()) {
            return Err(CheckError::Bound { hi });
        }
        if lines(formula) > MOST_LINES {
            return Err(CheckError::Formula { lines: lines(formula), most: MOST_LINES });
        }
        for piece in sets.iter().flat_map(Shape::pieces) {
            let wall = match piece {
                Shape::HalfSpace(wall) => wall,
                Shape::Point(_) | Shape::Ball(_) | Shape::AxisBox(_) => continue,
                other => return Err(CheckError::Set { kind: other.name() }),
            };
            let (normal, offset) = wall.given();
            if offset.abs() > FARTHEST_WALL * normal.amax() {
                return Err(CheckError::HalfSpace { offset, normal: normal.amax() });
            }
        }
        let mut pairs = (0..D).flat_map(|i| (i + 1..D).map(move |j| (i, j)));
        let differ = pairs.find(|&(i, j)| formula.entry(i, j) != formula.entry(j, i));
        if let Some((row, column)) = differ {
            return Err(CheckError::Halves { row, column });
        }
        steps::prove_region(region, formula, sets.each_ref(), hi, &work)?;
        Ok(Self { formula, sets, hi, region, work, lower: 0.0, kept: None, levels: Vec::new() })
    }

    /// Returns the lower bound proved so far, in `m`.
    #[must_use]
    pub fn lower(&self) -> f64 {
        self.lower
    }

    /// Returns what the proof has cost so far, in the units of `FORMAT.md`. A certificate whose proof costs
    /// more than its [`budget`](Certificate::budget) is refused.
    #[must_use]
    pub fn work(&self) -> u64 {
        self.work.spent()
    }

    /// Returns an upper bound on the length of a polygon, in `m`, and counts its work.
    ///
    /// # Errors
    ///
    /// As [`length_above`](crate::length_above).
    pub fn length_above(&self, points: &[SVector<f64, D>]) -> Result<f64, CheckError> {
        steps::length(self.formula, self.sets.each_ref(), points, &self.work)
    }

    /// Returns whether no curve shorter than `hi` is left, so that more levels prove no more.
    #[must_use]
    pub fn is_closed(&self) -> bool {
        self.kept.as_ref().is_some_and(|kept| kept.places().is_empty())
    }

    /// Returns the cubes that curves shorter than `hi` may meet; `None` before the first level.
    #[must_use]
    pub fn kept(&self) -> Option<&Cubes<D>> {
        self.kept.as_ref()
    }

    /// Returns the cubes of side `2^exponent` that the next level has to contain.
    ///
    /// # Errors
    ///
    /// [`CheckError::Sides`] if they are neither as large as those of the level before nor half as
    /// large, [`CheckError::Side`] and [`CheckError::Place`] if halves are out of range; for the first
    /// level the errors of [`Region::required`].
    pub fn required(&self, exponent: i32) -> Result<Cubes<D>, CheckError> {
        self.required_of(exponent, MOST, &UNLIMITED)
    }

    fn required_of(
        &self,
        exponent: i32,
        most: usize,
        work: &Work<'_>,
    ) -> Result<Cubes<D>, CheckError> {
        match &self.kept {
            None => {
                let limits = (exponent, most, work);
                steps::required(self.region, self.sets.each_ref(), self.hi, limits)
            }
            Some(kept) if exponent == kept.exponent() => Ok(kept.clone()),
            Some(kept) if exponent == kept.exponent() - 1 => kept.halved(),
            Some(kept) => Err(CheckError::Sides {
                level: self.levels.len(),
                exponent,
                before: kept.exponent(),
            }),
        }
    }

    /// Adds a level. `keep` is the length below which curves are kept: at least `hi`, or a little
    /// more so that a checker that rounds differently keeps no other cubes.
    ///
    /// # Errors
    ///
    /// [`CheckError::Empty`] without a cube, [`CheckError::Missing`] if a required cube is missing,
    /// the errors of [`required`](Chain::required), and [`CheckError::Exit`] if curves may leave the
    /// first level.
    pub fn add(&mut self, level: &Level<D>, keep: f64) -> Result<(), CheckError> {
        let cubes = level.cubes();
        let most = self.work.most_cubes::<D>(cubes.places().len());
        let required = self.required_of(cubes.exponent(), most, &self.work)?;
        if let Some(place) = cubes.first_missing(required.places()) {
            return Err(CheckError::Missing { level: self.levels.len(), place: place.to_vec() });
        }
        if cubes.places().is_empty() {
            return Err(CheckError::Empty);
        }
        let lengths = Lengths { hi: self.hi, keep: self.hi.max(keep) };
        let first = self.kept.is_none().then_some(self.region);
        let sets = self.sets.each_ref();
        let swept = steps::sweep(self.formula, sets, level, lengths, first, &self.work)?;
        let kept: Vec<Place<D>> = swept.kept;
        self.lower = self.lower.max(swept.lower.min(self.hi));
        self.kept = Some(Cubes::new(cubes.exponent(), kept)?);
        self.levels.push((cubes.places().len(), self.lower));
        self.work.count_level();
        Ok(())
    }

    /// Returns what is proved, given an upper bound on the length of a curve, if there is one.
    ///
    /// # Errors
    ///
    /// [`CheckError::Contradiction`] if no curve as short as this one can exist;
    /// [`CheckError::Empty`] before the first level.
    pub fn proved(self, upper: Option<f64>) -> Result<Proved<D>, CheckError> {
        let lower = self.lower;
        if let Some(upper) = upper
            && (self.is_closed() || lower > upper)
        {
            return Err(CheckError::Contradiction { lower, upper });
        }
        let declared = match self.region {
            Region::Declared { c1 } => Some(c1),
            _ => None,
        };
        let corridor = self.kept.ok_or(CheckError::Empty)?;
        Ok(Proved { lower, upper, declared, corridor, levels: self.levels })
    }
}
