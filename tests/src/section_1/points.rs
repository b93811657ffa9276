//! Theorems 1.1 to 1.4 between two points.

use super::chains::{left_endpoint, trapezoidal};
use crate::families::{constant, points, ramp, separable, shear, valleys_across, valleys_along};

#[test]
fn theorems_1_1_and_1_2_on_constant_metrics() {
    trapezoidal(1101, 128, points(constant::<2>()));
    trapezoidal(1102, 128, points(constant::<4>()));
}

#[test]
fn theorems_1_3_and_1_4_on_constant_metrics() {
    left_endpoint(1301, 128, points(constant::<2>()));
    left_endpoint(1302, 128, points(constant::<4>()));
}

#[test]
fn theorems_1_1_and_1_2_on_shears() {
    trapezoidal(1103, 384, points(shear()));
}

#[test]
fn theorems_1_3_and_1_4_on_shears() {
    left_endpoint(1303, 384, points(shear()));
}

#[test]
fn theorems_1_1_and_1_2_on_separable_metrics() {
    trapezoidal(1104, 256, points(separable::<1>()));
    trapezoidal(1105, 256, points(separable::<2>()));
    trapezoidal(1106, 192, points(separable::<3>()));
    trapezoidal(1107, 128, points(separable::<5>()));
}

#[test]
fn theorems_1_3_and_1_4_on_separable_metrics() {
    left_endpoint(1304, 256, points(separable::<1>()));
    left_endpoint(1305, 256, points(separable::<2>()));
    left_endpoint(1306, 192, points(separable::<3>()));
    left_endpoint(1307, 128, points(separable::<5>()));
}

#[test]
fn theorems_1_1_and_1_2_on_ramps() {
    trapezoidal(1108, 384, points(ramp()));
}

#[test]
fn theorems_1_3_and_1_4_on_ramps() {
    left_endpoint(1308, 384, points(ramp()));
}

#[test]
fn theorems_1_1_and_1_2_along_the_valleys_axis() {
    trapezoidal(1109, 256, valleys_along());
}

#[test]
fn theorems_1_3_and_1_4_along_the_valleys_axis() {
    left_endpoint(1309, 256, valleys_along());
}

#[test]
fn theorems_1_1_and_1_2_across_the_valleys() {
    trapezoidal(1110, 256, valleys_across::<2>());
    trapezoidal(1111, 128, valleys_across::<3>());
}

#[test]
fn theorems_1_3_and_1_4_across_the_valleys() {
    left_endpoint(1310, 256, valleys_across::<2>());
    left_endpoint(1311, 128, valleys_across::<3>());
}
