//! `TwoRoutes`: two short ways on the line, far apart, of which a discrete minimiser takes the
//! wrong one.

use nalgebra::{SMatrix, SVector};
use tautline::{Bounded, Constants, Ends, FiniteSet, Metric, Scalar, quadrature::integrate};

use crate::{Known, VerifyError};

/// How `H` runs along a route `[0, l]`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Profile {
    /// `H = start + slope s`.
    Incline {
        /// `H(0)`, in `m²/ℓ²`.
        start: f64,
        /// `H′`, in `m²/ℓ³`.
        slope: f64,
    },
    /// `H = tip + slope |s − ½|`, rounded off at the tip over `10⁻⁶`: it is smooth, and off by
    /// less than `10⁻⁶ |slope|`.
    Tent {
        /// `H(½)`, in `m²/ℓ²`.
        tip: f64,
        /// The slopes are `∓slope`, in `m²/ℓ³`.
        slope: f64,
    },
}

/// How far a tent is rounded off.
const ROUNDED: f64 = 1e-6;

impl Profile {
    fn at<S: Scalar>(self, s: S) -> S {
        match self {
            Profile::Incline { start, slope } => s * slope + start,
            Profile::Tent { tip, slope } => {
                ((s - 0.5).sqr() + ROUNDED * ROUNDED).sqrt() * slope + tip
            }
        }
    }

    /// `∫₀ˡ √H`, in `m`, and its error.
    fn distance(self, length: f64) -> (f64, f64) {
        // Halved, so that a tip lies at an end.
        let half =
            |from: f64, to: f64| integrate(|s| self.at(s).sqrt(), from, to, 4.0 * f64::EPSILON);
        let parts = [half(0.0, 0.5 * length), half(0.5 * length, length)];
        (parts[0].value + parts[1].value, parts[0].error + parts[1].error)
    }
}

/// A metric on the line with one profile along `[0, 1]` and another along `[10, 10 + l]`.
///
/// Between them it passes from one formula to the other; nothing is claimed there but
/// `H ≥ ¼`, so that every other way between the sets is longer.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TwoRoutes {
    profiles: [Profile; 2],
    length: f64,
    constants: Constants,
}

/// Where the second route begins.
const SECOND: f64 = 10.0;

impl TwoRoutes {
    /// Returns the metric with the two profiles, the second of them of length `length`; `None`
    /// unless `½ ≤ H ≤ 2` on both routes, and the slopes are at most `0.1`.
    #[must_use]
    pub fn new(profiles: [Profile; 2], length: f64) -> Option<Self> {
        let mut range = (f64::INFINITY, 0.0_f64, 0.0_f64);
        for (profile, length) in profiles.into_iter().zip([1.0, length]) {
            for s in [0.0, 0.5, length] {
                let h = profile.at(s);
                range = (range.0.min(h), range.1.max(h), range.2);
            }
            let (Profile::Incline { slope, .. } | Profile::Tent { slope, .. }) = profile;
            range.2 = range.2.max(slope.abs());
        }
        let (low, high, l_h) = range;
        let fits = low >= 0.5 && high <= 2.0 && l_h <= 0.1 && (0.5..2.0).contains(&length);
        let constants = Constants::new(low, high, l_h).ok()?;
        fits.then_some(Self { profiles, length, constants })
    }

    /// Returns the problem from `{0, 10}` to `{1, 10 + l}`: the distance is the shorter of the two
    /// routes.
    ///
    /// # Errors
    ///
    /// None for a metric that exists.
    pub fn between_sets(self) -> Result<Known<Self, 1>, VerifyError> {
        let first = FiniteSet::new([[0.0], [SECOND]])?;
        let second = FiniteSet::new([[1.0], [SECOND + self.length]])?;
        let routes = [self.profiles[0].distance(1.0), self.profiles[1].distance(self.length)];
        let shorter = if routes[0].0 <= routes[1].0 { routes[0] } else { routes[1] };
        self.known(Ends::new(first, second)?, shorter)
    }

    /// Returns the problem from 0 to 1, on the first route alone.
    ///
    /// # Errors
    ///
    /// None for a metric that exists.
    pub fn along_the_first(self) -> Result<Known<Self, 1>, VerifyError> {
        self.known(Ends::points([0.0], [1.0])?, self.profiles[0].distance(1.0))
    }

    fn known(
        self,
        ends: Ends<1>,
        (distance, error): (f64, f64),
    ) -> Result<Known<Self, 1>, VerifyError> {
        let distance_error = error + 4.0 * f64::EPSILON * distance;
        Ok(Known { metric: self, ends, distance, distance_error })
    }
}

impl Metric<1> for TwoRoutes {
    fn gram<S: Scalar>(&self, x: &SVector<S, 1>) -> SMatrix<S, 1, 1> {
        // Exactly 1 on the first route and exactly 0 on the second: tanh 45 is 1 in f64.
        let first = (-((x[0] - 5.5) * 10.0).tanh() + 1.0) * 0.5;
        let [a, b] = [self.profiles[0].at(x[0]), self.profiles[1].at(x[0] - SECOND)];
        SMatrix::from_diagonal_element(a * first + b * (-first + 1.0))
    }
}

impl Bounded<1> for TwoRoutes {
    /// Those on the two routes.
    fn constants(&self) -> Constants {
        self.constants
    }
}
