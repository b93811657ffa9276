//! An upper bound on the largest eigenvalue of a symmetric matrix on a box.

use nalgebra::{DMatrix, Dyn, SymmetricEigen};
use num_traits::{One, Zero};
use tautline_scalar::{Interval, Scalar};

/// Enclosures of a symmetric matrix `S(x)` on a box.
pub(crate) struct Enclosed {
    /// Enclosure of `S` at the midpoint of the box.
    pub(crate) centre: DMatrix<Interval>,
    /// Enclosure of `S` on the whole box.
    pub(crate) value: DMatrix<Interval>,
    /// Enclosures of `∂ₖ S` on the whole box.
    pub(crate) slopes: Vec<DMatrix<Interval>>,
    /// Enclosures of `xₖ − mₖ` for `x` in the box, with midpoint `m`, in `ℓ`.
    pub(crate) offsets: Vec<Interval>,
}

/// Returns an upper bound on the largest eigenvalue of `S(x)` for all `x` in the box, `∞` or NaN if
/// there is none, and the largest eigenvalue at the midpoint, up to rounding, or NaN.
///
/// Let `m` be the midpoint of the box. The columns of `Q` are eigenvectors, computed in doubles, of
/// the matrix of the midpoints of the intervals that enclose `S(m)`. Then `B = Qᵀ S Q` is nearly
/// diagonal. If the eigenvalues are simple, the off-diagonal entries affect them only to second
/// order in the size of the box. Two enclosures of `B` are intersected: the
/// mean value form `Qᵀ S(m) Q + Σ Qᵀ ∂ₖS Q (xₖ − mₖ)` and `Qᵀ S Q` itself. Then [`rayleigh`] bounds
/// `zᵀBz / zᵀz`, and `yᵀSy / yᵀy = zᵀBz / zᵀQᵀQz` for `y = Qz`. The bound holds for any `Q`.
pub(crate) fn largest_eigenvalue(s: &Enclosed) -> (f64, f64) {
    let n = s.centre.nrows();
    let middle = s.centre.map(|entry| entry.midpoint());
    let Some(eigen) = eigen(&middle) else { return (f64::NAN, f64::NAN) };
    let q = eigen.eigenvectors;
    // What overflows has no value.
    let is_finite = s.centre.iter().all(|entry| entry.is_finite());
    let greatest = if is_finite { eigen.eigenvalues.max() } else { f64::NAN };
    if !(q.amax() <= 2.0) {
        return (f64::NAN, greatest);
    }
    let mut taylor = rotated(&s.centre, &q);
    for (slope, &offset) in s.slopes.iter().zip(&s.offsets) {
        if !(offset.lo() == 0.0 && offset.hi() == 0.0) {
            taylor += rotated(slope, &q).map(|entry| entry * offset);
        }
    }
    let plain = rotated(&s.value, &q);
    // Both enclosures contain the true entries, so they intersect unless one is undefined.
    let b = taylor.zip_map(&plain, |x, y| x.intersection(y).unwrap_or(Interval::UNDEFINED));
    let bound = rayleigh(&b);
    // QᵀQ is the identity up to rounding. The row sums of the defect bound its eigenvalues.
    let mut defect = rotated(&DMatrix::identity(n, n), &q);
    for i in 0..n {
        defect[(i, i)] -= Interval::one();
    }
    let row = |i: usize| {
        defect.row(i).iter().fold(Interval::zero(), |sum, x| sum + Interval::point(x.magnitude()))
    };
    let spread = (0..n).map(|i| row(i).hi()).fold(0.0, f64::max);
    let stretch = Interval::one() + Interval::new(-spread, spread).unwrap_or(Interval::UNDEFINED);
    ((Interval::point(bound) / stretch).hi(), greatest)
}

/// Returns an enclosure of `Qᵀ A Q`, for a symmetric `A` and entries of `Q` of at most 2.
///
/// The entries are split into midpoints and radii, `A = M ± R`. Two products in doubles give `QᵀMQ`
/// with an error of at most `(2n + 1) u |Q|ᵀ|M||Q|`, where `u = 2⁻⁵³`, since a sum of `n ≤ 1000`
/// products has an error of at most `n u/(1 − n u)` of the sum of their absolute values. The result
/// is therefore within `|Q|ᵀ(R + (2n + 1) u |M|)|Q|` of `QᵀAQ`. This radius is a sum of numbers that
/// are not negative, so its own relative error is below `(2n + 4) u`. Products of doubles take a
/// tenth of the time of products of intervals.
fn rotated(a: &DMatrix<Interval>, q: &DMatrix<f64>) -> DMatrix<Interval> {
    let n = q.nrows();
    let is_zero = |entry: &Interval| entry.magnitude() == 0.0;
    // Half-lines have no midpoint, and nothing is gained for a few entries.
    if n <= 2 || a.iter().all(is_zero) || !a.iter().all(|entry| entry.is_finite()) {
        return turned(a, q);
    }
    let relative = (2 * n + 4) as f64 * (0.5 * f64::EPSILON);
    let middle = a.map(|entry| entry.midpoint());
    let radius = a.zip_map(&middle, |entry, middle| {
        (entry.hi() - middle).max(middle - entry.lo()).next_up() + relative * middle.abs()
    });
    let (middle, radius) = (turned(&middle, q), turned(&radius, &q.map(f64::abs)));
    middle.zip_map(&radius, |middle, radius| {
        // What underflows is less than 16 n² times the least double.
        let radius = radius * (1.0 + 2.0 * relative) + f64::MIN_POSITIVE;
        Interval::new((middle - radius).next_down(), (middle + radius).next_up())
            .unwrap_or(Interval::UNDEFINED)
    })
}

/// Returns `Qᵀ A Q` for a symmetric `A`, by sums in a fixed order. A library's product of large
/// matrices may depend on the processor.
fn turned<T: Scalar>(a: &DMatrix<T>, q: &DMatrix<f64>) -> DMatrix<T> {
    let n = q.nrows();
    let mut times = DMatrix::from_element(n, n, T::zero());
    for j in 0..n {
        for k in 0..n {
            let factor = q[(k, j)];
            for i in 0..n {
                times[(i, j)] += a[(i, k)] * factor;
            }
        }
    }
    let mut result = DMatrix::from_element(n, n, T::zero());
    for j in 0..n {
        for i in 0..=j {
            let entry = (0..n).fold(T::zero(), |sum, k| sum + times[(k, j)] * q[(k, i)]);
            result[(i, j)] = entry;
            result[(j, i)] = entry;
        }
    }
    result
}

/// Returns an upper bound on `zᵀBz / zᵀz` for all symmetric `B` within the entries; NaN if an entry
/// is undefined.
///
/// The quotient is at most `|z|ᵀ C |z| / zᵀz`, where `Cᵢᵢ` is the upper end of `Bᵢᵢ` and `Cᵢⱼ` the
/// largest `|Bᵢⱼ|`. The off-diagonal entries of `C` are not negative, so its largest eigenvalue is
/// at most `maxᵢ Σⱼ Cᵢⱼ tⱼ / tᵢ` for any positive `t` (Collatz–Wielandt). Equality holds if `t` is
/// the corresponding eigenvector, so the code takes this eigenvector for `t`, up to rounding.
fn rayleigh(b: &DMatrix<Interval>) -> f64 {
    let n = b.nrows();
    let c =
        DMatrix::from_fn(n, n, |i, j| if i == j { b[(i, i)].hi() } else { b[(i, j)].magnitude() });
    let Some(eigen) = eigen(&c) else { return f64::NAN };
    // If the matrix is reducible, the eigenvector has zeros; t must be positive.
    let t = eigen.eigenvectors.column(eigen.eigenvalues.imax()).map(|t| t.abs().max(1e-9));
    let row = |i: usize| {
        let terms = (0..n).map(|j| {
            let weight = if i == j { Interval::one() } else { Interval::point(t[j]) / t[i] };
            weight * c[(i, j)]
        });
        terms.fold(Interval::zero(), |sum, term| sum + term).hi()
    };
    (0..n)
        .map(row)
        .fold(f64::NEG_INFINITY, |most, row| if row > most || row.is_nan() { row } else { most })
}

/// Returns the eigenvalues and eigenvectors of a symmetric matrix, up to rounding, or `None` if an
/// entry is not finite.
pub(crate) fn eigen(matrix: &DMatrix<f64>) -> Option<SymmetricEigen<f64, Dyn>> {
    let scale = matrix.amax();
    if !matrix.iter().all(|x| x.is_finite()) {
        return None;
    }
    if scale == 0.0 {
        return Some(SymmetricEigen::new(matrix.clone()));
    }
    // The matrix is scaled so that no square overflows or underflows.
    let mut eigen = SymmetricEigen::new(matrix / scale);
    eigen.eigenvalues *= scale;
    Some(eigen)
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, dmatrix};
    use proptest::prelude::*;
    use tautline_scalar::Interval;

    use super::{Enclosed, eigen, rayleigh, rotated, turned};

    fn largest_eigenvalue(s: &Enclosed) -> f64 {
        super::largest_eigenvalue(s).0
    }

    fn interval(lo: f64, hi: f64) -> Interval {
        Interval::new(lo, hi).expect("in order")
    }

    fn top(matrix: &DMatrix<f64>) -> f64 {
        eigen(matrix).expect("finite").eigenvalues.max()
    }

    /// Returns enclosures of `S(x) = A + x B` for `|x| ≤ width`.
    fn linear(a: &DMatrix<f64>, b: &DMatrix<f64>, width: f64) -> Enclosed {
        let x = interval(-width, width);
        Enclosed {
            centre: a.map(Interval::point),
            value: a.zip_map(b, |a, b| Interval::point(a) + x * b),
            slopes: vec![b.map(Interval::point)],
            offsets: vec![x],
        }
    }

    fn symmetric(n: usize) -> impl Strategy<Value = DMatrix<f64>> {
        proptest::collection::vec(-1.0..1.0_f64, n * n)
            .prop_map(move |e| DMatrix::from_fn(n, n, |i, j| e[i.min(j) * n + i.max(j)]))
    }

    proptest! {
        #![proptest_config(tautline_chance::config(1, 256))]
        #[test]
        fn no_eigenvalue_exceeds_the_bound(
            (a, b) in (1..5_usize).prop_flat_map(|n| (symmetric(n), symmetric(n))),
            width in prop_oneof![Just(0.0), Just(1e-3), 0.0..1.0_f64],
            scale in prop_oneof![Just(1.0), Just(1e-300), Just(1e200)],
        ) {
            let (a, b) = (a * scale, b * scale);
            let bound = largest_eigenvalue(&linear(&a, &b, width));
            for step in -4..=4 {
                let eigenvalue = top(&(&a + &b * (width * f64::from(step) / 4.0)));
                // The computed eigenvalue is itself rounded, by a few ε of the matrix.
                prop_assert!(eigenvalue <= bound + 1e-14 * scale, "{eigenvalue} > {bound}");
            }
        }
    }

    #[test]
    fn the_bound_is_of_second_order_where_eigenvalues_are_simple() {
        let a = dmatrix![2.0, 1.0, 0.0; 1.0, -1.0, 0.5; 0.0, 0.5, 0.0];
        let b = dmatrix![0.0, 1.0, 1.0; 1.0, 0.0, -1.0; 1.0, -1.0, 0.0];
        let excess = |width: f64| {
            let most = (-50..=50).map(|i| top(&(&a + &b * (width * f64::from(i) / 50.0))));
            largest_eigenvalue(&linear(&a, &b, width)) - most.fold(f64::MIN, f64::max)
        };
        let [coarse, fine] = [0.04, 0.004].map(excess);
        // Measured: 1.5e-3 and 1.6e-5, thus 100 times less in a box ten times smaller.
        assert!(fine > 0.0 && fine < 0.015 * coarse, "{coarse:e} {fine:e}");
        // At a point the bound is exact, up to rounding.
        let at_a_point = largest_eigenvalue(&linear(&a, &b, 0.0)) / top(&a) - 1.0;
        assert!((0.0..1e-14).contains(&at_a_point), "{at_a_point:e}");
    }

    /// Dyadic matrices whose eigenvalues are known exactly, made by reflections along
    /// `(±1, ±1, ±1, ±1)`. The bound is never below the largest eigenvalue, not even by a rounding
    /// error, although the eigenvectors in use are orthonormal only up to rounding.
    #[test]
    fn no_bound_is_below_an_eigenvalue_that_is_known_exactly() {
        let reflection = |signs: u32| {
            let v = |i: usize| if signs >> i & 1 == 0 { 1.0 } else { -1.0 };
            DMatrix::from_fn(4, 4, |i, j| f64::from(u8::from(i == j)) - 0.5 * v(i) * v(j))
        };
        for case in 0..400_u32 {
            let digit = |k: u32| f64::from(case.wrapping_mul(2_654_435_761) >> (5 * k) & 31);
            let shift = if case % 3 == 0 { -40.0 } else { -7.0 };
            let eigenvalues: Vec<f64> = (0..4).map(|k| digit(k) + shift).collect();
            let q = reflection(case % 8) * reflection(case / 8 % 8);
            let diagonal = DMatrix::from_fn(4, 4, |i, j| if i == j { eigenvalues[i] } else { 0.0 });
            let scale = 2.0_f64.powi(case as i32 % 90 - 45);
            let a = &q * diagonal * q.transpose() * scale;
            let most = eigenvalues.iter().copied().fold(f64::MIN, f64::max) * scale;
            let size = eigenvalues.iter().fold(0.0_f64, |size, x| size.max(x.abs())) * scale;
            let bound = largest_eigenvalue(&linear(&a, &a, 0.0));
            // The margin allows for double eigenvalues, which have no unique eigenvector.
            assert!(most <= bound && bound <= most + 1e-6 * size, "{case}: {most} {bound}");
        }
    }

    /// Integers tell the exact product. Doubles miss it, since it has more than 53 bits.
    #[test]
    fn a_product_in_doubles_is_enclosed_with_its_rounding() {
        let (mut off, mut state) = (0, 1_u64);
        let mut draw = |bits: u32| {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            i128::from(state >> 11) % (2_i128 << bits) - (1_i128 << bits)
        };
        for _ in 0..200 {
            let mut a = [[0; 3]; 3];
            let q: [[i128; 3]; 3] = std::array::from_fn(|_| std::array::from_fn(|_| draw(20)));
            for (i, j) in [(0, 0), (0, 1), (1, 1), (0, 2), (1, 2), (2, 2)] {
                a[i][j] = draw(40);
                a[j][i] = a[i][j];
            }
            let scale = 2.0_f64.powi(-20);
            let matrix = DMatrix::from_fn(3, 3, |i, j| a[i][j] as f64);
            let basis = DMatrix::from_fn(3, 3, |i, j| q[i][j] as f64 * scale);
            let (found, plain) =
                (rotated(&matrix.map(Interval::point), &basis), turned(&matrix, &basis));
            for (i, j) in [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)] {
                let terms = (0..9).map(|k| q[k / 3][i] * a[k / 3][k % 3] * q[k % 3][j]);
                let exact: i128 = terms.sum();
                // In units of 2⁻⁴⁰.
                let units = |end: f64| end * 2.0_f64.powi(40);
                let [lo, hi] = [found[(i, j)].lo(), found[(i, j)].hi()].map(units);
                assert!(lo.ceil() as i128 <= exact && exact <= hi.floor() as i128, "{exact}");
                assert!(hi - lo < 1e-14 * 9.0 * 2.0_f64.powi(80));
                off += usize::from(units(plain[(i, j)]) as i128 != exact);
            }
        }
        assert!(off > 600, "{off}");
    }

    #[test]
    fn a_negative_eigenvalue_is_bounded_from_above_too() {
        let a = dmatrix![-2.0, 0.3; 0.3, -5.0];
        let bound = largest_eigenvalue(&linear(&a, &a, 0.0));
        assert!(top(&a) <= bound && bound < top(&a) + 1e-14, "{bound}");
    }

    #[test]
    fn the_bound_of_an_interval_matrix_is_attained() {
        // The 2 × 2 matrix with the upper ends and the largest off-diagonal entry attains the
        // bound.
        let b = dmatrix![interval(0.0, 1.0), interval(-2.0, 0.5); interval(-2.0, 0.5), interval(-1.0, 2.0)];
        let exact = 1.5 + 4.25_f64.sqrt();
        let bound = rayleigh(&b);
        assert!(exact <= bound && bound < exact + 1e-14, "{bound} {exact}");
    }

    #[test]
    fn undefined_or_infinite_entries_have_no_bound() {
        let a = dmatrix![1.0, 0.0; 0.0, 1.0];
        for bad in [Interval::UNDEFINED, Interval::REALS] {
            for entry in [(0, 0), (1, 1)] {
                let mut s = linear(&a, &a, 0.1);
                s.value[entry] = bad;
                s.slopes[0][entry] = bad;
                assert!(!(largest_eigenvalue(&s) < f64::INFINITY));
                let mut s = linear(&a, &a, 0.1);
                s.centre[entry] = bad;
                s.value[entry] = bad;
                assert!(!(largest_eigenvalue(&s) < f64::INFINITY));
            }
        }
    }
}
