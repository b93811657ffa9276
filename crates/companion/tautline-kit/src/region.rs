//! `Region`: the box of `R^D` in which samples are drawn.

use nalgebra::SVector;
use proptest::prelude::*;

/// The number of steps along each edge. It is a power of two, so that shrunk samples are short
/// binary fractions of the edges.
const STEPS: u32 = 1 << 16;

/// The number of equal parts of an edge; special points lie between them.
const PARTS: u32 = 4;

/// One in this many points is special.
const MOVED: u32 = 8;

/// The number of steps of a coordinate of a direction, on either side of 0.
const DIRECTION_STEPS: i32 = 1 << 8;

/// A box of `R^D` with positive edges, in which the kit draws samples.
///
/// Choose the part of space where the formula varies: one period, or a few widths of its features.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Region<const D: usize> {
    low: SVector<f64, D>,
    high: SVector<f64, D>,
}

/// An edge along which samples cannot be drawn.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
#[error("edge {index} from {low} to {high} must be finite and of positive length")]
pub struct RegionError {
    /// The index of the coordinate, from 0.
    pub index: usize,
    /// The coordinate of the lower corner.
    pub low: f64,
    /// The coordinate of the upper corner.
    pub high: f64,
}

impl<const D: usize> Region<D> {
    /// Returns the box between two corners, in `ℓ`.
    ///
    /// # Errors
    ///
    /// [`RegionError`] with the first edge that is not finite or whose length is not positive.
    pub fn new(
        low: impl Into<SVector<f64, D>>,
        high: impl Into<SVector<f64, D>>,
    ) -> Result<Self, RegionError> {
        let (low, high) = (low.into(), high.into());
        for index in 0..D {
            let (low, high) = (low[index], high[index]);
            let length = high - low;
            if !(length > 0.0 && length.is_finite()) {
                return Err(RegionError { index, low, high });
            }
        }
        Ok(Self { low, high })
    }

    /// Returns the box between two corners, in `ℓ`, for use in a test.
    ///
    /// # Panics
    ///
    /// If an edge is not finite or its length is not positive. [`Region::new`] returns an error
    /// instead.
    #[must_use]
    #[track_caller]
    pub fn cell(low: impl Into<SVector<f64, D>>, high: impl Into<SVector<f64, D>>) -> Self {
        match Self::new(low, high) {
            Ok(region) => region,
            Err(error) => panic!("{error}"),
        }
    }

    /// Returns the longest edge, in `ℓ`.
    #[must_use]
    pub fn size(&self) -> f64 {
        (self.high - self.low).max()
    }

    /// Returns the largest distance of a point of the box from the origin, in `ℓ`.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.low.abs().sup(&self.high.abs()).norm()
    }

    /// Returns the point at a fraction in `[0, 1]` of each edge, in `ℓ`.
    #[must_use]
    pub fn at(&self, fractions: &SVector<f64, D>) -> SVector<f64, D> {
        self.low + (self.high - self.low).component_mul(fractions)
    }

    /// Returns the point of the box nearest to `x`, in `ℓ`.
    #[must_use]
    pub fn clamp(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        x.sup(&self.low).inf(&self.high)
    }

    /// Draws points of the box. Seven in eight are [`uniform`](Region::uniform). The others are
    /// moved to places where formulas break and no uniform point lies: each coordinate is moved to
    /// an end of its edge, a quarter, the middle, three quarters or, if it is on the edge, 0.
    pub fn points(&self) -> impl Strategy<Value = SVector<f64, D>> + use<D> {
        let region = *self;
        // If the uniform point fails too, a special point first shrinks to it.
        (0..MOVED, self.uniform())
            .prop_map(move |(k, x)| if k + 1 == MOVED { region.special(&x) } else { x })
    }

    /// Draws uniform points of the box. They are drawn as integers, so shrunk points have short
    /// coordinates.
    pub fn uniform(&self) -> impl Strategy<Value = SVector<f64, D>> + use<D> {
        let region = *self;
        proptest::array::uniform::<_, D>(0..=STEPS).prop_map(move |steps| {
            region.at(&SVector::from(steps.map(|k| f64::from(k) / f64::from(STEPS))))
        })
    }

    /// Moves each coordinate to a special value.
    fn special(&self, x: &SVector<f64, D>) -> SVector<f64, D> {
        let ([low, high], parts) = ([&self.low, &self.high], f64::from(PARTS));
        SVector::from_fn(|i, _| {
            let edge = high[i] - low[i];
            // Each of the five special values attracts the fifth of the edge in which it lies.
            let part = ((x[i] - low[i]) / edge * (parts + 1.0)).floor().min(parts);
            // The computed low + (high − low) may exceed high by one rounding.
            let quarter = (low[i] + part / parts * edge).min(high[i]);
            let zero = low[i] <= 0.0 && high[i] >= 0.0 && x[i].abs() < (x[i] - quarter).abs();
            if zero { 0.0 } else { quarter }
        })
    }

    /// Draws pairs of different points of the box. Two pairs in three are independent; the points
    /// of the others may be as close as `2⁻¹⁸` of the longest edge.
    pub fn pairs(&self) -> impl Strategy<Value = [SVector<f64, D>; 2]> + use<D> {
        let region = *self;
        let near =
            (self.points(), directions::<D>(), 1..=18_i32).prop_map(move |(x, w, halvings)| {
                [x, region.clamp(&(x + w * (region.size() * 0.5_f64.powi(halvings))))]
            });
        let far = (self.points(), self.points()).prop_map(|(x, y)| [x, y]);
        prop_oneof![2 => far, 1 => near].prop_filter("the points differ", |[x, y]| x != y)
    }
}

/// Draws unit vectors, as integers.
pub fn directions<const D: usize>() -> impl Strategy<Value = SVector<f64, D>> {
    proptest::array::uniform::<_, D>(-DIRECTION_STEPS..=DIRECTION_STEPS)
        .prop_filter("a direction is not zero", |steps| steps.iter().any(|&k| k != 0))
        .prop_map(|steps| SVector::from(steps.map(f64::from)).normalize())
}

#[cfg(test)]
mod tests {
    use nalgebra::vector;
    use proptest::{
        strategy::{Strategy, ValueTree},
        test_runner::TestRunner,
    };

    use super::{Region, RegionError};

    #[test]
    fn edges_without_length_are_refused() {
        let error = Region::<2>::new([0.0, 1.0], [1.0, 1.0]).expect_err("no length");
        assert_eq!(error, RegionError { index: 1, low: 1.0, high: 1.0 });
        assert!(Region::<1>::new([f64::NAN], [1.0]).is_err());
        assert!(Region::<1>::new([0.0], [f64::INFINITY]).is_err());
        assert!(Region::<1>::new([-f64::MAX], [f64::MAX]).is_err());
    }

    #[test]
    fn size_reach_and_clamp_are_those_of_the_box() {
        let region = Region::<2>::cell([-4.0, 0.0], [-3.0, 3.0]);
        assert_eq!((region.size(), region.reach()), (3.0, 5.0));
        assert_eq!(region.clamp(&vector![-9.0, 1.0]), vector![-4.0, 1.0]);
        assert_eq!(region.at(&vector![0.5, 1.0]), vector![-3.5, 3.0]);
    }

    /// Of 1024 samples, 128 are moved. A tenth or a fifth of these are moved to a given place of an
    /// edge.
    #[test]
    fn samples_meet_the_axes_the_middle_and_the_corner() {
        let region = Region::<2>::cell([-1.0, -0.7], [2.0, 0.9]);
        let mut runner = TestRunner::new(tautline_chance::config(411, 1));
        let mut met = [0; 4];
        for _ in 0..1024 {
            let x = region.points().new_tree(&mut runner).expect("a sample").current();
            let seen = [x[0] == 0.0, x[1] == 0.0, x[0] == 0.5, x == vector![2.0, 0.9]];
            for (met, seen) in met.iter_mut().zip(seen) {
                *met += u32::from(seen);
            }
        }
        assert!(met.iter().all(|&times| (1..=64).contains(&times)), "{met:?}");
        let moved = [[0.1, 0.08], [0.4, -0.29], [-0.9, 0.89]].map(|x| region.special(&x.into()));
        let expected = [vector![0.0, 0.1], vector![0.5, -0.3], vector![-1.0, 0.9]];
        for (x, expected) in moved.iter().zip(expected) {
            assert!((x - expected).amax() <= 1e-15 && region.clamp(x) == *x, "{x}");
        }
    }

    /// Of 256 pairs, 85 are close together, and 28 of these are closer than `2⁻¹²` of the edge.
    #[test]
    fn some_pairs_are_near_and_most_are_far() {
        let region = Region::<2>::cell([0.0, 0.0], [1.0, 1.0]);
        let mut runner = TestRunner::new(tautline_chance::config(412, 1));
        let apart: Vec<f64> = (0..256)
            .map(|_| region.pairs().new_tree(&mut runner).expect("a sample").current())
            .map(|[x, y]| (x - y).norm())
            .collect();
        let nearer = |than: f64| apart.iter().filter(|&&step| step < than).count();
        assert!((10..=56).contains(&nearer(1.0 / 4096.0)), "{}", nearer(1.0 / 4096.0));
        assert!(nearer(0.1) <= 128 && nearer(f64::MIN_POSITIVE) == 0);
    }
}
