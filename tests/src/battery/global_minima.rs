//! Global minima, by dynamic programming.

super::checks! {
    section_5_the_solver_finds_the_global_minimum_of_the_trapezoidal_energy
    section_5_the_solver_finds_the_global_minimum_of_the_left_endpoint_energy
    the_solver_finds_the_global_minimum_on_a_ramp
}
