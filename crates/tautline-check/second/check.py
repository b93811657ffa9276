"""Checks a certificate of a distance: python3 check.py FILE.

A second checker, written from the theorems and from `../FORMAT.md`, on other intervals: numpy's
doubles rounded outward, and arb for the elementary functions (pip install numpy python-flint). It
prints what is proved; it exits with 1 and a reason if the file proves nothing.
"""

import itertools
import math
import sys
from decimal import ROUND_CEILING, ROUND_FLOOR, Context, Decimal

import numpy as np
from flint import arb

from certificate import FARTHEST, Certificate, Refused, require
from intervals import INF, Interval, Jet, add_down, add_up, down, of, up, upper

BINS, ROUNDS = 4096, 10
MOST_CUBES, MOST_BOXES = 1 << 23, 1 << 18


# The metric: H on boxes, its second derivatives, and p·H⁻¹p.


def gram(formula, x):
    """H on boxes; NaN where it is not defined on all of a box."""
    shape = np.broadcast(*(xi.lo for xi in x)).shape
    h = formula(x, of)
    return {ij: Interval(np.broadcast_to(e.lo, shape), np.broadcast_to(e.hi, shape)) for ij, e in h.items()}


def curvature(formula, x):
    """An M ≥ 0 with u·D²H[e,e]u ≤ M on each box for all unit u, e; NaN if H may not be C².

    It is the form of the symmetric matrix with entries ∂ₖ∂ₗHᵢⱼ, rows (i,k) and columns (j,l), at
    u ⊗ e: at most its Frobenius norm, and at most Gershgorin's bound on its eigenvalues.
    """
    n = len(x)
    unit = [[of(1.0) if i == j else None for j in range(n)] for i in range(n)]
    h = formula([Jet(xi, first) for xi, first in zip(x, unit)], lambda c: Jet(c, [None] * n))
    zero, pairs = of(np.zeros(x[0].lo.shape)), list(itertools.product(range(n), repeat=2))
    squares, rows = zero, []
    finite = np.ones(zero.lo.shape, bool)
    for i, k in pairs:
        row = zero
        for j, l in pairs:
            entry = h[min(i, j), max(i, j)]
            second = zero + (entry.second.get((min(k, l), max(k, l))) or zero)
            finite &= np.isfinite(second.lo + second.hi) & np.isfinite(entry.value.lo + entry.value.hi)
            squares += second.sqr()
            row += second if (i, k) == (j, l) else Interval(second.magnitude())
        rows.append(row.hi)
    bound = np.minimum(squares.sqrt().hi, np.maximum(0, np.max(rows, axis=0)))
    return np.where(finite, bound, np.nan)


def eliminated(h, n, shift):
    """The pivots and factors of H − shift·I, whose pivots are NaN unless proved positive."""
    s, factors = dict(h), {}
    s.update({(k, k): h[k, k] - shift for k in range(n)})
    for k in range(n):
        s[k, k] = s[k, k].where(s[k, k].lo > 0)
        for i in range(k + 1, n):
            factors[i, k] = s[k, i] / s[k, k]
            for j in range(k + 1, i + 1):
                s[j, i] = s[j, i] - factors[i, k] * s[k, j]
    return [s[k, k] for k in range(n)], factors


def positive(h, n, shift):
    """Whether H > shift·I is proved."""
    pivots, _ = eliminated(h, n, shift)
    return np.all([pivot.lo > 0 for pivot in pivots], axis=0)


def dual_square(elimination, p):
    """An upper bound on p·S⁻¹p, by completing squares."""
    (pivots, factors), y, total = elimination, list(p), of(0.0)
    for i, pivot in enumerate(pivots):
        for j in range(i):
            y[i] = y[i] - factors[i, j] * y[j]
        total = total + y[i].sqr() / pivot
    return np.where(np.isnan(total.hi), INF, total.hi)


# Kuhn's simplices. The corners are w₀ = 0 and wₘ = wₘ₋₁ + e_π(m), in units of the side.


class Simplex:
    def __init__(self, axes):
        n, self.axes = len(axes), axes
        self.corners = np.array([[int(axis in axes[:m]) for axis in range(n)] for m in range(n + 1)])

    def corner(self, m):
        """The number of a corner among the 2^D of the cube."""
        return int(np.ravel_multi_index(self.corners[m], (2,) * len(self.axes)))

    def node(self, values, i, j):
        """The values at the midpoint of two corners, in each cube."""
        return values[np.ravel_multi_index(self.corners[i] + self.corners[j], (3,) * len(self.axes))]

    def bernstein(self, values):
        """The coefficients b with φ = Σ bᵢⱼ λᵢ λⱼ: φ lies between the least and the greatest."""
        def coefficient(i, j):
            a, b = (of(self.node(values, k, k)) for k in (i, j))
            return a if i == j else of(self.node(values, i, j)).scaled(2.0) - (a + b).scaled(0.5)
        return {ij: coefficient(*ij) for ij in upper(len(self.axes) + 1)}

    def gradient(self, values, k, side):
        """The gradient at the corner k.

        Along an edge from k the derivative is 4(mid − at k) − (end − at k); the axis π(m) is the
        difference of the edges to m and to m − 1. This holds for m or m − 1 = k, too.
        """
        gradient = [None] * len(self.axes)
        for m, axis in enumerate(self.axes, 1):
            mids = of(self.node(values, k, m)) - of(self.node(values, k, m - 1))
            ends = of(self.node(values, m, m)) - of(self.node(values, m - 1, m - 1))
            gradient[axis] = (mids.scaled(4.0) - ends).scaled(1 / side)
        return gradient


def simplices(n):
    return [Simplex(axes) for axes in itertools.permutations(range(n))]


def least(form):
    return np.min([b.lo for b in form.values()], axis=0)


def bounds(form):
    """Bounds on all values, infinite where a coefficient is unknown."""
    lo, hi = least(form), np.max([b.hi for b in form.values()], axis=0)
    return np.where(np.isnan(lo), -INF, lo), np.where(np.isnan(hi), INF, hi)


# The sets: unions of pieces. A piece but a point is where all its functions α|x−c|² + n·x − β ≤ 0.


def constraints(piece):
    kind, x = piece
    n = {"point": len(x), "ball": len(x) - 1, "half-space": len(x) - 1, "box": len(x) // 2}[kind]
    if kind == "ball":
        return [(x[:n], np.zeros(n), of(x[n]).sqr())]
    if kind == "half-space":
        return [(None, x[:n], of(x[n]))]
    sides = [(None, np.eye(n)[i] * s, of(s * x[i + (n if s > 0 else 0)])) for i in range(n) for s in (1, -1)]
    return sides


def polar(constraint, x, y):
    """The Bernstein coefficient for two vertices; for x = y the value there."""
    centre, normal, offset = constraint
    total = -offset
    for i, (xi, yi) in enumerate(zip(x, y)):
        total = total + ((xi + yi) * normal[i]).scaled(0.5)
        if centre is not None:
            total = total + ((xi - centre[i]).sqr() if x is y else (xi - centre[i]) * (yi - centre[i]))
    return total


def norm(x):
    return sum((xi.sqr() for xi in x), of(0.0)).sqrt()


def distance_below(pieces, x):
    """A lower bound on the distance between a set and each box."""
    found, n = INF, len(x)
    for kind, s in pieces:
        if kind == "half-space":
            height = sum((xi * s[i] for i, xi in enumerate(x)), of(0.0)) - s[n]
            distance = height.positive() / norm([of(c) for c in s[:n]])
        elif kind == "box":
            distance = norm([(of(s[i]) - xi).positive() + (xi - s[n + i]).positive() for i, xi in enumerate(x)])
        else:
            distance = norm([xi - s[i] for i, xi in enumerate(x)]) - (s[n] if kind == "ball" else 0.0)
        found = np.minimum(found, np.where(distance.lo > 0, distance.lo, 0))
    return found


def bounding_box(pieces, n):
    """The smallest box around a set, rounded outward; None if the set is unbounded."""
    if any(kind == "half-space" for kind, _ in pieces):
        return None
    ends = []
    for kind, x in pieces:
        r = x[n] if kind == "ball" else 0.0
        low, high = x[:n], x[n:] if kind == "box" else x[:n]
        ends.append((add_down(low, -r), add_up(high, r)))
    return [Interval(min(lo[i] for lo, _ in ends), max(hi[i] for _, hi in ends)) for i in range(n)]


def contains(pieces, x):
    """Whether a point is proved to lie in a set."""
    point = [of(xi) for xi in x]
    def in_piece(piece):
        if piece[0] == "point":
            return (piece[1] == x).all()
        return all(polar(c, point, point).hi <= 0 for c in constraints(piece))
    return any(map(in_piece, pieces))


def on_piece(piece, simplex, low, side, forms):
    """Where a piece may meet the simplex, and for each form bounds on its values there."""
    kind, s = piece
    n = len(low)
    if kind == "point" or kind == "ball" and s[n] == 0:
        height = [(of(s[axis]) - low[axis]).scaled(1 / side) for axis in simplex.axes]
        weights = [a - b for a, b in zip([of(1.0), *height], [*height, of(0.0)])]
        meets = np.all([(w.hi >= 0) & (w.lo <= 1) for w in weights], axis=0)
        weights = [Interval(np.maximum(w.lo, 0), np.minimum(w.hi, 1)).where(meets, 0.0) for w in weights]
        values = []
        for form in forms:
            terms = [(weights[i] * weights[j] * b).scaled(1.0 if i == j else 2.0) for (i, j), b in form.items()]
            value, (lo, hi) = sum(terms, of(0.0)), bounds(form)
            values.append((np.where(value.lo > lo, value.lo, lo), np.where(value.hi < hi, value.hi, hi)))
        return meets, values
    vertices = [[of(low[i] + side * w[i]) for i in range(n)] for w in simplex.corners]
    functions = [{(i, j): polar(c, vertices[i], vertices[j]) for i, j in upper(n + 1)} for c in constraints(piece)]
    meets = ~np.any([least(b) > 0 for b in functions], axis=0)
    def negative(form):
        return {ij: -b for ij, b in form.items()}
    return meets, [(least_where(form, functions), -least_where(negative(form), functions)) for form in forms]


def least_where(form, functions):
    """A lower bound on a form where all functions b ≤ 0: there φ ≥ φ + Σ μ b for all μ ≥ 0.

    The μ, floats, make the gradient of the sum small, one function after the other.
    """
    def slopes(form, n):
        return np.array([(form[m, m].lo - form[m - 1, m - 1].lo) for m in range(1, n + 1)])
    n, total = max(i for i, _ in form), form
    for b in functions:
        with np.errstate(all="ignore"):
            direction = slopes(b, n)
            factor = -(slopes(total, n) * direction).sum(axis=0) / (direction**2).sum(axis=0)
        touches = ~(np.max([c.hi for c in b.values()], axis=0) < 0)
        factor = np.where(touches & (factor > 0) & np.isfinite(factor), factor, 0.0)
        total = {ij: total[ij] + b[ij] * factor for ij in form}
    found, plain = least(total), bounds(form)[0]
    return np.where(found > plain, found, plain)


# Level sets: f = 0 up to t₀, then with slopes s on bins where s² q ≤ 1 for all simplices that meet them.


class LevelSets:
    def __init__(self, lo, hi, q, start, end):
        with np.errstate(all="ignore"):
            step = np.float64(1.1) * (end - start) / BINS
            levels = start + step * np.arange(BINS + 1)
        ok = np.isfinite(start) and np.isfinite(end) and end > start and np.isfinite(levels).all()
        self.levels = np.unique(levels) if ok else np.zeros(1)
        count = len(self.levels) - 1
        self.slopes, self.heights = np.zeros(count), np.zeros(count + 1)
        if count:
            worst = self.worst(lo, hi, q)
            with np.errstate(divide="ignore"):
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


# One level.


class Sweep:
    def __init__(self, formula, sets, level):
        n, side = level.dimension, level.side
        self.level, self.simplices = level, simplices(n)
        self.low = [level.cubes[:, i] * side for i in range(n)]
        box = [Interval(low, low + side) for low in self.low]
        with np.errstate(over="ignore"):
            shift = up(curvature(formula, box) * (side**2 * n / 8))
        points, numbers = level.numbers(1)
        h = gram(formula, [of(x * side) for x in points])
        corners = [{ij: e[number] for ij, e in h.items()} for number in numbers]
        # Where a shift is too large for the vertex test, H may still have bounds on the whole cube.
        good = np.all([positive(h, n, of(shift)) for h in corners], axis=0)
        whole = {ij: e.where(~good) for ij, e in gram(formula, box).items()} if not good.all() else None
        shift = of(np.where(good, shift, 0))
        if whole:
            corners = [{ij: e.where(good, whole[ij]) for ij, e in h.items()} for h in corners]
        tests = [eliminated(h, n, shift) for h in corners]
        self.forms = [[s.bernstein(v) for v in level.values] for s in self.simplices]
        self.ranges = [np.array([bounds(f[i]) for f in self.forms]) for i in (0, 1)]
        self.q = [np.array([self.largest(s, v, tests) for s in self.simplices]) for v in level.values]
        self.sum = np.array([least({ij: f[0][ij] + f[1][ij] for ij in f[0]}) for f in self.forms])
        self.meetings = [self.meet(pieces, own, box) for own, pieces in enumerate(sets)]

    def largest(self, simplex, values, tests):
        q = 0
        for k in range(len(simplex.axes) + 1):
            p = simplex.gradient(values, k, self.level.side)
            q = np.maximum(q, dual_square(tests[simplex.corner(k)], p))
        return q

    def meet(self, pieces, own, box):
        """For each simplex that a set may meet: its number, an upper bound on the set's own function
        and a lower bound on the other one, on the set."""
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
            with np.errstate(invalid="ignore"):
                apart = add_down(f.below(a), g.below(c))
                together = add_down(add_down(self.sum, -f.excess(b)), -g.excess(d))
            left = kept & ~((apart >= hi) | (together >= hi))
            if (left == kept).all():
                break
            kept = left
        return min(lower, hi), kept.any(axis=0)

    def to_the_boundary(self, ignored):
        """Lower bounds on the lengths from each set to a boundary facet of the cubes."""
        level = self.level
        start = [own.max(initial=-INF) for _, own, _ in self.meetings]
        ends = [r[:, 1][np.isfinite(r[:, 1])].max(initial=s) for r, s in zip(self.ranges, start)]
        functions = self.functions(np.ones(self.sum.shape, bool), start, ends)
        shortest = [INF, INF]
        n = level.dimension
        for simplex, forms in zip(self.simplices, self.forms):
            # Without the last corner: in the low face of the last axis. Without the first: high face.
            for k, axis, step in ((n, simplex.axes[-1], -1), (0, simplex.axes[0], 1)):
                facet = ~level.holds(level.cubes + step * np.eye(n, dtype=np.int64)[axis])
                facet &= np.logical_not(ignored(simplex, k, self.low, level.side))
                for i, function in enumerate(functions):
                    lo = bounds({ij: b for ij, b in forms[i].items() if k not in ij})[0]
                    shortest[i] = min(shortest[i], function.below(lo[facet]).min(initial=INF))
        return shortest


# The region: why curves shorter than hi stay in the cubes of the first level.


def prove_tubes(formula, sets, hi, radius, c1):
    """H ≥ c₁ within the radius of each bounded set; the tubes are too wide for short curves to leave."""
    n = formula.dimension
    bounded = [pieces for pieces in sets if bounding_box(pieces, n)]
    require(bounded, "no set is bounded")
    needed = hi / 2 if len(bounded) == 2 else hi
    wide = (of(c1).sqrt() * radius).lo >= needed
    require(wide, f"tubes of radius {radius} with c1 = {c1} do not hold all curves shorter than {hi}")
    for pieces in bounded:
        x = [side + Interval(-radius, radius) for side in bounding_box(pieces, n)]
        lo, hi_ = (np.array([[float(getattr(xi, end))] for xi in x]) for end in ("lo", "hi"))
        seen = 0
        while lo.size:
            seen += lo.shape[1]
            require(seen <= MOST_BOXES, f"c1 = {c1} is not proved within {radius} of the sets")
            box = [Interval(a, b) for a, b in zip(lo, hi_)]
            open_ = ~(distance_below(pieces, box) > radius) & ~positive(gram(formula, box), n, of(c1))
            lo, hi_ = lo[:, open_], hi_[:, open_]
            longest, every = np.argmax(hi_ - lo, axis=0), np.arange(lo.shape[1])
            middle = 0.5 * lo[longest, every] + 0.5 * hi_[longest, every]
            above, below = lo.copy(), hi_.copy()
            above[longest, every], below[longest, every] = middle, middle
            lo, hi_ = np.hstack([lo, above]), np.hstack([below, hi_])


def required_cubes(region, sets, hi, exponent, n):
    """The cubes that the first level has to contain."""
    kind, *numbers = region
    if kind in ("exit-one", "exit-two"):
        def at(pieces):
            return cubes_near(pieces, 0.0, exponent, n, lambda box: ~(distance_below(pieces, box) > 0))
        return np.concatenate([at(pieces) for pieces in sets[: 1 if kind == "exit-one" else 2]])
    root = of(numbers[-1]).sqrt()
    reach = (of(hi) / root).hi
    def near(box):
        both = add_down(distance_below(sets[0], box), distance_below(sets[1], box))
        return ~((root * of(both)).lo >= hi)
    bounded = [pieces for pieces in sets if bounding_box(pieces, n)]
    require(bounded, "no set is bounded")
    return cubes_near(bounded[0], reach, exponent, n, near)


def cubes_near(pieces, reach, exponent, n, near):
    """The cubes of side 2^exponent in the box within reach of a bounded set that are near.

    Larger cubes are halved; one that is not near has no cube that is."""
    around = bounding_box(pieces, n)
    require(around, "a set is unbounded that must be bounded")
    around = [side + Interval(-reach, reach) for side in around]
    width = max(float(up(side.hi - side.lo)) for side in around)
    require(np.isfinite(width), "the region is not bounded")
    coarse = exponent
    while 2.0**coarse < width:
        coarse += 1
    require(coarse - exponent <= 28, "the cubes of the first level are too small")
    # Four cubes as large as the box cover it along an axis.
    first = [np.floor(side.lo / 2.0**coarse) - 1 for side in around]
    require(max(map(abs, first)) < FARTHEST, "the region is too far from the origin")
    places = np.array(list(itertools.product(*(range(int(f), int(f) + 4) for f in first))), np.int64)
    halves = np.array(list(itertools.product(range(2), repeat=n)))
    while True:
        box = [Interval(places[:, i] * 2.0**coarse, (places[:, i] + 1) * 2.0**coarse) for i in range(n)]
        meets = np.all([(a.lo <= b.hi) & (b.lo <= a.hi) for a, b in zip(box, around)], axis=0)
        places = places[meets & near(box)]
        require(len(places) <= MOST_CUBES, f"the region has more than {MOST_CUBES} cubes")
        require(np.abs(places).max(initial=0) <= FARTHEST, "a required cube is too far from the origin")
        if coarse == exponent:
            return places
        coarse, places = coarse - 1, (2 * places[:, None] + halves).reshape(-1, n)


def prove_exit(region, sets, hi, sweep):
    """No curve shorter than hi leaves the cubes of the first level."""
    if region[0] == "exit-one":
        def inside(simplex, k, low, side):
            held = np.zeros(low[0].shape, bool)
            for piece in sets[1]:
                if piece[0] != "point":
                    w = [[of(x + side * c) for x, c in zip(low, corner)] for corner in simplex.corners]
                    facet = [(i, j) for i, j in upper(len(w)) if k not in (i, j)]
                    held |= np.all([polar(c, w[i], w[j]).hi <= 0 for c in constraints(piece) for i, j in facet], axis=0)
            return held
        shortest = sweep.to_the_boundary(inside)[0]
    elif region[0] == "exit-two":
        shortest = add_down(*sweep.to_the_boundary(lambda *_: False))
    else:
        return
    require(shortest >= hi, f"a curve of length {shortest} may leave the cubes, which is less than {hi}")


# The curve.


def length_above(formula, points):
    """An upper bound on the length of a polygon.

    The speed g on a part of a chord has the integral w (g(middle) + w² g''(somewhere)/24).
    """
    moved = (points[1:] != points[:-1]).any(axis=1)
    start, end = points[:-1][moved], points[1:][moved]
    chord, at, width, lengths = np.arange(len(start)), np.zeros(len(start)), 1.0, []
    for _ in range(13):
        origin = [of(x) for x in start[chord].T]
        d = [of(y) - x for y, x in zip(end[chord].T, origin)]
        def speed(s):
            x = [Jet(s, [of(1.0)]) * di + xi for xi, di in zip(origin, d)]
            h = formula(x, lambda c: Jet(c, [None]))
            terms = [h[i, j] * (d[i] * d[j]).scaled(1.0 if i == j else 2.0) for i, j in h]
            return sum(terms[1:], terms[0]).sqrt()
        bent = speed(Interval(at, at + width)).second.get((0, 0)) or of(0.0)
        length = (speed(of(at + width / 2)).value + bent * width**2 / 24.0) * width
        known = np.isfinite(length.lo + length.hi)
        lengths.extend(length.hi[known])
        chord, at = np.tile(chord[~known], 2), np.concatenate([at[~known], at[~known] + width / 2])
        width /= 2
        if not chord.size:
            return up(math.fsum(lengths))
    return INF


# The certificate.


def check(certificate, report=lambda line: None):
    """The lower and the upper bound, which is None without a curve."""
    c = certificate
    require(c.hi > 0, f"the bound hi is {c.hi}")
    require(c.levels, "the certificate has no levels")
    if c.region[0] == "tubes":
        prove_tubes(c.formula, c.sets, c.hi, *c.region[1:])
    upper_bound = None
    if c.curve is not None:
        require(len(c.curve), "the curve has no points")
        for name, pieces, x in (("first", c.sets[0], c.curve[0]), ("last", c.sets[1], c.curve[-1])):
            require(contains(pieces, x), f"the {name} point of the curve is not proved to lie in its set")
        upper_bound = float(length_above(c.formula, c.curve))
        require(upper_bound < c.hi, f"the curve has length at most {upper_bound}, not below {c.hi}")
    lower, kept = 0.0, None
    for number, level in enumerate(c.levels):
        if kept is None:
            required = required_cubes(c.region, c.sets, c.hi, level.exponent, c.dimension)
        elif level.exponent == before.exponent:
            required = kept
        else:
            require(level.exponent == before.exponent - 1, f"level {number} has cubes of another size")
            halves = np.array(list(itertools.product(range(2), repeat=c.dimension)))
            required = (2 * kept[:, None] + halves).reshape(-1, c.dimension)
        missing = required[~level.holds(required)]
        require(not len(missing), f"level {number} lacks {len(missing)} cubes, as at {missing[:1].tolist()}")
        sweep = Sweep(c.formula, c.sets, level)
        if kept is None:
            prove_exit(c.region, c.sets, c.hi, sweep)
        found, left = sweep.shorter_than(c.hi)
        lower, kept, before = max(lower, found), level.cubes[left], level
        report(f"level {number}: {len(level.cubes)} cubes, {len(kept)} kept, lower bound {rounded(lower, ROUND_FLOOR)}")
        if not len(kept):
            break
    if upper_bound is not None:
        require(len(kept) and lower <= upper_bound, f"a contradiction: {lower} and a curve of length {upper_bound}")
    return lower, upper_bound


def rounded(x, rounding):
    return Context(prec=17, rounding=rounding).create_decimal(Decimal(float(x)))


def test_rounding():
    """Refuses a processor in another rounding mode, or without subnormal numbers."""
    one, half = np.array([1.0, -1.0]), np.array([1.0, -1.0]) * 2.0**-53
    nearest = (one + half == one).all() and (one + 1.5 * half == one * (1 + 2.0**-52)).all()
    require(nearest and (np.array([2.0**-1022]) / 2 > 0).all(), "doubles are not rounded to nearest")


def main(path):
    try:
        test_rounding()
        with open(path, encoding="ascii", newline="") as file:
            certificate = Certificate(file.read())
        print("\n".join(certificate.statement))
        for name, pieces in zip(("from", "to"), certificate.sets):
            for kind, numbers in pieces:
                print(name, kind, *map(float, numbers))
        print("curves shorter than", float(certificate.hi), "stay in the cubes:", *map(str, certificate.region))
        if certificate.region[0] == "declared":
            print("c1 is declared, not proved: a hypothesis")
        lower, upper_bound = check(certificate, print)
    except (Refused, OSError, ValueError) as reason:
        print(f"refused: {reason}", file=sys.stderr)
        return 1
    print("lower", rounded(lower, ROUND_FLOOR))
    if upper_bound is not None:
        print("upper", rounded(upper_bound, ROUND_CEILING))
        print("gap  ", f"{(upper_bound - lower) / upper_bound if upper_bound else 0.0:.6e}")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]) if len(sys.argv) == 2 else "usage: python3 check.py FILE")
