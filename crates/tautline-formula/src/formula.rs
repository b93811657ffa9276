//! `Formula`: the Gram matrix of a metric as a list of operations.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::Metric;
use tautline_scalar::Scalar;

use crate::{
    RecordError,
    operation::{Arithmetic, Operation, Pair, Step},
    recording::{Recording, Symbol, record},
};

/// The formula of a Gram matrix `H(x)` on `R^D`: what a metric does with its numbers, step by step.
///
/// Two formulas are equal if they do the same in the same order, not if they have the same values.
/// Evaluated, a formula gives the bits that the metric itself gives, in `f64`, in jets and in intervals.
///
/// # Laws
///
/// The first `D` steps are the coordinates; a step reads earlier ones only; each of the others is needed
/// for an entry; no two are the same, but for the second ones of pairs.
#[derive(Clone, Debug, PartialEq, Eq, Hash)]
#[doc(alias = "tape")]
pub struct Formula<const D: usize> {
    operations: Vec<Operation>,
    /// The steps that are the entries of `H`, column by column.
    entries: Vec<Step>,
}

impl<const D: usize> Formula<D> {
    /// Records what a metric does: its formula is evaluated once.
    ///
    /// # Errors
    ///
    /// [`RecordError`] if the formula compares numbers that depend on `x`, has too many steps, or is
    /// evaluated elsewhere.
    pub fn record(metric: &impl Metric<D>) -> Result<Self, RecordError> {
        let (gram, recording) = record(D, |x| metric.gram(&SVector::from_fn(|i, _| x[i])));
        Self::of(gram.as_slice(), &recording)
    }

    /// The formula of these entries, column by column.
    pub(crate) fn of(entries: &[Symbol], recording: &Recording) -> Result<Self, RecordError> {
        let (operations, entries) = needed(entries, recording, D)?;
        Ok(Self { operations, entries })
    }

    pub(crate) fn tape(&self) -> Tape<'_> {
        Tape { dimension: D, operations: &self.operations, entries: &self.entries }
    }

    /// Returns the steps.
    #[must_use]
    pub fn operations(&self) -> &[Operation] {
        &self.operations
    }

    /// Returns the step that is the entry `Hᵢⱼ`, from 0 on.
    ///
    /// # Panics
    ///
    /// If `row` or `column` is `D` or more.
    #[must_use]
    pub fn entry(&self, row: usize, column: usize) -> Step {
        assert!(row < D && column < D, "entry ({row}, {column}) of {D} × {D}");
        self.entries[column * D + row]
    }
}

/// A formula whose dimension is a number: what is done with it is compiled once for all dimensions.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Tape<'f> {
    pub(crate) dimension: usize,
    pub(crate) operations: &'f [Operation],
    /// Column by column.
    pub(crate) entries: &'f [Step],
}

impl Tape<'_> {
    /// The values of all steps at `x`.
    fn values<S: Scalar>(self, x: &[S]) -> Vec<S> {
        let mut values: Vec<S> = Vec::with_capacity(self.operations.len());
        // The second of the pair that was evaluated last.
        let mut second = None;
        for &operation in self.operations {
            let at = |step: Step| values[step as usize];
            let value = match operation {
                Operation::Coordinate(i) => x[i as usize],
                Operation::Constant(number) => S::constant(number.value()),
                Operation::Binary(how, a, b) => match how {
                    Arithmetic::Add => at(a) + at(b),
                    Arithmetic::Sub => at(a) - at(b),
                    Arithmetic::Mul => at(a) * at(b),
                    Arithmetic::Div => at(a) / at(b),
                },
                Operation::WithNumber(how, a, number) => match how {
                    Arithmetic::Add => at(a) + number.value(),
                    Arithmetic::Sub => at(a) - number.value(),
                    Arithmetic::Mul => at(a) * number.value(),
                    Arithmetic::Div => at(a) / number.value(),
                },
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
                // After its first one, always.
                Operation::Second => second.unwrap_or_else(S::zero),
            };
            values.push(value);
        }
        values
    }
}

impl<const D: usize> Metric<D> for Formula<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        let values = self.tape().values(x.as_slice());
        SMatrix::from_fn(|i, j| values[self.entries[j * D + i] as usize])
    }
}

/// The steps of a recording that are needed for these entries, and the entries.
fn needed(
    entries: &[Symbol],
    recording: &Recording,
    dimension: usize,
) -> Result<(Vec<Operation>, Vec<Step>), RecordError> {
    if let Some(error) = recording.failed {
        return Err(error);
    }
    let entries: Vec<Step> = entries.iter().map(|entry| entry.0).collect();
    if entries.iter().any(|&entry| entry as usize >= recording.operations.len()) {
        return Err(RecordError::Foreign);
    }
    Ok(without_idle(&recording.operations, &entries, dimension))
}

/// The coordinates and the steps that are needed for these entries, in the order in which they were.
fn without_idle(
    operations: &[Operation],
    entries: &[Step],
    dimension: usize,
) -> (Vec<Operation>, Vec<Step>) {
    let mut needed = vec![false; operations.len()];
    needed[..dimension].fill(true);
    for &entry in entries {
        needed[entry as usize] = true;
    }
    for place in (0..operations.len()).rev().filter(|&place| place >= dimension) {
        // A pair is not parted.
        let is_followed = operations.get(place + 1) == Some(&Operation::Second);
        needed[place] |= is_followed && needed[place + 1];
        if needed[place] {
            if is_followed {
                needed[place + 1] = true;
            }
            for read in operations[place].reads(place as Step).into_iter().flatten() {
                needed[read as usize] = true;
            }
        }
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
    use nalgebra::{SMatrix, SVector};
    use tautline_metrics::{Metric, gallery};
    use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

    use super::Formula;
    use crate::{
        RecordError,
        operation::{Arithmetic, Function, Number, Operation, Pair},
    };

    /// The same as text: NaN is NaN, and `−0` is not `0`.
    fn same<S: Scalar, const D: usize>(
        metric: &impl Metric<D>,
        formula: &Formula<D>,
        x: &SVector<S, D>,
    ) {
        let (found, expected) = (formula.gram(x), metric.gram(x));
        for (found, expected) in found.iter().zip(&expected) {
            assert_eq!(format!("{found:?}"), format!("{expected:?}"), "at {x:?}");
        }
    }

    /// At some points, in the numbers that the library uses.
    fn records<const D: usize>(metric: &impl Metric<D>) {
        let formula = Formula::record(metric).expect("no comparison");
        for k in 0..32_u32 {
            let at = |i: usize| ((f64::from(k) + 0.5) * (0.618 + 0.755 * i as f64)).fract() - 0.5;
            let x: [f64; D] = std::array::from_fn(at);
            let boxes: [Interval; D] =
                x.map(|x| Interval::new(x, x + 0.125).expect("ordered ends"));
            same(metric, &formula, &SVector::from(x));
            same(metric, &formula, &SVector::from(Jet1::variables(&x)));
            same(metric, &formula, &SVector::from(Jet2::variables(&x)));
            same(metric, &formula, &SVector::from(boxes));
            same(metric, &formula, &SVector::from(Jet2::variables(&boxes)));
        }
        assert_eq!(Formula::record(&formula).as_ref(), Ok(&formula));
    }

    #[test]
    fn the_gallery_is_recorded_to_the_bit() {
        records::<2>(&gallery::Valleys);
        records(&gallery::Shear::new(0.5, 1.0).expect("a wave number"));
        records::<2>(&gallery::Bump::new(0.5, 1.0).expect("positive"));
        records::<2>(&gallery::Lens::new(0.5, 1.0).expect("positive"));
        records::<2>(&gallery::Hill::new(0.5, 1.0).expect("positive"));
        records(&gallery::Ramp::new(0.5, 1.0).expect("below one"));
        records(&gallery::Separable::new([0.3, -0.5, 0.7], [1.0, 2.0, 3.0]).expect("below one"));
        records(&gallery::CoupledCosines);
        records(&gallery::RotatingAnisotropy::new([4.0, 1.0], [1.0, 0.5]).expect("positive"));
        records(&gallery::SineProjections::benchmark());
        records::<2>(&gallery::Sphere);
        records::<3>(&gallery::Hyperbolic);
        records(&gallery::GaussianFisher);
        records(&gallery::Constant::<3>::new(SMatrix::identity()).expect("definite"));
    }

    /// One of each operation, with numbers on either side.
    struct Everything;

    impl Metric<1> for Everything {
        fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
            let x = x[0];
            let (sin, cos) = x.sin_cos();
            let (sinh, cosh) = x.sinh_cosh();
            let mut sum = (2.0 - x).sqr() + 3.0 / (x + 4.0) + x.powi(-3) - (x * x - 5.0).tan();
            sum += sin * cosh - cos / sinh + (-x).atan() * (x * 0.5).sinh() + x.cosh();
            sum -= (x / 8.0).exp().sqrt().ln().tanh() + x.sin() - x.cos() + S::constant(-0.0);
            sum *= x.recip() + S::one();
            SMatrix::from_element(sum)
        }
    }

    #[test]
    fn every_operation_is_recorded_to_the_bit() {
        records(&Everything);
        let formula = Formula::record(&Everything).expect("no comparison");
        let has = |operation| formula.operations().contains(&operation);
        let [sub, add] = [Arithmetic::Sub, Arithmetic::Add];
        assert!(has(Operation::Of(Function::Neg, 0)) && has(Operation::Powi(0, -3)));
        assert!(has(Operation::WithNumber(add, 0, Number::of(4.0))));
        assert!(
            has(Operation::Constant(Number::of(-0.0))) && has(Operation::First(Pair::SinCos, 0))
        );
        assert!(
            formula
                .operations()
                .iter()
                .any(|step| matches!(step, Operation::Binary(how, ..) if *how == sub))
        );
    }

    #[test]
    fn what_is_asked_for_twice_is_a_step_once_and_what_is_not_used_none() {
        struct Twice;
        impl Metric<2> for Twice {
            fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
                let _ = x[1].exp() + x[0].sinh_cosh().1;
                let (_, cos) = x[0].sin_cos();
                SMatrix::from_diagonal_element(cos + 2.0)
                    + SMatrix::from_diagonal_element(cos + 2.0)
            }
        }
        let formula = Formula::record(&Twice).expect("no comparison");
        let cos = 3;
        assert_eq!(
            formula.operations()[..5],
            [
                Operation::Coordinate(0),
                Operation::Coordinate(1),
                Operation::First(Pair::SinCos, 0),
                Operation::Second,
                Operation::WithNumber(Arithmetic::Add, cos, Number::of(2.0)),
            ]
        );
        // 2 cos + 4 twice, and 0 + 0 twice.
        assert_eq!(formula.entry(0, 0), formula.entry(1, 1));
        assert_eq!(formula.entry(0, 1), formula.entry(1, 0));
        assert_eq!(formula.operations().len(), 8, "{formula:?}");
    }

    #[test]
    fn a_formula_with_branches_is_refused() {
        struct Branch;
        impl Metric<1> for Branch {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                let zero = S::zero();
                SMatrix::from_element(if x[0] == zero { S::one() } else { x[0].sin() / x[0] })
            }
        }
        assert_eq!(Formula::record(&Branch), Err(RecordError::Compares));
        // Of numbers the answer is known.
        struct Known;
        impl Metric<1> for Known {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                let half = S::constant(0.5);
                assert!(half == S::constant(0.5) && half != S::one() && !half.is_zero());
                SMatrix::from_element(if S::zero().is_zero() { x[0] + 1.0 } else { x[0] })
            }
        }
        records(&Known);
    }

    #[test]
    fn a_loop_without_end_in_sight_is_refused() {
        struct Loop;
        impl Metric<1> for Loop {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                SMatrix::from_element((0..2_000_000).fold(x[0], |sum, k| sum + f64::from(k)))
            }
        }
        let most = crate::LONGEST;
        assert_eq!(Formula::record(&Loop), Err(RecordError::TooLong { most }));
    }

    /// Numbers that another thread has made are on no tape.
    #[test]
    fn a_formula_that_is_evaluated_elsewhere_is_refused() {
        struct Elsewhere;
        impl Metric<1> for Elsewhere {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                let x = x[0];
                let sum = std::thread::scope(|scope| scope.spawn(|| x + 1.0).join());
                SMatrix::from_element(sum.expect("no panic"))
            }
        }
        assert_eq!(Formula::record(&Elsewhere), Err(RecordError::Foreign));
    }

    /// A formula may record another one; and what a panic leaves behind is not on the next tape.
    #[test]
    fn recordings_do_not_disturb_each_other() {
        struct Within;
        impl Metric<1> for Within {
            fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                let before = x[0].sin();
                assert!(Formula::record(&Everything).is_ok());
                SMatrix::from_element(before * x[0].sin() + 2.0)
            }
        }
        records(&Within);
        struct Panics;
        impl Metric<1> for Panics {
            fn gram<S: Scalar>(&self, _: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                panic!("on purpose")
            }
        }
        let caught = std::panic::catch_unwind(|| Formula::record(&Panics));
        assert!(caught.is_err());
        records(&Everything);
    }
}
