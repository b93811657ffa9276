//! The rules, one a file.

pub(crate) mod gauss_three;
pub(crate) mod gauss_two;
pub(crate) mod left_endpoint;
pub(crate) mod right_endpoint;
pub(crate) mod simpson;
pub(crate) mod trapezoidal;
pub(crate) mod true_trapezoid;
