//! `BothEnds`: the ends of a problem, in `R^D` and in a dimension that is a value.

use std::sync::OnceLock;

use tautline_sets::{AnyEnds, Ends};

/// The two sets of a problem. Those in `R^D` are made on first use.
#[derive(Clone, Debug)]
pub(crate) struct BothEnds<const D: usize> {
    any: AnyEnds,
    typed: OnceLock<Ends<D>>,
}

impl<const D: usize> BothEnds<D> {
    pub(crate) fn any(&self) -> &AnyEnds {
        &self.any
    }

    pub(crate) fn typed(&self) -> &Ends<D> {
        let typed = || self.any.in_dimension().expect("the dimension of the problem");
        self.typed.get_or_init(typed)
    }
}

impl<const D: usize> From<Ends<D>> for BothEnds<D> {
    fn from(ends: Ends<D>) -> Self {
        Self { any: ends.in_any(), typed: OnceLock::from(ends) }
    }
}

impl<const D: usize> From<AnyEnds> for BothEnds<D> {
    fn from(any: AnyEnds) -> Self {
        Self { any, typed: OnceLock::new() }
    }
}
