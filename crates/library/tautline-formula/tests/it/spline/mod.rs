//! Splines, compared with exact arithmetic, with brute force, and with what their documentation
//! says.

mod border;
mod boxes;
mod derivatives;
mod enclosures;
mod exact;
mod interpolation;
mod monotone;
mod pyramids;
mod sampled;
mod shapes;
mod smoothing;
mod table;
mod tightness;
