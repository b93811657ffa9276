//! Whether a chord leaps from one part of a surface to another.

use nalgebra::SVector;
use tautline::PointSequence;

use crate::descent::constrained::equality::{Contact, Equality};

/// How often a chord is bisected, and the most that a half may have of its length.
///
/// A half of an arc of the angle `θ` has `1/(2 cos(θ/4))` of the length of its chord, which is at
/// most 0.71 up to a half turn. Across a gap as wide as the chord it has all of it.
const BISECTIONS: usize = 5;
const HALF: f64 = 0.75;

/// The largest number of Newton steps to the surface, and the step, relative to the chord, after
/// which a point is on it as exactly as its distances from the ends need.
const NEWTON: usize = 20;
const NEAR: f64 = 1e-3;

/// A chord is judged if it is longer than this number of times the sum of the distances of its ends
/// from the surface, so that its last parts are longer than four of them.
const JUDGED: f64 = 128.0;

/// Returns the first chord whose ends are not joined by points of the surface.
///
/// Every chord is bisected by a point of the surface near its middle, and so are its halves. A leap
/// between parallel parts is found if the gap is longer than a sixteenth of the chord: the last part
/// that is bisected has the extent `1/16` along them, and the gap `g` makes one of its halves too
/// long, `1/32² + g² > 0.75² (1/16² + g²)`, if `g > 0.053`.
pub(crate) fn leaps<const D: usize>(
    constraint: &impl Equality<D>,
    sequence: &PointSequence<D>,
) -> Option<usize> {
    let off = |x: &SVector<f64, D>| {
        let contact = Contact::at(constraint, x);
        (contact.value.abs() + contact.rounding) / contact.slope.norm()
    };
    let is_joined = |a: &SVector<f64, D>, b: &SVector<f64, D>| {
        (b - a).norm() <= JUDGED * (off(a) + off(b)) || is_joined(constraint, a, b, BISECTIONS)
    };
    sequence.points().windows(2).position(|pair| !is_joined(&pair[0], &pair[1]))
}

fn is_joined<const D: usize>(
    constraint: &impl Equality<D>,
    a: &SVector<f64, D>,
    b: &SVector<f64, D>,
    bisections: usize,
) -> bool {
    let length = (b - a).norm();
    if bisections == 0 || length == 0.0 {
        return true;
    }
    let mut middle = (a + b) * 0.5;
    for _ in 0..NEWTON {
        let contact = Contact::at(constraint, &middle);
        // Where the value is 0, the slope may be too.
        let step = if contact.holds(0.0) {
            SVector::zeros()
        } else {
            contact.slope * (contact.value / contact.slope.norm_squared())
        };
        middle -= step;
        if step.norm() <= NEAR * length {
            let halves = (middle - a).norm().max((b - middle).norm());
            return halves <= HALF * length
                && is_joined(constraint, a, &middle, bisections - 1)
                && is_joined(constraint, &middle, b, bisections - 1);
        }
    }
    false
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};
    use tautline::{PointSequence, Scalar};

    use super::{BISECTIONS, is_joined, leaps};
    use crate::descent::constrained::equality::{Equality, tests::Circle};

    #[test]
    fn arcs_up_to_a_half_turn_are_joined() {
        for angle in [1e-9_f64, 1e-3, 1.0, 3.0] {
            let (a, b) = (vector![1.0, 0.0], vector![angle.cos(), angle.sin()]);
            assert!(is_joined(&Circle, &a, &b, BISECTIONS), "{angle}");
        }
        // The middle is the centre, where there is no way to the circle.
        assert!(!is_joined(&Circle, &vector![1.0, 0.0], &vector![-1.0, 0.0], BISECTIONS));
        assert!(is_joined(&Circle, &vector![1.0, 0.0], &vector![1.0, 0.0], BISECTIONS));
    }

    /// The middle of a chord that is shorter than its ends are off the circle is farther from them
    /// than they are from each other.
    #[test]
    fn a_chord_that_is_shorter_than_its_ends_are_off_is_not_judged() {
        let off = |length: f64| {
            let points = vec![vector![1.0 + 1e-9, 0.0], vector![1.0 + 1e-9, length]];
            leaps(&Circle, &PointSequence::new(points).expect("finite"))
        };
        assert_eq!([1e-10, 1e-9, 1e-7, 1e-5, 0.1].map(off), [None; 5]);
        let points = vec![vector![1.0, 0.0], vector![0.0, 1.0], vector![0.0, -1.0]];
        assert_eq!(leaps(&Circle, &PointSequence::new(points).expect("finite")), Some(1));
    }

    /// The lines `x₂ = 0` and `x₂ = 1/10 + x₁/100`.
    struct Lines;

    impl Equality<2> for Lines {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            x[1] * (x[1] - 0.1 - x[0] * 0.01)
        }
    }

    /// The lines `x₂ = 0` and `x₂ = 0.07`, with values that lead Newton's method to the nearer one.
    struct Parallel;

    impl Equality<2> for Parallel {
        fn value<S: Scalar>(&self, x: &SVector<S, 2>) -> S {
            x[1] * (x[1] - 0.07) * (x[1] * (2.0 / 0.07)).exp()
        }
    }

    #[test]
    fn a_gap_of_more_than_a_sixteenth_is_found() {
        let (a, b) = (vector![0.0, 0.0], vector![1.0, 0.07]);
        assert!(!is_joined(&Parallel, &a, &b, BISECTIONS));
        assert!(!is_joined(&Parallel, &b, &a, BISECTIONS));
        assert!(is_joined(&Parallel, &a, &b, BISECTIONS - 1));
        assert!(is_joined(&Parallel, &a, &vector![1.0, 0.0], BISECTIONS));
    }

    /// The gap is a tenth of the chord, and only one quarter or less of the chord is across it.
    #[test]
    fn a_short_gap_in_either_half_is_found() {
        let (a, b) = (vector![0.0, 0.0], vector![1.0, 0.11]);
        assert!(!is_joined(&Lines, &a, &b, BISECTIONS));
        assert!(!is_joined(&Lines, &b, &a, BISECTIONS));
        // One bisection does not see it.
        assert!(is_joined(&Lines, &a, &b, 1));
        assert!(is_joined(&Lines, &a, &vector![1.0, 0.0], BISECTIONS));
        assert!(is_joined(&Lines, &vector![0.0, 0.1], &b, BISECTIONS));
    }
}
