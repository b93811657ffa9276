//! The constants `c₁`, `c₂`, `L_H` and `M_H` of a metric, enclosed by branch and bound.
//!
//! Each constant is the maximum over the domain of the largest eigenvalue of certain symmetric
//! matrices made from `H` and its derivatives ([`spectral`]), or the negative or the root of this
//! maximum. On a box, intervals bound the eigenvalue ([`eigenvalue_bound`]).

mod biquadratic;
mod certified_constants;
mod eigenvalue_bound;
mod eigenvalue_range;
mod expansion;
mod first_derivative;
mod gram;
pub(crate) mod lifted;
mod quantity;
mod quartic;
mod rows;
mod second_derivative;
mod spectral;
#[cfg(test)]
mod tests;

pub use certified_constants::CertifiedConstants;
pub(crate) use expansion::Expansion;
pub(crate) use lifted::is_bounded;
pub use quantity::Quantity;
pub(crate) use rows::Order;

use tautline_formula::{Formula, Operation};
use tautline_metrics::Metric;
use tautline_scalar::{ANY, Interval, Scalar};

use self::{
    eigenvalue_range::{Eigenvalue, End},
    first_derivative::FirstDerivative,
    gram::Gram,
    second_derivative::SecondDerivative,
    spectral::{LargestEigenvalue, Spectral},
};
use crate::{
    Accuracy, CertifyError, Domain, Progress, Watch, branch_and_bound::maximise, patch::Region,
    progress::unwatched,
};

/// Lower and upper bounds on a constant of a metric on a domain.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub struct CertifiedConstant {
    /// A proved lower bound.
    pub lower: f64,
    /// A proved upper bound.
    pub upper: f64,
    /// A point where the constant is nearly attained, in `ℓ`. One of the two bounds comes from an
    /// evaluation at this point.
    pub at: Vec<f64>,
    /// How many boxes were evaluated.
    pub boxes: usize,
}

impl CertifiedConstant {
    /// Returns `upper / lower`; 1 if both are 0.
    #[must_use]
    pub fn looseness(&self) -> f64 {
        if self.lower == self.upper { 1.0 } else { self.upper / self.lower }
    }

    /// Returns the error that these bounds are not close enough.
    fn spent(&self, quantity: Quantity) -> CertifyError {
        let Self { lower, upper, boxes, .. } = *self;
        CertifyError::BudgetSpent { quantity, lower, upper, boxes }
    }

    /// Returns whether `value` lies between the bounds, so that it may be the constant.
    #[must_use]
    pub fn contains(&self, value: f64) -> bool {
        self.lower <= value && value <= self.upper
    }
}

/// Encloses a constant of `metric` on `domain`.
///
/// The bounds agree to within the tolerance for `c₁` and `c₂`, for multiples of the identity, and
/// in one and two dimensions. Otherwise `L_H` and `M_H` are overestimated by factors of at most
/// `√D` and `D`, usually by a few percent; [`looseness`](CertifiedConstant::looseness) shows how
/// much.
///
/// The result does not depend on the number of threads.
///
/// # Errors
///
/// * [`CertifyError::NoDimension`] if `D = 0`;
/// * [`CertifyError::Coordinates`] if the domain lies in another space;
/// * [`CertifyError::NotATolerance`] if the tolerance is not between 0 and 1;
/// * [`CertifyError::NotRecorded`] if the formula cannot be recorded, or its halves are not known to be
///   equal;
/// * [`CertifyError::Jumps`] for `M_H` if the formula reads second derivatives of a table;
/// * [`CertifyError::NotPositiveDefinite`] with a point where the metric is certainly not so;
/// * [`CertifyError::Undefined`] with a point where the formula, evaluated in intervals, may be
///   undefined;
/// * [`CertifyError::BudgetSpent`] with the bounds so far if they are not within the tolerance,
///   which is always the case for an infinite constant.
pub fn certify<const D: usize>(
    metric: &impl Metric<D>,
    quantity: Quantity,
    domain: &Domain,
    accuracy: Accuracy,
) -> Result<CertifiedConstant, CertifyError> {
    certify_by_formula(&recorded(metric)?, quantity, domain, accuracy, &unwatched)
}

/// Encloses a constant like [`certify`], given the formula in a dimension that is a value, and tells
/// `watch` of the progress.
///
/// # Errors
///
/// Those of [`certify`]; [`CertifyError::BudgetSpent`] also if `watch` ends the search.
pub fn certify_by_formula(
    formula: &Formula<ANY>,
    quantity: Quantity,
    domain: &Domain,
    accuracy: Accuracy,
    watch: &dyn Watch,
) -> Result<CertifiedConstant, CertifyError> {
    let (constant, reached) = enclose(formula, quantity, domain, accuracy, watch)?;
    if reached { Ok(constant) } else { Err(constant.spent(quantity)) }
}

/// Returns the formula of a metric.
pub(crate) fn recorded<const D: usize>(
    metric: &impl Metric<D>,
) -> Result<Formula<ANY>, CertifyError> {
    Formula::record(metric).map(Formula::into_any).map_err(CertifyError::NotRecorded)
}

/// Returns the largest order along an axis of a derivative of a table that the formula reads.
///
/// A spline has third derivatives that jump, so that its second ones have kinks. Boxes that end at the knots
/// would not show it.
fn order_of_tables(formula: &Formula<ANY>) -> u8 {
    let order = |operation: &Operation| match operation {
        Operation::Table(call) => call.orders.into_iter().max().unwrap_or(0),
        _ => 0,
    };
    formula.operations().iter().map(order).max().unwrap_or(0)
}

/// Encloses a constant like [`certify`], and returns whether the tolerance is reached. If it is
/// not, the bounds are those that the budget allows.
fn enclose(
    formula: &Formula<ANY>,
    quantity: Quantity,
    domain: &Domain,
    accuracy: Accuracy,
    watch: &dyn Watch,
) -> Result<(CertifiedConstant, bool), CertifyError> {
    if formula.dimension() == 0 {
        return Err(CertifyError::NoDimension);
    }
    CertifyError::check_coordinates("a domain", domain.dimension(), formula.dimension())?;
    let accuracy = accuracy.checked()?;
    let formula = formula.symmetric().map_err(CertifyError::NotRecorded)?;
    // Those of order 3 jump themselves.
    if order_of_tables(formula) >= if quantity == Quantity::MH { 2 } else { 3 } {
        return Err(CertifyError::Jumps);
    }
    let lift = domain.lift(formula);
    let gram = Gram::new(formula, lift.as_ref());
    let region: &dyn Region = match &lift {
        Some(lift) => lift,
        None => domain,
    };
    let effort = Effort { quantity, region, accuracy, watch };
    let (found, lower, upper) = match quantity {
        Quantity::C1 => {
            let found = search(&Eigenvalue(gram, End::Least), effort, |upper| -upper)?;
            let (bound, witness) = (-found.upper, found.witness);
            (found, bound, witness)
        }
        Quantity::C2 => {
            let found = search(&Eigenvalue(gram, End::Greatest), effort, |upper| upper)?;
            let (bound, witness) = (found.upper, found.witness);
            (found, witness, bound)
        }
        Quantity::LH => {
            // The relative tolerance of a square is twice that of its root.
            let square = Accuracy { tolerance: 2.0 * accuracy.tolerance, ..accuracy };
            let effort = Effort { accuracy: square, ..effort };
            let found = search(&FirstDerivative(gram), effort, |upper| upper.max(0.0).sqrt())?;
            let bound = Interval::point(found.upper.max(0.0)).sqrt().hi();
            let witness = found.witness;
            (found, witness, bound)
        }
        Quantity::MH => {
            let found = search(&SecondDerivative(gram), effort, |upper| upper.max(0.0))?;
            let (witness, bound) = (found.witness, found.upper.max(0.0));
            (found, witness, bound)
        }
    };
    // NaN and infinity do not count as bounds.
    let lower = if lower.is_finite() { lower } else { f64::NEG_INFINITY };
    let upper = if upper.is_finite() { upper } else { f64::INFINITY };
    let boxes = found.boxes;
    let Some(at) = found.at else {
        return Err(CertifyError::BudgetSpent { quantity, lower, upper, boxes });
    };
    let reached = found.reached && lower.is_finite() && upper.is_finite();
    Ok((CertifiedConstant { lower, upper, at, boxes }, reached))
}

/// Where, how closely and under whose eyes a constant is searched for.
#[derive(Clone, Copy)]
struct Effort<'e> {
    quantity: Quantity,
    region: &'e dyn Region,
    accuracy: Accuracy,
    watch: &'e dyn Watch,
}

/// The result of a search, at a point of space, and the bound proved there.
struct Found {
    upper: f64,
    at: Option<Vec<f64>>,
    witness: f64,
    boxes: usize,
    reached: bool,
}

/// Returns the result of a search. `constant` turns an eigenvalue into the constant, up to rounding.
fn search(
    function: &impl Spectral,
    effort: Effort<'_>,
    constant: impl Fn(f64) -> f64,
) -> Result<Found, CertifyError> {
    let Effort { quantity, region, accuracy, watch } = effort;
    let mut goes_on = |boxes, value, bound| {
        let [value, bound] = [value, bound].map(&constant);
        watch.goes_on(Progress { quantity, boxes, bound, value })
    };
    let found = maximise(&LargestEigenvalue(function), region, accuracy, &mut goes_on);
    let gram = function.gram();
    let [at, refuted] =
        [&found.at, &found.refuted].map(|x| x.as_ref().map(|x| function.in_space(x)));
    // The formal derivative of a constant is 0, even if the constant is NaN, so the formula is
    // checked.
    let undefined = || at.clone().filter(|x| gram.is_undefined(x));
    if let Some(point) = refuted.or_else(undefined) {
        return Err(if gram.is_undefined(&point) {
            CertifyError::Undefined { point }
        } else {
            let eigenvalue = function.witness(&point);
            CertifyError::NotPositiveDefinite { point, eigenvalue }
        });
    }
    let witness = at.as_ref().map_or(f64::NAN, |x| function.witness(x));
    Ok(Found { upper: found.upper, at, witness, boxes: found.boxes, reached: found.reached })
}
