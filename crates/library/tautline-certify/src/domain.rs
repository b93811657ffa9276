//! `Domain`: where a constant holds.

#[cfg(test)]
mod tests;

use nalgebra::DVector;
use num_traits::{One, Zero};
use tautline_formula::Formula;
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Interval, Scalar};

use crate::{
    Cell, CertifyError,
    constants::{Expansion, Order, is_bounded},
    formula::{Along, Lift, dependence, is_radial, superfluous},
    patch::{Patch, Point, Region},
};

/// A convex compact set on which constants are proved, and the scope in which they then hold.
///
/// On a convex set the largest `‖DH‖` is the Lipschitz constant of `H`. The dimension is a value.
#[derive(Clone, Debug, PartialEq)]
pub struct Domain {
    cell: Cell,
    ball: Option<(DVector<f64>, f64)>,
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

impl Domain {
    /// How far [`Domain::space`] reaches where a metric is neither constant nor periodic: `2¹⁰⁰ ℓ`.
    ///
    /// At this reach tenth powers of coordinates do not overflow. They remain negligible when
    /// multiplied by the least double, which replaces what underflows.
    pub const REACH: f64 = f64::from_bits((1023 + 100) << 52);

    /// Returns the domain that consists of a box.
    #[must_use]
    pub fn cell(cell: Cell) -> Self {
        Self { cell, ball: None, scope: Scope::Region }
    }

    /// Returns the ball `|x − centre| ≤ radius`, both in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`CertifyError::NotARadius`] if the radius is negative or not finite, and
    /// [`CertifyError::NotASide`] if the centre is not finite.
    pub fn ball(centre: impl AsRef<[f64]>, radius: f64) -> Result<Self, CertifyError> {
        let centre = DVector::from_column_slice(centre.as_ref());
        if !(radius >= 0.0 && radius.is_finite()) {
            return Err(CertifyError::NotARadius { radius });
        }
        // The box reaches one double farther, since the sums are rounded. For radius 0 it does not:
        // nothing is rounded, and a derivative may vanish at the centre only.
        let cell = if radius == 0.0 {
            Cell::new(centre.as_slice(), centre.as_slice())?
        } else {
            let below = centre.map(|c| (c - radius).next_down());
            let above = centre.map(|c| (c + radius).next_up());
            Cell::new(below.as_slice(), above.as_slice())?
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
    /// let valleys = Domain::space::<2>(&Valleys);
    /// let [x1, x2] = valleys.bounding_cell().sides() else { unreachable!() };
    /// assert!(valleys.is_all_of_space());
    /// assert!(x1.lo() == 0.0 && 6.28 < x1.hi() && x1.hi() < 6.29 && x2.width() == 0.0);
    ///
    /// let walls = Formula::<2>::parse("4 + tanh(x1) + sin(x1 + 0.3*x2) I", &[])?;
    /// assert!(Domain::space(&walls).is_all_of_space());
    /// assert!(!Domain::space::<2>(&Sphere).is_all_of_space());
    /// # Ok::<(), tautline_formula::TextError>(())
    /// ```
    #[must_use]
    pub fn space<const D: usize>(metric: &impl Metric<D>) -> Self {
        match Formula::record(metric) {
            Ok(formula) => Self::space_by_formula(&formula.into_any()),
            Err(_) => Self::within_reach(D),
        }
    }

    /// Returns the [space](Domain::space) of a formula, in a dimension that is a value.
    #[must_use]
    pub fn space_by_formula(formula: &Formula<ANY>) -> Self {
        let along = along(formula);
        let Some(cell) = representative(&along) else {
            return Self::within_reach(formula.dimension());
        };
        let scope = if along.iter().all(|along| *along != Along::Unknown) {
            Scope::Space
        } else {
            match lift(formula, &along).filter(is_bounded) {
                Some(lift) => Scope::Lifted { sharp: lift.is_sharp() },
                None => Scope::Region,
            }
        };
        Self { cell, ball: None, scope }
    }

    /// Returns the box of which a metric shows nothing beyond.
    fn within_reach(d: usize) -> Self {
        let far = vec![Self::REACH; d];
        let near: Vec<_> = far.iter().map(|far| -far).collect();
        Self { cell: Cell::new(near, far).expect("finite"), ball: None, scope: Scope::Region }
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
    pub fn settled_space<const D: usize>(metric: &impl Metric<D>) -> Result<Self, CertifyError> {
        let formula = Formula::record(metric).map_err(CertifyError::NotRecorded)?;
        Self::settled_space_by_formula(&formula.into_any())
    }

    /// Returns the [settled space](Domain::settled_space) of a formula, in a dimension that is a value.
    ///
    /// # Errors
    ///
    /// Those of [`settled_space`](Domain::settled_space).
    pub fn settled_space_by_formula(formula: &Formula<ANY>) -> Result<Self, CertifyError> {
        formula.symmetric().map_err(CertifyError::NotRecorded)?;
        let space = Self::space_by_formula(formula);
        if space.is_all_of_space() {
            return Ok(space);
        }
        let sides = space.cell.sides();
        for coordinate in (0..sides.len()).filter(|&k| sides[k].hi() == Self::REACH) {
            for sign in [1.0, -1.0] {
                let mut shell = sides.to_vec();
                shell[coordinate] =
                    (Interval::point(0.5).hull(Interval::one())) * (sign * Self::REACH);
                let change = relative_change(formula, &shell, coordinate);
                if !(change <= 1e-9) {
                    return Err(CertifyError::NotSettled { coordinate, change });
                }
            }
        }
        Ok(Self { scope: Scope::SettledSpace, ..space })
    }

    /// Returns the dimension.
    #[must_use]
    pub fn dimension(&self) -> usize {
        self.cell.dimension()
    }

    /// Returns the bounding box, which is the domain itself unless the domain is a ball or, for some
    /// metrics, [all of space](Domain::space).
    #[must_use]
    pub fn bounding_cell(&self) -> &Cell {
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

    /// Returns whether constants of a formula on the domain hold on all of `R^D`. The domain may have
    /// been made for another one.
    pub(crate) fn represents_space_for(&self, formula: &Formula<ANY>) -> bool {
        match self.scope {
            Scope::Region => false,
            Scope::Space | Scope::Lifted { .. } => *self == Self::space_by_formula(formula),
            Scope::SettledSpace => {
                Self::settled_space_by_formula(formula).is_ok_and(|space| *self == space)
            }
        }
    }

    /// Returns the lifted formula in whose variables the domain is all of space for a formula.
    pub(crate) fn lift(&self, formula: &Formula<ANY>) -> Option<Lift> {
        let is_lifted =
            matches!(self.scope, Scope::Lifted { .. }) && self.represents_space_for(formula);
        is_lifted.then(|| lift(formula, &along(formula))).flatten()
    }
}

impl Region for Domain {
    fn patches(&self) -> Vec<Patch> {
        vec![Patch { sides: self.cell.sides().to_vec(), chart: 0 }]
    }

    fn misses(&self, patch: &Patch) -> bool {
        self.ball.as_ref().is_some_and(|(centre, radius)| {
            let nearest = distance_squared(&nearest(patch, centre), centre);
            nearest.lo() > Interval::point(*radius).sqr().hi()
        })
    }

    fn point_in(&self, patch: &Patch) -> Option<Point> {
        let middle = patch.middle();
        let Some((centre, radius)) = &self.ball else { return Some(middle) };
        let inside = |x: &DVector<f64>| {
            distance_squared(x, centre).hi() <= Interval::point(*radius).sqr().lo()
        };
        let x = DVector::from_column_slice(&middle.at);
        if inside(&x) {
            return Some(middle);
        }
        // The point on the ray through the midpoint that lies on or just inside the sphere, then
        // clamped to the box.
        let away = x - centre;
        let share = radius / away.norm() * (1.0 - 4.0 * f64::EPSILON);
        let pulled = centre + away * share;
        let candidates = [&pulled, centre].map(|x| nearest(patch, x));
        let found = candidates.into_iter().find(|x| inside(x))?;
        Some(Point { at: found.as_slice().to_vec(), chart: patch.chart })
    }
}

/// Returns the point of the box nearest to `x`, both in `ℓ`.
fn nearest(patch: &Patch, x: &DVector<f64>) -> DVector<f64> {
    DVector::from_fn(x.len(), |i, _| x[i].clamp(patch.sides[i].lo(), patch.sides[i].hi()))
}

/// Returns a box of which all of space is the copies, as far as the dependence on each coordinate is known;
/// `None` if a period overflows.
fn representative(along: &[Along]) -> Option<Cell> {
    let side = |along: &Along| match *along {
        Along::Constant => Interval::zero(),
        // 2π is enclosed as 8 arctan 1.
        Along::Periodic(wave_number) => {
            let period = Interval::constant(1.0).atan() * 8.0 / wave_number;
            Interval::zero().hull(period)
        }
        Along::Unknown => Interval::point(-Domain::REACH).hull(Interval::point(Domain::REACH)),
    };
    let sides: Vec<_> = along.iter().map(side).collect();
    let corner =
        |end: fn(Interval) -> f64| -> Vec<f64> { sides.iter().map(|&side| end(side)).collect() };
    Cell::new(corner(Interval::lo), corner(Interval::hi)).ok()
}

/// Returns the lifted formula, if it has few variables.
fn lift(formula: &Formula<ANY>, along: &[Along]) -> Option<Lift> {
    Lift::new(formula, along.iter().map(|along| *along == Along::Constant).collect())
}

/// Returns how the metric depends on each coordinate, up to motions that leave the constants
/// unchanged.
fn along(formula: &Formula<ANY>) -> Vec<Along> {
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
fn relative_change(formula: &Formula<ANY>, sides: &[Interval], k: usize) -> f64 {
    let (reach, d) = (Interval::point(Domain::REACH), sides.len());
    let gram = Expansion::of(formula, sides, Order::Second);
    let least = (0..d).map(|i| gram.value(i, i)).reduce(Interval::hull);
    let mut most = Interval::zero();
    for (i, j) in (0..d).flat_map(|j| (0..=j).map(move |i| (i, j))) {
        most = most.hull(gram.first(k, i, j) * reach);
        for l in 0..d {
            most = most.hull(gram.second(k, l, i, j) * reach.sqr());
        }
    }
    match least {
        Some(least) if least.lo() > 0.0 => (Interval::point(most.magnitude()) / least.lo()).hi(),
        _ => f64::NAN,
    }
}

fn distance_squared(x: &DVector<f64>, y: &DVector<f64>) -> Interval {
    x.iter().zip(y).fold(Interval::zero(), |sum, (&x, &y)| {
        sum + (Interval::point(x) - Interval::point(y)).sqr()
    })
}
