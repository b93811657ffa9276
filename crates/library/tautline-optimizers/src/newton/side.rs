//! `Side`: one side of an elimination, in any dimension.

use tautline_discretizations::{ChordModels, CompensatedSum};

use crate::newton::{
    arithmetic::blocks::{Blocks, PivotMut},
    arithmetic::small::transpose,
    end_frame::EndFrame,
    factorization::Regulariser,
    residual::Scale,
};

/// The block row of a point, as far as it is assembled.
struct Row<B: Blocks> {
    /// The lower triangle `i ≥ j` of the diagonal block.
    block: B::Block,
    /// The right hand side.
    right: B::Vector,
    /// The gradient with respect to the point, without elimination.
    gradient: B::Vector,
}

/// The point that an elimination from one end has reached, the point ahead, and the sums accumulated
/// on the way there. It does what a [`Front`](crate::newton::front::Front) does, in memory of any size.
pub(crate) struct Side<B: Blocks> {
    blocks: B,
    row: Row<B>,
    /// The contribution of the chord ahead to the next point.
    ahead: Row<B>,
    /// The block of the next point in the columns of the current one.
    lower: B::Block,
    sums: Sums,
    scratch: Vec<f64>,
    y: B::Vector,
}

/// What an elimination has summed up.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Sums {
    /// The energy of the chords behind, in `m²`.
    pub(crate) energy: CompensatedSum,
    /// `N tr H` of the chords behind, in `m²/ℓ²`.
    pub(crate) trace: f64,
    /// `Σ yₙᵀ Dₙ⁻¹ yₙ` over the eliminated points, in `m²`.
    pub(crate) square: f64,
    /// `Σ |gₙ|²` over the inner points behind, divided by the square of the unit of the
    /// [`Residual`](crate::newton::residual::Residual).
    pub(crate) inner: f64,
    /// Whether the metric is positive definite at every node behind.
    pub(crate) is_metric: bool,
}

impl<B: Blocks> Side<B> {
    /// Returns the side that begins at the end itself.
    pub(crate) fn new(blocks: B, regulariser: Regulariser) -> Self {
        let d = blocks.dimension();
        let zero = || Row::<B> {
            block: blocks.block(),
            right: blocks.vector(),
            gradient: blocks.vector(),
        };
        let (mut row, ahead) = (zero(), zero());
        for i in 0..d {
            row.block.as_mut()[i * d + i] = regulariser.of_end();
        }
        let sums = Sums {
            energy: CompensatedSum::default(),
            trace: 0.0,
            square: 0.0,
            inner: 0.0,
            is_metric: true,
        };
        let (lower, scratch, y) = (blocks.block(), Vec::new(), blocks.vector());
        Self { blocks, row, ahead, lower, sums, scratch, y }
    }

    pub(crate) fn gradient(&self) -> &[f64] {
        self.row.gradient.as_ref()
    }

    pub(crate) fn gradient_ahead(&self) -> &[f64] {
        self.ahead.gradient.as_ref()
    }

    pub(crate) fn sums(&self) -> &Sums {
        &self.sums
    }

    pub(crate) fn set_metric(&mut self, is_metric: bool) {
        self.sums.is_metric &= is_metric;
    }

    /// Adds chord `k` of some models, which lies ahead, to the row of the current point.
    #[inline(always)]
    pub(crate) fn add(&mut self, models: &ChordModels, k: usize, regulariser: Regulariser) {
        let d = self.blocks.dimension();
        let size = d * d;
        let Self { row, ahead, lower, sums, .. } = self;
        let [near, far] = [0, 1].map(|end| &models.gradient(end, k)[..d]);
        let (right, gradient) = (row.right.as_mut(), row.gradient.as_mut());
        let (right_ahead, gradient_ahead) = (ahead.right.as_mut(), ahead.gradient.as_mut());
        for i in 0..d {
            right[i] -= near[i];
            gradient[i] += near[i];
            right_ahead[i] = -far[i];
            gradient_ahead[i] = far[i];
        }
        // The whole block is added, although only its lower triangle counts.
        let (block, added) = (row.block.as_mut(), &models.hessian(0, k)[..size]);
        let (block_ahead, lower) = (ahead.block.as_mut(), lower.as_mut());
        for place in 0..size {
            block[place] += added[place];
        }
        block_ahead.copy_from_slice(&models.hessian(1, k)[..size]);
        lower.copy_from_slice(&models.lower(k)[..size]);
        let (own, coupling) = (regulariser.of_chord(), regulariser.upper());
        for i in 0..d {
            let place = i * d + i;
            block[place] += own;
            block_ahead[place] += own;
            lower[place] += coupling;
        }
        sums.energy.add(models.energy(k));
        sums.trace += models.trace(k);
    }

    /// Counts the current point as an inner one.
    #[inline(always)]
    pub(crate) fn count(&mut self, scale: Scale) {
        self.sums.inner += scale.square_of(self.row.gradient.as_ref());
    }

    /// Transforms the current point, which is an end, to the coordinates of its frame.
    pub(crate) fn enter(&mut self, frame: &EndFrame, tau: f64) {
        let d = self.blocks.dimension();
        let coupling = self.lower.as_mut();
        transpose(d, coupling);
        self.row.enter(frame, coupling, self.ahead.right.as_mut(), tau);
        transpose(d, coupling);
    }

    /// Transforms the point ahead, which is an end, to the coordinates of its frame.
    pub(crate) fn enter_ahead(&mut self, frame: &EndFrame, tau: f64) {
        self.ahead.enter(frame, self.lower.as_mut(), self.row.right.as_mut(), tau);
    }

    /// Eliminates the row and moves to the point ahead; writes the pivot and `zₙ`. Returns whether the
    /// Hessian is positive definite so far.
    #[inline(always)]
    pub(crate) fn advance(&mut self, pivot: PivotMut<'_>, z: &mut [f64]) -> bool {
        let d = self.blocks.dimension();
        let size = d * d;
        let Self { blocks, row, ahead, lower, sums, scratch, y } = self;
        let PivotMut { factors, lower: scaled } = pivot;
        let (factors, scaled) = (&mut factors[..size], &mut scaled[..size]);
        let pivot = PivotMut { factors: &mut *factors, lower: &mut *scaled };
        let (schur, next) = (row.block.as_ref(), ahead.block.as_mut());
        if !blocks.eliminate(schur, lower.as_ref(), next, pivot, scratch) {
            return false;
        }
        let (y, z) = (y.as_mut(), &mut z[..d]);
        y.copy_from_slice(row.right.as_ref());
        blocks.forward(factors, y, z);
        blocks.subtract(scaled, y, ahead.right.as_mut());
        sums.square += blocks.dot(y, z);
        std::mem::swap(row, ahead);
        true
    }

    /// Adds the row of the same point as assembled from its other side, where `self` has reached it.
    pub(crate) fn join(&mut self, other: &Self) {
        self.row.join(&other.row);
    }

    /// Adds the row of the point ahead as assembled from its other side.
    pub(crate) fn join_ahead(&mut self, other: &Self) {
        self.ahead.join(&other.row);
    }

    /// Adds the sums of an elimination from the other end.
    pub(crate) fn add_sums(&mut self, other: &Self) {
        let Sums { energy, trace, square, inner, is_metric } = other.sums;
        self.sums.energy += energy;
        self.sums.trace += trace;
        self.sums.square += square;
        self.sums.inner += inner;
        self.sums.is_metric &= is_metric;
    }

    /// Eliminates the last row, and writes its factors and `z`. Returns whether it is positive definite.
    pub(crate) fn finish(&mut self, factors: &mut [f64], z: &mut [f64]) -> bool {
        let Self { blocks, row, sums, y, .. } = self;
        if !blocks.factorize(row.block.as_ref(), factors) {
            return false;
        }
        let y = y.as_mut();
        y.copy_from_slice(row.right.as_ref());
        blocks.forward(factors, y, z);
        sums.square += blocks.dot(y, z);
        true
    }
}

impl<B: Blocks> Row<B> {
    fn join(&mut self, other: &Self) {
        let add = |to: &mut [f64], from: &[f64]| {
            to.iter_mut().zip(from).for_each(|(to, from)| *to += from);
        };
        add(self.block.as_mut(), other.block.as_ref());
        add(self.right.as_mut(), other.right.as_ref());
        add(self.gradient.as_mut(), other.gradient.as_ref());
    }

    /// Transforms the row of an end to the coordinates of its frame. `coupling` has the rows of the
    /// end, and `beside` is the right hand side of the neighbour.
    fn enter(&mut self, frame: &EndFrame, coupling: &mut [f64], beside: &mut [f64], tau: f64) {
        let (block, right) = (self.block.as_mut(), self.right.as_mut());
        let d = right.len();
        for j in 0..d {
            for i in j + 1..d {
                block[i * d + j] = block[j * d + i];
            }
        }
        // The frame supplies the force at the end, while the contribution of a fixed neighbour
        // stays.
        right.iter_mut().zip(self.gradient.as_ref()).for_each(|(right, g)| *right += g);
        frame.enter(block, coupling, [right, beside], tau);
    }
}
