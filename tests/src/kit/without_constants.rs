//! The metrics of the gallery that have constants on balls only: the whole suite in a ball.
//!
//! The corner of the largest cube in a ball is as far from the origin as the ball reaches if its
//! centre lies on a diagonal, so that the constants that are extreme there are attained.

use tautline::gallery::{GaussianFisher, Hyperbolic, Sphere};
use tautline_verify::{kit::MetricCase, prelude::*};

metric_suite!(sphere: Sphere, dimension 2, within 0.3, of [0.5, 0.5], with distances);
metric_suite!(hyperbolic: Hyperbolic, dimension 3, within 0.2, of [0.3, 0.3, 0.3], with distances);
metric_suite!(fisher: GaussianFisher, dimension 2, within 0.5, of [1.0, -0.3], with distances);

/// In a ball as large as that, nothing is near enough for its competitors to stay inside.
#[test]
fn a_ball_with_useless_constants_is_refused() {
    for radius in [1e3, -1.0, f64::NAN] {
        let refused = MetricCase::<_, 2>::within(Sphere, [0.0, 0.0], radius, Effort::default());
        assert!(refused.is_err(), "{radius}");
    }
    assert!(MetricCase::<_, 2>::within(Hyperbolic, [0.0, 0.0], 1.0, Effort::default()).is_err());
}
