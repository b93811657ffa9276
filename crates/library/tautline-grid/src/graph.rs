//! Shortest paths along the nodes of a lattice.
//!
//! A path runs in the directions of the edges only. Its length therefore tends to the distance under
//! another norm, whatever the spacing: the one whose unit ball is the convex hull of the directions.

use tautline_formula::Plain;
use tautline_metrics::{Constants, Metric};
use tautline_sets::Ends;

use crate::{GraphPathError, Lattice, LatticeGraph, LatticePath};

/// Returns a shortest path between two sets along a lattice whose edges reach `reach` steps along each
/// axis: its length in `m`, its corners in `ℓ` and the number of nodes that were opened.
///
/// The length is `Σ ½ (|d|_{H(x)} + |d|_{H(x + d)})` over the edges `d` from `x`. Without `constants` the
/// search is that of Dijkstra; with them it is A* with the lower bound `√c₁ · dist(x, X⁽¹⁾)` on the rest,
/// which finds the same length and opens fewer nodes. In the plane the length is at most
/// [`angular_factor`] times that of the geodesic for a constant `H = c I` and equal spacings, up to the
/// chords between the sets and their nearest nodes.
///
/// ```
/// use tautline_grid::{Lattice, graph};
/// use tautline_metrics::{Bounded, KnownDistance, gallery::Shear};
/// use tautline_sets::Ends;
///
/// let shear = Shear::new(0.5, 1.0)?;
/// let ends = Ends::points([0.0, 0.0], [2.0, 1.0])?;
/// let lattice = Lattice::new([-0.5, -0.5], [2.5, 1.5], 0.05)?;
/// let path = graph(&shear, &ends, &lattice, 3, Some(&shear.constants()))?;
/// let exact = shear.distance(&[0.0, 0.0].into(), &[2.0, 1.0].into()).expect("all are known");
/// assert!(path.length() > exact && path.length() < 1.02 * exact);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`GraphPathError`] with the offending numbers: a reach that is not 1 to 8, a set that is far from all
/// nodes with a metric, sets that are not connected by such nodes, or a `c₁` that is no lower bound.
pub fn graph<M: Metric<D>, const D: usize>(
    metric: &M,
    ends: &Ends<D>,
    lattice: &Lattice<D>,
    reach: usize,
    constants: Option<&Constants>,
) -> Result<LatticePath<D>, GraphPathError> {
    let metric = Plain::new(metric);
    LatticeGraph::new(&metric, lattice.clone(), reach)?.shortest(ends, constants)
}

/// Returns the largest quotient of the length of a path along a lattice of equal spacings in the plane by
/// the Euclidean distance of its ends, over all directions: `1/cos(½ atan(1/r))` for the reach `r`, a pure
/// number. It is infinite for `r = 0`, where there are no edges.
///
/// Between neighbouring directions `a` and `b` at the angle `α` the length of `s a + t b` is
/// `s|a| + t|b|`. The unit ball of this norm is a chord there, at the distance `cos(α/2)` from 0. Since
/// `a` and `b` are a basis of the lattice, `tan α = 1/(a·b)`. With `a₁ ≥ a₂ ≥ 0` and `b₁ ≥ b₂ ≥ 0`, the sum
/// `a + b` is beyond the reach, `a₁ + b₁ ≥ r + 1`, so that `a·b ≥ a₁b₁ ≥ r`. The directions `(1, 0)` and
/// `(r, 1)` attain it.
#[must_use]
pub fn angular_factor(reach: usize) -> f64 {
    if reach == 0 {
        return f64::INFINITY;
    }
    (0.5 * (reach as f64).recip().atan()).cos().recip()
}

#[cfg(test)]
mod tests {
    use super::angular_factor;

    /// For the reach 1 the directions are at 45°: `1/cos 22.5° = √(4 − 2√2)`. For the reach 2 the largest
    /// angle is `atan ½`, with `cos² (½ atan ½) = ½ (1 + 2/√5)`. A few roundings each.
    #[test]
    fn the_angular_factor_has_closed_forms() {
        assert!((angular_factor(1) - (4.0 - 8_f64.sqrt()).sqrt()).abs() < 1e-15);
        assert!((angular_factor(2) - (2.0 / (1.0 + 2.0 / 5_f64.sqrt())).sqrt()).abs() < 1e-15);
        assert_eq!(angular_factor(0), f64::INFINITY);
    }
}
