//! Gradients of the discrete energies.

super::checks! {
    gradients_agree_with_differences_of_order_2
}
