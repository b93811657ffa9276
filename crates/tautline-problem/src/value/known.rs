//! `Known`: a metric by its formula or by its values.

use core::ops::ControlFlow;
use std::sync::Arc;

use tautline::{
    BlackBox, CertificateError, Formula, Interval, Metric, RecordError, SVector, Table, TautLine,
    certify::{Accuracy, Watch},
    distance::{Progress, Wanted},
};
use tautline_portrait::Shape;

use super::{GivenError, curve::NamedRule};
use crate::{
    Bounds, CertifiedAnswer, ConstantsAnswer,
    bounds::Proving,
    constants::{ConstantsError, constants},
};

/// Is told of every level of a certificate, and may end the search.
pub type Observe<'o> = &'o mut dyn FnMut(Progress) -> ControlFlow<()>;

/// A metric as a program gives it, and what is proved of it.
pub(super) trait Known<const D: usize>:
    Metric<D> + Clone + std::fmt::Debug + Send + 'static
{
    /// Returns the text of the formula, if there is one.
    fn text(&self) -> Option<String>;

    /// Returns the formula, if there is one.
    fn formula(&self) -> Option<&Formula<D>>;

    /// Returns whether interval arithmetic shows that the first entry of `H` is positive everywhere.
    fn is_positive_everywhere(&self) -> bool;

    /// Returns the tables that the text calls, in the order of their numbers.
    fn tables(&self) -> &[Arc<dyn Table>];

    /// Proves the constants.
    fn constants(
        &self,
        within: Option<&Shape>,
        accuracy: Accuracy,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError>;

    /// Proves bounds on the distance.
    fn bounds<R: NamedRule>(
        line: &TautLine<Self, R, D>,
        proving: Proving,
        watch: &dyn Watch,
        observe: Observe<'_>,
    ) -> Result<Bounds, String>;

    /// Searches for a certificate.
    fn certificate<R: NamedRule>(
        line: &TautLine<Self, R, D>,
        wanted: Wanted,
        observe: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError>;
}

impl<const D: usize> Known<D> for Formula<D> {
    fn text(&self) -> Option<String> {
        Some(self.to_string())
    }

    fn formula(&self) -> Option<&Formula<D>> {
        Some(self)
    }

    fn is_positive_everywhere(&self) -> bool {
        // An undefined entry has no positive bound.
        self.gram(&SVector::from_element(Interval::REALS))[(0, 0)].lo() > 0.0
    }

    fn tables(&self) -> &[Arc<dyn Table>] {
        self.tables()
    }

    fn constants(
        &self,
        within: Option<&Shape>,
        accuracy: Accuracy,
        watch: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError> {
        Ok(constants(self, within, accuracy, watch)?)
    }

    fn bounds<R: NamedRule>(
        line: &TautLine<Self, R, D>,
        proving: Proving,
        watch: &dyn Watch,
        observe: Observe<'_>,
    ) -> Result<Bounds, String> {
        R::bounds(line, proving, watch, observe)
    }

    fn certificate<R: NamedRule>(
        line: &TautLine<Self, R, D>,
        wanted: Wanted,
        observe: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError> {
        CertifiedAnswer::of(line, wanted, observe)
    }
}

/// Nothing is proved of a metric without a formula.
impl<const D: usize> Known<D> for BlackBox<D> {
    fn text(&self) -> Option<String> {
        None
    }

    fn formula(&self) -> Option<&Formula<D>> {
        None
    }

    fn is_positive_everywhere(&self) -> bool {
        false
    }

    fn tables(&self) -> &[Arc<dyn Table>] {
        &[]
    }

    fn constants(
        &self,
        _: Option<&Shape>,
        _: Accuracy,
        _: &dyn Watch,
    ) -> Result<ConstantsAnswer, GivenError> {
        Err(ConstantsError::NotRecorded(RecordError::BlackBox).into())
    }

    fn bounds<R: NamedRule>(
        _: &TautLine<Self, R, D>,
        _: Proving,
        _: &dyn Watch,
        _: Observe<'_>,
    ) -> Result<Bounds, String> {
        Err(RecordError::BlackBox.to_string())
    }

    fn certificate<R: NamedRule>(
        _: &TautLine<Self, R, D>,
        _: Wanted,
        _: Observe<'_>,
    ) -> Result<CertifiedAnswer, CertificateError> {
        Err(RecordError::BlackBox.into())
    }
}
