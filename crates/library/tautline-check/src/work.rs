//! `Work`: how much a check may cost.
//!
//! The units, and what they are counted for, are those of `FORMAT.md`, so that all checkers refuse the
//! same files.

use std::{
    any::Any,
    fmt::{self, Debug, Formatter},
    sync::atomic::{AtomicU64, AtomicUsize, Ordering::Relaxed},
};

use tautline_formula::{Formula, Function, Operation, spline::Spline};
use tautline_sets::Shape;

use crate::{Certificate, CheckError, Region, region::MOST};

/// The units that every certificate may cost, and those for each of its numbers.
const ALWAYS: u64 = 1 << 24;
const FOR_A_NUMBER: u64 = 1 << 16;

/// What a check has cost and may cost, and whether it is to go on.
pub(crate) struct Work<'g> {
    /// The weight of the formula.
    pub(crate) formula: u64,
    /// The number of pieces of both sets.
    pub(crate) pieces: u64,
    budget: u64,
    spent: AtomicU64,
    /// How many levels there are, and how many of them are checked.
    levels: usize,
    checked: AtomicUsize,
    go_on: &'g (dyn Fn() -> bool + Sync),
}

/// The work of a proof that may cost what it likes, and is not counted.
pub(crate) static UNLIMITED: Work<'static> = Work {
    formula: 0,
    pieces: 0,
    budget: u64::MAX,
    spent: AtomicU64::new(0),
    levels: 0,
    checked: AtomicUsize::new(0),
    go_on: &|| true,
};

impl<'g> Work<'g> {
    /// Returns the work that a certificate may cost, as long as `go_on` is true.
    pub(crate) fn limited<const D: usize>(
        certificate: &Certificate<D>,
        go_on: &'g (dyn Fn() -> bool + Sync),
    ) -> Self {
        Self {
            formula: weight(&certificate.formula),
            pieces: pieces(&certificate.sets),
            budget: budget(certificate),
            spent: AtomicU64::new(0),
            levels: certificate.levels.len(),
            checked: AtomicUsize::new(0),
            go_on,
        }
    }

    /// Returns the work of a proof that may cost what it likes, and is counted.
    pub(crate) fn counted<const D: usize>(formula: &Formula<D>, sets: &[Shape<D>; 2]) -> Self {
        Self {
            formula: weight(formula),
            pieces: pieces(sets),
            spent: AtomicU64::new(0),
            ..UNLIMITED.clone()
        }
    }

    /// Returns what was paid so far, in units.
    pub(crate) fn spent(&self) -> u64 {
        self.spent.load(Relaxed)
    }

    /// Pays for the cubes of a level.
    pub(crate) fn spend_cubes<const D: usize>(&self, count: usize) -> Result<(), CheckError> {
        let evaluations = (1 << D) + (D as u64 + 1) * (D as u64 + 2) / 2;
        let cube = evaluations * self.formula + self.pieces;
        self.spend(cube.saturating_mul(count as u64))
    }

    /// Pays for a cube, of any size, that is looked at in the search for those that the first level has to
    /// contain.
    pub(crate) fn spend_seen(&self) -> Result<(), CheckError> {
        self.spend(self.pieces)
    }

    /// Pays for a piece of a set that may meet a cube.
    pub(crate) fn spend_meeting<const D: usize>(&self, piece: &Shape<D>) -> Result<(), CheckError> {
        let functions = if matches!(piece, Shape::AxisBox(_)) { 2 * D } else { 1 };
        self.spend((64 * (1..=D).product::<usize>() * functions) as u64)
    }

    /// Pays so many units, if it is to go on.
    pub(crate) fn spend(&self, units: u64) -> Result<(), CheckError> {
        self.go_on()?;
        let within = |spent: u64| spent.checked_add(units).filter(|&sum| sum <= self.budget);
        let paid = self.spent.fetch_update(Relaxed, Relaxed, within);
        paid.map(|_| ()).map_err(|_| CheckError::Work { budget: self.budget })
    }

    /// Asks whether to go on.
    pub(crate) fn go_on(&self) -> Result<(), CheckError> {
        let (levels, of) = (self.checked.load(Relaxed), self.levels);
        if (self.go_on)() { Ok(()) } else { Err(CheckError::Stopped { levels, of }) }
    }

    /// Counts one more level as checked.
    pub(crate) fn count_level(&self) {
        self.checked.fetch_add(1, Relaxed);
    }

    /// Returns how many cubes are searched for that a first level of so many cubes has to contain. If
    /// many more are required, it lacks one.
    pub(crate) fn most_cubes<const D: usize>(&self, cubes: usize) -> usize {
        if self.is_limited() { MOST.min(4 * cubes + (1 << (2 * D))) } else { MOST }
    }

    /// Returns whether there is a budget.
    pub(crate) fn is_limited(&self) -> bool {
        self.budget < u64::MAX
    }
}

/// A copy counts on by itself.
impl Clone for Work<'_> {
    fn clone(&self) -> Self {
        Self {
            spent: AtomicU64::new(self.spent()),
            checked: AtomicUsize::new(self.checked.load(Relaxed)),
            ..*self
        }
    }
}

impl Debug for Work<'_> {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "Work({:?} of {})", self.spent, self.budget)
    }
}

/// Returns the most units that the check of a certificate may cost.
pub(crate) fn budget<const D: usize>(certificate: &Certificate<D>) -> u64 {
    FOR_A_NUMBER.saturating_mul(size(certificate)).saturating_add(ALWAYS)
}

/// Returns the number of pieces of both sets.
fn pieces<const D: usize>(sets: &[Shape<D>; 2]) -> u64 {
    sets.iter().map(|set| set.pieces().len() as u64).sum()
}

/// Returns the number of doubles in a certificate and of lines of its formula.
fn size<const D: usize>(certificate: &Certificate<D>) -> u64 {
    let Certificate { formula, sets, region, curve, levels, .. } = certificate;
    let spline = |table| (table as &dyn Any).downcast_ref::<Spline>();
    let tables = formula.tables().iter().filter_map(|table| spline(&**table));
    let of_piece = |piece: &Shape<D>| match piece {
        Shape::Point(_) => D,
        Shape::AxisBox(_) => 2 * D,
        Shape::Ball(_) | Shape::HalfSpace(_) => D + 1,
        _ => 0,
    };
    let of_region = match region {
        Region::Tubes { .. } => 2,
        Region::Declared { .. } => 1,
        Region::ExitOne | Region::ExitTwo => 0,
    };
    let numbers = tables.map(|spline| spline.coefficients().len()).sum::<usize>()
        + lines(formula)
        + sets.iter().flat_map(Shape::pieces).map(of_piece).sum::<usize>()
        + of_region
        + D * curve.as_ref().map_or(0, Vec::len)
        + levels.iter().map(|level| 2 * level.nodes().len()).sum::<usize>();
    // And `hi`.
    numbers as u64 + 1
}

/// Returns the number of lines of the formula, as a file has it.
pub(crate) fn lines<const D: usize>(formula: &Formula<D>) -> usize {
    let is_step =
        |operation: &&Operation| !matches!(operation, Operation::Coordinate(_) | Operation::Second);
    // The matrix is the last line.
    formula.operations().iter().filter(is_step).count() + 1
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

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_formula::Formula;
    use tautline_sets::{AxisBox, Ball, Point, Shape};

    use super::{ALWAYS, FOR_A_NUMBER, Work, size, weight};
    use crate::{Certificate, Chain, CheckError, Cubes, Level, Region};

    fn certificate() -> Certificate<2> {
        let point = Shape::Point(Point::new([0.5, 0.5]).expect("finite"));
        let ball = Shape::Ball(Ball::new([1.5, 0.5], 0.25).expect("a ball"));
        let far = AxisBox::from_corners([9.0, 9.0], [9.5, 9.5]).expect("a box");
        let to = Shape::Union(vec![ball, Shape::AxisBox(far)]);
        let formula = Formula::parse("s, c = sin_cos(0*x1); (c + s^5) I", &[]).expect("a formula");
        // The sets and what curves up to 0.85 between them may meet.
        let places = (-1..3).flat_map(|i| (-1..2).map(move |j| [i, j])).collect();
        let cubes = Cubes::new(0, places).expect("in range");
        let values = vec![0.0; cubes.nodes().len()];
        let level = Level::new(0, cubes, [values.clone(), values]).expect("finite");
        Certificate {
            formula,
            sets: [point, to],
            hi: 0.85,
            region: Region::Declared { c1: 1.0 },
            curve: Some([0.5, 0.75, 1.25].map(|x| vector![x, 0.5]).to_vec()),
            levels: vec![level],
        }
    }

    /// Returns what the check of a certificate costs.
    fn spent_by(certificate: &Certificate<2>) -> u64 {
        let (chain, _) =
            certificate.proof(Work::limited(certificate, &|| true)).expect("all cubes are there");
        chain.work()
    }

    /// Counted by hand, as `FORMAT.md` says.
    #[test]
    fn work_is_counted_as_the_format_says() {
        let certificate = certificate();
        // number(0), 0·x1, the pair, s^5, the sum, and the matrix.
        let formula = certificate.formula.to_string();
        assert_eq!(weight(&certificate.formula), 1 + 1 + 4 + 3 + 1 + 1, "{formula}");
        // 6 lines; points, ball and box; hi; c1; 3 points; 9 · 7 nodes.
        assert_eq!(size(&certificate), 6 + 2 + 3 + 4 + 1 + 1 + 6 + 126, "{formula}");
        assert_eq!(certificate.budget(), ALWAYS + FOR_A_NUMBER * 149);
        let spent = spent_by(&certificate);
        // Two chords; 16 cubes of side 2, of which those at (0, 0) and (0, -1) are halved; 12 cubes with
        // 10 evaluations and 3 pieces; the point is in one cube, and the ball in another.
        let seen = (16 + 2 * 4) * 3;
        assert_eq!(spent, 2 * 6 * 11 + seen + 12 * (10 * 11 + 3) + 128 * (1 + 1));
    }

    /// Who makes a certificate counts as its checker does, and copies count on by themselves.
    #[test]
    fn a_proof_without_a_budget_is_counted() {
        let certificate = certificate();
        let Certificate { formula, sets, hi, region, curve, levels } = &certificate;
        let mut chain = Chain::new(formula, sets, *hi, *region).expect("a region");
        let points = curve.as_ref().expect("a curve");
        chain.length_above(points).expect("a length");
        let before = chain.clone();
        chain.add(&levels[0], *hi).expect("all cubes are there");
        assert_eq!(chain.work(), spent_by(&certificate));
        assert_eq!(before.work(), 2 * 6 * 11);
    }

    /// The budget counts, and so does the last unit of it.
    #[test]
    fn a_check_that_costs_more_than_its_budget_is_refused() {
        let certificate = certificate();
        let spent = spent_by(&certificate);
        for (budget, is_enough) in [(spent, true), (spent - 1, false), (1, false)] {
            let work = Work { budget, ..Work::limited(&certificate, &|| true) };
            let refused = certificate.proof(work).err();
            assert_eq!(refused.is_none(), is_enough, "{budget} of {spent}");
            assert!(is_enough || refused == Some(CheckError::Work { budget }));
        }
        // Tubes.
        let sets = certificate.sets.each_ref();
        let tubes = Region::Tubes { radius: 1.0, c1: 0.9 };
        let work = Work::limited(&certificate, &|| true);
        tubes.prove_within(&certificate.formula, sets, 0.85, &work).expect("a constant metric");
        let (spent, box_) = (work.spent.into_inner(), 11 + 3);
        assert!(spent >= 2 * box_ && spent % box_ == 0, "{spent}");
        let work = Work { budget: spent - 1, ..Work::limited(&certificate, &|| true) };
        let refused = tubes.prove_within(&certificate.formula, sets, 0.85, &work);
        assert_eq!(refused, Err(CheckError::Work { budget: spent - 1 }));
    }

    /// Whenever it is stopped, the levels that it says it checked are those before.
    #[test]
    fn a_check_that_is_stopped_says_how_far_it_came() {
        use std::sync::atomic::{AtomicU32, Ordering::Relaxed};
        let mut certificate = certificate();
        certificate.levels.push(certificate.levels[0].clone());
        let mut before = 0;
        for allowed in 0..10_000 {
            let asked = AtomicU32::new(0);
            let go_on = || asked.fetch_add(1, Relaxed) < allowed;
            match certificate.check_while(&go_on) {
                Err(CheckError::Stopped { levels, of: 2 }) => {
                    assert!((before..2).contains(&levels), "{allowed}: {levels}");
                    before = levels;
                }
                checked => {
                    assert_eq!(checked, certificate.check());
                    assert!(before == 1 && allowed > 20, "{allowed}");
                    return;
                }
            }
        }
        panic!("the check never ends");
    }

    /// No sum of units wraps around.
    #[test]
    fn so_much_work_that_it_overflows_is_refused() {
        let certificate = certificate();
        let work = Work::limited(&certificate, &|| true);
        for _ in 0..9 {
            assert!(work.spend(u64::MAX).is_err() && work.spend_cubes::<2>(usize::MAX).is_err());
        }
        assert_eq!(work.spend(1), Ok(()));
    }

    /// The lines of a formula, each by itself: they are as many as its weights say, and the matrix.
    #[test]
    fn each_kind_of_line_has_its_weight() {
        use std::sync::Arc;

        use tautline_formula::spline::Spline;
        use tautline_scalar::Table;
        let table = |axes: usize| -> Arc<dyn Table> {
            let count = 2_usize.pow(axes as u32);
            Arc::new(Spline::new(&vec![2; axes], vec![1.0; count]).expect("a shape"))
        };
        let tables = [("t", table(1)), ("h", table(2)), ("f", table(3))];
        for (line, expected) in [
            ("-x1", 1),
            ("sqr(x1)", 1),
            ("recip(x1)", 1),
            ("x1 - 2", 1),
            ("x1*x1", 1),
            ("number(3)", 1),
            ("x1^0", 1),
            ("x1^1", 1),
            ("x1^2", 2),
            ("x1^3", 2),
            ("x1^4", 3),
            ("x1^-1", 1),
            ("x1^-8", 4),
            ("x1^2147483647", 31),
            ("x1^-2147483648", 32),
            ("sqrt(x1)", 4),
            ("exp(x1)", 4),
            ("ln(x1)", 4),
            ("tan(x1)", 4),
            ("atan(x1)", 4),
            ("tanh(x1)", 4),
            ("sin(x1)", 4),
            ("t(x1)", 16),
            ("t_2(x1)", 16),
            ("h(x1, x1)", 64),
            ("f(x1, x1, x1)", 256),
        ] {
            let formula = Formula::<1>::parse_with(&format!("[{line}]"), &[], &tables).expect(line);
            assert_eq!(weight(&formula), expected + 1, "{line}");
        }
    }

    /// Each kind of region, piece and table, counted by hand.
    #[test]
    fn the_size_of_a_certificate_counts_all_of_its_numbers() {
        use std::sync::Arc;

        use tautline_formula::spline::Spline;
        use tautline_scalar::Table;
        use tautline_sets::HalfSpace;
        let table: Arc<dyn Table> = Arc::new(Spline::new(&[2, 3], vec![1.0; 6]).expect("a shape"));
        let formula = Formula::<2>::parse_with("h(x1, x2) I", &[], &[("h", table)]);
        let wall = Shape::HalfSpace(HalfSpace::new([1.0, 0.0], -9.0).expect("a wall"));
        let mut certificate = Certificate { formula: formula.expect("a formula"), ..certificate() };
        certificate.curve = None;
        // The table and its call, the zero beside the diagonal, the matrix; a point, a ball and a box;
        // hi; the nodes.
        let others = 6 + 3 + 2 + 3 + 4 + 1 + 126;
        for (region, numbers) in [
            (Region::Tubes { radius: 1.0, c1: 1.0 }, 2),
            (Region::Declared { c1: 1.0 }, 1),
            (Region::ExitOne, 0),
            (Region::ExitTwo, 0),
        ] {
            certificate.region = region;
            assert_eq!(size(&certificate), others + numbers, "{region:?}");
        }
        certificate.sets[0] = Shape::Union(vec![wall.clone(), wall]);
        assert_eq!(size(&certificate), others - 2 + 6);
        certificate.curve = Some(vec![vector![0.0, 0.0]; 5]);
        certificate.levels.push(certificate.levels[0].clone());
        assert_eq!(size(&certificate), others - 2 + 6 + 10 + 126);
    }

    /// A box has two sides along each axis, and a cube of three dimensions six simplices.
    #[test]
    fn a_piece_that_meets_a_cube_costs_its_sides_and_simplices() {
        let cost = |spend: &dyn Fn(&Work<'_>) -> Result<(), CheckError>| {
            let certificate = certificate();
            let work = Work::limited(&certificate, &|| true);
            spend(&work).expect("within the budget");
            work.spent.into_inner()
        };
        let point = Shape::Point(Point::new([0.5; 3]).expect("finite"));
        let side = Shape::AxisBox(AxisBox::from_corners([0.0; 3], [1.0; 3]).expect("a box"));
        assert_eq!(cost(&|work| work.spend_meeting(&point)), 64 * 6);
        assert_eq!(cost(&|work| work.spend_meeting(&side)), 64 * 6 * 6);
        let side = Shape::AxisBox(AxisBox::from_corners([0.0; 2], [1.0; 2]).expect("a box"));
        assert_eq!(cost(&|work| work.spend_meeting(&side)), 64 * 2 * 4);
        // The formula of the certificate has the weight 11, and there are three pieces.
        assert_eq!(cost(&|work| work.spend_cubes::<1>(5)), 5 * ((2 + 3) * 11 + 3));
        assert_eq!(cost(&|work| work.spend_cubes::<3>(2)), 2 * ((8 + 10) * 11 + 3));
        assert_eq!(cost(&|work| work.spend_cubes::<4>(1)), (16 + 15) * 11 + 3);
        assert_eq!(cost(&|work| work.spend_seen()), 3);
    }
}
