//! What sets claim: convexity, members, and the numbers they were made from.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector, vector};
use tautline_scalar::Interval;
use tautline_sets::{
    AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment, SetError,
    Sphere, Union,
};

/// A set with the required methods only.
#[derive(Debug)]
struct Origin;

impl ClosedSet<2> for Origin {
    fn project(&self, _: &SVector<f64, 2>) -> SVector<f64, 2> {
        SVector::zeros()
    }

    fn projection_derivative(&self, _: &SVector<f64, 2>) -> SMatrix<f64, 2, 2> {
        SMatrix::zeros()
    }

    fn radius(&self) -> Option<f64> {
        Some(0.0)
    }
}

#[test]
fn exactly_the_convex_sets_claim_convexity() -> Result<(), SetError> {
    let points = |count: usize| {
        FiniteSet::new((0..count).map(|k| vector![k as f64, 0.0]).collect::<Vec<_>>())
    };
    let convex: [Arc<dyn ClosedSet<2>>; 8] = [
        Arc::new(Point::new([1.0, 2.0])?),
        Arc::new(points(1)?),
        Arc::new(Ball::new([0.0, 0.0], 1.0)?),
        Arc::new(Sphere::new([0.0, 0.0], 0.0)?),
        Arc::new(AxisBox::new([0.0, 0.0], [1.0, 1.0])?),
        Arc::new(Segment::new([0.0, 0.0], [1.0, 1.0])?),
        Arc::new(HalfSpace::new([1.0, 0.0], 1.0)?),
        Arc::new(AffineSubspace::new([0.0, 0.0], [vector![1.0, 1.0]])?),
    ];
    for set in &convex {
        assert!(set.is_convex(), "{set:?}");
    }
    let others: [Arc<dyn ClosedSet<2>>; 4] = [
        Arc::new(points(2)?),
        Arc::new(Sphere::new([0.0, 0.0], 1.0)?),
        Arc::new(Union::new(convex[..2].to_vec())?),
        Arc::new(Origin),
    ];
    for set in &others {
        // A pointer to a set is also a set.
        assert!(!set.is_convex() && !Arc::new(Arc::clone(set)).is_convex(), "{set:?}");
    }
    Ok(())
}

#[test]
fn a_set_by_default_is_one_piece_without_seeds() {
    assert!(Origin.pieces().is_empty() && Origin.seeds().is_empty());
}

#[test]
fn accessors_return_the_given_numbers() -> Result<(), SetError> {
    assert_eq!(Ball::new([0.0, 0.0], 0.75)?.r(), 0.75);
    assert_eq!(Sphere::new([0.0, 0.0], 0.75)?.r(), 0.75);
    // 3 x₁ + 4 x₂ ≤ 10 is the same as 0.6 x₁ + 0.8 x₂ ≤ 2.
    let wall = HalfSpace::new([3.0, 4.0], 10.0)?;
    assert!((wall.offset() - 2.0).abs() <= 1e-15 && (wall.normal()[1] - 0.8).abs() <= 1e-15);
    Ok(())
}

/// A sphere of radius 0 is a point, so its projection is constant.
#[test]
fn a_sphere_of_radius_0_has_no_derivative_at_its_centre() -> Result<(), SetError> {
    let sphere = Sphere::new([1.0, 2.0], 0.0)?;
    assert_eq!(sphere.projection_derivative(&vector![1.0, 2.0]), SMatrix::<f64, 2, 2>::zeros());
    Ok(())
}

/// The numbers are exact here, so that membership is decidable.
#[test]
fn proved_members_stay() -> Result<(), SetError> {
    let members: [(Arc<dyn ClosedSet<2>>, SVector<f64, 2>); 12] = [
        (Arc::new(Point::new([1.0, 2.0])?), vector![1.0, 2.0]),
        (Arc::new(FiniteSet::new([[5.0, 5.0], [1.0, 2.0]])?), vector![1.0, 2.0]),
        (Arc::new(Ball::new([1.0, 1.0], 5.0)?), vector![4.0, 5.0]),
        (Arc::new(Ball::new([1.0, 1.0], 5.0)?), vector![1.0, 1.0]),
        (Arc::new(Ball::new([0.1, 0.2], 0.0)?), vector![0.1, 0.2]),
        (Arc::new(Sphere::new([1.0, 1.0], 5.0)?), vector![-2.0, 5.0]),
        (Arc::new(Sphere::new([0.1, 0.2], 0.0)?), vector![0.1, 0.2]),
        (Arc::new(AxisBox::new([0.0, 0.0], [0.1, 0.0])?), vector![0.1, 0.0]),
        (Arc::new(Segment::new([0.1, 0.3], [0.7, 0.3])?), vector![0.45, 0.3]),
        // The normalised normal is rounded, while the given one is not.
        (Arc::new(HalfSpace::new([1.0, 3.0], 10.0)?), vector![1.0, 3.0]),
        (Arc::new(AffineSubspace::new([0.1, 0.3], [[0.0, 0.7]])?), vector![0.1, 0.45]),
        (Arc::new(AffineSubspace::new([0.0, 0.0], [[1.0, 3.0]])?), vector![0.0, 0.0]),
    ];
    for (set, x) in &members {
        let near = set.member_near(x).expect("a set of this crate");
        assert_eq!(near, x.map(Interval::point), "{set:?}");
        let union = Union::new(vec![Arc::new(Point::new([2.0, 2.0])?), Arc::clone(set)])?;
        assert_eq!(union.member_near(x), Some(near), "{set:?}");
    }
    Ok(())
}

/// No point outside a set is taken for a member, however near it is.
#[test]
fn points_outside_a_set_are_not_taken_for_members() -> Result<(), SetError> {
    let beside: [(Arc<dyn ClosedSet<2>>, SVector<f64, 2>); 7] = [
        (Arc::new(Ball::new([1.0, 1.0], 5.0)?), vector![4.0, 5.0_f64.next_up()]),
        (Arc::new(Sphere::new([1.0, 1.0], 5.0)?), vector![-2.0, 5.0_f64.next_down()]),
        (Arc::new(HalfSpace::new([1.0, 3.0], 10.0)?), vector![1.0, 3.0_f64.next_up()]),
        // In doubles, 0.1 + 0.2 > 0.3.
        (Arc::new(HalfSpace::new([1.0, 1.0], 0.3)?), vector![0.1, 0.2]),
        (Arc::new(Segment::new([0.0, 0.0], [1.0, 3.0])?), vector![0.1, 0.3]),
        (Arc::new(AffineSubspace::new([0.0, 0.0], [[1.0, 3.0]])?), vector![0.1, 0.3]),
        (Arc::new(Point::new([1.0, 2.0])?), vector![1.0, 2.0_f64.next_up()]),
    ];
    for (set, x) in &beside {
        let near = set.member_near(x).expect("a set of this crate");
        assert_ne!(near, x.map(Interval::point), "{set:?}");
        for i in 0..2 {
            // The allowance is a few roundings of coordinates up to 5.
            let far = (near[i].lo() - x[i]).abs().max((near[i].hi() - x[i]).abs());
            assert!(far <= 16.0 * 5.0 * f64::EPSILON, "{set:?}: {near:?}");
        }
    }
    Ok(())
}

/// At the centre of a sphere, the distance zero must not become a divisor.
#[test]
fn the_centre_of_a_sphere_has_a_member_near() -> Result<(), SetError> {
    let near = Sphere::new([1.0, 2.0], 3.0)?.member_near(&vector![1.0, 2.0]);
    assert_eq!(near, Some(vector![4.0, 2.0].map(Interval::point)));
    // c₁ + r is not a double here.
    let near = Sphere::new([0.1, 2.0], 0.7)?.member_near(&vector![0.1, 2.0]).expect("a member");
    assert!(near[0].lo() < near[0].hi() && near[1] == Interval::point(2.0));
    Ok(())
}

/// By default a set proves nothing, and a union skips it.
#[test]
fn a_set_proves_nothing_by_default() -> Result<(), SetError> {
    let x = vector![0.0, 0.0];
    assert_eq!(Origin.member_near(&x), None);
    let shared: Arc<dyn ClosedSet<2>> = Arc::new(Origin);
    assert_eq!(shared.member_near(&x), None);
    assert_eq!(Union::new(vec![Arc::clone(&shared)])?.member_near(&x), None);
    let both = Union::new(vec![shared, Arc::new(Point::new([3.0, 0.0])?)])?;
    assert_eq!(both.member_near(&x), Some(vector![3.0, 0.0].map(Interval::point)));
    Ok(())
}
