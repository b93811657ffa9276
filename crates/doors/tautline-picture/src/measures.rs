//! Lengths of the house style, in px.

/// Size of labels, in px per em.
pub(super) const TEXT: f64 = 15.0;
/// Size of tick labels and of the numbers at slope triangles.
pub(super) const SMALL: f64 = 13.5;
/// Width of a curve.
pub(super) const CURVE: f64 = 1.7;
/// Width of axes.
pub(super) const FRAME: f64 = 0.9;
/// Width of ticks and of thin remarks.
pub(super) const THIN: f64 = 0.8;
/// Length of a labelled tick.
pub(super) const TICK: f64 = 6.0;
/// Length of a tick without a label.
pub(super) const MINOR_TICK: f64 = 3.5;
/// Radius of a disc marker. Other shapes have about the same area.
pub(super) const MARKER: f64 = 3.5;
/// Distance from an axis to its tick labels.
pub(super) const TICK_GAP: f64 = 6.0;
/// Distance from the tick labels to the label of the axis.
pub(super) const LABEL_GAP: f64 = 11.0;
/// Distance from the frame to the labels at the ends of curves.
pub(super) const END_GAP: f64 = 8.0;
/// The same distance if a leader has to be visible.
pub(super) const LEADER_GAP: f64 = 26.0;
/// Distance from the frame to the nearest data point, so that no marker covers an axis.
pub(super) const INSET: f64 = 9.0;
/// Width of the gap of a broken axis.
pub(super) const BREAK: f64 = 26.0;
/// White space around the whole figure.
pub(super) const EDGE: f64 = 8.0;
/// Distance between neighbouring panels, and between rows.
pub(super) const GUTTER: f64 = 22.0;
/// Width of a colour bar.
pub(super) const BAR: f64 = 13.0;
