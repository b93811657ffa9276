//! Cubes `k a + [0, a]^D` of a lattice whose side `a` is a power of two, and their nodes.
//!
//! All corners and all midpoints of edges are doubles, without rounding.

use nalgebra::SVector;
use tautline_scalar::Interval;

use crate::CheckError;

/// The place of a cube, or of a node on the lattice of half the side.
pub type Place<const D: usize> = [i32; D];

/// The least and the greatest exponent of a side.
const EXPONENTS: std::ops::RangeInclusive<i32> = -200..=200;

/// The greatest coordinate of a place.
const FARTHEST: i32 = 1 << 28;

/// The most places in a box around all cubes. So a checker can number the nodes with 64 bits.
const WIDEST: u128 = 1 << 48;

/// A finite set of cubes, all of side `2ᵉ`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Cubes<const D: usize> {
    exponent: i32,
    /// In lexicographic order, each one once.
    places: Vec<Place<D>>,
}

impl<const D: usize> Cubes<D> {
    /// Returns the cubes at these places, in any order.
    ///
    /// # Errors
    ///
    /// [`CheckError::Side`] or [`CheckError::Place`] if a side or a place is out of range;
    /// [`CheckError::Apart`] if a box around all cubes has more than `2⁴⁸` places.
    pub fn new(exponent: i32, mut places: Vec<Place<D>>) -> Result<Self, CheckError> {
        if !EXPONENTS.contains(&exponent) {
            return Err(CheckError::Side { exponent });
        }
        let far = |&k: &i32| !(-FARTHEST..=FARTHEST).contains(&k);
        if let Some(&place) = places.iter().flatten().find(|k| far(k)) {
            return Err(CheckError::Place { place });
        }
        let width = |i: usize| {
            let along = || places.iter().map(|place| i64::from(place[i]));
            along().max().zip(along().min()).map_or(0, |(most, least)| most - least + 1)
        };
        let widths = (0..D).map(|i| width(i) as u128);
        if widths.fold(1, u128::saturating_mul) > WIDEST {
            return Err(CheckError::Apart);
        }
        places.sort_unstable();
        places.dedup();
        Ok(Self { exponent, places })
    }

    /// Returns `e`.
    #[must_use]
    pub fn exponent(&self) -> i32 {
        self.exponent
    }

    /// Returns the side `2ᵉ`, in `ℓ`.
    #[must_use]
    pub fn side(&self) -> f64 {
        side(self.exponent)
    }

    /// Returns the places, in lexicographic order.
    #[must_use]
    pub fn places(&self) -> &[Place<D>] {
        &self.places
    }

    /// Returns the nodes: the points of the lattice of half the side that lie in a cube, in
    /// lexicographic order. A cube at `k` has the nodes from `2k` to `2k + 2`.
    #[must_use]
    pub fn nodes(&self) -> Vec<Place<D>> {
        lattice_points(&self.places, 2)
    }

    /// Returns the corners of the cubes, in lexicographic order.
    #[must_use]
    pub fn corners(&self) -> Vec<Place<D>> {
        lattice_points(&self.places, 1)
    }

    /// Returns whether there is a cube at this place.
    #[must_use]
    pub fn contains(&self, place: &Place<D>) -> bool {
        self.places.binary_search(place).is_ok()
    }

    /// Returns the first of these places without a cube.
    pub(crate) fn first_missing<'p>(&self, places: &'p [Place<D>]) -> Option<&'p Place<D>> {
        places.iter().find(|place| !self.contains(place))
    }

    /// Returns the cubes of half the side.
    ///
    /// # Errors
    ///
    /// As for [`Cubes::new`].
    pub fn halved(&self) -> Result<Self, CheckError> {
        let halves = self.places.iter().flat_map(halves).collect();
        Self::new(self.exponent - 1, halves)
    }
}

/// Returns the places of the `2^D` cubes of half the side.
pub(crate) fn halves<const D: usize>(place: &Place<D>) -> impl Iterator<Item = Place<D>> + use<D> {
    let place = *place;
    (0..1 << D)
        .map(move |half: usize| std::array::from_fn(|i| 2 * place[i] + (half >> i & 1) as i32))
}

/// Returns the double `2ᵉ`.
pub(crate) fn side(exponent: i32) -> f64 {
    2.0_f64.powi(exponent)
}

/// Returns the point of the lattice of side `2ᵉ` at this place, without rounding.
pub(crate) fn point<const D: usize>(exponent: i32, place: &Place<D>) -> SVector<f64, D> {
    SVector::from_fn(|i, _| f64::from(place[i]) * side(exponent))
}

/// Returns the cube of side `2ᵉ` at this place.
pub(crate) fn cube<const D: usize>(exponent: i32, place: &Place<D>) -> SVector<Interval, D> {
    let (low, high) = (point(exponent, place), point(exponent, &place.map(|k| k + 1)));
    low.zip_map(&high, |low, high| Interval::point(low).hull(Interval::point(high)))
}

/// Returns the points from `n k` to `n k + n` of all places `k`, in lexicographic order.
fn lattice_points<const D: usize>(places: &[Place<D>], n: i32) -> Vec<Place<D>> {
    let width = (n + 1) as usize;
    let mut points = Vec::with_capacity(places.len() * width.pow(D as u32));
    for place in places {
        points.extend((0..width.pow(D as u32)).map(|at| offset(place, n, at)));
    }
    points.sort_unstable();
    points.dedup();
    points
}

/// Returns the point number `at` of those from `n k` to `n k + n`, in lexicographic order.
fn offset<const D: usize>(place: &Place<D>, n: i32, mut at: usize) -> Place<D> {
    let width = (n + 1) as usize;
    let mut point = [0; D];
    for i in (0..D).rev() {
        point[i] = n * place[i] + (at % width) as i32;
        at /= width;
    }
    point
}

/// Writes the numbers of the points from `n k` to `n k + n` in the sorted list of all points.
///
/// Points that differ in the last coordinate only are neighbours in the list.
pub(crate) fn numbers<const D: usize>(
    points: &[Place<D>],
    place: &Place<D>,
    n: i32,
    numbers: &mut Vec<usize>,
) {
    let width = (n + 1) as usize;
    numbers.clear();
    for row in 0..width.pow(D as u32 - 1) {
        let first = points.partition_point(|point| *point < offset(place, n, row * width));
        numbers.extend(first..first + width);
    }
}
