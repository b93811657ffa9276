//! The statements, each as one function that returns [`Evidence`](crate::Evidence).
//!
//! | section | takes | functions |
//! | --- | --- | --- |
//! | 1, main results | a [`Reconstruction`](crate::Reconstruction) | [`theorem_1_1`] to [`theorem_1_4`] |
//! | 5, the counterexample | a point sequence over the valleys | [`section_5_left`], [`section_5_trapezoidal`] |
//! | 7, existence | two sets and two point sequences | [`prop_7_1`], and [`critical_point`] of a minimiser |
//! | 7 and 8, any point sequence | a metric and a point sequence | [`prop_7_8`], [`prop_7_9`], [`prop_8_1`], [`prop_8_2`] |
//! | 7 and 8, constants of the theorems | a [`Reconstruction`](crate::Reconstruction) | [`constant_k3_bar`], [`constant_c_1_1`], [`constant_k4_bar`], [`constant_c_1_3`] |

mod discrete_constants;
mod existence;
mod point_sequences;
mod section_1;
mod section_5;

pub use discrete_constants::{constant_c_1_1, constant_c_1_3, constant_k3_bar, constant_k4_bar};
pub use existence::{critical_point, prop_7_1};
pub use point_sequences::{prop_7_8, prop_7_9, prop_8_1, prop_8_2};
pub use section_1::{theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4};
pub use section_5::{section_5_left, section_5_trapezoidal};
