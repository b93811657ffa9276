//! A metric on the line with a V-shaped valley or ridge at the middle of `[0, 1]`.

use super::Polygonal;

/// Returns the metric `H = tip + slope |x − ½|` on `[0, 1]`, which is constant outside; `None`
/// unless it is positive. It has a valley for `slope > 0` and a ridge for `slope < 0`. `tip` is in
/// `m²/ℓ²` and `slope` in `m²/ℓ³`.
///
/// On the chord from `0` to `1`, the trapezoidal rule evaluates `H` at its tip, which attains
/// Proposition 7.9.
#[must_use]
pub fn tent(tip: f64, slope: f64) -> Option<Polygonal> {
    let foot = tip + 0.5 * slope;
    Polygonal::new(&[[0.0, foot], [0.5, tip], [1.0, foot]])
}
