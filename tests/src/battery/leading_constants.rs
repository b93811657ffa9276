//! Leading constants.

super::checks! {
    leading_constants_on_a_shear
    leading_constants_over_the_valleys
    leading_constants_on_a_corrugated_metric
}
