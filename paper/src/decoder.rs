//! The decoder whose pullback a figure and tables examine.

use tautline::{
    SMatrix,
    gallery::{GalleryError, TanhDecoder},
};

/// Returns the metric of a surface in space that two layers decode from a plane.
pub(crate) fn decoder() -> Result<TanhDecoder<2, 3, 3>, GalleryError> {
    let inner = SMatrix::<f64, 3, 2>::new(1.0, 0.2, -0.5, 0.8, 0.3, -1.0);
    let outer = SMatrix::<f64, 3, 3>::new(1.0, 0.0, 0.5, 0.0, 1.0, -0.5, 0.4, 0.3, 1.0);
    TanhDecoder::new(inner, outer, 0.5)
}
