//! `Expansion`: the Gram matrix with its derivatives in the coordinates, at a point or on a box.

use std::borrow::Cow;

use tautline_formula::{Formula, Operation, Pair, Step};
use tautline_scalar::{ANY, Scalar};

use super::rows::{Order, Row, Rows};

/// `H` with its derivatives in the coordinates, up to an order. It is symmetric: the entries on and above
/// the diagonal are those of the formula.
#[derive(Clone, Debug)]
pub(crate) struct Expansion<T> {
    rows: Rows,
    /// The rows of the entries `(i, j)` with `i ≤ j`, column by column.
    numbers: Vec<T>,
}

impl<T: Scalar> Expansion<T> {
    /// Returns the expansion with the row `entry(i, j)` for each entry with `i ≤ j`.
    pub(super) fn from_entries<'r>(rows: Rows, entry: impl Fn(usize, usize) -> Row<'r, T>) -> Self {
        let upper = (0..rows.d).flat_map(|j| (0..=j).map(move |i| (i, j)));
        let mut numbers = Vec::with_capacity(rows.d * (rows.d + 1) / 2 * rows.len());
        upper.for_each(|(i, j)| numbers.extend_from_slice(&entry(i, j).numbers));
        Self { rows, numbers }
    }

    /// Expands a formula at these values of the coordinates.
    pub(crate) fn of(formula: &Formula<ANY>, x: &[T], order: Order) -> Self {
        let rows = Rows { d: formula.dimension(), order };
        let mut tape = Tape::new(formula, rows);
        for place in 0..formula.operations().len() {
            tape.operate(place, |i| x[i], |steps, step| steps.row(step));
        }
        let steps = tape.steps();
        Self::from_entries(rows, |i, j| steps.row(formula.entry(i, j)))
    }

    /// Returns the dimension.
    pub(super) fn dimension(&self) -> usize {
        self.rows.d
    }

    fn row(&self, i: usize, j: usize) -> &[T] {
        let (i, j, n) = (i.min(j), i.max(j), self.rows.len());
        &self.numbers[(j * (j + 1) / 2 + i) * n..][..n]
    }

    /// Returns `Hᵢⱼ`.
    pub(crate) fn value(&self, i: usize, j: usize) -> T {
        self.row(i, j)[0]
    }

    /// Returns `∂ₖHᵢⱼ`.
    pub(crate) fn first(&self, k: usize, i: usize, j: usize) -> T {
        self.row(i, j)[1 + k]
    }

    /// Returns `∂ₖ∂ₗHᵢⱼ`.
    pub(crate) fn second(&self, k: usize, l: usize, i: usize, j: usize) -> T {
        self.row(i, j)[self.rows.second(k.min(l), k.max(l))]
    }

    /// Returns all values and derivatives.
    pub(crate) fn numbers(&self) -> &[T] {
        &self.numbers
    }
}

/// The steps of a formula, expanded one after the other.
pub(super) struct Tape<'f, T> {
    formula: &'f Formula<ANY>,
    pub(super) rows: Rows,
    /// The rows of all steps, of which the first ones are known.
    numbers: Vec<T>,
    bent: Vec<bool>,
    /// The step of the second function of the latest pair, with its value and derivatives.
    second: Option<(usize, [T; 3])>,
}

/// The steps that are known.
#[derive(Clone, Copy)]
pub(super) struct Steps<'t, T> {
    length: usize,
    numbers: &'t [T],
    bent: &'t [bool],
}

impl<'t, T: Scalar> Steps<'t, T> {
    pub(super) fn row(self, step: Step) -> Row<'t, T> {
        let step = step as usize;
        let numbers = &self.numbers[step * self.length..][..self.length];
        Row { numbers: Cow::Borrowed(numbers), bent: self.bent[step] }
    }
}

impl<'f, T: Scalar> Tape<'f, T> {
    pub(super) fn new(formula: &'f Formula<ANY>, rows: Rows) -> Self {
        let steps = formula.operations().len();
        let numbers = vec![T::zero(); steps * rows.len()];
        Self { formula, rows, numbers, bent: Vec::with_capacity(steps), second: None }
    }

    pub(super) fn steps(&self) -> Steps<'_, T> {
        Steps { length: self.rows.len(), numbers: &self.numbers, bent: &self.bent }
    }

    /// Adds a step, which `write` writes into zeros. It says whether second derivatives may be nonzero.
    pub(super) fn push(&mut self, write: impl FnOnce(Steps<'_, T>, &mut [T]) -> bool) {
        let length = self.rows.len();
        let (known, rest) = self.numbers.split_at_mut(self.bent.len() * length);
        let steps = Steps { length, numbers: known, bent: &self.bent };
        let bent = write(steps, &mut rest[..length]);
        self.bent.push(bent);
    }

    /// Adds the step at `place` by its operation, given the values of the coordinates. `read` returns the
    /// rows of the steps that it reads.
    pub(super) fn operate(
        &mut self,
        place: usize,
        coordinate: impl Fn(usize) -> T,
        read: impl for<'t> Fn(Steps<'t, T>, Step) -> Row<'t, T>,
    ) {
        let (formula, rows) = (self.formula, self.rows);
        let expanded = match formula.operations()[place] {
            // Both functions of a pair are computed at once.
            Operation::First(pair, a) => {
                let [first, second] = pair_at(pair, read(self.steps(), a).value(), rows.order);
                self.second = Some((place + 1, second));
                Some(first)
            }
            Operation::Second => {
                self.second.take().filter(|&(of, _)| of == place).map(|(_, second)| second)
            }
            _ => None,
        };
        self.push(|steps, out| {
            let at = |step: Step| read(steps, step);
            match formula.operations()[place] {
                Operation::Coordinate(i) => {
                    rows.coordinate(i as usize, coordinate(i as usize), out)
                }
                Operation::Constant(c) => rows.constant(T::constant(c.value()), out),
                Operation::Binary(how, a, b) => rows.arithmetic(how, &at(a), &at(b), out),
                Operation::WithNumber(how, a, c) => rows.with_number(how, &at(a), c.value(), out),
                Operation::Powi(a, n) => rows.power(&at(a), n, out),
                Operation::Table(call) => {
                    let table = &formula.tables()[call.table as usize];
                    let arguments: Vec<_> = call.arguments().iter().map(|&a| at(a)).collect();
                    rows.table(table, call.orders, &arguments, out)
                }
                Operation::Of(..) | Operation::First(..) | Operation::Second => {
                    let (function, a) =
                        formula.function(place).expect("a second follows its first");
                    match expanded {
                        Some(expanded) => rows.chain(&at(a), expanded, out),
                        None => rows.function(function, &at(a), out),
                    }
                }
            }
        });
    }
}

/// Returns two functions at `x`, each with its derivatives if they are wanted.
fn pair_at<T: Scalar>(pair: Pair, x: T, order: Order) -> [[T; 3]; 2] {
    let values =
        |(first, second): (T, T)| [first, second].map(|value| [value, T::zero(), T::zero()]);
    match (order, pair) {
        (Order::Value, Pair::SinCos) => values(x.sin_cos()),
        (Order::Value, Pair::SinhCosh) => values(x.sinh_cosh()),
        _ => pair.expanded(x),
    }
}

#[cfg(test)]
mod tests {
    use std::array::from_fn;

    use nalgebra::{SMatrix, SVector};
    use tautline_chance::Random;
    use tautline_formula::Formula;
    use tautline_metrics::Metric;
    use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

    use super::{Expansion, Order};
    use crate::testing::tables;

    /// A metric whose entries are some of the [`results`] of all operations, beginning with this one.
    struct Results(usize);

    impl<const D: usize> Metric<D> for Results {
        fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
            let all = results(&from_fn(|i| x[i % D]));
            SMatrix::from_fn(|i, j| {
                let (i, j) = (i.min(j), i.max(j));
                all[(self.0 + j * (j + 1) / 2 + i) % all.len()]
            })
        }
    }

    /// Returns the results of each operation with a coordinate, a constant, and a function without and
    /// one with second derivatives.
    fn results<S: Scalar>(&[x, y, z, v, w]: &[S; 5]) -> Vec<S> {
        let operands = [x, S::constant(0.75), y + z * 0.5 - v - 0.25, x * w + (y * z - v).sqr()];
        let tables = tables().map(|(_, table)| table);
        let mut results = Vec::new();
        for a in operands {
            results.extend([a + 1.5, a - 1.5, a * 1.5, a / 1.5]);
            results.extend([1.5 + a, 1.5 - a, 1.5 * a, 1.5 / a]);
            results.extend([0, 1, 2, 3, -1, -2].map(|n| a.powi(n)));
            results.extend([-a, a.sqr(), a.recip(), a.sqrt(), a.exp(), a.ln()]);
            results.extend([a.sin(), a.cos(), a.tan(), a.atan(), a.sinh(), a.cosh(), a.tanh()]);
            let pairs = [a.sin_cos(), a.sinh_cosh()];
            results.extend(pairs.into_iter().flat_map(|(first, second)| [first, second]));
            results.extend([0, 1].map(|order| S::tabulated(&tables[0], [order, 0, 0], &[a])));
            for b in operands {
                results.extend([a + b, a - b, a * b, a / b]);
                results.push(S::tabulated(&tables[1], [0, 1, 0], &[a, b]));
                results.push(S::tabulated(&tables[2], [0; 3], &[a, b, x]));
            }
        }
        results
    }

    /// Compares the expansions of all results at a point, and returns how many are defined.
    fn compare<T: Scalar, const D: usize>(x: [T; D]) -> usize {
        // Doubles are written with all of their bits, apart from those of NaN.
        let written = |numbers: &[T]| format!("{numbers:?}");
        let row = |at: &dyn Fn(usize) -> T| written(&from_fn::<T, D, _>(at));
        let square = |at: &dyn Fn(usize, usize) -> T| -> String {
            (0..D).map(|k| row(&|l| at(k, l))).collect()
        };
        let mut defined = 0;
        for place in (0..results(&[0.0; 5]).len()).step_by(D * (D + 1) / 2) {
            let formula = Formula::<D>::record(&Results(place)).expect("no comparison");
            let values = formula.gram(&SVector::from(x));
            let ones = formula.gram(&SVector::from(Jet1::variables(&x)));
            let twos = formula.gram(&SVector::from(Jet2::variables(&x)));
            let formula = formula.into_any();
            let [zero, one, two] = [Order::Value, Order::First, Order::Second]
                .map(|order| Expansion::of(&formula, &x, order));
            for (i, j) in (0..D).flat_map(|i| (0..D).map(move |j| (i, j))) {
                let found = [
                    written(&[zero.value(i, j)]),
                    written(&[one.value(i, j)]) + &row(&|k| one.first(k, i, j)),
                    written(&[two.value(i, j)]) + &row(&|k| two.first(k, i, j)),
                    square(&|k, l| two.second(k, l, i, j)),
                ];
                let (value, one, two) = (values[(i, j)], &ones[(i, j)], &twos[(i, j)]);
                let exact = [
                    written(&[value]),
                    written(&[one.value()]) + &row(&|k| one.first(k)),
                    written(&[two.value()]) + &row(&|k| two.first(k)),
                    square(&|k, l| two.second(k, l)),
                ];
                assert_eq!(found, exact, "entry ({i}, {j}) of {formula} at {x:?}");
                let is_nan = |text: &String| text.contains("NaN") || text.contains("undefined");
                defined += usize::from(!exact.iter().any(is_nan));
            }
        }
        defined
    }

    /// Compares at random points, in each type of numbers.
    fn compare_all<const D: usize>(random: &mut Random) {
        let cases = tautline_chance::cases(8);
        let mut defined = [0; 3];
        for case in 0..cases {
            let width = [0.0, 1e-9, 0.1, 2.0][case as usize % 4];
            let mut side = || {
                let lo = random.between(-2.0, 2.0);
                Interval::new(lo, lo + width).expect("in order")
            };
            let x: [Jet1<Interval, 2>; D] = from_fn(|_| Jet1::new(side(), from_fn(|_| side())));
            defined[0] += compare(x.map(|x| x.value().lo()));
            defined[1] += compare(x.map(|x| x.value()));
            defined[2] += compare(x);
        }
        assert!(defined.iter().all(|&defined| defined > 150 * cases as usize), "{defined:?}");
    }

    #[test]
    fn an_expansion_has_the_bits_of_its_formula_in_jets() {
        let mut random = Random(tautline_chance::seed(62));
        compare_all::<1>(&mut random);
        compare_all::<2>(&mut random);
        compare_all::<3>(&mut random);
        compare_all::<5>(&mut random);
    }
}
