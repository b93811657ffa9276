//! The constants of the paper, with 40 digits.

super::checks! {
    golden_constants_of_constant_metrics
    golden_constants_of_the_valleys
    golden_constants_of_the_shear
    golden_constants_of_a_corrugated_metric
    golden_distances_by_extrapolation
}
