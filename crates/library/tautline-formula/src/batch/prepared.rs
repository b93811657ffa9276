//! `Prepared`: batches evaluated in the fastest way for a metric.

use std::sync::{Arc, OnceLock};

use tautline_metrics::{Metric, quadrature::FEW_ROUNDINGS};
use tautline_scalar::ANY;

use crate::{
    BlackBox, BlackBoxBatches, Formula, RecordError,
    batch::{
        AnyBatches, Batches, Kind, Layout, Plain, contiguous, interpreted, kernel::Kernel, rows,
    },
    formula::Tape,
    program::{InstructionSet, Registers},
};

/// A metric, ready to be evaluated at many points at once.
///
/// It runs programs that are derived from the formula on first use. A formula that compares numbers
/// cannot be recorded, and the programs of a very long formula are slow. Such formulas are
/// evaluated as compiled, point by point. The results agree up to rounding.
#[derive(Debug)]
pub struct Prepared<M, const D: usize> {
    plain: Plain<M, D>,
    formula: Result<Formula<D>, RecordError>,
    programs: Arc<Programs>,
    /// The metric, if it is known by its values only.
    black_box: Option<BlackBoxBatches>,
}

/// The greatest number of lanes.
const LANES: usize = 128;

impl<M: Metric<D>, const D: usize> Prepared<M, D> {
    /// Records the formula of a metric.
    #[must_use]
    pub fn new(metric: M) -> Self {
        Self::with(metric, InstructionSet::Widest, LANES)
    }

    /// Does the same with this instruction set and at most this many lanes. There are fewer lanes
    /// if they would not fit into a cache. The results are the same bit for bit.
    #[must_use]
    pub fn with(metric: M, instruction_set: InstructionSet, lanes: usize) -> Self {
        let formula = Formula::record(&metric);
        let programs = Arc::new(Programs::new(instruction_set, lanes, !M::IS_RECORDED));
        Self { plain: Plain::new(metric), formula, programs, black_box: None }
    }

    /// Wraps a metric that computes what a black box does. Batches are evaluated by the latter, all
    /// points of a batch in one call.
    #[must_use]
    pub fn of_black_box(metric: M, black_box: BlackBox<D>) -> Self {
        Self {
            plain: Plain::new(metric),
            formula: Err(RecordError::BlackBox),
            programs: Arc::new(Programs::new(InstructionSet::Widest, LANES, true)),
            black_box: Some(BlackBoxBatches::new(black_box.into_any())),
        }
    }

    /// Returns the metric.
    #[must_use]
    pub fn metric(&self) -> &M {
        self.plain.metric()
    }

    /// Returns the metric's formula, or `None` if it could not be recorded.
    #[must_use]
    pub fn formula(&self) -> Option<&Formula<D>> {
        self.recorded().ok()
    }

    /// Returns the metric's formula, or why it could not be recorded.
    pub(crate) fn recorded(&self) -> Result<&Formula<D>, RecordError> {
        self.formula.as_ref().map_err(|&error| error)
    }

    /// Returns the metric as compiled.
    pub(crate) fn plain(&self) -> &Plain<M, D> {
        &self.plain
    }

    /// Returns the numbers of instructions and registers of a program, or `None` if there is none.
    #[must_use]
    pub fn size(&self, kind: Kind) -> Option<[usize; 2]> {
        self.kernel(kind).map(Kernel::size)
    }

    fn kernel(&self, kind: Kind) -> Option<&Kernel> {
        self.programs.kernel(self.formula()?.tape(), kind)
    }
}

/// The programs of a formula, which are derived on first use.
#[derive(Debug)]
struct Programs {
    kernels: [OnceLock<Option<Kernel>>; 4],
    instruction_set: InstructionSet,
    lanes: usize,
    /// Whether the formula is compiled too, so that a long program may be slower.
    is_compiled: bool,
}

impl Programs {
    fn new(instruction_set: InstructionSet, lanes: usize, is_compiled: bool) -> Self {
        Self { kernels: Default::default(), instruction_set, lanes, is_compiled }
    }

    /// Returns the program of a kind, or `None` if there is none, or the formula is faster.
    fn kernel(&self, tape: Tape<'_>, kind: Kind) -> Option<&Kernel> {
        let kernel = || Kernel::new(tape, kind, self.is_compiled);
        self.kernels[kind as usize].get_or_init(kernel).as_ref()
    }

    /// Returns registers for a program.
    fn registers(&self, kernel: &Kernel, unit: usize, units: usize) -> Registers {
        let lanes = unit.saturating_mul(units).min(self.lanes).min(kernel.lanes()).max(unit);
        Registers::new(kernel.program(), lanes, self.instruction_set)
    }
}

/// A formula in a dimension that is a value, ready to be evaluated at many points at once.
///
/// It runs programs that are derived from the formula on first use. If a program becomes too long, the
/// formula is evaluated point by point. The results agree up to rounding.
///
/// ```
/// use tautline_formula::{AnyBatches, Formula, PreparedFormula};
///
/// let formula = Formula::parse_in(20, "(2 - cos(x20)) I", &[], &[])?;
/// let metric = PreparedFormula::new(formula);
/// let mut gram = [0.0; 400];
/// metric.gram_into(&[0.0; 20], &mut gram);
/// assert_eq!((gram[0], gram[1], gram[399]), (1.0, 0.0, 1.0));
/// # Ok::<(), tautline_formula::TextError>(())
/// ```
#[derive(Debug)]
pub struct PreparedFormula {
    formula: Formula<ANY>,
    programs: Arc<Programs>,
    /// The layouts of the kinds that no program evaluates.
    layouts: [OnceLock<Layout>; 4],
}

/// The number of lanes of a batch that no program evaluates.
const FEW: usize = 16;

impl PreparedFormula {
    /// Takes a formula.
    #[must_use]
    pub fn new(formula: Formula<ANY>) -> Self {
        let programs = Arc::new(Programs::new(InstructionSet::Widest, LANES, false));
        Self { formula, programs, layouts: Default::default() }
    }

    /// Returns the formula.
    #[must_use]
    pub fn formula(&self) -> &Formula<ANY> {
        &self.formula
    }

    fn kernel(&self, kind: Kind) -> Option<&Kernel> {
        self.programs.kernel(self.formula.tape(), kind)
    }
}

impl AnyBatches for PreparedFormula {
    fn dimension(&self) -> usize {
        self.formula.dimension()
    }

    fn quadrature_tolerance(&self) -> f64 {
        // Measured numbers are hardly known to more digits.
        if self.formula.tables().is_empty() { FEW_ROUNDINGS } else { 1e-9 }
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        gram.copy_from_slice(&interpreted::gram(self.formula.tape(), x));
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.kernel(kind).map_or_else(
            || self.layouts[kind as usize].get_or_init(|| contiguous(kind, self.dimension())),
            Kernel::layout,
        )
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        match self.kernel(kind) {
            Some(kernel) => self.programs.registers(kernel, unit, units),
            None => {
                let lanes = unit.saturating_mul(units).clamp(unit, unit.max(FEW));
                Registers::empty(rows(self.layout(kind), self.dimension()), lanes)
            }
        }
    }

    fn instruction_set(&self) -> InstructionSet {
        self.programs.instruction_set
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        match self.kernel(kind) {
            Some(kernel) => registers.run(kernel.program()),
            None => {
                interpreted::evaluate(self.formula.tape(), self.layout(kind), kind, registers);
            }
        }
    }
}

impl<M: Metric<D>, const D: usize> Batches<D> for Prepared<M, D> {}

impl<M: Metric<D>, const D: usize> AnyBatches for Prepared<M, D> {
    fn dimension(&self) -> usize {
        D
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.plain.gram_into(x, gram);
    }

    fn layout(&self, kind: Kind) -> &Layout {
        match (self.kernel(kind), &self.black_box) {
            (Some(kernel), _) => kernel.layout(),
            (None, Some(black_box)) => black_box.layout(kind),
            (None, None) => self.plain.layout(kind),
        }
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        match (self.kernel(kind), &self.black_box) {
            (Some(kernel), _) => self.programs.registers(kernel, unit, units),
            (None, Some(black_box)) => black_box.registers(kind, unit, units),
            (None, None) => self.plain.registers(kind, unit, units),
        }
    }

    fn instruction_set(&self) -> InstructionSet {
        self.programs.instruction_set
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        match (self.kernel(kind), &self.black_box) {
            (Some(kernel), _) => registers.run(kernel.program()),
            (None, Some(black_box)) => black_box.evaluate(kind, registers),
            // The compiler decides: the derivatives of recorded steps are not compiled.
            (None, None) if const { M::IS_RECORDED } => {
                let tape = self.formula().map(Formula::tape).expect("steps are a formula");
                interpreted::evaluate(tape, self.layout(kind), kind, registers);
            }
            (None, None) => self.plain.evaluate(kind, registers),
        }
    }
}
