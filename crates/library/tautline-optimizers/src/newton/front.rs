//! `Front`: the state of an elimination from one end.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{ChordModel, CompensatedSum};
use tautline_metrics::{Lanes, Pair};

use crate::newton::{
    arithmetic::ldl::Ldl,
    end_frame::EndFrame,
    factorization::{Pivot, Regulariser},
    residual::Scale,
};

/// The block row of a point, as far as it is assembled.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<const D: usize, T = f64> {
    /// The diagonal block, stored in its lower triangle `i ≥ j`.
    block: SMatrix<T, D, D>,
    /// The right hand side.
    right: SVector<T, D>,
    /// The gradient with respect to the point, without elimination.
    pub(crate) gradient: SVector<T, D>,
}

/// The point that an elimination has reached, and the sums accumulated on the way there. For pairs
/// of numbers, these are two eliminations side by side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Front<const D: usize, T = f64> {
    /// The contributions of the chord behind and of the eliminated points.
    pub(crate) row: Row<D, T>,
    /// The energy of the chords behind, in `m²`.
    pub(crate) energy: CompensatedSum<T>,
    /// `N tr H` of the chords behind, in `m²/ℓ²`.
    pub(crate) trace: T,
    /// `Σ yₙᵀ Dₙ⁻¹ yₙ` over the eliminated points, in `m²`.
    pub(crate) square: T,
    /// `Σ |gₙ|²` over the inner points behind, divided by the square of the unit of the
    /// [`Residual`](crate::newton::residual::Residual).
    pub(crate) inner: T,
    /// Whether the metric is positive definite at every node behind.
    pub(crate) is_metric: bool,
}

/// The contribution of a chord to the point ahead: its row, and the block in the columns of the
/// point behind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ahead<const D: usize, T = f64> {
    pub(crate) row: Row<D, T>,
    lower: SMatrix<T, D, D>,
}

impl<T: Lanes, const D: usize> Front<D, T> {
    /// Returns the front that begins at the end itself.
    pub(crate) fn new(regulariser: Regulariser) -> Self {
        let block = SMatrix::from_diagonal_element(T::constant(regulariser.of_end()));
        Self {
            row: Row { block, right: SVector::zeros(), gradient: SVector::zeros() },
            energy: CompensatedSum::default(),
            trace: T::zero(),
            square: T::zero(),
            inner: T::zero(),
            is_metric: true,
        }
    }

    /// Adds the chord ahead to the row of the current point.
    #[inline(always)]
    pub(crate) fn add(
        &mut self,
        chord: &ChordModel<D, T>,
        regulariser: Regulariser,
    ) -> Ahead<D, T> {
        let shifted = |mut matrix: SMatrix<T, D, D>, shift: f64| {
            for i in 0..D {
                matrix[(i, i)] += T::constant(shift);
            }
            matrix
        };
        let ([near, far], own) = (chord.gradient, regulariser.of_chord());
        self.row.block += shifted(chord.hessian[0], own);
        self.row.right -= near;
        self.row.gradient += near;
        self.energy.add(chord.energy);
        self.trace += chord.trace;
        let row = Row { block: shifted(chord.hessian[1], own), right: -far, gradient: far };
        Ahead { row, lower: shifted(chord.coupling.transpose(), regulariser.upper()) }
    }

    /// Counts the current point as an inner one.
    #[inline(always)]
    pub(crate) fn count(&mut self, scale: Scale) {
        self.inner += scale.square(&self.row.gradient);
    }

    /// Eliminates the row and moves to the point ahead; returns the pivot and `zₙ`. The result is
    /// `None` if the Hessian is not positive definite.
    #[inline(always)]
    pub(crate) fn advance(
        &mut self,
        Ahead { mut row, lower }: Ahead<D, T>,
    ) -> Option<(Pivot<D, T>, SVector<T, D>)> {
        let pivot = Pivot::new(&self.row.block, &lower, &mut row.block)?;
        let [y, z] = pivot.forward(self.row.right, &mut row.right);
        self.square += y.dot(&z);
        self.row = row;
        Some((pivot, z))
    }
}

impl<T: Lanes, const D: usize> Row<D, T> {
    /// Adds the row of the same point as assembled from its other side.
    pub(crate) fn join(&mut self, other: &Self) {
        self.block += other.block;
        self.right += other.right;
        self.gradient += other.gradient;
    }

    fn lane(&self, lane: usize) -> Row<D> {
        Row {
            block: self.block.map(|x| x.lane(lane)),
            right: self.right.map(|x| x.lane(lane)),
            gradient: self.gradient.map(|x| x.lane(lane)),
        }
    }
}

impl<const D: usize> Front<D> {
    /// Transforms the current point, which is an end, to the coordinates of its frame.
    pub(crate) fn enter(&mut self, frame: &EndFrame, ahead: &mut Ahead<D>, tau: f64) {
        let mut coupling = ahead.lower.transpose();
        self.row.enter(frame, &mut coupling, &mut ahead.row.right, tau);
        ahead.lower = coupling.transpose();
    }

    /// Adds the sums of an elimination from the other end.
    pub(crate) fn add_sums(&mut self, other: &Self) {
        self.energy += other.energy;
        self.trace += other.trace;
        self.square += other.square;
        self.inner += other.inner;
        self.is_metric &= other.is_metric;
    }

    /// Eliminates the last row, and returns its pivot and `z`.
    pub(crate) fn finish(&mut self) -> Option<(Ldl<D>, SVector<f64, D>)> {
        let last = Ldl::new(&self.row.block)?;
        let [y, z] = last.forward(self.row.right);
        self.square += y.dot(&z);
        Some((last, z))
    }
}

impl<const D: usize> Ahead<D> {
    /// Transforms the point ahead, which is an end, to the coordinates of its frame.
    pub(crate) fn enter(&mut self, frame: &EndFrame, front: &mut Front<D>, tau: f64) {
        self.row.enter(frame, &mut self.lower, &mut front.row.right, tau);
    }
}

impl<const D: usize> Row<D> {
    /// Transforms the row of an end to the coordinates of its frame. `coupling` has the rows of the
    /// end, and `beside` is the right hand side of the neighbour.
    fn enter(
        &mut self,
        frame: &EndFrame,
        coupling: &mut SMatrix<f64, D, D>,
        beside: &mut SVector<f64, D>,
        tau: f64,
    ) {
        // The frame supplies the force at the end, while the contribution of a fixed neighbour
        // stays.
        self.right += self.gradient;
        frame.enter(
            self.block.as_mut_slice(),
            coupling.as_mut_slice(),
            [self.right.as_mut_slice(), beside.as_mut_slice()],
            tau,
        );
    }
}

/// Combines two rows into one of pairs.
fn pair_rows<const D: usize>(rows: [&Row<D>; 2]) -> Row<D, Pair> {
    let [one, other] = rows;
    Row {
        block: one.block.zip_map(&other.block, Pair::new),
        right: one.right.zip_map(&other.right, Pair::new),
        gradient: one.gradient.zip_map(&other.gradient, Pair::new),
    }
}

impl<const D: usize> Front<D, Pair> {
    /// Returns the two eliminations separately.
    pub(crate) fn apart(&self) -> [Front<D>; 2] {
        let energies = self.energy.apart();
        [0, 1].map(|lane| Front {
            row: self.row.lane(lane),
            energy: energies[lane],
            trace: self.trace.lane(lane),
            square: self.square.lane(lane),
            inner: self.inner.lane(lane),
            is_metric: self.is_metric,
        })
    }

    /// Transforms the current points, which are the two ends, to the coordinates of their frames.
    pub(crate) fn enter(&mut self, frames: [&EndFrame; 2], ahead: &mut Ahead<D, Pair>, tau: f64) {
        let mut fronts = self.apart();
        let mut both = [0, 1].map(|lane| Ahead {
            row: ahead.row.lane(lane),
            lower: ahead.lower.map(|x| x.lane(lane)),
        });
        for ((front, ahead), frame) in fronts.iter_mut().zip(&mut both).zip(frames) {
            front.enter(frame, ahead, tau);
        }
        self.row = pair_rows([&fronts[0].row, &fronts[1].row]);
        ahead.row = pair_rows([&both[0].row, &both[1].row]);
        ahead.lower = both[0].lower.zip_map(&both[1].lower, Pair::new);
    }
}
