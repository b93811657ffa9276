//! `Patch`: a box of the search, whose sides may be half-lines.

use tautline_scalar::Interval;

/// A box in the coordinates of the search. These are the coordinates of space, or the variables of
/// a lifted formula, in one of several charts.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Patch {
    /// The sides; an end may be infinite.
    pub(crate) sides: Vec<Interval>,
    /// The number of the chart.
    pub(crate) chart: usize,
}

/// A point in the coordinates of the search.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Point {
    /// The coordinates, all of them finite.
    pub(crate) at: Vec<f64>,
    /// The number of the chart.
    pub(crate) chart: usize,
}

/// A set over which a function is maximised.
pub(crate) trait Region: Sync {
    /// Returns patches that cover the set.
    fn patches(&self) -> Vec<Patch>;

    /// Returns whether the patch certainly does not meet the set.
    fn misses(&self, patch: &Patch) -> bool;

    /// Returns a point of the patch that certainly lies in the set, and the midpoint if that does.
    fn point_in(&self, patch: &Patch) -> Option<Point>;
}

impl Patch {
    /// Returns the midpoint, up to rounding. On a half-line it is some point.
    pub(crate) fn middle(&self) -> Point {
        let middle = |side: &Interval| {
            if side.is_finite() {
                side.midpoint()
            } else {
                cut(*side).map_or(0.0, |cut| cut.clamp(side.lo(), side.hi()))
            }
        };
        Point { at: self.sides.iter().map(middle).collect(), chart: self.chart }
    }

    /// Returns the length of a side, for the choice of a cut. That of a half-line is the distance at
    /// which it is cut next.
    pub(crate) fn length(&self, side: usize) -> f64 {
        let side = self.sides[side];
        if side.is_finite() { side.width() } else { FACTOR * side.mignitude().max(UNIT) }
    }

    /// Returns the longest side. A side with an infinite end is measured by its share of the line.
    pub(crate) fn longest(&self) -> usize {
        let share = |x: f64| if x.is_infinite() { x.signum() } else { x / (1.0 + x.abs()) };
        let finite = self.sides.iter().all(|side| side.is_finite());
        let length = |k: usize| {
            let side = self.sides[k];
            if finite { side.width() } else { share(side.hi()) - share(side.lo()) }
        };
        (0..self.sides.len()).fold(0, |most, k| if length(k) > length(most) { k } else { most })
    }

    /// Cuts the box across a side. Returns `None` if there is no double strictly between the ends
    /// of that side.
    pub(crate) fn halves(&self, side: usize) -> Option<[Self; 2]> {
        let (lo, hi) = (self.sides[side].lo(), self.sides[side].hi());
        let cut = cut(self.sides[side])?;
        Some([(lo, cut), (cut, hi)].map(|(lo, hi)| {
            let mut half = self.clone();
            half.sides[side] = Interval::new(lo, hi).expect("ends in order");
            half
        }))
    }
}

/// A longer side is cut at the geometric mean of its ends, in `ℓ`.
///
/// If the length scale of a metric differs much from this unit, a few more cuts are needed.
const UNIT: f64 = 1.0;

/// A half-line is cut at this multiple of its end.
const FACTOR: f64 = 4.0;

/// Returns where a side is cut, if a double lies strictly between its ends.
fn cut(side: Interval) -> Option<f64> {
    let (lo, hi) = (side.lo(), side.hi());
    let sign = if hi > 0.0 { 1.0 } else { -1.0 };
    let cut = if lo < 0.0 && hi > 0.0 && side.width() > 4.0 * UNIT {
        0.0
    } else if !side.is_finite() {
        sign * FACTOR * side.mignitude().max(UNIT)
    } else if side.mignitude().max(UNIT) < 0.25 * side.magnitude() {
        sign * side.mignitude().max(UNIT).sqrt() * side.magnitude().sqrt()
    } else {
        side.midpoint()
    };
    (lo < cut && cut < hi).then_some(cut)
}

#[cfg(test)]
mod tests {
    use tautline_scalar::Interval;

    use super::Patch;

    fn patch<const N: usize>(sides: [(f64, f64); N]) -> Patch {
        let side = |(lo, hi)| Interval::new(lo, hi).expect("in order");
        Patch { sides: sides.map(side).into(), chart: 0 }
    }

    #[test]
    fn halves_cover_the_patch_and_shrink() {
        let (far, infinity) = (2.0_f64.powi(100), f64::INFINITY);
        for (lo, hi) in [
            (0.0, 1.0),
            (-far, far),
            (0.0, far),
            (-far, -1e-3),
            (-1e-9, 5.0),
            (3.0, far),
            (-infinity, infinity),
            (-3.0, infinity),
            (-infinity, -0.5),
        ] {
            let mut patches = vec![patch([(lo, hi)])];
            for _ in 0..12 {
                patches = patches
                    .iter()
                    .flat_map(|patch| {
                        let [a, b] = patch.halves(0).expect("wide");
                        assert_eq!(a.sides[0].hi(), b.sides[0].lo());
                        let (x, y) = (patch.sides[0], a.sides[0].hull(b.sides[0]));
                        assert_eq!((x.lo(), x.hi()), (y.lo(), y.hi()));
                        [a, b]
                    })
                    .collect();
            }
            // A geometric cut halves the exponent: after 12 cuts every side either has width at
            // most 4, or its two ends have a ratio of at most 4. What remains of a half-line begins
            // far out.
            for patch in patches {
                let side = patch.sides[0];
                let narrow = side.width() <= 4.0 || side.magnitude() <= 4.0 * side.mignitude();
                let beyond = !side.is_finite() && side.mignitude() >= 4.0_f64.powi(10);
                assert!(narrow || beyond, "{side:?} of [{lo}, {hi}]");
            }
        }
    }

    #[test]
    fn a_side_without_a_double_inside_has_no_halves() {
        let patch = patch([(1.0, 1.0_f64.next_up()), (0.0, 0.0)]);
        assert_eq!(patch.halves(0), None);
        assert_eq!(patch.halves(1), None);
    }

    /// A half-line that begins far out is short.
    #[test]
    fn the_longest_side_is_cut_first() {
        let infinity = f64::INFINITY;
        assert_eq!(patch([(0.0, 1.0), (0.0, 3.0)]).longest(), 1);
        assert_eq!(patch([(1.0, 2.0), (0.0, infinity)]).longest(), 1);
        assert_eq!(patch([(1.0, 2.0), (64.0, infinity)]).longest(), 0);
        let middle = patch([(-infinity, -2.0), (0.0, 3.0)]).middle();
        assert!(middle.at[0].is_finite() && middle.at[0] < -2.0 && middle.at[1] == 1.5);
    }
}
