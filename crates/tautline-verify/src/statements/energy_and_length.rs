//! Section 6: the least energy is the square of the distance, between points and between sets.

use nalgebra::SVector;
use tautline::{Metric, MetricError};

use super::geodesics::{given_complete, off_sets};
use crate::{
    Evidence, Known, Reconstruction, Statement, Subject, Unit,
    curves::{Curve, Measured, Residual, largest},
};

/// Evaluates Proposition 6.1 on a curve between two points: `d² ≤ L(γ)² ≤ E(γ)`.
///
/// Equality: minimal geodesics, for which see [`prop_6_1_minimiser`], and nothing else. That the
/// minima are attained: [`prop_6_1_attained`].
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    no_curve_is_shorter(
        given_points(Evidence::of(Statement::Proposition6_1), subject, known),
        subject,
        known,
        seen,
    )
}

/// Adds the hypothesis that both sets are points.
///
/// With `R` the radius of a set, it is a point if and only if it sends the `2D` points `±s eᵢ` to
/// the same one, for an `s ≥ √D R`. If two points `p ≠ q` of it had `p` nearest to all of them,
/// `2s |pᵢ − qᵢ| ≤ |q|² − |p|²` for every `i`; but
///
/// ```text
/// |q|² − |p|² = (q − p)·(q + p) < 2R |q − p| ≤ 2R √D maxᵢ |pᵢ − qᵢ|
/// ```
///
/// A set without a radius is not bounded, and no point.
fn given_points<M, const D: usize>(
    evidence: Evidence,
    subject: &impl Subject,
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

/// Evaluates that the minima of Proposition 6.1 are attained: by the curve which is shown.
///
/// ```text
/// γ ∈ C(x⁰, x¹),    L(γ)² ≤ d²,    E(γ) ≤ d²
/// ```
///
/// Needs: that there is a minimal geodesic, as in a complete space; `way_out` is that of
/// [`prop_3_2`](super::prop_3_2).
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1_attained<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
    way_out: f64,
) -> Evidence {
    let evidence = given_points(Evidence::of(Statement::Proposition6_1), subject, known);
    is_attained(given_complete(evidence, way_out), subject, known, seen)
}

/// Evaluates that the minima of Proposition 6.3 are attained, as [`prop_6_1_attained`] does.
///
/// Needs: a complete space, and that one of the sets is bounded. [`tautline::Ends`] sees to the
/// second; without it there may be no nearest pair, and then no shortest curve: see
/// [`prop_6_2`], and for the discrete energies [`prop_7_1`](super::prop_7_1).
#[doc(alias = "prop:geodesic_len_and_energy_2")]
pub fn prop_6_3_attained<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
    way_out: f64,
) -> Evidence {
    let evidence = given_complete(Evidence::of(Statement::Proposition6_3), way_out);
    is_attained(evidence, subject, known, seen)
}

fn is_attained<M, const D: usize>(
    evidence: Evidence,
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    let (off, rounding) = off_sets(subject, known, seen);
    let d2 = known.distance.powi(2);
    let granted = seen.granted_energy() + 2.0 * known.distance * known.distance_error;
    evidence
        .stated("γ joins the sets", Unit::COORDINATE, [off, 0.0], rounding)
        .stated("L(γ)² ≤ d²", Unit::ENERGY, [seen.length_squared(), d2], granted)
        .stated("E(γ) ≤ d²", Unit::ENERGY, [seen.energy.value, d2], granted)
}

/// Evaluates Proposition 6.3 on a curve between two closed sets: `d² ≤ L(γ)² ≤ E(γ)`.
///
/// Equality: minimal geodesics between a nearest pair. That the minima are attained:
/// [`prop_6_3_attained`].
#[doc(alias = "prop:geodesic_len_and_energy_2")]
pub fn prop_6_3<M, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    // `Ends` has one bounded set at least, so that this is no hypothesis to be checked.
    no_curve_is_shorter(Evidence::of(Statement::Proposition6_3), subject, known, seen)
}

fn no_curve_is_shorter<M, const D: usize>(
    evidence: Evidence,
    subject: &impl Subject,
    known: &Known<M, D>,
    seen: &Measured<D>,
) -> Evidence {
    let (off, rounding) = off_sets(subject, known, seen);
    let d2 = known.distance.powi(2);
    let (length2, energy) = (seen.length_squared(), seen.energy.value);
    let granted = seen.granted_energy() + 2.0 * known.distance * known.distance_error;
    evidence
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], rounding)
        .stated("d² ≤ L(γ)²", Unit::ENERGY, [d2, length2], granted)
        .stated("L(γ)² ≤ E(γ)", Unit::ENERGY, [length2, energy], granted)
}

/// Evaluates the second claim of Proposition 6.1 on a curve: if its energy is `d²`, it is a minimal
/// geodesic.
///
/// # Errors
///
/// [`MetricError`] where `H` is not finite, symmetric and positive definite.
#[doc(alias = "prop:geodesic_len_and_energy")]
pub fn prop_6_1_minimiser<M: Metric<D>, const D: usize>(
    subject: &impl Subject,
    known: &Known<M, D>,
    curve: &impl Curve<D>,
) -> Result<Evidence, MetricError> {
    let seen = Measured::of(&known.metric, curve);
    let residual = Residual::of(subject, &known.metric, curve)?;
    let (off, rounding) = off_sets(subject, known, &seen);
    let length = seen.granted_length() + known.distance_error;
    let granted = seen.granted_energy() + 2.0 * known.distance * known.distance_error;
    Ok(Evidence::of(Statement::Proposition6_1)
        .given("the ends lie in X⁽⁰⁾ and X⁽¹⁾", Unit::COORDINATE, [off, 0.0], rounding)
        .given("E(γ) ≤ d²", Unit::ENERGY, [seen.energy.value, known.distance.powi(2)], granted)
        .stated("L(γ) ≤ d", Unit::LENGTH, [seen.length.value, known.distance], length)
        .stated("d ≤ L(γ)", Unit::LENGTH, [known.distance, seen.length.value], length)
        .stated("γ̈ = −Γ(γ̇, γ̇)", Unit::COORDINATE, [residual.value, 0.0], residual.granted))
}

/// A pair of points of two sets, said to be a nearest one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestPair<const D: usize> {
    /// The two points, in `ℓ`.
    pub points: [SVector<f64, D>; 2],
    /// Their distance, in `m`.
    pub apart: f64,
    /// The distance of the two sets, in `m`.
    pub distance: f64,
    /// How much larger than the square of that the square of the pair's may be, in `m²`.
    pub excess: f64,
    /// How far the points are from their sets, in `ℓ`.
    pub off_sets: f64,
    /// `sup |x|` over a bounded one of the two sets, in `ℓ`; `None` if neither is bounded.
    pub radius: Option<f64>,
    /// The least distance of other pairs of points of the two sets, in `m`; `∞` if none was tried.
    pub sampled: f64,
    /// Whether both sets contain the limits of their sequences, as a
    /// [`ClosedSet`](tautline::ClosedSet) does.
    pub closed: bool,
    /// The length of the shortest curve from one of the points that leaves every compact set, in
    /// `m`; `∞` if and only if the space is complete.
    pub way_out: f64,
    /// What is granted, in `m²`.
    pub granted: f64,
}

impl<const D: usize> NearestPair<D> {
    /// Returns the ends of a computed minimiser of the trapezoidal rule, whose distance is `apart`:
    /// no more than the length of the curve that joins them, so that `excess` is of order `1/N`.
    /// `sampled` is the least distance of other pairs. The metric has a `c₁ > 0`, so that the space
    /// is complete (Proposition 3.3).
    #[must_use]
    pub fn of<M>(
        subject: &impl Subject,
        known: &Known<M, D>,
        seen: &Reconstruction<D>,
        apart: f64,
        sampled: f64,
    ) -> Self {
        let sequence = &seen.minimum.sequence;
        let sets = [known.ends.first(), known.ends.second()];
        Self {
            points: [*sequence.first(), *sequence.last()],
            apart,
            distance: known.distance,
            excess: subject.theorem_a_excess(seen.setting, seen.rule, seen.n),
            off_sets: seen.off_sets,
            radius: sets.iter().filter_map(|set| set.radius()).reduce(f64::min),
            sampled,
            closed: true,
            way_out: f64::INFINITY,
            granted: seen.granted,
        }
    }
}

/// Evaluates Proposition 6.2 on a pair: that it is a nearest one, and that it lies where the
/// nearest pairs are confined to, within `d/√c₁` of the bounded set.
///
/// Needs: closed sets, a bounded one, a complete space. `c1` is a lower bound of `H` at the two
/// points; where it is one everywhere, the space is complete (Proposition 3.3).
#[doc(alias = "prop:bounded_2sets_min")]
#[must_use]
pub fn prop_6_2<const D: usize>(pair: &NearestPair<D>, c1: f64) -> Evidence {
    let unbounded = if pair.radius.is_some() { 0.0 } else { 1.0 };
    let size = largest(pair.points.iter().map(|x| x.norm()));
    let d2 = pair.distance.powi(2) + pair.excess;
    let reach = (d2 / c1).sqrt();
    let room = pair.radius.map_or(f64::INFINITY, |radius| radius + reach);
    // The sets may touch, and then there is no reach to be rounded.
    let moved = if reach > 0.0 { 0.5 * pair.granted / (c1 * reach) } else { 0.0 };
    let granted = 1e-13 * size + moved;
    let open = if pair.closed { 0.0 } else { 1.0 };
    given_complete(Evidence::of(Statement::Proposition6_2), pair.way_out)
        .given("one of the sets is bounded", Unit::NONE, [unbounded, 0.0], 0.0)
        .given("the sets are closed", Unit::NONE, [open, 0.0], 0.0)
        .given("x ∈ X⁽⁰⁾ and y ∈ X⁽¹⁾", Unit::COORDINATE, [pair.off_sets, 0.0], 1e-13 * size)
        .stated("d(x, y)² ≤ d(X⁽⁰⁾, X⁽¹⁾)²", Unit::ENERGY, [pair.apart.powi(2), d2], pair.granted)
        .stated("|x|, |y| ≤ R + d/√c₁", Unit::COORDINATE, [size, room], granted)
        .sharper(
            "d(X⁽⁰⁾, X⁽¹⁾)² ≤ d(x, y)²",
            Unit::ENERGY,
            [pair.distance.powi(2), pair.apart.powi(2)],
            pair.granted,
        )
        .sharper(
            "d(X⁽⁰⁾, X⁽¹⁾)² ≤ d(x′, y′)² for other pairs",
            Unit::ENERGY,
            [pair.distance.powi(2), pair.sampled.powi(2)],
            pair.granted + 1e-13 * pair.distance.powi(2),
        )
}
