//! Biquadratic forms, represented by quadratic forms up to forms that vanish on products.

use nalgebra::DMatrix;
use tautline_scalar::Scalar;

use super::{
    second_derivative::Second,
    spectral::{Direction, basis_with, congruent},
};

/// The matrix `B`, with the entry `b(k, l, i, j) = ∂ₖ∂ₗHᵢⱼ` at `(k, i), (l, j)`.
pub(super) fn flattened<T: Scalar>(
    b: impl Fn(usize, usize, usize, usize) -> T,
    d: usize,
) -> DMatrix<T> {
    DMatrix::from_fn(d * d, d * d, |row, column| b(row / d, column / d, row % d, column % d))
}

/// A matrix whose quadratic form vanishes on all `v ⊗ u`.
pub(super) struct Vanishing {
    /// With `k < l` and `i < j`: the factor of `2 zₖᵢ zₗⱼ − 2 zₖⱼ zₗᵢ`.
    factors: Second,
}

impl Vanishing {
    /// Returns the best factors for a form with its maximum at `u` and `v`, up to rounding.
    pub(super) fn for_maximum(b: &Second, at: &Direction) -> Self {
        let d = b.d;
        // The entries at (1, 1), (l, j), in the bases p and q whose first columns are v and u.
        let (p, q) = (basis_with(&at.v), basis_with(&at.u));
        let pairs = || (0..d).flat_map(|k| (0..d).map(move |m| (k, m)));
        let turned: Vec<_> = pairs().map(|(k, m)| congruent(&q, |i, j| b.at(k, m, i, j))).collect();
        let beside = DMatrix::from_fn(d, d, |l, j| {
            if l == 0 || j == 0 {
                return 0.0;
            }
            pairs().map(|(k, m)| p[(k, 0)] * p[(m, l)] * turned[k * d + m][(0, j)]).sum::<f64>()
        });
        // Rotated back: the sum over l and j of −beside times the antisymmetric parts of e₁ₗ and
        // e₁ⱼ.
        let factor = |k: usize, l: usize, i: usize, j: usize| {
            let mut sum = 0.0;
            for m in 1..d {
                for n in 1..d {
                    let minor_v = p[(k, 0)] * p[(l, m)] - p[(l, 0)] * p[(k, m)];
                    let minor_u = q[(i, 0)] * q[(j, n)] - q[(j, 0)] * q[(i, n)];
                    sum -= beside[(m, n)] * minor_v * minor_u;
                }
            }
            sum
        };
        let of = |k, l, i, j| if k < l && i < j { factor(k, l, i, j) } else { 0.0 };
        Self { factors: Second::from_fn(d, of) }
    }

    pub(super) fn add_to<T: Scalar>(&self, matrix: &mut DMatrix<T>) {
        let d = self.factors.d;
        let pairs = || (0..d).flat_map(|j| (0..j).map(move |i| (i, j)));
        for (k, l) in pairs() {
            for (i, j) in pairs() {
                let factor = T::constant(self.factors.at(k, l, i, j));
                for ((a, b), factor) in
                    [((k * d + i, l * d + j), factor), ((k * d + j, l * d + i), -factor)]
                {
                    matrix[(a, b)] += factor;
                    matrix[(b, a)] += factor;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{DVector, SMatrix};
    use proptest::{prelude::*, strategy::ValueTree, test_runner::TestRunner};

    use super::{DMatrix, Direction, Vanishing, flattened};
    use crate::constants::{
        eigenvalue_bound::eigen,
        second_derivative::{self, maximum},
        spectral::form,
    };

    type Second<const D: usize> = [[SMatrix<f64, D, D>; D]; D];

    fn second<const D: usize>() -> impl Strategy<Value = Second<D>> {
        proptest::collection::vec(-1.0..1.0_f64, D * D * D * D).prop_map(|entries| {
            let at = |k: usize, l, i, j| entries[((k * D + l) * D + i) * D + j];
            std::array::from_fn(|k| {
                std::array::from_fn(|l| {
                    SMatrix::from_fn(|i, j| at(k.min(l), k.max(l), i.min(j), i.max(j)))
                })
            })
        })
    }

    fn of<const D: usize>(b: &Second<D>) -> second_derivative::Second {
        second_derivative::Second::from_fn(D, |k, l, i, j| b[k][l][(i, j)])
    }

    fn matrix<const D: usize>(b: &Second<D>) -> DMatrix<f64> {
        flattened(|k, l, i, j| b[k][l][(i, j)], D)
    }

    fn unit(d: usize) -> impl Strategy<Value = DVector<f64>> {
        proptest::collection::vec(-1.0..1.0_f64, d)
            .prop_map(DVector::from_vec)
            .prop_filter_map("a direction", |u: DVector<f64>| u.try_normalize(0.1))
    }

    fn value<const D: usize>(b: &Second<D>, v: &DVector<f64>, u: &DVector<f64>) -> f64 {
        form(|k, l| form(|i, j| b[k][l][(i, j)], u), v)
    }

    fn changes_nothing<const D: usize>(
        b: Second<D>,
        c: Second<D>,
        [u, v, w, z]: [DVector<f64>; 4],
    ) -> Result<(), TestCaseError> {
        let place = DVector::from_fn(D * D, |r, _| v[r / D] * u[r % D]);
        let at = Direction { norm: 0.0, u: w, v: z };
        let mut sum = matrix(&b);
        for changed in [false, true] {
            if changed {
                Vanishing::for_maximum(&of(&c), &at).add_to(&mut sum);
            }
            // The tolerance covers some hundreds of roundings of numbers up to D⁴.
            let difference = (place.transpose() * &sum * &place)[0] - value(&b, &v, &u);
            prop_assert!(difference.abs() < 1e-13, "{difference:e}");
        }
        Ok(())
    }

    /// Returns the maximum found and the bound on it.
    fn bound<const D: usize>(b: &Second<D>) -> (f64, f64) {
        let found = maximum(&of(b)).expect("finite");
        let mut sum = matrix(b);
        Vanishing::for_maximum(&of(b), &found).add_to(&mut sum);
        (found.norm, eigen(&sum).expect("finite").eigenvalues.max())
    }

    proptest! {
        #![proptest_config(tautline_chance::config(3, 256))]
        #[test]
        fn what_is_added_vanishes_on_products_in_the_plane(
            b in second::<2>(), c in second::<2>(), at in [unit(2), unit(2), unit(2), unit(2)],
        ) {
            changes_nothing(b, c, at)?;
        }

        #[test]
        fn what_is_added_vanishes_on_products_in_space(
            b in second::<3>(), c in second::<3>(), at in [unit(3), unit(3), unit(3), unit(3)],
        ) {
            changes_nothing(b, c, at)?;
        }

        #[test]
        fn what_is_added_vanishes_on_products_in_four_dimensions(
            b in second::<4>(), c in second::<4>(), at in [unit(4), unit(4), unit(4), unit(4)],
        ) {
            changes_nothing(b, c, at)?;
        }

        #[test]
        fn the_bound_is_the_maximum_in_the_plane(b in second::<2>()) {
            let angle = |step: i32| {
                let (sin, cos) = (f64::from(step) * std::f64::consts::PI / 400.0).sin_cos();
                DVector::from_column_slice(&[cos, sin])
            };
            let pairs = (0..400).flat_map(|s| (0..400).map(move |t| (s, t)));
            let most = pairs.map(|(s, t)| value(&b, &angle(s), &angle(t))).fold(f64::MIN, f64::max);
            let (found, bound) = bound(&b);
            // Between the sampled angles the form is larger by at most 2 (π/800)² of its largest
            // entry, times 8.
            prop_assert!(most <= bound + 1e-13 && found <= bound + 1e-13);
            prop_assert!(bound <= most + 3e-4, "{most} {found} {bound}");
            // If the maximum is found exactly, the bound is exact too.
            prop_assert!(bound - found < 1e-8 || found < most, "{found} {bound}");
        }
    }

    /// For three by three variables the bound is not exact, and the choice is a guess. The measured
    /// mean overestimation is 2.6 %; without the choice it is 13 %.
    #[test]
    fn the_bound_is_nearly_the_maximum_in_space() {
        const CASES: u32 = 512;
        let mut runner = TestRunner::new(tautline_chance::config(402, CASES));
        let mut sum = 0.0;
        let cases = tautline_chance::cases(CASES);
        for _ in 0..cases {
            let b = second::<3>().new_tree(&mut runner).expect("a case").current();
            let (found, bound) = bound(&b);
            assert!(found <= bound * (1.0 + 1e-14), "{found} {bound}");
            sum += bound / found;
        }
        let mean = sum / f64::from(cases);
        assert!(mean < 1.05, "{mean}");
    }
}
