//! `Geodesic`: a geodesic over the time `[0, 1]`, with dense output.

use nalgebra::{SMatrix, SVector};
use tautline::{Jet1, Scalar};

use super::flow::Flow;

/// The derivatives of a position by time, of the orders 0 to 3, all in `ℓ`.
pub(crate) type Derivatives<const D: usize> = [SVector<f64, D>; 4];

/// One step of the integrator, with the derivatives at its ends.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Step<const D: usize> {
    pub(crate) begin: f64,
    pub(crate) end: f64,
    pub(crate) first: Derivatives<D>,
    pub(crate) last: Derivatives<D>,
}

impl<const D: usize> Step<D> {
    /// Evaluates the polynomial of degree 7 with these derivatives at the ends, and its derivative.
    ///
    /// With `s` from 0 to 1 along a step of length `h`, the term of `γ⁽ᵏ⁾(0)` is
    ///
    /// ```text
    /// hᵏ sᵏ/k! (1 − s)⁴ Σₘ (3 + m choose m) sᵐ,    m = 0, …, 3 − k
    /// ```
    ///
    /// since the sum is the Taylor polynomial of `(1 − s)⁻⁴`. The other end is its mirror image.
    fn at(&self, time: f64) -> [SVector<f64, D>; 2] {
        let h = self.end - self.begin;
        let [s] = Jet1::<f64, 1>::variables(&[(time - self.begin) / h]);
        let (ahead, back) = (terms(s, h), terms(1.0 - s, -h));
        let mut sums = [SVector::zeros(); 2];
        for k in 0..4 {
            sums[0] += self.first[k] * ahead[k].value() + self.last[k] * back[k].value();
            sums[1] += self.first[k] * ahead[k].first(0) + self.last[k] * back[k].first(0);
        }
        [sums[0], sums[1] / h]
    }
}

/// Returns the factors of the derivatives of the orders 0 to 3 at the end where `s = 0`.
fn terms(s: Jet1<f64, 1>, h: f64) -> [Jet1<f64, 1>; 4] {
    let far = (1.0 - s).sqr().sqr();
    let mut power = far;
    std::array::from_fn(|k| {
        let sum = [1.0, 4.0, 10.0, 20.0][..4 - k]
            .iter()
            .rev()
            .fold(Jet1::constant(0.0), |sum, &coefficient| sum * s + coefficient);
        let term = power * sum;
        power = power * s * (h / (k + 1) as f64);
        term
    })
}

/// A geodesic `γ(t) = exp_x(tv)` for `t ∈ [0, 1]`, with the derivatives of its end.
#[derive(Clone, Debug, PartialEq)]
pub struct Geodesic<const D: usize> {
    pub(crate) steps: Vec<Step<D>>,
    pub(crate) last: Flow<D>,
    /// `γ̇ᵀHγ̇` at both ends.
    pub(crate) squares: [f64; 2],
}

impl<const D: usize> Geodesic<D> {
    /// Returns the point `γ(t)`, in `ℓ`; `None` unless `0 ≤ t ≤ 1`.
    #[must_use]
    pub fn position(&self, t: f64) -> Option<SVector<f64, D>> {
        Some(self.at(t)?[0])
    }

    /// Returns the velocity `γ̇(t)`, in `ℓ`; `None` unless `0 ≤ t ≤ 1`.
    #[must_use]
    pub fn velocity(&self, t: f64) -> Option<SVector<f64, D>> {
        Some(self.at(t)?[1])
    }

    fn at(&self, t: f64) -> Option<[SVector<f64, D>; 2]> {
        if !(0.0..=1.0).contains(&t) {
            return None;
        }
        let number = self.steps.partition_point(|step| step.end < t);
        Some(self.steps.get(number).or(self.steps.last())?.at(t))
    }

    /// Returns the first point `γ(0)`, in `ℓ`.
    #[must_use]
    pub fn start(&self) -> SVector<f64, D> {
        self.steps[0].first[0]
    }

    /// Returns the last point `γ(1)`, in `ℓ`.
    #[must_use]
    pub fn end(&self) -> SVector<f64, D> {
        self.last.position
    }

    /// Returns the velocity `γ̇(0)`, in `ℓ`.
    #[must_use]
    pub fn initial_velocity(&self) -> SVector<f64, D> {
        self.steps[0].first[1]
    }

    /// Returns the velocity `γ̇(1)`, in `ℓ`.
    #[must_use]
    pub fn final_velocity(&self) -> SVector<f64, D> {
        self.last.velocity
    }

    /// Returns the energy `∫ γ̇ᵀHγ̇ dt`, in `m²`. The integrand is constant along a geodesic, and
    /// is evaluated at the start.
    #[must_use]
    pub fn energy(&self) -> f64 {
        self.squares[0]
    }

    /// Returns the length, in `m`: the root of the energy.
    #[must_use]
    pub fn length(&self) -> f64 {
        self.squares[0].sqrt()
    }

    /// Returns by how much `γ̇ᵀHγ̇` differs at the end from the energy, relative to the energy: a
    /// measure of the error of the integration. It is 0 for a curve that rests.
    #[must_use]
    pub fn drift(&self) -> f64 {
        let [first, last] = self.squares;
        if first == 0.0 { 0.0 } else { (last - first).abs() / first }
    }

    /// Returns the derivative of the end `exp_x(v)` by the start `x`, a pure number, with the
    /// coordinates of `v` kept.
    #[must_use]
    pub fn end_by_start(&self) -> SMatrix<f64, D, D> {
        self.last.position_by_position
    }

    /// Returns the derivative of the end `exp_x(v)` by `v`, a pure number. Its columns are Jacobi
    /// fields; it is singular if the ends are conjugate.
    #[must_use]
    pub fn end_by_velocity(&self) -> SMatrix<f64, D, D> {
        self.last.position_by_velocity
    }

    /// Returns the number of steps of the integrator.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.steps.len()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;

    use super::Step;

    /// Eight derivatives determine a polynomial of degree 7. The values are below 2 and the weights
    /// below 50, so that the rounding is below `10⁻¹³`.
    #[test]
    fn a_step_reproduces_polynomials_of_degree_seven() {
        let at = |t: f64| {
            let f = t.powi(7) - t.powi(3);
            let f1 = 7.0 * t.powi(6) - 3.0 * t.powi(2);
            let f2 = 42.0 * t.powi(5) - 6.0 * t;
            [
                vector![f, 1.0 - t],
                vector![f1, -1.0],
                vector![f2, 0.0],
                vector![210.0 * t.powi(4) - 6.0, 0.0],
            ]
        };
        let step = Step { begin: 0.25, end: 0.75, first: at(0.25), last: at(0.75) };
        for k in 0..=100 {
            let t = 0.25 + 0.005 * f64::from(k);
            let [position, velocity] = step.at(t);
            let exact = at(t);
            assert!((position - exact[0]).norm() < 1e-13, "{position} for {} at {t}", exact[0]);
            assert!((velocity - exact[1]).norm() < 1e-13, "{velocity} for {} at {t}", exact[1]);
        }
    }
}
