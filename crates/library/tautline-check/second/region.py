"""Why curves shorter than hi stay in the cubes of the first level."""

import itertools
from fractions import Fraction

import numpy as np

from certificate import FARTHEST
from intervals import Interval, add_down, of, up
from jets import upper
from metric import gram, positive
from refused import require
from sets import bounding_box, constraints, distance_below, polar
from work import UNLIMITED, batches

# The most boxes on which c₁ is proved, and the most boxes or cubes that are looked at together.
MOST_BOXES, BATCH = 1 << 18, 1 << 12


def prove_tubes(formula, sets, hi, radius, c1, work=UNLIMITED):
    """Proves H ≥ c₁ within the radius of each bounded set, in tubes that hold all short curves."""
    n = formula.dimension
    bounded = [pieces for pieces in sets if bounding_box(pieces, n)]
    require(bounded, "no set is bounded")
    # Two tubes have to be as wide together as the curves are long.
    wide = (of(c1).sqrt() * radius * len(bounded)).lo >= hi
    short = f"tubes of radius {radius} with c1 = {c1} do not hold all curves shorter than {hi}"
    require(wide, short)
    for pieces in bounded:
        x = [side + Interval(-radius, radius) for side in bounding_box(pieces, n)]
        lo, hi_ = (np.array([[float(getattr(xi, end))] for xi in x]) for end in ("lo", "hi"))
        left, seen = [(lo, hi_)], 0
        while left:
            lo, hi_ = left.pop()
            seen += lo.shape[1]
            work.spend((formula.weight + sum(map(len, sets))) * lo.shape[1])
            require(seen <= MOST_BOXES, f"c1 = {c1} is not proved within {radius} of the sets")
            box = [Interval(a, b) for a, b in zip(lo, hi_)]
            open_ = ~(distance_below(pieces, box) > radius)
            open_[open_] = ~positive(gram(formula, [xi[open_] for xi in box]), n, of(c1))
            lo, hi_ = lo[:, open_], hi_[:, open_]
            longest, every = np.argmax(hi_ - lo, axis=0), np.arange(lo.shape[1])
            middle = 0.5 * lo[longest, every] + 0.5 * hi_[longest, every]
            above, below = lo.copy(), hi_.copy()
            above[longest, every], below[longest, every] = middle, middle
            lo, hi_ = np.hstack([lo, above]), np.hstack([below, hi_])
            left += [(lo[:, part], hi_[:, part]) for part in batches(lo.shape[1], BATCH)]


def required_cubes(region, sets, hi, exponent, n, work=UNLIMITED):
    """The cubes that the first level has to contain, some at a time."""
    kind, *numbers = region

    def seen(count):
        work.spend(count * sum(map(len, sets)))

    if kind in ("exit-one", "exit-two"):
        for pieces in sets[: 1 if kind == "exit-one" else 2]:
            yield from cubes_near(
                (pieces, 0.0), exponent, n, lambda box: ~(distance_below(pieces, box) > 0), seen
            )
        return
    root = of(numbers[-1]).sqrt()
    reach = (of(hi) / root).hi

    def near(box):
        both = add_down(*(distance_below(pieces, box) for pieces in sets))
        length = root * of(both)
        far = length.lo >= hi
        # Rounded, a cube that just touches the region would count.
        for at in np.flatnonzero(~far & (length.hi >= hi) & np.isfinite(both)):
            far[at] = Fraction(numbers[-1]) * Fraction(both[at]) ** 2 >= Fraction(hi) ** 2
        return ~far

    bounded = [pieces for pieces in sets if bounding_box(pieces, n)]
    require(bounded, "no set is bounded")
    yield from cubes_near((bounded[0], reach), exponent, n, near, seen)


def cubes_near(within, exponent, n, near, seen):
    """The cubes of side 2^exponent in the box within reach of a bounded set that are near.

    `seen` is told how many cubes are looked at. Larger cubes are halved; one that is not near has no cube that is. Those found last are halved
    first, so that a file that lacks cubes is soon found out."""
    pieces, reach = within
    around = bounding_box(pieces, n)
    require(around, "a set is unbounded that must be bounded")
    around = [side + Interval(-reach, reach) for side in around]
    width = max(float(up(side.hi - side.lo)) for side in around)
    require(np.isfinite(width), "the region is not bounded")
    coarse = exponent
    while coarse - exponent <= 28 and 2.0**coarse < width:
        coarse += 1
    require(coarse - exponent <= 28, "the cubes of the first level are too small")
    # Four cubes as large as the box cover it along an axis.
    first = [float(np.floor(side.lo / 2.0**coarse) - 1) for side in around]
    require(max(map(abs, first)) < FARTHEST, "the region is too far from the origin")
    places = np.array(
        list(itertools.product(*(range(int(f), int(f) + 4) for f in first))), np.int64
    )
    halves = np.array(list(itertools.product(range(2), repeat=n)))
    left = [(coarse, places)]
    while left:
        coarse, places = left.pop()
        seen(len(places))
        box = [
            Interval(places[:, i] * 2.0**coarse, (places[:, i] + 1) * 2.0**coarse) for i in range(n)
        ]
        meets = np.all([(a.lo <= b.hi) & (b.lo <= a.hi) for a, b in zip(box, around)], axis=0)
        places = places[meets & near(box)]
        require(
            np.abs(places).max(initial=0) <= FARTHEST, "a required cube is too far from the origin"
        )
        if coarse == exponent:
            yield places
        else:
            places = (2 * places[:, None] + halves).reshape(-1, n)
            left += [(coarse - 1, places[part]) for part in batches(len(places), BATCH)]


def prove_exit(region, sets, hi, sweep):
    """No curve shorter than hi leaves the cubes of the first level."""
    if region[0] == "exit-one":

        def inside(simplex, k, low, side):
            held = np.zeros(low[0].shape, bool)
            for piece in sets[1]:
                if piece[0] != "point":
                    w = [
                        [of(x + side * c) for x, c in zip(low, corner)]
                        for corner in simplex.corners
                    ]
                    facet = [(i, j) for i, j in upper(len(w)) if k not in (i, j)]
                    held |= np.all(
                        [
                            polar(c, w[i], w[j]).hi <= 0
                            for c in constraints(piece)
                            for i, j in facet
                        ],
                        axis=0,
                    )
            return held

        shortest = sweep.to_the_boundary(inside)[0]
    elif region[0] == "exit-two":
        shortest = add_down(*sweep.to_the_boundary(lambda *_: False))
    else:
        return
    require(
        shortest >= hi, f"a curve of length {shortest} may leave the cubes, which is less than {hi}"
    )
