//! The sign of a cost or a speed, which the metric, made of its square, does not show.

use tautline_any::{Curve, Given, GivenError};

/// A cost or a speed.
#[derive(Clone)]
pub(crate) struct Sign {
    /// Cost or speed.
    pub(crate) name: String,
    /// The function itself: φ I.
    pub(crate) phi: Given,
}

impl Sign {
    /// Returns the sign that is to be looked at, if the function may be negative somewhere.
    pub(crate) fn of(name: String, phi: Given) -> Option<Self> {
        (!phi.is_positive_everywhere()).then_some(Self { name, phi })
    }

    /// Returns what is wrong if the function is negative at a point of a curve, or in the middle of a
    /// chord.
    pub(crate) fn wrong(&self, curve: &Curve) -> Result<Option<String>, GivenError> {
        let least = self.phi.least_entry_along(curve)?.filter(|(value, _)| *value < 0.0);
        let message = |(value, x)| {
            format!("the {} is {value:?} at {x:?}; expected a positive function", self.name)
        };
        Ok(least.map(message))
    }
}
