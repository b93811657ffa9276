//! The parameters that families share, and what lies beyond their ranges.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::super::{Beyond, Parameter};

/// The amplitude of a metric that allows any amplitude. `H` is constant for amplitude 0; as the
/// amplitude tends to `∞`, the constant part of `H` becomes negligible.
pub(super) fn amplitude(name: &'static str, most: f64) -> Parameter {
    let (zero, infinity) = match name {
        "L" => ("L → 0", "L → ∞"),
        _ => ("a → 0", "a → ∞"),
    };
    Parameter::logarithmic(name, 1e-4, most).with_ends(Beyond::Limit(zero), Beyond::Limit(infinity))
}

/// A relative amplitude. `H` is constant for amplitude 0 and degenerate for amplitude 1.
pub(super) fn part(name: &'static str, most: f64) -> Parameter {
    Parameter::fraction(name, 1e-4, most).with_ends(Beyond::Limit("a → 0"), Beyond::Limit("a → 1"))
}

/// The angle that splits an amplitude between two axes. At 0, all of it belongs to the first axis.
pub(super) fn share() -> Parameter {
    let beyond = Beyond::Nothing("H varies along one axis alone");
    Parameter::linear("psi", 0.0, FRAC_PI_2).with_ends(beyond, beyond)
}

/// Returns the amplitudes along the two axes.
pub(super) fn shared(amplitude: f64, share: f64) -> [f64; 2] {
    [amplitude * share.cos(), amplitude * share.sin()]
}

/// The ratio of two wave numbers. Far from 1, one of the two coordinates hardly changes the metric.
pub(super) fn ratio_of_waves() -> Parameter {
    Parameter::logarithmic("k2/k1", MOST_RATIO.recip(), MOST_RATIO)
        .with_ends(Beyond::Limit("k2/k1 → 0"), Beyond::Limit("k2/k1 → ∞"))
}

/// The largest ratio of two wave numbers.
const MOST_RATIO: f64 = 1e2;

/// Returns two wave numbers with this ratio. The larger one is 1, so that the shorter wave is the
/// unit of steps.
pub(super) fn wave_numbers(ratio: f64) -> [f64; 2] {
    [1.0 / ratio.max(1.0), ratio.min(1.0)]
}

/// A coordinate in which the metric has the period `2π`.
pub(super) fn phase(name: &'static str) -> Parameter {
    Parameter::periodic(name, TAU)
}

/// The length of a step (in a problem, the distance between the ends divided by `N`). It ranges
/// from nearly 0, where the metric is linear, to four periods.
///
/// The bound on a gap grows with the step, but the gap does not, so that no statement is tight for
/// long steps.
pub(super) fn step(name: &'static str) -> Parameter {
    let zero = match name {
        "step" => "step → 0",
        "step1" => "step1 → 0",
        _ => "step2 → 0",
    };
    Parameter::logarithmic(name, SHORTEST, 4.0 * TAU).starting(Beyond::Limit(zero))
}

/// The length of a step across two waves of any ratio, up to four periods of the longer wave.
pub(super) fn step_of_waves() -> Parameter {
    Parameter::logarithmic("step", SHORTEST, 4.0 * TAU * MOST_RATIO)
        .starting(Beyond::Limit("step → 0"))
}

/// The shortest step, which is nearly at the limit `step → 0`. With the constants of the valleys,
/// the overestimation there differs from its limit by some hundreds of `SHORTEST`, relatively.
const SHORTEST: f64 = 1e-5;

/// The length of a step on a ramp, or over valleys with walls between them. Long steps attain a
/// bound that is the ratio of `c₂` to `c₁`.
pub(super) fn any_step(longest: f64) -> Parameter {
    Parameter::logarithmic("step", SHORTEST, longest)
        .with_ends(Beyond::Limit("step → 0"), Beyond::Limit("step → ∞"))
}

/// The direction from one point of the plane to another.
pub(super) fn direction(name: &'static str) -> Parameter {
    Parameter::periodic(name, TAU)
}

/// The direction along the line, as a phase: forward in the first half of the period.
pub(super) fn way(name: &'static str) -> Parameter {
    Parameter::periodic(name, 2.0)
}

/// The part of the way between two points that has the given coordinate, as a phase: the start, the
/// middle or the end.
pub(super) fn anchor() -> Parameter {
    Parameter::periodic("anchor", 3.0)
}

/// Returns both ends of a way of this length, forward or backward, with its anchor at `x`.
pub(super) fn anchored(x: f64, anchor: f64, length: f64, way: f64) -> [f64; 2] {
    let from = x - 0.5 * anchor.floor() * along(length, way);
    [from, from + along(length, way)]
}

/// Returns the step of this length, forward or backward.
pub(super) fn along(length: f64, way: f64) -> f64 {
    if way < 1.0 { length } else { -length }
}

/// Returns the point at this distance from another point, in this direction.
pub(super) fn beside([x, y]: [f64; 2], length: f64, direction: f64) -> [f64; 2] {
    let (sin, cos) = direction.sin_cos();
    [x + length * cos, y + length * sin]
}

/// A point on the ramp. Far from its middle, the ramp is nearly flat.
pub(super) fn on_the_ramp() -> Parameter {
    Parameter::linear("x", -12.0, 12.0).with_ends(Beyond::Limit("x → −∞"), Beyond::Limit("x → ∞"))
}

/// A point of `[0, 1]`, where the constants of tents and inclines hold.
pub(super) fn inside(name: &'static str) -> Parameter {
    let beyond = Beyond::Nothing("the metric has its constants on [0, 1]");
    Parameter::linear(name, 0.0, 1.0).with_ends(beyond, beyond)
}

/// `N`. The bounds decrease like `1/√N`, so that statements are tight for few subintervals.
pub(super) fn n() -> Parameter {
    Parameter::whole("N", 1, 64).with_ends(Beyond::Nothing("N ≥ 1"), Beyond::Limit("N → ∞"))
}

#[cfg(test)]
mod tests {
    use super::wave_numbers;

    #[test]
    fn wave_numbers_have_their_ratio_and_the_larger_is_one() {
        assert_eq!([4.0, 1.0, 0.25].map(wave_numbers), [[0.25, 1.0], [1.0, 1.0], [1.0, 0.25]]);
    }
}
