//! `Chord`: rigorous bounds on the energy and the length of a line segment.

use tautline_formula::Formula;
use tautline_scalar::{ANY, Enclosure, Kernel, Scalar};

use super::{pairwise_sum::PairwiseSum, taylor::Taylor};

/// A panel with at most this relative width is not bisected.
///
/// The relative width of the total does not exceed the largest relative width of a panel, so that
/// truncation contributes at most this much. The rounding of `N = 1000` chords adds up to `10⁻¹⁴`.
const TOLERANCE: f64 = 1e-12;

/// The largest number of bisections: at `2⁻⁴⁰` of the chord, rounding begins to matter.
const DEPTH: u32 = 40;

/// The largest number of panels of a chord: enough for twelve bisections everywhere, or for forty
/// near a few points.
const PANELS: usize = 8192;

/// The segment from `start` to `start + step`, or all segments whose data lie in these boxes.
#[derive(Clone, Debug)]
pub(super) struct Chord<K> {
    start: Vec<Enclosure<K>>,
    step: Vec<Enclosure<K>>,
    /// The box between the ends, which rounding does not lead out of.
    hull: Vec<Enclosure<K>>,
}

/// Enclosures of `∫₀¹ f ds` and `∫₀¹ √f ds`, where `f(s) = dᵀ H(x + s d) d`, in `m²` and `m`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Integrals<K> {
    pub(super) square: Enclosure<K>,
    pub(super) root: Enclosure<K>,
}

/// The part of a chord with `|s − centre| ≤ width/2`. Both numbers are dyadic fractions, hence
/// exact.
#[derive(Clone, Copy, Debug)]
struct Panel {
    centre: f64,
    width: f64,
}

impl<K: Kernel> Chord<K> {
    /// Returns the segment between two points of the same dimension.
    pub(super) fn between(x: &[Enclosure<K>], y: &[Enclosure<K>]) -> Chord<K> {
        let both = || x.iter().zip(y);
        // Intervals, since the difference of two doubles is rounded.
        let step = both().map(|(&x, &y)| y - x).collect();
        let hull = both().map(|(&x, &y)| x.hull(y)).collect();
        Chord { start: x.to_vec(), step, hull }
    }

    /// Returns the first point, in `ℓ`.
    pub(super) fn start(&self) -> &[Enclosure<K>] {
        &self.start
    }

    /// Returns the difference of the last and the first point, in `ℓ`.
    pub(super) fn step(&self) -> &[Enclosure<K>] {
        &self.step
    }

    /// Returns the enclosures; they are undefined if the metric is undefined somewhere on the
    /// chord.
    pub(super) fn integrals(&self, formula: &Formula<ANY>) -> Integrals<K> {
        bisected(|panel| self.over(formula, panel))
    }

    /// Returns `dᵀ H(x + s d) d` as a function of `u`, where `s = centre + width u`.
    fn square<const M: usize>(
        &self,
        formula: &Formula<ANY>,
        centre: Enclosure<K>,
        width: f64,
    ) -> Taylor<Enclosure<K>, M> {
        let d = &self.step;
        let x = self.at(centre);
        let at: Vec<_> = x.iter().zip(d).map(|(&x, &d)| Taylor::line(x, d * width)).collect();
        let (h, n) = (formula.gram_at(&at), d.len());
        Taylor::combination((0..n).flat_map(|i| (i..n).map(move |j| (i, j))).map(|(i, j)| {
            let product = if i == j { d[i].sqr() } else { d[i] * d[j] * 2.0 };
            (h[j * n + i], product)
        }))
    }

    /// Returns the points `x + s d`, which do not lie beyond the ends: a table may be smooth up to there
    /// only.
    fn at(&self, s: Enclosure<K>) -> Vec<Enclosure<K>> {
        let coordinate = |i: usize| {
            let x = self.start[i] + self.step[i] * s;
            x.intersection(self.hull[i]).unwrap_or(self.hull[i])
        };
        (0..self.hull.len()).map(coordinate).collect()
    }

    /// Returns whether `H` is proved to be defined and positive definite on all of the chord: the part
    /// that is not is bisected, as often as for the integrals.
    pub(super) fn is_definite(&self, formula: &Formula<ANY>) -> bool {
        let mut left = vec![Panel { centre: 0.5, width: 1.0 }];
        let least = 0.5_f64.powi(DEPTH as i32);
        for _ in 0..PANELS {
            let Some(panel) = left.pop() else { return true };
            let place = self.at(panel.range());
            if is_positive_definite(&mut formula.gram_at(&place), place.len()) {
                continue;
            }
            if panel.width <= least {
                return false;
            }
            left.extend(panel.halves());
        }
        left.is_empty()
    }

    /// Returns the value `dᵀ H(x + s d) d`. At `s = 0` nothing is added to `x`.
    pub(super) fn square_at(&self, formula: &Formula<ANY>, fraction: f64) -> Enclosure<K> {
        let value: Taylor<_, 1> = self.square(formula, Enclosure::point(fraction), 0.0);
        nonnegative(value.coefficient(0))
    }

    /// Returns the integrals over a panel, and whether there is no point in bisecting it.
    ///
    /// With `g(u) = f(centre + width u)`, Taylor's formula at the midpoint gives
    ///
    /// ```text
    /// ∫ f ds = width ∫ g du = width (g₀(0) + g₂(0)/12 + g₄(ξ)/80),   |u| ≤ ½, |ξ| ≤ ½
    /// ```
    ///
    /// with the coefficients `gₖ = g⁽ᵏ⁾/k!`. The odd terms cancel, and `∫ u² = 1/12`,
    /// `∫ u⁴ = 1/80`.
    fn over(&self, formula: &Formula<ANY>, panel: Panel) -> (Integrals<K>, bool) {
        let Panel { centre, width } = panel;
        let middle: Taylor<_, 3> = self.square(formula, Enclosure::point(centre), width);
        // The metric is undefined at one point, up to rounding, so bisecting would not help.
        let value = nonnegative(middle.coefficient(0));
        if value.is_undefined() {
            return (Integrals::undefined(), true);
        }
        let all: Taylor<_, 5> = self.square(formula, panel.range(), width);
        let squares = nonnegative(all.coefficient(0));
        let square = bound(squares, &middle, &all);
        let root = bound(squares.sqrt(), &middle.sqrt(), &all.sqrt());
        let done = narrow(square, value.width()) && narrow(root, value.sqrt().width());
        (Integrals { square: square * width, root: root * width }, done)
    }
}

impl Panel {
    /// Returns its parameters.
    fn range<K: Kernel>(self) -> Enclosure<K> {
        let half = 0.5 * self.width;
        Enclosure::point(self.centre - half).hull(Enclosure::point(self.centre + half))
    }

    fn halves(self) -> [Panel; 2] {
        let width = 0.5 * self.width;
        [-0.5, 0.5].map(|side| Panel { centre: self.centre + side * width, width })
    }
}

/// Returns the integrals over a chord, given those over its panels and whether there is no point in
/// bisecting one.
///
/// Each round bisects every panel whose enclosure is too wide. If a limit ends the rounds, the
/// panels that are still too wide therefore all have the same length.
fn bisected<K: Kernel>(mut over: impl FnMut(Panel) -> (Integrals<K>, bool)) -> Integrals<K> {
    let whole = Panel { centre: 0.5, width: 1.0 };
    let (integrals, done) = over(whole);
    if done {
        return integrals;
    }
    let (mut squares, mut roots) = (PairwiseSum::new(), PairwiseSum::new());
    let mut add = |integrals: Integrals<K>| {
        squares.add(integrals.square);
        roots.add(integrals.root);
    };
    let mut wide = vec![(whole, integrals)];
    let mut seen = 1;
    for _ in 0..DEPTH {
        seen += 2 * wide.len();
        if seen > PANELS {
            break;
        }
        for panel in std::mem::take(&mut wide).into_iter().flat_map(|(panel, _)| panel.halves()) {
            match over(panel) {
                (integrals, true) if integrals.is_undefined() => return integrals,
                (integrals, true) => add(integrals),
                (integrals, false) => wide.push((panel, integrals)),
            }
        }
    }
    // The remaining panels are wide or undefined, but their enclosures are valid.
    wide.into_iter().for_each(|(_, integrals)| add(integrals));
    Integrals { square: squares.value(), root: roots.value() }
}

/// Returns whether every symmetric matrix within these entries is positive definite, and all entries
/// are defined: whether the pivots of the elimination are positive. The `d²` entries are given column by
/// column, and are overwritten.
pub(super) fn is_positive_definite<K: Kernel>(h: &mut [Enclosure<K>], d: usize) -> bool {
    let is_defined = h.iter().all(|entry| entry.is_finite());
    is_defined
        && (0..d).all(|k| {
            let pivot = h[k * d + k];
            for i in k + 1..d {
                for j in i..d {
                    // The entries above the diagonal stand for both.
                    let [row, column] = [h[i * d + k], h[j * d + k]];
                    let product = if i == j { row.sqr() } else { row * column };
                    h[j * d + i] -= product / pivot;
                }
            }
            pivot.lo() > 0.0
        })
}

/// Encloses the mean of a function on a panel, given its range there and its coefficients.
fn bound<K: Kernel>(
    range: Enclosure<K>,
    middle: &Taylor<Enclosure<K>, 3>,
    all: &Taylor<Enclosure<K>, 5>,
) -> Enclosure<K> {
    let fourth = middle.coefficient(0) + middle.coefficient(2) / 12.0 + all.coefficient(4) / 80.0;
    // Third derivatives of a table may jump; then a lower order serves.
    let second = middle.coefficient(0) + all.coefficient(2) / 12.0;
    let taylor = if fourth.is_undefined() { second } else { fourth };
    if taylor.is_undefined() {
        // A derivative may be undefined where the value is defined, as for the root of zero.
        return range;
    }
    range.intersection(taylor).unwrap_or(Enclosure::UNDEFINED)
}

/// Returns whether a panel is narrow enough, or bisecting would not help because the value at its
/// midpoint is just as wide. Returns false if the panel is undefined.
fn narrow<K: Kernel>(mean: Enclosure<K>, of_value: f64) -> bool {
    let width = mean.width();
    width <= TOLERANCE * mean.mignitude() || width <= 2.0 * of_value
}

/// Returns the nonnegative part of an enclosure of `dᵀHd`. If this part is empty, `H` is not a
/// metric, and the result is undefined.
fn nonnegative<K: Kernel>(square: Enclosure<K>) -> Enclosure<K> {
    if square.hi() >= 0.0 {
        Enclosure::new(square.lo().max(0.0), square.hi()).unwrap_or(Enclosure::UNDEFINED)
    } else {
        Enclosure::UNDEFINED
    }
}

impl<K: Kernel> Integrals<K> {
    pub(super) fn undefined() -> Self {
        Self { square: Enclosure::UNDEFINED, root: Enclosure::UNDEFINED }
    }

    pub(super) fn is_undefined(&self) -> bool {
        self.square.is_undefined() || self.root.is_undefined()
    }
}

#[cfg(test)]
mod tests {
    use tautline_formula::Formula;
    use tautline_metrics::{
        Metric,
        gallery::{EggCrate, Valleys},
    };
    use tautline_scalar::{Interval, Rigorous};

    use super::{Chord, Integrals, bisected};

    /// If a box at an end makes the enclosure wide, bisecting would not help and is not tried. If
    /// the metric varies too fast, bisecting stops.
    #[test]
    fn bisecting_stops_where_it_does_not_help() {
        /// Returns the integrals, and how often a panel was evaluated.
        fn counted(
            chord: &Chord<Rigorous>,
            metric: &impl Metric<2>,
        ) -> (Integrals<Rigorous>, usize) {
            let formula = Formula::record(metric).expect("no branches").into_any();
            let mut panels = 0;
            let integrals = bisected(|panel| {
                panels += 1;
                chord.over(&formula, panel)
            });
            (integrals, panels)
        }
        let near = |c: f64| Interval::new(c - 1e-3, c + 1e-3).expect("ordered");
        let (from, to) = ([Interval::point(0.0); 2], [0.5, 0.25]);
        let (boxes, panels) = counted(&Chord::between(&from, &to.map(near)), &Valleys);
        assert!(boxes.square.is_finite());
        // The metric is evaluated at the midpoint and on the whole chord.
        assert_eq!(panels, 1);
        let fast = EggCrate::new(1e-6, 1e6).expect("positive");
        let (all, panels) = counted(&Chord::between(&from, &to.map(Interval::point)), &fast);
        let energy = all.square;
        assert!(energy.is_finite() && energy.width() > 0.01 * energy.lo(), "{energy:?}");
        assert!((4096..=8192).contains(&panels), "{panels}");
    }
}
