//! `Cell`: a random box and points in it.

use tautline_scalar::{Enclosure, Kernel, Scalar};

use super::Precise;
use crate::reference::Random;

/// A box, given by the ends of its sides.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cell<const D: usize> {
    sides: [(f64, f64); D],
}

impl<const D: usize> Cell<D> {
    /// Returns a box of any size from a point to a few units, with its centre in
    /// `[−reach, reach]^D`. One box in eight has its centre, and its size, at any scale. One in
    /// eight has a side that is a point or begins at zero.
    pub(crate) fn random(reach: f64, random: &mut Random) -> Self {
        let far = random.bits().is_multiple_of(8);
        let size = match random.bits() % 6 {
            0 | 1 => 0.0,
            2 => 1e-15,
            3 => 1e-6,
            4 => 0.03,
            _ => 1.0,
        };
        let special = random.bits().is_multiple_of(8).then(|| random.bits() as usize % D);
        let sides = std::array::from_fn(|i| {
            let centre = if far {
                random.sign() * random.with_exponent(-60, 24)
            } else {
                random.between(-reach, reach)
            };
            // Small sizes are relative to the centre, large sizes to the region.
            let unit = if far || size < 1e-9 { centre.abs() } else { reach };
            let (less, more) = (random.unit() * size * unit, random.unit() * size * unit);
            let (lo, hi) = (centre - less, centre + more);
            match (special == Some(i), random.bits() & 1) {
                (true, 0) => (centre, centre),
                (true, _) => (0.0, hi - lo),
                _ => (lo, hi),
            }
        });
        Self { sides }
    }

    /// Returns whether the box is a point.
    pub(crate) fn is_point(&self) -> bool {
        self.sides.iter().all(|(lo, hi)| lo == hi)
    }

    /// Returns whether the box lies in `[−reach, reach]^D`.
    pub(crate) fn is_within(&self, reach: f64) -> bool {
        self.sides.iter().all(|&(lo, hi)| -reach <= lo && hi <= reach)
    }

    pub(crate) fn intervals<K: Kernel>(&self) -> [Enclosure<K>; D] {
        self.sides.map(|(lo, hi)| Enclosure::new(lo, hi).expect("ordered ends"))
    }

    /// Returns a point of the box: a corner, a point whose coordinates are doubles, or any point.
    pub(crate) fn point(&self, random: &mut Random) -> [Precise; D] {
        let kind = random.bits() % 3;
        self.sides.map(|(lo, hi)| match kind {
            0 => Precise::constant(if random.bits() & 1 == 0 { lo } else { hi }),
            1 => Precise::constant(random.between(lo, hi).clamp(lo, hi)),
            _ => Precise::between(lo, hi, random.unit()),
        })
    }
}
