//! Constants that are claimed: four numbers, or what `Metric.constants` returns.

use pyo3::{prelude::*, types::PyDict};
use tautline::Constants;

use crate::{
    bounds::{Constant, FourConstants},
    error::ProblemError,
};

/// Constants of a metric, as a function takes them.
pub(crate) struct Claims(pub(crate) Constants);

impl<'a, 'py> FromPyObject<'a, 'py> for Claims {
    type Error = PyErr;

    fn extract(given: Borrowed<'a, 'py, PyAny>) -> PyResult<Self> {
        let (c1, c2, l_h, m_h) = match given.cast::<PyDict>() {
            Ok(named) => proved(&named)?,
            Err(_) => numbers(&given)?,
        };
        let constants = Constants::new(c1, c2, l_h);
        let constants =
            constants.and_then(|found| m_h.map_or(Ok(found), |m_h| found.with_m_h(m_h)));
        constants.map(Claims).map_err(|error| ProblemError::new_err(error.to_string()))
    }
}

fn numbers(given: &Bound<'_, PyAny>) -> PyResult<FourConstants> {
    given.extract().map_err(|_| {
        let shown = given.repr().map_or_else(|_| "something else".to_owned(), |text| text.to_string());
        ProblemError::new_err(format!(
            "the constants are {shown}; expected (c1, c2, L_H, M_H), where M_H may be None, or what \
             Metric.constants returns"
        ))
    })
}

/// Returns the bounds of constants that are valid for every curve: c1 from below, the others from above.
fn proved(named: &Bound<'_, PyDict>) -> PyResult<FourConstants> {
    let bound = |name: &str| -> PyResult<Option<f64>> {
        let Some(found) = named.get_item(name)? else { return Ok(None) };
        let constant = found.cast::<Constant>()?.get();
        Ok(if name == "c1" { constant.lower } else { constant.upper })
    };
    let known = |name: &str| {
        let missing =
            || ProblemError::new_err(format!("the constants have no proved bound on {name}"));
        bound(name)?.ok_or_else(missing)
    };
    Ok((known("c1")?, known("c2")?, known("L_H")?, bound("M_H")?))
}
