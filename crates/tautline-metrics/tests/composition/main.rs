//! Metrics built from metrics: their constants hold and are attained, their distances are those
//! of their parts, and bad parts are refused.

#[path = "../gallery/about.rs"]
mod about;
mod attained;
mod balls;
mod conformal;
mod formulas;
mod hold;
#[path = "../gallery/laws.rs"]
mod laws;
#[path = "../gallery/measure.rs"]
mod measure;
mod refused;
