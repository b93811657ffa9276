//! `Reconstruction`: a computed discrete minimiser and the numbers observed on it.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use tautline::{
    Bounded, Curvature, Integral, Metric, Minimum, PointSequence, Stop,
    bounds::{PaperRule, Setting},
};

use crate::{AnyBounded, GramRange, Known, Subject, VerifyError, curvature_along};

/// Returns the discrete energy of a sequence by a rule of the paper, in `m²`.
pub fn discrete_energy<const D: usize>(
    subject: &Subject,
    rule: PaperRule,
    metric: &impl Metric<D>,
    sequence: &PointSequence<D>,
) -> f64 {
    subject.discrete_energy(rule.into(), metric, sequence)
}

/// The result of one solve: the numbers that Theorems 1.1 to 1.4 and Sections 6 to 9 need.
#[derive(Clone, Debug)]
pub struct Reconstruction<const D: usize> {
    /// The rule of the minimised discrete energy.
    pub rule: PaperRule,
    /// Constants, distance and dimension.
    pub setting: Setting,
    /// The number of subintervals.
    pub n: NonZeroUsize,
    /// `min E = min L² = d²`, in `m²`.
    pub distance_squared: f64,
    /// The discrete energy of the sequence, in `m²`.
    pub discrete_energy: f64,
    /// The energy `E(γᵖˡ)` of the curve, in `m²`.
    pub energy: Integral,
    /// The squared length `L(γᵖˡ)²` of the curve, in `m²`.
    pub length_squared: Integral,
    /// The root mean square `K₃` of the differences, in `ℓ`.
    pub k3: f64,
    /// The mean of the cubes of the differences, `(1/N) Σ |βₙ|³`, in `ℓ³`.
    pub mean_cube: f64,
    /// The speeds `qₙ` of the chords as the rule measures them, in `m`.
    pub speeds: Vec<f64>,
    /// The greatest `|uᵀ D²H[w, w] u|` found along the chords, for unit vectors `u` and `w`, in
    /// `m²/ℓ⁴`.
    pub curvature: f64,
    /// The range of the metric over the points and the midpoints of the chords.
    pub gram: GramRange,
    /// The larger of the distances of the two ends from their sets, in `ℓ`.
    pub off_sets: f64,
    /// The sequence, and how the solver found it.
    pub minimum: Minimum<D>,
    /// The allowance for rounding, for the quadratures and for the error of `d²`, in `m²`.
    pub granted: f64,
}

impl<const D: usize> Reconstruction<D> {
    /// Minimises the discrete energy of `rule` with `n` subintervals.
    ///
    /// # Errors
    ///
    /// If the solver refuses the problem, or does not converge to a local minimum.
    pub fn observe<M: Bounded<D>>(
        subject: &Subject,
        known: &Known<M, D>,
        rule: PaperRule,
        n: usize,
    ) -> Result<Self, VerifyError> {
        let known = &known.behind_a_pointer();
        let (metric, ends) = (&known.metric, &known.ends);
        let minimum = subject.minimise(rule.into(), metric, ends, n)?;
        // A degenerate Hessian is allowed: a curve that leaves a ball may be free to move sideways.
        let saddle = matches!(minimum.curvature, Curvature::Indefinite { .. });
        if !matches!(minimum.stop, Stop::Converged | Stop::EndsTouch) || saddle {
            let (stop, curvature) = (minimum.stop, minimum.curvature);
            return Err(VerifyError::NotConverged { n, stop, curvature });
        }
        Self::behind_a_pointer(subject, known, rule, minimum)
    }

    /// Observes a given sequence, for instance one that is not a global minimiser.
    ///
    /// # Errors
    ///
    /// [`VerifyError::Metric`] where `H` is not finite, symmetric and positive definite.
    pub fn read<M: Bounded<D>>(
        subject: &Subject,
        known: &Known<M, D>,
        rule: PaperRule,
        minimum: Minimum<D>,
    ) -> Result<Self, VerifyError> {
        Self::behind_a_pointer(subject, &known.behind_a_pointer(), rule, minimum)
    }

    fn behind_a_pointer(
        subject: &Subject,
        known: &Known<AnyBounded<'_, D>, D>,
        rule: PaperRule,
        minimum: Minimum<D>,
    ) -> Result<Self, VerifyError> {
        let (metric, sequence) = (&known.metric, &minimum.sequence);
        let discrete_energy = discrete_energy(subject, rule, metric, sequence);
        let speeds = subject.discrete_speeds(rule.into(), metric, sequence);
        let energy = subject.curve_energy(metric, sequence);
        let length = subject.curve_length(metric, sequence);
        let length_squared =
            Integral { value: length.value.powi(2), error: 2.0 * length.value * length.error };
        let setting = Setting::new(subject.constants(metric), known.distance, D)?;
        let distance_squared = known.distance.powi(2);
        // Energies are compensated sums of terms with about ten roundings each. The points have
        // size |x| and are rounded; the momentum 2√(c₂E) turns this into an error of the energy.
        let size = sequence.points().iter().map(|x| x.norm()).fold(0.0, f64::max);
        let momentum = 2.0 * (setting.constants().c2() * energy.value.max(0.0)).sqrt();
        let granted = 1e-14 * (distance_squared + discrete_energy + energy.value)
            + 8.0 * f64::EPSILON * size * momentum
            + known.squared_error()
            + energy.error
            + length_squared.error;
        Ok(Self {
            rule,
            setting,
            n: sequence.n(),
            distance_squared,
            discrete_energy,
            energy,
            length_squared,
            k3: subject.k3(sequence),
            mean_cube: mean_power(sequence, 3),
            speeds,
            curvature: curvature_along(metric, sequence),
            gram: GramRange::along(metric, nodes(sequence))?,
            off_sets: off_sets(known, sequence),
            minimum,
            granted,
        })
    }
}

/// Returns `(1/N) Σ |βₙ|^power`, in `ℓ^power`.
#[must_use]
pub fn mean_power<const D: usize>(sequence: &PointSequence<D>, power: i32) -> f64 {
    let powers: f64 = sequence.differences().map(|beta| beta.norm().powi(power)).sum();
    powers / sequence.n().get() as f64
}

/// Returns the points of a sequence and the midpoints of its chords, in order. The rules of the
/// paper evaluate `H` at these points.
pub fn nodes<const D: usize>(sequence: &PointSequence<D>) -> impl Iterator<Item = SVector<f64, D>> {
    let chords = sequence.chords().flat_map(|(x, chord)| [*x, x + chord * 0.5]);
    chords.chain([*sequence.last()])
}

/// Returns the larger of the distances of the two ends of a sequence from their sets, in `ℓ`.
fn off_sets<M, const D: usize>(known: &Known<M, D>, sequence: &PointSequence<D>) -> f64 {
    let ends = [(known.ends.first(), sequence.first()), (known.ends.second(), sequence.last())];
    ends.map(|(set, x)| (set.project(x) - x).norm()).into_iter().fold(0.0, f64::max)
}
