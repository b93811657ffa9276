//! `Pyramid`: the ranges of the differences over blocks of them, for the range over any box.

use std::mem;

use super::{Spline, stencil::Stencil};

/// The bounds `lo` and `hi` on some numbers.
type Range = (f64, f64);

/// The range of no numbers, which every range contains.
const NOTHING: Range = (f64::INFINITY, f64::NEG_INFINITY);

/// The count of differences along each side of the smallest blocks. Blocks are twice as long on
/// each further level.
const BLOCK: usize = 4;

/// The ranges of the differences of given orders over blocks.
///
/// Along an axis of `n` coefficients with order `a`, the differences that may differ from zero, or
/// from each other if `a = 0`, have the numbers `1 − a` to `n − 2`. The pyramid has one more at
/// each end, `−a` and `n − 1`, which stand for all beyond: `n + a` differences.
#[derive(Clone)]
pub(crate) struct Pyramid {
    orders: [usize; 3],
    /// The count of differences along each axis.
    counts: [usize; 3],
    /// From the smallest blocks to a single one.
    levels: Vec<Level>,
}

/// Blocks of one size.
#[derive(Clone)]
struct Level {
    /// The count of differences along the sides of a block.
    size: usize,
    /// The count of blocks along each axis.
    blocks: [usize; 3],
    ranges: Vec<Range>,
}

/// The numbers of differences from `from` to `to` along each axis, both included.
#[derive(Clone, Copy)]
struct Window {
    from: [usize; 3],
    to: [usize; 3],
}

impl Window {
    /// Calls `visit` for each position in the window.
    fn each(self, mut visit: impl FnMut([usize; 3])) {
        for i in self.from[0]..=self.to[0] {
            for j in self.from[1]..=self.to[1] {
                for k in self.from[2]..=self.to[2] {
                    visit([i, j, k]);
                }
            }
        }
    }

    /// Returns the common part, or `None` if there is none.
    fn common(self, other: Self) -> Option<Self> {
        let from: [usize; 3] = std::array::from_fn(|axis| self.from[axis].max(other.from[axis]));
        let to: [usize; 3] = std::array::from_fn(|axis| self.to[axis].min(other.to[axis]));
        (0..3).all(|axis| from[axis] <= to[axis]).then_some(Self { from, to })
    }
}

impl Level {
    fn new(size: usize, counts: [usize; 3], mut range: impl FnMut([usize; 3]) -> Range) -> Self {
        let blocks = counts.map(|count| count.div_ceil(size));
        let mut ranges = Vec::with_capacity(blocks.iter().product());
        Window { from: [0; 3], to: blocks.map(|blocks| blocks - 1) }
            .each(|block| ranges.push(range(block)));
        Self { size, blocks, ranges }
    }

    fn range(&self, [i, j, k]: [usize; 3]) -> Range {
        self.ranges[(i * self.blocks[1] + j) * self.blocks[2] + k]
    }

    /// Returns the differences of a block, without those beyond the end of an axis.
    fn window(&self, block: [usize; 3], counts: [usize; 3]) -> Window {
        let from = block.map(|block| block * self.size);
        let to = std::array::from_fn(|axis| (from[axis] + self.size).min(counts[axis]) - 1);
        Window { from, to }
    }

    /// Returns the two blocks along each axis, or the one at the end, that make up a block of the
    /// level above.
    fn parts(&self, block: [usize; 3]) -> Window {
        let from = block.map(|block| 2 * block);
        let to = std::array::from_fn(|axis| (from[axis] + 1).min(self.blocks[axis] - 1));
        Window { from, to }
    }
}

impl Pyramid {
    pub(crate) fn new(spline: &Spline, orders: [usize; 3]) -> Self {
        let first = 3 - spline.axes;
        let counts =
            std::array::from_fn(
                |axis| {
                    if axis < first { 1 } else { spline.lengths[axis] + orders[axis] }
                },
            );
        let mut pyramid = Self { orders, counts, levels: Vec::new() };
        let mut level = Level::new(BLOCK, counts, |block| {
            let from = block.map(|block| BLOCK * block);
            let to = std::array::from_fn(|axis| (from[axis] + BLOCK).min(counts[axis]) - 1);
            pyramid.directly(spline, Window { from, to })
        });
        while level.ranges.len() > 1 {
            let above = Level::new(2 * level.size, counts, |block| {
                let mut all = NOTHING;
                level.parts(block).each(|part| all = union(all, level.range(part)));
                all
            });
            pyramid.levels.push(level);
            level = above;
        }
        pyramid.levels.push(level);
        pyramid
    }

    /// Returns the memory that the ranges take, in bytes.
    pub(crate) fn memory(&self) -> usize {
        self.levels.iter().map(|level| mem::size_of_val(&*level.ranges)).sum()
    }

    /// Returns bounds on all differences.
    pub(crate) fn all(&self) -> Range {
        self.levels.last().map_or(NOTHING, |top| top.range([0; 3]))
    }

    /// Returns bounds on the differences with the numbers `from` to `to`, both included, where a
    /// number beyond the ends stands for the one there.
    pub(crate) fn range(&self, spline: &Spline, from: [isize; 3], to: [isize; 3]) -> Range {
        let place = |number: [isize; 3]| {
            std::array::from_fn(|axis| {
                let place = number[axis].saturating_add(self.orders[axis] as isize);
                place.clamp(0, self.counts[axis] as isize - 1) as usize
            })
        };
        let window = Window { from: place(from), to: place(to) };
        let mut found = NOTHING;
        self.search(spline, window, self.levels.len() - 1, [0; 3], &mut found);
        found
    }

    /// Adds the differences of a block that are in the window to what was found.
    ///
    /// Blocks inside the window come first. A block at its border need not be looked into if its
    /// range is known to be no news, and that is how most of them end.
    fn search(
        &self,
        spline: &Spline,
        window: Window,
        level: usize,
        block: [usize; 3],
        found: &mut Range,
    ) {
        let own = &self.levels[level];
        let differences = own.window(block, self.counts);
        let (Some(common), range) = (window.common(differences), own.range(block)) else {
            return;
        };
        if found.0 <= range.0 && range.1 <= found.1 {
            return;
        }
        if common.from == differences.from && common.to == differences.to {
            *found = union(*found, range);
            return;
        }
        let Some(below) = level.checked_sub(1) else {
            *found = union(*found, self.directly(spline, common));
            return;
        };
        let parts = self.levels[below].parts(block);
        parts.each(|part| {
            let differences = self.levels[below].window(part, self.counts);
            let inside = (0..3).all(|axis| {
                window.from[axis] <= differences.from[axis]
                    && differences.to[axis] <= window.to[axis]
            });
            if inside {
                *found = union(*found, self.levels[below].range(part));
            }
        });
        parts.each(|part| self.search(spline, window, below, part, found));
    }

    /// Computes bounds on the differences in a window of at most one smallest block.
    fn directly(&self, spline: &Spline, window: Window) -> Range {
        let mut all = NOTHING;
        window.each(|place| {
            let number =
                std::array::from_fn(|axis| place[axis] as isize - self.orders[axis] as isize);
            all = union(all, Stencil::new(spline, number, [1; 3], self.orders).hull());
        });
        all
    }
}

fn union(a: Range, b: Range) -> Range {
    (a.0.min(b.0), a.1.max(b.1))
}
