//! `Method`: the ways to a minimal geodesic that are compared, and what each of them needs.

/// A way to a minimal geodesic.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Method {
    /// The solver, by the trapezoidal rule.
    Trapezoidal,
    /// The same, and its extrapolation to `N = ∞`.
    Extrapolated,
    /// The solver, by the left-endpoint rule.
    LeftEndpoint,
    /// The solver with the straight line as its only start, like the methods that follow.
    FromTheLine,
    /// The solver with a start for each of several homotopy classes around the peaks of the metric.
    Classes,
    /// L-BFGS in the coordinates of the points.
    LbfgsPoints,
    /// L-BFGS in Sobolev coordinates.
    LbfgsSobolev,
    /// Gradients in a Sobolev norm.
    SobolevGradient,
    /// Differential dynamic programming along the chain of points, with second derivatives of `H`.
    DynamicProgramming,
    /// The same without them.
    GaussNewton,
    /// Sequences of equal speeds, by the left-endpoint rule, as of Liu et al.
    EqualSpeeds,
    /// The norm of the discrete logarithm of Rumpf and Wirth.
    DiscreteLogarithm,
    /// Shooting.
    Shooting,
    /// Collocation.
    Collocation,
    /// A shortest path along the edges of a lattice.
    LatticePath,
    /// Fast marching of the first order.
    FirstOrderMarch,
    /// Fast marching of the second order.
    SecondOrderMarch,
}

/// How much work a method is allowed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Setting {
    /// The number of chords `N`.
    Chords(usize),
    /// The tolerance of an integration or of a residual.
    Tolerance(f64),
    /// A lattice of this many cells along each axis of the box.
    Cells(usize),
    /// The same, with edges of this reach.
    Edges {
        /// The number of cells along each axis.
        cells: usize,
        /// How many cells an edge reaches along each axis.
        reach: usize,
    },
}

use Method::*;

impl Method {
    /// All methods, in the order of the table of accuracy and time, and of the figure, which leaves out the
    /// discrete logarithm.
    pub(crate) const ALL: [Method; 17] = [
        Trapezoidal,
        Extrapolated,
        LeftEndpoint,
        FromTheLine,
        Classes,
        LbfgsPoints,
        LbfgsSobolev,
        SobolevGradient,
        DynamicProgramming,
        GaussNewton,
        EqualSpeeds,
        DiscreteLogarithm,
        Shooting,
        Collocation,
        LatticePath,
        FirstOrderMarch,
        SecondOrderMarch,
    ];

    /// Returns the name in figures, tables and data.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Trapezoidal => "Tautline, trapezoidal",
            Extrapolated => "Tautline, extrapolated",
            LeftEndpoint => "Tautline, left endpoint",
            FromTheLine => "Tautline, one start",
            Classes => "Tautline, classes",
            LbfgsPoints => "L-BFGS, points",
            LbfgsSobolev => "L-BFGS, Sobolev",
            SobolevGradient => "Sobolev gradient",
            DynamicProgramming => "DDP",
            GaussNewton => "DDP, Gauss–Newton",
            EqualSpeeds => "equal speeds",
            DiscreteLogarithm => "discrete logarithm",
            Shooting => "shooting",
            Collocation => "collocation",
            LatticePath => "lattice path",
            FirstOrderMarch => "fast marching, order 1",
            SecondOrderMarch => "fast marching, order 2",
        }
    }

    /// Returns the settings of the figure in this dimension, from cheap to accurate.
    pub(crate) fn settings(self, dimension: usize) -> Vec<Setting> {
        let chords = |ns: &[usize]| ns.iter().map(|&n| Setting::Chords(n)).collect();
        let tolerances =
            |powers: &[i32]| powers.iter().map(|&k| Setting::Tolerance(10_f64.powi(k))).collect();
        let flat = dimension <= 2;
        match self {
            Trapezoidal | LeftEndpoint | FromTheLine | Classes | DiscreteLogarithm => {
                chords(&[16, 64, 256, 1024, 4096])
            }
            // Below there is one grid only.
            Extrapolated => chords(&[64, 256, 1024, 4096]),
            LbfgsPoints | LbfgsSobolev | SobolevGradient | DynamicProgramming | GaussNewton
            | EqualSpeeds => chords(&[16, 32, 64, 128]),
            Shooting => tolerances(&[-3, -6, -9, -12]),
            Collocation => tolerances(&[-1, -2, -4, -6]),
            LatticePath => {
                let lattices: &[(usize, usize)] = if flat {
                    &[(32, 1), (64, 2), (128, 3), (256, 5)]
                } else {
                    &[(16, 1), (24, 2), (32, 3)]
                };
                lattices.iter().map(|&(cells, reach)| Setting::Edges { cells, reach }).collect()
            }
            FirstOrderMarch | SecondOrderMarch => {
                let cells: &[usize] = if flat { &[32, 64, 128, 256] } else { &[12, 24, 48] };
                cells.iter().map(|&cells| Setting::Cells(cells)).collect()
            }
        }
    }
}

impl std::fmt::Display for Setting {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Setting::Chords(n) => write!(f, "{n} chords"),
            Setting::Tolerance(tolerance) => write!(f, "tolerance {tolerance:e}"),
            Setting::Cells(cells) => write!(f, "{cells} cells"),
            Setting::Edges { cells, reach } => write!(f, "{cells} cells, reach {reach}"),
        }
    }
}
