//! The constants of the metric of a file, proved from its formula.

use tautline::certify::{Progress, Watch};
use tautline_any::{ConstantsAnswer, ConstantsError, constants};

use crate::{Diagnostic, Failure, Question};

impl Question {
    /// Proves the constants of the metric: in the region of the file, or on all of space if the
    /// formula shows what happens far out, or seems to settle there.
    ///
    /// # Errors
    ///
    /// [`Failure::BadInput`] if the formula is wrong; [`Failure::NotComputed`] if no region is
    /// known, or if there are too many dimensions.
    pub fn constants(&self) -> Result<ConstantsAnswer, Failure> {
        self.constants_watched(&|_: Progress| true)
    }

    /// Proves the constants like [`constants`](Question::constants), and tells `watch` of the
    /// progress. If `watch` ends a search, the bounds found so far are the answer.
    ///
    /// # Errors
    ///
    /// Those of [`constants`](Question::constants).
    pub fn constants_watched(&self, watch: &dyn Watch) -> Result<ConstantsAnswer, Failure> {
        let formula = self.any_formula()?;
        let within = self.within.as_ref().map(|within| &within.shape);
        let proved = constants(&formula, within, self.accuracy(), watch);
        proved.map_err(|error| match (error, &self.within) {
            (ConstantsError::Region(message), Some(within)) => {
                let place = within.places.first().cloned().unwrap_or_default();
                Failure::BadInput(Diagnostic::new(message, place))
            }
            (ConstantsError::NotAllOfSpace(error), _) => Failure::NotComputed(format!(
                "no constants on all of space: {error}. Constants in a region need [certify] with \
                 within = {{ ball = … }} or {{ box = … }}"
            )),
            (error, _) => Failure::NotComputed(error.to_string()),
        })
    }
}
