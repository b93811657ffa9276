//! Constants in two to seven dimensions, against the largest values that an ascent finds, and against
//! those of quadratic forms.

use nalgebra::{DMatrix, DVector, SVector};
use tautline_certify::{Accuracy, Cell, CertifiedConstants, CertifyError, Domain};
use tautline_chance::{Random, cases, seed};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::Jet2;

use crate::parsed;

/// The Gram matrix of a formula at a point, with its first and second derivatives.
struct Derivatives<const D: usize> {
    value: DMatrix<f64>,
    first: Vec<DMatrix<f64>>,
    /// `∂ₖ∂ₗH` at `(k, l)`.
    second: Vec<Vec<DMatrix<f64>>>,
}

impl<const D: usize> Derivatives<D> {
    fn at(formula: &Formula<D>, x: &[f64; D]) -> Self {
        let gram = formula.gram(&SVector::from(Jet2::variables(x)));
        let matrix = |of: &dyn Fn(&Jet2<f64, D>) -> f64| {
            DMatrix::from_fn(D, D, |i, j| of(&gram[(i.min(j), i.max(j))]))
        };
        let first = |k: usize| matrix(&|jet| jet.first(k));
        let second = |k: usize, l: usize| matrix(&|jet| jet.second(k, l));
        Self {
            value: matrix(&Jet2::value),
            first: (0..D).map(first).collect(),
            second: (0..D).map(|k| (0..D).map(|l| second(k, l)).collect()).collect(),
        }
    }

    /// Returns the least and the largest eigenvalue of `H`.
    fn eigenvalues(&self) -> (f64, f64) {
        let eigenvalues = self.value.symmetric_eigenvalues();
        (eigenvalues.min(), eigenvalues.max())
    }

    /// Returns `‖DH[w]‖` for a direction `w` of length 1, ascended from this one.
    fn slope(&self, mut w: DVector<f64>) -> f64 {
        let mut best = 0.0_f64;
        for _ in 0..40 {
            let along = sum(&self.first, &w);
            let (size, u) = largest(&along);
            best = best.max(size);
            let gradient = DVector::from_fn(D, |k, _| u.dot(&(&self.first[k] * &u)));
            w = gradient.try_normalize(0.0).unwrap_or(w);
        }
        best
    }

    /// Returns `‖D²H[w, w]‖` for a direction `w` of length 1, ascended from this one.
    fn curvature(&self, mut w: DVector<f64>) -> f64 {
        let mut best = 0.0_f64;
        for _ in 0..40 {
            let rows: Vec<DMatrix<f64>> = self.second.iter().map(|row| sum(row, &w)).collect();
            let (size, u) = largest(&sum(&rows, &w));
            best = best.max(size);
            let form = |k: usize, l: usize| u.dot(&(&self.second[k][l] * &u));
            w = largest(&DMatrix::from_fn(D, D, form)).1;
        }
        best
    }
}

fn sum(matrices: &[DMatrix<f64>], w: &DVector<f64>) -> DMatrix<f64> {
    let zero = DMatrix::zeros(w.len(), w.len());
    matrices.iter().zip(w.iter()).fold(zero, |sum, (matrix, w)| sum + matrix * *w)
}

/// Returns the norm of a symmetric matrix, and a unit vector at which it is attained.
fn largest(matrix: &DMatrix<f64>) -> (f64, DVector<f64>) {
    let eigen = matrix.clone().symmetric_eigen();
    let (k, size) = eigen.eigenvalues.map(f64::abs).argmax();
    (size, eigen.eigenvectors.column(k).into_owned())
}

/// Returns a random number less than `n`.
fn below(random: &mut Random, n: usize) -> usize {
    (random.bits() % n as u64) as usize
}

/// Returns a random expression of `d` coordinates, most of them of two or three.
fn expression(random: &mut Random, d: usize) -> String {
    let [a, b, c] = [(); 3].map(|()| 1 + below(random, d));
    let (k, m) = (random.between(0.2, 1.5), random.between(-0.4, 0.4));
    match below(random, 5) {
        0 => format!("{m}*sin({k}*x{a} + x{b})*x{c}"),
        1 => format!("{m}*x{a}*x{b}"),
        2 => format!("{m}*exp(-{k}*(x{a}^2 + x{b}^2))"),
        3 => format!("{m}*tanh(x{a} - {k}*x{b}*x{c})"),
        _ => format!("{m}*x{a}/(2 + x{b}^2)"),
    }
}

/// Returns a random positive definite matrix of expressions, or a multiple of the identity.
fn metric(random: &mut Random, d: usize) -> String {
    if below(random, 3) == 0 {
        let terms: Vec<String> = (0..d).map(|_| expression(random, d)).collect();
        return format!("{} + {} I", 2 * d, terms.join(" + "));
    }
    let upper = |i: usize, j: usize| format!("h{}_{}", i.min(j), i.max(j));
    let mut text = String::new();
    for (i, j) in (0..d).flat_map(|i| (i..d).map(move |j| (i, j))) {
        let entry = expression(random, d);
        let diagonal = if i == j { format!("{} + ", 4 + d) } else { String::new() };
        text += &format!("{} = {diagonal}{entry}; ", upper(i, j));
    }
    let row = |i: usize| (0..d).map(|j| upper(i, j)).collect::<Vec<_>>().join(", ");
    text + "[" + &(0..d).map(row).collect::<Vec<_>>().join("; ") + "]"
}

/// No value that an ascent from random points finds is beyond a proved constant.
fn no_value_is_beyond<const D: usize>(random: &mut Random, most: u32) {
    for _ in 0..cases(most) {
        let text = metric(random, D);
        let formula = parsed::<D>(&text);
        let lower: [f64; D] = std::array::from_fn(|_| random.between(-1.0, 1.0));
        let width = [0.02, 0.1, 0.4][below(random, 3)];
        let upper = lower.map(|x| x + width * random.between(0.5, 1.0));
        let cell = Domain::cell(Cell::new(lower, upper).expect("ordered"));
        let accuracy = Accuracy { tolerance: 0.02, budget: 60 };
        let proved = CertifiedConstants::within_budget(&formula, &cell, accuracy);
        let proved = proved.unwrap_or_else(|error| panic!("{text}: {error}"));
        let m_h = proved.m_h().map_or(f64::INFINITY, |m_h| m_h.upper);
        for _ in 0..24 {
            let x = std::array::from_fn(|i| match below(random, 3) {
                0 => lower[i],
                1 => upper[i],
                _ => random.between(lower[i], upper[i]),
            });
            let at = Derivatives::at(&formula, &x);
            let w = DVector::from_fn(D, |_, _| random.between(-1.0, 1.0)).normalize();
            let (least, most) = at.eigenvalues();
            let (slope, curvature) = (at.slope(w.clone()), at.curvature(w));
            // Rounding of the eigenvalues of a matrix of this size.
            let rounding = 1e-12 * most;
            let bounds = [
                ("c1", proved.c1().lower, least),
                ("c2", most, proved.c2().upper),
                ("L_H", slope, proved.l_h().upper),
                ("M_H", curvature, m_h),
            ];
            for (name, low, high) in bounds {
                assert!(low <= high + rounding, "{name}: {low} > {high} at {x:?} of {text}");
            }
        }
    }
}

#[test]
fn no_value_is_beyond_a_proved_constant() {
    let mut random = Random(seed(65));
    no_value_is_beyond::<2>(&mut random, 8);
    no_value_is_beyond::<4>(&mut random, 24);
    no_value_is_beyond::<5>(&mut random, 12);
    no_value_is_beyond::<6>(&mut random, 6);
    no_value_is_beyond::<7>(&mut random, 3);
}

/// `(c + xᵀAx/2) I` has the second derivative `A` and the slope `|Ax|`, which is largest at a corner.
fn forms_are_enclosed<const D: usize>(random: &mut Random) -> Result<(), CertifyError> {
    let mut a = DMatrix::zeros(D, D);
    for (i, j) in (0..D).flat_map(|i| (0..i).map(move |j| (i, j))) {
        a[(i, j)] = f64::from(below(random, 9) as u32) - 4.0;
        a[(j, i)] = a[(i, j)];
    }
    let product = |(i, j): (usize, usize)| format!("({})*x{}*x{}", a[(i, j)], i + 1, j + 1);
    let pairs = (0..D).flat_map(|i| (0..i).map(move |j| (i, j)));
    let sum = pairs.map(product).collect::<Vec<_>>().join(" + ");
    let formula = parsed::<D>(&format!("200 + {sum} I"));
    let cell = Domain::cell(Cell::new([0.5; D], [1.0; D])?);
    let accuracy = Accuracy { tolerance: 1e-9, budget: 4000 };
    let proved = CertifiedConstants::within_budget(&formula, &cell, accuracy)?;
    let norm = a.symmetric_eigenvalues().amax();
    let m_h = proved.m_h().expect("bounded");
    assert!((m_h.upper / norm - 1.0).abs() <= 1e-9, "{m_h:?} {norm}: {sum}");
    let corner = |k: usize| DVector::from_fn(D, |i, _| if k >> i & 1 == 1 { 1.0 } else { 0.5 });
    let steepest = (0..1 << D).map(|k| (&a * corner(k)).norm()).fold(0.0_f64, f64::max);
    let l_h = proved.l_h();
    assert!(l_h.upper >= steepest * (1.0 - 1e-12) && l_h.lower <= steepest * (1.0 + 1e-12));
    assert!(l_h.upper <= 1.5 * steepest, "{l_h:?} {steepest}: {sum}");
    Ok(())
}

#[test]
fn the_constants_of_quadratic_forms_are_enclosed() -> Result<(), CertifyError> {
    let mut random = Random(seed(66));
    for _ in 0..cases(8) {
        forms_are_enclosed::<3>(&mut random)?;
        forms_are_enclosed::<4>(&mut random)?;
        forms_are_enclosed::<5>(&mut random)?;
        forms_are_enclosed::<6>(&mut random)?;
    }
    Ok(())
}
