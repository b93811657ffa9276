//! `Punctures`: the points of the plane around which curves have sides.

use nalgebra::SVector;

use crate::{GraphPathError, Word};

/// The directions among which the rays are chosen: as many as degrees in a half turn.
const DIRECTIONS: usize = 180;

/// The points of the plane around which curves are told apart, such as the middles of obstacles.
///
/// In more than two dimensions they are pillars: all points whose first two coordinates are these.
#[derive(Clone, Debug, PartialEq)]
pub struct Punctures {
    points: Vec<[f64; 2]>,
    /// The direction of the rays, and for each puncture its place across the rays and along them.
    direction: [f64; 2],
    places: Vec<[f64; 2]>,
}

impl Punctures {
    /// Returns punctures at these points, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`GraphPathError::Puncture`] if a coordinate is not finite or a point stands twice.
    pub fn new(points: Vec<[f64; 2]>) -> Result<Self, GraphPathError> {
        for (k, point) in points.iter().enumerate() {
            let is_finite = point.iter().all(|along| along.is_finite());
            if !is_finite || points[..k].contains(point) {
                return Err(GraphPathError::Puncture { number: k + 1, point: *point });
            }
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
        let best = directions.reduce(|a, b| if apart(&b) > apart(&a) { b } else { a });
        let direction = best.unwrap_or([0.0, 1.0]);
        let places = points.iter().map(|x| place(x, &direction)).collect();
        Ok(Self { points, direction, places })
    }

    /// Returns the first `most` of them, or all if there are fewer.
    #[must_use]
    pub fn first(mut self, most: usize) -> Self {
        self.points.truncate(most);
        self.places.truncate(most);
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
            self.letters(&pair[0], &pair[1]).into_iter().for_each(|letter| word.push(letter));
        }
        word
    }

    /// Returns the rays that a chord crosses, in its order.
    pub(crate) fn letters<const D: usize>(
        &self,
        a: &SVector<f64, D>,
        b: &SVector<f64, D>,
    ) -> Vec<i32> {
        if D < 2 {
            return Vec::new();
        }
        let [a, b] = [a, b].map(|x| place(&[x[0], x[1]], &self.direction));
        let mut crossed: Vec<(f64, i32)> = Vec::new();
        for (k, own) in self.places.iter().enumerate() {
            let (from, to) = (a[0] - own[0], b[0] - own[0]);
            // A point on the line of a ray counts to one side, so that no crossing counts twice.
            if (from >= 0.0) == (to >= 0.0) {
                continue;
            }
            // The same bits for the chord from b to a.
            let height = (a[1] * to - b[1] * from) / (to - from);
            if height > own[1] {
                let letter = (k + 1) as i32;
                crossed.push((from / (from - to), if to > from { letter } else { -letter }));
            }
        }
        crossed.sort_by(|x, y| x.0.total_cmp(&y.0));
        crossed.into_iter().map(|(_, letter)| letter).collect()
    }
}

/// Returns the place of a point across a direction, to the right of it, and along it.
fn place(x: &[f64; 2], direction: &[f64; 2]) -> [f64; 2] {
    [x[0] * direction[1] - x[1] * direction[0], x[0] * direction[0] + x[1] * direction[1]]
}

#[cfg(test)]
mod tests {
    use nalgebra::{SVector, vector};

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

    #[test]
    fn no_puncture_stands_twice() {
        let twice = Punctures::new(vec![[0.0, 1.0], [0.0, 1.0]]);
        assert_eq!(twice, Err(GraphPathError::Puncture { number: 2, point: [0.0, 1.0] }));
        assert!(Punctures::new(vec![[f64::NAN, 1.0]]).is_err());
        assert!(Punctures::new(Vec::new()).expect("none").points().is_empty());
    }
}
