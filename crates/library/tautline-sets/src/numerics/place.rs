//! Points of a space whose dimension is a value, as lists of numbers.

use nalgebra::SVector;
use smallvec::SmallVec;

/// A point or a vector, which needs no allocation up to four dimensions.
pub(crate) type Place = SmallVec<[f64; 4]>;

/// Returns `D` numbers as a vector of `R^D`.
pub(crate) fn vector<const D: usize>(x: &[f64]) -> &SVector<f64, D> {
    bytemuck::from_bytes(bytemuck::cast_slice(x))
}

/// Returns the sum of `x` and a multiple of `y`.
pub(crate) fn plus(x: &[f64], y: &[f64], factor: f64) -> Place {
    x.iter().zip(y).map(|(x, y)| x + y * factor).collect()
}

/// Adds a multiple of `y` to `x`.
pub(crate) fn add(x: &mut [f64], y: &[f64], factor: f64) {
    x.iter_mut().zip(y).for_each(|(x, y)| *x += y * factor);
}

/// Returns `x − y`.
pub(crate) fn minus(x: &[f64], y: &[f64]) -> Place {
    x.iter().zip(y).map(|(x, y)| x - y).collect()
}

/// Returns `x·y`, summed from left to right.
pub(crate) fn dot(x: &[f64], y: &[f64]) -> f64 {
    x.iter().zip(y).map(|(x, y)| x * y).sum()
}

/// Returns the largest coordinate in absolute value, or 0 if there is none. A NaN counts only if
/// nothing else is there.
pub(crate) fn largest(x: &[f64]) -> f64 {
    x.iter().map(|x| x.abs()).reduce(f64::max).unwrap_or(0.0)
}

/// Writes `stretch · (I − uuᵀ)` to a square matrix.
pub(crate) fn tangential(u: &[f64], stretch: f64, matrix: &mut [f64]) {
    let entries = u.iter().enumerate().flat_map(|(j, v)| {
        u.iter().enumerate().map(move |(i, u)| f64::from(u8::from(i == j)) - u * v)
    });
    matrix.iter_mut().zip(entries).for_each(|(to, entry)| *to = entry * stretch);
}

/// Writes a diagonal matrix.
pub(crate) fn diagonal(matrix: &mut [f64], dimension: usize, entry: impl Fn(usize) -> f64) {
    matrix.fill(0.0);
    (0..dimension).for_each(|i| matrix[i * (dimension + 1)] = entry(i));
}
