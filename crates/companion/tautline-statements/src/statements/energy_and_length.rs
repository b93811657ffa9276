//! Section 6: the least energy is the squared distance, between points and between sets.

use nalgebra::SVector;
use tautline::{Metric, MetricError};

use super::{geodesics::off_sets, way_out::WayOut};
use crate::{
    Evidence, Known, Statement, Subject, Unit,
    curves::{Curve, Measured, Residual, largest},
};

/// Evaluates Proposition 6.1 on a curve between two points: `d² ≤ L(γ)² ≤ E(γ)`.
///
/// Equality holds only for minimal geodesics; see [`prop_6_1_minimiser`]. [`prop_6_1_attained`]
/// checks that the minima are attained.
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    let evidence = given_points(Evidence::of(Statement::Proposition6_1), subject, known);
    no_curve_is_shorter(evidence, subject, known, seen)
}

/// Adds the hypothesis that both sets are points.
///
/// A set of radius `R` is a point if and only if it projects the `2D` points `±s eᵢ` to the same
/// point, for some `s ≥ √D R`. Indeed, suppose that it contains `p ≠ q`, and that `p` is nearest to
/// all these points. Then `2s |pᵢ − qᵢ| ≤ |q|² − |p|²` for every `i`, but
///
/// ```text
/// |q|² − |p|² = (q − p)·(q + p) < 2R |q − p| ≤ 2R √D maxᵢ |pᵢ − qᵢ|
/// ```
///
/// A set without a radius is unbounded and therefore not a point.
fn given_points<M, const D: usize>(
    evidence: Evidence,
    subject: &Subject,
    known: &Known<M, D>,
) -> Evidence {
    let spread = [known.ends.first(), known.ends.second()].map(|set| {
        let Some(radius) = set.radius() else { return f64::INFINITY };
        let far = 2.0 * (D as f64).sqrt() * radius;
        let axes = (0..D).flat_map(|i| [far, -far].map(|s| (i, s)));
        let mut seen = axes.map(|(i, s)| {
            let mut probe = SVector::<f64, D>::zeros();
            probe[i] = s;
            subject.project(&**set, &probe)
        });
        let first = seen.next();
        largest(seen.zip(first.iter().cycle()).map(|(other, first)| (other - first).norm()))
    });
    let claim = "the two sets are points";
    evidence.given(claim, Unit::COORDINATE, [largest(spread), 0.0], 0.0)
}

/// Evaluates the claim that the given curve attains the minima of Proposition 6.1.
///
/// ```text
/// γ ∈ C(x⁰, x¹),    L(γ)² ≤ d²,    E(γ) ≤ d²
/// ```
///
/// Needs: a minimal geodesic. A complete space, which has no way out, has one.
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1_attained<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
    way_out: WayOut,
) -> Evidence {
    let evidence = given_points(Evidence::of(Statement::Proposition6_1), subject, known);
    is_attained(evidence, subject, known, seen, way_out)
}

/// Evaluates the claim that the given curve attains the minima of Proposition 6.3, as
/// [`prop_6_1_attained`] does.
///
/// Needs: a complete space, and a bounded set, which [`tautline::Ends`] ensures. Without a bounded
/// set there may be no nearest pair and no shortest curve: see [`prop_6_2`](super::prop_6_2), and
/// [`prop_7_1`](super::prop_7_1) for the discrete energies.
#[doc(alias = "prop:geodesic_len_and_energy_2")]
pub fn prop_6_3_attained<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
    way_out: WayOut,
) -> Evidence {
    is_attained(Evidence::of(Statement::Proposition6_3), subject, known, seen, way_out)
}

fn is_attained<M, const D: usize>(
    evidence: Evidence,
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
    way_out: WayOut,
) -> Evidence {
    let (off, rounding) = off_sets(subject, known, seen);
    let d2 = known.distance.powi(2);
    let granted = seen.granted_energy() + known.squared_error();
    way_out
        .given_longer(evidence, [known.distance, known.distance_error])
        .stated("γ joins the sets", Unit::COORDINATE, [off, 0.0], rounding)
        .stated("L(γ)² ≤ d²", Unit::ENERGY, [seen.length_squared(), d2], granted)
        .stated("E(γ) ≤ d²", Unit::ENERGY, [seen.energy.value, d2], granted)
}

/// Evaluates Proposition 6.3 on a curve between two closed sets: `d² ≤ L(γ)² ≤ E(γ)`.
///
/// Equality holds for minimal geodesics between the points of a nearest pair; see
/// [`prop_6_3_attained`].
#[doc(alias = "prop:geodesic_len_and_energy_2")]
pub fn prop_6_3<M, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    // `Ends` always has a bounded set, so this hypothesis needs no check.
    no_curve_is_shorter(Evidence::of(Statement::Proposition6_3), subject, known, seen)
}

fn no_curve_is_shorter<M, const D: usize>(
    evidence: Evidence,
    subject: &Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    let (off, rounding) = off_sets(subject, known, seen);
    let d2 = known.distance.powi(2);
    let (length2, energy) = (seen.length_squared(), seen.energy.value);
    let granted = seen.granted_energy() + known.squared_error();
    evidence
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], rounding)
        .stated("d² ≤ L(γ)²", Unit::ENERGY, [d2, length2], granted)
        .stated("L(γ)² ≤ E(γ)", Unit::ENERGY, [length2, energy], granted)
}

/// Evaluates the second claim of Proposition 6.1: a curve of energy `d²` is a minimal geodesic.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1_minimiser<M: Metric<D>, const D: usize>(
    subject: &Subject,
    known: &Known<M, D>,
    curve: &impl Curve<D>,
) -> Result<Evidence, MetricError> {
    let seen = Measured::of(&known.metric, curve);
    let residual = Residual::of(subject, &known.metric, curve)?;
    let (off, rounding) = off_sets(subject, known, &seen);
    let length = seen.granted_length() + known.distance_error;
    let granted = seen.granted_energy() + known.squared_error();
    Ok(Evidence::of(Statement::Proposition6_1)
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], rounding)
        .given("E(γ) ≤ d²", Unit::ENERGY, [seen.energy.value, known.distance.powi(2)], granted)
        .stated("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, known.distance], length)
        .stated("d ≤ L(γ)", Unit::LENGTH, [known.distance, seen.length.value], length)
        .stated("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [residual.value, 0.0], residual.granted))
}
