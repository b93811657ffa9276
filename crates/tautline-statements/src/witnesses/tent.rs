//! A metric on the line with a V-shaped valley or ridge at the middle of `[0, 1]`.

use super::Polygonal;

/// Returns `H = tip + slope |x − ½|` on `[0, 1]`, constant outside: a valley for `slope > 0`, a
/// ridge for `slope < 0`; in `m²/ℓ²` and `m²/ℓ³`. `None` unless it is positive.
///
/// Between `0` and `1` the trapezoidal rule evaluates it at its tip, which attains Proposition 7.9.
#[must_use]
pub fn tent(tip: f64, slope: f64) -> Option<Polygonal> {
    let foot = tip + 0.5 * slope;
    Polygonal::new(&[[0.0, foot], [0.5, tip], [1.0, foot]])
}
