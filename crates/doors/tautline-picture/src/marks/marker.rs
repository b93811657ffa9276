//! The shapes of points.

use crate::measures::MARKER;

/// The shape of a point. All shapes have about the area of the disc.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Marker {
    /// A filled circle.
    Disc,
    /// A circle filled with white.
    Ring,
    /// A filled square.
    Square,
    /// A filled square that stands on one corner.
    Diamond,
    /// A filled triangle that points upwards.
    Triangle,
    /// A diagonal cross.
    Cross,
    /// A filled star with five points, one of which points upwards.
    Star,
}

impl Marker {
    /// Returns the corners relative to the centre, in px; `None` for the round shapes.
    ///
    /// The cross is a polygon too, so that it can have a halo.
    pub(crate) fn corners(self) -> Option<Vec<(f64, f64)>> {
        let r = MARKER;
        // Sides of a square and a triangle that have the area π r² of the disc: √π r, and 2 √π /
        // 3^{1/4} r.
        let half = 0.886 * r;
        match self {
            Marker::Disc | Marker::Ring => None,
            Marker::Square => {
                Some(vec![(-half, -half), (half, -half), (half, half), (-half, half)])
            }
            Marker::Diamond => {
                let reach = 1.253 * r;
                Some(vec![(0.0, -reach), (reach, 0.0), (0.0, reach), (-reach, 0.0)])
            }
            Marker::Triangle => {
                let (side, height) = (2.694 * r, 2.333 * r);
                // The centroid, at a third of the height, is at the data point.
                let (low, high) = (height / 3.0, -2.0 * height / 3.0);
                Some(vec![(-side / 2.0, low), (0.0, high), (side / 2.0, low)])
            }
            Marker::Star => {
                // A pentagram: its inner corners are at 0.382 times the reach of its points. It
                // consists of ten triangles, so that its area is 5 sin 36° · 0.382 reach².
                let reach = 1.673 * r;
                let corner = |k: i32| {
                    let far = if k % 2 == 0 { reach } else { 0.382 * reach };
                    let (sin, cos) = (f64::from(k) * std::f64::consts::PI / 5.0).sin_cos();
                    (far * sin, -far * cos)
                };
                Some((0..10).map(corner).collect())
            }
            Marker::Cross => {
                let (reach, arm) = (1.2 * r, 0.24 * r);
                let (a, b) = (reach - arm, reach + arm);
                let quarter = [(arm * 2.0, 0.0), (b, a), (a, b)];
                let turned = |(x, y): (f64, f64), k: usize| match k {
                    0 => (x, y),
                    1 => (-y, x),
                    2 => (-x, -y),
                    _ => (y, -x),
                };
                Some((0..4).flat_map(|k| quarter.map(|p| turned(p, k))).collect())
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{MARKER, Marker};

    #[test]
    fn polygons_have_the_area_of_the_disc() {
        let disc = std::f64::consts::PI * MARKER * MARKER;
        for marker in [Marker::Square, Marker::Diamond, Marker::Triangle, Marker::Star] {
            let corners = marker.corners().expect("a polygon");
            let twice: f64 = (0..corners.len())
                .map(|k| {
                    let ((x1, y1), (x2, y2)) = (corners[k], corners[(k + 1) % corners.len()]);
                    x1 * y2 - x2 * y1
                })
                .sum();
            assert!((twice.abs() / 2.0 / disc - 1.0).abs() < 0.01, "{marker:?}");
        }
    }

    #[test]
    fn the_cross_is_symmetric() {
        let corners = Marker::Cross.corners().expect("a polygon");
        assert_eq!(corners.len(), 12);
        for (x, y) in &corners {
            assert!(corners.contains(&(-x, -y)), "({x}, {y})");
        }
    }
}
