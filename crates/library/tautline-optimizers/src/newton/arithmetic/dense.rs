//! Dense arithmetic of blocks whose size is known when the program runs: factorisations and updates in
//! panels of four columns, column by column.

/// The number of columns that are subtracted together: each number of the target is then loaded and
/// stored once for four products.
const PANEL: usize = 4;

/// Returns `x · y`, summed in four parts.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    let ((x, x_rest), (y, y_rest)) = (x.as_chunks::<PANEL>(), y.as_chunks::<PANEL>());
    let mut sums = [0.0; PANEL];
    for (x, y) in x.iter().zip(y) {
        for lane in 0..PANEL {
            sums[lane] += x[lane] * y[lane];
        }
    }
    let rest: f64 = x_rest.iter().zip(y_rest).map(|(x, y)| x * y).sum();
    (sums[0] + sums[1]) + (sums[2] + sums[3]) + rest
}

/// Subtracts from `target` the columns of `a`, each times its factor. Column `k` begins at number
/// `k stride + first` of `a` and is as long as the target.
#[inline(always)]
fn subtract_columns(
    target: &mut [f64],
    a: &[f64],
    [stride, first]: [usize; 2],
    count: usize,
    factor: impl Fn(usize) -> f64,
) {
    let length = target.len();
    let column = |k: usize| &a[k * stride + first..][..length];
    let panels = count / PANEL;
    for panel in 0..panels {
        let k = panel * PANEL;
        let factors: [f64; PANEL] = std::array::from_fn(|l| factor(k + l));
        let [a, b, c, d] = [column(k), column(k + 1), column(k + 2), column(k + 3)];
        for i in 0..length {
            let products =
                (a[i] * factors[0] + b[i] * factors[1]) + (c[i] * factors[2] + d[i] * factors[3]);
            target[i] -= products;
        }
    }
    for k in panels * PANEL..count {
        let factor = factor(k);
        target.iter_mut().zip(column(k)).for_each(|(target, a)| *target -= a * factor);
    }
}

/// Factorises `A = L D Lᵀ` in place, given by its lower triangle: `L` below the diagonal and the
/// reciprocals of `D` on it; `D` itself is written to `diagonal`. Returns whether `A` is positive
/// definite and finite.
#[inline(always)]
fn factorize_inline(d: usize, factors: &mut [f64], diagonal: &mut [f64]) -> bool {
    let (factors, diagonal) = (&mut factors[..d * d], &mut diagonal[..d]);
    for k in 0..d {
        let (done, rest) = factors.split_at_mut(k * d);
        let target = &mut rest[k..d];
        subtract_columns(target, done, [d, k], k, |j| done[j * d + k] * diagonal[j]);
        let pivot = target[0];
        // NaN and +∞ fail here too.
        if !(pivot > 0.0 && pivot <= f64::MAX) {
            return false;
        }
        diagonal[k] = pivot;
        let reciprocal = 1.0 / pivot;
        target[1..].iter_mut().for_each(|entry| *entry *= reciprocal);
        target[0] = reciprocal;
    }
    true
}

#[inline(always)]
fn eliminate_inline(
    d: usize,
    schur: &[f64],
    lower: &[f64],
    next: &mut [f64],
    [factors, scaled, w]: [&mut [f64]; 3],
) -> bool {
    factors.copy_from_slice(schur);
    if !factorize_inline(d, factors, w) {
        return false;
    }
    // W Lᵀ = B, column by column.
    w.copy_from_slice(lower);
    for k in 0..d {
        let (done, rest) = w.split_at_mut(k * d);
        subtract_columns(&mut rest[..d], done, [d, 0], k, |j| factors[j * d + k]);
        let reciprocal = factors[k * d + k];
        let columns = scaled[k * d..][..d].iter_mut().zip(&rest[..d]);
        columns.for_each(|(scaled, w)| *scaled = w * reciprocal);
    }
    for (j, target) in next.chunks_exact_mut(d).enumerate() {
        subtract_columns(&mut target[j..], w, [d, j], d, |k| scaled[k * d + j]);
    }
    true
}

/// Factorises a block in place, as [`Blocks::factorize`](crate::newton::arithmetic::blocks::Blocks::factorize) says.
pub(crate) fn factorize(d: usize, factors: &mut [f64]) -> bool {
    factorize_widest(d, factors, &mut vec![0.0; d])
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn factorize_widest(d: usize, factors: &mut [f64], diagonal: &mut [f64]) -> bool {
    factorize_inline(d, factors, diagonal)
}

/// Eliminates a block, as [`Blocks::eliminate`](crate::newton::arithmetic::blocks::Blocks::eliminate) says. The
/// results are its factors, `W D⁻¹` and `W`.
pub(crate) fn eliminate(
    d: usize,
    schur: &[f64],
    lower: &[f64],
    next: &mut [f64],
    results: [&mut [f64]; 3],
) -> bool {
    eliminate_widest(d, schur, lower, next, results)
}

#[multiversion::multiversion(targets("x86_64+avx2"))]
fn eliminate_widest(
    d: usize,
    schur: &[f64],
    lower: &[f64],
    next: &mut [f64],
    results: [&mut [f64]; 3],
) -> bool {
    eliminate_inline(d, schur, lower, next, results)
}
