//! Parts of polygons and polylines: cut by a half-plane or a box, without respect to the unit.
//!
//! Points far outside a panel have no place on the canvas, so that a shape is clipped before it is
//! placed.

/// A point of the plane.
type Point = (f64, f64);

/// Returns the part of a convex polygon in which `a x + b y ≤ c`; it is empty if there is none
/// (Sutherland and Hodgman). A polygon that is not convex may get edges along the cut.
#[must_use]
pub fn by_half_plane(ring: &[Point], (a, b): (f64, f64), c: f64) -> Vec<Point> {
    let excess = |(x, y): Point| a * x + b * y - c;
    let mut kept = Vec::with_capacity(ring.len() + 1);
    for (k, &to) in ring.iter().enumerate() {
        let from = ring[(k + ring.len() - 1) % ring.len()];
        let (before, after) = (excess(from), excess(to));
        if (before <= 0.0) != (after <= 0.0) {
            let t = before / (before - after);
            kept.push((from.0 + t * (to.0 - from.0), from.1 + t * (to.1 - from.1)));
        }
        if after <= 0.0 {
            kept.push(to);
        }
    }
    kept
}

/// Returns the part of a polygon inside a box; it is empty if there is none.
#[must_use]
pub fn to_box(ring: &[Point], x: (f64, f64), y: (f64, f64)) -> Vec<Point> {
    let sides = [((-1.0, 0.0), -x.0), ((1.0, 0.0), x.1), ((0.0, -1.0), -y.0), ((0.0, 1.0), y.1)];
    sides.into_iter().fold(ring.to_vec(), |ring, (normal, c)| by_half_plane(&ring, normal, c))
}

/// Returns the pieces of a polyline that lie inside a box.
#[must_use]
pub fn polyline(points: &[Point], x: (f64, f64), y: (f64, f64)) -> Vec<Vec<Point>> {
    let mut pieces: Vec<Vec<Point>> = Vec::new();
    for pair in points.windows(2) {
        let Some((from, to)) = chord((pair[0], pair[1]), x, y) else { continue };
        match pieces.last_mut() {
            Some(piece) if piece.last() == Some(&from) => piece.push(to),
            _ => pieces.push(vec![from, to]),
        }
    }
    pieces
}

/// Returns the part of a chord inside a box (Liang and Barsky).
fn chord((from, to): (Point, Point), x: (f64, f64), y: (f64, f64)) -> Option<(Point, Point)> {
    let (dx, dy) = (to.0 - from.0, to.1 - from.1);
    let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
    for (speed, room) in
        [(-dx, from.0 - x.0), (dx, x.1 - from.0), (-dy, from.1 - y.0), (dy, y.1 - from.1)]
    {
        if speed == 0.0 && room < 0.0 {
            return None;
        } else if speed < 0.0 {
            enters = enters.max(room / speed);
        } else if speed > 0.0 {
            leaves = leaves.min(room / speed);
        }
    }
    let at = |t: f64| {
        if t == 0.0 {
            from
        } else if t == 1.0 {
            to
        } else {
            // A convex combination does not overflow, unlike a multiple of the difference.
            ((1.0 - t) * from.0 + t * to.0, (1.0 - t) * from.1 + t * to.1)
        }
    };
    (enters <= leaves).then(|| (at(enters), at(leaves)))
}

#[cfg(test)]
mod tests {
    use super::{by_half_plane, polyline, to_box};

    const SQUARE: [(f64, f64); 4] = [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)];

    fn area(ring: &[(f64, f64)]) -> f64 {
        let next = ring.iter().cycle().skip(1);
        ring.iter().zip(next).map(|(p, q)| p.0 * q.1 - q.0 * p.1).sum::<f64>() / 2.0
    }

    #[test]
    fn a_diagonal_halves_a_square() {
        let half = by_half_plane(&SQUARE, (1.0, 1.0), 2.0);
        assert!((area(&half) - 2.0).abs() <= 1e-15, "{half:?}");
        assert!(by_half_plane(&SQUARE, (1.0, 0.0), -0.1).is_empty());
        assert_eq!(by_half_plane(&SQUARE, (1.0, 0.0), 5.0), SQUARE);
    }

    #[test]
    fn a_box_keeps_what_it_shares_with_a_polygon() {
        let part = to_box(&SQUARE, (1.0, 9.0), (-3.0, 0.5));
        assert!((area(&part) - 0.5).abs() <= 1e-15, "{part:?}");
    }

    #[test]
    fn a_polyline_that_leaves_a_box_comes_back_as_another_piece() {
        let zigzag = [(0.5, 0.5), (0.5, 3.5), (1.5, 3.5), (1.5, 0.5), (1.6, 0.5)];
        let pieces = polyline(&zigzag, (0.0, 2.0), (0.0, 2.0));
        let expected = [vec![(0.5, 0.5), (0.5, 2.0)], vec![(1.5, 2.0), (1.5, 0.5), (1.6, 0.5)]];
        assert_eq!(pieces, expected);
    }
}
