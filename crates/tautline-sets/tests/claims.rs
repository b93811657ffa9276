//! What sets say of themselves: whether they are convex, and the numbers they were made of.

use std::sync::Arc;

use nalgebra::{SMatrix, SVector, vector};
use tautline_sets::{
    AffineSubspace, AxisBox, Ball, ClosedSet, FiniteSet, HalfSpace, Point, Segment, SetError,
    Sphere, Union,
};

/// A set that implements no more than it has to.
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
fn the_convex_sets_say_so_and_the_others_do_not() -> Result<(), SetError> {
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
        // Once more behind a pointer, which is a set too.
        assert!(!set.is_convex() && !Arc::new(Arc::clone(set)).is_convex(), "{set:?}");
    }
    Ok(())
}

#[test]
fn a_set_that_says_nothing_is_one_piece_without_seeds() {
    assert!(Origin.pieces().is_empty() && Origin.seeds().is_empty());
}

#[test]
fn numbers_come_out_as_they_went_in() -> Result<(), SetError> {
    assert_eq!(Ball::new([0.0, 0.0], 0.75)?.r(), 0.75);
    assert_eq!(Sphere::new([0.0, 0.0], 0.75)?.r(), 0.75);
    // 3 x₁ + 4 x₂ ≤ 10 is 0.6 x₁ + 0.8 x₂ ≤ 2.
    let wall = HalfSpace::new([3.0, 4.0], 10.0)?;
    assert!((wall.offset() - 2.0).abs() <= 1e-15 && (wall.normal()[1] - 0.8).abs() <= 1e-15);
    Ok(())
}

/// A sphere of no radius is a point: nothing moves it.
#[test]
fn a_sphere_of_radius_0_has_no_derivative_at_its_centre() -> Result<(), SetError> {
    let sphere = Sphere::new([1.0, 2.0], 0.0)?;
    assert_eq!(sphere.projection_derivative(&vector![1.0, 2.0]), SMatrix::<f64, 2, 2>::zeros());
    Ok(())
}
