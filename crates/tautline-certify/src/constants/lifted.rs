//! The evaluation of a lifted formula, in jets with respect to the coordinates of space.

use nalgebra::SMatrix;
use num_traits::Zero;
use tautline_formula::{Function, Step};
use tautline_scalar::{Interval, Jet1, Jet2, Scalar};

use crate::{
    formula::{Lift, Place, Role, Wall, operate},
    patch::Patch,
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

impl<const D: usize> Variable for Jet1<Interval, D> {
    fn fixed(value: Interval) -> Self {
        Self::new(value, [Interval::zero(); D])
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

/// A number with its derivatives with respect to `D` coordinates, up to some order.
pub(crate) trait Expansion<T, const D: usize>: Scalar {
    /// Returns the number with this value; all of its derivatives are `slope`.
    fn uniform(value: T, slope: T) -> Self;

    /// Returns the coordinate functions at the origin.
    fn coordinates() -> [Self; D];

    /// Returns the value.
    fn top(&self) -> T;
}

impl<T: Scalar, const D: usize> Expansion<T, D> for T {
    fn uniform(value: T, _: T) -> Self {
        value
    }

    fn coordinates() -> [Self; D] {
        [T::zero(); D]
    }

    fn top(&self) -> T {
        *self
    }
}

impl<T: Scalar, const D: usize> Expansion<T, D> for Jet1<T, D> {
    fn uniform(value: T, slope: T) -> Self {
        Self::new(value, [slope; D])
    }

    fn coordinates() -> [Self; D] {
        Self::variables(&[T::zero(); D])
    }

    fn top(&self) -> T {
        self.value()
    }
}

impl<T: Scalar, const D: usize> Expansion<T, D> for Jet2<T, D> {
    fn uniform(value: T, slope: T) -> Self {
        Self::new(value, [slope; D], |_, _| slope)
    }

    fn coordinates() -> [Self; D] {
        Self::variables(&[T::zero(); D])
    }

    fn top(&self) -> T {
        self.value()
    }
}

/// Returns `H` at these values of the variables, in this chart.
pub(crate) fn gram<T: Variable, J: Expansion<T, D>, const D: usize>(
    lift: &Lift<D>,
    at: &[T],
    chart: usize,
) -> SMatrix<J, D, D> {
    let lifted = Lifted { lift, at, chart };
    let coordinates = J::coordinates();
    let mut values: Vec<J> = Vec::with_capacity(lift.roles.len());
    for place in 0..lift.roles.len() {
        let value = lifted.step(place, &values, &coordinates);
        values.push(value);
    }
    let read = |step: Step| lifted.read(&values, step);
    SMatrix::from_fn(|i, j| read(lift.formula.entry(i.min(j), i.max(j))))
}

/// Returns whether intervals bound `H` and its derivatives up to second order on all of space.
pub(crate) fn is_bounded<const D: usize>(lift: &Lift<D>) -> bool {
    let is_bounded = |patch: &Patch| {
        let gram: SMatrix<Jet2<Interval, D>, D, D> = gram(lift, &patch.sides, patch.chart);
        gram.iter().all(|entry| {
            let second = (0..D).flat_map(|k| (k..D).map(move |l| (k, l)));
            entry.value().is_finite()
                && entry.gradient().iter().all(|first| first.is_finite())
                && second.into_iter().all(|(k, l)| entry.second(k, l).is_finite())
        })
    };
    crate::patch::Region::patches(lift).iter().all(is_bounded)
}

/// A lifted formula at values of its variables.
struct Lifted<'a, T, const D: usize> {
    lift: &'a Lift<D>,
    at: &'a [T],
    chart: usize,
}

impl<T: Variable, const D: usize> Lifted<'_, T, D> {
    /// Returns the value of a step. That of a linear step is taken at the origin of space, and
    /// [`read`](Lifted::read) adds the value of its form.
    fn step<J: Expansion<T, D>>(&self, place: usize, values: &[J], x: &[J; D]) -> J {
        let formula = &self.lift.formula;
        let read = |step: Step| self.read(values, step);
        let plain = || operate(formula, place, |i| x[i], read);
        match self.lift.roles[place] {
            Role::Linear(_) => operate(formula, place, |i| x[i], |step| values[step as usize]),
            Role::Wave { step, form, phase, multiple } => {
                let (function, _) = formula.function(place).expect("a wave");
                function.of(self.phase(values, step, form, phase, multiple))
            }
            Role::Wall(Wall { numerator, d, f, z }) => {
                // 1/(d + f e^z) = (1 − tanh ½(z + ln(f/d)))/2d.
                let shift = (J::constant(f) / d).ln();
                let (value, flat) = ((read(z) + shift) * 0.5, self.without_value(values, z) * 0.5);
                let wall = (1.0 - saturating(Function::Tanh, value, flat)) * 0.5 / d;
                numerator.map_or(wall, |numerator| wall * read(numerator))
            }
            Role::Hill(hill) => self.hill(hill).unwrap_or_else(plain),
            Role::Plain => match formula.function(place) {
                Some((function @ (Function::Tanh | Function::Atan), step))
                    if matches!(self.lift.roles[step as usize], Role::Linear(_)) =>
                {
                    saturating(function, read(step), self.without_value(values, step))
                }
                _ => plain(),
            },
        }
    }

    /// Returns the value of a step for a step that reads it.
    fn read<J: Expansion<T, D>>(&self, values: &[J], step: Step) -> J {
        let value = values[step as usize];
        match self.lift.roles[step as usize] {
            Role::Linear(Some((form, scale))) => match self.lift.forms[form].variable {
                Some(variable) => value + J::uniform(self.at[variable].scaled(scale), T::zero()),
                None => value,
            },
            _ => value,
        }
    }

    /// Returns a linear step minus its value, which may be infinite.
    fn without_value<J: Expansion<T, D>>(&self, values: &[J], step: Step) -> J {
        let value = values[step as usize];
        value - J::uniform(value.top(), T::zero())
    }

    /// Returns the argument of a wave, up to multiples of `2π`.
    fn phase<J: Expansion<T, D>>(
        &self,
        values: &[J],
        step: Step,
        form: usize,
        phase: usize,
        multiple: f64,
    ) -> J {
        let at = &self.lift.forms[form];
        if at.is_still || self.lift.place(self.chart, form) == Place::Near {
            return self.read(values, step);
        }
        let angle = self.at[at.phases[phase].variable] * multiple;
        values[step as usize] + J::uniform(angle, T::zero())
    }

    /// Returns a hill on a half-line.
    fn hill<J: Expansion<T, D>>(&self, hill: usize) -> Option<J> {
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
        Some(J::uniform(T::fixed(hill.value(form)) + moving, T::fixed(slope) + moving))
    }
}

/// Returns `tanh` or `arctan` of a linear step with this value. `flat` is the step without it.
///
/// On a half-line, the usual formulas for derivatives are `∞ · 0`. Those in terms of the bounded
/// result are not: `1 − t²` and `−2 t (1 − t²)` for `t = tanh y`; `cos²τ` and `−2 sin τ cos³τ` for
/// `τ = arctan y`.
fn saturating<T: Variable, J: Expansion<T, D>, const D: usize>(
    function: Function,
    value: J,
    flat: J,
) -> J {
    let y = value.top();
    if y.enclosure().is_finite() {
        return function.of(value);
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
        [result, first, half_second].map(|value| J::uniform(value, T::zero()));
    // The Taylor polynomial has the derivatives of the function.
    result + flat * first + flat.sqr() * half_second
}
