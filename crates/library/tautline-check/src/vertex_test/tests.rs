//! The vertex test where it is sharp, and against samples.

use nalgebra::{SMatrix, SVector};
use tautline_chance::{Random, cases, seed};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Scalar};

use super::{Decomposed, curvature, gram};

/// `2 I` and a wave in each entry.
struct Waves<const D: usize> {
    numbers: [[[f64; 6]; 4]; 4],
}

impl<const D: usize> Waves<D> {
    fn random(random: &mut Random) -> Self {
        let entry = |_| std::array::from_fn(|_| random.between(-1.0, 1.0));
        let mut flat: Vec<[f64; 6]> = (0..16).map(entry).collect();
        Self { numbers: std::array::from_fn(|_| std::array::from_fn(|_| flat.pop().expect("16"))) }
    }
}

impl<const D: usize> Metric<D> for Waves<D> {
    fn gram<S: Scalar>(&self, x: &SVector<S, D>) -> SMatrix<S, D, D> {
        SMatrix::from_fn(|i, j| {
            let numbers = &self.numbers[i.min(j)][i.max(j)];
            let mut phase = S::constant(numbers[4]);
            for k in 0..D {
                phase += x[k] * (2.0 * numbers[k]);
            }
            let wave = phase.sin() * (numbers[5] * 0.9 / D as f64);
            if i == j { wave + 2.0 } else { wave }
        })
    }
}

/// A cube of side `a` at a random place.
struct Place<const D: usize> {
    low: SVector<f64, D>,
    side: f64,
}

impl<const D: usize> Place<D> {
    fn cube(&self) -> SVector<Interval, D> {
        self.low.map(|t| Interval::new(t, t + self.side).expect("a side"))
    }

    fn corner(&self, bits: usize) -> SVector<f64, D> {
        SVector::from_fn(|i, _| self.low[i] + self.side * (bits >> i & 1) as f64)
    }

    /// Returns `ε = C a²/8`.
    fn shift(&self, curvature: f64) -> Interval {
        Interval::point(curvature) * (self.side * self.side / 8.0)
    }
}

/// Returns the bound at a corner.
fn at_corner<const D: usize>(
    formula: &Formula<D>,
    corner: &SVector<f64, D>,
    shift: Interval,
    p: &SVector<f64, D>,
) -> f64 {
    let s = Decomposed::new(gram(formula, &corner.map(Interval::point)), shift);
    let p: [Interval; D] = std::array::from_fn(|i| Interval::point(p[i]));
    s.map_or(f64::INFINITY, |s| s.inverse_square(&p))
}

fn against_samples<const D: usize>(fixed: u64, count: u32) {
    let mut random = Random(seed(fixed));
    let mut tightness = Vec::new();
    for _ in 0..cases(count) {
        let formula = Formula::record(&Waves::<D>::random(&mut random)).expect("no branches");
        let low = SVector::from_fn(|_, _| random.between(-2.0, 2.0));
        let place = Place { low, side: 2.0_f64.powf(random.between(-4.0, -0.5)) };
        let m = curvature(&formula, &place.cube());
        let shift = place.shift(m);
        // The affine function `p(x) = B y + p₀`, with `y` in the unit cube, on the whole cube.
        let slope: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-0.5, 0.5));
        let p0: SVector<f64, D> = SVector::from_fn(|_, _| random.between(-1.0, 1.0));
        let p = |y: &SVector<f64, D>| slope * y + p0;
        let unit = |bits: usize| SVector::from_fn(|i, _| (bits >> i & 1) as f64);
        let bound = (0..1 << D)
            .map(|bits| at_corner(&formula, &place.corner(bits), shift, &p(&unit(bits))))
            .fold(0.0, f64::max);
        let mut largest = 0.0_f64;
        for n in 0..60 {
            // Corners are where the largest value often is.
            let y = if n < 1 << D { unit(n) } else { SVector::from_fn(|_, _| random.unit()) };
            let x = place.low + y * place.side;
            let h: SMatrix<f64, D, D> = formula.gram(&x);
            let inverse = h.try_inverse().expect("definite");
            largest = largest.max(p(&y).dot(&(inverse * p(&y))));
            // And the second derivative itself, by differences.
            let e = SVector::<f64, D>::from_fn(|_, _| random.between(-1.0, 1.0)).normalize();
            let u = SVector::<f64, D>::from_fn(|_, _| random.between(-1.0, 1.0)).normalize();
            let form = |s: f64| u.dot(&(formula.gram(&(x + e * s)) * u));
            let step = 1e-4;
            let second = (form(step) - 2.0 * form(0.0) + form(-step)) / (step * step);
            // Rounding, divided by the square of the step, and the points beyond the cube.
            assert!(second <= m + 4e-3, "{second} > {m}");
        }
        assert!(largest <= bound * (1.0 + 1e-14), "{largest} > {bound}");
        if bound.is_finite() {
            tightness.push(bound / largest);
        }
    }
    tightness.sort_by(f64::total_cmp);
    let median = tightness[tightness.len() / 2];
    assert!(median < 1.5 && tightness.len() as u32 > count / 2, "{D}: {median}");
}

#[test]
fn no_sample_exceeds_the_bound() {
    against_samples::<1>(41, 200);
    against_samples::<2>(42, 200);
    against_samples::<3>(43, 100);
    against_samples::<4>(44, 60);
}

/// `H = (1 + M|x − c|²/2) I` and a constant `p`: the bound is `|p|²` itself, at the centre.
#[test]
fn the_bound_is_attained_at_the_centre_of_a_bowl() {
    fn check<const D: usize>(text: &str) {
        let formula = Formula::<D>::parse(text, &[]).expect("a formula");
        let place = Place { low: SVector::zeros(), side: 0.5 };
        let m = curvature(&formula, &place.cube());
        // It counts only the axes along which the metric bends.
        assert_eq!(m, 2.0 * text.matches("sqr").count() as f64);
        for bits in 0..1 << D {
            let p = SVector::from_fn(|i, _| (i + 1) as f64);
            let bound = at_corner(&formula, &place.corner(bits), place.shift(m), &p);
            let exact = p.norm_squared();
            assert!(bound >= exact && bound <= exact * (1.0 + 1e-12), "{bound} {exact}");
        }
    }
    check::<1>("(1 + sqr(x1 - 0.25)) I");
    check::<2>("(1 + sqr(x1 - 0.25) + sqr(x2 - 0.25)) I");
    check::<2>("(1 + sqr(x2 - 0.25)) I");
    check::<3>("(1 + sqr(x1 - 0.25) + sqr(x3 - 0.25)) I");
    check::<3>("(1 + sqr(x1 - 0.25) + sqr(x2 - 0.25) + sqr(x3 - 0.25)) I");
    check::<4>("(1 + sqr(x1-0.25) + sqr(x2-0.25) + sqr(x3-0.25) + sqr(x4-0.25)) I");
}

/// Forms of the array of second derivatives whose largest value is known.
#[test]
fn the_curvature_counts_each_axis_by_itself() {
    let of = |text: &str| {
        let formula = Formula::<2>::parse(text, &[]).expect("a formula");
        curvature(&formula, &SVector::repeat(Interval::new(-1.0, 1.0).expect("a side")))
    };
    // A concave metric needs no shift.
    assert_eq!(of("(9 - sqr(x1) - sqr(x2)) I"), 0.0);
    // `D²H = 2 e₁e₁ᵀ ⊗ e₁e₁ᵀ`.
    assert_eq!(of("[4 + sqr(x1), 0; 0, 4]"), 2.0);
    // An entry beside the diagonal counts twice: with `u = (1, 1)/√2` the form is `2 e₁²`.
    assert_eq!(of("[4, sqr(x1); sqr(x1), 4]"), 2.0);
    // A saddle bends upwards along one axis only, by `2 e₁² − 2 e₂²`.
    assert_eq!(of("(9 + sqr(x1) - sqr(x2)) I"), 2.0);
    // `D²H = 2 e₁e₁ᵀ ⊗ (e₁e₂ᵀ + e₂e₁ᵀ)`, which is at most `2 e₁² + 2 e₂²`.
    assert_eq!(of("[9 + 2*x1*x2, 0; 0, 9]"), 4.0);
    // Where the second derivative is unknown, so is the bound.
    assert!(of("sqrt(x1) I").is_nan() && of("(4 + sqrt(sqr(x1))) I").is_nan());
    // A maximum would ignore an unknown number, in whatever row.
    for rows in ["[s, 0; 0, 4]", "[4, 0; 0, s]", "[4, s; s, 4]"] {
        let formula = Formula::<2>::parse(&format!("s = 1 + sqrt(sqr(x1)); {rows}"), &[]);
        let formula = formula.expect("a formula");
        let cube = SVector::repeat(Interval::new(-0.5, 0.5).expect("a side"));
        assert!(curvature(&formula, &cube).is_nan(), "{rows}");
    }
}

/// A matrix that is not proved to be definite has no factors, and no square is negative.
#[test]
fn indefinite_matrices_have_no_decomposition() {
    let flat = SMatrix::<Interval, 2, 2>::from_diagonal_element(Interval::point(1.0));
    for shift in [1.0, 1.5, 1e300] {
        assert!(Decomposed::new(flat, Interval::point(shift)).is_none());
    }
    assert!(Decomposed::new(flat, Interval::UNDEFINED).is_none());
    assert!(Decomposed::new(flat, Interval::new(0.0, 1.0).expect("ends")).is_none());
    let mut saddle = flat;
    (saddle[(0, 1)], saddle[(1, 0)]) = (Interval::point(2.0), Interval::point(2.0));
    assert!(Decomposed::new(saddle, Interval::point(0.0)).is_none());
    let half = Decomposed::new(flat, Interval::point(0.5)).expect("definite");
    assert_eq!(half.inverse_square(&[Interval::point(1.0); 2]), 4.0);
    for unknown in [Interval::UNDEFINED, Interval::REALS] {
        assert_eq!(half.inverse_square(&[unknown; 2]), f64::INFINITY);
    }
}

/// The sum of the bounds along the axes is rounded up. Twice a number is exact, and so is the sum of
/// three in integers.
#[test]
fn the_sum_of_the_curvatures_is_rounded_up() {
    let mut random = Random(seed(45));
    let units = |x: f64| (x * 2.0_f64.powi(60)) as i128;
    let mut rounded = 0;
    for _ in 0..cases(200) {
        let [a, b, c] = [(); 3].map(|()| random.between(0.5, 1.0));
        let parameters = [("a", a), ("b", b), ("c", c)];
        let text = "(9 + a*sqr(x1) + b*sqr(x2) + c*sqr(x3)) I";
        let formula = Formula::<3>::parse(text, &parameters).expect("a formula");
        let cube = SVector::repeat(Interval::new(0.0, 1.0).expect("a side"));
        let found = curvature(&formula, &cube);
        let exact: i128 = [a, b, c].map(|x| units(2.0 * x)).iter().sum();
        assert!(units(found) >= exact && found <= 2.0 * (a + b + c) * (1.0 + 1e-14), "{found}");
        rounded += usize::from(units(found) > exact);
    }
    assert!(rounded > 10, "{rounded}");
}

/// For matrices and vectors of small integers the square is a quotient of integers.
#[test]
fn squares_of_integers_are_rounded_up() {
    let mut random = Random(seed(46));
    let mut below = |n: u64| (random.bits() % n) as i64;
    let mut seen = 0;
    for _ in 0..cases(1000) {
        let [a, b, c] = [1 + below(9), 1 + below(9), 1 + below(9)];
        let [d, e, f] = [below(7) - 3, below(7) - 3, below(7) - 3];
        let p = [below(19) - 9, below(19) - 9, below(19) - 9];
        let h = [[a, d, e], [d, b, f], [e, f, c]];
        // The adjugate, by cofactors in cyclic order.
        let cofactor = |i: usize, j: usize| {
            let (k, l, m, n) = ((i + 1) % 3, (i + 2) % 3, (j + 1) % 3, (j + 2) % 3);
            h[k][m] * h[l][n] - h[k][n] * h[l][m]
        };
        let determinant: i64 = (0..3).map(|j| h[0][j] * cofactor(0, j)).sum();
        if a * b - d * d <= 0 || determinant <= 0 {
            continue;
        }
        let pairs = (0..3).flat_map(|i| (0..3).map(move |j| (i, j)));
        let numerator: i64 = pairs.map(|(i, j)| p[i] * cofactor(i, j) * p[j]).sum();
        let matrix = SMatrix::<Interval, 3, 3>::from_fn(|i, j| Interval::point(h[i][j] as f64));
        let s = Decomposed::new(matrix, Interval::point(0.0)).expect("positive definite");
        let bound = s.inverse_square(&p.map(|p| Interval::point(p as f64)));
        let (numerator, determinant) = (numerator as f64, determinant as f64);
        // A fused operation is rounded once, which keeps its sign.
        assert!(bound.mul_add(determinant, -numerator) >= 0.0, "{h:?} {p:?}: {bound}");
        assert!(bound * determinant <= numerator + 1e-9 * determinant, "{h:?} {p:?}: {bound}");
        seen += 1;
    }
    assert!(seen > 100, "{seen}");
}
