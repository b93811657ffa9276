"""One level of the proof."""

import numpy as np

from intervals import INF, Interval, add_down, of, up
from kuhn import bounds, least, simplices
from level_sets import LevelSets
from metric import curvature, dual_square, eliminated, gram, positive
from sets import distance_below, on_piece
from work import UNLIMITED, batches

# How often the level sets are made from the simplices that are left.
ROUNDS = 10

# The most cubes that are looked at together.
MOST_CUBES = 1 << 12


class Sweep:
    def __init__(self, formula, sets, level, work=UNLIMITED):
        n, side = level.dimension, level.side
        self.level, self.simplices = level, simplices(n)
        evaluations = 2**n + (n + 1) * (n + 2) // 2
        pieces = sum(map(len, sets))
        work.spend((evaluations * formula.weight + pieces) * len(level.cubes))
        self.low = [level.cubes[:, i] * side for i in range(n)]
        points, numbers = level.numbers(1)
        h = gram(formula, [of(x * side) for x in points])
        of_batches = []
        for part in batches(len(level.cubes), MOST_CUBES):
            box = [Interval(low[part], low[part] + side) for low in self.low]
            shift = up(curvature(formula, box) * (side**2 / 8))
            corners = [{ij: e[at] for ij, e in h.items()} for at in numbers[:, part]]
            # Where a shift is too large for the vertex test, H may still have bounds on the whole
            # cube.
            good = np.all([positive(h, n, of(shift)) for h in corners], axis=0)
            if not good.all():
                bad, whole = np.flatnonzero(~good), gram(formula, [x[~good] for x in box])
                shift = np.where(good, shift, 0)
                for corner in corners:
                    for ij, e in corner.items():
                        e.lo[bad], e.hi[bad] = whole[ij].lo, whole[ij].hi
            tests = [eliminated(h, n, of(shift)) for h in corners]
            of_batches.append(self.tested(level.values(part), tests))
        self.ranges, self.q, self.sum = (np.concatenate(found, -1) for found in zip(*of_batches))
        self.meetings = [self.meet(pieces, own, work) for own, pieces in enumerate(sets)]

    def tested(self, values, tests):
        """For φ and ψ on each simplex of some cubes their ranges, the largest squares of their
        gradients, and the least values of the sum."""
        ranges, q, sums = [], [], []
        for simplex in self.simplices:
            forms = [simplex.bernstein(v) for v in values]
            ranges.append([bounds(form) for form in forms])
            q.append([self.largest(simplex, v, tests) for v in values])
            sums.append(least({ij: b + forms[1][ij] for ij, b in forms[0].items()}))
        return np.moveaxis(ranges, 1, 0), np.moveaxis(q, 1, 0), np.array(sums)

    def largest(self, simplex, values, tests):
        q = 0
        for k in range(len(simplex.axes) + 1):
            p = simplex.gradient(values, k, self.level.side)
            q = np.maximum(q, dual_square(tests[simplex.corner(k)], p))
        return q

    def meet(self, pieces, own, work):
        """For each simplex of each cube, whether a set may meet it, an upper bound on the set's own
        function there and a lower bound on the other one."""
        shape = self.sum.shape
        met, most, least_ = np.zeros(shape, bool), np.full(shape, -INF), np.full(shape, INF)
        for piece in pieces:
            for part in batches(shape[1], MOST_CUBES):
                box = [Interval(low[part], low[part] + self.level.side) for low in self.low]
                near = part.start + np.flatnonzero(~(distance_below([piece], box) > 0))
                if not near.size:
                    continue
                sides = 2 * len(self.low) if piece[0] == "box" else 1
                work.spend(64 * len(self.simplices) * sides * near.size)
                low, values = [x[near] for x in self.low], self.level.values(near)
                for s, simplex in enumerate(self.simplices):
                    forms = [simplex.bernstein(values[i]) for i in (own, 1 - own)]
                    meets, (mine, other) = on_piece(piece, simplex, low, self.level.side, forms)
                    # Of several pieces in a simplex all count.
                    at = near[meets]
                    met[s, at] = True
                    most[s, at] = np.maximum(most[s, at], mine[1][meets])
                    least_[s, at] = np.minimum(least_[s, at], other[0][meets])
        return met, most, least_

    def functions(self, kept, start, end):
        def function(i):
            lo, hi = self.ranges[i][:, 0], self.ranges[i][:, 1]
            return LevelSets(lo[kept], hi[kept], self.q[i][kept], start[i], end[i])

        return function(0), function(1)

    def shorter_than(self, hi):
        """A lower bound on the length of curves in the cubes, or hi, and which cubes curves shorter
        than hi may meet."""
        kept, lower = np.ones(self.sum.shape, bool), 0.0
        for _ in range(ROUNDS):
            start, end = [0, 0], [0, 0]
            for i, (met, own, other) in enumerate(self.meetings):
                there = kept & met
                if not there.any():
                    return hi, np.zeros(kept.shape[1], bool)
                start[i], end[1 - i] = own[there].max(), other[there].min()
            f, g = self.functions(kept, start, end)
            lower = max(lower, float(f.below(end[0])), float(g.below(end[1])))
            (a, b), (c, d) = (self.ranges[i].swapaxes(0, 1) for i in (0, 1))
            apart = add_down(f.below(a), g.below(c))
            together = add_down(add_down(self.sum, -f.excess(b)), -g.excess(d))
            left = kept & ~((apart >= hi) | (together >= hi))
            if (left == kept).all():
                break
            kept = left
        return min(lower, hi) if kept.any() else hi, kept.any(axis=0)

    def to_the_boundary(self, ignored):
        """Lower bounds on the lengths from each set to a boundary facet of the cubes."""
        level = self.level
        start = [own[met].max(initial=-INF) for met, own, _ in self.meetings]
        ends = [r[:, 1][np.isfinite(r[:, 1])].max(initial=s) for r, s in zip(self.ranges, start)]
        functions = self.functions(np.ones(self.sum.shape, bool), start, ends)
        shortest = [INF, INF]
        n = level.dimension
        for simplex in self.simplices:
            # Without its last corner, a simplex lies in the low face of its last axis; without its
            # first one, in the high face of its first axis.
            for k, axis, step in ((n, simplex.axes[-1], -1), (0, simplex.axes[0], 1)):
                beside = level.cubes + step * np.eye(n, dtype=np.int64)[axis]
                outer = np.flatnonzero(~level.holds(beside))
                for part in batches(len(outer), MOST_CUBES):
                    at = outer[part]
                    low, values = [x[at] for x in self.low], level.values(at)
                    counts = np.logical_not(ignored(simplex, k, low, level.side))
                    for i, function in enumerate(functions):
                        form = simplex.bernstein(values[i])
                        lo = bounds({ij: b for ij, b in form.items() if k not in ij})[0]
                        least_there = function.below(lo)[np.broadcast_to(counts, lo.shape)]
                        shortest[i] = min(shortest[i], least_there.min(initial=INF))
        return shortest
