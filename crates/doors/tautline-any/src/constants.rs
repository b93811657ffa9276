//! `ConstantsAnswer`: the constants of a metric, proved from its formula.

use schemars::JsonSchema;
use serde::Serialize;
use tautline::{
    ANY, AnySet, CertifiedConstant, CertifyError, Domain, Formula, Quantity, RecordError, SetError,
    Shape,
    certify::{Accuracy, Cell, Watch, certify_by_formula},
};

use crate::{Float, LARGEST_EXPANSION, LARGEST_PROVED_DIMENSION};

/// The constants of a metric, and where they hold.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(title = "Constants of a metric")]
pub struct ConstantsAnswer {
    /// Where they hold: all of space, or the region of the file.
    pub region: String,
    /// Whether they hold only if the metric settles, which is not proved; the region says so, too.
    pub if_it_settles: bool,
    /// The constants c1, c2, L_H and M_H.
    pub constants: Vec<ConstantAnswer>,
}

/// One constant.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ConstantAnswer {
    /// Its name.
    pub name: String,
    /// What it bounds.
    pub bounds: &'static str,
    /// Whether the two bounds are within the wanted accuracy.
    pub proved: bool,
    /// A proved lower bound on the best constant; absent if there is none.
    pub lower: Option<Float>,
    /// A proved upper bound on the best constant; absent if there is none.
    pub upper: Option<Float>,
    /// A point where it is nearly attained.
    pub at: Option<Vec<f64>>,
    /// Why it is not proved.
    pub reason: Option<String>,
}

impl ConstantAnswer {
    /// Returns whether the bounds give a constant that theorems can use, close or not.
    #[must_use]
    pub fn is_known(&self) -> bool {
        let positive = self.lower.as_ref().is_some_and(|lower| lower.value > 0.0);
        self.upper.is_some() && (positive || self.name != Quantity::C1.to_string())
    }
}

impl ConstantsAnswer {
    /// Returns whether all constants are proved.
    #[must_use]
    pub fn are_proved(&self) -> bool {
        self.constants.iter().all(|constant| constant.proved)
    }
}

/// Why no constants were sought.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ConstantsError {
    /// The region is neither a ball nor a box, or lies in another dimension.
    #[error("{0}")]
    Region(String),
    /// The formula does not show what happens far out, and no region was given.
    #[error("no constants on all of space: {0}; name a ball or a box within which they hold")]
    NotAllOfSpace(CertifyError),
    /// There is no formula.
    #[error(transparent)]
    NotRecorded(RecordError),
    /// There are more than [`LARGEST_PROVED_DIMENSION`].
    #[error(
        "constants are proved from a formula in up to {LARGEST_PROVED_DIMENSION} dimensions; claim c1, \
         c2 and l_h in [certify], constants"
    )]
    TooManyCoordinates,
    /// In more than six dimensions the formula has more than [`LARGEST_EXPANSION`] numbers.
    #[error(
        "in {dimension} dimensions constants are proved from formulas of up to {most} steps, and this one \
         has {steps}; claim c1, c2 and l_h in [certify], constants"
    )]
    TooManySteps {
        /// The dimension.
        dimension: usize,
        /// The number of steps of the formula.
        steps: usize,
        /// The most steps in this dimension.
        most: usize,
    },
}

/// Returns why constants of a formula are not proved, if they take too long.
///
/// # Errors
///
/// [`ConstantsError::TooManyCoordinates`] and [`ConstantsError::TooManySteps`].
pub(crate) fn are_provable(formula: &Formula<ANY>) -> Result<(), ConstantsError> {
    let (dimension, steps) = (formula.dimension(), formula.operations().len());
    let row = 1 + dimension + dimension * (dimension + 1) / 2;
    let most = if dimension > 6 { LARGEST_EXPANSION / row } else { usize::MAX };
    if dimension > LARGEST_PROVED_DIMENSION {
        Err(ConstantsError::TooManyCoordinates)
    } else if steps > most {
        Err(ConstantsError::TooManySteps { dimension, steps, most })
    } else {
        Ok(())
    }
}

/// Proves the constants of a formula, in a ball or a box or on all of space. `watch` is told of the progress,
/// and may end the search for a constant.
///
/// # Errors
///
/// [`ConstantsError`].
pub fn constants(
    formula: &Formula<ANY>,
    within: Option<&Shape<ANY>>,
    accuracy: Accuracy,
    watch: &dyn Watch,
) -> Result<ConstantsAnswer, ConstantsError> {
    are_provable(formula)?;
    let (domain, region) = domain(formula, within)?;
    let if_it_settles = domain.is_declared_to_settle();
    let of = |quantity| {
        let found = certify_by_formula(formula, quantity, &domain, accuracy, watch);
        answer(quantity, found)
    };
    Ok(ConstantsAnswer { region, if_it_settles, constants: Quantity::ALL.map(of).into() })
}

/// What constants on all of space assume of a metric that is declared to settle.
pub const IF_IT_SETTLES: &str = "if the metric settles within a distance of 2^100";

/// Returns where constants are proved, and the same in words.
fn domain(
    formula: &Formula<ANY>,
    within: Option<&Shape<ANY>>,
) -> Result<(Domain, String), ConstantsError> {
    let refuse = |message: String| ConstantsError::Region(message);
    let (domain, region) = match within {
        None => {
            let space = Domain::space_by_formula(formula);
            if space.is_all_of_space() {
                return Ok((space, "all of space".to_owned()));
            }
            let settled = Domain::settled_space_by_formula(formula);
            return settled
                .map(|space| (space, format!("all of space, {IF_IT_SETTLES}")))
                .map_err(ConstantsError::NotAllOfSpace);
        }
        Some(shape) if shape.dimension() != formula.dimension() => {
            let (what, found) = (shape.name(), shape.dimension());
            let other = SetError::Coordinates { what, found, dimension: formula.dimension() };
            return Err(refuse(other.to_string()));
        }
        Some(Shape::Ball(ball)) => {
            let (centre, r) = (ball.centre_slice(), ball.r());
            let region = format!("the ball of radius {r} about {centre:?}");
            (Domain::ball(centre, r), region)
        }
        Some(Shape::AxisBox(side)) => {
            let [low, high] = side.corner_slices();
            let region = format!("the box from {low:?} to {high:?}");
            (Cell::new(low, high).map(Domain::cell), region)
        }
        Some(shape) => {
            return Err(refuse(format!("constants hold in a ball or a box, not {}", shape.name())));
        }
    };
    domain.map(|domain| (domain, region)).map_err(|error| refuse(error.to_string()))
}

fn answer(quantity: Quantity, proved: Result<CertifiedConstant, CertifyError>) -> ConstantAnswer {
    let finite = |bound: f64| bound.is_finite().then(|| Float::from(bound));
    let name = quantity.to_string();
    let bounds = match quantity {
        Quantity::C1 => "c1 |v|² ≤ vᵀH(x)v",
        Quantity::C2 => "vᵀH(x)v ≤ c2 |v|²",
        Quantity::LH => "‖DH(x)[v]‖ ≤ L_H |v|",
        Quantity::MH => "‖D²H(x)[v, w]‖ ≤ M_H |v| |w|",
    };
    let none = ConstantAnswer {
        name,
        bounds,
        proved: false,
        lower: None,
        upper: None,
        at: None,
        reason: None,
    };
    match proved {
        Ok(constant) => ConstantAnswer {
            proved: true,
            lower: finite(constant.lower),
            upper: finite(constant.upper),
            at: Some(constant.at),
            ..none
        },
        Err(error) => {
            let (lower, upper, at) = match &error {
                CertifyError::BudgetSpent { lower, upper, .. } => {
                    (finite(*lower), finite(*upper), None)
                }
                CertifyError::NotPositiveDefinite { point, .. }
                | CertifyError::Undefined { point } => (None, None, Some(point.clone())),
                _ => (None, None, None),
            };
            ConstantAnswer { lower, upper, at, reason: Some(error.to_string()), ..none }
        }
    }
}
