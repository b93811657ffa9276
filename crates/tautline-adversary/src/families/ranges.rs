//! The parameters that families share, and what lies beyond their ranges.

use std::f64::consts::{FRAC_PI_2, TAU};

use super::super::{Beyond, Parameter};

/// The amplitude of a metric that may have any. `H` is constant at 0, and loses its constant part
/// at `∞`.
pub(super) fn amplitude(name: &'static str, most: f64) -> Parameter {
    let (zero, infinity) = match name {
        "L" => ("L → 0", "L → ∞"),
        _ => ("a → 0", "a → ∞"),
    };
    Parameter::logarithmic(name, 1e-4, most).with_ends(Beyond::Limit(zero), Beyond::Limit(infinity))
}

/// A relative amplitude: `H` is constant at 0, and degenerate at 1.
pub(super) fn part(name: &'static str, most: f64) -> Parameter {
    Parameter::fraction(name, 1e-4, most).with_ends(Beyond::Limit("a → 0"), Beyond::Limit("a → 1"))
}

/// The split of an amplitude between two axes, as an angle: at 0 all of it belongs to the first.
pub(super) fn share() -> Parameter {
    let beyond = Beyond::Nothing("H varies along one axis alone");
    Parameter::linear("psi", 0.0, FRAC_PI_2).with_ends(beyond, beyond)
}

/// The amplitudes along the two axes.
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

/// Two wave numbers of this ratio, the larger one 1: the shorter wave is the unit of steps.
pub(super) fn wave_numbers(ratio: f64) -> [f64; 2] {
    [1.0 / ratio.max(1.0), ratio.min(1.0)]
}

/// A coordinate in which the metric has the period `2π`.
pub(super) fn phase(name: &'static str) -> Parameter {
    Parameter::periodic(name, TAU)
}

/// The length of a step (in a problem, the distance of the ends over `N`): from nothing, where the
/// metric is linear, to four periods.
///
/// The bound on a gap grows with the step, and the gap does not: nothing is tight far out.
pub(super) fn step(name: &'static str) -> Parameter {
    let zero = match name {
        "step" => "step → 0",
        "step1" => "step1 → 0",
        _ => "step2 → 0",
    };
    Parameter::logarithmic(name, SHORTEST, 4.0 * TAU).starting(Beyond::Limit(zero))
}

/// A step among two waves of any ratio, up to four periods of the longer one.
pub(super) fn step_of_waves() -> Parameter {
    Parameter::logarithmic("step", SHORTEST, 4.0 * TAU * MOST_RATIO)
        .starting(Beyond::Limit("step → 0"))
}

/// A step this short is as good as the limit: for the constants of the valleys, some hundreds of it
/// are left on the way.
const SHORTEST: f64 = 1e-5;

/// A step on a ramp, or over valleys with walls between them: long steps attain a bound that is the
/// ratio of `c₂` and `c₁`.
pub(super) fn any_step(longest: f64) -> Parameter {
    Parameter::logarithmic("step", SHORTEST, longest)
        .with_ends(Beyond::Limit("step → 0"), Beyond::Limit("step → ∞"))
}

/// The direction from one point of the plane to another.
pub(super) fn direction(name: &'static str) -> Parameter {
    Parameter::periodic(name, TAU)
}

/// The two directions on the line, as a phase: forward for the first half.
pub(super) fn way(name: &'static str) -> Parameter {
    Parameter::periodic(name, 2.0)
}

/// Where the way between two points has its given coordinate, as a phase: at its start, in its
/// middle, or at its end.
pub(super) fn anchor() -> Parameter {
    Parameter::periodic("anchor", 3.0)
}

/// Both ends of a way of this length, forward or back, with its anchor at `x`.
pub(super) fn anchored(x: f64, anchor: f64, length: f64, way: f64) -> [f64; 2] {
    let from = x - 0.5 * anchor.floor() * along(length, way);
    [from, from + along(length, way)]
}

/// The step of this length, forward or back.
pub(super) fn along(length: f64, way: f64) -> f64 {
    if way < 1.0 { length } else { -length }
}

/// The point at this distance from another one, in this direction.
pub(super) fn beside([x, y]: [f64; 2], length: f64, direction: f64) -> [f64; 2] {
    let (sin, cos) = direction.sin_cos();
    [x + length * cos, y + length * sin]
}

/// A point of the ramp, which is nearly flat far from the middle.
pub(super) fn on_the_ramp() -> Parameter {
    Parameter::linear("x", -12.0, 12.0).with_ends(Beyond::Limit("x → −∞"), Beyond::Limit("x → ∞"))
}

/// A point of `[0, 1]`, where the constants of tents and inclines hold.
pub(super) fn inside(name: &'static str) -> Parameter {
    let beyond = Beyond::Nothing("the metric has its constants on [0, 1]");
    Parameter::linear(name, 0.0, 1.0).with_ends(beyond, beyond)
}

/// `N`: statements are tight for few subintervals, since the bounds fall like `1/√N`.
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
