//! `Subject`: what the statements are computed with.

use std::num::NonZeroUsize;

use nalgebra::SVector;
use tautline::{
    Bounded, ClosedSet, Constants, Ends, Integral, Interpolation, Metric, MetricError, Minimum,
    Options, PointSequence, Rule, SolveError,
    bounds::{
        self, BetweenPoints, Bound, BoundError, Computed, Enclosure, LocalityError, PaperRule,
        Region, Setting, Spread,
    },
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

    /// Returns the `K₂` of Lemma S.1, in `ℓ`.
    fn k2_sharp(&self, setting: Setting) -> f64 {
        bounds::k2_sharp(setting)
    }

    /// Returns the bound of `|E(γᵖˡ) − E_N|` by the mean cube of Lemma S.2, in `m²`.
    fn cubic_gap(&self, constants: Constants, rule: PaperRule, cube: f64, n: NonZeroUsize) -> f64 {
        bounds::cubic_gap(constants, rule, cube, n)
    }

    /// Returns the bound of `|E_l,N − E_tra,N|` by the mean cube of Lemma S.2, in `m²`.
    fn cubic_rule_gap(&self, constants: Constants, cube: f64, n: NonZeroUsize) -> f64 {
        bounds::cubic_rule_gap(constants, cube, n)
    }

    /// Returns the bound of `|E(γᵖˡ) − E_tra,N|` by the mean fourth power of Lemma S.2, in `m²`.
    fn quartic_gap(&self, constants: Constants, fourth: f64, n: NonZeroUsize) -> Option<f64> {
        bounds::quartic_gap(constants, fourth, n)
    }

    /// Returns the bound of `max qₙ` of Lemma S.3, in `m`.
    fn greatest_speed(&self, constants: Constants, energy: f64, rho: f64, n: NonZeroUsize) -> f64 {
        bounds::greatest_speed(constants, energy, rho, n)
    }

    /// Returns the bound of `max |βₙ|` of Lemma S.3, in `ℓ`.
    fn greatest_difference(&self, constants: Constants, k3: f64, rho: f64) -> f64 {
        bounds::greatest_difference(constants, k3, rho)
    }

    /// Returns the bound of `|βₙ − βₙ₋₁|` of Lemma S.3, in `ℓ`.
    fn difference_step(&self, constants: Constants, greatest: f64, n: NonZeroUsize) -> f64 {
        bounds::difference_step(constants, greatest, n)
    }

    /// Returns the bound of `L(γᵖˡ)²` by the discrete energy of Lemma S.5, in `m²`.
    fn squared_length(
        &self,
        constants: Constants,
        rule: PaperRule,
        e: f64,
        n: NonZeroUsize,
    ) -> f64 {
        bounds::squared_length(constants, rule, e, n)
    }

    /// Returns the spread of Lemma S.5 by the first order, pure numbers.
    fn spread(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize, surplus: f64) -> Spread {
        Spread::of_first_order(setting, rule, n, surplus)
    }

    /// Returns the spread of Lemma S.5 by the second order, pure numbers.
    fn sharp_spread(&self, setting: Setting, n: NonZeroUsize, surplus: f64) -> Option<Spread> {
        Spread::of_second_order(setting, n, surplus)
    }

    /// Returns the bound of order `1/N` of `min E_N − d²`, in `m²`.
    fn theorem_a_minimum_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_a_minimum_gap(setting, rule, n)
    }

    /// Returns the bound of `E(γᵖˡ) − E_N` and `d² − E_N` of Theorem A, in `m²`.
    fn theorem_a_polyline_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_a_polyline_gap(setting, rule, n)
    }

    /// Returns the bound of `E(γᵖˡ) − d²` of Theorem A, in `m²`.
    fn theorem_a_excess(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_a_excess(setting, rule, n)
    }

    /// Returns the bound of order `1/N²` of `min E_tra,N − d²` of Theorem B, in `m²`.
    fn theorem_b_minimum_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_b_minimum_gap(setting, n)
    }

    /// Returns the bound of `|E(γᵖˡ) − E_tra,N|` of Theorem B, in `m²`.
    fn theorem_b_polyline_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_b_polyline_gap(setting, n)
    }

    /// Returns the bound of `d² − E_N` of Theorem C, in `m²`.
    fn theorem_c_deficit(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_c_deficit(setting, rule, n)
    }

    /// Returns the bound of `|E(γᵖˡ) − E_N|` of Theorem C, in `m²`.
    fn theorem_c_polyline_gap(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_c_polyline_gap(setting, rule, n)
    }

    /// Returns the bound of `L(γᵖˡ)² − d²` of Theorem C, in `m²`.
    fn theorem_c_length_excess(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> f64 {
        bounds::theorem_c_length_excess(setting, rule, n)
    }

    /// Returns the bound of `L(γᵖˡ)² − d²` of Theorem D, in `m²`.
    fn theorem_d_length_excess(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_d_length_excess(setting, n)
    }

    /// Returns the bound of order `1/N²` of `min E_tra,N − d²` of Theorem D, in `m²`.
    fn theorem_d_minimum_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_d_minimum_gap(setting, n)
    }

    /// Returns the bound of `d² − E_tra,N` of Theorem D, in `m²`.
    fn theorem_d_deficit(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_d_deficit(setting, n)
    }

    /// Returns the bound of `|E(γᵖˡ) − E_tra,N|` of Theorem D, in `m²`.
    fn theorem_d_polyline_gap(&self, setting: Setting, n: NonZeroUsize) -> Option<f64> {
        bounds::theorem_d_polyline_gap(setting, n)
    }

    /// Returns the least of all bounds of `L(γᵖˡ)² − d²`, in `m²`.
    fn least_length_excess(&self, setting: Setting, rule: PaperRule, n: NonZeroUsize) -> Bound {
        bounds::least_length_excess(setting, rule, n)
    }

    /// Returns the enclosure of `d²` of Proposition S.6.
    ///
    /// # Errors
    ///
    /// As [`bounds::enclose`].
    fn enclose(
        &self,
        constants: Constants,
        dimension: usize,
        computed: &Computed,
    ) -> Result<Enclosure, BoundError> {
        bounds::enclose(constants, dimension, computed)
    }

    /// Returns the modulus of convexity of Proposition S.7, in `m²/ℓ²`.
    fn convexity_modulus(
        &self,
        constants: Constants,
        rule: PaperRule,
        greatest: f64,
        n: NonZeroUsize,
    ) -> Option<f64> {
        bounds::convexity_modulus(constants, rule, greatest, n)
    }

    /// Returns the lower bound of the discrete minimum of Proposition S.7, in `m²`.
    fn strict_convexity(
        &self,
        constants: Constants,
        dimension: usize,
        computed: &BetweenPoints,
    ) -> Option<f64> {
        bounds::strict_convexity(constants, dimension, computed)
    }

    /// Returns the region of Proposition S.8, outside of which no competitor comes.
    fn competitors<E>(
        &self,
        dimension: usize,
        rule: PaperRule,
        n: NonZeroUsize,
        upper: f64,
        constants_within: impl FnMut(f64) -> Result<Constants, E>,
    ) -> Result<Region, LocalityError<E>> {
        bounds::competitors(dimension, rule, n, upper, constants_within)
    }
}

/// The library itself: every method of [`Subject`] as it is.
#[derive(Clone, Copy, Debug, Default)]
pub struct Library;

impl Subject for Library {}
