//! Mistakes in recorded formulas and their programs.

use std::collections::BTreeSet;

use nalgebra::{SMatrix, SVector};
use tautline::{
    AnyBatches, Batches, Formula, Kind, Metric, Prepared, Scalar,
    formula::{Arithmetic, Function, Layout, Operation, Pair, Register, Registers, Step},
};

use super::Mutant;

/// Returns the programs of a metric whose formula is recorded, derived or run with the mistake of a
/// mutant; `None` if the mistake is elsewhere, or if the formula cannot be recorded.
pub(super) fn batches<const D: usize>(
    mutant: Mutant,
    metric: &impl Metric<D>,
) -> Option<Box<dyn Batches<D>>> {
    match mutant {
        Mutant::OperandsSwapped
        | Mutant::ConstantsMerged
        | Mutant::ConstantsShortened
        | Mutant::SineForCosine
        | Mutant::PowerOfStepLost
        | Mutant::StepBesideRead
        | Mutant::EntryTakenForZero
        | Mutant::TableAxesExchanged
        | Mutant::TableReadBeside => {
            let formula = Formula::record(metric).ok()?;
            Some(Box::new(Prepared::new(Misread { formula, mutant })))
        }
        Mutant::ProductRuleHalved | Mutant::LaneLost | Mutant::RegisterStale => {
            let prepared = Prepared::new(Formula::record(metric).ok()?);
            Some(Box::new(Misrun { prepared, mutant }))
        }
        _ => None,
    }
}

/// A formula that is read with a mistake.
struct Misread<const D: usize> {
    formula: Formula<D>,
    mutant: Mutant,
}

impl<const D: usize> Misread<D> {
    fn number(&self, number: f64) -> f64 {
        match self.mutant {
            Mutant::ConstantsMerged => (number * 4.0).round() / 4.0,
            Mutant::ConstantsShortened => f64::from(number as f32),
            _ => number,
        }
    }

    fn binary<S: Scalar>(&self, how: Arithmetic, a: S, b: S) -> S {
        let swapped = self.mutant == Mutant::OperandsSwapped;
        let (a, b) = if swapped { (b, a) } else { (a, b) };
        match how {
            Arithmetic::Add => a + b,
            Arithmetic::Sub => a - b,
            Arithmetic::Mul => a * b,
            Arithmetic::Div => a / b,
        }
    }

    /// Returns the step that is read in place of `step`.
    fn read(&self, step: Step, place: usize) -> usize {
        let step = step as usize;
        let beside = self.mutant == Mutant::StepBesideRead && step >= D && step + 1 < place;
        step + usize::from(beside)
    }
}

impl<const D: usize> Metric<D> for Misread<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let mut values: Vec<S> = Vec::new();
        for (place, &operation) in self.formula.operations().iter().enumerate() {
            let at = |step: Step| values[self.read(step, place)];
            let value = match operation {
                Operation::Coordinate(i) => x[i as usize],
                Operation::Constant(number) => S::constant(self.number(number.value())),
                Operation::Binary(how, a, b) => self.binary(how, at(a), at(b)),
                Operation::WithNumber(how, a, number) => {
                    self.binary(how, at(a), S::constant(self.number(number.value())))
                }
                Operation::Powi(a, n) if self.mutant == Mutant::PowerOfStepLost => {
                    at(a).powi(n - n.signum())
                }
                Operation::Powi(a, n) => at(a).powi(n),
                Operation::Of(Function::Sqr, a) if self.mutant == Mutant::PowerOfStepLost => at(a),
                Operation::Of(Function::Cos, a) if self.mutant == Mutant::SineForCosine => {
                    at(a).sin()
                }
                Operation::Of(function, a) => function.of(at(a)),
                Operation::First(Pair::SinCos, a) => at(a).sin(),
                Operation::First(Pair::SinhCosh, a) => at(a).sinh(),
                Operation::Second => self.second(place, &values),
                Operation::Table(call) => {
                    let table = &self.formula.tables()[call.table as usize];
                    let mut u = call.arguments.map(at);
                    let axes = call.arguments().len();
                    match self.mutant {
                        Mutant::TableAxesExchanged if axes > 1 => u.swap(0, 1),
                        Mutant::TableReadBeside => u[0] += S::constant(1.0),
                        _ => {}
                    }
                    S::tabulated(table, call.orders, &u[..axes])
                }
            };
            values.push(value);
        }
        SMatrix::from_fn(|i, j| {
            if i != j && self.mutant == Mutant::EntryTakenForZero {
                S::zero()
            } else {
                values[self.formula.entry(i, j) as usize]
            }
        })
    }
}

impl<const D: usize> Misread<D> {
    /// Returns the second of a pair of functions.
    fn second<S: Scalar>(&self, place: usize, values: &[S]) -> S {
        match self.formula.operations()[place - 1] {
            Operation::First(..) if self.mutant == Mutant::SineForCosine => values[place - 1],
            Operation::First(Pair::SinCos, a) => values[a as usize].cos(),
            Operation::First(Pair::SinhCosh, a) => values[a as usize].cosh(),
            _ => unreachable!("the second of a pair follows the first"),
        }
    }
}

/// Programs that are derived or run with a mistake.
struct Misrun<const D: usize> {
    prepared: Prepared<Formula<D>, D>,
    mutant: Mutant,
}

/// Returns all rows of results in a batch, except those that only serve to judge `H`.
fn rows(layout: &Layout) -> impl Iterator<Item = Register> {
    let Layout { square, momentum, slope, gram, turn, bend, .. } = layout;
    [square, momentum, slope, gram, turn, bend].into_iter().flatten().copied()
}

impl<const D: usize> Batches<D> for Misrun<D> {}

impl<const D: usize> AnyBatches for Misrun<D> {
    fn dimension(&self) -> usize {
        D
    }

    fn gram_into(&self, x: &[f64], gram: &mut [f64]) {
        self.prepared.gram_into(x, gram);
    }

    fn layout(&self, kind: Kind) -> &Layout {
        self.prepared.layout(kind)
    }

    fn registers(&self, kind: Kind, unit: usize, units: usize) -> Registers {
        self.prepared.registers(kind, unit, units)
    }

    fn evaluate(&self, kind: Kind, registers: &mut Registers) {
        let layout = self.layout(kind);
        let of_first_lane = |registers: &Registers| -> Vec<f64> {
            rows(layout).map(|row| registers.row(row)[0]).collect()
        };
        let before = of_first_lane(registers);
        let is_stale = |now: &[f64]| {
            before.iter().zip(now).any(|(&before, &now)| before != 0.0 && before != now)
        };
        self.prepared.evaluate(kind, registers);
        let last = registers.count() - 1;
        match self.mutant {
            Mutant::ProductRuleHalved => {
                // Slopes share a register if they are the same step.
                let slopes: BTreeSet<Register> = layout.slope.iter().copied().collect();
                for row in slopes {
                    for lane in 0..=last {
                        registers.set(row, lane, 0.5 * registers.row(row)[lane]);
                    }
                }
            }
            Mutant::LaneLost if last > 0 => {
                for row in rows(layout) {
                    registers.set(row, last, registers.row(row)[last - 1]);
                }
            }
            // On first use, the registers of results are zero, so that nothing is stale yet.
            Mutant::RegisterStale if is_stale(&of_first_lane(registers)) => {
                for (row, &value) in rows(layout).zip(&before) {
                    registers.set(row, 0, value);
                }
            }
            _ => {}
        }
    }
}
