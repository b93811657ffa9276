//! What a portrait shows, read from the finished drawing.

mod corridor;
mod extremes;
mod metric;
mod places;
mod reading;
mod refusals;
mod shapes;
