//! An affine subspace, which is a point, a line, a plane and so on.

use nalgebra::{SMatrix, SVector};
use tautline_scalar::{ANY, Interval};

use crate::any_set::closed_set_in_any;
use crate::kind::{Kind, Part, Piece, Value};
use crate::numerics::norm::{norm_above, polar};
use crate::numerics::place::{Place, add, diagonal, dot, largest, minus, vector};
use crate::numerics::proof;
use crate::set_error::{SetError, finite_vector, known};
use crate::{AnySet, ClosedSet, Shape};

/// The affine subspace `p + span(q₁, …, qₖ)`, where `0 ≤ k ≤ D`. It is unbounded for `k ≥ 1`.
///
/// With orthonormal `qᵢ` and `Q = (q₁ … qₖ)`:
///
/// ```text
/// P(x) = p + QQᵀ (x − p),    DP(x) = QQᵀ
/// ```
///
/// Accuracy: `P(x)` lies in the subspace up to a few roundings of `|p|` and `|P(x) − p|`. Choose a
/// `p` that is not much farther from the origin than the points of interest. For `k = D` the
/// subspace is `R^D`, and `P(x) = x` exactly.
#[derive(Clone, Debug, PartialEq)]
pub struct AffineSubspace<const D: usize> {
    base: Box<[f64]>,
    /// The coordinates of the orthonormal directions, one direction after the other.
    basis: Box<[f64]>,
    /// The directions as given. They define the subspace exactly, while the basis is rounded.
    directions: Vec<Box<[f64]>>,
    /// The projector `QQᵀ`.
    projector: Box<[f64]>,
}

impl<const D: usize> AffineSubspace<D> {
    /// Returns the subspace through `base`, in `ℓ`, that is spanned by `directions` of any length.
    ///
    /// Without directions it is the point `base`; the type of the directions must then be explicit:
    /// `AffineSubspace::new(base, [[0.0; D]; 0])`.
    ///
    /// # Errors
    ///
    /// [`SetError::NonFiniteCoordinate`] if a coordinate is not finite;
    /// [`SetError::DependentDirection`] if a direction, such as zero, lies in the span of the
    /// directions before it, up to a relative `4 D² ε`.
    pub fn new<V: Into<SVector<f64, D>>>(
        base: impl Into<SVector<f64, D>>,
        directions: impl IntoIterator<Item = V>,
    ) -> Result<AffineSubspace<D>, SetError> {
        let directions = directions.into_iter().map(|v| -> SVector<f64, D> { v.into() });
        AffineSubspace::from_slices(base.into().as_slice(), directions)
    }

    /// Returns the subspace through the point with these coordinates, spanned by directions with those.
    ///
    /// # Errors
    ///
    /// As for [`AffineSubspace::new`]; also [`SetError::Coordinates`] if a vector has not `D`
    /// coordinates, or not as many as `base`.
    pub fn from_slices(
        base: &[f64],
        directions: impl IntoIterator<Item = impl AsRef<[f64]>>,
    ) -> Result<AffineSubspace<D>, SetError> {
        let base = finite_vector("the base point", base, known(D))?;
        let dimension = base.len();
        let mut basis: Vec<Place> = Vec::new();
        let mut given = Vec::new();
        for (index, direction) in directions.into_iter().enumerate() {
            let direction = finite_vector("a direction", direction.as_ref(), Some(dimension))?;
            let Some((_, mut q)) = polar(&direction) else {
                return Err(SetError::DependentDirection { index, remainder: 0.0 });
            };
            given.push(direction);
            // Gram–Schmidt runs twice: the first round leaves components of size ε/remainder along
            // the earlier directions.
            let mut remainder = 1.0;
            for _ in 0..2 {
                for earlier in &basis {
                    let share = dot(earlier, &q);
                    add(&mut q, earlier, -share);
                }
                let (length, unit) = polar(&q).unwrap_or((0.0, q));
                remainder *= length;
                // A product q·e of unit vectors carries at most D + 1 roundings of ε/2, and its
                // subtraction two more. There are fewer than D products, so that the error is below
                // 2 D² ε for D ≥ 2. The bound is doubled for directions that are dependent in
                // decimals and rounded on input.
                if !(remainder > 4.0 * (dimension * dimension) as f64 * f64::EPSILON) {
                    return Err(SetError::DependentDirection { index, remainder });
                }
                q = unit;
            }
            basis.push(q);
        }
        let mut projector = vec![0.0; dimension * dimension];
        if basis.len() == dimension {
            diagonal(&mut projector, dimension, |_| 1.0);
        } else {
            for q in &basis {
                let products = q.iter().flat_map(|v| q.iter().map(move |u| u * v));
                projector.iter_mut().zip(products).for_each(|(sum, product)| *sum += product);
            }
        }
        let basis = basis.into_iter().flatten().collect();
        Ok(AffineSubspace { base, basis, directions: given, projector: projector.into() })
    }

    /// Returns the point `p`, in `ℓ`.
    #[must_use]
    pub fn base(&self) -> &SVector<f64, D> {
        vector(&self.base)
    }

    /// Returns the coordinates of the point `p`, in `ℓ`.
    #[must_use]
    pub fn base_slice(&self) -> &[f64] {
        &self.base
    }

    /// Returns the orthonormal directions `q₁, …, qₖ`, which are pure numbers.
    #[must_use]
    pub fn basis(&self) -> &[SVector<f64, D>] {
        bytemuck::cast_slice(&self.basis)
    }

    /// Returns the directions as they were given, which define the subspace exactly.
    #[must_use]
    pub fn given_slices(&self) -> &[Box<[f64]>] {
        &self.directions
    }

    /// The kind of such a set: its names and parts.
    pub const KIND: Kind = Kind {
        key: "affine",
        name: "an affine subspace",
        about: "The affine subspace through `through`, spanned by `directions`.",
        parts: &[
            Part::vector("through", "A point of the subspace."),
            Part::vectors("directions", "Linearly independent directions.").directions(),
        ],
    };

    /// Returns the set of these values; `None` if their forms are not those of the parts.
    pub(crate) fn of(values: &[Value]) -> Option<Result<Self, SetError>> {
        let [Value::Vector(base), Value::Vectors(directions)] = values else { return None };
        Some(AffineSubspace::from_slices(base, directions))
    }

    pub(crate) fn cast<const E: usize>(self) -> AffineSubspace<E> {
        let Self { base, basis, directions, projector } = self;
        AffineSubspace { base, basis, directions, projector }
    }

    /// Returns whether the subspace is all of the space.
    fn is_all(&self) -> bool {
        self.directions.len() == self.base.len()
    }

    /// Returns an orthonormal direction.
    fn direction(&self, i: usize) -> &[f64] {
        let dimension = self.base.len();
        &self.basis[i * dimension..][..dimension]
    }
}

impl<const D: usize> AnySet for AffineSubspace<D> {
    fn dimension(&self) -> usize {
        self.base.len()
    }

    fn project(&self, x: &mut [f64]) {
        if self.is_all() {
            return;
        }
        let offset = minus(x, &self.base);
        x.copy_from_slice(&self.base);
        for i in 0..self.directions.len() {
            let q = self.direction(i);
            add(x, q, dot(q, &offset));
        }
    }

    fn projection_derivative(&self, _x: &[f64], derivative: &mut [f64]) {
        derivative.copy_from_slice(&self.projector);
    }

    fn radius(&self) -> Option<f64> {
        self.basis.is_empty().then(|| norm_above(&proof::point(&self.base)))
    }

    fn enclosing_ball(&self) -> Option<(Vec<f64>, f64)> {
        self.basis.is_empty().then(|| (self.base.to_vec(), 0.0))
    }

    fn is_convex(&self) -> bool {
        true
    }

    fn member_near(&self, x: &[f64]) -> Option<Vec<Interval>> {
        let k = self.directions.len();
        if self.is_all() {
            return Some(proof::point(x));
        }
        let along = |v: &[f64]| v.iter().filter(|&&coordinate| coordinate != 0.0).count();
        if self.directions.iter().all(|v| along(v) == 1) {
            // Axes span their coordinates, so nothing rounds.
            let free = |i: usize| self.directions.iter().any(|v| v[i] != 0.0);
            let member = |i: usize| if free(i) { x[i] } else { self.base[i] };
            return Some((0..x.len()).map(|i| Interval::point(member(i))).collect());
        }
        // p + Σ tᵢ vᵢ is a member for any tᵢ. The tᵢ that give P(x), up to rounding, solve the
        // triangular system QᵀV t = Qᵀ(x − p), where V has the given directions up to powers of
        // two.
        let units: Vec<f64> =
            self.directions.iter().map(|v| proof::power_of_two(largest(v))).collect();
        let offset = minus(x, &self.base);
        let mut t = vec![0.0; k];
        for i in (0..k).rev() {
            let entry = |j: usize| {
                let scaled: Place = self.directions[j].iter().map(|v| v / units[j]).collect();
                dot(self.direction(i), &scaled)
            };
            let later: f64 = (i + 1..k).map(|j| entry(j) * t[j]).sum();
            t[i] = (dot(self.direction(i), &offset) - later) / entry(i);
        }
        let mut member = proof::point(&self.base);
        for ((v, unit), t) in self.directions.iter().zip(&units).zip(&t) {
            let steps = v.iter().map(|&v| Interval::point(v) / *unit * *t);
            member.iter_mut().zip(steps).for_each(|(sum, step)| *sum += step);
        }
        proof::finite(member)
    }

    fn shape(&self) -> Option<Shape<ANY>> {
        Some(Shape::AffineSubspace(self.clone().cast()))
    }
}

impl<const D: usize> Piece for AffineSubspace<D> {
    fn kind(&self) -> Kind {
        Self::KIND
    }

    fn values(&self) -> Vec<Value> {
        let directions = self.given_slices().iter().map(|v| v.to_vec()).collect();
        vec![Value::Vector(self.base_slice().to_vec()), Value::Vectors(directions)]
    }

    fn boxes(&self) -> Vec<[Vec<f64>; 2]> {
        Vec::new()
    }
}

impl<const D: usize> ClosedSet<D> for AffineSubspace<D> {
    closed_set_in_any!(self => Shape::AffineSubspace(self.clone()));
}

#[cfg(test)]
mod tests {
    use super::AffineSubspace;
    use crate::laws::{Case, check, scale, vector_in};
    use crate::numerics::exact::{Exact, meets_line, reaches_subspace};
    use crate::{ClosedSet, SetError};
    use nalgebra::{DMatrix, Matrix2, Matrix3, SVector, vector};
    use proptest::prelude::*;
    use tautline_scalar::Interval;

    /// Returns the matrix with the directions as columns.
    fn matrix<const D: usize>(directions: &[SVector<f64, D>]) -> DMatrix<f64> {
        DMatrix::from_fn(D, directions.len(), |i, j| directions[j][i])
    }

    /// Computes the distance of `x` from `p + span` by Householder reflections, without
    /// Gram–Schmidt.
    fn distance<const D: usize>(
        p: SVector<f64, D>,
        directions: &[SVector<f64, D>],
        x: &SVector<f64, D>,
    ) -> f64 {
        let offset = DMatrix::from_column_slice(D, 1, (x - p).as_slice());
        if directions.is_empty() {
            return offset.norm();
        }
        let q = matrix(directions).qr().q();
        (&q * q.tr_mul(&offset) - offset).norm()
    }

    fn case<const D: usize>() -> impl Strategy<Value = Case<D>> {
        let directions = proptest::collection::vec(vector_in::<D>(1.0), 0..=D);
        // Two ways to compute the same span differ by a factor of the condition number of the
        // directions. With singular values between 0.2 and 2 the factor is at most 10, which the
        // tolerance of the laws covers.
        let steep = directions.prop_filter("the directions are independent", |directions| {
            directions.is_empty() || matrix(directions).singular_values().min() >= 0.2
        });
        (vector_in::<D>(3.0), steep, scale()).prop_map(|(p, directions, scale)| {
            let set = AffineSubspace::new(p * scale, directions.iter().copied());
            let [spanning, exactly] = std::array::from_fn(|_| directions.clone());
            Case {
                farthest: directions.is_empty().then_some(p),
                member: Box::new(move |w| {
                    spanning.iter().enumerate().fold(p, |sum, (i, v)| sum + v * w[i])
                }),
                defect: Box::new(move |x| distance(p, &directions, x)),
                held: Box::new(move |y| match exactly.as_slice() {
                    [v] => meets_line(y, &p, &std::array::from_fn(|i| Exact::new(v[i])), false),
                    more => reaches_subspace(y, &p, more),
                }),
                kink: Box::new(|_| f64::INFINITY),
                set: Box::new(set.expect("independent")),
                scale,
            }
        })
    }

    #[test]
    fn affine_subspace_obeys_the_laws() {
        check(case::<1>());
        check(case::<2>());
        check(case::<4>());
    }

    #[test]
    fn affine_subspace_of_nearly_parallel_directions_is_their_plane() {
        // The second direction differs from the first by 1e-8 in x₃, so the plane is x₂ = x₁.
        let plane = AffineSubspace::new([0.0; 3], [[1.0, 1.0, 0.0], [1.0, 1.0, 1e-8]])
            .expect("independent");
        let expected = Matrix3::new(0.5, 0.5, 0.0, 0.5, 0.5, 0.0, 0.0, 0.0, 1.0);
        let derivative = plane.projection_derivative(&SVector::zeros());
        // The second direction is known to within ε/1e-8.
        assert!((derivative - expected).amax() <= 4.0 * f64::EPSILON / 1e-8);
        // The basis is still orthonormal up to rounding, owing to the second round.
        let cosine = plane.basis()[0].dot(&plane.basis()[1]);
        assert!(cosine.abs() <= 8.0 * f64::EPSILON, "{cosine:e}");
    }

    #[test]
    fn affine_subspace_may_be_a_point_or_the_whole_space() {
        let point = AffineSubspace::new([3.0, 4.0], [[0.0; 2]; 0]).expect("no direction");
        assert_eq!(point.project(&vector![7.0, 7.0]), vector![3.0, 4.0]);
        assert_eq!(point.radius(), Some(5.0));
        let all = AffineSubspace::new([3.0, 4.0], [[1.0, 2.0], [0.1, 0.3]]).expect("two");
        assert_eq!(all.project(&vector![0.1, 0.7]), vector![0.1, 0.7]);
        assert_eq!(all.radius(), None);
        assert_eq!(all.projection_derivative(&vector![0.1, 0.7]), Matrix2::identity());
    }

    /// Mixes axes and slanted directions, in either order. Coordinates are free only if all
    /// directions are axes.
    #[test]
    fn affine_subspace_distinguishes_slanted_directions_from_axes() {
        let x = vector![1.0, 2.0, 3.0];
        let near = |directions: [[f64; 3]; 2]| {
            let plane = AffineSubspace::new([0.0, 0.5, 0.25], directions).expect("independent");
            plane.member_near(&x).expect("a member")
        };
        let (first, third) = ([2.0, 0.0, 0.0], [0.0, 0.0, -0.3]);
        for axes in [[first, third], [third, first]] {
            assert_eq!(near(axes), vector![1.0, 0.5, 3.0].map(Interval::point));
        }
        // t (1, 1) from (½, ¼) is nearest to (2, 3) at t = (1.5 + 2.75)/2.
        let slanted = [0.0, 1.0, 1.0];
        for mixed in [[first, slanted], [slanted, first]] {
            let [one, two, three] = near(mixed).into();
            for (found, exact) in [(one, 1.0), (two, 2.625), (three, 2.375)] {
                // The allowance is a few roundings of numbers below 4.
                let off = (found.lo() - exact).abs().max((found.hi() - exact).abs());
                assert!(off <= 16.0 * f64::EPSILON, "{found:?} for {exact}");
            }
        }
    }

    #[test]
    fn affine_subspace_refuses_dependent_directions_by_index() {
        let zero = AffineSubspace::new([0.0; 2], [[0.0; 2]]);
        assert_eq!(zero, Err(SetError::DependentDirection { index: 0, remainder: 0.0 }));
        // These directions are dependent in decimals, but not in f64.
        let parallel = AffineSubspace::new([0.0; 3], [[0.1, 0.2, 0.3], [0.3, 0.6, 0.9]]);
        assert!(matches!(
            parallel,
            Err(SetError::DependentDirection { index: 1, remainder }) if remainder < 1e-14
        ));
        let three = AffineSubspace::new([0.0; 2], [[1.0, 0.0], [1.0, 1.0], [1.0, 2.0]]);
        assert!(matches!(three, Err(SetError::DependentDirection { index: 2, .. })));
        assert!(matches!(
            AffineSubspace::new([0.0; 2], [[f64::NAN, 0.0]]),
            Err(SetError::NonFiniteCoordinate { what: "a direction", index: 0, .. })
        ));
    }
}
