//! `Row`: a number with its derivatives in a number of coordinates that is a value.

use std::{borrow::Cow, sync::Arc};

use tautline_formula::{Arithmetic, Function};
use tautline_scalar::{Scalar, Table, elementary};

/// The highest order of derivatives that are wanted.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Order {
    Value,
    First,
    Second,
}

/// The shape of a row: the value; the `d` first derivatives; the second derivatives `∂ₖ∂ₗ` for
/// `k ≤ l`, row by row.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rows {
    pub(crate) d: usize,
    pub(crate) order: Order,
}

/// A number with its derivatives.
///
/// A product, a quotient and a function of a row are computed by the operations of
/// [`Jet1`](tautline_scalar::Jet1) and [`Jet2`](tautline_scalar::Jet2), in the same order, so that the
/// results have the same bits.
#[derive(Clone, Debug)]
pub(crate) struct Row<'r, T: Scalar> {
    pub(crate) numbers: Cow<'r, [T]>,
    /// Whether second derivatives may be nonzero.
    pub(crate) bent: bool,
}

impl<T: Scalar> Row<'_, T> {
    pub(crate) fn value(&self) -> T {
        self.numbers[0]
    }
}

impl Rows {
    /// Returns how many numbers a row has.
    pub(crate) fn len(self) -> usize {
        match self.order {
            Order::Value => 1,
            Order::First => 1 + self.d,
            Order::Second => self.second(self.d, self.d),
        }
    }

    /// Returns the place of `∂ₖ∂ₗ`, for `k ≤ l`.
    pub(crate) fn second(self, k: usize, l: usize) -> usize {
        1 + self.d + (k * (2 * self.d - k) + k) / 2 + l - k
    }

    /// Calls `f` with the place of each second derivative and its coordinates.
    #[inline(always)]
    fn for_each_second(self, mut f: impl FnMut(usize, usize, usize)) {
        if self.order < Order::Second {
            return;
        }
        let mut place = 1 + self.d;
        for k in 0..self.d {
            for l in k..self.d {
                f(place, k, l);
                place += 1;
            }
        }
    }

    fn firsts(self) -> std::ops::Range<usize> {
        1..if self.order == Order::Value { 1 } else { 1 + self.d }
    }

    /// Makes a row.
    pub(crate) fn row<T: Scalar>(self, write: impl FnOnce(&mut [T]) -> bool) -> Row<'static, T> {
        let mut numbers = vec![T::zero(); self.len()];
        let bent = write(&mut numbers);
        Row { numbers: Cow::Owned(numbers), bent }
    }

    /// Returns the row with this value; all of its derivatives are `slope`.
    pub(crate) fn uniform<T: Scalar>(self, value: T, slope: T) -> Row<'static, T> {
        self.row(|out| {
            out.fill(slope);
            out[0] = value;
            true
        })
    }

    /// Writes a constant. Here and below, `out` is zero before, and the result says whether second
    /// derivatives may be nonzero.
    pub(crate) fn constant<T: Scalar>(self, value: T, out: &mut [T]) -> bool {
        out[0] = value;
        false
    }

    /// Writes the coordinate with this number, at this value.
    pub(crate) fn coordinate<T: Scalar>(self, number: usize, value: T, out: &mut [T]) -> bool {
        out[0] = value;
        if self.order > Order::Value {
            out[1 + number] = T::one();
        }
        false
    }

    /// Writes `f` of each number, for a linear `f`.
    pub(crate) fn map<T: Scalar>(self, a: &Row<'_, T>, f: impl Fn(T) -> T, out: &mut [T]) -> bool {
        let linear = if a.bent { out.len() } else { self.firsts().end };
        for (out, &a) in out[..linear].iter_mut().zip(&a.numbers[..linear]) {
            *out = f(a);
        }
        a.bent
    }

    /// Writes `a ∘ b`.
    pub(crate) fn arithmetic<T: Scalar>(
        self,
        how: Arithmetic,
        a: &Row<'_, T>,
        b: &Row<'_, T>,
        out: &mut [T],
    ) -> bool {
        match how {
            Arithmetic::Add => self.sum(a, b, |a, b| a + b, out),
            Arithmetic::Sub => self.sum(a, b, |a, b| a - b, out),
            Arithmetic::Mul => self.product(a, b, out),
            Arithmetic::Div => self.quotient(a, b, out),
        }
    }

    /// Writes `a ∘ c`.
    pub(crate) fn with_number<T: Scalar>(
        self,
        how: Arithmetic,
        a: &Row<'_, T>,
        c: f64,
        out: &mut [T],
    ) -> bool {
        let shifted = |value: T, out: &mut [T]| {
            out.copy_from_slice(&a.numbers);
            out[0] = value;
            a.bent
        };
        match how {
            Arithmetic::Add => shifted(a.value() + c, out),
            Arithmetic::Sub => shifted(a.value() + -c, out),
            Arithmetic::Mul => self.map(a, |a| a * c, out),
            Arithmetic::Div => self.map(a, |a| a / c, out),
        }
    }

    /// Writes `xⁿ`.
    pub(crate) fn power<T: Scalar>(self, x: &Row<'_, T>, n: i32, out: &mut [T]) -> bool {
        match (self.order, n) {
            (Order::Value, _) => self.constant(x.value().powi(n), out),
            (_, 1) => self.map(x, |x| x, out),
            _ => self.chain(x, elementary::powi(x.value(), n), out),
        }
    }

    /// Writes `f(x)`.
    pub(crate) fn function<T: Scalar>(self, f: Function, x: &Row<'_, T>, out: &mut [T]) -> bool {
        match (self.order, f) {
            (Order::Value, _) => self.constant(f.of(x.value()), out),
            (_, Function::Neg) => self.map(x, |x| -x, out),
            _ => self.chain(x, f.expanded(x.value()), out),
        }
    }

    /// Returns `a + b`.
    pub(crate) fn sum_of<T: Scalar>(self, a: &Row<'_, T>, b: &Row<'_, T>) -> Row<'static, T> {
        self.row(|out| self.sum(a, b, |a, b| a + b, out))
    }

    /// Returns `c x`.
    pub(crate) fn times<T: Scalar>(self, x: &Row<'_, T>, c: f64) -> Row<'static, T> {
        self.row(|out| self.map(x, |x| x * c, out))
    }

    fn sum<T: Scalar>(
        self,
        a: &Row<'_, T>,
        b: &Row<'_, T>,
        f: impl Fn(T, T) -> T,
        out: &mut [T],
    ) -> bool {
        out.copy_from_slice(&a.numbers);
        let added = if b.bent { out.len() } else { self.firsts().end };
        for (out, &b) in out[..added].iter_mut().zip(&b.numbers[..added]) {
            *out = f(*out, b);
        }
        a.bent || b.bent
    }

    fn product<T: Scalar>(self, a: &Row<'_, T>, b: &Row<'_, T>, out: &mut [T]) -> bool {
        let (a_bent, b_bent) = (a.bent, b.bent);
        let (a, b): (&[T], &[T]) = (&a.numbers, &b.numbers);
        out[0] = a[0] * b[0];
        for i in self.firsts() {
            out[i] = a[i] * b[0] + b[i] * a[0];
        }
        self.for_each_second(|at, k, l| {
            let mixed = a[1 + k] * b[1 + l] + a[1 + l] * b[1 + k];
            out[at] = match (a_bent, b_bent) {
                (true, true) => a[at] * b[0] + b[at] * a[0] + mixed,
                (true, false) => a[at] * b[0] + mixed,
                (false, true) => b[at] * a[0] + mixed,
                (false, false) => mixed,
            };
        });
        true
    }

    fn quotient<T: Scalar>(self, a: &Row<'_, T>, b: &Row<'_, T>, out: &mut [T]) -> bool {
        let (a, b): (&[T], &[T]) = (&a.numbers, &b.numbers);
        // Differentiating q b = a once and twice gives
        // q' b + q b' = a',   qᵢⱼ b + qᵢ bⱼ + qⱼ bᵢ + q bᵢⱼ = aᵢⱼ.
        let q = a[0] / b[0];
        out[0] = q;
        for i in self.firsts() {
            out[i] = (a[i] - q * b[i]) / b[0];
        }
        self.for_each_second(|at, k, l| {
            let known = a[at] - out[1 + k] * b[1 + l] - out[1 + l] * b[1 + k] - q * b[at];
            out[at] = known / b[0];
        });
        true
    }

    /// Writes `f(x)`, where `f` has this value and these derivatives at the value of `x`.
    pub(crate) fn chain<T: Scalar>(
        self,
        x: &Row<'_, T>,
        [value, first, second]: [T; 3],
        out: &mut [T],
    ) -> bool {
        let g: &[T] = &x.numbers;
        out[0] = value;
        for i in self.firsts() {
            out[i] = g[i] * first;
        }
        self.for_each_second(|at, k, l| {
            // The square of an interval is tighter than its product with itself.
            let product = if k == l { g[1 + k].sqr() } else { g[1 + k] * g[1 + l] };
            out[at] = if x.bent { g[at] * first + product * second } else { product * second };
        });
        true
    }

    /// Writes the partial derivative of a table at these arguments, by Taylor's formula to second order,
    /// which is exact for a row.
    pub(crate) fn table<T: Scalar>(
        self,
        table: &Arc<dyn Table>,
        orders: [u8; 3],
        arguments: &[Row<'_, T>],
        out: &mut [T],
    ) -> bool {
        let at: Vec<T> = arguments.iter().map(Row::value).collect();
        let value = T::tabulated(table, orders, &at);
        if self.order == Order::Value {
            return self.constant(value, out);
        }
        let raised = |mut orders: [u8; 3], axis: usize| {
            orders[axis] = orders[axis].saturating_add(1);
            orders
        };
        let steps = arguments.iter().map(|argument| {
            let mut step = argument.clone();
            step.numbers.to_mut()[0] = T::zero();
            step
        });
        let steps: Vec<Row<'_, T>> = steps.collect();
        let mut sum = self.row(|out| self.constant(value, out));
        let mut add = |term: Row<'_, T>| sum = self.sum_of(&sum, &term);
        for axis in 0..at.len() {
            let slopes = raised(orders, axis);
            let slope = T::tabulated(table, slopes, &at);
            add(self.row(|out| self.map(&steps[axis], |c| c * slope, out)));
            if self.order < Order::Second {
                continue;
            }
            for other in axis..at.len() {
                let bend = T::tabulated(table, raised(slopes, other), &at);
                let bend = if other == axis { bend * 0.5 } else { bend };
                let both = self.row(|out| self.product(&steps[axis], &steps[other], out));
                add(self.row(|out| self.map(&both, |c| c * bend, out)));
            }
        }
        out.copy_from_slice(&sum.numbers);
        out[0] = value;
        sum.bent
    }
}
