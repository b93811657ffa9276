//! Whether a chord leaps from one part of a surface to another.

use nalgebra::SVector;
use tautline::PointSequence;

use crate::descent::constrained::equality::{Contact, Equality};

/// How often a chord is bisected, and the most that a half may have of its length.
///
/// A half of an arc of the angle `θ` has `1/(2 cos(θ/4))` of the length of its chord, which is at
/// most 0.71 up to a half turn. Across a gap as wide as the chord it has all of it.
const BISECTIONS: usize = 4;
const HALF: f64 = 0.75;

/// The largest number of Newton steps to the surface.
const NEWTON: usize = 20;

/// Returns the first chord whose ends are not joined by points of the surface.
///
/// Every chord is bisected by a point of the surface near its middle, and so are its halves. A leap
/// across a gap that is longer than a sixteenth of a chord is found: no point near the middle
/// makes both parts shorter.
pub(crate) fn leaps<const D: usize>(
    constraint: &impl Equality<D>,
    sequence: &PointSequence<D>,
    feasibility: f64,
) -> Option<usize> {
    let points = sequence.points();
    let joined = |pair: &[SVector<f64, D>]| {
        is_joined(constraint, &pair[0], &pair[1], feasibility, BISECTIONS)
    };
    points.windows(2).position(|pair| !joined(pair))
}

fn is_joined<const D: usize>(
    constraint: &impl Equality<D>,
    a: &SVector<f64, D>,
    b: &SVector<f64, D>,
    feasibility: f64,
    bisections: usize,
) -> bool {
    let length = (b - a).norm();
    if bisections == 0 || length == 0.0 {
        return true;
    }
    let mut middle = (a + b) * 0.5;
    for _ in 0..NEWTON {
        let contact = Contact::at(constraint, &middle);
        if contact.holds(feasibility) {
            let halves = (middle - a).norm().max((b - middle).norm());
            // A NaN joins nothing.
            return halves <= HALF * length
                && is_joined(constraint, a, &middle, feasibility, bisections - 1)
                && is_joined(constraint, &middle, b, feasibility, bisections - 1);
        }
        middle -= contact.slope * (contact.value / contact.slope.norm_squared());
    }
    false
}
