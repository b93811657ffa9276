//! `Mutant`: the library with one deliberate mistake.

use crate::replaceable::Program;

/// Makes the enum of all mutants from their table. A row has the name, the programs that are wrong,
/// and the mistake. If it has no programs, entries of [`Bounds`](crate::Bounds) are replaced.
macro_rules! mutants {
    ($($(#[$detail:meta])* $name:ident $(in [$($program:ident),*])?: $mistake:literal,)*) => {
        /// A deliberately wrong variant of the library, which a good test suite detects.
        #[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
        pub enum Mutant {
            $(#[doc = concat!("Mistake: ", $mistake, ".")] $(#[$detail])* $name,)*
        }

        impl Mutant {
            /// All mutants, in the order of their mistakes: discretizations, sets, solver, recorded
            /// formulas, constants, bounds of the paper, sharper bounds.
            pub const ALL: [Self; [$($mistake),*].len()] = [$(Self::$name),*];

            /// Returns the mistake in a few words.
            #[must_use]
            pub fn mistake(self) -> &'static str {
                match self {
                    $(Self::$name => $mistake,)*
                }
            }

            /// Returns the programs that are wrong; all others are the library's.
            pub(crate) const fn programs(self) -> &'static [Program] {
                match self {
                    $(Self::$name => &[$($(Program::$program),*)?],)*
                }
            }
        }
    };
}

mutants! {
    // Discretizations and sets
    /// It affects energies, gradients and the solver.
    RulesExchanged in [DiscreteEnergy, DiscreteLength, EnergyGradient, Minimise]:
        "the two rules exchanged",
    /// It affects the trapezoidal rule.
    TrueTrapezoid in [DiscreteEnergy, DiscreteLength, Minimise]:
        "H averaged over the ends of a chord",
    EnergyHalved in [DiscreteEnergy]: "a factor 1/2 in the discrete energy",
    LastChordLost in [DiscreteEnergy]: "the last chord left out",
    RootLost in [DiscreteLength]: "no square root in the discrete length",
    QuadratureOfOneNode in [CurveEnergy]: "one node a chord in E(γᵖˡ)",
    QuadratureByEnds in [CurveEnergy]: "the ends of a chord in E(γᵖˡ)",
    LengthFromEnergy in [CurveLength]: "L(γᵖˡ) = √E(γᵖˡ)",
    /// The sum over the chords is not divided by `N`.
    MeanForgotten in [K3]: "K₃ without the mean",
    GradientReversed in [EnergyGradient]: "the gradient reversed",
    MetricFrozen in [EnergyGradient]: "the gradient without DH",
    /// It affects the last term.
    ChristoffelSign in [Christoffel]: "a wrong sign in Γ",
    ChristoffelDoubled in [Christoffel]: "no factor 1/2 in Γ",
    NotProjected in [Project]: "points not projected",
    // The solver
    /// The solver moves the first point.
    EndRelaxed in [Minimise]: "an end point 10⁻⁶ off its set",
    /// The solver then reports that it converged.
    StopsEarly in [Minimise]: "one Newton step",
    /// The solver reports that it converged.
    NotOptimised in [Minimise]: "the straight line for a minimiser",
    /// The solver returns the interpolation of this minimiser.
    NotRefined in [Minimise]: "the minimiser of half as many chords",
    /// The solver returns the local minimum nearest to the straight line.
    LocalForGlobal in [Minimise]: "a local minimum for the global one",
    // Recorded formulas, in the search
    /// `a ∘ b` is read as `b ∘ a`.
    OperandsSwapped in [Minimise]: "operands of a recorded step swapped",
    /// Constants are rounded to quarters, so that nearby constants coincide.
    ConstantsMerged in [Minimise]: "constants of a recorded formula merged",
    ConstantsShortened in [Minimise]: "recorded constants in single precision",
    SineForCosine in [Minimise]: "the sine for a recorded cosine",
    /// `x²` is read as `x`, and so on.
    PowerOfStepLost in [Minimise]: "a power of a recorded step lost",
    StepBesideRead in [Minimise]: "the step beside a recorded one read",
    EntryTakenForZero in [Minimise]: "entries of H taken for zeros of its structure",
    TableAxesExchanged in [Minimise]: "the first two arguments of a recorded table exchanged",
    TableReadBeside in [Minimise]: "a recorded table read one cell beside",
    ProductRuleHalved in [Minimise]: "half of the product rule in dᵀ ∂ₖH d",
    /// The last lane gets the rows of the lane before it.
    LaneLost in [Minimise]: "the last lane of a batch lost",
    /// The first lane of a batch keeps the rows of the previous batch.
    RegisterStale in [Minimise]: "registers of the batch before",
    // Constants and bounds of the paper
    LipschitzTooSmall in [Constants]: "L_H 10 % too small",
    /// This is not wrong, but it loosens every bound.
    LipschitzDoubled in [Constants]: "L_H twice too large",
    ConstantsExchanged: "c₁ and c₂ exchanged in K_{1,g}",
    /// The root of `c₁` is missing.
    RootOfC1Forgotten: "K_{1,g} = d/c₁",
    DimensionForgotten: "K_{2,g} without D²",
    DimensionOnce: "K_{2,g} with D for D²",
    /// This is the cross term.
    CrossTermLost: "C_tra(N) without 4c₂K₁K₂/N",
    /// `1/N²` is replaced by `1/N`.
    SecondOrderForgotten: "C_tra(N) with 4c₂K₂²/N",
    PowerOfK1Lost: "C_tra♯ with K₁² for K₁³",
    DistanceForgotten: "K̄_{3,g} without d",
    K4IsK3: "K̄_{4,g} = K̄_{3,g}",
    QuarterLost: "7.9 without the factor 1/4",
    PowerOfK3Lost: "7.9 with K₃² for K₃³",
    /// The formula holds for equal speeds only.
    RootOfNForgotten: "7.9 with N for √N",
    HalfOfRuleGap: "8.1 with 1/4 for 1/2",
    HalfOfLeftGap: "8.2 with 1/4 for 1/2",
    SharpForgotten: "C of Theorem 1.1 without C_tra♯",
    LastCubeForgotten: "C of Theorem 1.3 without K̄_{4,g}³",
    // Sharper bounds
    /// It affects Lemma S.1.
    OmegaHalved: "ω = 1/2 for every metric",
    LeftCubeHalved: "S.2 with 1/4 for the left rule",
    /// The correct term is `M_H/24N²`.
    CurvatureGapHalved: "S.2 with M_H/48N²",
    ResidualForgotten: "S.3 without the residual",
    /// The change of speed from chord to chord is left out.
    SpeedChangeForgotten: "S.3 with max q = √E",
    /// `½ L_H K₃²` is replaced by `¼ L_H K₃²`.
    MomentumGrowthHalved: "S.3 with half the growth of the momentum",
    /// The correct factor is `3/2`.
    StepHalved: "S.3 with 3/4 from chord to chord",
    LeftCeilingHalved: "S.4 with δ/4N for the left rule",
    /// The correct term is `G²/12`.
    SecondVariationHalved: "S.4 with G²/24",
    LengthGapHalved: "S.5 with half the gap of the length",
    VarianceHalved: "S.5 with half the variance",
    /// The formula holds if the speeds are symmetric about their mean.
    SkewnessForgotten: "S.5 without R v in m₃",
    /// The fourth power of the deviations is left out.
    KurtosisForgotten: "S.5 without R²v in m₄",
    /// The formula holds if all speeds are equal.
    SpeedsOfTheoremAEqual: "Theorem A with Q = √e",
    SampledTermHalved: "Theorem B with Gδ/6 for Gδ/3",
    SquareOfSpeedLost: "Theorem B with Q for Q²",
    /// The correct term is `μ/24N²`.
    StationaryFourthHalved: "Theorem B with μ/48N²",
    /// The deficit is the amount by which `E_N` may be below `d²`.
    DeficitHalved: "Theorem C with half the deficit",
    /// `m₃` is replaced by `e^{3/2}`.
    SpeedsOfTheoremCEqual: "Theorem C with m₃ for equal speeds",
    LengthOfTheoremCHalved: "Theorem C with half the gap of L(γᵖˡ)",
    /// One chord then has a smaller bound than two.
    CapForgotten: "Theorem C without the cap of m₃",
    /// It affects the gap of the length.
    PowerOfTheoremCLost: "Theorem C with e for its power 3/2",
    /// The correct term is `μ/24N²`.
    FourthPowerHalved: "Theorem D with μ/48N²",
    LengthOfTheoremDHalved: "Theorem D with half the gap of L(γᵖˡ)",
    /// The deficit is the amount by which `E_tra,N` may be below `d²`.
    DeficitOfTheoremDHalved: "Theorem D with half the deficit",
    LeastOfTheOtherRule: "the left rule with the trapezoidal least bound",
    CeilingForgotten: "S.6 with min E_N ≤ d²",
    SlopeForgotten: "S.7 without L_H",
    CurvatureOfConvexityForgotten: "S.7 without M_H",
    /// `B` covers only the computed sequence.
    CompetitorsForgotten: "S.7 on a set without the competitors",
    /// `π/2` is the Poincaré constant of curves.
    PoincareOfCurves: "S.7 with π/2 for N sin(π/2N)",
    /// The left-endpoint rule shows it.
    GapOfConvexityForgotten: "S.9 without K",
    ResidualOfConvexityForgotten: "S.9 without S",
    SampledEnergyHalved: "S.9 with half of P",
    /// The radius becomes `d̄ √e/√c₂`.
    RegionOfC2 in [Competitors]: "S.8 with c₂ for c₁",
    /// It affects the second stage.
    LengthOfC2: "S.8 about the middle with c₂ for c₁",
}
