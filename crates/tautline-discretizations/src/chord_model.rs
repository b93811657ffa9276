//! `ChordModel`: what one chord adds to a discrete energy, to second order.

use nalgebra::{SMatrix, SVector};
use tautline_metrics::{Metric, Pair, Scalar};

use crate::{
    Node, Rule,
    contraction::{Contraction, SPLIT},
};

/// The part of one chord in a discrete energy, with its first and second derivatives by the two
/// points that it joins.
///
/// With pairs of numbers, those of two chords side by side.
///
/// Derivation, for one node of weight 1 at the fraction `θ` of the chord `d = y − x`, with
/// `H` and its derivatives at `x + θ d`, and `e = N dᵀHd` its part of the energy:
///
/// ```text
/// q = H d,   Gₖ = dᵀ ∂ₖH d,   Pᵢₖ = (∂ₖH d)ᵢ,   Qₖₗ = dᵀ ∂ₖ∂ₗH d
/// ∂e/∂x = N (−2q + (1−θ) G),                  ∂e/∂y = N (2q + θ G)
/// ∂²e/∂x² = N (2H − 2(1−θ)(P + Pᵀ) + (1−θ)² Q),  ∂²e/∂y² = N (2H + 2θ(P + Pᵀ) + θ² Q)
/// ∂²e/∂x∂y = N (−2H − 2θ P + 2(1−θ) Pᵀ + θ(1−θ) Q)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChordModel<const D: usize, T = f64> {
    /// The part of the energy, in `m²`.
    pub energy: T,
    /// `N tr H`, the mean over the nodes, in `m²/ℓ²`.
    pub trace: T,
    /// The gradients by the near and by the far point, in `m²/ℓ`.
    pub gradient: [SVector<T, D>; 2],
    /// The second derivatives by the near and by the far point, in `m²/ℓ²`.
    pub hessian: [SMatrix<T, D, D>; 2],
    /// The mixed ones: rows by the near point, columns by the far.
    pub coupling: SMatrix<T, D, D>,
    /// Whether the Gram matrix is finite, symmetric and positive definite at every node.
    pub is_metric: bool,
}

impl<const D: usize> ChordModel<D> {
    /// Expands the part that the chord from `x` to `x + d` has in the energy of `rule` with `n`
    /// subintervals. NaN where the metric is.
    #[inline(always)]
    #[must_use]
    pub fn new<R: Rule>(
        rule: R,
        metric: &impl Metric<D>,
        x: &SVector<f64, D>,
        d: &SVector<f64, D>,
        n: f64,
    ) -> Self {
        Self::seen_from(0, rule, metric, (x, *d), n)
    }

    /// The same seen from the end 0, `x`, or 1, `x + d`, of the chord `(x, d)`: from the latter it
    /// leads back to `x`, and its near point is the far one of the rule.
    #[inline(always)]
    #[must_use]
    pub fn seen_from<R: Rule>(
        end: usize,
        _rule: R,
        metric: &impl Metric<D>,
        (x, d): (&SVector<f64, D>, SVector<f64, D>),
        n: f64,
    ) -> Self {
        let seen = if end == 0 { d } else { -d };
        Self::over_nodes::<R>(|node| {
            let far = if end == 0 { node.fraction } else { 1.0 - node.fraction };
            let contraction = Contraction::new(metric, &(x + d * node.fraction), &seen);
            Self::at_node(contraction, &seen, far, node.weight * n)
        })
    }
}

impl<const D: usize> ChordModel<D, Pair> {
    /// Whether two chords at once take less time than one after the other.
    pub const PAYS: bool = D < SPLIT;

    /// Expands the parts of two chords at once, of which the second is [seen](ChordModel::seen_from)
    /// from its end 1.
    #[inline(always)]
    #[must_use]
    pub fn facing<R: Rule>(
        _rule: R,
        metric: &impl Metric<D>,
        chords: [(&SVector<f64, D>, SVector<f64, D>); 2],
        n: f64,
    ) -> Self {
        let [(x, d), (other_x, other_d)] = chords;
        let reversed = d.zip_map(&other_d, |d, other| Pair::new(d, -other));
        Self::over_nodes::<R>(|node| {
            let theta = node.fraction;
            let (y, other_y) = (x + d * theta, other_x + other_d * theta);
            let contraction =
                Contraction::of_pair(metric, &y.zip_map(&other_y, Pair::new), &reversed);
            Self::at_node(contraction, &reversed, Pair::new(theta, 1.0 - theta), node.weight * n)
        })
    }
}

impl<T: Scalar, const D: usize> ChordModel<D, T> {
    /// The sum over the nodes.
    #[inline(always)]
    fn over_nodes<R: Rule>(node: impl Fn(&Node) -> Self) -> Self {
        let [first, rest @ ..] = R::NODES else { return Self::zero() };
        rest.iter().map(&node).fold(node(first), Self::plus)
    }

    /// The sum over the nodes, of which each has its number.
    #[inline(always)]
    pub(crate) fn over(nodes: &[Node], node: impl Fn(usize, &Node) -> Self) -> Self {
        let [first, rest @ ..] = nodes else { return Self::zero() };
        let mut sum = node(0, first);
        for (place, next) in rest.iter().enumerate() {
            sum = sum.plus(node(place + 1, next));
        }
        sum
    }

    /// The part of one node, of the weight `w`, at the fraction `far` of the chord.
    #[inline(always)]
    pub(crate) fn at_node(contraction: Contraction<D, T>, d: &SVector<T, D>, far: T, w: f64) -> Self {
        let near = T::one() - far;
        let Contraction { h, g, p, q, is_metric } = contraction;
        // Each with its weight, and twice where twice is wanted.
        let (once, twice) = (T::constant(w), T::constant(2.0 * w));
        let (h, g, p, q) = (h * twice, g * once, p * twice, q * once);
        let (hd, transposed) = (h * d, p.transpose());
        let symmetric = p + transposed;
        Self {
            energy: d.dot(&hd) * 0.5,
            trace: h.trace() * 0.5,
            gradient: [g * near - hd, g * far + hd],
            hessian: [
                h - symmetric * near + q * (near * near),
                h + symmetric * far + q * (far * far),
            ],
            coupling: q * (near * far) - h - p * far + transposed * near,
            is_metric,
        }
    }

    /// The sum of two parts.
    fn plus(self, other: Self) -> Self {
        Self {
            energy: self.energy + other.energy,
            trace: self.trace + other.trace,
            gradient: [0, 1].map(|end| self.gradient[end] + other.gradient[end]),
            hessian: [0, 1].map(|end| self.hessian[end] + other.hessian[end]),
            coupling: self.coupling + other.coupling,
            is_metric: self.is_metric && other.is_metric,
        }
    }

    /// What a rule without nodes has.
    fn zero() -> Self {
        Self {
            energy: T::zero(),
            trace: T::zero(),
            gradient: [SVector::zeros(); 2],
            hessian: [SMatrix::zeros(); 2],
            coupling: SMatrix::zeros(),
            is_metric: true,
        }
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector, vector};
    use tautline_metrics::{Lanes, Metric, Pair, Scalar, gallery::Swirl};

    use super::ChordModel;
    use crate::{LeftEndpoint, LinearModel, Node, PointSequence, Rule, Trapezoidal, TrueTrapezoid};

    /// Nothing in it looks the same from both ends.
    #[derive(Clone, Copy, Debug)]
    struct Lopsided;
    impl Rule for Lopsided {
        const NODES: &'static [Node] =
            &[Node { fraction: 0.25, weight: 0.75 }, Node { fraction: 0.5, weight: 0.25 }];
        const ERROR_EXPONENT: i32 = 1;
    }

    /// Some hundred operations on numbers below 100, of which 3e-14 is two roundings.
    const SMALL: f64 = 1e-12;

    /// That `one`, seen from the end `end`, is `other`, seen from the near one.
    #[track_caller]
    fn is_seen<const D: usize>(end: usize, one: &ChordModel<D>, other: &ChordModel<D>) {
        assert!((one.energy - other.energy).abs() <= SMALL);
        assert!((one.trace - other.trace).abs() <= SMALL);
        for place in [0, 1] {
            let seen = place ^ end;
            assert!((one.gradient[seen] - other.gradient[place]).amax() <= SMALL);
            assert!((one.hessian[seen] - other.hessian[place]).amax() <= SMALL);
        }
        let coupling = if end == 0 { other.coupling } else { other.coupling.transpose() };
        assert!((one.coupling - coupling).amax() <= SMALL);
    }

    #[track_caller]
    fn compare<R: Rule>(rule: R) {
        let metric = Swirl::new(0.5, 1.0).expect("a width");
        let chords =
            [(vector![0.3, -0.2], vector![0.5, 0.25]), (vector![-0.6, 0.1], vector![0.2, -0.7])];
        let chords = chords.each_ref().map(|(x, d)| (x, *d));
        let facing = ChordModel::facing(rule, &metric, chords, 8.0);
        assert!(facing.is_metric);
        for (end, (x, d)) in chords.into_iter().enumerate() {
            let near = ChordModel::new(rule, &metric, x, &d, 8.0);
            let lane = ChordModel {
                energy: facing.energy.lane(end),
                trace: facing.trace.lane(end),
                gradient: facing.gradient.map(|g| g.map(|x| x.lane(end))),
                hessian: facing.hessian.map(|h| h.map(|x| x.lane(end))),
                coupling: facing.coupling.map(|x| x.lane(end)),
                is_metric: true,
            };
            is_seen(end, &lane, &near);
            is_seen(end, &ChordModel::seen_from(end, rule, &metric, (x, d), 8.0), &near);
        }
    }

    #[test]
    fn a_chord_seen_from_its_far_end_leads_back() {
        compare(Trapezoidal);
        compare(LeftEndpoint);
        compare(TrueTrapezoid);
        compare(Lopsided);
    }

    /// `x₂ I`: none from the axis down.
    struct Above;
    impl Metric<2> for Above {
        fn gram<S: Scalar>(&self, x: &SVector<S, 2>) -> SMatrix<S, 2, 2> {
            SMatrix::from_diagonal_element(x[1])
        }
    }

    /// Below the axis at one node of one chord, of two nodes and two chords: each is enough, for a
    /// pair of chords, for one chord, and for all of a sequence.
    #[test]
    fn one_node_without_a_metric_is_enough() {
        // At the nodes 0 and 1 the heights are those of the two ends.
        let chord = |from: f64, to: f64| (vector![0.0, from], vector![1.0, to - from]);
        let heights = [1.0, 2.0, 3.0, 4.0];
        for below in 0..=heights.len() {
            let height = |place: usize| if place == below { -1.0 } else { heights[place] };
            let chords = [chord(height(0), height(1)), chord(height(2), height(3))];
            let [first, second] =
                chords.map(|(x, d)| ChordModel::new(TrueTrapezoid, &Above, &x, &d, 1.0).is_metric);
            assert_eq!([first, second], [below >= 2, !(2..4).contains(&below)], "{below}");
            let both = chords.each_ref().map(|(x, d)| (x, *d));
            let facing = ChordModel::facing(TrueTrapezoid, &Above, both, 1.0);
            assert_eq!(facing.is_metric, below == heights.len(), "{below}");
            let points = (0..4).map(|place| vector![place as f64, height(place)]).collect();
            let sequence = PointSequence::new(points).expect("finite");
            let linear = LinearModel::new(TrueTrapezoid, &Above, &sequence);
            assert_eq!(linear.is_metric, below == heights.len(), "{below}");
        }
    }

    /// The identity, but for one entry.
    struct Spoilt {
        place: (usize, usize),
        entry: f64,
    }
    impl<const D: usize> Metric<D> for Spoilt {
        fn gram<S: Scalar>(&self, _: &SVector<S, D>) -> SMatrix<S, D, D> {
            let mut h = SMatrix::<S, D, D>::identity();
            h[self.place] = S::constant(self.entry);
            h
        }
    }

    /// In every way in which derivatives are taken: halves that differ, whichever is the spoilt one,
    /// an entry of the diagonal that is not positive, the last as well, and infinity.
    #[track_caller]
    fn spoilt_matrices_are_seen<const D: usize>() {
        let defects = [
            ((0, 1), 0.25),
            ((1, 0), 0.25),
            ((D - 1, 0), 0.25),
            ((D - 2, D - 1), 0.25),
            ((0, 0), -1.0),
            ((D - 1, D - 1), 0.0),
            ((D - 1, D - 1), f64::INFINITY),
            ((0, D - 1), f64::NAN),
        ];
        let whole = ((0, 0), 1.0);
        let (x, d) = (SVector::<f64, D>::zeros(), SVector::<f64, D>::repeat(0.5));
        let sequence = PointSequence::new(vec![x, x + d]).expect("finite");
        for (place, entry) in defects.into_iter().chain([whole]) {
            let metric = Spoilt { place, entry };
            let expected = (place, entry) == whole;
            let chord = ChordModel::new(Trapezoidal, &metric, &x, &d, 1.0);
            assert_eq!(chord.is_metric, expected, "{entry} at {place:?} of {D}");
            let linear = LinearModel::new(Trapezoidal, &metric, &sequence);
            assert_eq!(linear.is_metric, expected, "{entry} at {place:?} of {D}");
            // Elsewhere nobody asks for two chords at once, whose derivatives fill the stack.
            if ChordModel::<D, Pair>::PAYS {
                let facing = ChordModel::facing(Trapezoidal, &metric, [(&x, d), (&x, d)], 1.0);
                assert_eq!(facing.is_metric, expected, "{entry} at {place:?} of {D}");
            }
        }
    }

    #[test]
    fn a_matrix_that_is_no_metric_is_seen_in_every_dimension() {
        spoilt_matrices_are_seen::<2>();
        spoilt_matrices_are_seen::<3>();
        spoilt_matrices_are_seen::<4>();
        spoilt_matrices_are_seen::<9>();
        spoilt_matrices_are_seen::<25>();
    }

    #[test]
    fn one_place_without_a_metric_is_enough() {
        let (above, below) = (vector![0.0, 1.0], vector![0.0, -1.0]);
        let d = vector![1.0, 0.25];
        for places in [[&above, &below], [&below, &above], [&above, &above]] {
            let facing = ChordModel::facing(Trapezoidal, &Above, places.map(|x| (x, d)), 1.0);
            assert_eq!(facing.is_metric, places == [&above, &above]);
        }
    }
}
