//! Statements put to numbers that are proved.

super::checks! {
    energies_and_lengths_lie_between_their_bounds
    statements_hold_for_numbers_that_are_proved
}
