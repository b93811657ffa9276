//! The four Gauss points of an interval, and the integrals of their Lagrange polynomials.

/// The number of collocation points on each interval.
pub(crate) const STAGES: usize = 4;

/// Values at a fraction `τ` of an interval, for the polynomials `Lⱼ` of degree 3 with `Lⱼ(cᵢ) =
/// δᵢⱼ`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Weights {
    /// `τ`.
    pub(crate) fraction: f64,
    /// `Lⱼ(τ)`.
    pub(crate) value: [f64; STAGES],
    /// `∫₀^τ Lⱼ`.
    pub(crate) integral: [f64; STAGES],
    /// `∫₀^τ (τ − s) Lⱼ(s) ds`.
    pub(crate) double_integral: [f64; STAGES],
}

/// Returns the Gauss points in `[0, 1]`, the zeros of the Legendre polynomial of degree 4.
pub(crate) fn points() -> [f64; STAGES] {
    let root = (6.0_f64 / 5.0).sqrt();
    let [inner, outer] = [-1.0, 1.0].map(|sign| ((3.0 + sign * 2.0 * root) / 7.0).sqrt());
    [-outer, -inner, inner, outer].map(|x| 0.5 + 0.5 * x)
}

/// Returns the weights at the fraction `τ`.
pub(crate) fn weights(fraction: f64) -> Weights {
    let c = points();
    let mut weights = Weights {
        fraction,
        value: [0.0; STAGES],
        integral: [0.0; STAGES],
        double_integral: [0.0; STAGES],
    };
    for j in 0..STAGES {
        // The coefficients of Lⱼ, lowest power first.
        let mut polynomial = [1.0, 0.0, 0.0, 0.0];
        for k in (0..STAGES).filter(|&k| k != j) {
            let scale = 1.0 / (c[j] - c[k]);
            let before = polynomial;
            for power in 0..STAGES {
                let raised = if power > 0 { before[power - 1] } else { 0.0 };
                polynomial[power] = (raised - c[k] * before[power]) * scale;
            }
        }
        let mut power = 1.0;
        for (degree, coefficient) in polynomial.into_iter().enumerate() {
            let n = degree as f64;
            weights.value[j] += coefficient * power;
            power *= fraction;
            weights.integral[j] += coefficient * power / (n + 1.0);
            weights.double_integral[j] += coefficient * power * fraction / ((n + 1.0) * (n + 2.0));
        }
    }
    weights
}

/// All weights that a solve needs.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Table {
    /// At the Gauss points.
    pub(crate) stages: [Weights; STAGES],
    /// At the end of an interval; the integrals are the weights of the Gauss rule.
    pub(crate) end: Weights,
    /// Where the residual is sampled. It vanishes at the Gauss points and is nearly a multiple of
    /// `Π (τ − cⱼ)`, which is largest at the ends of the interval and has another extremum in its
    /// middle.
    pub(crate) samples: [Weights; 3],
}

impl Table {
    pub(crate) fn new() -> Self {
        Self {
            stages: points().map(weights),
            end: weights(1.0),
            samples: [0.0, 0.5, 1.0].map(weights),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Table, points, weights};

    /// The coefficients of the Lagrange polynomials are below 100, so that a sum rounds by `10⁻¹³`.
    const ROUNDING: f64 = 1e-13;

    /// The rule of Gauss with four points is exact up to degree 7, and the interpolation up to
    /// degree 3.
    #[test]
    fn the_weights_are_those_of_gauss() {
        for degree in 0..=8 {
            let sum: f64 =
                points().iter().zip(weights(1.0).integral).map(|(c, b)| b * c.powi(degree)).sum();
            let error = (sum - 1.0 / f64::from(degree + 1)).abs();
            assert_eq!(error < ROUNDING, degree < 8, "{degree}: {error:e}");
        }
        for tau in [0.0, 0.3, 1.0] {
            for n in 0..=3 {
                let w = weights(tau);
                let apply = |weights: [f64; 4]| -> f64 {
                    points().iter().zip(weights).map(|(c, b)| b * c.powi(n)).sum()
                };
                let once = f64::from(n + 1);
                let twice = once * f64::from(n + 2);
                assert!((apply(w.value) - tau.powi(n)).abs() < ROUNDING);
                assert!((apply(w.integral) - tau.powi(n + 1) / once).abs() < ROUNDING);
                assert!((apply(w.double_integral) - tau.powi(n + 2) / twice).abs() < ROUNDING);
            }
        }
    }

    /// Sampled finely, `Π (τ − cⱼ)` is nowhere larger than at the samples, of which both ends have
    /// the largest values. The one in the middle is the largest between the inner Gauss points.
    #[test]
    fn the_residual_is_sampled_where_it_is_largest() {
        let product = |tau: f64| points().iter().map(|c| tau - c).product::<f64>().abs();
        let samples = Table::new().samples.map(|sample| product(sample.fraction));
        let fractions = || (0..=1000).map(|k| f64::from(k) / 1000.0);
        let most = fractions().map(product).fold(0.0, f64::max);
        assert_eq!([samples[0], samples[2]].map(|value| value >= most - ROUNDING), [true; 2]);
        let [first, left, right, last] = points();
        let fractions_of = Table::new().samples.map(|sample| sample.fraction);
        assert!(fractions_of[0] < first && fractions_of[2] > last, "{fractions_of:?}");
        assert!((left..right).contains(&fractions_of[1]), "{fractions_of:?}");
        let inner = fractions().filter(|tau| (left..right).contains(tau)).map(product);
        let most = inner.fold(0.0, f64::max);
        assert!(most > 0.0 && samples[1] >= most - ROUNDING, "{samples:?} {most}");
        // The weights belong to the fractions.
        for sample in Table::new().samples {
            let at: f64 = points().iter().zip(sample.value).map(|(c, b)| b * c).sum();
            assert!((at - sample.fraction).abs() < ROUNDING);
        }
    }
}
