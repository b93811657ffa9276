//! The evaluation of a lifted formula, with derivatives in the coordinates of space.

use num_traits::Zero;
use tautline_formula::{Arithmetic, Function, Step};
use tautline_scalar::{Interval, Jet1, Scalar};

use super::{
    expansion::{Expansion, Steps, Tape},
    rows::{Order, Row, Rows},
};
use crate::{
    formula::{Lift, Place, Role, Wall},
    patch::{Patch, Region},
};

/// A number in which the variables of a search are given: a double, an interval, or an interval
/// with its derivatives.
pub(crate) trait Variable: Scalar {
    /// Returns the constant with this value.
    fn fixed(value: Interval) -> Self;

    /// Returns the value.
    fn enclosure(&self) -> Interval;

    /// Returns `factor` times the number, also if that is infinite.
    fn scaled(self, factor: Interval) -> Self;

    /// Returns `factor` times the number, minus the value of this product.
    fn change(self, factor: Interval) -> Self;
}

impl Variable for f64 {
    fn fixed(value: Interval) -> Self {
        value.midpoint()
    }

    fn enclosure(&self) -> Interval {
        Interval::point(*self)
    }

    fn scaled(self, factor: Interval) -> Self {
        self * factor.midpoint()
    }

    fn change(self, _: Interval) -> Self {
        0.0
    }
}

impl Variable for Interval {
    fn fixed(value: Interval) -> Self {
        value
    }

    fn enclosure(&self) -> Interval {
        *self
    }

    fn scaled(self, factor: Interval) -> Self {
        self * factor
    }

    fn change(self, _: Interval) -> Self {
        Self::zero()
    }
}

impl<const K: usize> Variable for Jet1<Interval, K> {
    fn fixed(value: Interval) -> Self {
        Self::new(value, [Interval::zero(); K])
    }

    fn enclosure(&self) -> Interval {
        self.value()
    }

    fn scaled(self, factor: Interval) -> Self {
        Self::new(self.value() * factor, self.gradient().map(|slope| slope * factor))
    }

    fn change(self, factor: Interval) -> Self {
        Self::new(Interval::zero(), self.gradient().map(|slope| slope * factor))
    }
}

/// Expands `H` at these values of the variables, in this chart.
pub(crate) fn expansion<T: Variable>(
    lift: &Lift,
    at: &[T],
    chart: usize,
    order: Order,
) -> Expansion<T> {
    let rows = Rows { d: lift.formula.dimension(), order };
    let lifted = Lifted { lift, at, chart, rows };
    let mut tape = Tape::new(&lift.formula, rows);
    for place in 0..lift.roles.len() {
        lifted.step(place, &mut tape);
    }
    let steps = tape.steps();
    Expansion::from_entries(rows, |i, j| lifted.read(steps, lift.formula.entry(i, j)))
}

/// Returns whether intervals bound `H` and its derivatives up to second order on all of space.
pub(crate) fn is_bounded(lift: &Lift) -> bool {
    let is_bounded = |patch: &Patch| {
        let expansion = expansion(lift, &patch.sides, patch.chart, Order::Second);
        expansion.numbers().iter().all(|number| number.is_finite())
    };
    lift.patches().iter().all(is_bounded)
}

/// A lifted formula at values of its variables.
struct Lifted<'a, T> {
    lift: &'a Lift,
    at: &'a [T],
    chart: usize,
    rows: Rows,
}

impl<T: Variable> Lifted<'_, T> {
    /// Adds a step to those that are known. The value of a linear step is taken at the origin of space, and
    /// [`read`](Lifted::read) adds the value of its form.
    fn step(&self, place: usize, tape: &mut Tape<'_, T>) {
        let (formula, rows) = (&self.lift.formula, self.rows);
        let plain = |tape: &mut Tape<'_, T>| {
            tape.operate(place, |_| T::zero(), |steps, step| self.read(steps, step));
        };
        match self.lift.roles[place] {
            Role::Linear(_) => tape.operate(place, |_| T::zero(), |steps, step| steps.row(step)),
            Role::Wave { step, form, phase, multiple } => {
                let (function, _) = formula.function(place).expect("a wave");
                tape.push(|steps, out| {
                    rows.function(function, &self.phase(steps, step, form, phase, multiple), out)
                });
            }
            Role::Wall(Wall { numerator, d, f, z }) => tape.push(|steps, out| {
                // 1/(d + f e^z) = (1 − tanh ½(z + ln(f/d)))/2d.
                let shift = rows.row(|out| {
                    let c = T::constant(f) / d;
                    rows.constant(c, out)
                });
                let shift = rows.row(|out| rows.function(Function::Ln, &shift, out));
                let sum = rows.sum_of(&self.read(steps, z), &shift);
                let half = |row: &Row<'_, T>| rows.times(row, 0.5);
                let (value, flat) = (half(&sum), half(&self.without_value(steps, z)));
                let tanh = saturating(rows, Function::Tanh, &value, &flat);
                let one = rows.row(|out| rows.constant(T::one(), out));
                let below = rows.row(|out| rows.arithmetic(Arithmetic::Sub, &one, &tanh, out));
                let below = half(&below);
                let wall = rows.row(|out| rows.with_number(Arithmetic::Div, &below, d, out));
                match numerator {
                    Some(c) => rows.arithmetic(Arithmetic::Mul, &wall, &self.read(steps, c), out),
                    None => rows.map(&wall, |wall| wall, out),
                }
            }),
            Role::Hill(hill) => match self.hill(hill) {
                Some(hill) => tape.push(|_, out| rows.map(&hill, |hill| hill, out)),
                None => plain(tape),
            },
            Role::Plain => match formula.function(place) {
                Some((function @ (Function::Tanh | Function::Atan), step))
                    if matches!(self.lift.roles[step as usize], Role::Linear(_)) =>
                {
                    tape.push(|steps, out| {
                        let (value, flat) =
                            (self.read(steps, step), self.without_value(steps, step));
                        let result = saturating(rows, function, &value, &flat);
                        rows.map(&result, |result| result, out)
                    });
                }
                _ => plain(tape),
            },
        }
    }

    /// Returns the value of a step for a step that reads it.
    fn read<'t>(&self, steps: Steps<'t, T>, step: Step) -> Row<'t, T> {
        let value = steps.row(step);
        match self.lift.roles[step as usize] {
            Role::Linear(Some((form, scale))) => match self.lift.forms[form].variable {
                Some(variable) => self.shifted(&value, self.at[variable].scaled(scale)),
                None => value,
            },
            _ => value,
        }
    }

    /// Returns a row plus a number of the search.
    fn shifted(&self, row: &Row<'_, T>, by: T) -> Row<'static, T> {
        self.rows.sum_of(row, &self.rows.uniform(by, T::zero()))
    }

    /// Returns a linear step minus its value, which may be infinite.
    fn without_value(&self, steps: Steps<'_, T>, step: Step) -> Row<'static, T> {
        let (rows, value) = (self.rows, steps.row(step));
        let constant = rows.uniform(value.value(), T::zero());
        rows.row(|out| rows.arithmetic(Arithmetic::Sub, &value, &constant, out))
    }

    /// Returns the argument of a wave, up to multiples of `2π`.
    fn phase<'t>(
        &self,
        steps: Steps<'t, T>,
        step: Step,
        form: usize,
        phase: usize,
        multiple: f64,
    ) -> Row<'t, T> {
        let at = &self.lift.forms[form];
        if at.is_still || self.lift.place(self.chart, form) == Place::Near {
            return self.read(steps, step);
        }
        let angle = self.at[at.phases[phase].variable] * multiple;
        self.shifted(&steps.row(step), angle)
    }

    /// Returns a hill on a half-line.
    fn hill(&self, hill: usize) -> Option<Row<'static, T>> {
        let hill = &self.lift.hills[hill];
        let form = |form: usize| {
            let variable = self.lift.forms[form].variable;
            variable.map_or(Interval::point(0.0), |variable| self.at[variable].enclosure())
        };
        if hill.terms.iter().all(|term| form(term.form).is_finite()) {
            return None;
        }
        let size = |form: usize| {
            let direction = &self.lift.forms[form].direction;
            direction.iter().fold(1.0, |most: f64, slope| most.max(slope.magnitude()))
        };
        let slope = hill.slope(form, size);
        let slope = Interval::new(-slope, slope).unwrap_or(Interval::UNDEFINED);
        // The hill changes only with the variables of its forms.
        let variables = hill.terms.iter().filter_map(|term| self.lift.forms[term.form].variable);
        let moving = variables
            .map(|variable| self.at[variable].change(slope))
            .fold(T::zero(), |sum, change| sum + change);
        Some(self.rows.uniform(T::fixed(hill.value(form)) + moving, T::fixed(slope) + moving))
    }
}

/// Returns `tanh` or `arctan` of a linear step with this value. `flat` is the step without it.
///
/// On a half-line, the usual formulas for derivatives are `∞ · 0`. Those in terms of the bounded
/// result are not: `1 − t²` and `−2 t (1 − t²)` for `t = tanh y`; `cos²τ` and `−2 sin τ cos³τ` for
/// `τ = arctan y`.
fn saturating<T: Variable>(
    rows: Rows,
    function: Function,
    value: &Row<'_, T>,
    flat: &Row<'_, T>,
) -> Row<'static, T> {
    let y = value.value();
    if y.enclosure().is_finite() {
        return rows.row(|out| rows.function(function, value, out));
    }
    let result = function.of(y);
    let (first, half_second) = if function == Function::Tanh {
        let first = 1.0 - result.sqr();
        (first, -result * first)
    } else {
        let (sin, cos) = result.sin_cos();
        (cos.sqr(), -sin * cos.powi(3))
    };
    let [result, first, half_second] =
        [result, first, half_second].map(|value| rows.uniform(value, T::zero()));
    // The Taylor polynomial has the derivatives of the function.
    let times = |a: &Row<'_, T>, b: &Row<'_, T>| {
        rows.row(|out| rows.arithmetic(Arithmetic::Mul, a, b, out))
    };
    let square = rows.row(|out| rows.function(Function::Sqr, flat, out));
    let line = rows.sum_of(&result, &times(flat, &first));
    rows.sum_of(&line, &times(&square, &half_second))
}
