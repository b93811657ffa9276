//! `Work`: how much a check may cost.
//!
//! The units, and what they are counted for, are those of `FORMAT.md`, so that all checkers refuse the
//! same files.

use std::{
    any::Any,
    sync::atomic::{AtomicU64, Ordering::Relaxed},
};

use tautline_formula::{Formula, Function, Operation};
use tautline_sets::Shape;
use tautline_spline::Spline;

use crate::{Certificate, CheckError, Region};

/// The units that every certificate may cost, and those for each of its numbers.
const ALWAYS: u64 = 1 << 24;
const FOR_A_NUMBER: u64 = 1 << 16;

/// What a check has cost and may cost, and whether it is to go on.
pub(crate) struct Work<'g> {
    /// The weight of the formula.
    formula: u64,
    /// The number of pieces of both sets.
    pieces: u64,
    budget: u64,
    spent: AtomicU64,
    go_on: &'g (dyn Fn() -> bool + Sync),
}

impl<'g> Work<'g> {
    /// Returns the work of a check that may cost what it likes.
    pub(crate) fn unlimited() -> Work<'static> {
        let spent = AtomicU64::new(0);
        Work { formula: 0, pieces: 0, budget: u64::MAX, spent, go_on: &|| true }
    }

    /// Returns the work that a certificate may cost, as long as `go_on` is true.
    pub(crate) fn limited<const D: usize>(
        certificate: &Certificate<D>,
        go_on: &'g (dyn Fn() -> bool + Sync),
    ) -> Self {
        let pieces = certificate.sets.iter().map(|set| set.pieces().len() as u64).sum();
        let budget = FOR_A_NUMBER.saturating_mul(size(certificate)).saturating_add(ALWAYS);
        let formula = weight(&certificate.formula);
        Self { formula, pieces, budget, spent: AtomicU64::new(0), go_on }
    }

    /// Pays for a box of a tube.
    pub(crate) fn spend_box(&self) -> Result<(), CheckError> {
        self.spend(self.formula.saturating_add(self.pieces))
    }

    /// Pays for a part of a chord.
    pub(crate) fn spend_part(&self) -> Result<(), CheckError> {
        self.spend(self.formula.saturating_mul(6))
    }

    /// Pays for the cubes of a level.
    pub(crate) fn spend_cubes<const D: usize>(&self, count: usize) -> Result<(), CheckError> {
        let evaluations = (1 << D) + (D + 1) * (D + 2) / 2;
        let cube = self.formula.saturating_mul(evaluations as u64).saturating_add(self.pieces);
        self.spend(cube.saturating_mul(count as u64))
    }

    /// Pays for a piece of a set that may meet a cube.
    pub(crate) fn spend_meeting<const D: usize>(&self, piece: &Shape<D>) -> Result<(), CheckError> {
        let functions = if matches!(piece, Shape::AxisBox(_)) { 2 * D } else { 1 };
        let simplices = (1..=D).product::<usize>();
        self.spend((64 * simplices * functions) as u64)
    }

    fn spend(&self, units: u64) -> Result<(), CheckError> {
        self.go_on()?;
        let spent = self.spent.fetch_add(units, Relaxed);
        // A sum of few terms of at most the budget each does not wrap around.
        if units > self.budget || spent.saturating_add(units) > self.budget {
            return Err(CheckError::Work { budget: self.budget });
        }
        Ok(())
    }

    /// Asks whether to go on.
    pub(crate) fn go_on(&self) -> Result<(), CheckError> {
        if (self.go_on)() { Ok(()) } else { Err(CheckError::Stopped { levels: 0, of: 0 }) }
    }
}

/// Returns the number of doubles in a certificate and of lines of its formula.
fn size<const D: usize>(certificate: &Certificate<D>) -> u64 {
    let Certificate { formula, sets, region, curve, levels, .. } = certificate;
    let spline = |table| (table as &dyn Any).downcast_ref::<Spline>();
    let tables = formula.tables().iter().filter_map(|table| spline(&**table));
    let is_line =
        |operation: &&Operation| !matches!(operation, Operation::Coordinate(_) | Operation::Second);
    let of_piece = |piece: &Shape<D>| match piece {
        Shape::Point(_) => D,
        Shape::AxisBox(_) => 2 * D,
        Shape::Ball(_) | Shape::HalfSpace(_) => D + 1,
        Shape::Union(_) => 0,
    };
    let of_region = match region {
        Region::Tubes { .. } => 2,
        Region::Declared { .. } => 1,
        Region::ExitOne | Region::ExitTwo => 0,
    };
    let numbers = tables.map(|spline| spline.coefficients().len()).sum::<usize>()
        + formula.operations().iter().filter(is_line).count()
        + sets.iter().flat_map(Shape::pieces).map(of_piece).sum::<usize>()
        + of_region
        + D * curve.as_ref().map_or(0, Vec::len)
        + levels.iter().map(|level| 2 * level.nodes().len()).sum::<usize>();
    // The last line of the formula, and `hi`.
    numbers as u64 + 2
}

/// Returns the sum of the weights of the lines.
fn weight<const D: usize>(formula: &Formula<D>) -> u64 {
    let of = |operation: &Operation| match *operation {
        // The line of a pair counts for both.
        Operation::Coordinate(_) | Operation::Second => 0,
        Operation::Constant(_)
        | Operation::Binary(..)
        | Operation::WithNumber(..)
        | Operation::Of(Function::Neg | Function::Sqr | Function::Recip, _) => 1,
        Operation::Powi(_, n) => u64::from(u32::BITS - n.unsigned_abs().leading_zeros()).max(1),
        Operation::Of(..) | Operation::First(..) => 4,
        Operation::Table(call) => 1 << (2 * (call.axes + 1)),
    };
    formula.operations().iter().map(of).sum::<u64>() + 1
}
