//! Conversions between the numbers that programs report for a shortest curve.
//!
//! This library reports energies without a factor `½` over the time `[0, 1]`, so that the least
//! energy is the squared distance `d²`. A [`Convention`] converts between `d²` and what other
//! programs print.

/// A number that a program reports for a shortest curve, as a function of the distance `d`.
///
/// All of them assume a curve of constant speed: a minimiser of the energy has that, and of the
/// curves between the same ends it has the least of each number. For other curves
/// `L² ≤ T ∫ γ̇ᵀ H γ̇ dt`, so that [`squared_distance`](Convention::squared_distance) of an energy is
/// an upper bound on the squared length.
///
/// ```
/// use tautline::Convention;
///
/// // A program that minimises ½ ∫ γ̇ᵀ H γ̇ dt prints 18, a fast-marching code 6: the same curve.
/// let energy = Convention::HalfEnergy.squared_distance(18.0);
/// let time = Convention::Length.squared_distance(6.0);
/// assert_eq!((energy, time), (36.0, 36.0));
/// assert_eq!(Convention::HalfEnergy.of_squared_distance(36.0), 18.0);
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
#[doc(alias = "half")]
#[doc(alias = "arrival time")]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Convention {
    /// `∫₀¹ γ̇ᵀ H γ̇ dt = d²`, in `m²`: the energy of this library.
    Energy,
    /// `½ ∫₀¹ γ̇ᵀ H γ̇ dt = d²/2`, in `m²`: the energy of most books and of geomstats.
    HalfEnergy,
    /// `∫₀¹ (γ̇ᵀ H γ̇)^{1/2} dt = d`, in `m`: a length, or the arrival time of a front.
    Length,
    /// `∫₀ᵀ γ̇ᵀ H γ̇ dt = d²/T`, in `m²/s`: the energy of a curve that takes the time `T`.
    EnergyOver {
        /// The time `T`, in `s`, which is positive.
        time: f64,
    },
    /// `½ ∫₀ᵀ γ̇ᵀ H γ̇ dt = d²/2T`, in `m²/s`: the action of a free particle, and the usual cost of
    /// a control problem.
    HalfEnergyOver {
        /// The time `T`, in `s`, which is positive.
        time: f64,
    },
    /// `Σ Δₙᵀ H Δₙ ≈ d²/N`, in `m²`, with the steps `Δₙ = xₙ₊₁ − xₙ` of `N` chords: a discrete energy
    /// that is not divided by the length of a time step. It differs from `d²/N` by the error of the
    /// rule.
    SumOfSquares {
        /// The number of chords `N`, which is positive.
        n: usize,
    },
}

impl Convention {
    /// Returns `d²`, in `m²`, if the program reports `value`.
    ///
    /// Returns NaN if `value` is negative or NaN, if a time is not positive or not finite, or if
    /// `N` is 0.
    #[must_use]
    pub fn squared_distance(self, value: f64) -> f64 {
        // Written so that NaN stays NaN.
        if !(value >= 0.0) {
            return f64::NAN;
        }
        match self {
            Convention::Length => value * value,
            _ => value / self.per_squared_distance(),
        }
    }

    /// Returns what the program reports if the squared distance is `d2`, in `m²`.
    ///
    /// Returns NaN in the same cases as [`squared_distance`](Convention::squared_distance).
    #[must_use]
    pub fn of_squared_distance(self, d2: f64) -> f64 {
        if !(d2 >= 0.0) {
            return f64::NAN;
        }
        match self {
            Convention::Length => d2.sqrt(),
            _ => d2 * self.per_squared_distance(),
        }
    }

    /// Returns `d`, in `m`, if the program reports `value`. Returns NaN in the same cases as
    /// [`squared_distance`](Convention::squared_distance).
    #[must_use]
    pub fn distance(self, value: f64) -> f64 {
        match self {
            // Without the square, which could overflow.
            Convention::Length if value >= 0.0 => value,
            _ => self.squared_distance(value).sqrt(),
        }
    }

    /// Returns the number that an energy reports for `d² = 1`; NaN if its parameter is not allowed.
    fn per_squared_distance(self) -> f64 {
        let per = |time: f64| if time > 0.0 && time.is_finite() { 1.0 / time } else { f64::NAN };
        match self {
            Convention::Energy | Convention::Length => 1.0,
            Convention::HalfEnergy => 0.5,
            Convention::EnergyOver { time } => per(time),
            Convention::HalfEnergyOver { time } => 0.5 * per(time),
            Convention::SumOfSquares { n } => per(n as f64),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Convention;
    use crate::{Ends, Metric, Problem, Rule, SMatrix, SVector, Scalar, gallery::Bump};

    /// The curve `x(t) = 3t/T` under `H = 4` has `d = 6`; each number is computed from the integral
    /// or the sum that defines it.
    #[test]
    fn each_number_is_what_its_formula_says() {
        let (time, n) = (1.5, 8_usize);
        let speed: f64 = 3.0 / time;
        let unit = 4.0 * 3.0 * 3.0; // γ̇ᵀ H γ̇ over [0, 1]
        let over = time * 4.0 * speed * speed; // the same integrated over [0, T]
        let step: f64 = 3.0 / n as f64;
        let reported = [
            (Convention::Energy, unit),
            (Convention::HalfEnergy, 0.5 * unit),
            (Convention::Length, 2.0 * 3.0),
            (Convention::EnergyOver { time }, over),
            (Convention::HalfEnergyOver { time }, 0.5 * over),
            (Convention::SumOfSquares { n }, n as f64 * 4.0 * step * step),
        ];
        for (convention, value) in reported {
            // Two or three roundings.
            let close = |a: f64, b: f64| (a - b).abs() <= 3.0 * f64::EPSILON * b;
            assert!(close(convention.squared_distance(value), 36.0), "{convention:?} of {value}");
            assert!(close(convention.distance(value), 6.0), "{convention:?} of {value}");
            assert!(close(convention.of_squared_distance(36.0), value), "{convention:?}");
        }
    }

    /// The sums of a computed line, with and without the factors that other programs use.
    #[test]
    fn a_computed_line_is_reported_in_every_convention() {
        let bump = Bump::new(4.0, 0.5).expect("a width");
        let ends = Ends::points([-1.5, 0.05], [1.5, -0.1]).expect("finite");
        let line = Problem::new(bump, ends).solve(Rule::LEFT_ENDPOINT, 100).expect("solved");
        let points = line.sequence();
        // Σ ½ |N Δₙ|²_H / N at the first point of each chord, as geomstats computes it.
        let mut half = 0.0;
        let mut squares = 0.0;
        for (x, beta) in points.points().iter().zip(points.differences()) {
            let square = (beta.transpose() * line.metric().gram::<f64>(x) * beta)[0];
            half += square / 200.0;
            squares += square / 1e4;
        }
        let energy = line.discrete_energy();
        let close = |a: f64| (a - energy).abs() < 1e-12 * energy; // 100 terms
        assert!(close(Convention::HalfEnergy.squared_distance(half)));
        assert!(close(Convention::SumOfSquares { n: 100 }.squared_distance(squares)));
        assert!(close(Convention::Energy.squared_distance(energy)));
    }

    /// Only constant speed makes an energy a squared length.
    #[test]
    fn an_energy_bounds_a_squared_length_from_above() {
        struct Flat;
        impl Metric<1> for Flat {
            fn gram<S: Scalar>(&self, _: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
                SMatrix::identity()
            }
        }
        let ends = Ends::points([0.0], [1.0]).expect("finite");
        let line = Problem::new(Flat, ends).solve(Rule::TRAPEZOIDAL, 4).expect("solved");
        let length = line.length().value;
        assert!((Convention::Energy.distance(line.energy().value) - length).abs() < 1e-14);
        // x(t) = t² has the length 1 and the energy 4/3.
        let bound = Convention::Energy.squared_distance(4.0 / 3.0);
        assert!(bound > length * length * (1.0 + 1e-9));
    }

    #[test]
    fn bad_numbers_give_no_distance() {
        let good = Convention::HalfEnergy;
        for value in [-1.0, f64::NAN, f64::NEG_INFINITY] {
            for number in [good.squared_distance(value), good.distance(value)] {
                assert!(number.is_nan());
            }
            assert!(good.of_squared_distance(value).is_nan());
            assert!(Convention::Length.distance(value).is_nan());
            assert!(Convention::Length.of_squared_distance(value).is_nan());
        }
        let bad = [
            Convention::EnergyOver { time: 0.0 },
            Convention::EnergyOver { time: f64::INFINITY },
            Convention::HalfEnergyOver { time: -1.0 },
            Convention::HalfEnergyOver { time: f64::NAN },
            Convention::SumOfSquares { n: 0 },
        ];
        for convention in bad {
            assert!(convention.squared_distance(1.0).is_nan(), "{convention:?}");
            assert!(convention.of_squared_distance(1.0).is_nan(), "{convention:?}");
        }
        assert_eq!(Convention::Length.distance(1e200), 1e200);
        assert_eq!(Convention::Energy.squared_distance(0.0), 0.0);
    }
}
