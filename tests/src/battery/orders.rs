//! Observed orders.

super::checks! {
    orders_on_a_shear
    orders_over_the_valleys
    orders_on_a_separable_metric
    orders_on_a_ramp
    the_left_rule_has_order_2_where_the_metric_is_even_about_the_middle
}
