"""Tables: arrays as cubic splines, and bounds on their derivatives over boxes."""

import itertools

import numpy as np

from intervals import Interval, of
from jets import Jet, jet, plus, times, upper
from work import batches

# A box over more cells gets the range of the coefficients that meet it.
MOST_CELLS = 16

# The most arguments of polar forms that are looked at together.
MOST_ARGUMENTS = 1 << 14


class Table:
    """The spline with these coefficients, which go on beyond the array as at its border."""

    def __init__(self, coefficients):
        self.coefficients, self.differences = coefficients, {}

    def __call__(self, orders, u):
        """Bounds on a partial derivative over boxes; NaN where a box or the derivative has none."""
        shape = np.broadcast_shapes(*(side.lo.shape for side in u))
        lo, hi = (
            np.array([np.broadcast_to(getattr(side, end), shape).ravel() for side in u])
            for end in ("lo", "hi")
        )
        low, high = np.full(lo.shape[1:], np.nan), np.full(lo.shape[1:], np.nan)
        known = ~(np.isnan(lo) | np.isnan(hi)).any(axis=0)
        if sum(orders) > 3:
            # Third derivatives jump from cell to cell, and are smooth in each.
            n = np.array(self.coefficients.shape)[:, None]
            known &= ((hi <= np.floor(lo) + 1) | (hi <= -1) | (lo >= n)).all(axis=0)
        if max(orders) > 3:
            low[known] = high[known] = 0.0
            return Interval(low.reshape(shape), high.reshape(shape))
        lo, hi, first, last = self.cells(orders, lo[:, known], hi[:, known])
        few = np.prod(last - first + 1, axis=0) <= MOST_CELLS
        found = Interval(np.empty(few.shape), np.empty(few.shape))
        near = self.over_cells(orders, lo[:, few], hi[:, few], first[:, few], last[:, few])
        found.lo[few], found.hi[few] = near.lo, near.hi
        far = self.over_coefficients(orders, first[:, ~few], last[:, ~few])
        found.lo[~few], found.hi[~few] = far.lo, far.hi
        low[known], high[known] = found.lo, found.hi
        return Interval(low.reshape(shape), high.reshape(shape))

    def cells(self, orders, lo, hi):
        """The sides without what lies far beyond the array, and the cells that they meet."""
        end = np.array(self.coefficients.shape)[:, None] + 1.0
        lo, hi = np.clip(lo, -2.0, end), np.clip(hi, -2.0, end)
        # A cell that only touches a side counts if the derivative jumps.
        jumps = np.array(orders)[:, None] == 3
        first = np.where(jumps, np.ceil(lo) - 1, np.floor(lo))
        last = np.where(jumps, np.floor(hi), np.maximum(first, np.ceil(hi) - 1))
        return lo, hi, first.astype(int), last.astype(int)

    def over_cells(self, orders, lo, hi, first, last):
        """The least and the greatest Bernstein coefficient on the parts of the cells."""
        low, high = np.full(lo.shape[1], np.inf), np.full(lo.shape[1], -np.inf)
        boxes, cells = meetings(first, last)
        # Of the arguments along an axis, so many are the upper end, the others the lower one.
        choices = [range(4 - order) for order in orders]
        ahead = np.array(list(itertools.product(*choices))).T
        for part in batches(len(boxes) * ahead.shape[1], MOST_ARGUMENTS):
            at, choice = np.divmod(
                np.arange(part.start, min(part.stop, len(boxes) * ahead.shape[1])), ahead.shape[1]
            )
            box, cell, t = boxes[at], cells[:, at], []
            for axis, order in enumerate(orders):
                ends = [clamped(of(side[axis, box]) - cell[axis]) for side in (lo, hi)]
                lower = 3 - order - ahead[axis, choice]
                t.append([ends[0].where(k < lower, ends[1]) for k in range(3 - order)])
            value = self.blossom(orders, cell, t, ())
            np.minimum.at(low, box, value.lo)
            np.maximum.at(high, box, value.hi)
        return Interval(low, high)

    def blossom(self, orders, cell, t, known):
        """The polar form on cells at these arguments, one axis after the other."""
        axis = len(known)
        if axis == len(orders):
            return of(self.coefficients[known])
        n = self.coefficients.shape[axis]
        places = [np.clip(cell[axis] + k, 0, n - 1) for k in range(-1, 3)]
        values = [self.blossom(orders, cell, t, (*known, place)) for place in places]
        for _ in range(orders[axis]):
            values = [b - a for a, b in itertools.pairwise(values)]
        # De Boor's algorithm on integer knots: the span of the coefficients at (i, i + degree).
        for s in t[axis]:
            degree = len(values) - 1
            left = [(s + (degree - 1 - i)) / degree for i in range(degree)]
            right = [(-s + (1 + i)) / degree for i in range(degree)]
            values = [r * a + l * b for l, r, a, b in zip(left, right, values, values[1:])]
        return values[0]

    def over_coefficients(self, orders, first, last):
        """The range of the coefficients, or of their differences, that meet the cells."""
        if orders not in self.differences:
            padded = Interval(np.pad(self.coefficients, 6, mode="edge"))
            for axis, order in enumerate(orders):
                for _ in range(order):
                    padded = padded[cut(axis, 1, None)] - padded[cut(axis, 0, -1)]
            self.differences[orders] = padded
        all_, rows = self.differences[orders], []
        for a, b in zip(first.T, last.T):
            box = tuple(slice(i + 5, j + 9 - o) for i, j, o in zip(a, b, orders))
            rows.append((all_.lo[box].min(), all_.hi[box].max()))
        rows = np.array(rows).reshape(-1, 2)
        return Interval(rows[:, 0], rows[:, 1])


def meetings(first, last):
    """The pairs of a box and a cell that it meets, by the first and the last cell of each box."""
    counts = (last - first).max(axis=1, initial=-1) + 1
    boxes, cells = [np.zeros(0, int)], [np.zeros((len(first), 0), int)]
    for offset in itertools.product(*map(range, counts)):
        cell = first + np.array(offset)[:, None]
        meets = np.flatnonzero((cell <= last).all(axis=0))
        boxes.append(meets)
        cells.append(cell[:, meets])
    return np.concatenate(boxes), np.concatenate(cells, axis=1)


def cut(axis, start, end):
    return (slice(None),) * axis + (slice(start, end),)


def clamped(t):
    """The part of [0, 1]."""
    return Interval(np.clip(t.lo, 0.0, 1.0), np.clip(t.hi, 0.0, 1.0))


def tabulated(table, orders, u):
    """A partial derivative of a table at intervals, or at jets with its first two derivatives."""
    if not any(isinstance(x, Jet) for x in u):
        return table(orders, [of(x) for x in u])
    like = next(x for x in u if isinstance(x, Jet))
    u = [jet(x, like) for x in u]
    n, axes, at = len(like.first), range(len(u)), [x.value for x in u]

    def along(*raised):
        return table(tuple(o + raised.count(a) for a, o in enumerate(orders)), at)

    slopes = [along(a) if any(f is not None for f in u[a].first) else None for a in axes]
    first, second = [None] * n, {}
    for i in range(n):
        for a in axes:
            first[i] = plus(first[i], times(u[a].first[i], slopes[a]))
    for a, b in itertools.product(axes, axes):
        if a <= b and slopes[a] is not None and slopes[b] is not None:
            bend = along(a, b)
            for i, j in upper(n):
                both = times(u[a].first[i], u[b].first[j])
                if a != b:
                    both = plus(both, times(u[b].first[i], u[a].first[j]))
                elif i == j and u[a].first[i] is not None:
                    both = u[a].first[i].sqr()
                second[i, j] = plus(second.get((i, j)), times(both, bend))
    for a in axes:
        for ij, bent in u[a].second.items():
            second[ij] = plus(second.get(ij), times(bent, slopes[a]))
    return Jet(table(orders, at), first, second)
