//! `Formula`: the Gram matrix of a metric as a list of operations.

mod polynomial;
mod where_positive;

use std::sync::Arc;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Scalar, Table};

use self::polynomial::identities;
use crate::{
    RecordError,
    operation::{Function, Operation, Pair, Step, function_at, needed},
    recording::{Recording, Symbol, record},
};

/// The formula of a Gram matrix `H(x)` on `R^D`: the operations of a metric, step by step.
///
/// Two formulas are equal if their operations are the same, in the same order. Equal values are not
/// enough. Evaluated in `f64`, in jets or in intervals, a formula gives the same bits as the
/// metric.
///
/// # Laws
///
/// The first `D` steps are the coordinates. A step reads only earlier steps. Every other step is
/// needed for an entry. No two steps are the same, except for the second steps of pairs.
///
/// The dimension is known at compile time, or is a value if `D` is [`ANY`].
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[doc(alias = "tape")]
pub struct Formula<const D: usize> {
    dimension: usize,
    operations: Vec<Operation>,
    /// The steps that are the entries of `H`, column by column.
    entries: Vec<Step>,
    tables: Vec<Arc<dyn Table>>,
}

impl<const D: usize> Formula<D> {
    /// Records the operations of a metric by evaluating it once.
    ///
    /// # Errors
    ///
    /// [`RecordError`] if the formula compares numbers that depend on `x`, has too many steps, or
    /// uses numbers of another evaluation.
    pub fn record(metric: &impl Metric<D>) -> Result<Self, RecordError> {
        let (gram, recording) = record(D, |x| metric.gram(&SVector::from_fn(|i, _| x[i])));
        Self::of(D, gram.as_slice(), &recording)
    }

    /// Returns the formula with these entries, given column by column.
    pub(crate) fn of(
        dimension: usize,
        entries: &[Symbol],
        recording: &Recording,
    ) -> Result<Self, RecordError> {
        if let Some(error) = recording.failed {
            return Err(error);
        }
        let entries: Vec<Step> = entries.iter().map(|entry| entry.0).collect();
        if entries.iter().any(|&entry| entry as usize >= recording.operations.len()) {
            return Err(RecordError::Foreign);
        }
        let (mut operations, entries) = without_idle(&recording.operations, &entries, dimension);
        let tables = called(&mut operations, &recording.tables);
        Ok(Self { dimension, operations, entries, tables })
    }

    /// Returns the row and the column of an entry that is not known to equal its mirror image; `None` if
    /// there is none. Then the matrix is symmetric wherever it is defined.
    ///
    /// Two entries are equal if they are the same step, or the same polynomial of other steps once all sums
    /// and products are expanded. Numbers count as they stand: nothing is known of `x1*x2/2` and
    /// `0.5*x1*x2`.
    #[must_use]
    pub fn unequal_halves(&self) -> Option<(usize, usize)> {
        let d = self.dimension;
        let mut pairs = (0..d).flat_map(|i| (i + 1..d).map(move |j| (i, j)));
        let differ = |&(i, j): &(usize, usize)| self.entry(i, j) != self.entry(j, i);
        if !pairs.clone().any(|pair| differ(&pair)) {
            return None;
        }
        let same = identities(&self.operations);
        let at = |i: usize, j: usize| same[self.entry(i, j) as usize];
        pairs.find(|&(i, j)| at(i, j) != at(j, i))
    }

    /// Returns the formula if its matrix is symmetric wherever it is defined. Proofs read one half only.
    ///
    /// # Errors
    ///
    /// [`RecordError::Halves`] if there are [unequal halves](Formula::unequal_halves).
    pub fn symmetric(&self) -> Result<&Self, RecordError> {
        match self.unequal_halves() {
            Some((row, column)) => Err(RecordError::Halves { row, column }),
            None => Ok(self),
        }
    }

    /// Returns the formula whose entries below the diagonal are the steps of those above it, without
    /// the steps that only the former ones read.
    ///
    /// It is the same matrix unless there are [unequal halves](Formula::unequal_halves).
    #[must_use]
    pub fn of_upper_half(&self) -> Self {
        let at = |i: usize, j: usize| self.entry(i.min(j), i.max(j));
        let d = self.dimension;
        let entries: Vec<Step> = (0..d * d).map(|place| at(place % d, place / d)).collect();
        let (mut operations, entries) = without_idle(&self.operations, &entries, d);
        let tables = called(&mut operations, &self.tables);
        Self { dimension: d, operations, entries, tables }
    }

    pub(crate) fn tape(&self) -> Tape<'_> {
        let &Self { dimension, ref operations, ref entries, ref tables } = self;
        Tape { dimension, operations, entries, tables }
    }

    /// Returns the dimension of the space.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.dimension
    }

    /// Returns the same formula as one whose dimension is a value.
    #[must_use]
    pub fn into_any(self) -> Formula<ANY> {
        let Self { dimension, operations, entries, tables } = self;
        Formula { dimension, operations, entries, tables }
    }

    /// Returns `H(x)`, as `D²` numbers column by column.
    ///
    /// # Panics
    ///
    /// If `x` has fewer coordinates than the space.
    #[must_use]
    pub fn gram_at<S: Scalar>(&self, x: &[S]) -> Vec<S> {
        let values = self.values_at(x);
        self.entries.iter().map(|&entry| values[entry as usize]).collect()
    }

    /// Returns the values of all steps at `x`.
    ///
    /// # Panics
    ///
    /// If `x` has fewer coordinates than the space.
    #[must_use]
    pub fn values_at<S: Scalar>(&self, x: &[S]) -> Vec<S> {
        self.tape().values(x)
    }

    /// Returns the steps.
    #[must_use]
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Returns the tables that steps refer to by their numbers, in the order of the first calls.
    #[must_use]
    pub fn tables(&self) -> &[Arc<dyn Table>] {
        &self.tables
    }

    /// Returns the function of one number that the step at `place` computes, with its argument. One
    /// half of a [`Pair`] counts as a function. Returns `None` for coordinates, numbers, arithmetic
    /// and powers.
    #[must_use]
    pub fn function(&self, place: usize) -> Option<(Function, Step)> {
        function_at(&self.operations, place)
    }

    /// Returns the step that computes the entry `Hᵢⱼ`; indices start at 0.
    ///
    /// # Panics
    ///
    /// If `row` or `column` is `D` or more.
    #[must_use]
    pub fn entry(&self, row: usize, column: usize) -> Step {
        let d = self.dimension;
        assert!(row < d && column < d, "entry ({row}, {column}) of {d} × {d}");
        self.entries[column * d + row]
    }
}

impl Formula<ANY> {
    /// Returns the same formula as one on `R^E`; `None` if it is one in another dimension.
    #[must_use]
    pub fn into_dimension<const E: usize>(self) -> Option<Formula<E>> {
        let Self { dimension, operations, entries, tables } = self;
        (dimension == E).then_some(Formula { dimension, operations, entries, tables })
    }
}

/// A formula behind a pointer, in whatever dimension.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tape<'f> {
    pub(crate) dimension: usize,
    pub(crate) operations: &'f [Operation],
    /// The steps of the entries, column by column.
    pub(crate) entries: &'f [Step],
    pub(crate) tables: &'f [Arc<dyn Table>],
}

impl Tape<'_> {
    /// Returns the values of all steps at `x`.
    pub(crate) fn values<S: Scalar>(self, x: &[S]) -> Vec<S> {
        let mut values: Vec<S> = Vec::with_capacity(self.operations.len());
        // The second value of the latest pair.
        let mut second = None;
        for &operation in self.operations {
            let at = |step: Step| values[step as usize];
            let value = match operation {
                Operation::Coordinate(i) => x[i as usize],
                Operation::Constant(number) => S::constant(number.value()),
                Operation::Binary(how, a, b) => how.of(at(a), at(b)),
                Operation::WithNumber(how, a, number) => how.of(at(a), number.value()),
                Operation::Powi(a, n) => at(a).powi(n),
                Operation::Of(function, a) => function.of(at(a)),
                Operation::First(pair, a) => {
                    let (first, other) = match pair {
                        Pair::SinCos => at(a).sin_cos(),
                        Pair::SinhCosh => at(a).sinh_cosh(),
                    };
                    second = Some(other);
                    first
                }
                // A second step always comes after its first.
                Operation::Second => second.unwrap_or_else(S::zero),
                Operation::Table(call) => {
                    let table = &self.tables[call.table as usize];
                    let u = call.arguments.map(at);
                    S::tabulated(table, call.orders, &u[..usize::from(call.axes)])
                }
            };
            values.push(value);
        }
        values
    }
}

impl<const D: usize> Metric<D> for Formula<D> {
    const IS_RECORDED: bool = true;

    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let values = self.tape().values(x.as_slice());
        SMatrix::from_fn(|i, j| values[self.entries[j * D + i] as usize])
    }
}

/// Returns the tables that steps call, in the order of the first calls, and numbers them anew.
fn called(operations: &mut [Operation], tables: &[Arc<dyn Table>]) -> Vec<Arc<dyn Table>> {
    let mut order: Vec<u32> = Vec::new();
    for operation in operations {
        if let Operation::Table(call) = operation {
            let known = order.iter().position(|&table| table == call.table);
            let number = known.unwrap_or_else(|| {
                order.push(call.table);
                order.len() - 1
            });
            call.table = number as u32;
        }
    }
    order.into_iter().map(|table| Arc::clone(&tables[table as usize])).collect()
}

/// Returns the coordinates and the steps that these entries need, in their order, and the entries
/// with their new numbers.
fn without_idle(
    operations: &[Operation],
    entries: &[Step],
    dimension: usize,
) -> (Vec<Operation>, Vec<Step>) {
    let mut needed = needed(operations, entries, |_| true);
    needed.resize(operations.len(), false);
    needed[..dimension].fill(true);
    for place in 1..operations.len() {
        // The two steps of a pair stay together.
        needed[place] |= operations[place] == Operation::Second && needed[place - 1];
    }
    let mut moved = vec![0; operations.len()];
    let mut kept = Vec::new();
    for (place, operation) in operations.iter().enumerate().filter(|&(place, _)| needed[place]) {
        moved[place] = kept.len() as Step;
        kept.push(operation.with_reads(|step| moved[step as usize]));
    }
    (kept, entries.iter().map(|&entry| moved[entry as usize]).collect())
}

#[cfg(test)]
mod tests {
    use super::Formula;

    /// Polynomials of equal steps are equal, also within functions, quotients and pairs; nothing else is
    /// known to be equal.
    #[test]
    fn halves_that_are_the_same_polynomial_are_equal() {
        let halves = |upper: &str, lower: &str| {
            let text =
                format!("s, c = sin_cos(x1*x2); t, d = sin_cos(x2*x1); [9, {upper}; {lower}, 9]");
            Formula::<2>::parse(&text, &[]).expect("a formula").unequal_halves()
        };
        for (upper, lower) in [
            ("x1*x2", "x2*x1"),
            ("x1 + x2*exp(x1 + x2)", "exp(x2 + x1)*x2 + x1"),
            ("(x1*x2)^3 - 2*x1", "(x2*x1)^3 - x1*2"),
            ("s/(c + x1)", "t/(x1 + d)"),
            ("0", "-0.0"),
            ("x1*(x2*exp(x1))", "(exp(x1)*x1)*x2"),
            ("(x1 + x2)*(x1 - s)", "x1^2 + x1*x2 - s*x1 - x2*t"),
            ("-x1*(x2 + 0*x1)", "x1*-x2 - x1*0*x1"),
            ("sqr(x1 - 2)", "x1*x1 - 2*x1 - x1*2 + number(2)*2"),
        ] {
            assert_eq!(halves(upper, lower), None, "{upper} and {lower}");
        }
        for (upper, lower) in [
            ("0", "x2"),
            ("0", "3*(x1 + x2)"),
            ("x1 - x2", "x2 - x1"),
            ("x1/x2", "x2/x1"),
            ("s", "d"),
            ("s", "c"),
            ("x1^2", "x1^3"),
            ("x1*x2", "x1 + x2"),
            ("x1 + 1", "x1 + 2"),
            ("x1*x2/2", "0.5*x1*x2"),
            // One half is undefined at 0, the other one is not.
            ("x1 + x2/x1 - x2/x1", "x1"),
            ("0", "0/x1"),
            ("0", "0*ln(x1)"),
            ("x1^2", "x1"),
            ("2*x1", "x1"),
            ("x1 + x1", "x1"),
            ("x1 - x2", "x1 + x2"),
        ] {
            assert_eq!(halves(upper, lower), Some((0, 1)), "{upper} and {lower}");
        }
        // Rᵀ D R and Jᵀ G J, multiplied from the left.
        let entry = |i: usize, j: usize| {
            let place = |k: usize, l: usize| format!("(x{k}*sin(x{i}))*g{k}{l}*(x{l}*sin(x{j}))");
            let [a, b, c, d] = [place(1, 1), place(1, 2), place(2, 1), place(2, 2)];
            format!("({a} + {b}) + ({c} + {d})")
        };
        let text = format!(
            "g11 = exp(x1); g12 = x1*x2; g21 = g12; g22 = 9 + x2; [{}, {}; {}, {}]",
            entry(1, 1),
            entry(1, 2),
            entry(2, 1),
            entry(2, 2)
        );
        assert_eq!(Formula::<2>::parse(&text, &[]).expect("a formula").unequal_halves(), None);
        // Polynomials that are too long to be expanded are compared step by step.
        let long = (0..12).map(|n| format!("(x1 + exp({n}*x2))")).collect::<Vec<_>>().join("*");
        assert_eq!(halves(&format!("x1*({long})"), &format!("({long})*x1")), None);
        let later = Formula::<3>::parse("[9, x1, x2; x1, 9, x3; x2, x1, 9]", &[]);
        assert_eq!(later.expect("a formula").unequal_halves(), Some((1, 2)));
    }

    #[test]
    fn the_upper_half_leaves_nothing_of_the_lower_one() {
        let of = |text: &str| Formula::<2>::parse(text, &[]).expect("a formula");
        let typed = of("[2 + x1, x1*x2; x2*x1 + 0/x1, 3]");
        assert_eq!(typed.of_upper_half(), of("a = 2 + x1; b = x1*x2; [a, b; b, 3]"));
        let pole = of("[1, 0; 1/x1, 1]").of_upper_half();
        assert_eq!(pole.operations().len(), 4, "{pole}");
        assert_eq!(pole.of_upper_half(), pole);
        // Both functions of a pair stay.
        let pair = of("s, c = sin_cos(x1); [2 + s, s; s + c, 2]").of_upper_half();
        assert_eq!(Formula::parse(&pair.to_string(), &[]), Ok(pair));
    }
}
