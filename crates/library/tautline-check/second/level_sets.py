"""Rescaling by level sets: how fast a function may grow with its own values."""

import numpy as np
from flint import arb

from intervals import INF, add_down, add_up, down, up

# As in the other checker, so that both keep the same cubes.
BINS = 4096


class LevelSets:
    def __init__(self, lo, hi, q, start, end):
        step = np.float64(1.1) * (end - start) / BINS
        levels = start + step * np.arange(BINS + 1)
        ok = np.isfinite(start) and np.isfinite(end) and end > start and np.isfinite(levels).all()
        self.levels = np.unique(levels) if ok else np.zeros(1)
        count = len(self.levels) - 1
        self.slopes, self.heights = np.zeros(count), np.zeros(count + 1)
        if count:
            worst = self.worst(lo, hi, q)
            slopes = down(1 / np.maximum(up(np.sqrt(worst)), 1e-300))
            self.slopes = np.clip(np.where(worst < INF, slopes, 0), 0, 1)
            # The heights of f are exact sums; these are lower bounds.
            total = arb(0)
            for b in range(count):
                width = arb(float(self.levels[b + 1])) - arb(float(self.levels[b]))
                total += width * arb(float(self.slopes[b]))
                self.heights[b + 1] = down(float(total.lower()))
            self.heights = np.maximum(self.heights, 0)

    def worst(self, lo, hi, q):
        """The largest q of the simplices whose open range meets a bin.

        The bins of a simplex are two overlapping blocks whose length is a power of two.
        """
        count = len(self.levels) - 1
        first = np.maximum(np.searchsorted(self.levels, lo, "right") - 1, 0)
        past = np.minimum(np.searchsorted(self.levels, hi, "left"), count)
        some = past > first
        first, past, q = first[some], past[some], q[some]
        power = np.frexp(past - first)[1] - 1
        blocks = np.zeros((power.max(initial=0) + 1, count))
        np.maximum.at(blocks, (power, first), q)
        np.maximum.at(blocks, (power, past - (1 << power)), q)
        for k in range(len(blocks) - 1, 0, -1):
            half = 1 << (k - 1)
            blocks[k - 1] = np.maximum(blocks[k - 1], blocks[k])
            blocks[k - 1, half:] = np.maximum(blocks[k - 1, half:], blocks[k, :-half])
        return blocks[0]

    def below(self, t):
        """A lower bound on f(t); t is not NaN."""
        t = np.asarray(t)
        at = np.searchsorted(self.levels, t, "right") - 1
        last = len(self.slopes)
        if last == 0:
            return np.zeros(t.shape)
        b = np.clip(at, 0, last - 1)
        inside = np.where((at >= 0) & (at < last), t, self.levels[b])
        rise = down(np.maximum(add_down(inside, -self.levels[b]), 0) * self.slopes[b])
        value = np.where(at >= last, self.heights[last], add_down(self.heights[b], rise))
        return np.where(at < 0, 0, np.maximum(value, 0))

    def excess(self, t):
        """An upper bound on t − f(t), which does not decrease."""
        return add_up(np.asarray(t), -self.below(t))
