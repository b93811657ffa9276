//! Derivatives of a black box from differences of its values.

use super::BlackBox;

/// `H` and its derivatives at some points, laid out as [`Values`](super::Values) are. Derivatives that
/// nobody asked for are empty.
#[derive(Debug, Default)]
pub(super) struct Derivatives {
    pub(super) gram: Vec<f64>,
    pub(super) first: Vec<f64>,
    pub(super) second: Vec<f64>,
}

/// Derivatives of `H` along a vector at some points; the second ones are empty if nobody asked for them.
#[derive(Debug)]
pub(super) struct Along {
    pub(super) first: Vec<f64>,
    pub(super) second: Vec<f64>,
}

/// The offsets, in steps, at which `H` is taken in each direction.
const OFFSETS: [f64; 4] = [-2.0, -1.0, 1.0, 2.0];

/// `f′ ≈ (f(−2h) − 8 f(−h) + 8 f(h) − f(2h)) / 12h`, with an error of `h⁴ f⁽⁵⁾ / 30`.
const SLOPE: [f64; 4] = [1.0 / 12.0, -8.0 / 12.0, 8.0 / 12.0, -1.0 / 12.0];

/// `f″ ≈ (−f(−2h) + 16 f(−h) − 30 f(0) + 16 f(h) − f(2h)) / 12h²`, with an error of `h⁴ f⁽⁶⁾ / 90`.
const BEND: [f64; 4] = [-1.0 / 12.0, 16.0 / 12.0, 16.0 / 12.0, -1.0 / 12.0];
const BEND_HERE: f64 = -30.0 / 12.0;

impl<const D: usize> BlackBox<D> {
    /// Returns `H` and its derivatives up to an order of at most two.
    pub(super) fn derivatives(&self, x: &[f64], order: usize) -> Derivatives {
        let mut at = Derivatives { gram: self.values.gram(x), ..Derivatives::default() };
        if order == 0 {
            return at;
        }
        match self.values.first(x) {
            Some(first) => {
                at.first = first;
                if order == 2 {
                    let second = self.values.second(x);
                    at.second = second.unwrap_or_else(|| self.bends_of_slopes(x, at.first.len()));
                }
            }
            None => self.by_differences(x, order, &mut at),
        }
        at
    }

    /// Returns the derivatives along a vector for each point, up to an order; `None` if they are not given, or
    /// not asked for.
    pub(super) fn along(&self, x: &[f64], v: &[f64], order: usize) -> Option<Along> {
        if order == 0 || !self.values.is_along() {
            return None;
        }
        let wanted = x.len() * self.dimension;
        // What is not there is undefined.
        let whole = |found: Option<Vec<f64>>| {
            found.filter(|all| all.len() == wanted).unwrap_or_else(|| vec![f64::NAN; wanted])
        };
        let first = whole(self.values.first_along(x, v));
        let second = match order {
            2 => match self.values.second_along(x, v) {
                Some(second) => whole(Some(second)),
                None => self.bends_along(x, v),
            },
            _ => Vec::new(),
        };
        Some(Along { first, second })
    }

    /// Returns `∂ₖ∂ₗ(vᵀHv)` from differences of `∂ₖ(H v)`.
    fn bends_along(&self, x: &[f64], v: &[f64]) -> Vec<f64> {
        let d = self.dimension;
        let slopes = |l: usize, offset: f64| -> Vec<f64> {
            let moved = self.moved(x, &[[(l, offset), (l, 0.0)]]);
            let turns = self.values.first_along(&moved, v).unwrap_or_default();
            if turns.len() != x.len() * d {
                return vec![f64::NAN; x.len()];
            }
            let of_point = |(turn, v): (&[f64], &[f64])| -> Vec<f64> {
                let sum = |k: usize| v.iter().zip(turn.chunks(d)).map(|(v, row)| row[k] * v).sum();
                (0..d).map(sum).collect()
            };
            turns.chunks(d * d).zip(v.chunks(d)).flat_map(of_point).collect()
        };
        let mut second = vec![0.0; x.len() * d];
        for l in 0..d {
            for (offset, weight) in OFFSETS.into_iter().zip(SLOPE) {
                for (place, slope) in slopes(l, offset).into_iter().enumerate() {
                    // The two orders of differentiation differ by the error of the differences.
                    let (point, k) = (place / d * d * d, place % d);
                    let share = 0.5 * weight * slope / self.step;
                    second[point + k * d + l] += share;
                    second[point + l * d + k] += share;
                }
            }
        }
        second
    }

    /// Returns the points moved in some directions by some steps, one copy of all points after the
    /// other.
    fn moved(&self, x: &[f64], moves: &[[(usize, f64); 2]]) -> Vec<f64> {
        let mut all = Vec::with_capacity(x.len() * moves.len());
        for moved in moves {
            let from = all.len();
            all.extend_from_slice(x);
            for point in all[from..].chunks_mut(self.dimension) {
                for &(k, steps) in moved {
                    point[k] += steps * self.step;
                }
            }
        }
        all
    }

    /// Sets first and second derivatives from values of `H` alone.
    fn by_differences(&self, x: &[f64], order: usize, at: &mut Derivatives) {
        let d = self.dimension;
        let mut moves: Vec<[(usize, f64); 2]> = Vec::new();
        for k in 0..d {
            moves.extend(OFFSETS.map(|offset| [(k, offset), (k, 0.0)]));
        }
        let pairs: Vec<(usize, usize)> =
            (0..d).flat_map(|k| (k + 1..d).map(move |l| (k, l))).collect();
        const SIGNS: [[f64; 2]; 4] = [[1.0, 1.0], [-1.0, -1.0], [1.0, -1.0], [-1.0, 1.0]];
        if order == 2 {
            for &(k, l) in &pairs {
                moves.extend(SIGNS.map(|[a, b]| [(k, a), (l, b)]));
            }
        }
        let values = self.values.gram(&self.moved(x, &moves));
        let (h, entries) = (self.step, at.gram.len());
        let value = |moved: usize, entry: usize| values[moved * entries + entry];
        let sum = |weights: [f64; 4], from: usize, entry: usize| -> f64 {
            weights.iter().zip(from..).map(|(w, moved)| w * value(moved, entry)).sum()
        };
        at.first = (0..entries * d).map(|n| sum(SLOPE, n % d * 4, n / d) / h).collect();
        if order < 2 {
            return;
        }
        at.second = vec![0.0; entries * d * d];
        for entry in 0..entries {
            for k in 0..d {
                let here = BEND_HERE * at.gram[entry];
                at.second[(entry * d + k) * d + k] = (sum(BEND, 4 * k, entry) + here) / (h * h);
            }
            for (n, &(k, l)) in pairs.iter().enumerate() {
                let turned = sum([0.25, 0.25, -0.25, -0.25], 4 * (d + n), entry) / (h * h);
                at.second[(entry * d + k) * d + l] = turned;
                at.second[(entry * d + l) * d + k] = turned;
            }
        }
    }

    /// Returns second derivatives from differences of the first ones, of which there are `all`. They are
    /// undefined where the first ones are known no more.
    fn bends_of_slopes(&self, x: &[f64], all: usize) -> Vec<f64> {
        let d = self.dimension;
        let moves: Vec<_> =
            (0..d).flat_map(|k| OFFSETS.map(|offset| [(k, offset), (k, 0.0)])).collect();
        let slopes = self.values.first(&self.moved(x, &moves));
        let slopes = slopes.unwrap_or_else(|| vec![f64::NAN; all * moves.len()]);
        let bend = |n: usize, k: usize| -> f64 {
            let slopes = (0..4).map(|i| SLOPE[i] * slopes[(4 * k + i) * all + n]);
            slopes.sum::<f64>() / self.step
        };
        let mut second = vec![0.0; all * d];
        for entry in 0..all / d {
            for (k, l) in (0..d).flat_map(|k| (0..d).map(move |l| (k, l))) {
                // The two orders of differentiation differ by the error of the differences.
                let both = bend(entry * d + k, l) + bend(entry * d + l, k);
                second[(entry * d + k) * d + l] = 0.5 * both;
            }
        }
        second
    }
}
