//! Colours, the palette of the figures, and the ramp of heat-maps.

mod colour;
pub mod palette;
mod ramp;

pub use colour::Colour;
pub use ramp::Ramp;
