//! `Chord`: rigorous bounds of the energy and the length of one line segment.

use nalgebra::SVector;
use tautline_metrics::Metric;
use tautline_scalar::{Enclosure, Kernel, Scalar};

use super::taylor::Taylor;

/// A panel whose enclosure is at most this much wider than long, relatively, is not bisected.
///
/// The widths of panels add up as their integrals do, so the truncation widens the whole by no
/// more than this: a hundredth of ten digits. The rounding of `N = 1000` chords comes to `10⁻¹⁴`.
const TOLERANCE: f64 = 1e-12;

/// How often a chord is bisected at most: a panel is then `2⁻¹²` of it.
const DEPTH: u32 = 12;

/// The line from `start` to `start + step`, or each of the lines with these data in two boxes.
#[derive(Clone, Copy, Debug)]
pub(super) struct Chord<K, const D: usize> {
    start: SVector<Enclosure<K>, D>,
    step: SVector<Enclosure<K>, D>,
}

/// Enclosures of `∫₀¹ f ds` and `∫₀¹ √f ds`, where `f(s) = dᵀ H(x + s d) d`, in `m²` and `m`.
#[derive(Clone, Copy, Debug)]
pub(super) struct Integrals<K> {
    pub(super) square: Enclosure<K>,
    pub(super) root: Enclosure<K>,
}

/// The part of a chord with `|s − centre| ≤ width/2`; both are dyadic fractions, hence exact.
#[derive(Clone, Copy, Debug)]
struct Panel {
    centre: f64,
    width: f64,
}

impl<K: Kernel, const D: usize> Chord<K, D> {
    pub(super) fn between(
        x: &SVector<Enclosure<K>, D>,
        y: &SVector<Enclosure<K>, D>,
    ) -> Chord<K, D> {
        // An interval difference: the one of doubles rounds.
        Chord { start: *x, step: SVector::from_fn(|i, _| y[i] - x[i]) }
    }

    /// The enclosures; undefined if the metric is, somewhere on the chord.
    pub(super) fn integrals(&self, metric: &impl Metric<D>) -> Integrals<K> {
        self.over(metric, Panel { centre: 0.5, width: 1.0 }, DEPTH)
    }

    /// `dᵀ H(x + s d) d` as a function of `u`, where `s = centre + width u`.
    ///
    /// From the Gram matrix and not from `norm_squared`: the vector of that one is a double.
    fn square<const M: usize>(
        &self,
        metric: &impl Metric<D>,
        centre: Enclosure<K>,
        width: f64,
    ) -> Taylor<Enclosure<K>, M> {
        let (x, d) = (&self.start, &self.step);
        let at = SVector::from_fn(|i, _| Taylor::line(x[i] + d[i] * centre, d[i] * width));
        let h = metric.gram(&at);
        Taylor::combination((0..D).flat_map(|i| (i..D).map(move |j| (i, j))).map(|(i, j)| {
            let product = if i == j { d[i].sqr() } else { d[i] * d[j] * 2.0 };
            (h[(i, j)], product)
        }))
    }

    /// The value `dᵀ H(x + s d) d` alone.
    pub(super) fn square_at(&self, metric: &impl Metric<D>, fraction: f64) -> Enclosure<K> {
        // Where s = 0 the point is x itself: x + 0 d would be wider if d is a box.
        let value: Taylor<_, 1> = self.square(metric, Enclosure::point(fraction), 0.0);
        nonnegative(value.coefficient(0))
    }

    /// The integrals over a panel, bisected up to `depth` times.
    ///
    /// With `g(u) = f(centre + width u)`, Taylor's formula at the midpoint has
    ///
    /// ```text
    /// ∫ f ds = width ∫ g du = width (g₀(0) + g₂(0)/12 + g₄(ξ)/80),   |u| ≤ ½, |ξ| ≤ ½
    /// ```
    ///
    /// in the coefficients `gₖ = g⁽ᵏ⁾/k!`: the odd ones cancel, and `∫ u² = 1/12`, `∫ u⁴ = 1/80`.
    fn over(&self, metric: &impl Metric<D>, panel: Panel, depth: u32) -> Integrals<K> {
        let Panel { centre, width } = panel;
        let middle: Taylor<_, 3> = self.square(metric, Enclosure::point(centre), width);
        if middle.coefficient(0).is_undefined() {
            return Integrals::undefined();
        }
        let half = 0.5 * width;
        let range = Enclosure::new(centre - half, centre + half).expect("a panel has its ends");
        let all: Taylor<_, 5> = self.square(metric, range, width);
        let square = bound(nonnegative(all.coefficient(0)), &middle, &all);
        let roots = nonnegative(all.coefficient(0)).sqrt();
        let root = bound(roots, &middle.sqrt(), &all.sqrt());
        // Bisecting does not help against the rounding of a value.
        let value = nonnegative(middle.coefficient(0));
        let done =
            depth == 0 || (narrow(square, value.width()) && narrow(root, value.sqrt().width()));
        if done {
            return Integrals { square: square * width, root: root * width };
        }
        let side = |centre: f64| self.over(metric, Panel { centre, width: half }, depth - 1);
        let left = side(centre - 0.5 * half);
        if left.is_undefined() {
            return left;
        }
        left + side(centre + 0.5 * half)
    }
}

/// The mean of a function on a panel, given its range there and its coefficients.
fn bound<K: Kernel>(
    range: Enclosure<K>,
    middle: &Taylor<Enclosure<K>, 3>,
    all: &Taylor<Enclosure<K>, 5>,
) -> Enclosure<K> {
    let taylor = middle.coefficient(0) + middle.coefficient(2) / 12.0 + all.coefficient(4) / 80.0;
    if taylor.is_undefined() {
        // A derivative may be so where the value is not, as for a root of zero.
        return range;
    }
    range.intersection(taylor).unwrap_or(Enclosure::UNDEFINED)
}

/// Whether a panel is narrow enough, given the width of one value on it; false if undefined.
fn narrow<K: Kernel>(mean: Enclosure<K>, of_value: f64) -> bool {
    let width = mean.width();
    width <= TOLERANCE * mean.mignitude() || width <= 2.0 * of_value
}

/// What is not negative of an enclosure of `dᵀHd`; undefined if that is nothing: then `H` is no
/// metric.
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

impl<K: Kernel> std::ops::Add for Integrals<K> {
    type Output = Self;
    fn add(self, other: Self) -> Self {
        Self { square: self.square + other.square, root: self.root + other.root }
    }
}
