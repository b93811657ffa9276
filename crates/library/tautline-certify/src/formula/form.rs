//! `Form`: a linear form in a formula, with the phases of its waves.

use tautline_formula::Step;
use tautline_scalar::Interval;

use super::{
    dependence::is_zero,
    harmonics::{Read, may_resonate, shared},
};
use crate::patch::Point;

/// A linear form `a·x`.
#[derive(Clone, Debug)]
pub(crate) struct Form {
    pub(crate) direction: Vec<Interval>,
    /// The variable with its value, if it has tails and is not 0 on the search.
    pub(crate) variable: Option<usize>,
    pub(crate) phases: Vec<Phase>,
    /// Whether it is 0 on the search, since it depends only on coordinates that are.
    pub(crate) is_still: bool,
    pub(super) has_tails: bool,
    /// Beyond this `K`, in the unit of the form, its tails are nearly flat.
    pub(super) reach: f64,
    /// What its waves read.
    waves: Vec<Read>,
}

/// A phase of a form.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Phase {
    /// `θ` is this number times the form, in radians per unit of the form.
    pub(super) wave_number: Interval,
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

impl Form {
    /// Returns the form of a linear step with this slope, and the ratio of the slope to that of the
    /// form: the form of a step in one coordinate is that coordinate.
    pub(super) fn of(slope: &[Interval], still: &[bool]) -> (Self, Interval) {
        let supported: Vec<_> = (0..slope.len()).filter(|&i| !is_zero(slope[i])).collect();
        let (mut direction, mut scale) = (slope.to_vec(), Interval::point(1.0));
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
            waves: Vec::new(),
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

    /// Adds a wave of `scale` times the form, which `step` is up to a constant. Returns its number.
    pub(super) fn add_wave(&mut self, step: Step, scale: Interval) -> usize {
        self.waves.push((step, scale));
        self.waves.len() - 1
    }

    /// Makes the phases, when all waves are known. Returns the phase of each wave, and which
    /// multiple of it the wave reads; `None` if there are more than `most` phases.
    pub(super) fn share_phases(&mut self, most: usize) -> Option<Vec<(usize, f64)>> {
        let shared = shared(&self.waves, most)?;
        let phase = |&wave_number: &Interval| Phase { wave_number, variable: 0 };
        self.phases = shared.wave_numbers.iter().map(phase).collect();
        Some(shared.waves)
    }

    /// Returns whether no two phases depend on each other noticeably.
    pub(super) fn has_free_phases(&self) -> bool {
        let pairs = (0..self.phases.len()).flat_map(|j| (0..j).map(move |i| (i, j)));
        let wave_number = |k: usize| self.phases[k].wave_number;
        pairs.into_iter().all(|(i, j)| !may_resonate(wave_number(i), wave_number(j)))
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
        // For the smallest wave numbers, a value may overflow.
        let candidates = candidates.filter(|value| value.is_finite());
        candidates.min_by(|a, b| miss(*a).total_cmp(&miss(*b))).unwrap_or(value)
    }
}

/// The number of periods that are tried to meet several phases at once.
const TURNS: u32 = 4096;

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
pub(super) fn ratio(a: &[Interval], b: &[Interval]) -> Option<Interval> {
    let supported: Vec<_> = (0..b.len()).filter(|&i| !is_zero(b[i])).collect();
    if (0..b.len()).any(|i| is_zero(a[i]) != is_zero(b[i])) {
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
        // A fused multiply-add is rounded once, so it is 0 only if `ratio · b − a` is, or if that
        // underflows. It is a multiple of the product of the last places of the factors, which is at
        // least 2⁻¹⁰⁶ of their product. An overflow is not 0.
        (ratio * b).abs() > 1e-250 && ratio.mul_add(b, -a) == 0.0
    };
    supported.iter().all(is_exact).then(|| Interval::point(ratio))
}
