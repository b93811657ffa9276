//! Problems as TOML files: a metric, two sets, and options.
//!
//! The file sets the dimension, so the program learns it only when it runs. Every error in a file
//! comes with its place.
//!
//! ```
//! use tautline_problem::Question;
//!
//! let file = r#"
//!     [metric]
//!     cost = "2 - cos(x1)"
//!     [from]
//!     ball = { centre = [0, 0], radius = 0.5 }
//!     [to]
//!     half_space = { normal = [1, 0], at_least = 3 }
//! "#;
//! let answer = Question::read(file)?.solve(&mut |_| ())?;
//! assert!((answer.length.value - 5.338305).abs() < 1e-6); // 5 − sin 3 + sin ½
//!
//! let error = Question::read(&file.replace("radius", "radios")).unwrap_err();
//! assert_eq!(error.help.as_deref(), Some("did you mean radius?"));
//! # Ok::<(), tautline_problem::Failure>(())
//! ```

pub mod array;
mod audited;
mod certify;
mod constants;
mod diagnostic;
mod examples;
mod failure;
mod file;
mod formula;
mod gallery;
mod picture;
mod question;
mod reading;
mod schema;
mod solve;
pub mod sweep;

pub use diagnostic::Diagnostic;
pub use examples::{EXAMPLES, Example};
pub use failure::Failure;
pub use question::Question;
pub use reading::tables::{Open, no_file};
pub use schema::{answer_schema, certified_schema, constants_schema, problem_schema};
pub use schemars::Schema;
pub use solve::Programs;
pub use sweep::{Axis, Sweep, Values};
pub use tautline::{
    LARGEST_N,
    certify::{Progress, Watch},
    check, decimal, distance,
};
pub use tautline_any::{
    Answer, BallAnswer, Bounds, CertificateAnswer, CertifiedAnswer, ConstantAnswer,
    ConstantsAnswer, ConstantsError, Doubt, DoubtAnswer, Estimated, Float, GlobalMinimum, Grid,
    IF_IT_SETTLES, InDimension, LARGEST_DIMENSION, LARGEST_FIXED_DIMENSION,
    LARGEST_PROVED_DIMENSION, LEAST_TOLERANCE, LevelAnswer, OtherMinimum, Search, UsedConstants,
    in_dimension,
};
pub use tautline_picture::{Scene, pdf, png, svg};
