//! `Domain`: where a constant holds.

#[cfg(test)]
mod tests;

use nalgebra::SVector;
use num_traits::{One, Zero};
use tautline_formula::AnyMetric;
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::{
    Cell, CertifyError,
    formula::{Along, dependence, is_radial, superfluous},
};

/// A convex compact set on which constants are proved, and the scope on which they then hold.
///
/// On a convex set the largest `‖DH‖` is the Lipschitz constant of `H`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    cell: Cell<D>,
    ball: Option<(SVector<f64, D>, f64)>,
    scope: Scope,
}

/// What a domain represents.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scope {
    /// Itself.
    Region,
    /// All of space: proved.
    Space,
    /// All of space: declared.
    SettledSpace,
}

impl<const D: usize> Domain<D> {
    /// How far [`Domain::space`] reaches where a metric is neither constant nor periodic: `2¹⁰⁰ ℓ`.
    ///
    /// Tenth powers of coordinates do not overflow there, and times the least double, which
    /// replaces what underflows, they are negligible.
    pub const REACH: f64 = f64::from_bits((1023 + 100) << 52);

    /// Returns a box.
    #[must_use]
    pub fn cell(cell: Cell<D>) -> Self {
        Self { cell, ball: None, scope: Scope::Region }
    }

    /// Returns the ball `|x − centre| ≤ radius`, both in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotARadius`], [`CertifyError::NotASide`] for a centre that is not finite.
    pub fn ball(centre: impl Into<SVector<f64, D>>, radius: f64) -> Result<Self, CertifyError> {
        let centre = centre.into();
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(CertifyError::NotARadius { radius });
        }
        // One double farther, since the sums are rounded. Not for the radius 0: nothing is rounded,
        // and a derivative may vanish at the centre only.
        let cell = if radius == 0.0 {
            Cell::new(centre, centre)?
        } else {
            Cell::new(
                centre.map(|c| (c - radius).next_down()),
                centre.map(|c| (c + radius).next_up()),
            )?
        };
        Ok(Self { cell, ball: Some((centre, radius)), scope: Scope::Region })
    }

    /// Returns a box that represents all of `R^D`, as far as the formula of `metric` shows.
    ///
    /// Its width is 0 along a coordinate that does not occur in the formula, or only in differences
    /// with others, and along all but the first if the formula is a function of `|x|²` times the
    /// identity. Along a coordinate in which the formula is periodic, it is one period, rounded up.
    /// All this is read off the formula, not sampled: it follows sines, cosines and tangents of
    /// linear functions with coefficients that are doubles with a common divisor. Along any other
    /// coordinate the box reaches from `−2¹⁰⁰` to `2¹⁰⁰`, and
    /// [`is_all_of_space`](Domain::is_all_of_space) is false: nothing is known beyond
    /// [`REACH`](Domain::REACH).
    ///
    /// ```
    /// use tautline_certify::Domain;
    /// use tautline_metrics::gallery::{Lens, Valleys};
    ///
    /// let valleys = Domain::<2>::space(&Valleys);
    /// let [x1, x2] = valleys.bounding_cell().sides();
    /// assert!(valleys.is_all_of_space());
    /// assert!(x1.lo() == 0.0 && 6.28 < x1.hi() && x1.hi() < 6.29 && x2.width() == 0.0);
    ///
    /// let lens = Domain::<2>::space(&Lens::new(1.0, 1.0)?);
    /// assert!(!lens.is_all_of_space());
    /// # Ok::<(), tautline_metrics::gallery::GalleryError>(())
    /// ```
    #[must_use]
    pub fn space(metric: &impl Metric<D>) -> Self {
        let metric = &AnyMetric::new(metric);
        let along = along(metric);
        let sides = along.map(|along| match along {
            Along::Constant => Interval::zero(),
            // 2π = 8 arctan 1, enclosed.
            Along::Periodic(wave_number) => {
                let period = Interval::constant(1.0).atan() * 8.0 / wave_number;
                Interval::zero().hull(period)
            }
            Along::Unknown => Interval::point(-Self::REACH).hull(Interval::point(Self::REACH)),
        });
        let whole = along.iter().all(|along| *along != Along::Unknown);
        let scope = if whole { Scope::Space } else { Scope::Region };
        let corner = |end: fn(Interval) -> f64| SVector::from(sides.map(end));
        // The periods of the least wave numbers overflow.
        let cell = Cell::new(corner(Interval::lo), corner(Interval::hi));
        match cell {
            Ok(cell) => Self { cell, ball: None, scope },
            Err(_) => {
                let far = SVector::from_element(Self::REACH);
                let cell = Cell::new(-far, far).expect("finite");
                Self { cell, ball: None, scope: Scope::Region }
            }
        }
    }

    /// Returns [`space`](Domain::space) as all of `R^D`, for a metric that you declare to settle:
    /// beyond [`REACH`](Domain::REACH) it is constant.
    ///
    /// Metrics with Gaussian or saturated parts are examples. The declaration is checked on the
    /// last octave: for `R/2 ≤ |xₖ| ≤ R`, with the reach `R`, and all other coordinates within
    /// [`space`](Domain::space), `R |∂H|` and `R² |∂²H|` are at most `10⁻⁹ Hᵢᵢ` in each entry.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotSettled`] with the coordinate along which the check fails;
    /// [`CertifyError::NotRecorded`].
    pub fn settled_space(metric: &impl Metric<D>) -> Result<Self, CertifyError> {
        let metric = &AnyMetric::new(metric);
        metric.formula().map_err(CertifyError::NotRecorded)?;
        let space = Self::space(metric);
        let far = |side: &Interval| side.hi() == Self::REACH;
        for coordinate in (0..D).filter(|&k| far(&space.cell.sides()[k])) {
            for sign in [1.0, -1.0] {
                let mut shell = *space.cell.sides();
                shell[coordinate] =
                    (Interval::point(0.5).hull(Interval::one())) * (sign * Self::REACH);
                let change = relative_change(metric, &shell);
                if !(change <= 1e-9) {
                    return Err(CertifyError::NotSettled { coordinate, change });
                }
            }
        }
        Ok(if space.is_all_of_space() {
            space
        } else {
            Self { scope: Scope::SettledSpace, ..space }
        })
    }

    /// Returns the bounding box; the domain itself unless it is a ball.
    #[must_use]
    pub fn bounding_cell(&self) -> &Cell<D> {
        &self.cell
    }

    /// Returns whether constants on the domain hold on all of `R^D`, for the metric that the domain
    /// was made for: as its formula proves, or as you declared to
    /// [`settled_space`](Domain::settled_space).
    #[must_use]
    pub fn is_all_of_space(&self) -> bool {
        self.scope != Scope::Region
    }

    /// Returns the same for any metric, whatever metric the domain was made for.
    pub(crate) fn represents_space_for(&self, metric: &impl Metric<D>) -> bool {
        match self.scope {
            Scope::Region => false,
            Scope::Space => *self == Self::space(metric),
            Scope::SettledSpace => Self::settled_space(metric).is_ok_and(|space| *self == space),
        }
    }

    /// Returns whether `cell` certainly misses the domain.
    pub(crate) fn misses(&self, cell: &Cell<D>) -> bool {
        self.ball.is_some_and(|(centre, radius)| {
            let nearest = distance_squared(&cell.nearest(&centre), &centre);
            nearest.lo() > Interval::point(radius).sqr().hi()
        })
    }

    /// Returns a point of `cell` that certainly lies in the domain, its midpoint if possible.
    pub(crate) fn point_in(&self, cell: &Cell<D>) -> Option<SVector<f64, D>> {
        let middle = cell.midpoint();
        let Some((centre, radius)) = self.ball else { return Some(middle) };
        let inside = |x: &SVector<f64, D>| {
            distance_squared(x, &centre).hi() <= Interval::point(radius).sqr().lo()
        };
        if inside(&middle) {
            return Some(middle);
        }
        // On the sphere or just inside, on the ray through the midpoint; then clamped to the cell.
        let away = middle - centre;
        let pulled = centre + away * (radius / away.norm() * (1.0 - 4.0 * f64::EPSILON));
        [cell.nearest(&pulled), cell.nearest(&centre)].into_iter().find(|x| inside(x))
    }
}

/// How the metric depends on each coordinate, up to motions that leave the constants unchanged.
fn along<const D: usize>(metric: &AnyMetric<'_, D>) -> [Along; D] {
    let Ok(formula) = metric.formula() else { return [Along::Unknown; D] };
    let mut along = dependence(formula);
    if is_radial(formula) {
        // A ray: constants do not depend on the direction.
        along.iter_mut().skip(1).for_each(|along| *along = Along::Constant);
    }
    for (along, superfluous) in along.iter_mut().zip(superfluous(formula)) {
        if superfluous {
            *along = Along::Constant;
        }
    }
    along
}

/// The largest of `R |∂ₖHᵢⱼ|` and `R² |∂ₖ∂ₗHᵢⱼ|` on a box, over the least diagonal entry, for the
/// reach `R`.
fn relative_change<const D: usize>(metric: &impl Metric<D>, sides: &[Interval; D]) -> f64 {
    let reach = Interval::point(Domain::<D>::REACH);
    let gram = metric.gram(&SVector::from(Jet2::variables(sides)));
    let least = (0..D).map(|i| gram[(i, i)].value()).reduce(Interval::hull);
    let mut most = Interval::zero();
    for entry in gram.iter() {
        for k in 0..D {
            most = most.hull(entry.first(k) * reach);
            for l in k..D {
                most = most.hull(entry.second(k, l) * reach.sqr());
            }
        }
    }
    match least {
        Some(least) if least.lo() > 0.0 => (Interval::point(most.magnitude()) / least.lo()).hi(),
        _ => f64::NAN,
    }
}

fn distance_squared<const D: usize>(x: &SVector<f64, D>, y: &SVector<f64, D>) -> Interval {
    x.iter().zip(y).fold(Interval::zero(), |sum, (&x, &y)| {
        sum + (Interval::point(x) - Interval::point(y)).sqr()
    })
}
