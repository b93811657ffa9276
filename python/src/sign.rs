//! The sign of a cost or a speed, which the metric, made of its square, does not show.

use tautline_problem::value::{Curve, Given, GivenError};

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
    pub(crate) fn wrong(&self, curve: &dyn Curve) -> Result<Option<String>, GivenError> {
        let (points, dimension) = (curve.points(), curve.dimension());
        let rows: Vec<&[f64]> = points.chunks(dimension).collect();
        let middle =
            |pair: &[&[f64]]| pair[0].iter().zip(pair[1]).map(|(a, b)| 0.5 * (a + b)).collect();
        let middles: Vec<Vec<f64>> = rows.windows(2).map(middle).collect();
        let mut least: Option<(f64, &[f64])> = None;
        for x in rows.iter().copied().chain(middles.iter().map(Vec::as_slice)) {
            let value = self.phi.gram(x)?[0];
            if value < least.map_or(0.0, |(least, _)| least) {
                least = Some((value, x));
            }
        }
        let message = |(value, x)| {
            format!("the {} is {value:?} at {x:?}; expected a positive function", self.name)
        };
        Ok(least.map(message))
    }
}
