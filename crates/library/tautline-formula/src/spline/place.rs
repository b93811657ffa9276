//! Where a coordinate lies on an axis: in which cell, and where in the cell.

/// A cell `[k, k + 1]` of an axis, and a point `k + t` in it.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Place {
    /// The number `k` of the cell, from `−2` to `n` on an axis of `n` coefficients.
    pub(crate) cell: isize,
    /// The point `t` in `[0, 1]`.
    pub(crate) t: f64,
}

impl Place {
    /// Returns the place of `u`, which is not NaN, on an axis of `n` coefficients. A node belongs
    /// to the cell above it.
    ///
    /// Beyond `−1` and `n` the spline is constant. All such points are at the lower end of a cell
    /// whose coefficients are all the same.
    ///
    /// `t` is exact for `u ≥ 0`, since `u` and `k` are multiples of the last place of `u`, and the
    /// difference is no larger than `u`. It is rounded once in the cell below 0.
    #[inline]
    pub(crate) fn of(u: f64, n: usize) -> Self {
        if u < -1.0 {
            Self { cell: -2, t: 0.0 }
        } else if u >= n as f64 {
            Self { cell: n as isize, t: 0.0 }
        } else {
            // The conversion rounds toward 0. It is faster than `floor`, which not every processor
            // has as an instruction.
            let toward_zero = u as isize;
            let cell = toward_zero - isize::from(toward_zero as f64 > u);
            Self { cell, t: u - cell as f64 }
        }
    }
}

/// Returns the positions of the `count` coefficients from number `start` on, on an axis of `n`,
/// each multiplied by `stride`. Beyond the ends they are those of the nearest coefficients.
#[inline]
pub(crate) fn clamped(start: isize, count: usize, n: usize, stride: usize) -> [usize; 4] {
    let last = n as isize - 1;
    let mut at = [0; 4];
    for (j, at) in at.iter_mut().enumerate().take(count) {
        *at = (start + j as isize).clamp(0, last) as usize * stride;
    }
    at
}
