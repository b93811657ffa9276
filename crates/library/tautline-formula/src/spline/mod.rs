//! Arrays of numbers as functions with continuous second derivatives, and proved ranges of all
//! their derivatives.
//!
//! A cost that was measured or drawn is an array, not a formula. A [`Spline`] makes it a function
//! on all of `R^E`, for one to three axes:
//!
//! ```text
//! f(u) = Σ c_{ijk} B(u₁ − i) B(u₂ − j) B(u₃ − k)
//! ```
//!
//! with the cubic B-spline `B` of support `(−2, 2)`, which is `2/3` at `0`, `1/6` at `±1`, and
//! twice continuously differentiable. Coordinates are in units of the grid: node `i` lies at
//! `u = i`. Outside of the array the nearest coefficient is repeated, so an axis with `n`
//! coefficients has no border: the function is constant along it for `u ≤ −1` and for `u ≥ n`.
//!
//! ```
//! use tautline_formula::spline::Spline;
//! use tautline_scalar::Interval;
//!
//! // Two rows of three pixels. The last axis is the fastest one, as in NumPy.
//! let cost = Spline::new(&[2, 3], vec![1.0, 4.0, 2.0, 1.0, 8.0, 2.0])?;
//! assert_eq!(cost.value(&[-5.0, f64::INFINITY], [0, 0, 0]), 2.0);
//!
//! // The slope along the second axis, at a point and bounded over a box.
//! let slope = cost.value(&[0.5, 1.25], [0, 1, 0]);
//! let side = Interval::new(0.25, 1.5)?;
//! let slopes = cost.enclosure(&[side, side], [0, 1, 0]);
//! assert!(slopes.contains(slope));
//!
//! // Values on all of space lie between the coefficients.
//! assert_eq!(cost.range([0, 0, 0]), Interval::new(1.0, 8.0)?);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Which coefficients
//!
//! | | [`FineSpline::monotone`] | [`Spline::interpolating`] | [`Spline::new`] with the samples |
//! | --- | --- | --- | --- |
//! | value at a node | the sample | the sample | a mean of the samples there and next to it |
//! | between nodes | monotone, between the samples | may overshoot | between the nearest samples |
//! | linear functions | reproduced away from the border | the same | reproduced |
//! | quadratic functions | reproduced where steep | reproduced away from the border | smoothed |
//! | cubic functions | approximated | reproduced away from the border | smoothed |
//! | memory on `E` axes | `3^E` numbers for each sample | one | one |
//!
//! A cost must be positive. If it is a cubic spline through samples, look at [`Spline::range`] first.
//!
//! # Proofs
//!
//! The derivative of order `a` along an axis is a spline of degree `3 − a`, whose coefficients are
//! the `a`-th differences of `c`. It is a convex combination of those that meet a cell, and, on a
//! part of a cell, of its Bernstein coefficients there. [`Spline::enclosure`] computes these with a
//! bound on rounding. It relies on what the intervals of `tautline-scalar` rely on: `+ − × ÷` of
//! `f64` round to nearest.

mod basis;
mod enclosure;
mod expansion;
mod fine_spline;
mod interpolation;
mod place;
mod pyramid;
mod spline_error;
mod stencil;
mod table;
mod value;

use std::{
    fmt,
    hash::{Hash, Hasher},
    mem,
    sync::OnceLock,
};

pub use expansion::Expansion;
pub use fine_spline::FineSpline;
use pyramid::Pyramid;
pub use spline_error::SplineError;

/// The largest coefficient. A mixed third difference along three axes is at most `8³ = 2⁹` times
/// as large, so no derivative overflows.
const LARGEST: f64 = f64::from_bits((1023 + 1000) << 52);

/// A tensor product of uniform cubic B-splines on one to three axes, defined on all of `R^E`.
///
/// The [module](self) documents the function. It is made by [`new`](Self::new) from coefficients,
/// or by [`interpolating`](Self::interpolating) from samples.
///
/// # Memory
///
/// The coefficients, 8 bytes each. The first enclosure over many cells adds, for its orders, a
/// pyramid of about 1.4 bytes per coefficient with two axes (6 with one, 0.3 with three). A picture
/// of 512 × 512 takes 2.1 MB, and with the six pyramids of value, gradient and Hessian 4.2 MB.
/// [`memory`](Self::memory) tells. Clones copy everything, so share a spline through an `Arc`.
///
/// # Equality
///
/// Splines are equal if their shapes and the bits of their coefficients are: `0` and `−0` differ.
#[derive(Clone)]
pub struct Spline {
    /// The count of axes, 1 to 3.
    pub(crate) axes: usize,
    /// The lengths of the last `axes` axes, after as many ones as are missing to three.
    pub(crate) lengths: [usize; 3],
    // Invariant: as many as the product of the lengths, and each at most LARGEST.
    pub(crate) coefficients: Box<[f64]>,
    fingerprint: u64,
    /// One for each triple of orders 0 to 3.
    pyramids: Box<[OnceLock<Pyramid>; 64]>,
}

impl Spline {
    /// Returns the spline with these coefficients.
    ///
    /// `shape` is the count of coefficients along each axis. The last axis is the fastest one, as
    /// in C and NumPy. With samples as coefficients, the spline smooths them: its values lie
    /// between the nearest samples, so it is positive and monotone where they are.
    ///
    /// # Errors
    ///
    /// [`SplineError`] if the shape has no axis, more than three or an empty one; if the count of
    /// coefficients is not the product of its lengths; or for a coefficient that is not finite or
    /// beyond `2¹⁰⁰⁰`.
    pub fn new(shape: &[usize], coefficients: Vec<f64>) -> Result<Self, SplineError> {
        check(shape, &coefficients)?;
        let axes = shape.len();
        let mut lengths = [1; 3];
        lengths[3 - axes..].copy_from_slice(shape);
        let words = coefficients.iter().map(|c| c.to_bits());
        let fingerprint = fingerprint(shape.iter().map(|&n| n as u64).chain(words), axes as u64);
        let pyramids = Box::new([const { OnceLock::new() }; 64]);
        let coefficients = coefficients.into_boxed_slice();
        Ok(Self { axes, lengths, coefficients, fingerprint, pyramids })
    }

    /// Returns the count of coefficients along each axis.
    #[must_use]
    pub fn shape(&self) -> &[usize] {
        &self.lengths[3 - self.axes..]
    }

    /// Returns the coefficients; the last axis is the fastest one.
    #[must_use]
    pub fn coefficients(&self) -> &[f64] {
        &self.coefficients
    }

    /// Returns 64 bits that depend on the shape and the bits of all coefficients, the same on every
    /// machine. Equal splines have the same fingerprint. Others have the same one by accident, or
    /// if somebody looks for such a pair.
    #[must_use]
    pub fn fingerprint(&self) -> u64 {
        self.fingerprint
    }

    /// Returns the memory that the spline takes at present, in bytes. It grows with the first
    /// enclosure over many cells of each combination of orders.
    #[must_use]
    pub fn memory(&self) -> usize {
        let pyramids = self.pyramids.iter().filter_map(OnceLock::get).map(Pyramid::memory);
        mem::size_of::<Self>()
            + mem::size_of_val(&*self.coefficients)
            + mem::size_of_val(&*self.pyramids)
            + pyramids.sum::<usize>()
    }

    /// Returns the pyramid over the differences of these orders, each at most 3, and builds it if
    /// this is the first call.
    pub(crate) fn pyramid(&self, orders: [usize; 3]) -> &Pyramid {
        let at = 16 * orders[0] + 4 * orders[1] + orders[2];
        self.pyramids[at].get_or_init(|| Pyramid::new(self, orders))
    }

    /// Returns the orders of the three inner axes, the last `axes` of which are those of the
    /// spline. `None` if the derivative is zero everywhere: beyond order 3, and along an axis that
    /// the spline does not have.
    pub(crate) fn inner_orders(&self, orders: [u8; 3]) -> Option<[usize; 3]> {
        let (own, others) = orders.split_at(self.axes);
        if others.iter().any(|&order| order > 0) || own.iter().any(|&order| order > 3) {
            return None;
        }
        let mut inner = [0; 3];
        for (inner, &order) in inner[3 - self.axes..].iter_mut().zip(own) {
            *inner = usize::from(order);
        }
        Some(inner)
    }
}

/// Checks what [`Spline::new`] asks of a shape and its numbers.
pub(crate) fn check(shape: &[usize], numbers: &[f64]) -> Result<(), SplineError> {
    let of = || shape.to_vec();
    if !(1..=3).contains(&shape.len()) {
        return Err(SplineError::Axes { shape: of() });
    }
    if let Some(axis) = shape.iter().position(|&length| length == 0) {
        return Err(SplineError::EmptyAxis { axis, shape: of() });
    }
    let product = shape.iter().try_fold(1_usize, |product, &n| product.checked_mul(n));
    let expected = product.ok_or_else(|| SplineError::Overflow { shape: of() })?;
    if numbers.len() != expected {
        return Err(SplineError::Count { shape: of(), expected, found: numbers.len() });
    }
    // Written so that NaN is found.
    let Some(at) = numbers.iter().position(|c| !(c.abs() <= LARGEST)) else {
        return Ok(());
    };
    let (index, value) = (position(shape, at), numbers[at]);
    Err(if value.is_finite() {
        SplineError::TooLarge { index, value }
    } else {
        SplineError::NotFinite { index, value }
    })
}

/// Returns the position along each axis of the number at place `at`.
fn position(shape: &[usize], mut at: usize) -> Vec<usize> {
    let mut index = shape.to_vec();
    for (index, &length) in index.iter_mut().zip(shape).rev() {
        *index = at % length;
        at /= length;
    }
    index
}

/// Mixes words by the finaliser of SplitMix64 (Steele, Lea and Flood, 2014), which maps 64 bits to
/// 64 bits one to one. A change of one word therefore always changes the result.
fn fingerprint(words: impl Iterator<Item = u64>, start: u64) -> u64 {
    words.fold(start, |hash, word| {
        let z = (hash ^ word).wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    })
}

impl PartialEq for Spline {
    fn eq(&self, other: &Self) -> bool {
        let mut pairs = self.coefficients.iter().zip(&other.coefficients);
        self.fingerprint == other.fingerprint
            && self.shape() == other.shape()
            && pairs.all(|(a, b)| a.to_bits() == b.to_bits())
    }
}

impl Eq for Spline {}

impl Hash for Spline {
    fn hash<H: Hasher>(&self, state: &mut H) {
        state.write_u64(self.fingerprint);
    }
}

impl fmt::Debug for Spline {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "Spline({:?}, {:016x})", self.shape(), self.fingerprint)
    }
}
