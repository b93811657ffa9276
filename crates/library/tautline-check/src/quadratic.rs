//! A quadratic polynomial on a simplex, given by its values at the vertices and at the midpoints of
//! the edges.

use tautline_scalar::Interval;

use crate::kuhn::Simplex;

/// A quadratic polynomial `φ = Σ bᵢⱼ λᵢ λⱼ` in barycentric coordinates, by its Bernstein
/// coefficients `bᵢᵢ = φ(vᵢ)` and `bᵢⱼ = 2 φ((vᵢ + vⱼ)/2) − (φ(vᵢ) + φ(vⱼ))/2`.
///
/// On the simplex its values lie between the least and the greatest coefficient.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Bernstein<const D: usize> {
    /// The coefficients with `i ≤ j`, row by row; the last ones are not used.
    coefficients: [Interval; MOST],
}

/// The number of coefficients in four dimensions.
const MOST: usize = 15;

/// Returns the pairs `i ≤ j` of vertices, row by row.
fn pairs(vertices: usize) -> impl Iterator<Item = (usize, usize)> {
    (0..vertices).flat_map(move |i| (i..vertices).map(move |j| (i, j)))
}

impl<const D: usize> Bernstein<D> {
    /// Returns the polynomial with these coefficients.
    pub(crate) fn new(coefficient: impl Fn(usize, usize) -> Interval) -> Self {
        let mut coefficients = [Interval::UNDEFINED; MOST];
        for (at, (i, j)) in pairs(D + 1).enumerate() {
            coefficients[at] = coefficient(i, j);
        }
        Self { coefficients }
    }

    /// Returns the polynomial with these values at the nodes of a cube.
    pub(crate) fn of(simplex: &Simplex, values: &[f64]) -> Self {
        let at = |i: usize, j: usize| Interval::point(values[simplex.nodes[i][j]]);
        Self::new(
            |i, j| {
                if i == j { at(i, i) } else { at(i, j) * 2.0 - (at(i, i) + at(j, j)) * 0.5 }
            },
        )
    }

    fn used(&self) -> &[Interval] {
        &self.coefficients[..(D + 1) * (D + 2) / 2]
    }

    /// Returns the sum of two polynomials.
    pub(crate) fn plus(&self, other: &Self) -> Self {
        let mut sum = *self;
        for (a, b) in sum.coefficients.iter_mut().zip(other.used()) {
            *a += *b;
        }
        sum
    }

    /// Returns the polynomial times a number.
    pub(crate) fn times(&self, factor: f64) -> Self {
        let mut product = *self;
        for a in &mut product.coefficients[..(D + 1) * (D + 2) / 2] {
            *a = *a * factor;
        }
        product
    }

    /// Returns an interval that contains all values on the simplex; the real line if a coefficient
    /// is unknown.
    pub(crate) fn range(&self) -> Interval {
        hull(self.used().iter().copied())
    }

    /// Returns an interval that contains all values on the facet without the vertex `k`.
    pub(crate) fn range_opposite(&self, k: usize) -> Interval {
        let facet = pairs(D + 1).zip(self.used()).filter(|&((i, j), _)| i != k && j != k);
        hull(facet.map(|(_, &b)| b))
    }

    /// Returns the differences between consecutive vertices, about: the slope along each axis of the
    /// simplex, times the side of the cube.
    pub(crate) fn slopes(&self) -> Vec<f64> {
        let vertices: Vec<f64> = pairs(D + 1)
            .zip(self.used())
            .filter(|((i, j), _)| i == j)
            .map(|(_, b)| b.midpoint())
            .collect();
        vertices.windows(2).map(|pair| pair[1] - pair[0]).collect()
    }

    /// Returns an interval that contains the value at a point with these barycentric coordinates.
    pub(crate) fn at(&self, barycentric: &[Interval]) -> Interval {
        let terms = pairs(D + 1).zip(self.used()).map(|((i, j), &b)| {
            let weight = barycentric[i] * barycentric[j];
            if i == j { weight * b } else { weight * b * 2.0 }
        });
        terms.reduce(|sum, term| sum + term).unwrap_or(Interval::UNDEFINED)
    }
}

fn hull(values: impl Iterator<Item = Interval>) -> Interval {
    let hull = values.reduce(Interval::hull).unwrap_or(Interval::UNDEFINED);
    if hull.is_undefined() { Interval::REALS } else { hull }
}

/// Returns the gradient at the vertex `k` of the polynomial with these values at the nodes of a cube
/// of side `1 / inverse_side`, a power of two.
///
/// With `d_j = (v_j − v_k)·p = −3 φ(v_k) + 4 φ((v_k + v_j)/2) − φ(v_j)`, the derivative along the
/// axis `π(m)` is `(d_m − d_{m−1})/a`. If neither vertex is `k`, the terms with `φ(v_k)` cancel.
pub(crate) fn gradient<const D: usize>(
    simplex: &Simplex,
    values: &[f64],
    k: usize,
    inverse_side: f64,
) -> [Interval; D] {
    let at = |i: usize, j: usize| Interval::point(values[simplex.nodes[i][j]]);
    let along = |j: usize| at(k, k) * -3.0 + at(k, j) * 4.0 - at(j, j);
    let mut gradient = [Interval::UNDEFINED; D];
    for m in 1..=D {
        let difference = if m == k {
            -along(m - 1)
        } else if m - 1 == k {
            along(m)
        } else {
            (at(k, m) - at(k, m - 1)) * 4.0 - (at(m, m) - at(m - 1, m - 1))
        };
        gradient[simplex.axes[m - 1]] = difference * inverse_side;
    }
    gradient
}

#[cfg(test)]
mod tests;
