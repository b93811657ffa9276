//! Runs the kit on the metrics of the gallery that have constants only on balls.
//!
//! If the centre of a ball lies on a diagonal, a corner of the largest cube in the ball is as far
//! from the origin as any point of the ball. A constant whose extreme value is taken at the point
//! of the ball farthest from the origin is therefore attained in the cube.

use tautline::{
    LocalError,
    bounds::LocalityError,
    gallery::{GaussianFisher, Hyperbolic, Sphere},
};
use tautline_kit::{MetricCase, metric, prelude::*};

metric_suite!(sphere: Sphere, dimension 2, within 0.3, of [0.5, 0.5], with distances);
metric_suite!(hyperbolic: Hyperbolic, dimension 3, within 0.2, of [0.3, 0.3, 0.3], with distances);
metric_suite!(fisher: GaussianFisher, dimension 2, within 0.5, of [1.0, -0.3], with distances);

/// Each constant is attained in the cube, so that every mistake in a constant shows.
#[test]
fn wrong_constants_of_a_ball_are_refused() {
    let case = MetricCase::<_, 2>::within(Sphere, [0.5, 0.5], 0.3, Effort::default());
    let case = case.expect("a ball").with_known_distance();
    for outcome in [
        metric::refuses_a_larger_c1(&case),
        metric::refuses_a_smaller_c2(&case),
        metric::refuses_a_smaller_l_h(&case),
        metric::refuses_a_smaller_m_h(&case),
    ] {
        outcome.assert();
        assert!(outcome.note.is_none(), "{outcome}");
    }
}

/// In a huge ball, no two ends are close enough for their competitors to stay inside the ball.
#[test]
fn a_ball_with_useless_constants_is_refused() {
    let refused = |radius| {
        MetricCase::<_, 2>::within(Sphere, [0.0, 0.0], radius, Effort::default())
            .expect_err("no case")
    };
    assert!(matches!(refused(1e3), LocalityError::Escapes { .. }));
    assert!(matches!(refused(0.0), LocalityError::Escapes { .. }));
    for radius in [-1.0, f64::NAN] {
        let LocalityError::NoConstants { reason, .. } = refused(radius) else { panic!("{radius}") };
        assert!(matches!(reason, LocalError::NotARadius { .. }), "{reason}");
    }
    let outside = MetricCase::<_, 2>::within(Hyperbolic, [0.0, 0.0], 1.0, Effort::default());
    let LocalityError::NoConstants { reason, .. } = outside.expect_err("no case") else { panic!() };
    assert!(matches!(reason, LocalError::LeavesTheDomain { limit: 1.0, .. }), "{reason}");
}
