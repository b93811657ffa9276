//! `Form`: a linear form in a formula, with the phases of its waves.

use tautline_formula::Step;
use tautline_scalar::Interval;

use super::dependence::{LARGEST_RATIO, common_divisor, is_zero};
use crate::patch::Point;

/// A linear form `a·x`.
#[derive(Clone, Debug)]
pub(crate) struct Form<const D: usize> {
    pub(crate) direction: [Interval; D],
    /// The variable with its value, if it has tails and is not 0 on the search.
    pub(crate) variable: Option<usize>,
    pub(crate) phases: Vec<Phase>,
    /// Whether it is 0 on the search, since it depends only on coordinates that are.
    pub(crate) is_still: bool,
    pub(super) has_tails: bool,
    /// Beyond this `K`, in the unit of the form, its tails are nearly flat.
    pub(super) reach: f64,
}

/// A phase of a form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// `θ` is this number times the form, in radians per unit of the form.
    pub(super) wave_number: Interval,
    /// The only linear step with this phase, if its wave number is not a double.
    of: Option<Step>,
    pub(crate) variable: usize,
}

/// Where a form is, in a chart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Place {
    /// Anywhere; it has no waves, or no tails.
    Anywhere,
    /// Within its reach, where its value gives its phase.
    Near,
    /// Beyond its reach, with this sign.
    Far(f64),
}

impl<const D: usize> Form<D> {
    /// Returns the form of a linear step with this slope, and the ratio of the slope to that of the
    /// form: the form of a step in one coordinate is that coordinate.
    pub(super) fn of(slope: [Interval; D], still: &[bool; D]) -> (Self, Interval) {
        let supported: Vec<_> = (0..D).filter(|&i| !is_zero(slope[i])).collect();
        let (mut direction, mut scale) = (slope, Interval::point(1.0));
        if let [i] = supported[..] {
            (direction[i], scale) = (Interval::point(1.0), slope[i]);
        }
        let form = Self {
            direction,
            variable: None,
            phases: Vec::new(),
            is_still: supported.iter().all(|&i| still[i]),
            has_tails: false,
            reach: 0.0,
        };
        (form, scale)
    }

    /// Returns whether it has a variable.
    pub(super) fn moves(&self) -> bool {
        !self.is_still && (self.has_tails || !self.phases.is_empty())
    }

    pub(super) fn is_mixed(&self) -> bool {
        !self.is_still && self.has_tails && !self.phases.is_empty()
    }

    /// Adds a tail: a function of `scale · y + β`.
    pub(super) fn add_tail(&mut self, scale: Interval, constant: Interval) {
        self.has_tails = true;
        // Where the argument of a function is 16, tanh differs from 1 by 3e-14.
        self.reach = self.reach.max((16.0 + constant.magnitude()) / scale.mignitude());
    }

    /// Adds a wave of `scale` times the form. Waves whose numbers have a common divisor share a
    /// phase.
    pub(super) fn add_wave(&mut self, step: Step, scale: Interval) {
        let size = scale.lo().abs();
        if scale.lo() != scale.hi() {
            self.phases.push(Phase { wave_number: scale, of: Some(step), variable: 0 });
            return;
        }
        for phase in self.phases.iter_mut().filter(|phase| phase.of.is_none()) {
            let divisor = common_divisor(phase.wave_number.lo(), size);
            if phase.wave_number.lo().max(size) <= LARGEST_RATIO * divisor {
                phase.wave_number = Interval::point(divisor);
                return;
            }
        }
        self.phases.push(Phase { wave_number: Interval::point(size), of: None, variable: 0 });
    }

    /// Returns a value of the form that agrees with a point of the search.
    pub(super) fn value(&self, place: Place, point: &Point) -> f64 {
        let at = |variable: usize| point.at[variable];
        let value = self.variable.map_or(0.0, at);
        let [first, others @ ..] = &self.phases[..] else { return value };
        let sign = match place {
            Place::Near => return value,
            Place::Anywhere => 1.0,
            Place::Far(sign) => sign,
        };
        let (angle, wave_number) = (at(first.variable), first.wave_number.midpoint());
        let turn = std::f64::consts::TAU;
        let turns = sign * ((value * wave_number - angle) / turn * sign).ceil();
        let candidate = |k: u32| (angle + turn * (turns + sign * f64::from(k))) / wave_number;
        let miss = |value: f64| -> f64 {
            let off = |phase: &Phase| value * phase.wave_number.midpoint() - at(phase.variable);
            others.iter().map(|phase| 1.0 - off(phase).cos()).sum()
        };
        let candidates = (0..if others.is_empty() { 1 } else { TURNS }).map(candidate);
        candidates.min_by(|a, b| miss(*a).total_cmp(&miss(*b))).unwrap_or(value)
    }
}

/// The number of periods that are tried to meet several phases at once.
const TURNS: u32 = 4096;

impl Phase {
    /// Returns `m` such that a wave of `scale` times the form has the phase `m θ`; `None` if it has
    /// another phase.
    pub(super) fn multiple(&self, step: Step, scale: Interval) -> Option<f64> {
        if self.of.is_some() {
            return (self.of == Some(step)).then_some(1.0);
        }
        let multiple = scale.lo() / self.wave_number.lo();
        let is_multiple = scale.lo() == scale.hi()
            && multiple.abs() <= LARGEST_RATIO
            && multiple.fract() == 0.0
            && multiple * self.wave_number.lo() == scale.lo();
        is_multiple.then_some(multiple)
    }
}

impl Place {
    /// Returns the values of a form with this reach.
    pub(super) fn side(self, reach: f64) -> Interval {
        let ends = match self {
            Place::Anywhere => (f64::NEG_INFINITY, f64::INFINITY),
            Place::Near => (-reach, reach),
            Place::Far(sign) if sign < 0.0 => (f64::NEG_INFINITY, -reach),
            Place::Far(_) => (reach, f64::INFINITY),
        };
        Interval::new(ends.0, ends.1).unwrap_or(Interval::REALS)
    }
}

/// Returns `a / b` if the vectors are exactly parallel and `b` is not 0.
pub(super) fn ratio<const D: usize>(a: &[Interval; D], b: &[Interval; D]) -> Option<Interval> {
    let supported: Vec<_> = (0..D).filter(|&i| !is_zero(b[i])).collect();
    if (0..D).any(|i| is_zero(a[i]) != is_zero(b[i])) {
        return None;
    }
    if let [i] = supported[..] {
        // The direction of a form in one coordinate is that of its axis.
        return Some(a[i]);
    }
    let is_point = |x: &Interval| x.lo() == x.hi();
    if !a.iter().chain(b).all(is_point) {
        return None;
    }
    let ratio = a[supported[0]].lo() / b[supported[0]].lo();
    let is_exact = |i: &usize| {
        let (a, b) = (a[*i].lo(), b[*i].lo());
        // Where nothing underflows, the error of a product is a double.
        (ratio * b).abs() > 1e-250 && ratio.mul_add(b, -a) == 0.0
    };
    supported.iter().all(is_exact).then(|| Interval::point(ratio))
}
