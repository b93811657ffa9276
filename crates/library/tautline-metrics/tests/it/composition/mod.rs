//! Metrics built from other metrics: their constants hold and are attained, their distances follow
//! from those of the parts, and bad parts are refused.

mod attained;
mod balls;
mod conformal;
mod formulas;
mod hold;
mod refused;
