//! Signed distances from convex sets under a constant metric.

use nalgebra::{DMatrix, SMatrix, SVector};
use tautline_sets::{AxisBox, Ball, Shape};

/// How often the interval of the multiplier of a ball is halved: a double has 53 bits, and the first
/// halvings may have to find its order of magnitude.
const HALVINGS: usize = 120;

/// Returns the signed distance of `x` from a convex piece under the constant metric `h`, and a nearest
/// point of its boundary. Outside it is the distance from the piece; inside it is minus the distance
/// from the boundary. The result is `None` if `h` is not positive definite or a number is not finite.
pub(crate) fn signed_distance<const D: usize>(
    piece: &Shape<D>,
    h: &SMatrix<f64, D, D>,
    x: &SVector<f64, D>,
) -> Option<(f64, SVector<f64, D>)> {
    let (sign, y) = match piece {
        Shape::Point(point) => (1.0, *point.position()),
        Shape::Ball(ball) if ball.r() == 0.0 => (1.0, *ball.centre()),
        Shape::Ball(ball) => nearest_of_sphere(ball, h, x)?,
        Shape::AxisBox(side) => nearest_of_faces(side, h, x)?,
        Shape::HalfSpace(wall) => {
            let t = wall.normal().dot(x) - wall.offset();
            (t.signum(), foot(h, wall.normal(), t, x)?)
        }
        _ => return None,
    };
    let distance = sign * length(h, &(x - y))?;
    (distance.is_finite() && y.iter().all(|c| c.is_finite())).then_some((distance, y))
}

/// Returns the length of a vector; `None` if it is not a number or the form is negative there.
pub(crate) fn length<const D: usize>(
    h: &SMatrix<f64, D, D>,
    vector: &SVector<f64, D>,
) -> Option<f64> {
    let square = vector.dot(&(h * vector));
    (square >= 0.0).then(|| square.sqrt())
}

/// Returns the point of a hyperplane with the unit normal `n` that is nearest to `x`, which lies at the
/// Euclidean height `t` above it: the one in the direction `h⁻¹n`.
fn foot<const D: usize>(
    h: &SMatrix<f64, D, D>,
    n: &SVector<f64, D>,
    t: f64,
    x: &SVector<f64, D>,
) -> Option<SVector<f64, D>> {
    let along = h.cholesky()?.solve(n);
    Some(x - along * (t / n.dot(&along)))
}

/// Returns the sign of the distance from a ball, and the point of its sphere that is nearest to `x`.
///
/// With `v = x − c` and `w = y − c`, a nearest point satisfies `(h + μI) w = h v` and `|w| = r`, where
/// `h + μI` is positive semidefinite: `μ > 0` outside and `μ < 0` inside. In the axes of `h`, where its
/// eigenvalues are `λᵢ`, `wᵢ = λᵢ vᵢ/(λᵢ + μ)`, and `|w|` decreases with `μ`. If it stays below `r` down
/// to `μ = −λ₁`, the least eigenvalue, then `w₁` is what `r` leaves for it: so at the centre, from which
/// the axis of the least eigenvalue is the shortest way out.
fn nearest_of_sphere<const D: usize>(
    ball: &Ball<D>,
    h: &SMatrix<f64, D, D>,
    x: &SVector<f64, D>,
) -> Option<(f64, SVector<f64, D>)> {
    let away = x - ball.centre();
    let r = ball.r();
    if !(h.iter().chain(away.iter()).all(|entry| entry.is_finite())) {
        // The search for eigenvalues would not end.
        return None;
    }
    let eigen = DMatrix::from_fn(D, D, |i, j| h[(i.min(j), i.max(j))]).symmetric_eigen();
    let first = eigen.eigenvalues.imin();
    let values: [f64; D] = std::array::from_fn(|i| eigen.eigenvalues[i]);
    let least = values[first];
    if !(least > 0.0) {
        return None;
    }
    let v: [f64; D] =
        std::array::from_fn(|k| (0..D).map(|i| eigen.eigenvectors[(i, k)] * away[i]).sum());
    // By the distance `δ = μ + λ₁` from the pole, which does not cancel.
    let w = |i: usize, delta: f64| values[i] * v[i] / ((values[i] - least) + delta);
    let is_outside = |delta: f64| (0..D).map(|i| w(i, delta).powi(2)).sum::<f64>() > r * r;
    let largest = values.iter().fold(0.0, |most: f64, &value| most.max(value));
    // `|w| ≤ λ_D |v|/δ`.
    let (mut low, mut high) = (0.0, largest * (away.norm() / r) + f64::MIN_POSITIVE);
    for _ in 0..HALVINGS {
        // In the middle of the exponents while the interval has several of them.
        let middle =
            if low > 0.0 && high > 4.0 * low { (low * high).sqrt() } else { 0.5 * (low + high) };
        if is_outside(middle) {
            low = middle;
        } else {
            high = middle;
        }
    }
    let mut y: [f64; D] = std::array::from_fn(|i| w(i, high));
    let rest: f64 = (0..D).filter(|&i| i != first).map(|i| y[i] * y[i]).sum();
    y[first] = (r * r - rest).max(0.0).sqrt().copysign(v[first]);
    let point = SVector::from_fn(|i, _| {
        (0..D).map(|k| eigen.eigenvectors[(i, k)] * y[k]).sum::<f64>() + ball.centre()[i]
    });
    Some(((away.norm() - r).signum(), point))
}

/// Returns the sign of the distance from a box, and the point of its boundary that is nearest to `x`.
///
/// The nearest point of the box lies inside one of its `3^D` faces of all dimensions, where it is the
/// nearest point of the plane of that face. Moved into the box, the nearest points of all these planes are
/// members, and the nearest of them is the one that is sought. From inside, the plane of a side is
/// reached first.
fn nearest_of_faces<const D: usize>(
    side: &AxisBox<D>,
    h: &SMatrix<f64, D, D>,
    x: &SVector<f64, D>,
) -> Option<(f64, SVector<f64, D>)> {
    let (lower, upper) = (side.lower(), side.upper());
    let mut best: Option<(f64, SVector<f64, D>)> = None;
    let mut offer = |y: SVector<f64, D>| {
        let distance = length(h, &(x - y))?;
        if best.is_none_or(|(least, _)| distance < least) {
            best = Some((distance, y));
        }
        Some(())
    };
    if (0..D).all(|i| lower[i] <= x[i] && x[i] <= upper[i]) {
        for i in 0..D {
            let n = SVector::from_fn(|j, _| if i == j { 1.0 } else { 0.0 });
            offer(foot(h, &n, x[i] - lower[i], x)?)?;
            offer(foot(h, &n, x[i] - upper[i], x)?)?;
        }
        return best.map(|(_, y)| (-1.0, y));
    }
    for face in 0..3_usize.pow(D as u32) {
        // Along each axis: on the low side, on the high side, or free.
        let kind: [usize; D] = std::array::from_fn(|i| face / 3_usize.pow(i as u32) % 3);
        let fixed = SVector::<f64, D>::from_fn(|i, _| match kind[i] {
            0 => lower[i] - x[i],
            1 => upper[i] - x[i],
            _ => 0.0,
        });
        let is_free = |i: usize| kind[i] == 2;
        let matrix = SMatrix::<f64, D, D>::from_fn(|i, j| {
            if is_free(i) && is_free(j) { h[(i, j)] } else { f64::from(i == j) }
        });
        let pull = h * fixed;
        let right = SVector::from_fn(|i, _| if is_free(i) { -pull[i] } else { fixed[i] });
        let step = matrix.cholesky()?.solve(&right);
        offer(SVector::from_fn(|i, _| (x[i] + step[i]).clamp(lower[i], upper[i])))?;
    }
    best.map(|(_, y)| (1.0, y))
}

#[cfg(test)]
mod tests;
