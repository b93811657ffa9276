//! The Python module `tautline_geodesics._tautline`. The package `tautline_geodesics` documents it.

mod accuracy;
mod avoiding;
mod black_box;
mod bounds;
mod certificate;
mod claims;
mod curve;
mod error;
mod estimate;
mod interruptible;
mod metric;
mod pool;
mod problem_file;
mod set;
mod sign;
mod sweep;
mod table;
mod text;

use pyo3::{prelude::*, types::PyTuple};
use tautline::Rule;

/// Shortest curves between two closed sets, and certificates of their distance.
#[pymodule]
mod _tautline {
    #[pymodule_export]
    use crate::{
        avoiding::avoiding,
        bounds::{Bounds, Constant, theorem_1_1, theorem_1_3},
        certificate::{Certificate, Verdict, check},
        curve::Curve,
        error::{LatticeError, MetricError, NotCertified, ProblemError, SignError},
        estimate::Estimate,
        metric::Program,
        problem_file::problem_file,
        set::Set,
        sweep::{Plan, is_finished, merged, shard},
        table::Spline,
    };

    use super::*;

    #[pymodule_init]
    fn init(module: &Bound<'_, PyModule>) -> PyResult<()> {
        module.add("RULES", PyTuple::new(module.py(), Rule::NAMES)?)?;
        module.add("__version__", env!("CARGO_PKG_VERSION"))
    }
}
