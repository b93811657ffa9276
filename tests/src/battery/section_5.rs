//! Section 5: the counterexample.

super::checks! {
    section_5_no_sequence_has_a_discrete_length_below_4_pi
    section_5_is_homogeneous
    section_5_the_discrete_lengths_attain_4_pi_for_every_n
    section_5_brute_force_counts_the_minimisers
    section_5_the_left_rule_reads_the_point_where_a_chord_begins
    section_5_fails_between_other_ends
    section_5_one_jump_undershoots_for_n_up_to_3
    section_5_the_roots_of_the_energies_converge_to_the_distance
}
