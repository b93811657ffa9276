//! `WayOut`: the length of the shortest way out of a space, infinite if the space is complete.

use nalgebra::SVector;
use tautline::Constants;

use crate::{Evidence, Unit, curves::KnownGeodesics};

/// The length of the shortest way out. A way out is a curve from a point that leaves every compact
/// set.
///
/// A space is complete if and only if no way out has finite length (Hopf and Rinow). For two points
/// it suffices that every way out is longer than the distance between them. Then the closed balls
/// whose radius is this distance are compact, and a minimal geodesic joins the points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WayOut {
    /// The length in `m`; no way out is shorter.
    length: f64,
    /// The assumption behind the length.
    assumed: Option<&'static str>,
}

impl WayOut {
    /// Returns the [normal radius](KnownGeodesics::normal_radius) at a point, since all shorter
    /// geodesics can be continued. If the radius is infinite, it is assumed that geodesics never
    /// end.
    pub fn from<const D: usize>(metric: &impl KnownGeodesics<D>, x: &SVector<f64, D>) -> Self {
        let length = metric.normal_radius(x);
        Self { length, assumed: (length == f64::INFINITY).then_some("geodesics never end") }
    }

    /// Returns an infinite length under the assumption that `c₁ ≤ H` everywhere. A way out of the
    /// ball of radius `r` then has at least the length `√c₁ r`.
    #[must_use]
    pub fn by_c1(constants: Constants) -> Self {
        let length = constants.c1().sqrt() * f64::INFINITY;
        Self { length, assumed: Some("c₁ ≤ λ_min(H) everywhere") }
    }

    /// Returns whether every way out is longer than `length`, in `m`.
    #[must_use]
    pub fn exceeds(self, length: f64) -> bool {
        self.length > length
    }

    /// Adds the hypothesis that no way out is shorter than `length`, in `m`, or else the assumption
    /// behind the length. The theorems need `>`; as everywhere with an allowance for rounding, `≥`
    /// is checked.
    pub(super) fn given_longer(self, evidence: Evidence, [length, granted]: [f64; 2]) -> Evidence {
        match self.assumed {
            Some(claim) => evidence.assumed(claim),
            None => {
                let claim = "no way out is shorter than d";
                evidence.given(claim, Unit::LENGTH, [length, self.length], granted)
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::SVector;
    use tautline::{
        gallery::{Constant, Hyperbolic, Separable, Shear, Sphere},
        norm_squared,
    };

    use super::WayOut;
    use crate::{
        Evidence, Finding, Statement,
        curves::{Curve, Geodesic, KnownGeodesics},
    };

    /// Returns whether every way out is longer than `length`.
    fn longer(way_out: WayOut, length: f64) -> bool {
        let evidence = Evidence::of(Statement::Proposition3_2);
        way_out.given_longer(evidence, [length, 0.0]).finding() == Finding::Holds
    }

    /// Checks that geodesics of lengths 1, 4 and 16 from `x` exist in all directions and are
    /// minimal.
    fn goes_on<M: KnownGeodesics<2> + Copy>(metric: M, x: [f64; 2]) {
        let x = SVector::from(x);
        assert!(longer(WayOut::from(&metric, &x), f64::MAX));
        for k in 0..8 {
            let (sin, cos) = (f64::from(k) * 0.8).sin_cos();
            let direction = SVector::from([cos, sin]);
            let unit = direction / norm_squared(&metric, &x, &direction).sqrt();
            for length in [1.0, 4.0, 16.0] {
                let geodesic = Geodesic::leaving(metric, x, unit * length);
                let end = geodesic.motion(1.0).position;
                let distance = metric.distance(&x, &end).expect("known");
                // In the ball model, a point at distance 16 is 4e−7 from the rim, and is known to
                // within 1e−16.
                assert!((distance - length).abs() <= 1e-8 * length, "{length}: {distance}");
            }
        }
    }

    #[test]
    fn geodesics_go_on_where_no_way_out_is_finite() {
        goes_on(
            Constant::new(nalgebra::Matrix2::new(2.0, 1.0, 1.0, 2.0)).expect("definite"),
            [1.0, 0.0],
        );
        goes_on(Shear::new(0.5, 1.0).expect("a wave number"), [1.0, -2.0]);
        goes_on(Separable::new([0.3, -0.5], [1.0, 2.0]).expect("below one"), [0.3, 0.7]);
        goes_on(Hyperbolic, [0.1, -0.3]);
    }

    /// The distance to the missing point is `π − 2 arctan |x|`.
    #[test]
    fn the_way_out_of_the_sphere_leads_to_the_missing_point() {
        let way_out = WayOut::from(&Sphere, &SVector::from([0.0, 1.0]));
        let half = std::f64::consts::FRAC_PI_2;
        assert!(longer(way_out, half - 1e-15) && !longer(way_out, half + 1e-15));
        // On the equator H = I. At the distance 10⁻⁶ before the missing point, |x| = cot(½ 10⁻⁶).
        let v = SVector::from([0.0, half - 1e-6]);
        let far = Geodesic::leaving(Sphere, SVector::from([0.0, 1.0]), v);
        let end = far.motion(1.0).position.norm();
        assert!((end - 2e6).abs() <= 1e-3 * end, "{end}");
    }

    #[test]
    fn by_c1_assumes_that_c1_holds_everywhere() {
        let constants = tautline::Constants::new(0.5, 1.0, 1.0).expect("in order");
        let begun = Evidence::of(Statement::Proposition6_2);
        let evidence = WayOut::by_c1(constants).given_longer(begun, [3.0, 0.0]);
        assert_eq!(evidence.assumed, ["c₁ ≤ λ_min(H) everywhere"]);
        assert!(evidence.hypotheses.is_empty());
    }
}
