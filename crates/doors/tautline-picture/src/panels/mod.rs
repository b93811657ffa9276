//! Panels and figures: layout and drawing.

mod colour_bar;
mod end_label;
mod figure;
mod foot;
mod frame;
mod key;
mod panel;
mod plot;
mod push_apart;
mod remark;

pub use figure::Figure;
pub use panel::Panel;
