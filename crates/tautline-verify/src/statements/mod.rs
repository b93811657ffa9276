//! The statements, each as one function that returns [`Evidence`](crate::Evidence).
//!
//! | section | takes | functions |
//! | --- | --- | --- |
//! | 1, main results | a [`Reconstruction`](crate::Reconstruction) | [`theorem_1_1`] to [`theorem_1_4`] |
//! | 7, curves | a [`Curve`](crate::curves::Curve) | [`prop_7_2`] to [`prop_7_4`] |
//! | 7 and 8, any point sequence | a metric and a point sequence | [`prop_7_8`], [`prop_7_9`], [`prop_8_1`], [`prop_8_2`] |

mod morrey;
mod point_sequences;
mod section_1;

pub use morrey::{prop_7_2, prop_7_2_as_printed, prop_7_3, prop_7_3_as_printed, prop_7_4};
pub use point_sequences::{prop_7_8, prop_7_9, prop_8_1, prop_8_2};
pub use section_1::{theorem_1_1, theorem_1_2, theorem_1_3, theorem_1_4};
