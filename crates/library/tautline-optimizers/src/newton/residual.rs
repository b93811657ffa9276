//! `Residual`: how far a point sequence is from solving the discrete geodesic equation.

use nalgebra::SVector;
use tautline_discretizations::{ANY, PointSequence};
use tautline_metrics::Lanes;
use tautline_sets::AnySet;

use crate::newton::{
    arithmetic::small::{Vector, dot},
    end_frame::EndFrame,
    magnitude::Magnitude,
    rounding::rounding,
};

/// The [residual](crate::Minimum::residual), computed from the gradients with respect to all
/// points.
pub(crate) struct Residual {
    dimension: usize,
    /// A unit close to the momentum, in `m²/ℓ`. Gradients are divided by it first, since their
    /// squares may overflow.
    unit: f64,
    reciprocal: f64,
    last: usize,
    /// `Σ |gₙ|²` over the inner points, divided by the square of the unit.
    pub(crate) inner: f64,
    /// The gradients with respect to the two ends.
    pub(crate) ends: [Vector; 2],
}

impl Residual {
    /// Begins a residual in `R^dimension` for `n` subintervals and a magnitude near `about`.
    pub(crate) fn new(dimension: usize, n: usize, about: Magnitude) -> Self {
        // The reciprocal of the unit has to be finite.
        let unit = about.momentum().max(f64::MIN_POSITIVE);
        let zero = Vector::from_elem(0.0, dimension);
        let ends = [zero.clone(), zero];
        Self { dimension, unit, reciprocal: 1.0 / unit, last: n, inner: 0.0, ends }
    }

    /// Returns the factor by which gradients are multiplied before they are squared.
    pub(crate) fn scale(&self) -> Scale {
        Scale { reciprocal: self.reciprocal }
    }

    /// Adds the gradients with respect to all points, of which these are the coordinates.
    pub(crate) fn push_all(&mut self, slopes: &[f64]) {
        let d = self.dimension;
        let (first, rest) = slopes.split_at(d);
        let (inner, last) = rest.split_at(rest.len() - d);
        self.ends = [Vector::from_slice(first), Vector::from_slice(last)];
        let scale = self.scale();
        self.inner = match d {
            1 => scale.sum::<1>(inner),
            2 => scale.sum::<2>(inner),
            3 => scale.sum::<3>(inner),
            _ => inner.chunks_exact(d).map(|slope| scale.square_of(slope)).sum(),
        };
    }

    /// Returns the residual and its floor, once the gradients are known.
    pub(crate) fn value(
        &self,
        sets: [&dyn AnySet; 2],
        sequence: &PointSequence<ANY>,
        magnitude: Magnitude,
    ) -> (f64, f64) {
        let n = self.last as f64;
        let momentum = magnitude.momentum();
        // Without a metric there is no residual that could be small.
        if momentum.is_nan() {
            return (f64::INFINITY, 0.0);
        }
        if momentum == 0.0 {
            return (0.0, 0.0);
        }
        // A coordinate is rounded with the variance u²/12, where u ≤ ε max |x|, so that xₙ₋₁ − 2xₙ
        // + xₙ₊₁ has the variance u²/2. There are D coordinates, and the factor is N⁴ c².
        let dimensions = (self.dimension as f64 / 2.0).max(1.0).sqrt();
        let floor = dimensions * n * rounding(sequence) * (magnitude.mean_gram / momentum);
        // The metric may have no derivative here.
        let infinite_if_nan = |x: f64| if x.is_nan() { f64::INFINITY } else { x };
        let root = (self.inner / n).sqrt() * (self.unit / momentum);
        let tau = magnitude.tau(self.last);
        let at_end = |end: usize, x: &[f64]| {
            let frame = EndFrame::new(sets[end], x, &self.ends[end], tau);
            let scaled: Vector = frame.projected_gradient.iter().map(|g| g / momentum).collect();
            infinite_if_nan(0.5 * dot(&scaled, &scaled).sqrt())
        };
        let ends = at_end(0, sequence.row(0)).max(at_end(1, sequence.row(self.last)));
        (infinite_if_nan(0.5 * n * root) + ends, floor)
    }
}

/// The unit in which gradients are squared.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    reciprocal: f64,
}

impl Scale {
    /// Returns the squared gradient with respect to a point, divided by the square of the unit.
    #[inline(always)]
    pub(crate) fn square<T: Lanes, const D: usize>(self, gradient: &SVector<T, D>) -> T {
        let scaled = gradient * T::constant(self.reciprocal);
        scaled.dot(&scaled)
    }

    /// Returns the same in any dimension.
    pub(crate) fn square_of(self, slope: &[f64]) -> f64 {
        slope.iter().map(|g| g * self.reciprocal).map(|g| g * g).sum()
    }

    fn sum<const D: usize>(self, slopes: &[f64]) -> f64 {
        let gradients: &[SVector<f64, D>] = bytemuck::cast_slice(slopes);
        gradients.iter().map(|gradient| self.square(gradient)).sum()
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::{SMatrix, SVector};
    use tautline_discretizations::{PointSequence, QuadraticModel, Rule};
    use tautline_metrics::{Lanes, Pair, gallery::Constant};
    use tautline_sets::{ClosedSet, HalfSpace, InAny, Point};

    use super::Residual;
    use crate::newton::magnitude::Magnitude;

    /// Returns the residual divided by its floor, for a rounded straight line with equal
    /// coordinates.
    fn over_the_floor<const D: usize>() -> f64 {
        let (a, b) = (SVector::<f64, D>::repeat(-0.3), SVector::repeat(0.7));
        let metric = Constant::new(SMatrix::<f64, D, D>::identity()).expect("definite");
        let line = PointSequence::straight(a, b, 1000).expect("finite");
        let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &line);
        let magnitude = Magnitude::of(&model);
        let mut residual = Residual::new(D, 1000, magnitude);
        residual.push_all(&model.slopes);
        let [a, b] = [a, b].map(|x| Point::new(x).expect("finite"));
        let (residual, floor) =
            residual.value([&InAny(&a), &InAny(&b)], &line.into_any(), magnitude);
        residual / floor
    }

    #[test]
    fn the_floor_predicts_rounding_in_any_dimension() {
        let plane = over_the_floor::<2>();
        // The rounding of coordinates from −0.3 to 0.7 is about a third of the rounding at 0.7.
        assert!((0.1..1.0).contains(&plane), "{plane}");
        // The roundings are the same in every coordinate, but they are summed in another order.
        for more in [over_the_floor::<3>(), over_the_floor::<8>(), over_the_floor::<32>()] {
            approx::assert_relative_eq!(more, plane, max_relative = 1e-9);
        }
    }

    /// A line runs from wall to wall with momentum `(3, 4)`, which has the component `4` along one
    /// wall and `3` along the other. The larger component counts, at either end. An end that is a
    /// point contributes nothing.
    #[test]
    fn the_less_stationary_end_counts() {
        let metric = Constant::new(SMatrix::<f64, 2, 2>::identity()).expect("definite");
        let [a, b] = [[0.0, 0.0], [3.0, 4.0]].map(SVector::from);
        let wall = |normal: [f64; 2], through: &SVector<f64, 2>| {
            let normal = SVector::from(normal);
            HalfSpace::new(normal, normal.dot(through)).expect("a normal")
        };
        let points = [a, b].map(|x| Point::new(x).expect("finite"));
        // The outer normals point against the line at its start and along it at its end.
        let first = [wall([1.0, 0.0], &a), wall([0.0, 1.0], &a)];
        let second = [wall([-1.0, 0.0], &b), wall([0.0, -1.0], &b)];
        for n in [1, 2, 20] {
            let line = PointSequence::straight(a, b, n).expect("finite");
            let model = QuadraticModel::new(Rule::TRAPEZOIDAL, &metric, &line);
            let magnitude = Magnitude::of(&model);
            let mut residual = Residual::new(2, n, magnitude);
            residual.push_all(&model.slopes);
            let value = |one: &dyn ClosedSet<2>, other: &dyn ClosedSet<2>| {
                residual.value([&InAny(one), &InAny(other)], &line.clone().into_any(), magnitude).0
            };
            for (found, expected) in [
                (value(&first[0], &second[1]), 0.8),
                (value(&first[1], &second[0]), 0.8),
                (value(&first[1], &second[1]), 0.6),
                (value(&first[0], &points[1]), 0.8),
                (value(&points[0], &second[0]), 0.8),
                (value(&points[0], &second[1]), 0.6),
                (value(&points[0], &points[1]), 0.0),
            ] {
                // The rounding is that of second differences of coordinates up to 4, times N².
                let rounding = 8.0 * f64::EPSILON * (n * n) as f64;
                assert!((found - expected).abs() <= rounding, "N = {n}: {found}, {expected}");
            }
        }
    }

    #[test]
    fn each_lane_has_its_own_square() {
        let residual = Residual::new(2, 3, Magnitude { energy: 2.0, mean_gram: 1.0 }).scale();
        let gradients = [[1.0, 2.0], [3.0, -4.0]].map(SVector::from);
        let squares = residual.square(&gradients[0].zip_map(&gradients[1], Pair::new));
        // The squares 1 + 4 and 9 + 16 are divided by the square of the momentum, 2, with three
        // roundings.
        for (lane, expected) in [2.5, 12.5].into_iter().enumerate() {
            assert!((squares.lane(lane) - expected).abs() < 1e-14);
            assert_eq!(squares.lane(lane), residual.square(&gradients[lane]));
        }
    }
}
