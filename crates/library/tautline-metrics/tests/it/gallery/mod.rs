//! The metrics of the gallery: their constants hold and are attained, their distances are
//! distances, and bad parameters are refused.

mod attained;
mod balls;
mod decoder;
mod distances;
mod flags;
mod full_matrices;
mod golden;
mod hold;
mod known;
mod lines;
mod patch_distances;
mod patches;
mod proven;
mod rays;
mod refused;
