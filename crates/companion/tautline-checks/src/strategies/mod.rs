//! Proptest strategies: points, point sequences, curves, metrics, and problems with known
//! distances.

mod balls;
mod curves;
mod geodesics;
mod metrics;
mod points;
mod problems;

pub use balls::{gaussian_fisher_nearby, hyperbolic_nearby, sphere_nearby};
pub use curves::{kinked_curve, smooth_curve, smooth_curve_between, times};
pub use geodesics::{clock, in_hyperbolic_space, joined, on_sphere, ray};
pub use metrics::{bump, constant, hill, lens, ramp, separable, shear};
pub use points::{sequence, subintervals, two_points, vector};
pub use problems::{
    constant_ball_half_space, constant_finite_sets, points, separable_box_half_space,
    separable_boxes, shear_ball_half_plane, valleys_across, valleys_along, valleys_ball_half_space,
};
