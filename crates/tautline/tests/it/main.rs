//! The front door: problems, batches and enclosures.

mod batch;
mod enclosure;
mod front_door;
