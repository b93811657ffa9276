//! `Case`: a metric, two sets and the distance between them.

use std::f64::consts::PI;

use tautline::{
    AxisBox, Ball, Bounded, Constants, Curvature, Ends, HalfSpace, KnownDistance, LeftEndpoint,
    Metric, Problem, Rule, SVector, Stop, Trapezoidal,
    bounds::Setting,
    gallery::{Bump, Ramp, Separable, Shear, Valleys},
};

use crate::{Failure, observation::Observation};

/// The two rules of the paper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PaperRule {
    /// The trapezoidal rule.
    Trapezoidal,
    /// The left-endpoint rule.
    LeftEndpoint,
}

impl PaperRule {
    /// Both, in the paper's order.
    pub const BOTH: [PaperRule; 2] = [PaperRule::Trapezoidal, PaperRule::LeftEndpoint];

    /// Returns the name in the data files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            PaperRule::Trapezoidal => "trapezoidal",
            PaperRule::LeftEndpoint => "left_endpoint",
        }
    }
}

/// Where `d²` comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Reference {
    /// A closed form, or a quadrature to rounding, with a proof of minimality.
    Exact,
    /// Richardson extrapolation from grids up to 65 536 chords: an estimate.
    Extrapolated,
}

impl Reference {
    /// Returns the name in the data files.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Reference::Exact => "exact",
            Reference::Extrapolated => "extrapolated",
        }
    }
}

/// A problem whose distance is known.
pub struct Case {
    /// The name in the data files.
    pub name: &'static str,
    /// The name in the figures and tables, in the syntax of labels.
    pub title: &'static str,
    /// The square of the distance, in `m²`.
    pub distance_squared: f64,
    /// Where it comes from.
    pub reference: Reference,
    /// What the bounds depend on.
    pub setting: Setting,
    /// The orders in `1/N` of `E_N − d²` for both rules; see [`Orders`].
    pub orders: Orders,
    solve: Solve,
}

/// The orders in `1/N` of `E_tra,N − d²` and of `E_l,N − d²`, where they can be observed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Orders {
    /// 2 and 1: the general case.
    General,
    /// 2 for the trapezoidal rule; the first order of the left rule, `∫ DH[γ̇](γ̇, γ̇) dt`, is
    /// zero by symmetry, or so small that the second order hides it on these grids.
    LeftHidden,
    /// Neither: the discrete energies attain `d²` exactly.
    Exact,
}

impl Orders {
    /// Returns the order for a rule; `None` if there is none to observe.
    #[must_use]
    pub fn of(self, rule: PaperRule) -> Option<f64> {
        match (self, rule) {
            (Orders::Exact, _) | (Orders::LeftHidden, PaperRule::LeftEndpoint) => None,
            (_, PaperRule::Trapezoidal) => Some(2.0),
            (Orders::General, PaperRule::LeftEndpoint) => Some(1.0),
        }
    }
}

type Solve = Box<dyn Fn(PaperRule, usize) -> Result<Observation, Failure>>;

impl Case {
    /// Minimises the discrete energy of `rule` with `n` subintervals.
    ///
    /// # Errors
    ///
    /// If the solver refuses the problem or does not converge to a local minimum.
    pub fn solve(&self, rule: PaperRule, n: usize) -> Result<Observation, Failure> {
        let observation = (self.solve)(rule, n)?;
        // Degenerate is allowed: where the minimiser leaves the boundary of a ball, the valleys
        // may be followed sideways at no cost, and there is a continuum of minimisers.
        if observation.stop != Stop::Converged
            || matches!(observation.curvature, Curvature::Indefinite { .. })
        {
            return Err(Failure::NotConverged {
                case: self.name,
                rule: rule.name(),
                n,
                stop: observation.stop,
                curvature: observation.curvature,
            });
        }
        Ok(observation)
    }

    fn new<M, const D: usize>(
        (name, title): (&'static str, &'static str),
        metric: M,
        ends: Ends<D>,
        distance: Option<f64>,
        orders: Orders,
    ) -> Result<Case, Failure>
    where
        M: Bounded<D> + 'static,
    {
        let constants: Constants = metric.constants();
        let problem = Problem::new(metric, ends);
        let (distance_squared, reference) = match distance {
            Some(d) => (d * d, Reference::Exact),
            None => {
                let line = problem.solve(Trapezoidal, 65_536)?;
                let d2 = line.distance_squared_estimate().ok_or(Failure::NoReference(name))?;
                (d2.value, Reference::Extrapolated)
            }
        };
        let setting = Setting::new(constants, distance_squared.sqrt(), D)?;
        let solve = Box::new(move |rule, n| match rule {
            PaperRule::Trapezoidal => observe(&problem, Trapezoidal, n),
            PaperRule::LeftEndpoint => observe(&problem, LeftEndpoint, n),
        });
        Ok(Case { name, title, distance_squared, reference, setting, orders, solve })
    }

    /// A case between two points whose distance the metric knows.
    fn between<M, const D: usize>(
        names: (&'static str, &'static str),
        metric: M,
        [a, b]: [[f64; D]; 2],
        orders: Orders,
    ) -> Result<Case, Failure>
    where
        M: Bounded<D> + KnownDistance<D> + 'static,
    {
        let distance = metric.distance(&SVector::from(a), &SVector::from(b));
        let distance = Some(distance.ok_or(Failure::NoReference(names.0))?);
        Case::new(names, metric, Ends::points(a, b)?, distance, orders)
    }
}

fn observe<M: Metric<D>, const D: usize>(
    problem: &Problem<M, D>,
    rule: impl Rule,
    n: usize,
) -> Result<Observation, Failure> {
    let line = problem.solve(rule, n)?;
    let minimum = line.minimum();
    Ok(Observation {
        n,
        discrete_energy: line.discrete_energy(),
        energy: line.energy(),
        length: line.length(),
        decrement: minimum.decrement,
        residual: minimum.residual,
        residual_floor: minimum.residual_floor,
        stop: minimum.stop,
        curvature: minimum.curvature,
    })
}

/// Returns all cases.
///
/// # Errors
///
/// None in a correct build: every constructor is called with constants.
pub fn cases() -> Result<Vec<Case>, Failure> {
    let shear = Shear::new(0.5, 1.0)?;
    let ball = Ball::new([0.0, 0.0], 0.5)?;
    let separable = || Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]);
    // Flattening each coordinate maps a box and a half-space x₁ ≥ 4 to a box and a half-space.
    let corner = separable()?.flatten(&SVector::from([0.5, 0.0, 0.0]))[0];
    let wall = separable()?.flatten(&SVector::from([4.0, 0.0, 0.0]))[0];
    Ok(vec![
        Case::between(
            ("valleys_points", "valleys, $(0,0)$ to $(4π,0)$"),
            Valleys,
            [[0.0, 0.0], [4.0 * PI, 0.0]],
            // H is even about the middle of the curve.
            Orders::LeftHidden,
        )?,
        Case::between(
            ("valleys_oblique", "valleys, $(0,0)$ to $(2,3/2)$"),
            Valleys,
            [[0.0, 0.0], [2.0, 1.5]],
            Orders::General,
        )?,
        Case::new(
            ("valleys_ball", "valleys, ball to half-plane"),
            Valleys,
            Ends::new(ball, HalfSpace::at_least([1.0, 0.0], 3.0)?)?,
            // |∇u| = f for u = 2x₁ − sin x₁, and the ball reaches to x₁ = ½.
            Some(5.0 - 3_f64.sin() + 0.5_f64.sin()),
            Orders::General,
        )?,
        Case::between(
            ("shear_points", "shear, $(0,0)$ to $(2,3)$"),
            shear,
            [[0.0, 0.0], [2.0, 3.0]],
            Orders::General,
        )?,
        Case::new(
            ("shear_ball", "shear, ball to half-plane"),
            shear,
            Ends::new(ball, HalfSpace::at_least([0.0, 1.0], 3.0)?)?,
            // Flattening keeps x₂, and the ball reaches to x₂ = ½.
            Some(2.5),
            // Both rules can follow β₁ = −½ cos(x₂) β₂ exactly, x₁ being free at the end.
            Orders::Exact,
        )?,
        Case::between(
            ("separable_points", "separable, $D = 3$"),
            separable()?,
            [[0.0, 0.0, 0.0], [2.0, 1.0, -1.5]],
            Orders::General,
        )?,
        Case::new(
            ("separable_box", "separable, box to half-space"),
            separable()?,
            Ends::new(
                AxisBox::new([0.0, 0.0, 0.0], [0.5, 0.5, 0.5])?,
                HalfSpace::at_least([1.0, 0.0, 0.0], 4.0)?,
            )?,
            Some(wall - corner),
            Orders::General,
        )?,
        Case::between(
            ("ramp", "ramp, $D = 1$"),
            Ramp::new(0.5, 1.0)?,
            [[-1.0], [2.0]],
            Orders::General,
        )?,
        Case::new(
            ("bump_points", "bump, passed on one side"),
            Bump::new(4.0, 0.5)?,
            Ends::points([-1.5, 0.05], [1.5, -0.1])?,
            None,
            // Both ends are at nearly the same distance from the bump.
            Orders::LeftHidden,
        )?,
        Case::new(
            ("bump_ball", "bump, ball to half-plane"),
            Bump::new(4.0, 0.5)?,
            Ends::new(Ball::new([-2.0, 0.0], 0.5)?, HalfSpace::at_least([1.0, 0.0], 2.0)?)?,
            None,
            Orders::General,
        )?,
    ])
}
