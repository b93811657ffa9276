//! `Front`: how far an elimination from an end has come.

use nalgebra::{SMatrix, SVector};
use tautline_discretizations::{ChordModel, CompensatedSum};
use tautline_metrics::{Lanes, Pair};

use crate::newton::{
    end_frame::{EndFrame, EndRow},
    factorization::{Pivot, Regulariser},
    ldl::Ldl,
    residual::Residual,
};

/// The block row of a point, as far as it is known.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Row<const D: usize, T = f64> {
    /// The diagonal block; its entries `i ≥ j` count.
    block: SMatrix<T, D, D>,
    /// The right hand side.
    right: SVector<T, D>,
    /// The gradient by the point, of which nothing is eliminated.
    pub(crate) gradient: SVector<T, D>,
}

/// The point that an elimination from an end has come to, and the sums on the way there. With pairs
/// of numbers, of two eliminations side by side.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Front<const D: usize, T = f64> {
    /// From the chord behind and from what is eliminated.
    pub(crate) row: Row<D, T>,
    /// Of the chords behind, in `m²`.
    pub(crate) energy: CompensatedSum<T>,
    /// `N tr H` of the chords behind, in `m²/ℓ²`.
    pub(crate) trace: T,
    /// `Σ yₙᵀ Dₙ⁻¹ yₙ` over what is eliminated, in `m²`.
    pub(crate) square: T,
    /// `Σ |gₙ|²` over the inner points behind, divided by the square of the unit of the [`Residual`].
    pub(crate) inner: T,
    /// Whether the metric is one at every node behind.
    pub(crate) is_metric: bool,
}

/// The point ahead, by the chord that leads there: its row, and the block in it that has the columns
/// of the point behind.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ahead<const D: usize, T = f64> {
    pub(crate) row: Row<D, T>,
    lower: SMatrix<T, D, D>,
}

impl<T: Lanes, const D: usize> Front<D, T> {
    /// At the end itself, where nothing is behind.
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

    /// Adds the chord ahead to the row.
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

    /// Counts the point that it has come to as an inner one.
    #[inline(always)]
    pub(crate) fn count(&mut self, residual: &Residual<D>) {
        self.inner += residual.square(&self.row.gradient);
    }

    /// Eliminates the row and goes ahead; returns the pivot and `zₙ`. `None` if the Hessian is not
    /// positive definite.
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
    /// Adds what is known of the same point from its other side.
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
    /// Goes over to the coordinates of the end at which it is.
    pub(crate) fn enter(&mut self, frame: &EndFrame<D>, ahead: &mut Ahead<D>, tau: f64) {
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

    /// The last row; returns its pivot and `z`, and adds to the square.
    pub(crate) fn finish(&mut self) -> Option<(Ldl<D>, SVector<f64, D>)> {
        let last = Ldl::new(&self.row.block)?;
        let [y, z] = last.forward(self.row.right);
        self.square += y.dot(&z);
        Some((last, z))
    }
}

impl<const D: usize> Ahead<D> {
    /// Goes over to the coordinates of the end that is ahead.
    pub(crate) fn enter(&mut self, frame: &EndFrame<D>, front: &mut Front<D>, tau: f64) {
        self.row.enter(frame, &mut self.lower, &mut front.row.right, tau);
    }
}

impl<const D: usize> Row<D> {
    /// Goes over to the coordinates of the end to which it belongs; `coupling` has its rows, and
    /// `beside` is the right hand side of the neighbour.
    fn enter(
        &mut self,
        frame: &EndFrame<D>,
        coupling: &mut SMatrix<f64, D, D>,
        beside: &mut SVector<f64, D>,
        tau: f64,
    ) {
        // The frame has the force of the end itself; what a neighbour in a frame has added stays.
        let right = self.right + self.gradient;
        let row = EndRow { block: self.block, coupling: *coupling, right, beside: *beside };
        let row = frame.enter(row, tau);
        (self.block, self.right) = (row.block, row.right);
        (*coupling, *beside) = (row.coupling, row.beside);
    }
}

/// Two side by side.
fn pair_rows<const D: usize>(rows: [&Row<D>; 2]) -> Row<D, Pair> {
    let [one, other] = rows;
    Row {
        block: one.block.zip_map(&other.block, Pair::new),
        right: one.right.zip_map(&other.right, Pair::new),
        gradient: one.gradient.zip_map(&other.gradient, Pair::new),
    }
}

impl<const D: usize> Front<D, Pair> {
    /// Returns the two.
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

    /// Goes over to the coordinates of the two ends at which they are.
    pub(crate) fn enter(
        &mut self,
        frames: [&EndFrame<D>; 2],
        ahead: &mut Ahead<D, Pair>,
        tau: f64,
    ) {
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
