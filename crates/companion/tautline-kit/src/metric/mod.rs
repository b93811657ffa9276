//! The laws of a metric, and the statements of the paper about it.
//!
//! There is one function per law, with the same name as its test in
//! [`metric_suite!`](crate::metric_suite).
//!
//! Every statement is tested that applies to a metric of which only the formula, the constants and
//! perhaps the distances are known. Propositions 3.1, 3.2, 4.1 to 4.3, 7.12 and 9.1, Lemma 4.4 and
//! the constants `K_{1,g}` and `K_{2,g}` are about minimal geodesics, which are not known here.
//! Section 5 is about the valleys; Propositions 7.2 to 7.4 and 7.8 do not involve a metric at all.

mod case;
mod claims;
mod distances;
mod extreme;
mod formula;
mod memory;
mod minimisers;
mod mutants;
mod on_a_ball;
mod orders;
mod problems;
mod proofs;
mod proved_distances;
mod sampled_curves;
mod sharper;
mod solutions;
mod soundness;
mod statements;

use std::sync::Arc;

use case::Case;
use memory::Solved;
use nalgebra::SVector;
use statements::joined;
use tautline::{Bounded, KnownDistance, LocalError, LocallyBounded, bounds::LocalityError};
use tautline_statements::{self as of_the_paper, PaperRule, curves::Measured};

use super::{Claim, Effort, Region, Report};

/// Returns the distance between two points, in `m`, if the metric knows it.
type Distance<M, const D: usize> = fn(&M, &SVector<f64, D>, &SVector<f64, D>) -> Option<f64>;

/// A metric, the region to sample, and the effort.
#[derive(Clone, Debug)]
pub struct MetricCase<M, const D: usize> {
    metric: M,
    region: Region<D>,
    /// The region in which the ends of problems lie.
    ends: Region<D>,
    effort: Effort,
    distance: Option<Distance<M, D>>,
    solved: Arc<Solved<D>>,
}

impl<M: Bounded<D>, const D: usize> MetricCase<M, D> {
    /// Returns the case of a metric whose distances are extrapolated from fine grids. In up to two
    /// dimensions one of them is also proved by a certificate, and the theorems have to hold with it.
    pub fn new(metric: M, region: Region<D>, effort: Effort) -> Self {
        Self { metric, region, ends: region, effort, distance: None, solved: Arc::default() }
    }

    /// Returns the case of the same metric with the distances that it knows.
    #[must_use]
    pub fn with_known_distance(self) -> Self
    where
        M: KnownDistance<D>,
    {
        // Solutions found with estimated distances are no longer used.
        let solved = Arc::default();
        Self { distance: Some(|metric, x, y| metric.distance(x, y)), solved, ..self }
    }

    /// Implements `with distances` at the end of [`metric_suite!`](crate::metric_suite).
    #[doc(hidden)]
    #[must_use]
    pub fn distances(self) -> Self
    where
        M: KnownDistance<D>,
    {
        self.with_known_distance()
    }

    /// Returns the case that the laws use, with the type of the metric erased.
    fn erased(&self) -> Case<'_, D> {
        let Self { metric, region, ends, effort, distance, solved } = self;
        let distance =
            distance.map(|distance| Box::new(move |x: &_, y: &_| distance(metric, x, y)) as _);
        let solved = Arc::clone(solved);
        Case { ends: *ends, distance, solved, ..Case::new(metric, *region, *effort) }
    }
}

/// The laws, one per row: its name, its content, and the function that checks it.
///
/// To add a statement of `tautline_statements`, add a row: `case.of_points(…)` for a statement
/// about the metric at a point, `case.of_point_sequences(…)` for one about any point sequence,
/// `case.of_known(…)` for one about a distance and the curves that are no shorter,
/// `case.of_minimisers(rule, …)` for one about computed minimisers, `case.of_theorem(rule, …)` if
/// it is to hold with a proved distance too, and
/// `case.of_constants(rule, …)` if it is an equality for every metric. All laws about minimisers
/// share the same minimisers, which are computed once.
#[doc(hidden)]
#[macro_export]
macro_rules! __metric_laws {
    ([$($callback:tt)*] $context:tt) => {
        $($callback)*! { $context
            is_finite_and_symmetric, "H(x) is finite and symmetric",
                formula::finite_and_symmetric;
            is_positive_definite, "H(x) is positive definite",
                formula::positive_definite;
            jets_agree_with_differences, "DH and D²H are the limits of central differences",
                formula::jets;
            is_isotropic_if_it_says_so, "H(x) is a multiple of I, if the constants say so",
                formula::isotropic;
            c1_is_a_lower_bound, "c1 ≤ λ_min(H)",
                |case| claims::claim(case, Claim::C1);
            c2_is_an_upper_bound, "λ_max(H) ≤ c2",
                |case| claims::claim(case, Claim::C2);
            l_h_bounds_the_derivative, "‖DH(x)[w]‖ ≤ L_H |w|",
                |case| claims::claim(case, Claim::LH);
            l_h_bounds_differences, "‖H(x) − H(y)‖ ≤ L_H |x − y|",
                claims::lipschitz;
            m_h_bounds_the_second_derivative, "|uᵀ D²H(x)[w, w] u| ≤ M_H |w|² |u|²",
                |case| claims::claim(case, Claim::MH);
            no_constant_is_refuted, "no bound over the region contradicts c1, c2, L_H or M_H",
                proofs::constants;
            known_distances_are_distances, "d(x, y) = d(y, x), d(x, x) = 0, no curve is shorter",
                orders::distances;
            prop_3_3, "Proposition 3.3: c1|x − y|² ≤ d(x, y)² ≤ c2|x − y|²",
                |case| case.of_known(|subject, known, _| {
                    Ok(of_the_paper::prop_3_3(subject, known)?)
                });
            prop_6_1, "Proposition 6.1: d² ≤ L(γᵖˡ)² ≤ E(γᵖˡ) between two points",
                |case| case.of_known(|subject, known, inner| {
                    let sequence = joined(known, inner)?;
                    let seen = Measured::of_sequence(subject, &known.metric, &sequence);
                    Ok(of_the_paper::prop_6_1(subject, known, &seen))
                });
            prop_6_2, "Proposition 6.2: a nearest pair is there, within R + d/√c1",
                minimisers::prop_6_2;
            prop_6_3, "Proposition 6.3: d² ≤ L(γ)² ≤ E(γ) between two sets",
                minimisers::prop_6_3;
            prop_7_1, "Proposition 7.1: minimisers are no farther away than √(R/c1), and minimal",
                minimisers::prop_7_1;
            minimisers_are_critical_points, "∂E_N/∂xₙ = 0, and speeds are nearly equal",
                minimisers::critical_points;
            prop_7_5, "Proposition 7.5: |u₁ᵀH(x₁)u₁ − u₂ᵀH(x₂)u₂| by L_H and c2",
                |case| case.of_two_forms();
            prop_7_6, "Proposition 7.6: |E(γ) − E_tra,N(γ)| ≤ C_tra(N) for a smooth curve",
                sampled_curves::prop_7_6;
            prop_7_7, "Proposition 7.7: min E_tra,N − min E ≤ C_tra(N) over smooth curves",
                sampled_curves::prop_7_7;
            prop_7_9, "Proposition 7.9: |E(γᵖˡ) − E_tra,N| ≤ L_H K₃³/4√N",
                |case| case.of_point_sequences(of_the_paper::prop_7_9);
            prop_7_10, "Proposition 7.10: |∂ₗ Hᵢⱼ| ≤ L_H",
                |case| case.of_points(of_the_paper::prop_7_10);
            prop_7_11, "Proposition 7.11: |Γᵏᵢⱼ| ≤ 3 L_H √D/2c1",
                |case| case.of_points(of_the_paper::prop_7_11);
            prop_8_1, "Proposition 8.1: |E_l,N − E_tra,N| ≤ L_H K₃³/2√N",
                |case| case.of_point_sequences(of_the_paper::prop_8_1);
            prop_8_2, "Proposition 8.2: |E(γᵖˡ) − E_l,N| ≤ L_H K₃³/2√N",
                |case| case.of_point_sequences(of_the_paper::prop_8_2);
            theorem_1_1, "Theorem 1.1: energies of the trapezoidal rule",
                |case| case.of_theorem(PaperRule::Trapezoidal, of_the_paper::theorem_1_1);
            theorem_1_2, "Theorem 1.2: lengths of the trapezoidal rule",
                |case| case.of_theorem(PaperRule::Trapezoidal, of_the_paper::theorem_1_2);
            theorem_1_3, "Theorem 1.3: energies of the left-endpoint rule",
                |case| case.of_theorem(PaperRule::LeftEndpoint, of_the_paper::theorem_1_3);
            theorem_1_4, "Theorem 1.4: lengths of the left-endpoint rule",
                |case| case.of_theorem(PaperRule::LeftEndpoint, of_the_paper::theorem_1_4);
            constant_c_tra, "C_tra(N) is its formula",
                |case| case.of_constants(PaperRule::Trapezoidal, minimisers::c_tra, None);
            constant_c_tra_sharp, "C_tra(N) ≤ C_tra♯/N, with equality at N = 1",
                |case| case.of_constants(PaperRule::Trapezoidal, minimisers::c_tra_sharp, None);
            constant_k3_bar, "K₃ ≤ K̄₃ for the trapezoidal rule",
                |case| case.of_minimisers(PaperRule::Trapezoidal, of_the_paper::constant_k3_bar);
            constant_c_1_1, "E(γᵖˡ) − d² ≤ C/√N with the C of Theorem 1.1, the sum of its parts",
                |case| {
                    let shown = Some("E(γᵖˡ) − d² ≤ by parts");
                    case.of_constants(PaperRule::Trapezoidal, of_the_paper::constant_c_1_1, shown)
                };
            constant_k4_bar, "K₃ ≤ K̄₄ for the left-endpoint rule",
                |case| case.of_minimisers(PaperRule::LeftEndpoint, of_the_paper::constant_k4_bar);
            constant_c_1_3, "E(γᵖˡ) − d² ≤ C/√N with the C of Theorem 1.3, the sum of its parts",
                |case| {
                    let shown = Some("E(γᵖˡ) − d² ≤ by parts");
                    case.of_constants(PaperRule::LeftEndpoint, of_the_paper::constant_c_1_3, shown)
                };
            lemmas_s_2_and_s_3, "Lemmas S.2 and S.3: gaps and speeds of any sequence",
                sharper::of_sequences;
            lemmas_s_4_and_s_5, "Lemmas S.4 and S.5: the discrete minimum and its speeds",
                sharper::of_minima;
            theorems_a_to_d, "Theorems A to D: all gaps are of order 1/N, or 1/N² with M_H",
                sharper::theorems;
            prop_s_6, "Propositions S.6 and S.9: the distance is enclosed by one minimiser",
                sharper::enclosures;
            prop_s_8, "Proposition S.8: competitors stay where the constants hold",
                sharper::localities;
            remark_9_2, "Remark 9.2: all gaps are of order 1/N, for both rules",
                minimisers::remark_9_2;
            trapezoidal_rule_has_order_2, "E_tra,N − d² and E(γᵖˡ) − d² fall like N⁻²",
                |case| orders::orders(case, PaperRule::Trapezoidal, 2.0);
            left_rule_has_order_1, "E_l,N − d² falls like N⁻¹, E(γᵖˡ) − d² like N⁻²",
                |case| orders::orders(case, PaperRule::LeftEndpoint, 1.0);
            refuses_a_larger_c1, "1.05 c1 is refused, if c1 is attained",
                |case| mutants::constant(case, Claim::C1);
            refuses_a_smaller_c2, "0.95 c2 is refused, if c2 is attained",
                |case| mutants::constant(case, Claim::C2);
            refuses_a_smaller_l_h, "0.9 L_H is refused, if L_H is attained",
                |case| mutants::constant(case, Claim::LH);
            refuses_a_smaller_m_h, "0.9 M_H is refused, if M_H is attained",
                |case| mutants::constant(case, Claim::MH);
            refuses_a_metric_that_is_nan, "H is refused if it is NaN in half of the region",
                mutants::nan_metric;
            refuses_points_that_are_nan, "points that are not finite are refused",
                mutants::nan_points;
            refuses_no_subinterval, "N = 0 is refused",
                mutants::no_subinterval;
            refuses_two_unbounded_sets, "two half-spaces are refused",
                mutants::two_unbounded_sets;
            refuses_an_empty_set, "an empty set is refused",
                mutants::empty_set;
        }
    };
}

__metric_laws! {
    [super::laws::functions]
    { [M: Bounded<D>, const D: usize] MetricCase<M, D>, MetricCase::erased }
}

/// Checks all laws of a metric whose distances are extrapolated from fine grids, and proved in one
/// case: see [`MetricCase::new`].
///
/// The tests of [`metric_suite!`](crate::metric_suite) call the same functions.
pub fn verify_metric<M: Bounded<D>, const D: usize>(
    metric: &M,
    region: &Region<D>,
    effort: &Effort,
) -> Report {
    verify(&MetricCase::new(metric, *region, *effort))
}

/// Checks all laws of a metric with constants on balls, on one of the balls.
///
/// # Errors
///
/// The errors of [`MetricCase::within`].
pub fn verify_metric_within<M: LocallyBounded<D>, const D: usize>(
    metric: &M,
    centre: impl Into<SVector<f64, D>>,
    radius: f64,
    effort: &Effort,
) -> Result<Report, LocalityError<LocalError>> {
    Ok(verify(&MetricCase::within(metric, centre, radius, *effort)?))
}
