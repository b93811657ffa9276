//! `Traits`: what a method needs and can do; and its usual setting.

use super::method::{
    Method::{self, *},
    Setting,
};

/// What a method needs beyond values of the metric, and what it can do beyond one curve between two
/// points.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Traits {
    /// The derivatives of `H` along its way: their order, or `Γ` for Christoffel symbols with their
    /// derivatives.
    pub(crate) derivatives: &'static str,
    /// Whether it needs a lattice over a box.
    pub(crate) lattice: bool,
    /// Whether its ends may move along closed sets.
    pub(crate) sets: bool,
    /// Whether a certificate of the distance can follow.
    pub(crate) certificate: bool,
}

impl Method {
    /// Returns what the method needs and can do.
    pub(crate) fn traits(self) -> Traits {
        let of = |derivatives, lattice, sets, certificate| Traits {
            derivatives,
            lattice,
            sets,
            certificate,
        };
        match self {
            Trapezoidal | Extrapolated | LeftEndpoint | FromTheLine => of("2", false, true, true),
            Classes => of("2", true, true, true),
            LbfgsPoints | LbfgsSobolev | SobolevGradient | GaussNewton => {
                of("1", false, false, false)
            }
            DynamicProgramming | EqualSpeeds | DiscreteLogarithm => of("2", false, false, false),
            Shooting | Collocation => of("Γ", false, true, false),
            LatticePath | FirstOrderMarch | SecondOrderMarch => of("0", true, true, false),
        }
    }

    /// Returns the setting of the tables in this dimension: a usual one.
    pub(crate) fn usual(self, dimension: usize) -> Setting {
        let flat = dimension <= 2;
        match self {
            Shooting => Setting::Tolerance(1e-9),
            Collocation => Setting::Tolerance(1e-4),
            LatticePath if flat => Setting::Edges { cells: 128, reach: 3 },
            LatticePath => Setting::Edges { cells: 24, reach: 2 },
            FirstOrderMarch | SecondOrderMarch => Setting::Cells(if flat { 128 } else { 32 }),
            _ => Setting::Chords(128),
        }
    }
}
