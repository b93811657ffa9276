//! Fast marching on a lattice, and the paths that descend its distances.

mod descent;
mod distances;
mod error;
mod near;

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, check_gram};
use tautline_sets::{ClosedSet, Ends};

use crate::{Front, Lattice, Order};

pub use descent::EikonalPath;
pub use distances::Distances;
pub use error::EikonalError;

/// The largest number of nodes: in space the stencils of all take about 1.5 GB.
const MOST_NODES: usize = 1 << 22;

/// The largest condition number of `H` in steps of the lattice. The stencils are about as long as its
/// root.
const MOST_ANISOTROPIC: f64 = 1e8;

/// How many steps from a set, along each axis, nodes get the length of a chord.
const BAND: f64 = 3.0;

/// The widest band: that of the largest lattice.
const WIDEST_BAND: f64 = MOST_NODES as f64;

/// The eikonal equation `∇uᵀH(x)⁻¹∇u = 1` on the nodes of a lattice, in one to three dimensions.
///
/// The scheme is upwind along the vectors of Selling's decomposition of `H⁻¹` at each node (J.-M.
/// Mirebeau, *Riemannian fast-marching on Cartesian grids, using Voronoi's first reduction of quadratic
/// forms*, SIAM J. Numer. Anal. 57, 2019; its [`Front`] also proposes certificates of distances). The
/// vectors are about as long as the root of the condition number of `H`, in steps. Nodes that are so near
/// to the boundary of the box that their stencils leave it get values that are too large: let the box be
/// larger than the geodesics by that much.
#[derive(Clone, Debug)]
pub struct Eikonal<'m, M, const D: usize> {
    metric: &'m M,
    lattice: Lattice<D>,
    front: Front,
    band: f64,
}

impl<'m, M: Metric<D>, const D: usize> Eikonal<'m, M, D> {
    /// Prepares the stencils. Nodes without a metric are left out.
    ///
    /// # Errors
    ///
    /// [`EikonalError::Dimension`], [`EikonalError::TooManyNodes`] beyond `2²²` nodes, and
    /// [`EikonalError::Anisotropy`] if `H` has a condition number above `10⁸` at a node.
    pub fn new(metric: &'m M, lattice: &Lattice<D>) -> Result<Self, EikonalError> {
        if D > 3 {
            return Err(EikonalError::Dimension { dimension: D });
        }
        let nodes = lattice.nodes();
        if nodes > MOST_NODES {
            return Err(EikonalError::TooManyNodes { nodes, most: MOST_NODES });
        }
        let spacing = lattice.spacing();
        let mut inverses = Vec::with_capacity(nodes);
        for node in 0..nodes {
            let x = lattice.point(node);
            // In steps of the lattice.
            let scaled = |h: SMatrix<f64, D, D>| {
                SMatrix::<f64, D, D>::from_fn(|i, j| spacing[i] * h[(i, j)] * spacing[j])
            };
            let Ok(h) = check_gram(metric, &x).map(scaled) else {
                inverses.push(None);
                continue;
            };
            let inverse = h.cholesky().map(|factors| factors.inverse());
            let condition = inverse.map_or(f64::INFINITY, |inverse| h.norm() * inverse.norm());
            if !(condition <= MOST_ANISOTROPIC) {
                let point = x.as_slice().to_vec();
                let most = MOST_ANISOTROPIC;
                return Err(EikonalError::Anisotropy { point, condition, most });
            }
            inverses.push(inverse);
        }
        let neighbour = |node: usize, offset: &[i32; D]| {
            lattice.neighbour(&lattice.place(node), &offset.map(|along| along as isize))
        };
        let front = Front::new(nodes, 1.0, |node| inverses[node], neighbour);
        Ok(Self { metric, lattice: lattice.clone(), front, band: BAND })
    }

    /// Returns the equation with another band: how many steps from a set, along each axis, a distance is
    /// the length of a chord. It is 3 unless it is set.
    ///
    /// For a smooth metric a chord is wrong by the third power of the width `b` of the band, in `ℓ`, and a
    /// march of second order from a point by `h²/b`. The width that is the geometric mean of the spacing
    /// `h` and a length of the problem makes both `h^{3/2}`. A band must be narrower than the details of
    /// the metric.
    ///
    /// # Errors
    ///
    /// [`EikonalError::Band`] unless there are at least one and at most `2²²` steps.
    pub fn with_band(self, steps: f64) -> Result<Self, EikonalError> {
        if !(1.0..=WIDEST_BAND).contains(&steps) {
            return Err(EikonalError::Band { steps, most: WIDEST_BAND });
        }
        Ok(Self { band: steps, ..self })
    }

    /// Returns the lattice.
    #[must_use]
    pub fn lattice(&self) -> &Lattice<D> {
        &self.lattice
    }

    /// Returns the distances from a set at the nodes, in `m`.
    ///
    /// Nodes within the [band](Eikonal::with_band) around the set, and those whose stencils reach into it,
    /// get the length of the shortest chord to it. From a set with a smooth boundary the error is of the
    /// order of the march. From a point or a corner, where the distance has a kink, it is `h log 1/h` for
    /// the first order and `h` for the second, unless the band is wider.
    ///
    /// # Errors
    ///
    /// [`EikonalError::FarFromEnd`] if no node with a metric is near the set.
    pub fn distances_from<'s>(
        &'s self,
        set: &'s dyn ClosedSet<D>,
        order: Order,
    ) -> Result<Distances<'s, M, D>, EikonalError> {
        let nodes = self.lattice.nodes();
        let chords: Vec<SVector<f64, D>> = (0..nodes)
            .map(|node| {
                let x = self.lattice.point(node);
                x - set.project(&x)
            })
            .collect();
        let seed = |node: usize| {
            let reaches_in =
                || self.front.neighbours(node).any(|other| chords[other].amax() == 0.0);
            if !(self.is_within(self.band, &chords[node]) || reaches_in()) {
                return f64::INFINITY;
            }
            let chord = near::chord(self.metric, set, &self.lattice.point(node));
            // The distance has a kink along the boundary: no difference reaches across it.
            let is_inside = chords[node].amax() == 0.0;
            chord.map_or(f64::INFINITY, |(_, length)| if is_inside { f64::NAN } else { length })
        };
        let seeds: Vec<f64> = (0..nodes).map(seed).collect();
        self.distances_from_values(set, seeds, order)
    }

    /// Returns the distances from a set, given those at nodes near it, in `m`: one number for each node.
    ///
    /// Finite values are kept, nodes with `∞` get theirs, and nodes with NaN are left out. Afterwards
    /// the latter have the distance 0 if they are in the set and have a metric, and `∞` otherwise, as have
    /// nodes that are not reached.
    ///
    /// # Errors
    ///
    /// [`EikonalError::Count`], [`EikonalError::Value`] for a value `−∞`, and [`EikonalError::FarFromEnd`]
    /// if no value is finite and no node is in the set.
    pub fn distances_from_values<'s>(
        &'s self,
        set: &'s dyn ClosedSet<D>,
        values: Vec<f64>,
        order: Order,
    ) -> Result<Distances<'s, M, D>, EikonalError> {
        let nodes = self.lattice.nodes();
        if values.len() != nodes {
            return Err(EikonalError::Count { found: values.len(), nodes });
        }
        if let Some(node) = values.iter().position(|&value| value == f64::NEG_INFINITY) {
            return Err(EikonalError::Value { node, value: values[node] });
        }
        let mut values = self.front.march(values, order);
        for (node, value) in values.iter_mut().enumerate().filter(|(_, value)| value.is_nan()) {
            let x = self.lattice.point(node);
            let is_inside = set.project(&x) == x && check_gram(self.metric, &x).is_ok();
            *value = if is_inside { 0.0 } else { f64::INFINITY };
        }
        if !values.iter().any(|value| value.is_finite()) {
            return Err(EikonalError::FarFromEnd { end: "first" });
        }
        Ok(Distances::new(self, set, values))
    }

    /// Returns whether a vector is at most so many steps long, along each axis.
    fn is_within(&self, steps: f64, vector: &SVector<f64, D>) -> bool {
        (0..D).all(|i| vector[i].abs() <= steps * self.lattice.spacing()[i])
    }
}

/// Returns a path between two sets that descends the distances from the first, along `−H⁻¹∇u`, with its
/// corners in `ℓ`, its length and the distance between the sets, in `m`.
///
/// ```
/// use tautline_grid::{Lattice, Order, eikonal};
/// use tautline_metrics::gallery::Valleys;
/// use tautline_sets::{Ball, Ends, HalfSpace};
///
/// // From the ball of radius ½ to the half-space x₁ ≥ 3: d = 5 − sin 3 + sin ½.
/// let ends = Ends::new(Ball::new([0.0, 0.0], 0.5)?, HalfSpace::new([-1.0, 0.0], -3.0)?)?;
/// let lattice = Lattice::new([-1.0, -1.0], [3.5, 1.0], 0.05)?;
/// let path = eikonal(&Valleys, &ends, &lattice, Order::Second)?;
/// assert!((path.distance() - 5.338305).abs() < 1e-2);
/// assert_eq!(path.sequence(16)?.points().len(), 17);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
///
/// [`EikonalError`] with the offending numbers.
pub fn eikonal<M: Metric<D>, const D: usize>(
    metric: &M,
    ends: &Ends<D>,
    lattice: &Lattice<D>,
    order: Order,
) -> Result<EikonalPath<D>, EikonalError> {
    let equation = Eikonal::new(metric, lattice)?;
    let distances = equation.distances_from(&**ends.first(), order)?;
    distances.path_to(&**ends.second())
}
