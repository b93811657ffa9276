//! Bounds sharper than those of the paper. They are of order `1/N` and `1/N²` and do not depend on
//! the dimension, and some need only one computed sequence. The proofs are in `paper/SHARPER.md`.

mod acceleration;
mod best;
mod ceiling;
mod computed;
mod convex_excess;
mod convexity;
mod enclosure;
mod length;
mod locality;
mod own_norms;
mod sampling;
mod sequence_gap;
mod speeds;
mod spread;
mod theorem_a;
mod theorem_b;
mod theorem_c;
mod theorem_d;

pub use acceleration::{christoffel_bound, k2_sharp};
pub use best::{
    Bound, Theorem, first_order_excess, least_excess, least_length_excess, second_order_excess,
    suggest_n,
};
pub use computed::{Computed, DiscreteMinimum};
pub use convex_excess::{convex_excess, convex_excess_outward, sampled_excess};
pub use convexity::{BetweenPoints, convexity_modulus, strict_convexity, strict_convexity_outward};
pub use enclosure::{Enclosure, FromAbove, FromBelow, enclose, enclose_outward};
pub use length::squared_length;
pub use locality::{
    LocalityError, Region, competitors, competitors_within, reach, reach_outward, shrink,
};
pub use own_norms::OwnNorms;
pub use sampling::{pointwise_fall, pointwise_rise, sampling_fall, sampling_rise, velocity_error};
pub use sequence_gap::{cubic_gap, cubic_rule_gap, quartic_gap};
pub use speeds::{difference_step, greatest_difference, greatest_speed};
pub use spread::Spread;
pub use theorem_a::{
    theorem_a_constant, theorem_a_excess, theorem_a_minimum_gap, theorem_a_polyline_gap,
};
pub use theorem_b::{
    theorem_b_constant, theorem_b_excess, theorem_b_minimum_gap, theorem_b_polyline_gap,
};
pub use theorem_c::{
    theorem_c_deficit, theorem_c_excess, theorem_c_length_excess, theorem_c_polyline_gap,
};
pub use theorem_d::{
    theorem_d_deficit, theorem_d_excess, theorem_d_length_excess, theorem_d_minimum_gap,
    theorem_d_polyline_gap,
};
