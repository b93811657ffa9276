//! `Subject`: what the statements are computed with.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use tautline::{
    Bounded, ClosedSet, Constants, Ends, Integral, Interpolation, Metric, MetricError, Minimum,
    Options, PointSequence, Rule, SolveError,
    bounds::{self, Setting},
    christoffel, energy_gradient, minimise,
};

/// The programs by which a statement is evaluated: discrete energies, reconstructions, solver,
/// constants and bounds.
///
/// Every method is provided, and calls the library. So [`Library`] is the library itself, and an
/// implementor that overrides a method is the library with that one thing changed: what a
/// suite of tests says of such a variant shows what the suite is worth.
///
/// Units: those of the functions that are called.
pub trait Subject: Sync {
    /// Returns the discrete energy of a sequence, in `m²`.
    fn discrete_energy<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        rule.energy(metric, sequence)
    }

    /// Returns the discrete length of a sequence, in `m`.
    fn discrete_length<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> f64 {
        rule.length(metric, sequence)
    }

    /// Returns `∂E_N/∂xₙ` for all `N + 1` points, in `m²/ℓ`.
    fn energy_gradient<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<SVector<f64, D>> {
        energy_gradient(rule, metric, sequence).1
    }

    /// Returns the energy `E(γᵖˡ)` of the reconstruction, in `m²`.
    fn curve_energy<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        Interpolation::new(sequence).energy(metric)
    }

    /// Returns the length `L(γᵖˡ)` of the reconstruction, in `m`.
    fn curve_length<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Integral {
        Interpolation::new(sequence).length(metric)
    }

    /// Returns `K₃`, the root mean square of the differences, in `ℓ`.
    fn k3<const D: usize>(&self, sequence: &PointSequence<D>) -> f64 {
        sequence.k3()
    }

    /// Returns the Christoffel symbols at a point, in `1/ℓ`.
    ///
    /// # Errors
    ///
    /// As [`christoffel`].
    fn christoffel<const D: usize>(
        &self,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
    ) -> Result<[nalgebra::SMatrix<f64, D, D>; D], MetricError> {
        christoffel(metric, x)
    }

    /// Returns the nearest point of a set, in `ℓ`.
    fn project<const D: usize>(
        &self,
        set: &dyn ClosedSet<D>,
        x: &SVector<f64, D>,
    ) -> SVector<f64, D> {
        set.project(x)
    }

    /// Returns the discrete speeds of the chords, in `m`.
    fn discrete_speeds<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        sequence: &PointSequence<D>,
    ) -> Vec<f64> {
        rule.speeds(metric, sequence)
    }

    /// Returns the discrete minimiser that the solver finds from its own starts.
    ///
    /// # Errors
    ///
    /// As [`minimise`].
    fn minimise<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
    ) -> Result<Minimum<D>, SolveError> {
        self.minimise_with(rule, metric, ends, n, &Options::default())
    }

    /// Returns the discrete minimiser that the solver finds with these options.
    ///
    /// # Errors
    ///
    /// As [`minimise`].
    fn minimise_with<R: Rule, const D: usize>(
        &self,
        rule: R,
        metric: &impl Metric<D>,
        ends: &Ends<D>,
        n: usize,
        options: &Options<D>,
    ) -> Result<Minimum<D>, SolveError> {
        minimise(metric, ends, rule, n, options)
    }

    /// Returns what a metric claims of itself.
    fn constants<const D: usize>(&self, metric: &impl Bounded<D>) -> Constants {
        metric.constants()
    }

    /// Returns `K_{1,g}`, in `ℓ`.
    fn k1_g(&self, setting: Setting) -> f64 {
        bounds::k1_g(setting)
    }

    /// Returns `K_{2,g}`, in `ℓ`.
    fn k2_g(&self, setting: Setting) -> f64 {
        bounds::k2_g(setting)
    }

    /// Returns `C_tra(N)`, in `m²`.
    fn c_tra(&self, constants: Constants, k1: f64, k2: f64, n: NonZeroUsize) -> f64 {
        bounds::c_tra(constants, k1, k2, n)
    }

    /// Returns `C_tra♯`, in `m²`.
    fn c_tra_sharp(&self, constants: Constants, k1: f64, k2: f64) -> f64 {
        bounds::c_tra_sharp(constants, k1, k2)
    }

    /// Returns `K̄_{3,g}`, in `ℓ`.
    fn k3_bar_g(&self, setting: Setting) -> f64 {
        bounds::k3_bar_g(setting)
    }

    /// Returns `K̄_{4,g}`, in `ℓ`.
    fn k4_bar_g(&self, setting: Setting) -> f64 {
        bounds::k4_bar_g(setting)
    }

    /// Returns the bound of Proposition 7.9, in `m²`.
    fn polyline_gap_trapezoidal(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        bounds::polyline_gap_trapezoidal(constants, k3, n)
    }

    /// Returns the bound of Proposition 8.1, in `m²`.
    fn rule_gap(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        bounds::rule_gap(constants, k3, n)
    }

    /// Returns the bound of Proposition 8.2, in `m²`.
    fn polyline_gap_left(&self, constants: Constants, k3: f64, n: NonZeroUsize) -> f64 {
        bounds::polyline_gap_left(constants, k3, n)
    }

    /// Returns the constant `C` of Theorems 1.1 and 1.2, in `m²`.
    fn theorem_1_1_constant(&self, setting: Setting) -> f64 {
        bounds::theorem_1_1_constant(setting)
    }

    /// Returns the constant `C` of Theorems 1.3 and 1.4, in `m²`.
    fn theorem_1_3_constant(&self, setting: Setting) -> f64 {
        bounds::theorem_1_3_constant(setting)
    }

    /// Returns the bound of `E(γᵖˡ) − d²` in the proof of Theorem 1.1, in `m²`.
    fn theorem_1_1_excess(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::theorem_1_1_excess(setting, n)
    }

    /// Returns the bound of `E(γᵖˡ) − d²` in the proof of Theorem 1.3, in `m²`.
    fn theorem_1_3_excess(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::theorem_1_3_excess(setting, n)
    }

    /// Returns the bound of order `1/N` of `E(γᵖˡ) − d²` for the trapezoidal rule, in `m²`.
    fn first_order_excess_trapezoidal(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_excess_trapezoidal(setting, n)
    }

    /// Returns the bound of order `1/N` of `E(γᵖˡ) − d²` for the left-endpoint rule, in `m²`.
    fn first_order_excess_left(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_excess_left(setting, n)
    }

    /// Returns the bound of order `1/N` of `min E_tra,N − d²`, in `m²`.
    fn first_order_minimum_gap_trapezoidal(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_minimum_gap_trapezoidal(setting, n)
    }

    /// Returns the bound of order `1/N` of `min E_l,N − d²`, in `m²`.
    fn first_order_minimum_gap_left(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_minimum_gap_left(setting, n)
    }

    /// Returns the bound of order `1/N` of `E(γᵖˡ) − E_tra,N` and of `d² − E_tra,N`, in `m²`.
    fn first_order_polyline_gap_trapezoidal(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_polyline_gap_trapezoidal(setting, n)
    }

    /// Returns the bound of order `1/N` of `E(γᵖˡ) − E_l,N` and of `d² − E_l,N`, in `m²`.
    fn first_order_polyline_gap_left(&self, setting: Setting, n: NonZeroUsize) -> f64 {
        bounds::first_order_polyline_gap_left(setting, n)
    }
}

/// The library itself: every method of [`Subject`] as it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Library;

impl Subject for Library {}
