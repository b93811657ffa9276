//! A box with sides parallel to the axes.

/// A rectangle with sides parallel to the axes, in px, with `y` downwards.
#[derive(Clone, Copy, Debug, PartialEq)]
#[must_use]
pub struct Extent {
    /// The smallest `x`.
    pub left: f64,
    /// The smallest `y`.
    pub top: f64,
    /// The largest `x`.
    pub right: f64,
    /// The largest `y`.
    pub bottom: f64,
}

impl Extent {
    /// Returns the width, in px.
    #[must_use]
    pub fn width(&self) -> f64 {
        self.right - self.left
    }

    /// Returns the height, in px.
    #[must_use]
    pub fn height(&self) -> f64 {
        self.bottom - self.top
    }

    /// Returns whether two boxes have an interior point in common.
    #[must_use]
    pub fn overlaps(&self, other: &Extent) -> bool {
        let across = self.left < other.right && other.left < self.right;
        across && self.top < other.bottom && other.top < self.bottom
    }

    /// Returns whether the segment between two points enters the box (Liang and Barsky).
    #[must_use]
    pub fn meets(&self, from: (f64, f64), to: (f64, f64)) -> bool {
        let (dx, dy) = (to.0 - from.0, to.1 - from.1);
        // The part of the segment, between 0 and 1, that lies inside all four half-planes.
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        for (speed, room) in [
            (-dx, from.0 - self.left),
            (dx, self.right - from.0),
            (-dy, from.1 - self.top),
            (dy, self.bottom - from.1),
        ] {
            if speed == 0.0 && room < 0.0 {
                return false;
            } else if speed < 0.0 {
                enters = enters.max(room / speed);
            } else if speed > 0.0 {
                leaves = leaves.min(room / speed);
            }
        }
        enters < leaves
    }

    /// Returns whether the other box lies inside this one.
    #[must_use]
    pub fn contains(&self, other: &Extent) -> bool {
        let across = self.left <= other.left && other.right <= self.right;
        across && self.top <= other.top && other.bottom <= self.bottom
    }

    /// Returns the box shrunk by `dx` on the left and right, and by `dy` at the top and bottom.
    pub fn inset(&self, dx: f64, dy: f64) -> Extent {
        Extent {
            left: self.left + dx,
            top: self.top + dy,
            right: self.right - dx,
            bottom: self.bottom - dy,
        }
    }

    /// Returns the smallest box that contains this box and a point.
    pub fn with(self, x: f64, y: f64) -> Extent {
        Extent {
            left: self.left.min(x),
            top: self.top.min(y),
            right: self.right.max(x),
            bottom: self.bottom.max(y),
        }
    }

    /// Returns the smallest box that contains both.
    pub fn union(self, other: Extent) -> Extent {
        self.with(other.left, other.top).with(other.right, other.bottom)
    }
}

#[cfg(test)]
mod tests {
    use super::Extent;

    #[test]
    fn segments_meet_the_box_they_enter() {
        let unit = Extent { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 };
        assert!(unit.meets((-1.0, 0.5), (2.0, 0.5)) && unit.meets((0.2, 0.2), (0.3, 0.3)));
        assert!(!unit.meets((-1.0, 0.5), (-0.1, 0.5)) && !unit.meets((-1.0, 2.0), (2.0, 1.5)));
        // The segment crosses the quadrant at the corner, but not the box.
        assert!(!unit.meets((0.5, 2.0), (2.0, 0.5)));
    }

    #[test]
    fn touching_boxes_do_not_overlap() {
        let unit = Extent { left: 0.0, top: 0.0, right: 1.0, bottom: 1.0 };
        let beside = Extent { left: 1.0, right: 2.0, ..unit };
        assert!(!unit.overlaps(&beside));
        assert!(unit.overlaps(&Extent { left: 0.9, right: 2.0, ..unit }));
        assert!(unit.contains(&unit.inset(0.1, 0.1)) && !unit.contains(&beside));
    }
}
