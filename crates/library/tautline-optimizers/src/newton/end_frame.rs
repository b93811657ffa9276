//! `EndFrame`: the coordinates in which a Newton step moves an end point along its set.

use nalgebra::DMatrix;
use smallvec::SmallVec;
use tautline_sets::AnySet;

use crate::newton::{
    arithmetic::blocks::{Blocks, with_small_blocks},
    arithmetic::small::{Matrix, Vector, apply, apply_transposed, multiple_of_identity, multiply},
};

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
pub(crate) struct EndFrame {
    /// The eigenvectors of `J`, as columns; `None` if they are the axes.
    basis: Option<Matrix>,
    /// How the end moves along each column of the basis.
    pub(crate) coordinates: SmallVec<[Coordinate; 3]>,
    /// The projected gradient `F / τ`, in the coordinates of `R^D`.
    pub(crate) projected_gradient: Vector,
    /// The gradient `g`, in `m²/ℓ`.
    pub(crate) gradient: Vector,
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

impl EndFrame {
    pub(crate) fn new(set: &dyn AnySet, x: &[f64], gradient: &[f64], tau: f64) -> Self {
        with_small_blocks!(x.len(), blocks => Self::by(blocks, set, x, gradient, tau))
    }

    #[inline(always)]
    fn by<B: Blocks>(blocks: B, set: &dyn AnySet, x: &[f64], gradient: &[f64], tau: f64) -> Self {
        let d = blocks.dimension();
        let (x, gradient) = (&x[..d], &gradient[..d]);
        let (mut z, mut residual) = (blocks.vector(), blocks.vector());
        let (z, residual) = (z.as_mut(), residual.as_mut());
        for i in 0..d {
            z[i] = x[i] - gradient[i] * tau;
        }
        residual.copy_from_slice(z);
        set.project(residual);
        let mut derivative = blocks.block();
        let derivative = derivative.as_mut();
        set.projection_derivative(z, derivative);
        for i in 0..d {
            residual[i] = x[i] - residual[i];
            z[i] = residual[i] / tau;
        }
        let (projected_gradient, gradient) = (Vector::from_slice(z), Vector::from_slice(gradient));
        let mut coordinates = SmallVec::new();
        if let Some(sigma) = multiple_of_identity(blocks, derivative) {
            for f in &*residual {
                coordinates.push(if sigma == 1.0 {
                    Coordinate::Free { curvature: 0.0, force: -f / tau }
                } else {
                    Coordinate::Fixed { step: -f }
                });
            }
            return Self { basis: None, coordinates, projected_gradient, gradient };
        }
        let eigen =
            DMatrix::from_fn(d, d, |i, j| 0.5 * (derivative[j * d + i] + derivative[i * d + j]))
                .symmetric_eigen();
        let basis = Matrix::from_slice(eigen.eigenvectors.as_slice());
        apply_transposed(blocks, &basis, residual);
        for (&sigma, f) in eigen.eigenvalues.iter().zip(residual) {
            coordinates.push(if sigma < FLAT {
                Coordinate::Fixed { step: -*f }
            } else {
                Coordinate::Free {
                    curvature: (1.0 - sigma) / (sigma * tau),
                    force: -*f / (sigma * tau),
                }
            });
        }
        Self { basis: Some(basis), coordinates, projected_gradient, gradient }
    }

    /// Transforms the row of the end point in a block system to these coordinates: its diagonal
    /// block, the block that couples it to its neighbour (with rows for the end), and both right
    /// hand sides.
    ///
    /// A fixed coordinate keeps its place, as a separate equation that is already solved.
    pub(crate) fn enter(
        &self,
        block: &mut [f64],
        coupling: &mut [f64],
        vectors: [&mut [f64]; 2],
        tau: f64,
    ) {
        with_small_blocks!(self.gradient.len(), blocks => {
            self.enter_by(blocks, block, coupling, vectors, tau)
        });
    }

    #[inline(always)]
    fn enter_by<B: Blocks>(
        &self,
        blocks: B,
        block: &mut [f64],
        coupling: &mut [f64],
        [right, beside]: [&mut [f64]; 2],
        tau: f64,
    ) {
        let d = blocks.dimension();
        let (block, coupling) = (&mut block[..d * d], &mut coupling[..d * d]);
        let (right, beside) = (&mut right[..d], &mut beside[..d]);
        if let Some(basis) = &self.basis {
            multiply(blocks, block, basis);
            for matrix in [&mut *block, &mut *coupling] {
                matrix.chunks_exact_mut(d).for_each(|x| apply_transposed(blocks, basis, x));
            }
            apply_transposed(blocks, basis, right);
        }
        for (i, coordinate) in self.coordinates.iter().enumerate() {
            match *coordinate {
                Coordinate::Free { curvature, force } => {
                    block[i * d + i] += curvature;
                    right[i] += force;
                }
                Coordinate::Fixed { step } => {
                    for k in 0..d {
                        right[k] -= block[i * d + k] * step;
                        beside[k] -= coupling[k * d + i] * step;
                    }
                    for k in 0..d {
                        block[k * d + i] = 0.0;
                        block[i * d + k] = 0.0;
                        coupling[k * d + i] = 0.0;
                    }
                }
            }
        }
        for (i, coordinate) in self.coordinates.iter().enumerate() {
            if let Coordinate::Fixed { step } = *coordinate {
                block[i * d + i] = 1.0 / tau;
                right[i] = step / tau;
            }
        }
    }

    /// Returns the force on the end point, in the coordinates of `R^D`. Along the active face it is
    /// the right hand side of the Newton equation; across the face it is `step/τ`, which points
    /// back to the face.
    pub(crate) fn force(&self, tau: f64) -> Vector {
        let component = |coordinate: &Coordinate| match *coordinate {
            Coordinate::Free { force, .. } => force,
            Coordinate::Fixed { step } => step / tau,
        };
        let mut force: Vector = self.coordinates.iter().map(component).collect();
        self.leave(&mut force);
        force
    }

    /// Turns a vector from the coordinates of `R^D` to those of the frame.
    pub(crate) fn turn(&self, x: &mut [f64]) {
        if let Some(basis) = &self.basis {
            with_small_blocks!(x.len(), blocks => apply_transposed(blocks, basis, x));
        }
    }

    /// Turns a vector from the coordinates of the frame back to those of `R^D`.
    pub(crate) fn leave(&self, x: &mut [f64]) {
        if let Some(basis) = &self.basis {
            with_small_blocks!(x.len(), blocks => apply(blocks, basis, x));
        }
    }

    /// Returns whether the end does not move.
    #[cfg(test)]
    pub(crate) fn is_fixed(&self) -> bool {
        self.coordinates.iter().all(|c| matches!(c, Coordinate::Fixed { .. }))
    }
}

#[cfg(test)]
mod tests {
    use tautline_sets::{AxisBox, Ball, InAny, Point};

    use super::{Coordinate, EndFrame};
    use crate::newton::arithmetic::small::dot;

    fn free(frame: &EndFrame) -> usize {
        frame.coordinates.iter().filter(|c| matches!(c, Coordinate::Free { .. })).count()
    }

    #[test]
    fn interior_face_and_corner_of_a_box_have_2_1_0_free_coordinates() {
        let square = AxisBox::new([0.0, 0.0], [1.0, 1.0]).expect("half-widths 1");
        let frame = |x: [f64; 2], g: [f64; 2]| EndFrame::new(&InAny(&square), &x, &g, 0.1);
        assert_eq!(free(&frame([0.0, 0.0], [1.0, 1.0])), 2);
        assert_eq!(free(&frame([1.0, 0.0], [-1.0, 0.3])), 1);
        assert_eq!(free(&frame([1.0, 1.0], [-1.0, -1.0])), 0);
        // A force that points inwards leaves the face.
        assert_eq!(free(&frame([1.0, 0.0], [1.0, 0.0])), 2);
    }

    #[test]
    fn a_point_is_fixed() {
        let point = Point::new([0.5, 0.5]).expect("finite");
        let frame = EndFrame::new(&InAny(&point), &[0.5, 0.5], &[3.0, 4.0], 0.1);
        assert!(frame.is_fixed());
        assert_eq!(frame.projected_gradient[..], [0.0, 0.0]);
    }

    /// Under the outward force `λ`, on the boundary of a disc of radius `r`, the second derivative
    /// of the Lagrangian along the boundary is `λ/r`.
    #[test]
    fn the_curvature_term_is_the_multiplier_over_the_radius() {
        let ball = Ball::new([0.0, 0.0], 0.5).expect("positive radius");
        let frame = EndFrame::new(&InAny(&ball), &[0.5, 0.0], &[-3.0, 0.0], 0.01);
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
        let projected = &frame.projected_gradient;
        assert!(dot(projected, projected).sqrt() < 1e-13);
    }

    /// The eigenvalue `r/|z|` is `10⁻⁶` here.
    #[test]
    fn a_small_disc_is_not_a_point() {
        let ball = Ball::new([0.0, 0.0], 1e-6).expect("positive radius");
        let frame = EndFrame::new(&InAny(&ball), &[1e-6, 0.0], &[-(1.0 - 1e-6), 0.0], 1.0);
        assert_eq!(free(&frame), 1);
    }
}
