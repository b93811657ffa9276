//! `EndFrame`: the coordinates in which a Newton step moves an end point along its set.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_sets::ClosedSet;

/// Coordinates at an end point `x` of a closed set with the nearest-point map `P`.
///
/// Let `g` be the gradient of the energy with respect to `x`. The end point is stationary if
/// `x = P(z)` for `z = x − τ g`: the force `−g` then points out of the set, along a normal. One
/// semismooth Newton step for this equation is
///
/// ```text
/// F + δ − J (δ − τ A δ) = 0,     F = x − P(z),   J = P′(z),   A δ: the change of g
/// ```
///
/// The eigenvectors of the symmetric matrix `J` decouple this equation. For an eigenvalue `σ` there
/// are two cases:
///
/// - `σ = 0`, across the active face: `δ = −F`, and the coordinate is *fixed*;
/// - `σ > 0`, along the face: `A δ + (1−σ)/(σ τ) δ = −F/(σ τ)`, which is again a Newton equation,
///   with a term for the curvature of the face (`σ = 1` if the face is flat).
///
/// This approach treats faces, edges, corners and curved boundaries alike, and keeps the system
/// symmetric.
#[derive(Clone, Debug)]
pub(crate) struct EndFrame<const D: usize> {
    /// The eigenvectors of `J`, as columns.
    pub(crate) basis: SMatrix<f64, D, D>,
    /// How the end moves along each column of the basis.
    pub(crate) coordinates: [Coordinate; D],
    /// The projected gradient `F / τ`, in the coordinates of `R^D`.
    pub(crate) projected_gradient: SVector<f64, D>,
    /// The gradient `g`, in `m²/ℓ`.
    pub(crate) gradient: SVector<f64, D>,
}

/// One coordinate of an end point.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Coordinate {
    /// The coordinate is across the active face, and `step` leads back to the face.
    Fixed { step: f64 },
    /// The coordinate is along the active face, with the equation `A δ + curvature · δ = force`.
    Free { curvature: f64, force: f64 },
}

/// Eigenvalues of `J` below this number count as zero. For a sphere of radius `r` about the origin,
/// the eigenvalue along the sphere is `r/|z|`, so only a set smaller than `10⁻¹⁰` times a chord is
/// mistaken for a point.
const FLAT: f64 = 1e-10;

impl<const D: usize> EndFrame<D> {
    pub(crate) fn new(
        set: &dyn ClosedSet<D>,
        x: &SVector<f64, D>,
        gradient: &SVector<f64, D>,
        tau: f64,
    ) -> Self {
        let gradient = *gradient;
        let z = x - gradient * tau;
        let residual = x - set.project(&z);
        let derivative = set.projection_derivative(&z);
        let projected_gradient = residual / tau;
        let identity = SMatrix::<f64, D, D>::identity();
        if derivative == identity * 0.0 || derivative == identity {
            let free = derivative == identity;
            let coordinates = std::array::from_fn(|i| {
                if free {
                    Coordinate::Free { curvature: 0.0, force: -residual[i] / tau }
                } else {
                    Coordinate::Fixed { step: -residual[i] }
                }
            });
            return Self { basis: identity, coordinates, projected_gradient, gradient };
        }
        let eigen = DMatrix::from_fn(D, D, |i, j| 0.5 * (derivative[(i, j)] + derivative[(j, i)]))
            .symmetric_eigen();
        let basis = SMatrix::<f64, D, D>::from_fn(|i, j| eigen.eigenvectors[(i, j)]);
        let rotated = basis.tr_mul(&residual);
        let coordinates = std::array::from_fn(|i| {
            let sigma = eigen.eigenvalues[i];
            if sigma < FLAT {
                Coordinate::Fixed { step: -rotated[i] }
            } else {
                Coordinate::Free {
                    curvature: (1.0 - sigma) / (sigma * tau),
                    force: -rotated[i] / (sigma * tau),
                }
            }
        });
        Self { basis, coordinates, projected_gradient, gradient }
    }

    /// Transforms the row of the end point in a block system to these coordinates: its diagonal
    /// block, the block that couples it to its neighbour (with rows for the end), and both right
    /// hand sides.
    ///
    /// A fixed coordinate keeps its place, as a separate equation that is already solved.
    pub(crate) fn enter(
        &self,
        block: &mut SMatrix<f64, D, D>,
        coupling: &mut SMatrix<f64, D, D>,
        [right, beside]: [&mut SVector<f64, D>; 2],
        tau: f64,
    ) {
        *block = self.basis.tr_mul(&(*block * self.basis));
        *coupling = self.basis.tr_mul(coupling);
        *right = self.basis.tr_mul(right);
        for (i, coordinate) in self.coordinates.iter().enumerate() {
            match *coordinate {
                Coordinate::Free { curvature, force } => {
                    block[(i, i)] += curvature;
                    right[i] += force;
                }
                Coordinate::Fixed { step } => {
                    *right -= block.column(i) * step;
                    *beside -= coupling.row(i).transpose() * step;
                    block.row_mut(i).fill(0.0);
                    block.column_mut(i).fill(0.0);
                    coupling.row_mut(i).fill(0.0);
                }
            }
        }
        for (i, coordinate) in self.coordinates.iter().enumerate() {
            if let Coordinate::Fixed { step } = *coordinate {
                block[(i, i)] = 1.0 / tau;
                right[i] = step / tau;
            }
        }
    }

    /// Returns the force on the end point, in the coordinates of `R^D`. Along the active face it is
    /// the right hand side of the Newton equation; across the face it is `step/τ`, which points
    /// back to the face.
    pub(crate) fn force(&self, tau: f64) -> SVector<f64, D> {
        let component = |coordinate: &Coordinate| match *coordinate {
            Coordinate::Free { force, .. } => force,
            Coordinate::Fixed { step } => step / tau,
        };
        self.basis * SVector::from(self.coordinates.each_ref().map(component))
    }

    /// Returns whether the end does not move.
    #[cfg(test)]
    pub(crate) fn is_fixed(&self) -> bool {
        self.coordinates.iter().all(|c| matches!(c, Coordinate::Fixed { .. }))
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use tautline_sets::{AxisBox, Ball, Point};

    use super::{Coordinate, EndFrame};

    fn free(frame: &EndFrame<2>) -> usize {
        frame.coordinates.iter().filter(|c| matches!(c, Coordinate::Free { .. })).count()
    }

    #[test]
    fn interior_face_and_corner_of_a_box_have_2_1_0_free_coordinates() {
        let square = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("half-widths 1");
        let frame = |x: [f64; 2], g: [f64; 2]| EndFrame::new(&square, &x.into(), &g.into(), 0.1);
        assert_eq!(free(&frame([0.0, 0.0], [1.0, 1.0])), 2);
        assert_eq!(free(&frame([1.0, 0.0], [-1.0, 0.3])), 1);
        assert_eq!(free(&frame([1.0, 1.0], [-1.0, -1.0])), 0);
        // A force that points inwards leaves the face.
        assert_eq!(free(&frame([1.0, 0.0], [1.0, 0.0])), 2);
    }

    #[test]
    fn a_point_is_fixed() {
        let point = Point::new([0.5, 0.5]).expect("finite");
        let frame = EndFrame::new(&point, &vector![0.5, 0.5], &vector![3.0, 4.0], 0.1);
        assert!(frame.is_fixed());
        assert_eq!(frame.projected_gradient.norm(), 0.0);
    }

    /// Under the outward force `λ`, on the boundary of a disc of radius `r`, the second derivative
    /// of the Lagrangian along the boundary is `λ/r`.
    #[test]
    fn the_curvature_term_is_the_multiplier_over_the_radius() {
        let ball = Ball::new([0.0, 0.0], 0.5).expect("positive radius");
        let frame = EndFrame::new(&ball, &vector![0.5, 0.0], &vector![-3.0, 0.0], 0.01);
        let curvatures: Vec<f64> = frame
            .coordinates
            .iter()
            .filter_map(|c| match c {
                Coordinate::Free { curvature, .. } => Some(*curvature),
                Coordinate::Fixed { .. } => None,
            })
            .collect();
        assert_eq!(curvatures.len(), 1);
        approx::assert_relative_eq!(curvatures[0], 3.0 / 0.5, max_relative = 1e-12);
        // The point is on the set and the force is normal, so the projected gradient is rounding,
        // 1e-16 / τ.
        assert!(frame.projected_gradient.norm() < 1e-13);
    }

    /// The eigenvalue `r/|z|` is `10⁻⁶` here.
    #[test]
    fn a_small_disc_is_not_a_point() {
        let ball = Ball::new([0.0, 0.0], 1e-6).expect("positive radius");
        let frame = EndFrame::new(&ball, &vector![1e-6, 0.0], &vector![-(1.0 - 1e-6), 0.0], 1.0);
        assert_eq!(free(&frame), 1);
    }
}
