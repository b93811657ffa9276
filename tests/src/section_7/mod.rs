//! Section 7: the trapezoidal rule.

mod geodesics;
