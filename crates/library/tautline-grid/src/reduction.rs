//! Selling's decomposition of a symmetric positive definite matrix, `M = Σ λₖ eₖ eₖᵀ` with `λₖ ≥ 0`
//! and integer vectors `eₖ`.
//!
//! Along the `eₖ`, the eikonal equation for a metric with `H⁻¹ = M` becomes a sum of squares of upwind
//! differences. (Mirebeau, *Anisotropic fast marching on Cartesian grids using lattice basis
//! reduction*, 2014.)

use nalgebra::SMatrix;

/// A direction and its weight.
pub(crate) type Term<const D: usize> = ([i32; D], f64);

/// The most steps of the reduction. The number grows with the logarithm of the condition number.
const STEPS: usize = 200;

/// Returns the terms with positive weights. In more than three dimensions only the diagonal of `M`
/// counts.
pub(crate) fn selling<const D: usize>(m: &SMatrix<f64, D, D>) -> Vec<Term<D>> {
    let is_diagonal = (0..D * D).all(|at| at / D == at % D || m[(at / D, at % D)] == 0.0);
    let mut terms = match D {
        2 | 3 if !is_diagonal => obtuse(m),
        _ => (0..D).map(|i| (axis(i), m[(i, i)])).collect(),
    };
    terms.retain(|&(_, weight)| weight > 0.0);
    terms
}

fn axis<const D: usize>(i: usize) -> [i32; D] {
    std::array::from_fn(|j| i32::from(i == j))
}

fn obtuse<const D: usize>(m: &SMatrix<f64, D, D>) -> Vec<Term<D>> {
    let mut base: Vec<[i32; D]> = (0..D).map(axis).collect();
    base.push([-1; D]);
    let product = |a: &[i32; D], b: &[i32; D]| -> f64 {
        let terms = (0..D * D).map(|at| (at / D, at % D));
        terms.map(|(i, j)| f64::from(a[i]) * m[(i, j)] * f64::from(b[j])).sum()
    };
    let pairs: Vec<(usize, usize)> =
        (0..=D).flat_map(|i| (i + 1..=D).map(move |j| (i, j))).collect();
    let tolerance = 1e-12 * m.amax();
    for _ in 0..STEPS {
        let acute = pairs.iter().find(|&&(i, j)| product(&base[i], &base[j]) > tolerance);
        let Some(&(i, j)) = acute else { break };
        // The sum of the vectors stays zero.
        let turned = base[i];
        for (k, vector) in base.iter_mut().enumerate() {
            for c in 0..D {
                if k == i {
                    vector[c] = -turned[c];
                } else if k != j {
                    // In the plane, twice: the single remaining vector takes the whole change.
                    vector[c] += if D == 2 { 2 * turned[c] } else { turned[c] };
                }
            }
        }
    }
    let across = |i: usize, j: usize| -> [i32; D] {
        let rest: Vec<&[i32; D]> =
            (0..=D).filter(|&k| k != i && k != j).map(|k| &base[k]).collect();
        let entry = |c: usize| match rest[..] {
            [a] => {
                if c == 0 {
                    -a[1]
                } else {
                    a[0]
                }
            }
            [a, b] => {
                let (c1, c2) = ((c + 1) % 3, (c + 2) % 3);
                a[c1] * b[c2] - a[c2] * b[c1]
            }
            _ => 0,
        };
        std::array::from_fn(entry)
    };
    pairs.iter().map(|&(i, j)| (across(i, j), -product(&base[i], &base[j]))).collect()
}

#[cfg(test)]
mod tests {
    use nalgebra::SMatrix;
    use tautline_chance::{Random, seed};

    use super::selling;

    fn check<const D: usize>(number: u64) {
        let mut random = Random(seed(number));
        for _ in 0..200 {
            let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-1.0, 1.0));
            let m = a.transpose() * a + SMatrix::identity() * 1e-3;
            let mut sum = SMatrix::<f64, D, D>::zeros();
            for (e, weight) in selling(&m) {
                let e = SMatrix::<f64, D, 1>::from(e.map(f64::from));
                sum += e * e.transpose() * weight;
            }
            assert!((sum - m).amax() < 1e-9 * m.amax(), "{m} {sum}");
        }
    }

    /// The weights are positive and the sum is the matrix, for condition numbers up to a thousand.
    #[test]
    fn the_terms_sum_to_the_matrix() {
        check::<2>(1);
        check::<3>(2);
    }

    /// In other units the directions are the same ones, and a power of two changes the exponents of the
    /// weights only.
    #[test]
    fn the_directions_do_not_depend_on_the_unit() {
        fn in_units<const D: usize>(random: &mut Random) {
            let a: SMatrix<f64, D, D> = SMatrix::from_fn(|_, _| random.between(-1.0, 1.0));
            let m = a.transpose() * a + SMatrix::identity() * 1e-3;
            let terms = selling(&m);
            for exponent in [-200, -40, 40, 200] {
                let unit = 2.0_f64.powi(exponent);
                let scaled: Vec<_> = terms.iter().map(|(e, weight)| (*e, weight * unit)).collect();
                assert_eq!(selling(&(m * unit)), scaled, "2^{exponent} times {m}");
            }
        }
        let mut random = Random(seed(3));
        for _ in 0..50 {
            in_units::<1>(&mut random);
            in_units::<2>(&mut random);
            in_units::<3>(&mut random);
            in_units::<4>(&mut random);
        }
    }
}
