//! `Punctures`: the points of the plane around which curves have sides.

use std::cmp::Ordering;

use nalgebra::SVector;
use tautline_sets::Ends;

use crate::{GraphPathError, Word};

/// The directions among which the rays are chosen: as many as degrees in a half turn.
const DIRECTIONS: usize = 180;

/// Points of the plane, such as the middles of obstacles. A curve passes each of them on one side, and its
/// class says on which.
///
/// In more than two dimensions they are pillars: all points whose first two coordinates are these.
#[derive(Clone, Debug, PartialEq)]
pub struct Punctures {
    points: Vec<[f64; 2]>,
    /// The direction of the rays, and for each puncture its place across the rays and along them.
    direction: [f64; 2],
    places: Vec<[f64; 2]>,
    /// The punctures in the order of their places across the rays.
    order: Vec<usize>,
}

impl Punctures {
    /// Returns punctures at these points, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Puncture`] if a coordinate is not finite or a point stands twice.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, GraphPathError> {
        let mut sorted: Vec<usize> = (0..points.len()).collect();
        sorted.sort_by(|&j, &k| points[j].partial_cmp(&points[k]).unwrap_or(Ordering::Equal));
        let second = sorted.windows(2).filter(|pair| points[pair[0]] == points[pair[1]]);
        let is_wrong = |k: &usize| points[*k].iter().any(|along| !along.is_finite());
        let wrong = (0..points.len()).find(is_wrong);
        if let Some(k) = wrong.or_else(|| second.map(|pair| pair[1]).min()) {
            return Err(GraphPathError::Puncture { number: k + 1, point: points[k] });
        }
        // The rays are parallel. They must not run through other punctures: the best direction is the
        // one across which the punctures are farthest apart.
        let apart = |direction: &[f64; 2]| {
            let mut across: Vec<f64> = points.iter().map(|x| place(x, direction)[0]).collect();
            across.sort_by(f64::total_cmp);
            across.windows(2).map(|pair| pair[1] - pair[0]).fold(f64::INFINITY, f64::min)
        };
        let directions = (0..DIRECTIONS).map(|k| {
            let (sin, cos) = (std::f64::consts::PI * k as f64 / DIRECTIONS as f64).sin_cos();
            // The first ray goes up.
            [-sin, cos]
        });
        let rated = directions.map(|direction| (apart(&direction), direction));
        let best = rated.reduce(|a, b| if b.0 > a.0 { b } else { a });
        let direction = best.map_or([0.0, 1.0], |best| best.1);
        let places: Vec<_> = points.iter().map(|x| place(x, &direction)).collect();
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by(|&j, &k| places[j][0].total_cmp(&places[k][0]));
        Ok(Self { points, direction, places, order })
    }

    /// Returns the first `most` of them, or all if there are fewer.
    #[must_use]
    pub fn first(mut self, most: usize) -> Self {
        self.points.truncate(most);
        self.places.truncate(most);
        self.order.retain(|&k| k < most);
        self
    }

    /// Returns the points, in `ℓ`.
    #[must_use]
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }

    /// Returns the word of a polygon, given by its corners in `ℓ`. On a line there are no sides, and every
    /// word is empty.
    #[must_use]
    pub fn word<const D: usize>(&self, corners: &[SVector<f64, D>]) -> Word {
        let mut word = Word::default();
        for pair in corners.windows(2) {
            self.letters(&pair[0], &pair[1]).for_each(|letter| word.push(letter));
        }
        word
    }

    /// Returns a member of each set, to which curves between the sets are prolonged: those nearest to the
    /// mean of the punctures.
    pub(crate) fn anchors<const D: usize>(&self, ends: &Ends<D>) -> [SVector<f64, D>; 2] {
        let count = self.points.len().max(1) as f64;
        let mean = SVector::from_fn(|i, _| {
            let along = |point: &[f64; 2]| point.get(i).copied().unwrap_or(0.0) / count;
            self.points.iter().map(along).sum()
        });
        [ends.first(), ends.second()].map(|set| set.project(&mean))
    }

    /// Returns the word of a polygon between two sets, given by its corners in `ℓ`. It is prolonged by
    /// chords to a member of each set, the one nearest to the mean of the punctures.
    #[must_use]
    pub fn word_between<const D: usize>(
        &self,
        ends: &Ends<D>,
        corners: &[SVector<f64, D>],
    ) -> Word {
        let [first, second] = self.anchors(ends);
        self.word(&[&[first], corners, &[second]].concat())
    }

    /// Returns the rays that a chord crosses, in its order.
    pub(crate) fn letters<const D: usize>(
        &self,
        a: &SVector<f64, D>,
        b: &SVector<f64, D>,
    ) -> impl Iterator<Item = i32> {
        let [a, b] = [a, b].map(|x| self.place(x));
        let beside = |x: f64| self.order.partition_point(|&k| self.places[k][0] <= x);
        // The lines of the rays are parallel: a chord crosses them in the order of their places.
        let between = beside(a[0].min(b[0]))..beside(a[0].max(b[0]));
        let crossed = self.order.get(between).unwrap_or_default();
        let is_back = b[0] < a[0];
        (0..crossed.len()).filter_map(move |i| {
            let k = crossed[if is_back { crossed.len() - 1 - i } else { i }];
            let crossing = crossing(&self.places[k], &a, &b);
            (crossing != 0).then_some((k + 1) as i32 * crossing)
        })
    }

    /// Returns whether a curve turns by less than a whole turn around each puncture, given its ends and the
    /// letters of its word.
    ///
    /// The angle of the curve seen from a puncture differs by whole turns from that `δ` of its chord,
    /// `|δ| ≤ π`, so that it is `δ`, or the other way round `δ ∓ 2π`. Each crossing of the ray to the right
    /// in excess of those of the chord is a turn of `−2π`.
    pub(crate) fn is_less_than_a_turn<const D: usize>(
        &self,
        word: &Word,
        a: &SVector<f64, D>,
        b: &SVector<f64, D>,
    ) -> bool {
        let [a, b] = [a, b].map(|x| self.place(x));
        let mut letters = word.letters().to_vec();
        letters.sort_unstable_by_key(|letter| letter.abs());
        letters.chunk_by(|x, y| x.abs() == y.abs()).all(|equal| {
            let turns: i32 = equal.iter().map(|letter| letter.signum()).sum();
            let own = &self.places[equal[0].unsigned_abs() as usize - 1];
            let straight = crossing(own, &a, &b);
            let [from, to] = [a, b].map(|x| [x[0] - own[0], x[1] - own[1]]);
            let other = if straight != 0 {
                0
            } else if (from[0] >= 0.0) != (to[0] >= 0.0) {
                if to[0] > from[0] { 1 } else { -1 }
            } else {
                // With both ends on its line, and the puncture between them, the chord passes on the
                // right, as the ends count to it.
                let is_between = from[0] == 0.0 && to[0] == 0.0 && from[1] * to[1] < 0.0;
                let sine = from[0] * to[1] - from[1] * to[0];
                let sine = if is_between { to[1] - from[1] } else { sine };
                i32::from(sine > 0.0) - i32::from(sine < 0.0)
            };
            turns == straight || turns == other
        })
    }

    /// Returns the place of a point across the rays and along them; on a line all are at the same place.
    fn place<const D: usize>(&self, x: &SVector<f64, D>) -> [f64; 2] {
        if D < 2 { [0.0; 2] } else { place(&[x[0], x[1]], &self.direction) }
    }
}

/// Returns 1 if a chord crosses a ray to the right, −1 if to the left, and 0 if it does not cross it, all
/// given by their places.
fn crossing(own: &[f64; 2], a: &[f64; 2], b: &[f64; 2]) -> i32 {
    let (from, to) = (a[0] - own[0], b[0] - own[0]);
    // A point on the line of a ray counts to one side, so that no crossing counts twice.
    if (from >= 0.0) == (to >= 0.0) {
        return 0;
    }
    // The same bits for the chord from b to a.
    let height = (a[1] * to - b[1] * from) / (to - from);
    match height > own[1] {
        true if to > from => 1,
        true => -1,
        false => 0,
    }
}

/// Returns the place of a point across a direction, to the right of it, and along it.
fn place(x: &[f64; 2], direction: &[f64; 2]) -> [f64; 2] {
    [x[0] * direction[1] - x[1] * direction[0], x[0] * direction[0] + x[1] * direction[1]]
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use nalgebra::{SVector, vector};
    use tautline_chance::{Random, seed};

    use super::Punctures;
    use crate::GraphPathError;

    type Corners = [SVector<f64, 2>];

    /// Below and above two punctures there are four classes; a loop around one is another class, and a
    /// detour around none is not.
    #[test]
    fn words_tell_sides_apart() {
        let punctures = Punctures::new(vec![[0.0, 0.0], [1.0, 0.3]]).expect("two points");
        let word = |corners: &Corners| punctures.word(corners);
        let (a, b) = (vector![-2.0, 0.0], vector![3.0, 0.0]);
        let [up, down] = [1.5, -1.5].map(|y| [vector![0.0, y], vector![1.0, y]]);
        let ways = [[up[0], up[1]], [up[0], down[1]], [down[0], up[1]], [down[0], down[1]]];
        let words = ways.map(|[first, second]| word(&[a, first, second, b]));
        for (k, own) in words.iter().enumerate() {
            assert!(!words[..k].contains(own), "{own} twice");
        }
        let detour = [a, vector![-1.0, 4.0], vector![-1.5, -3.0], up[0], up[1], b];
        assert_eq!(word(&detour), words[0]);
        let around = [a, up[0], vector![0.5, 0.0], down[0], vector![-1.0, 0.0], up[0], up[1], b];
        assert!(!words.contains(&word(&around)));
    }

    /// The way back has the inverse letters in the inverse order, bit for bit.
    #[test]
    fn the_way_back_is_the_inverse() {
        let punctures = Punctures::new(vec![[0.1, 0.2], [0.4, -0.3], [0.7, 0.6]]);
        let punctures = punctures.expect("three points");
        let there = [vector![-1.0, 0.3], vector![0.3, 0.9], vector![0.5, -0.9], vector![1.5, 0.4]];
        let mut back = there;
        back.reverse();
        let inverse: Vec<i32> =
            punctures.word(&back).letters().iter().rev().map(|letter| -letter).collect();
        assert_eq!(punctures.word(&there).letters(), inverse);
        assert!(!inverse.is_empty());
    }

    /// Punctures above each other: no ray runs through another puncture.
    #[test]
    fn a_column_of_punctures_has_rays_beside_each_other() {
        let column: Vec<[f64; 2]> = (0..6).map(|k| [0.0, f64::from(k)]).collect();
        let punctures = Punctures::new(column).expect("six points");
        let [a, b] = [vector![-9.0, -0.5], vector![9.0, -0.5]];
        let through = |y: f64| punctures.word(&[a, vector![-1.0, y], vector![1.0, y], b]);
        let words: Vec<_> = (0..7).map(|k| through(f64::from(k) - 0.5)).collect();
        let mut different = words.clone();
        different.sort();
        different.dedup();
        assert_eq!(different.len(), 7, "{words:?}");
    }

    /// The angle of a polygon is the sum of those of its chords, each less than half a turn.
    #[test]
    fn whole_turns_are_told_from_the_word() {
        let mut random = Random(seed(3));
        let mut point = || [random.between(-1.0, 1.0), random.between(-1.0, 1.0)];
        let mut counts = [0; 2];
        for _ in 0..2000 {
            let punctures = Punctures::new(vec![point(), point(), point()]).expect("points");
            let corners: Vec<SVector<f64, 2>> = (0..9).map(|_| point().into()).collect();
            let angle = |own: &[f64; 2]| {
                let of_chord = |pair: &Corners| {
                    let [a, b] = [pair[0], pair[1]].map(|x| x - SVector::from(*own));
                    a.perp(&b).atan2(a.dot(&b))
                };
                corners.windows(2).map(of_chord).sum::<f64>()
            };
            let is_less = punctures.points().iter().all(|own| angle(own).abs() < TAU);
            let (word, ends) = (punctures.word(&corners), [&corners[0], &corners[8]]);
            assert_eq!(punctures.is_less_than_a_turn(&word, ends[0], ends[1]), is_less);
            counts[usize::from(is_less)] += 1;
        }
        // More than one case in ten of either kind.
        assert!(counts.iter().all(|&count| count > 200), "{counts:?}");
    }

    #[test]
    fn no_puncture_stands_twice() {
        let twice = Punctures::new(vec![[0.0, 1.0], [0.0, 1.0]]);
        assert_eq!(twice, Err(GraphPathError::Puncture { number: 2, point: [0.0, 1.0] }));
        assert!(Punctures::new(vec![[f64::NAN, 1.0]]).is_err());
        assert!(Punctures::new(Vec::new()).expect("none").points().is_empty());
    }
}
