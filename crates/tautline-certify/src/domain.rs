//! `Domain`: where a constant holds.

#[cfg(test)]
mod tests;

use nalgebra::SVector;
use num_traits::{One, Zero};
use tautline_formula::{AnyMetric, Formula};
use tautline_metrics::Metric;
use tautline_scalar::{Interval, Jet2, Scalar};

use crate::{
    Cell, CertifyError,
    constants::lifted::is_bounded,
    formula::{Along, Lift, dependence, is_radial, superfluous},
    patch::{Patch, Point, Region},
};

/// A convex compact set on which constants are proved, and the scope in which they then hold.
///
/// On a convex set the largest `‖DH‖` is the Lipschitz constant of `H`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Domain<const D: usize> {
    cell: Cell<D>,
    ball: Option<(SVector<f64, D>, f64)>,
    scope: Scope,
}

/// What a domain represents: only itself, or all of space.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scope {
    /// Only itself.
    Region,
    /// All of space, as proved.
    Space,
    /// All of space, in the variables of the lifted formula.
    Lifted {
        /// Whether they are independent.
        sharp: bool,
    },
    /// All of space, as declared.
    SettledSpace,
}

impl<const D: usize> Domain<D> {
    /// How far [`Domain::space`] reaches where a metric is neither constant nor periodic: `2¹⁰⁰ ℓ`.
    ///
    /// At this reach tenth powers of coordinates do not overflow. They remain negligible when
    /// multiplied by the least double, which replaces what underflows.
    pub const REACH: f64 = f64::from_bits((1023 + 100) << 52);

    /// Returns the domain that consists of a box.
    #[must_use]
    pub fn cell(cell: Cell<D>) -> Self {
        Self { cell, ball: None, scope: Scope::Region }
    }

    /// Returns the ball `|x − centre| ≤ radius`, both in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotARadius`] if the radius is negative or not finite, and
    /// [`CertifyError::NotASide`] if the centre is not finite.
    pub fn ball(centre: impl Into<SVector<f64, D>>, radius: f64) -> Result<Self, CertifyError> {
        let centre = centre.into();
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(CertifyError::NotARadius { radius });
        }
        // The box reaches one double farther, since the sums are rounded. For radius 0 it does not:
        // nothing is rounded, and a derivative may vanish at the centre only.
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

    /// Returns a domain that represents all of `R^D`, as far as the formula of `metric` shows this.
    ///
    /// The box has width 0 along coordinates on which the constants do not depend. For example, if
    /// the formula depends only on `|x|²`, the width is 0 along all coordinates but the first. Along
    /// a coordinate in which the formula is periodic, the width is one period, rounded up.
    ///
    /// Along any other coordinate the box reaches from `−2¹⁰⁰` to `2¹⁰⁰`. It still represents all of
    /// space if the formula changes with linear forms `a·x` only through `sin`, `cos` and functions
    /// that settle: `tanh`, `arctan`, `e^(−q)` with a sum `q` of squares of such forms, and walls
    /// `1/(d + f e^(a·x))`. Each form is then a variable of its own on the whole line, and the
    /// phases of waves are variables on circles. Constants are sharp if the forms, and the wave
    /// numbers of each form, are linearly independent; otherwise they may be overestimated. Waves of
    /// one form share a phase if their numbers have a common divisor: as doubles, `0.1` and `0.8`
    /// have one, but `0.1` and `0.5` have none that is of use, and far out their phases drift apart.
    ///
    /// For other formulas, [`is_all_of_space`](Domain::is_all_of_space) is false: nothing is known
    /// beyond [`REACH`](Domain::REACH).
    ///
    /// All this is read off the formula, not sampled. The periods found are those of sines, cosines
    /// and tangents of linear functions whose coefficients are doubles with a common divisor.
    ///
    /// ```
    /// use tautline_certify::Domain;
    /// use tautline_formula::Formula;
    /// use tautline_metrics::gallery::{Sphere, Valleys};
    ///
    /// let valleys = Domain::<2>::space(&Valleys);
    /// let [x1, x2] = valleys.bounding_cell().sides();
    /// assert!(valleys.is_all_of_space());
    /// assert!(x1.lo() == 0.0 && 6.28 < x1.hi() && x1.hi() < 6.29 && x2.width() == 0.0);
    ///
    /// let walls = Formula::<2>::parse("4 + tanh(x1) + sin(x1 + 0.3*x2) I", &[])?;
    /// assert!(Domain::space(&walls).is_all_of_space());
    /// assert!(!Domain::<2>::space(&Sphere).is_all_of_space());
    /// # Ok::<(), tautline_formula::TextError>(())
    /// ```
    #[must_use]
    pub fn space(metric: &impl Metric<D>) -> Self {
        let metric = &AnyMetric::new(metric);
        let along = along(metric);
        let sides = along.map(|along| match along {
            Along::Constant => Interval::zero(),
            // 2π is enclosed as 8 arctan 1.
            Along::Periodic(wave_number) => {
                let period = Interval::constant(1.0).atan() * 8.0 / wave_number;
                Interval::zero().hull(period)
            }
            Along::Unknown => Interval::point(-Self::REACH).hull(Interval::point(Self::REACH)),
        });
        let corner = |end: fn(Interval) -> f64| SVector::from(sides.map(end));
        // For the smallest wave numbers, the period overflows.
        let Ok(cell) = Cell::new(corner(Interval::lo), corner(Interval::hi)) else {
            let far = SVector::from_element(Self::REACH);
            let cell = Cell::new(-far, far).expect("finite");
            return Self { cell, ball: None, scope: Scope::Region };
        };
        let scope = if along.iter().all(|along| *along != Along::Unknown) {
            Scope::Space
        } else {
            match lift(metric, &along).filter(is_bounded) {
                Some(lift) => Scope::Lifted { sharp: lift.is_sharp() },
                None => Scope::Region,
            }
        };
        Self { cell, ball: None, scope }
    }

    /// Returns [`space`](Domain::space) as all of `R^D`, for a metric that you declare to settle:
    /// beyond [`REACH`](Domain::REACH) it does not change along those coordinates in which it is
    /// not known to be periodic.
    ///
    /// Metrics with rational parts are examples. The declaration is checked on the last octave: for
    /// `R/2 ≤ |xₖ| ≤ R`, where `R` is the reach, and all other coordinates within
    /// [`space`](Domain::space), `R |∂ₖH|` and `R² |∂ₖ∂ₗH|` must be at most `10⁻⁹ Hᵢᵢ` in each
    /// entry, for all `l`.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotSettled`] with the coordinate along which the check fails;
    /// [`CertifyError::NotRecorded`] if the formula cannot be recorded or is not known to be symmetric.
    pub fn settled_space(metric: &impl Metric<D>) -> Result<Self, CertifyError> {
        let metric = &AnyMetric::new(metric);
        metric.formula().and_then(Formula::symmetric).map_err(CertifyError::NotRecorded)?;
        let space = Self::space(metric);
        if space.is_all_of_space() {
            return Ok(space);
        }
        let far = |side: &Interval| side.hi() == Self::REACH;
        for coordinate in (0..D).filter(|&k| far(&space.cell.sides()[k])) {
            for sign in [1.0, -1.0] {
                let mut shell = *space.cell.sides();
                shell[coordinate] =
                    (Interval::point(0.5).hull(Interval::one())) * (sign * Self::REACH);
                let change = relative_change(metric, &shell, coordinate);
                if !(change <= 1e-9) {
                    return Err(CertifyError::NotSettled { coordinate, change });
                }
            }
        }
        Ok(Self { scope: Scope::SettledSpace, ..space })
    }

    /// Returns the bounding box, which is the domain itself unless the domain is a ball or, for some
    /// metrics, [all of space](Domain::space).
    #[must_use]
    pub fn bounding_cell(&self) -> &Cell<D> {
        &self.cell
    }

    /// Returns whether constants on the domain hold on all of `R^D` for the metric that the domain
    /// was made for, either because its formula proves it or because you declared it to
    /// [`settled_space`](Domain::settled_space).
    #[must_use]
    pub fn is_all_of_space(&self) -> bool {
        self.scope != Scope::Region
    }

    /// Returns whether constants hold on all of `R^D` only by your word that the metric
    /// [settles](Domain::settled_space).
    #[must_use]
    pub fn is_declared_to_settle(&self) -> bool {
        self.scope == Scope::SettledSpace
    }

    /// Returns whether the [bounding box](Domain::bounding_cell) alone represents all of `R^D`: the
    /// metric is periodic along each coordinate, or its constants do not depend on it.
    #[must_use]
    pub fn is_one_period(&self) -> bool {
        self.scope == Scope::Space
    }

    /// Returns whether constants on the domain can be proved as close to the best ones as wanted. They
    /// cannot if the domain is all of space for a formula with linearly dependent forms, such as
    /// `tanh(x1)`, `tanh(x2)` and `tanh(x1 + x2)`, or with two phases of waves whose numbers have a
    /// simple ratio. More complicated relations between three or more phases are not noticed.
    #[must_use]
    pub fn is_sharp(&self) -> bool {
        self.scope != Scope::Lifted { sharp: false }
    }

    /// Returns whether constants of `metric` on the domain hold on all of `R^D`. The domain may have
    /// been made for another metric.
    pub(crate) fn represents_space_for(&self, metric: &impl Metric<D>) -> bool {
        match self.scope {
            Scope::Region => false,
            Scope::Space | Scope::Lifted { .. } => *self == Self::space(metric),
            Scope::SettledSpace => Self::settled_space(metric).is_ok_and(|space| *self == space),
        }
    }

    /// Returns the lifted formula in whose variables the domain is all of space for `metric`.
    pub(crate) fn lift(&self, metric: &AnyMetric<'_, D>) -> Option<Lift<D>> {
        let is_lifted =
            matches!(self.scope, Scope::Lifted { .. }) && self.represents_space_for(metric);
        is_lifted.then(|| lift(metric, &along(metric))).flatten()
    }
}

impl<const D: usize> Region for Domain<D> {
    fn patches(&self) -> Vec<Patch> {
        vec![Patch { sides: self.cell.sides().to_vec(), chart: 0 }]
    }

    fn misses(&self, patch: &Patch) -> bool {
        self.ball.is_some_and(|(centre, radius)| {
            let nearest = distance_squared(&nearest(patch, &centre), &centre);
            nearest.lo() > Interval::point(radius).sqr().hi()
        })
    }

    fn point_in(&self, patch: &Patch) -> Option<Point> {
        let middle = patch.middle();
        let Some((centre, radius)) = self.ball else { return Some(middle) };
        let inside = |x: &SVector<f64, D>| {
            distance_squared(x, &centre).hi() <= Interval::point(radius).sqr().lo()
        };
        let x = SVector::from_column_slice(&middle.at);
        if inside(&x) {
            return Some(middle);
        }
        // The point on the ray through the midpoint that lies on or just inside the sphere, then
        // clamped to the box.
        let away = x - centre;
        let pulled = centre + away * (radius / away.norm() * (1.0 - 4.0 * f64::EPSILON));
        let found = [pulled, centre].map(|x| nearest(patch, &x)).into_iter().find(|x| inside(x))?;
        Some(Point { at: found.iter().copied().collect(), chart: patch.chart })
    }
}

/// Returns the point of the box nearest to `x`, both in `ℓ`.
fn nearest<const D: usize>(patch: &Patch, x: &SVector<f64, D>) -> SVector<f64, D> {
    SVector::from_fn(|i, _| x[i].clamp(patch.sides[i].lo(), patch.sides[i].hi()))
}

/// Returns the lifted formula, if it has few variables.
fn lift<const D: usize>(metric: &AnyMetric<'_, D>, along: &[Along; D]) -> Option<Lift<D>> {
    Lift::new(metric.formula().ok()?, along.map(|along| along == Along::Constant))
}

/// Returns how the metric depends on each coordinate, up to motions that leave the constants
/// unchanged.
fn along<const D: usize>(metric: &AnyMetric<'_, D>) -> [Along; D] {
    let Ok(formula) = metric.formula() else { return [Along::Unknown; D] };
    let mut along = dependence(formula);
    if is_radial(formula) {
        // A ray suffices: the constants do not depend on the direction.
        along.iter_mut().skip(1).for_each(|along| *along = Along::Constant);
    }
    for (along, superfluous) in along.iter_mut().zip(superfluous(formula)) {
        if superfluous {
            *along = Along::Constant;
        }
    }
    along
}

/// Returns the largest of `R |∂ₖHᵢⱼ|` and `R² |∂ₖ∂ₗHᵢⱼ|` on a box, for a coordinate `k` and all `l`,
/// divided by the least diagonal entry, where `R` is the reach.
fn relative_change<const D: usize>(
    metric: &impl Metric<D>,
    sides: &[Interval; D],
    k: usize,
) -> f64 {
    let reach = Interval::point(Domain::<D>::REACH);
    let gram = metric.gram(&SVector::from(Jet2::variables(sides)));
    let least = (0..D).map(|i| gram[(i, i)].value()).reduce(Interval::hull);
    let mut most = Interval::zero();
    for entry in gram.iter() {
        most = most.hull(entry.first(k) * reach);
        for l in 0..D {
            most = most.hull(entry.second(k, l) * reach.sqr());
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
