//! `Dependence`: how the entries of a Gram matrix depend on each coordinate, read off the formula.

use tautline_formula::{Arithmetic, Formula, Function, Operation};
use tautline_scalar::{ANY, Interval, Scalar};

/// The largest ratio of a wave number to the common divisor of all wave numbers.
///
/// Any two doubles have a common divisor, but for `0.1` and `0.3` it is `2⁻⁵⁵`, and the resulting
/// period is useless.
pub(super) const LARGEST_RATIO: f64 = 1024.0;

/// What a formula shows about the dependence of a step on some coordinates. The step has the form
///
/// `f(x) = a·x + p(x)`
///
/// where `p` does not depend on coordinate `i`, or is periodic in it, or depends on it in an
/// unknown way.
///
/// The formula is followed step by step, with exact arithmetic on its constants, so every period
/// found is proved. There may be others: `sin x / cos x` is known to have the period `2π`, not `π`.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Dependence {
    /// The value if the step is a constant; otherwise meaningless.
    constant: Interval,
    /// The linear coefficients `a`.
    pub(super) slope: Vec<Interval>,
    /// For each coordinate, a common divisor of all wave numbers, in `1/ℓ`; 0 if there is no wave.
    wave_number: Vec<f64>,
    /// Whether the dependence on a coordinate is unknown.
    aperiodic: Vec<bool>,
}

/// How a function depends on one coordinate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Along {
    /// The function does not depend on it.
    Constant,
    /// The function has the period `2π/κ` in it, for the given `κ`, in `1/ℓ`.
    Periodic(f64),
    /// The dependence is unknown.
    Unknown,
}

/// Returns how the Gram matrix depends on each coordinate.
pub(crate) fn dependence(formula: &Formula<ANY>) -> Vec<Along> {
    let d = formula.dimension();
    let steps = steps(formula, &coordinates(d));
    let all =
        entries(formula, &steps).fold(Dependence::constant(d, 0.0), |all, entry| all.joined(entry));
    let along = |i: usize| {
        if all.aperiodic[i] {
            Along::Unknown
        } else if all.wave_number[i] > 0.0 {
            Along::Periodic(all.wave_number[i])
        } else {
            Along::Constant
        }
    };
    (0..d).map(along).collect()
}

/// Returns whether the formula shows that the Gram matrix does not change along `direction`.
pub(crate) fn is_constant_along(formula: &Formula<ANY>, direction: &[f64]) -> bool {
    // The only variable is s, in x + s · direction, and x is arbitrary.
    let x = direction.iter().map(|&slope| Dependence {
        constant: Interval::REALS,
        slope: vec![Interval::point(slope)],
        ..Dependence::constant(1, 0.0)
    });
    let x: Vec<_> = x.collect();
    entries(formula, &steps(formula, &x)).all(Dependence::is_constant)
}

/// Returns the dependence of `d` coordinates on themselves.
pub(super) fn coordinates(d: usize) -> Vec<Dependence> {
    let variable = |i: usize| {
        let mut variable = Dependence { constant: Interval::REALS, ..Dependence::constant(d, 0.0) };
        variable.slope[i] = Interval::point(1.0);
        variable
    };
    (0..d).map(variable).collect()
}

/// Returns the entries on and above the diagonal, which are the only ones read elsewhere.
fn entries<'s>(
    formula: &Formula<ANY>,
    steps: &'s [Dependence],
) -> impl Iterator<Item = &'s Dependence> {
    let upper = (0..formula.dimension()).flat_map(|j| (0..=j).map(move |i| (i, j)));
    let places: Vec<_> = upper.map(|(i, j)| formula.entry(i, j) as usize).collect();
    places.into_iter().map(|place| &steps[place])
}

/// Returns the dependence of each step, given the dependence of the coordinates.
pub(super) fn steps(formula: &Formula<ANY>, x: &[Dependence]) -> Vec<Dependence> {
    let mut steps: Vec<Dependence> = Vec::with_capacity(formula.operations().len());
    let variables = x.first().map_or(0, |x| x.slope.len());
    let constant = |value: f64| Dependence::constant(variables, value);
    for (place, &operation) in formula.operations().iter().enumerate() {
        let at = |step: u32| steps[step as usize].clone();
        let step = match operation {
            Operation::Coordinate(i) => x[i as usize].clone(),
            Operation::Constant(c) => constant(c.value()),
            Operation::Binary(how, a, b) => at(a).combined(how, &steps[b as usize]),
            Operation::WithNumber(how, a, c) => at(a).combined(how, &constant(c.value())),
            Operation::Powi(a, 1) => at(a),
            Operation::Powi(a, n) => at(a).under(Dependence::bent, |constant| constant.powi(n)),
            Operation::Of(Function::Neg, a) => at(a).negative(),
            Operation::Table(call) => {
                let arguments = call.arguments().iter().map(|&argument| &steps[argument as usize]);
                arguments.fold(constant(0.0), Dependence::joined)
            }
            Operation::Of(..) | Operation::First(..) | Operation::Second => {
                let (function, a) = formula.function(place).expect("a second follows its first");
                let bent = match function {
                    Function::Sin | Function::Cos | Function::Tan => Dependence::wave,
                    _ => Dependence::bent,
                };
                at(a).under(bent, |constant| function.of(constant))
            }
        };
        steps.push(step);
    }
    steps
}

impl Dependence {
    /// Returns a constant, as a function of so many coordinates.
    fn constant(variables: usize, value: f64) -> Self {
        Self {
            constant: Interval::point(value),
            slope: vec![Interval::point(0.0); variables],
            wave_number: vec![0.0; variables],
            aperiodic: vec![false; variables],
        }
    }

    pub(super) fn is_constant(&self) -> bool {
        let none =
            |i: usize| is_zero(self.slope[i]) && self.wave_number[i] == 0.0 && !self.aperiodic[i];
        (0..self.slope.len()).all(none)
    }

    /// Returns whether the step is `a·x + c` with `a ≠ 0` and a constant `c`.
    pub(super) fn is_linear(&self) -> bool {
        let is_straight = |i: usize| self.wave_number[i] == 0.0 && !self.aperiodic[i];
        (0..self.slope.len()).all(is_straight) && !self.slope.iter().all(|&a| is_zero(a))
    }

    /// Applies a function to the step. If the step is constant, so is the result, and its value may
    /// serve as a factor.
    fn under(self, bent: fn(Self) -> Self, value: impl Fn(Interval) -> Interval) -> Self {
        let constant = self.is_constant().then(|| value(self.constant));
        let mut result = bent(self);
        if let Some(constant) = constant {
            result.constant = constant;
        }
        result
    }

    /// Applies an arbitrary function to `a·x + p`.
    fn bent(mut self) -> Self {
        for i in 0..self.slope.len() {
            self.aperiodic[i] |= !is_zero(self.slope[i]);
        }
        self.straightened()
    }

    /// Applies a function with the period `2π` to `a·x + p`.
    fn wave(mut self) -> Self {
        for i in 0..self.slope.len() {
            let slope = self.slope[i];
            if slope.lo() == slope.hi() {
                self.add_wave(i, slope.lo().abs());
            } else {
                self.aperiodic[i] = true;
            }
        }
        self.straightened()
    }

    fn straightened(mut self) -> Self {
        self.constant = Interval::REALS;
        self.slope.fill(Interval::point(0.0));
        self
    }

    /// Applies an arbitrary function of two variables to both steps.
    fn joined(self, other: &Self) -> Self {
        let mut both = self.bent();
        let other = other.clone().bent();
        for i in 0..both.slope.len() {
            both.aperiodic[i] |= other.aperiodic[i];
            both.add_wave(i, other.wave_number[i]);
        }
        both
    }

    fn add_wave(&mut self, i: usize, wave_number: f64) {
        let largest = self.wave_number[i].max(wave_number);
        let divisor = common_divisor(self.wave_number[i], wave_number);
        self.wave_number[i] = divisor;
        // This also holds if the divisor is not finite.
        self.aperiodic[i] |= !(largest <= LARGEST_RATIO * divisor);
    }

    fn negative(mut self) -> Self {
        self.constant = -self.constant;
        self.slope.iter_mut().for_each(|a| *a = -*a);
        self
    }

    /// `self ∘ other`.
    fn combined(mut self, how: Arithmetic, other: &Self) -> Self {
        match how {
            Arithmetic::Add => self.plus(other),
            Arithmetic::Sub => self.plus(&other.clone().negative()),
            Arithmetic::Mul if !other.is_constant() && self.is_constant() => {
                other.clone().combined(how, &self)
            }
            _ if !other.is_constant() => self.joined(other),
            _ => {
                let scaled = |a: Interval| how.of(a, other.constant);
                // 0 stays 0, whatever the factor is.
                for slope in self.slope.iter_mut().filter(|slope| !is_zero(**slope)) {
                    *slope = scaled(*slope);
                }
                self.constant = scaled(self.constant);
                self
            }
        }
    }

    fn plus(mut self, other: &Self) -> Self {
        self.constant += other.constant;
        for i in 0..self.slope.len() {
            self.slope[i] += other.slope[i];
            self.aperiodic[i] |= other.aperiodic[i];
            self.add_wave(i, other.wave_number[i]);
        }
        self
    }
}

pub(super) fn is_zero(x: Interval) -> bool {
    x.lo() == 0.0 && x.hi() == 0.0
}

/// Returns the greatest common divisor of two doubles. Both are multiples of a power of two, and
/// the remainder of two doubles is exact.
pub(super) fn common_divisor(mut a: f64, mut b: f64) -> f64 {
    while b > 0.0 {
        (a, b) = (b, a % b);
    }
    a
}

#[cfg(test)]
mod tests {
    use tautline_formula::Formula;
    use tautline_metrics::{
        Metric,
        gallery::{
            Checkerboard, CoupledCosines, GaussianFisher, Lens, RotatingAnisotropy, Shear, Valleys,
        },
    };

    use super::{Along, common_divisor};
    use crate::testing::{parsed, tables};

    fn dependence<const D: usize>(metric: &impl Metric<D>) -> [Along; D] {
        let formula = Formula::record(metric).expect("no comparison");
        super::dependence(&formula.into_any()).try_into().expect("one for each coordinate")
    }

    #[test]
    fn the_gallery_has_the_periods_of_its_formulas() {
        use Along::{Constant, Periodic, Unknown};
        assert_eq!(dependence::<3>(&Valleys), [Periodic(1.0), Constant, Constant]);
        let shear = Shear::new(0.5, 3.0).expect("a wave number");
        assert_eq!(dependence(&shear), [Constant, Periodic(3.0)]);
        assert_eq!(dependence(&CoupledCosines), [Periodic(1.0); 3]);
        assert_eq!(dependence(&GaussianFisher), [Constant, Unknown]);
        let lens = Lens::new(1.0, 1.0).expect("a width");
        assert_eq!(dependence::<2>(&lens), [Unknown; 2]);
        let board = Checkerboard::new(1.0, 2.0).expect("an edge");
        let [Periodic(k), Periodic(l)] = dependence(&board) else { panic!("not periodic") };
        // sin² has half that period, but this cannot be read off the formula.
        assert!(k == l && (k / std::f64::consts::FRAC_PI_2 - 1.0).abs() < 1e-15, "{k}");
        let anisotropy = RotatingAnisotropy::new([1.0, 4.0], [0.5, 1.5]).expect("eigenvalues");
        // The double angle gives this period.
        assert_eq!(dependence(&anisotropy), [Periodic(1.0), Periodic(3.0)]);
    }

    #[test]
    fn a_period_is_found_only_where_there_is_one() {
        use Along::{Constant, Periodic, Unknown};
        for (text, along) in [
            ("x1 - x1 + 2", Constant),
            ("sin(x1*3 - x1 + 1) + 2", Periodic(2.0)),
            ("cos(x1*4) + sin(x1*6) + 3", Periodic(2.0)),
            ("sin(cos(x1*2) + x1*4) + 3", Periodic(2.0)),
            ("cos(x1*sqrt(number(0.25))) + 3", Periodic(0.5)),
            ("exp(atan(tan(x1/0.5)))", Periodic(2.0)),
            // There is no common period, or none that is known.
            ("sin(x1) + sin(x1*sqrt(2)) + 3", Unknown),
            ("sin(x1*0.1) + sin(x1*0.3) + 3", Unknown),
            ("sin(x1/3) + 3", Unknown),
            // The function is not periodic.
            ("x1 + cos(x1)", Unknown),
            ("x1*cos(x1)", Unknown),
            ("cos(x1)/x1", Unknown),
            ("cos(sqr(x1))", Unknown),
            ("cos(x1*x1)", Unknown),
            ("sin(x1^3)", Unknown),
            ("cos(x1) + tanh(x1)", Unknown),
            ("cos(exp(x1)*2)", Unknown),
            ("sin(cos(x1)*x1)", Unknown),
            // Each case has a function inside a wave.
            ("cos(recip(x1 + 2))", Unknown),
            ("cos(sqrt(x1))", Unknown),
            ("cos(ln(x1))", Unknown),
            ("cos(atan(x1))", Unknown),
            ("cos(sinh(x1))", Unknown),
            ("cos(cosh(x1))", Unknown),
            ("cos(tanh(x1))", Unknown),
            ("cos(1/x1)", Unknown),
        ] {
            assert_eq!(dependence(&parsed::<1>(&format!("{text} I"))), [along], "{text}");
        }
    }

    /// A table depends on all of its arguments, on each as an unknown function does.
    #[test]
    fn a_table_depends_on_each_of_its_arguments() {
        use Along::{Constant, Periodic, Unknown};
        let tables = tables();
        for (text, along) in [
            ("t(x1)", [Unknown, Constant]),
            ("t(x2)", [Constant, Unknown]),
            ("h(x1, x2)", [Unknown; 2]),
            ("h(0.5, x2)", [Constant, Unknown]),
            ("h(x1, 0.5)", [Unknown, Constant]),
            ("h(sin(x1), cos(2*x2))", [Periodic(1.0), Periodic(2.0)]),
            ("h(sin(x1), x1)", [Unknown, Constant]),
            ("f(0.5, 0.5, x1)", [Unknown, Constant]),
            ("f(0.5, sin(x2), sin(3*x1))", [Periodic(3.0), Periodic(1.0)]),
            ("f_002(0.5, 0.5, x2) + h_10(0.5, x1)", [Unknown; 2]),
        ] {
            let formula = Formula::<2>::parse_with(&format!("{text} I"), &[], &tables);
            assert_eq!(dependence(&formula.expect(text)), along, "{text}");
        }
    }

    #[test]
    fn common_divisors_are_exact() {
        assert_eq!(common_divisor(6.0, 4.0), 2.0);
        assert_eq!(common_divisor(0.0, 0.75), 0.75);
        assert_eq!(common_divisor(0.75, 0.0), 0.75);
        assert_eq!(common_divisor(0.75, 0.5), 0.25);
    }
}
