//! A filled ellipse: a user's closed set, given by its nearest-point map.

use tautline::{ClosedSet, SMatrix, SVector};

/// `{x : (x − c)ᵀ Q (x − c) ≤ 1}` with a symmetric positive definite `Q`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ellipse {
    pub(super) centre: SVector<f64, 2>,
    pub(super) form: SMatrix<f64, 2, 2>,
}

impl Ellipse {
    /// Returns the ellipse with these semi-axes, rotated by `angle`.
    pub(crate) fn new(centre: [f64; 2], semi_axes: [f64; 2], angle: f64) -> Self {
        let (sin, cos) = angle.sin_cos();
        let turn = SMatrix::<f64, 2, 2>::new(cos, -sin, sin, cos);
        let scale = SMatrix::from_diagonal(&SVector::from(semi_axes.map(|a| a.powi(-2))));
        Self { centre: centre.into(), form: turn * scale * turn.transpose() }
    }

    /// Returns `max a·x` over the ellipse: `a·c + (aᵀQ⁻¹a)^{1/2}`.
    pub(super) fn support(&self, a: &SVector<f64, 2>) -> f64 {
        let inverse = self.form.try_inverse().expect("positive definite");
        a.dot(&self.centre) + a.dot(&(inverse * a)).sqrt()
    }

    /// Returns the nearest point `P` to `z = x − c` outside the ellipse, and the matrix
    /// `(I + λQ)⁻¹`. Here `P = (I + λQ)⁻¹z`, with the multiplier `λ > 0` for which `PᵀQP = 1`.
    /// `PᵀQP` is decreasing and convex in `λ`, so that Newton's method climbs from `λ = 0` to the
    /// root without a safeguard.
    fn nearest(&self, z: &SVector<f64, 2>) -> (SVector<f64, 2>, SMatrix<f64, 2, 2>) {
        let mut lambda = 0.0;
        loop {
            let shifted = SMatrix::identity() + self.form * lambda;
            let inverse = shifted.try_inverse().expect("positive definite");
            let (y, q) = (inverse * z, self.form * (inverse * z));
            // d/dλ yᵀQy = −2 qᵀ (I + λQ)⁻¹ q
            let step = (y.dot(&q) - 1.0) / (2.0 * q.dot(&(inverse * q)));
            if !(step > 1e-16 * (1.0 + lambda)) {
                return (y, inverse);
            }
            lambda += step;
        }
    }
}

impl ClosedSet<2> for Ellipse {
    fn project(&self, x: &SVector<f64, 2>) -> SVector<f64, 2> {
        let z = x - self.centre;
        if z.dot(&(self.form * z)) <= 1.0 { *x } else { self.centre + self.nearest(&z).0 }
    }

    /// From `dy = M (dz − q dλ)` and `qᵀdy = 0` the derivative is `M − M q qᵀM / qᵀM q`, with
    /// `M = (I + λQ)⁻¹`.
    fn projection_derivative(&self, x: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        let z = x - self.centre;
        if z.dot(&(self.form * z)) <= 1.0 {
            return SMatrix::identity();
        }
        let (y, m) = self.nearest(&z);
        let q = self.form * y;
        m - m * q * q.transpose() * m / q.dot(&(m * q))
    }

    fn radius(&self) -> Option<f64> {
        // The larger semi-axis is less than 1/√(least eigenvalue), and the least eigenvalue is at
        // least det/trace.
        let least = self.form.determinant() / self.form.trace();
        Some(self.centre.norm() + least.powf(-0.5))
    }

    fn is_convex(&self) -> bool {
        true
    }
}
