//! `Program`: the programs that are generic in the dimension and that a mutant can replace.

/// The names of the programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Program {
    DiscreteEnergy,
    DiscreteLength,
    DiscreteSpeeds,
    EnergyGradient,
    CurveEnergy,
    CurveLength,
    K3,
    Christoffel,
    Project,
    Minimise,
    Constants,
    Competitors,
}
