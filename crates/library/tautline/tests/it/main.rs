//! Problems, batches and enclosures, as a user meets them.

mod batch;
mod certificates;
mod elsewhere;
mod enclosure;
mod front_door;
mod last_digits;
mod lattice;
mod own_norms;
mod proofs;
mod tables;
