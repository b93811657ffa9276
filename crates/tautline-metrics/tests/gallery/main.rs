//! The metrics of the gallery: their constants hold and are attained, their distances are
//! distances, and bad parameters are refused.

mod attained;
mod distances;
mod full_matrices;
mod hold;
mod interval;
mod lines;
mod measure;
mod proven;
mod rays;
mod refused;
