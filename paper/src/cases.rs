//! The cases of the figures and tables.

use std::f64::consts::PI;

use tautline::{
    AxisBox, Ball, Ends, HalfSpace, SVector,
    gallery::{Bump, Ramp, Separable, Shear, Valleys},
};

use crate::{
    Failure,
    case::{Case, Orders},
};

/// Returns the cases with these names, in this order.
pub(crate) fn cases_named(names: &[&str]) -> Result<Vec<Case>, Failure> {
    let mut all = cases()?;
    let take = |name: &&str| {
        let place = all.iter().position(|case| case.name == *name);
        let place = place.ok_or_else(|| Failure::Data(format!("no case is called {name}")))?;
        Ok(all.swap_remove(place))
    };
    names.iter().map(take).collect()
}

/// Returns the case of a ridge that is crossed between two points of nearly the same cost. The
/// leading term of the left rule is proportional to the logarithm of the ratio of these costs, and
/// so small that the term of second order hides it up to some hundred chords.
pub(crate) fn over_a_ridge() -> Result<Case, Failure> {
    Case::between("valleys_ridge", Valleys, [[1.0, 0.0], [5.29, 1.0]], Orders::LeftHidden)
}

/// Returns all cases.
pub(crate) fn cases() -> Result<Vec<Case>, Failure> {
    let shear = Shear::new(0.5, 1.0)?;
    let ball = Ball::new([0.0, 0.0], 0.5)?;
    let separable = || Separable::new([0.3, 0.5, -0.4], [1.0, 2.0, 1.5]);
    // Flattening each coordinate maps a box and a half-space x₁ ≥ 4 to a box and a half-space.
    let corner = separable()?.flatten(&SVector::from([0.5, 0.0, 0.0]))[0];
    let wall = separable()?.flatten(&SVector::from([4.0, 0.0, 0.0]))[0];
    Ok(vec![
        Case::between(
            "valleys_points",
            Valleys,
            [[0.0, 0.0], [4.0 * PI, 0.0]],
            // H is even about the middle of the curve.
            Orders::LeftHidden,
        )?,
        Case::between("valleys_oblique", Valleys, [[0.0, 0.0], [2.0, 1.5]], Orders::General)?,
        Case::new(
            "valleys_ball",
            Valleys,
            Ends::new(ball.clone(), HalfSpace::at_least([1.0, 0.0], 3.0)?)?,
            // ∇u| = f for u = 2x₁ − sin x₁, and the ball extends to x₁ = ½.
            Some(5.0 - 3_f64.sin() + 0.5_f64.sin()),
            Orders::General,
        )?,
        Case::between("shear_points", shear, [[0.0, 0.0], [2.0, 3.0]], Orders::General)?,
        Case::new(
            "shear_ball",
            shear,
            Ends::new(ball, HalfSpace::at_least([0.0, 1.0], 3.0)?)?,
            // Flattening keeps x₂, and the ball extends to x₂ = ½.
            Some(2.5),
            // Both rules can follow β₁ = −½ cos(x₂) β₂ exactly, since x₁ is free at the end.
            Orders::Exact,
        )?,
        Case::between(
            "separable_points",
            separable()?,
            [[0.0, 0.0, 0.0], [2.0, 1.0, -1.5]],
            Orders::General,
        )?,
        Case::new(
            "separable_box",
            separable()?,
            Ends::new(
                AxisBox::new([0.0, 0.0, 0.0], [0.5, 0.5, 0.5])?,
                HalfSpace::at_least([1.0, 0.0, 0.0], 4.0)?,
            )?,
            Some(wall - corner),
            Orders::General,
        )?,
        Case::between("ramp", Ramp::new(0.5, 1.0)?, [[-1.0], [2.0]], Orders::General)?,
        Case::new(
            "bump_points",
            Bump::new(4.0, 0.5)?,
            Ends::points([-1.5, 0.05], [1.5, -0.1])?,
            None,
            // Both ends are at nearly the same distance from the bump.
            Orders::LeftHidden,
        )?,
        Case::new(
            "bump_ball",
            Bump::new(4.0, 0.5)?,
            Ends::new(Ball::new([-2.0, 0.0], 0.5)?, HalfSpace::at_least([1.0, 0.0], 2.0)?)?,
            None,
            Orders::General,
        )?,
    ])
}
