//! `Lift`: a formula whose linear forms are independent variables, so that a compact set of their
//! values represents all of space.

#[cfg(test)]
mod tests;

use nalgebra::{DMatrix, DVector};
use num_traits::Zero;
use tautline_formula::{Formula, Function, Operation, Step};
use tautline_scalar::{ANY, Interval, Scalar};

use super::{
    dependence::{Dependence, coordinates, steps},
    form::{Form, Place, ratio},
    hill::Hill,
    wall::Wall,
};
use crate::patch::{Patch, Point, Region};

/// The largest number of variables. With more, a search is hopeless.
const VARIABLES: usize = 8;

/// The largest number of forms with both waves and tails, each of which has three charts.
const MIXED: usize = 3;

/// A formula as a function of the linear forms `y = a·x` in it, with all of `R^D` as a compact set.
///
/// Functions of one form are of two kinds. A *wave*, `sin`, `cos` or `tan` of `α y + β`, needs only
/// the phase of `y` on a circle. All others have *tails*: they need `y` on the whole line, whose two
/// ends are half-lines `[K, ∞]`, on which `tanh`, `arctan`, the wall `1/(d + f e^z)` and the hill
/// `e^(−q)` have finite enclosures. Derivatives with respect to `x` follow from the chain rule.
///
/// A form with waves and tails has three charts. In the first, `|y| ≤ K` and the phase is that of
/// `y`. In the other two, `y` lies beyond `K` on one side, and the phase is a variable of its own.
///
/// Every `x` has variables at which the lifted formula equals `H(x)`, together with all derivatives.
/// The converse holds up to closure if the forms, and the wave numbers of each form, are linearly
/// independent; otherwise the lifted formula has more values than `H`.
#[derive(Clone, Debug)]
pub(crate) struct Lift {
    pub(crate) formula: Formula<ANY>,
    /// How each step is evaluated.
    pub(crate) roles: Vec<Role>,
    pub(crate) forms: Vec<Form>,
    pub(crate) hills: Vec<Hill>,
    /// The charts: for each form, where it is.
    charts: Vec<Vec<Place>>,
    variables: usize,
    /// The coordinates that are 0, since the constants do not depend on them.
    still: Vec<bool>,
}

/// How a step is evaluated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Role {
    /// By its operation.
    Plain,
    /// It is linear. If another step reads it, it has a form `y` and a multiple `α`, and is
    /// `α y + β`.
    Linear(Option<(usize, Interval)>),
    /// It is a wave of this linear step, with the phase `multiple · θ + β`.
    Wave { step: Step, form: usize, phase: usize, multiple: f64 },
    /// It is a wall with a linear step `z`.
    Wall(Wall),
    /// It is the hill with this index.
    Hill(usize),
}

impl Lift {
    /// Returns the lifted formula, with the `still` coordinates set to 0; `None` if it has too many
    /// forms, variables or charts.
    pub(crate) fn new(formula: &Formula<ANY>, still: Vec<bool>) -> Option<Self> {
        let depends = steps(formula, &coordinates(formula.dimension()));
        let role = |(place, step): (usize, &Dependence)| match Wall::at(formula, place) {
            _ if step.is_linear() => Role::Linear(None),
            Some(wall) if depends[wall.z as usize].is_linear() => Role::Wall(wall),
            _ => Role::Plain,
        };
        let mut lift = Self {
            formula: formula.clone(),
            roles: depends.iter().enumerate().map(role).collect(),
            forms: Vec::new(),
            hills: Vec::new(),
            charts: vec![Vec::new()],
            variables: 0,
            still,
        };
        // The values of linear steps at x = 0 are their constants.
        let origin = formula.values_at(&vec![Interval::zero(); formula.dimension()]);
        lift.find_waves_and_tails(&depends, &origin)?;
        lift.find_hills(&origin);
        lift.number_variables()?;
        Some(lift)
    }

    /// Finds the forms of those linear steps that other steps read, and notes which have waves and
    /// which have tails. Returns `None` if there are too many.
    fn find_waves_and_tails(&mut self, depends: &[Dependence], origin: &[Interval]) -> Option<()> {
        let formula = self.formula.clone();
        let mut waves = Vec::new();
        for (place, operation) in formula.operations().iter().enumerate() {
            let function = formula.function(place);
            let read = match (self.roles[place], *operation) {
                (Role::Linear(_), _) => continue,
                (Role::Wall(Wall { numerator, z, .. }), _) => [numerator, Some(z), None],
                (_, Operation::Binary(_, a, b)) => [Some(a), Some(b), None],
                (_, Operation::WithNumber(_, a, _) | Operation::Powi(a, _)) => {
                    [Some(a), None, None]
                }
                (_, Operation::Table(call)) => {
                    let argument = |axis: usize| call.arguments().get(axis).copied();
                    [argument(0), argument(1), argument(2)]
                }
                _ => [function.map(|(_, a)| a), None, None],
            };
            for step in read.into_iter().flatten() {
                let Some((form, scale)) = self.form(&depends[step as usize], step)? else {
                    continue;
                };
                if let Some((Function::Sin | Function::Cos | Function::Tan, _)) = function {
                    waves.push((place, step, form, self.forms[form].add_wave(step, scale)));
                } else {
                    self.forms[form].add_tail(scale, origin[step as usize]);
                }
            }
        }
        for (i, j) in (0..formula.dimension()).flat_map(|j| (0..=j).map(move |i| (i, j))) {
            let entry = formula.entry(i, j);
            if let Some((form, scale)) = self.form(&depends[entry as usize], entry)? {
                self.forms[form].add_tail(scale, origin[entry as usize]);
            }
        }
        let shared = self.forms.iter_mut().map(|form| form.share_phases(VARIABLES));
        let shared: Vec<_> = shared.collect::<Option<_>>()?;
        for (place, step, form, wave) in waves {
            let (phase, multiple) = shared[form][wave];
            self.roles[place] = Role::Wave { step, form, phase, multiple };
        }
        Some(())
    }

    /// Returns the form of a step and its multiple, or `Some(None)` if the step is not linear;
    /// `None` if there are too many forms.
    fn form(&mut self, depends: &Dependence, step: Step) -> Option<Option<(usize, Interval)>> {
        let Role::Linear(known) = self.roles[step as usize] else { return Some(None) };
        if known.is_some() {
            return Some(known);
        }
        let slope = &depends.slope;
        let mut forms = self.forms.iter().enumerate();
        let found = forms.find_map(|(form, it)| Some((form, ratio(slope, &it.direction)?)));
        let (form, scale) = found.unwrap_or_else(|| {
            let (form, scale) = Form::of(slope, &self.still);
            self.forms.push(form);
            (self.forms.len() - 1, scale)
        });
        self.roles[step as usize] = Role::Linear(Some((form, scale)));
        let moving = self.forms.iter().filter(|form| !form.is_still).count();
        (moving <= VARIABLES).then_some(Some((form, scale)))
    }

    fn find_hills(&mut self, origin: &[Interval]) {
        // From each step to the next: a recursion would need as much stack as the formula has steps.
        let mut parabolas: Vec<Option<Hill>> = Vec::with_capacity(self.roles.len());
        for place in 0..self.roles.len() {
            let parabola = Hill::parabola(self, origin, &parabolas, place);
            parabolas.push(parabola);
            let Some((Function::Exp, exponent)) = self.formula.function(place) else { continue };
            let Some(hill) = parabolas[exponent as usize].clone() else { continue };
            if !hill.is_concave() {
                continue;
            }
            for term in &hill.terms {
                let form = &mut self.forms[term.form];
                form.reach = form.reach.max(term.reach());
            }
            self.roles[place] = Role::Hill(self.hills.len());
            self.hills.push(hill);
        }
    }

    /// Numbers the variables and lists the charts; `None` if there are too many.
    fn number_variables(&mut self) -> Option<()> {
        for form in self.forms.iter_mut().filter(|form| !form.is_still) {
            let mut next = || {
                self.variables += 1;
                self.variables - 1
            };
            form.variable = form.has_tails.then(&mut next);
            form.phases.iter_mut().for_each(|phase| phase.variable = next());
        }
        let mixed = || self.forms.iter().filter(|form| form.is_mixed());
        let reach = mixed().all(|form| form.reach.is_finite());
        if self.variables > VARIABLES || mixed().count() > MIXED || !reach {
            return None;
        }
        for form in &self.forms {
            let places: &[Place] = match form.is_mixed() {
                false => &[Place::Anywhere],
                true => &[Place::Near, Place::Far(-1.0), Place::Far(1.0)],
            };
            let charts = std::mem::take(&mut self.charts);
            let with = |chart: Vec<Place>| {
                places.iter().map(move |&place| [chart.clone(), vec![place]].concat())
            };
            self.charts = charts.into_iter().flat_map(with).collect();
        }
        Some(())
    }

    /// Returns where a form is in a chart.
    pub(crate) fn place(&self, chart: usize, form: usize) -> Place {
        self.charts[chart][form]
    }

    /// Returns whether the forms are linearly independent, up to rounding, and no two phases of a
    /// form resonate.
    pub(crate) fn is_sharp(&self) -> bool {
        let moving: Vec<_> = self.forms.iter().filter(|form| form.moves()).collect();
        let rows = DMatrix::from_fn(moving.len(), self.still.len(), |row, i| {
            if self.still[i] { 0.0 } else { moving[row].direction[i].midpoint() }
        });
        // A matrix without rows has no decomposition.
        let is_free = moving.iter().all(|form| form.has_free_phases());
        moving.is_empty()
            || (is_free
                && moving.len() <= self.still.len()
                && rows.rank(1e-9 * rows.amax()) == moving.len())
    }

    /// Returns points of space, in `ℓ`, at which the forms have about the values of `point`. Phases
    /// are met as far as one value of their form meets them. If there are more forms than
    /// coordinates, each point is the best fit for as many forms as there are coordinates.
    pub(crate) fn in_space(&self, point: &Point) -> Vec<Vec<f64>> {
        let d = self.still.len();
        // The other forms are 0, or are only parts of forms.
        let moving: Vec<_> = (0..self.forms.len()).filter(|&k| self.forms[k].moves()).collect();
        if moving.is_empty() {
            return vec![vec![0.0; d]];
        }
        let subsets = (0..1_u32 << moving.len())
            .filter(|subset| subset.count_ones() as usize == moving.len().min(d));
        let fit = |subset: u32| {
            let chosen = (0..moving.len()).filter(|row| subset >> row & 1 == 1);
            let chosen: Vec<_> = chosen.map(|row| moving[row]).collect();
            let rows = DMatrix::from_fn(chosen.len(), d, |row, i| {
                if self.still[i] { 0.0 } else { self.forms[chosen[row]].direction[i].midpoint() }
            });
            let value = |k: &usize| self.forms[*k].value(self.place(point.chart, *k), point);
            let wanted = DVector::from_iterator(chosen.len(), chosen.iter().map(value));
            let x = rows.svd(true, true).solve(&wanted, 1e-12).ok()?;
            // What overflows is no point of space.
            x.iter().all(|x| x.is_finite()).then(|| x.as_slice().to_vec())
        };
        subsets.filter_map(fit).collect()
    }
}

impl Region for Lift {
    fn patches(&self) -> Vec<Patch> {
        // 2π is enclosed as 8 arctan 1.
        let circle = Interval::zero().hull(Interval::point(1.0).atan() * 8.0);
        let patch = |chart: usize| {
            let mut sides = vec![Interval::zero(); self.variables];
            for (form, place) in self.forms.iter().zip(&self.charts[chart]) {
                if let Some(variable) = form.variable {
                    sides[variable] = place.side(form.reach);
                }
                for phase in form.phases.iter().filter(|_| !form.is_still) {
                    // Near the origin it is not used.
                    sides[phase.variable] =
                        if *place == Place::Near { Interval::zero() } else { circle };
                }
            }
            Patch { sides, chart }
        };
        (0..self.charts.len()).map(patch).collect()
    }

    fn misses(&self, _: &Patch) -> bool {
        false
    }

    fn point_in(&self, patch: &Patch) -> Option<Point> {
        Some(patch.middle())
    }
}
