//! The statements, each as one function that returns [`Evidence`](crate::Evidence).

mod apriori;
mod discrete_constants;
mod distances;
mod energy_and_length;
mod existence;
mod functional_lipschitz;
mod geodesics;
mod gram_derivatives;
mod length_excess;
mod minimal_curves;
mod morrey;
mod nearest_pair;
mod point_sequences;
mod sampled_curves;
mod section_1;
mod section_5;
mod sharper;
mod way_out;

pub use apriori::*;
pub use discrete_constants::*;
pub use distances::*;
pub use energy_and_length::*;
pub use existence::*;
pub use functional_lipschitz::*;
pub use geodesics::*;
pub use gram_derivatives::*;
pub use length_excess::*;
pub use minimal_curves::*;
pub use morrey::*;
pub use nearest_pair::*;
pub use point_sequences::*;
pub use sampled_curves::*;
pub use section_1::*;
pub use section_5::*;
pub use sharper::*;
pub use way_out::*;
