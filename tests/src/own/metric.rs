//! A user's metric, given by a formula and its constants.

use tautline::{
    Bounded, Constants, Ends, Metric, Problem, Rule, SMatrix, SVector, Scalar, christoffel,
};

/// `H(x) = diag(1 + ½ sin² x₁, 2)`.
#[derive(Clone, Copy, Debug)]
struct Sheet;

impl Metric<2> for Sheet {
    fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
        let first = x[0].sin().sqr() * 0.5 + 1.0;
        SMatrix::from_diagonal(&SVector::from([first, S::constant(2.0)]))
    }
}

impl Bounded<2> for Sheet {
    /// `L_H = ½`, since `(½ sin² x)′ = ½ sin 2x`.
    fn constants(&self) -> Constants {
        Constants::new(1.0, 2.0, 0.5).expect("in order")
    }
}

/// `d²` from `(0.2, 0)` to `(2.5, 1)`, to 21 digits. The metric is a product, so `d²` is
/// `(E(2.5|m) − E(0.2|m))² + 2` with the incomplete elliptic integral of the second kind and the
/// parameter `m = −½`.
const D2: f64 = 8.97778203566217551435;

fn estimate(rule: Rule, n: usize) -> tautline::Estimate {
    let problem = Problem::new(Sheet, Ends::points([0.2, 0.0], [2.5, 1.0]).expect("finite"));
    let line = problem.solve(rule, n).expect("a metric");
    assert!(line.minimum().is_local_minimum());
    line.distance_squared_estimate().expect("several grids")
}

/// The values on the grids 16, 63, 250 and 1000 extrapolate to `d²`. For the trapezoidal rule the
/// terms up to `N⁻⁸` are removed, for the left rule those up to `N⁻⁴`.
#[test]
fn a_users_metric_extrapolates_to_its_distance() {
    let trapezoidal = estimate(Rule::TRAPEZOIDAL, 1000);
    // The remaining error of order 16⁻² 63⁻² 250⁻² 1000⁻² is below rounding, which is 20 ulps of 9.
    assert!((trapezoidal.value - D2).abs() <= 4e-14, "{:e}", trapezoidal.value - D2);
    let left = estimate(Rule::LEFT_ENDPOINT, 1000);
    // The error is 1/(16 · 63 · 250 · 1000) = 4e-9 times a constant of size 1.
    assert!((left.value - D2).abs() <= 1e-8, "{:e}", left.value - D2);
    for estimate in [trapezoidal, left] {
        let error = (estimate.value - D2).abs();
        // The estimated error may be too small, but only by rounding or a factor of 10.
        assert!(error <= 10.0 * estimate.error + 4e-14, "{error:e} beside {:e}", estimate.error);
    }
}

/// The derivative is not written by hand. `Γ¹₁₁ = ½ (log H₁₁)′ = ¼ sin 2x₁ / H₁₁`, and all other
/// symbols are 0.
#[test]
fn a_users_metric_has_christoffel_symbols() {
    let x = SVector::from([0.7, -3.0]);
    let symbols = christoffel(&Sheet, &x).expect("a metric");
    let expected = 0.25 * 1.4_f64.sin() / (1.0 + 0.5 * 0.7_f64.sin().powi(2));
    approx::assert_relative_eq!(symbols[0][(0, 0)], expected, max_relative = 1e-14);
    let sum: f64 = symbols.iter().map(|matrix| matrix.abs().sum()).sum();
    assert_eq!(sum, symbols[0][(0, 0)].abs());
}
