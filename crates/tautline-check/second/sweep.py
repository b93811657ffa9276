"""One level of the proof."""

import numpy as np

from intervals import INF, Interval, add_down, of, up
from kuhn import bounds, least, simplices
from level_sets import LevelSets
from metric import curvature, dual_square, eliminated, gram, positive
from sets import distance_below, on_piece

# How often the level sets are made from the simplices that are left.
ROUNDS = 10


class Sweep:
    def __init__(self, formula, sets, level):
        n, side = level.dimension, level.side
        self.level, self.simplices = level, simplices(n)
        self.low = [level.cubes[:, i] * side for i in range(n)]
        box = [Interval(low, low + side) for low in self.low]
        shift = up(curvature(formula, box) * (side**2 / 8))
        points, numbers = level.numbers(1)
        h = gram(formula, [of(x * side) for x in points])
        corners = [{ij: e[number] for ij, e in h.items()} for number in numbers]
        # Where a shift is too large for the vertex test, H may still have bounds on the whole cube.
        good = np.all([positive(h, n, of(shift)) for h in corners], axis=0)
        whole = (
            {ij: e.where(~good) for ij, e in gram(formula, box).items()} if not good.all() else None
        )
        shift = of(np.where(good, shift, 0))
        if whole:
            corners = [{ij: e.where(good, whole[ij]) for ij, e in h.items()} for h in corners]
        tests = [eliminated(h, n, shift) for h in corners]
        self.forms = [[s.bernstein(v) for v in level.values] for s in self.simplices]
        self.ranges = [np.array([bounds(f[i]) for f in self.forms]) for i in (0, 1)]
        self.q = [
            np.array([self.largest(s, v, tests) for s in self.simplices]) for v in level.values
        ]
        self.sum = np.array([least({ij: f[0][ij] + f[1][ij] for ij in f[0]}) for f in self.forms])
        self.meetings = [self.meet(pieces, own, box) for own, pieces in enumerate(sets)]

    def largest(self, simplex, values, tests):
        q = 0
        for k in range(len(simplex.axes) + 1):
            p = simplex.gradient(values, k, self.level.side)
            q = np.maximum(q, dual_square(tests[simplex.corner(k)], p))
        return q

    def meet(self, pieces, own, box):
        """The simplices that a set may meet, with an upper bound on the set's own function and a
        lower bound on the other one, on the set."""
        near = np.flatnonzero(~(distance_below(pieces, box) > 0))
        low, found = [x[near] for x in self.low], []
        for s, (simplex, forms) in enumerate(zip(self.simplices, self.forms)):
            forms = [{ij: b[near] for ij, b in forms[i].items()} for i in (own, 1 - own)]
            for piece in pieces:
                meets, (mine, other) = on_piece(piece, simplex, low, self.level.side, forms)
                found.append((s * len(box[0].lo) + near[meets], mine[1][meets], other[0][meets]))
        return [np.concatenate(parts) for parts in zip(*found)]

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
            for i, (simplex, own, other) in enumerate(self.meetings):
                there = kept.ravel()[simplex]
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
        start = [own.max(initial=-INF) for _, own, _ in self.meetings]
        ends = [r[:, 1][np.isfinite(r[:, 1])].max(initial=s) for r, s in zip(self.ranges, start)]
        functions = self.functions(np.ones(self.sum.shape, bool), start, ends)
        shortest = [INF, INF]
        n = level.dimension
        for simplex, forms in zip(self.simplices, self.forms):
            # Without its last corner, a simplex lies in the low face of its last axis; without its
            # first one, in the high face of its first axis.
            for k, axis, step in ((n, simplex.axes[-1], -1), (0, simplex.axes[0], 1)):
                facet = ~level.holds(level.cubes + step * np.eye(n, dtype=np.int64)[axis])
                facet &= np.logical_not(ignored(simplex, k, self.low, level.side))
                for i, function in enumerate(functions):
                    lo = bounds({ij: b for ij, b in forms[i].items() if k not in ij})[0]
                    shortest[i] = min(shortest[i], function.below(lo[facet]).min(initial=INF))
        return shortest
