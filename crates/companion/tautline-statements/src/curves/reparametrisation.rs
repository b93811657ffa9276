//! `Reparametrised`: a curve with another clock.

use super::{Curve, Motion};

/// How a clock advances between two knots. After the fraction `τ` of the duration it has covered
/// the fraction `τ`, `τ²` or `τ² (3 − 2τ)` of the way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Pace {
    /// At constant speed: `τ`.
    Even,
    /// From rest, faster and faster: `τ²`.
    Accelerating,
    /// From rest to rest, once differentiable at the knots: `τ² (3 − 2τ)`.
    Smooth,
}

impl Pace {
    /// Returns the fraction of the way, with its first two derivatives.
    fn jet(self, t: f64) -> [f64; 3] {
        match self {
            Pace::Even => [t, 1.0, 0.0],
            Pace::Accelerating => [t * t, 2.0 * t, 2.0],
            Pace::Smooth => [t * t * (3.0 - 2.0 * t), 6.0 * t * (1.0 - t), 6.0 - 12.0 * t],
        }
    }

    /// Returns `∫₀¹ w′²`, where `w` is the fraction of the way.
    fn energy(self) -> f64 {
        match self {
            Pace::Even => 1.0,
            Pace::Accelerating => 4.0 / 3.0,
            Pace::Smooth => 6.0 / 5.0,
        }
    }
}

/// A continuous function `φ: [0, 1] → [0, 1]` with `φ(0) = 0` and `φ(1) = 1` through given knots.
/// It may pause or run backwards.
#[derive(Clone, Debug, PartialEq)]
pub struct Clock {
    /// Pairs of a time and a reading; the times increase from 0 to 1.
    knots: Vec<[f64; 2]>,
    pace: Pace,
}

impl Clock {
    /// Divides `[0, 1]` into intervals with lengths proportional to `durations`, and returns the
    /// clock with these readings between consecutive intervals. The readings 0 and 1 at the ends
    /// are added.
    ///
    /// `None` unless the durations are positive, the readings lie in `[0, 1]`, and there is one
    /// reading fewer than durations.
    #[must_use]
    pub fn new(durations: &[f64], readings: &[f64], pace: Pace) -> Option<Self> {
        let valid = durations.len() == readings.len() + 1
            && durations.iter().all(|&duration| duration > 0.0)
            && readings.iter().all(|reading| (0.0..=1.0).contains(reading));
        let total: f64 = durations.iter().sum();
        if !(valid && total.is_finite()) {
            return None;
        }
        let mut knots = vec![[0.0, 0.0]];
        let mut time = 0.0;
        for (duration, &reading) in durations.iter().zip(readings) {
            time += duration / total;
            knots.push([time, reading]);
        }
        knots.push([1.0, 1.0]);
        Some(Self { knots, pace })
    }

    /// Returns the clock through these knots, each a time and a reading.
    ///
    /// `None` unless the times increase from 0 to 1, and the readings stay in `[0, 1]` and begin
    /// with 0 and end with 1.
    #[must_use]
    pub fn through(knots: &[[f64; 2]], pace: Pace) -> Option<Self> {
        let ends = knots.first() == Some(&[0.0, 0.0]) && knots.last() == Some(&[1.0, 1.0]);
        let valid = knots.windows(2).all(|pair| pair[0][0] < pair[1][0])
            && knots.iter().all(|knot| (0.0..=1.0).contains(&knot[1]));
        (ends && valid).then(|| Self { knots: knots.to_vec(), pace })
    }

    /// Returns the clock that advances from 0 to 1 in one piece. If the pace is even, then
    /// `φ(t) = t`.
    #[must_use]
    pub fn plain(pace: Pace) -> Self {
        Self { knots: vec![[0.0, 0.0], [1.0, 1.0]], pace }
    }

    /// Returns the clock that pauses at the reading `½` from the time `⅓` to the time `⅔`.
    #[must_use]
    pub fn pausing() -> Self {
        Self::of_thirds(0.5, 0.5)
    }

    /// Returns the clock that advances to `¾`, runs back to `¼`, and advances to 1.
    #[must_use]
    pub fn turning_back() -> Self {
        Self::of_thirds(0.75, 0.25)
    }

    fn of_thirds(first: f64, second: f64) -> Self {
        let third = 1.0 / 3.0;
        let knots = vec![[0.0, 0.0], [third, first], [2.0 * third, second], [1.0, 1.0]];
        Self { knots, pace: Pace::Even }
    }

    /// Returns `φ`, `φ′` and `φ″` at a time.
    #[must_use]
    pub fn at(&self, t: f64) -> [f64; 3] {
        let after = self.knots.partition_point(|knot| knot[0] <= t).clamp(1, self.knots.len() - 1);
        let ([t0, s0], [t1, s1]) = (self.knots[after - 1], self.knots[after]);
        let (duration, way) = (t1 - t0, s1 - s0);
        let [w, first, second] = self.pace.jet(((t - t0) / duration).clamp(0.0, 1.0));
        [s0 + way * w, way * first / duration, way * second / (duration * duration)]
    }

    /// Returns `∫ |φ′|`, a pure number. It is 1 if and only if the clock never runs backwards.
    #[must_use]
    pub fn variation(&self) -> f64 {
        self.steps().map(|[_, way]| way.abs()).sum()
    }

    /// Returns `∫ φ′²`, a pure number. It is 1 if and only if `φ(t) = t`.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.steps().map(|[duration, way]| way * way / duration * self.pace.energy()).sum()
    }

    /// Returns the duration of the longest pause.
    #[must_use]
    pub fn longest_pause(&self) -> f64 {
        let paused = self.steps().filter(|[_, way]| *way == 0.0).map(|[duration, _]| duration);
        paused.fold(0.0, f64::max)
    }

    /// Returns the number of pieces between knots.
    #[must_use]
    pub fn pieces(&self) -> usize {
        self.knots.len() - 1
    }

    fn steps(&self) -> impl Iterator<Item = [f64; 2]> {
        self.knots.windows(2).map(|pair| [pair[1][0] - pair[0][0], pair[1][1] - pair[0][1]])
    }
}

/// The curve `γ ∘ φ`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reparametrised<'a, C> {
    /// The curve `γ`, without corners.
    pub curve: &'a C,
    /// The clock `φ`.
    pub clock: &'a Clock,
}

impl<C: Curve<D>, const D: usize> Curve<D> for Reparametrised<'_, C> {
    fn motion(&self, t: f64) -> Motion<D> {
        let [reading, first, second] = self.clock.at(t);
        let Motion { position, velocity, acceleration } = self.curve.motion(reading);
        Motion {
            position,
            velocity: velocity * first,
            acceleration: acceleration * (first * first) + velocity * second,
        }
    }

    fn corners(&self) -> Vec<f64> {
        let inner = &self.clock.knots[1..self.clock.knots.len() - 1];
        inner.iter().map(|knot| knot[0]).collect()
    }
}
