//! Theorems 1.1 to 1.4 from set to set.

use super::chains::{left_endpoint, trapezoidal};
use crate::families::{
    constant_ball_half_space, constant_finite_sets, separable_box_half_space, separable_boxes,
    shear_ball_half_plane, valleys_ball_half_space,
};

#[test]
fn theorems_1_1_and_1_2_from_ball_to_half_space_under_constant_metrics() {
    trapezoidal(1121, 192, constant_ball_half_space::<2>());
    trapezoidal(1122, 128, constant_ball_half_space::<3>());
}

#[test]
fn theorems_1_3_and_1_4_from_ball_to_half_space_under_constant_metrics() {
    left_endpoint(1321, 192, constant_ball_half_space::<2>());
    left_endpoint(1322, 128, constant_ball_half_space::<3>());
}

/// The bounds are 0 for a constant metric, so that no pair but the nearest will do.
#[test]
fn theorems_1_1_to_1_4_between_finite_sets_under_constant_metrics() {
    trapezoidal(1131, 128, constant_finite_sets());
    left_endpoint(1331, 128, constant_finite_sets());
}

#[test]
fn theorems_1_1_and_1_2_from_ball_to_half_plane_under_shears() {
    trapezoidal(1123, 256, shear_ball_half_plane());
}

#[test]
fn theorems_1_3_and_1_4_from_ball_to_half_plane_under_shears() {
    left_endpoint(1323, 256, shear_ball_half_plane());
}

#[test]
fn theorems_1_1_and_1_2_from_box_to_half_space_under_separable_metrics() {
    trapezoidal(1124, 192, separable_box_half_space::<2>());
    trapezoidal(1125, 128, separable_box_half_space::<3>());
}

#[test]
fn theorems_1_3_and_1_4_from_box_to_half_space_under_separable_metrics() {
    left_endpoint(1324, 192, separable_box_half_space::<2>());
    left_endpoint(1325, 128, separable_box_half_space::<3>());
}

#[test]
fn theorems_1_1_and_1_2_from_box_to_box_under_separable_metrics() {
    trapezoidal(1126, 192, separable_boxes::<1>());
    trapezoidal(1127, 192, separable_boxes::<2>());
    trapezoidal(1128, 128, separable_boxes::<3>());
}

#[test]
fn theorems_1_3_and_1_4_from_box_to_box_under_separable_metrics() {
    left_endpoint(1326, 192, separable_boxes::<1>());
    left_endpoint(1327, 192, separable_boxes::<2>());
    left_endpoint(1328, 128, separable_boxes::<3>());
}

#[test]
fn theorems_1_1_and_1_2_from_ball_to_half_space_over_the_valleys() {
    trapezoidal(1129, 256, valleys_ball_half_space());
}

#[test]
fn theorems_1_3_and_1_4_from_ball_to_half_space_over_the_valleys() {
    left_endpoint(1329, 256, valleys_ball_half_space());
}
