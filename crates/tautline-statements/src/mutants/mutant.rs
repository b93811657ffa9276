//! `Mutant`: the library with one deliberate mistake.

/// A deliberately wrong variant of the library: a suite of tests that lets one pass is not worth
/// its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Mutant {
    /// The two rules are exchanged, in energies, gradients and solver.
    RulesExchanged,
    /// The trapezoidal rule takes the mean of `H` at both ends.
    TrueTrapezoid,
    /// A factor ½ in the discrete energy.
    EnergyHalved,
    /// The discrete energy leaves out the last chord.
    LastChordLost,
    /// The discrete length is taken without its square root.
    RootLost,
    /// `E(γᵖˡ)` by one node a chord.
    QuadratureOfOneNode,
    /// `E(γᵖˡ)` by the ends of each chord.
    QuadratureByEnds,
    /// `L(γᵖˡ)` is taken for `E(γᵖˡ)^{1/2}`.
    LengthFromEnergy,
    /// `K₃` without the mean over the chords.
    MeanForgotten,
    /// The gradient with the wrong sign.
    GradientReversed,
    /// The gradient without the derivative of `H`.
    MetricFrozen,
    /// Christoffel symbols with a sign exchanged in the last term.
    ChristoffelSign,
    /// Christoffel symbols without the factor ½.
    ChristoffelDoubled,
    /// The nearest-point map leaves points where they are.
    NotProjected,
    /// The solver lets the first point out of its set by a millionth.
    EndRelaxed,
    /// The solver stops after one step and says that it converged.
    StopsEarly,
    /// The solver returns the straight line and says that it converged.
    NotOptimised,
    /// The solver returns the interpolation of a minimiser of half as many chords.
    NotRefined,
    /// The solver returns the local minimum nearest to the straight line.
    LocalForGlobal,
    /// The search reads `b ∘ a` for `a ∘ b` in the recorded formula.
    OperandsSwapped,
    /// The search rounds the constants of the recorded formula to quarters, so that near ones are one.
    ConstantsMerged,
    /// The search keeps constants of the recorded formula to single precision.
    ConstantsShortened,
    /// The search evaluates the sine where the recorded formula has the cosine.
    SineForCosine,
    /// The search reads `x` for `x²` in the recorded formula, and so on.
    PowerOfStepLost,
    /// The search reads the step beside one of the recorded formula.
    StepBesideRead,
    /// The search takes the entries of `H` off the diagonal for zeros of its structure.
    EntryTakenForZero,
    /// The derivation of `dᵀ ∂ₖH d` has half of the product rule.
    ProductRuleHalved,
    /// The last place of a batch has the rows of the one before.
    LaneLost,
    /// The first place of a batch has the rows of the batch before.
    RegisterStale,
    /// `L_H` is claimed 10 % too small.
    LipschitzTooSmall,
    /// `L_H` is claimed twice too large: nothing is wrong then, but the bounds are loosened.
    LipschitzDoubled,
    /// `c₁` and `c₂` are exchanged in `K_{1,g}`.
    ConstantsExchanged,
    /// `K_{1,g} = d/c₁`, without the root.
    RootOfC1Forgotten,
    /// `K_{2,g}` without `D²`.
    DimensionForgotten,
    /// `K_{2,g}` with `D` for `D²`.
    DimensionOnce,
    /// `C_tra(N)` without its cross term.
    CrossTermLost,
    /// `C_tra(N)` with `1/N` for `1/N²`.
    SecondOrderForgotten,
    /// `C_tra♯` with `K₁²` for `K₁³`.
    PowerOfK1Lost,
    /// `K̄_{3,g}` without the distance.
    DistanceForgotten,
    /// `K̄_{4,g}` is taken for `K̄_{3,g}`.
    K4IsK3,
    /// Proposition 7.9 without the factor ¼.
    QuarterLost,
    /// Proposition 7.9 with `K₃²` for `K₃³`.
    PowerOfK3Lost,
    /// Proposition 7.9 with `1/N` for `1/√N`: true of equal speeds only.
    RootOfNForgotten,
    /// Proposition 8.1 with the factor ¼ for ½.
    HalfOfRuleGap,
    /// Proposition 8.2 with the factor ¼ for ½.
    HalfOfLeftGap,
    /// The `C` of Theorem 1.1 without `C_tra♯`.
    SharpForgotten,
    /// The `C` of Theorem 1.3 without the cube of `K̄_{4,g}`.
    LastCubeForgotten,
    /// Lemma S.1 with `ω = ½` for every metric.
    OmegaHalved,
    /// Lemma S.2 with the factor ¼ for the left-endpoint rule.
    LeftCubeHalved,
    /// Lemma S.2 with `M_H/48N²` for `M_H/24N²`.
    CurvatureGapHalved,
    /// Lemma S.3 without the residual.
    ResidualForgotten,
    /// Lemma S.3 without the change of speed from chord to chord.
    SpeedChangeForgotten,
    /// Lemma S.3 with `¼ L_H K₃²` for `½ L_H K₃²`.
    MomentumGrowthHalved,
    /// Lemma S.3 with `¾` for `3/2` from one difference to the next.
    StepHalved,
    /// Lemma S.4 with `δ/4N` for the left-endpoint rule.
    LeftCeilingHalved,
    /// Lemma S.4 with `G²/24` for `G²/12`.
    SecondVariationHalved,
    /// Lemma S.5 with half of the gap between energy and length.
    LengthGapHalved,
    /// Lemma S.5 with half of the variance of the speeds.
    VarianceHalved,
    /// Lemma S.5 with an `m₃` as if the speeds were symmetric about their mean.
    SkewnessForgotten,
    /// Lemma S.5 with an `m₄` without the fourth power of the deviations.
    KurtosisForgotten,
    /// Theorem A with `Q = √e`, as if all speeds were equal.
    SpeedsOfTheoremAEqual,
    /// Theorem B with `Gδ/6` for `Gδ/3`.
    SampledTermHalved,
    /// Theorem B with `Q` for `Q²`.
    SquareOfSpeedLost,
    /// Theorem B with `μ/48N²` for `μ/24N²`.
    StationaryFourthHalved,
    /// Theorem C with half of what `E_N` may be below `d²`.
    DeficitHalved,
    /// Theorem C with `m₃ = e^{3/2}`, as if all speeds were equal.
    SpeedsOfTheoremCEqual,
    /// Theorem C with half the gap of the length.
    LengthOfTheoremCHalved,
    /// Theorem C with `e` for `e^{3/2}` in the gap of the length.
    PowerOfTheoremCLost,
    /// Theorem D with `μ/48N²` for `μ/24N²`.
    FourthPowerHalved,
    /// Theorem D with half the gap of the length.
    LengthOfTheoremDHalved,
    /// Theorem D with half of what `E_tra,N` may be below `d²`.
    DeficitOfTheoremDHalved,
    /// The least bound of the length of the trapezoidal rule for the left-endpoint rule.
    LeastOfTheOtherRule,
    /// Proposition S.6 with `min E_N ≤ d²`.
    CeilingForgotten,
    /// Proposition S.7 without the term of `L_H`.
    SlopeForgotten,
    /// Proposition S.7 without the term of `M_H`.
    CurvatureOfConvexityForgotten,
    /// Proposition S.7 with a `B` that covers the computed sequence only.
    CompetitorsForgotten,
    /// Proposition S.7 with `π/2` for `N sin(π/2N)`, as for curves.
    PoincareOfCurves,
    /// `d̄ √e/√c₂` for the radius of Proposition S.8.
    RegionOfC2,
}

impl Mutant {
    /// All of them: discretizations, sets, solver, recorded formulas, constants, bounds, sharper bounds.
    pub const ALL: [Mutant; 78] = [
        Mutant::RulesExchanged,
        Mutant::TrueTrapezoid,
        Mutant::EnergyHalved,
        Mutant::LastChordLost,
        Mutant::RootLost,
        Mutant::QuadratureOfOneNode,
        Mutant::QuadratureByEnds,
        Mutant::LengthFromEnergy,
        Mutant::MeanForgotten,
        Mutant::GradientReversed,
        Mutant::MetricFrozen,
        Mutant::ChristoffelSign,
        Mutant::ChristoffelDoubled,
        Mutant::NotProjected,
        Mutant::EndRelaxed,
        Mutant::StopsEarly,
        Mutant::NotOptimised,
        Mutant::NotRefined,
        Mutant::LocalForGlobal,
        Mutant::OperandsSwapped,
        Mutant::ConstantsMerged,
        Mutant::ConstantsShortened,
        Mutant::SineForCosine,
        Mutant::PowerOfStepLost,
        Mutant::StepBesideRead,
        Mutant::EntryTakenForZero,
        Mutant::ProductRuleHalved,
        Mutant::LaneLost,
        Mutant::RegisterStale,
        Mutant::LipschitzTooSmall,
        Mutant::LipschitzDoubled,
        Mutant::ConstantsExchanged,
        Mutant::RootOfC1Forgotten,
        Mutant::DimensionForgotten,
        Mutant::DimensionOnce,
        Mutant::CrossTermLost,
        Mutant::SecondOrderForgotten,
        Mutant::PowerOfK1Lost,
        Mutant::DistanceForgotten,
        Mutant::K4IsK3,
        Mutant::QuarterLost,
        Mutant::PowerOfK3Lost,
        Mutant::RootOfNForgotten,
        Mutant::HalfOfRuleGap,
        Mutant::HalfOfLeftGap,
        Mutant::SharpForgotten,
        Mutant::LastCubeForgotten,
        Mutant::OmegaHalved,
        Mutant::LeftCubeHalved,
        Mutant::CurvatureGapHalved,
        Mutant::ResidualForgotten,
        Mutant::SpeedChangeForgotten,
        Mutant::MomentumGrowthHalved,
        Mutant::StepHalved,
        Mutant::LeftCeilingHalved,
        Mutant::SecondVariationHalved,
        Mutant::LengthGapHalved,
        Mutant::VarianceHalved,
        Mutant::SkewnessForgotten,
        Mutant::KurtosisForgotten,
        Mutant::SpeedsOfTheoremAEqual,
        Mutant::SampledTermHalved,
        Mutant::SquareOfSpeedLost,
        Mutant::StationaryFourthHalved,
        Mutant::DeficitHalved,
        Mutant::SpeedsOfTheoremCEqual,
        Mutant::LengthOfTheoremCHalved,
        Mutant::PowerOfTheoremCLost,
        Mutant::FourthPowerHalved,
        Mutant::LengthOfTheoremDHalved,
        Mutant::DeficitOfTheoremDHalved,
        Mutant::LeastOfTheOtherRule,
        Mutant::CeilingForgotten,
        Mutant::SlopeForgotten,
        Mutant::CurvatureOfConvexityForgotten,
        Mutant::CompetitorsForgotten,
        Mutant::PoincareOfCurves,
        Mutant::RegionOfC2,
    ];

    /// Returns what is wrong with it, in a few words.
    #[must_use]
    pub fn mistake(self) -> &'static str {
        match self {
            Mutant::RulesExchanged => "the two rules exchanged",
            Mutant::TrueTrapezoid => "H averaged over the ends of a chord",
            Mutant::EnergyHalved => "a factor 1/2 in the discrete energy",
            Mutant::LastChordLost => "the last chord left out",
            Mutant::RootLost => "no square root in the discrete length",
            Mutant::QuadratureOfOneNode => "one node a chord in E(γᵖˡ)",
            Mutant::QuadratureByEnds => "the ends of a chord in E(γᵖˡ)",
            Mutant::LengthFromEnergy => "L(γᵖˡ) = √E(γᵖˡ)",
            Mutant::MeanForgotten => "K₃ without the mean",
            Mutant::GradientReversed => "the gradient reversed",
            Mutant::MetricFrozen => "the gradient without DH",
            Mutant::ChristoffelSign => "a wrong sign in Γ",
            Mutant::ChristoffelDoubled => "no factor 1/2 in Γ",
            Mutant::NotProjected => "points not projected",
            Mutant::EndRelaxed => "an end point 10⁻⁶ off its set",
            Mutant::StopsEarly => "one Newton step",
            Mutant::NotOptimised => "the straight line for a minimiser",
            Mutant::NotRefined => "the minimiser of half as many chords",
            Mutant::LocalForGlobal => "a local minimum for the global one",
            Mutant::OperandsSwapped => "operands of a recorded step swapped",
            Mutant::ConstantsMerged => "constants of a recorded formula merged",
            Mutant::ConstantsShortened => "recorded constants in single precision",
            Mutant::SineForCosine => "the sine for a recorded cosine",
            Mutant::PowerOfStepLost => "a power of a recorded step lost",
            Mutant::StepBesideRead => "the step beside a recorded one read",
            Mutant::EntryTakenForZero => "entries of H taken for zeros of its structure",
            Mutant::ProductRuleHalved => "half of the product rule in dᵀ ∂ₖH d",
            Mutant::LaneLost => "the last lane of a batch lost",
            Mutant::RegisterStale => "registers of the batch before",
            Mutant::LipschitzTooSmall => "L_H 10 % too small",
            Mutant::LipschitzDoubled => "L_H twice too large",
            Mutant::ConstantsExchanged => "c₁ and c₂ exchanged in K_{1,g}",
            Mutant::RootOfC1Forgotten => "K_{1,g} = d/c₁",
            Mutant::DimensionForgotten => "K_{2,g} without D²",
            Mutant::DimensionOnce => "K_{2,g} with D for D²",
            Mutant::CrossTermLost => "C_tra(N) without 4c₂K₁K₂/N",
            Mutant::SecondOrderForgotten => "C_tra(N) with 4c₂K₂²/N",
            Mutant::PowerOfK1Lost => "C_tra♯ with K₁² for K₁³",
            Mutant::DistanceForgotten => "K̄_{3,g} without d",
            Mutant::K4IsK3 => "K̄_{4,g} = K̄_{3,g}",
            Mutant::QuarterLost => "7.9 without the factor 1/4",
            Mutant::PowerOfK3Lost => "7.9 with K₃² for K₃³",
            Mutant::RootOfNForgotten => "7.9 with N for √N",
            Mutant::HalfOfRuleGap => "8.1 with 1/4 for 1/2",
            Mutant::HalfOfLeftGap => "8.2 with 1/4 for 1/2",
            Mutant::SharpForgotten => "C of Theorem 1.1 without C_tra♯",
            Mutant::LastCubeForgotten => "C of Theorem 1.3 without K̄_{4,g}³",
            Mutant::OmegaHalved => "ω = 1/2 for every metric",
            Mutant::LeftCubeHalved => "S.2 with 1/4 for the left rule",
            Mutant::CurvatureGapHalved => "S.2 with M_H/48N²",
            Mutant::ResidualForgotten => "S.3 without the residual",
            Mutant::SpeedChangeForgotten => "S.3 with max q = √E",
            Mutant::MomentumGrowthHalved => "S.3 with half the growth of the momentum",
            Mutant::StepHalved => "S.3 with 3/4 from chord to chord",
            Mutant::LeftCeilingHalved => "S.4 with δ/4N for the left rule",
            Mutant::SecondVariationHalved => "S.4 with G²/24",
            Mutant::LengthGapHalved => "S.5 with half the gap of the length",
            Mutant::VarianceHalved => "S.5 with half the variance",
            Mutant::SkewnessForgotten => "S.5 without R v in m₃",
            Mutant::KurtosisForgotten => "S.5 without R²v in m₄",
            Mutant::SpeedsOfTheoremAEqual => "Theorem A with Q = √e",
            Mutant::SampledTermHalved => "Theorem B with Gδ/6 for Gδ/3",
            Mutant::SquareOfSpeedLost => "Theorem B with Q for Q²",
            Mutant::StationaryFourthHalved => "Theorem B with μ/48N²",
            Mutant::DeficitHalved => "Theorem C with half the deficit",
            Mutant::SpeedsOfTheoremCEqual => "Theorem C with m₃ for equal speeds",
            Mutant::LengthOfTheoremCHalved => "Theorem C with half the gap of L(γᵖˡ)",
            Mutant::PowerOfTheoremCLost => "Theorem C with e for its power 3/2",
            Mutant::FourthPowerHalved => "Theorem D with μ/48N²",
            Mutant::LengthOfTheoremDHalved => "Theorem D with half the gap of L(γᵖˡ)",
            Mutant::DeficitOfTheoremDHalved => "Theorem D with half the deficit",
            Mutant::LeastOfTheOtherRule => "the left rule with the trapezoidal least bound",
            Mutant::CeilingForgotten => "S.6 with min E_N ≤ d²",
            Mutant::SlopeForgotten => "S.7 without L_H",
            Mutant::CurvatureOfConvexityForgotten => "S.7 without M_H",
            Mutant::CompetitorsForgotten => "S.7 on a set without the competitors",
            Mutant::PoincareOfCurves => "S.7 with π/2 for N sin(π/2N)",
            Mutant::RegionOfC2 => "S.8 with c₂ for c₁",
        }
    }
}
