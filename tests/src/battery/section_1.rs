//! Section 1: the theorems.

super::checks! {
    theorems_1_1_and_1_2_hold_between_points
    theorems_1_1_and_1_2_hold_from_set_to_set
    theorems_1_3_and_1_4_hold_between_points
    theorems_1_3_and_1_4_hold_from_set_to_set
    theorems_1_1_and_1_2_are_homogeneous
    theorems_1_3_and_1_4_are_homogeneous
}
