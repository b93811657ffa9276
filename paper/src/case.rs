//! `Case`: a metric, two sets and the distance between them.

use std::{
    num::NonZeroUsize,
    rc::Rc,
    sync::{Mutex, PoisonError},
};

use tautline::{
    Bounded, Ends, KnownDistance, Problem, Rule, SVector,
    bounds::{
        Computed, DiscreteMinimum, Enclosure, Setting, enclose, theorem_1_1_constant,
        theorem_1_3_constant,
    },
    distance::Ended,
};
pub(crate) use tautline_statements::PaperRule;
use tautline_statements::{
    Evidence, Finding, Known, LIBRARY, Reconstruction, lemma_s_2, lemma_s_4, prop_7_9, prop_s_6,
    theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4, theorem_a, theorem_b, theorem_c, theorem_d,
};

use crate::{Failure, observation::Observation};

/// The source of `d²`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A closed form, or a quadrature accurate to rounding, with a proof of minimality.
    Exact,
    /// The middle of an interval that a certificate proves.
    Proved,
    /// An estimate by Richardson extrapolation.
    Extrapolated,
}

impl Reference {
    /// Returns the name in the data files.
    pub fn name(self) -> &'static str {
        match self {
            Reference::Exact => "exact",
            Reference::Proved => "proved",
            Reference::Extrapolated => "extrapolated",
        }
    }
}

/// A problem whose distance is known.
pub(crate) struct Case {
    /// The name in the data files.
    pub(crate) name: &'static str,
    /// The square of the distance, in `m²`.
    pub(crate) distance_squared: f64,
    /// The source of this value.
    pub(crate) reference: Reference,
    /// How far it may be off, in `m²`.
    error: f64,
    /// The data from which the bounds are computed.
    pub(crate) setting: Setting,
    /// The orders in `1/N` of `E_N − d²` for both rules; see [`Orders`].
    pub(crate) orders: Orders,
    solve: Solve,
    gaps: Gaps,
}

/// The orders in `1/N` of `E_tra,N − d²` and of `E_l,N − d²`, if they can be observed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Orders {
    /// The general case: 2 and 1.
    General,
    /// 2 for the trapezoidal rule. The first-order coefficient of the left rule,
    /// `∫ DH[γ̇](γ̇, γ̇) dt`, vanishes by symmetry, or the second order hides it on these grids.
    LeftHidden,
    /// No order: the discrete energies attain `d²` exactly.
    Exact,
}

impl Orders {
    /// Returns the order for a rule, or `None` if there is none to observe.
    pub(crate) fn of(self, rule: PaperRule) -> Option<f64> {
        match (self, rule) {
            (Orders::Exact, _) | (Orders::LeftHidden, PaperRule::LeftEndpoint) => None,
            (_, PaperRule::Trapezoidal) => Some(2.0),
            (Orders::General, PaperRule::LeftEndpoint) => Some(1.0),
        }
    }
}

type Solve = Box<dyn Fn(PaperRule, usize) -> Result<Observation, Failure>>;
type Gaps = Box<dyn Fn(usize) -> Result<[Evidence; 2], Failure>>;

impl Case {
    /// Minimises the discrete energy of `rule` with `n` subintervals. On the result it checks
    /// Theorems 1.1 and 1.2, or 1.3 and 1.4, and the sharper theorems. It fails if the solver does
    /// not converge to a local minimum, or if a hypothesis or an inequality is violated.
    pub(crate) fn solve(&self, rule: PaperRule, n: usize) -> Result<Observation, Failure> {
        (self.solve)(rule, n).map_err(|reason| {
            let (case, rule) = (self.name, rule.name());
            Failure::Violated(format!("{case}, {rule}, N = {n}: {reason}"))
        })
    }

    /// Returns whether a difference from `d²`, in `m²`, is known to a tenth.
    pub(crate) fn resolves(&self, difference: f64) -> bool {
        10.0 * self.error <= difference.abs() || self.reference == Reference::Exact
    }

    /// Minimises the trapezoidal energy with `n` subintervals. On the result it evaluates
    /// Proposition 7.9 and Lemma S.2, which bound the gap between the energy of the curve and the
    /// discrete energy. It fails for the same reasons as [`solve`](Case::solve).
    pub(crate) fn gaps(&self, n: usize) -> Result<[Evidence; 2], Failure> {
        (self.gaps)(n)
    }

    /// Encloses `d²` by one observed minimiser, which is taken for a global one, without using the
    /// known distance (Proposition S.6).
    pub(crate) fn enclose(
        &self,
        rule: PaperRule,
        seen: &Observation,
    ) -> Result<Enclosure, Failure> {
        let computed = Computed {
            rule,
            n: subintervals(seen.n)?,
            discrete_energy: seen.discrete_energy,
            energy: seen.energy.value,
            length_squared: seen.length_squared.value,
            minimum: DiscreteMinimum::Assumed,
            gap: 0.0,
        };
        Ok(enclose(self.setting.constants(), self.setting.dimension(), &computed)?)
    }

    pub(crate) fn new<M, const D: usize>(
        name: &'static str,
        metric: M,
        ends: Ends<D>,
        distance: Option<f64>,
        orders: Orders,
    ) -> Result<Case, Failure>
    where
        M: Bounded<D> + Clone + 'static,
    {
        let (d2, error, reference) = match distance {
            // A closed form has a dozen roundings of numbers up to 30.
            Some(d) => (d * d, 2.0 * d * 1e-13, Reference::Exact),
            None => {
                let bounds = proved_distance(name, &metric, &ends)?;
                let [least, most] = bounds.map(|d| d * d);
                (0.5 * (least + most), 0.5 * (most - least), Reference::Proved)
            }
        };
        let distance = d2.sqrt();
        let known = Known { metric, ends, distance, distance_error: 0.5 * error / distance };
        let setting = known.setting()?;
        let known = Rc::new(known);
        let shared = Rc::clone(&known);
        let solve = Box::new(move |rule, n| observe(&known, rule, n));
        let gaps = Box::new(move |n| gaps(&shared, n));
        Ok(Case { name, distance_squared: d2, reference, error, setting, orders, solve, gaps })
    }

    /// Returns a case between two points whose distance the metric knows.
    pub(crate) fn between<M, const D: usize>(
        name: &'static str,
        metric: M,
        [a, b]: [[f64; D]; 2],
        orders: Orders,
    ) -> Result<Case, Failure>
    where
        M: Bounded<D> + KnownDistance<D> + Clone + 'static,
    {
        let distance = metric.distance(&SVector::from(a), &SVector::from(b));
        let distance = Some(distance.ok_or(Failure::NoReference(name))?);
        Case::new(name, metric, Ends::points(a, b)?, distance, orders)
    }
}

/// The gap of the certificates, relative to the distance: some seconds each.
const GAP: f64 = 5e-7;

/// Returns two bounds on a distance that a certificate proves. Several figures have the same cases,
/// and each is proved once.
fn proved_distance<M: Bounded<D> + Clone, const D: usize>(
    name: &'static str,
    metric: &M,
    ends: &Ends<D>,
) -> Result<[f64; 2], Failure> {
    static PROVED: Mutex<Vec<(&str, [f64; 2])>> = Mutex::new(Vec::new());
    let mut proved = PROVED.lock().unwrap_or_else(PoisonError::into_inner);
    if let Some(&(_, bounds)) = proved.iter().find(|(known, _)| *known == name) {
        return Ok(bounds);
    }
    let line = Problem::new(metric.clone(), ends.clone()).solve(Rule::TRAPEZOIDAL, 1024)?;
    let no_reference = || Failure::NoReference(name);
    let found = line.certificate(GAP).map_err(|_| no_reference())?;
    let bounds = [found.proved.lower, found.proved.upper.ok_or_else(no_reference)?];
    if found.ended != Ended::Reached {
        return Err(no_reference());
    }
    proved.push((name, bounds));
    Ok(bounds)
}

fn observe<M: Bounded<D>, const D: usize>(
    known: &Known<M, D>,
    rule: PaperRule,
    n: usize,
) -> Result<Observation, Failure> {
    let seen = Reconstruction::observe(&LIBRARY, known, rule, n)?;
    let of_the_paper = match rule {
        PaperRule::Trapezoidal => [theorem_1_1(&LIBRARY, &seen), theorem_1_2(&LIBRARY, &seen)],
        PaperRule::LeftEndpoint => [theorem_1_3(&LIBRARY, &seen), theorem_1_4(&LIBRARY, &seen)],
    };
    let first_order =
        [lemma_s_4(&LIBRARY, &seen), theorem_a(&LIBRARY, &seen), theorem_c(&LIBRARY, &seen)];
    let second_order = [theorem_b(&LIBRARY, &seen), theorem_d(&LIBRARY, &seen)];
    let enclosure = prop_s_6(&LIBRARY, &seen, 0.0)?;
    let sharper: Vec<Evidence> =
        first_order.into_iter().chain(second_order.into_iter().flatten()).collect();
    of_the_paper.iter().chain(&sharper).chain([&enclosure]).try_for_each(holds)?;
    let minimum = &seen.minimum;
    Ok(Observation {
        n,
        discrete_energy: seen.discrete_energy,
        energy: seen.energy,
        length_squared: seen.length_squared,
        decrement: minimum.decrement,
        residual: minimum.residual,
        residual_floor: minimum.residual_floor,
        curvature: minimum.curvature,
    })
}

fn gaps<M: Bounded<D>, const D: usize>(
    known: &Known<M, D>,
    n: usize,
) -> Result<[Evidence; 2], Failure> {
    let seen = Reconstruction::observe(&LIBRARY, known, PaperRule::Trapezoidal, n)?;
    let sequence = &seen.minimum.sequence;
    let gaps = [
        prop_7_9(&LIBRARY, &known.metric, sequence)?,
        lemma_s_2(&LIBRARY, &known.metric, sequence)?,
    ];
    gaps.iter().try_for_each(holds)?;
    Ok(gaps)
}

fn holds(evidence: &Evidence) -> Result<(), Failure> {
    let statement = evidence.statement;
    match evidence.finding() {
        Finding::Holds => Ok(()),
        Finding::Inapplicable(clause) => {
            Err(Failure::Violated(format!("{statement} does not apply: {clause}")))
        }
        Finding::Violated(claim) => {
            Err(Failure::Violated(format!("{statement} is violated: {claim}")))
        }
    }
}

/// Returns `C/√N`, in `m²`, with the constant `C` of Theorem 1.1, or of Theorem 1.3 for the
/// left-endpoint rule.
///
/// It bounds `E(γᵖˡ) − d²` by the proofs of these theorems, and `L(γᵖˡ)² − d²` by Theorems 1.2 and
/// 1.4.
pub(crate) fn paper_bound(setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
    let constant = match rule {
        PaperRule::Trapezoidal => theorem_1_1_constant(setting),
        PaperRule::LeftEndpoint => theorem_1_3_constant(setting),
    };
    constant / (n.get() as f64).sqrt()
}

/// Returns `N ≥ 1` in the type that the bounds take.
pub(crate) fn subintervals(n: usize) -> Result<NonZeroUsize, Failure> {
    NonZeroUsize::new(n).ok_or_else(|| Failure::Data("N = 0".to_owned()))
}
