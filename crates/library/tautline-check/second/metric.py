"""The metric on boxes: H, its second derivatives, and bounds on p·H⁻¹p."""

import itertools

import numpy as np

from intervals import INF, Interval, add_up, of, up
from jets import Jet, upper
from work import batches


def gram(formula, x):
    """H on boxes; NaN where it is not defined on all of a box."""
    count = x[0].lo.size
    names = upper(formula.dimension)
    lo, hi = ({ij: np.empty(count) for ij in names} for _ in range(2))
    for part in batches(count, formula.batch(1)):
        for ij, entry in formula([xi[part] for xi in x], of).items():
            lo[ij][part], hi[ij][part] = entry.lo, entry.hi
    return {ij: Interval(lo[ij], hi[ij]) for ij in names}


def curvature(formula, x):
    """A C ≥ 0 with u·D²H[e,e]u ≤ Σ Mₖ eₖ² and Σ Mₖ ≤ C on each box, for all e and all unit u, with
    Mₖ ≥ 0; NaN if H may not be C².

    It is the form of the symmetric matrix with entries ∂ₖ∂ₗHᵢⱼ, rows (i,k) and columns (j,l), at
    u ⊗ e. Mₖ is the largest sum of a diagonal entry and the magnitudes of the others in a row (i,k),
    or else the Frobenius norm.
    """
    parts = (len(x) + 1) * (len(x) + 2) // 2
    sizes = batches(x[0].lo.size, formula.batch(parts))
    bounds = [curvature_of_batch(formula, [xi[part] for xi in x]) for part in sizes]
    return np.concatenate(bounds)


def curvature_of_batch(formula, x):
    n = len(x)
    unit = [[of(1.0) if i == j else None for j in range(n)] for i in range(n)]
    h = formula([Jet(xi, first) for xi, first in zip(x, unit)], lambda c: Jet(c, [None] * n))
    zero, pairs = of(np.zeros(x[0].lo.shape)), list(itertools.product(range(n), repeat=2))
    squares, along = zero, [np.zeros(zero.lo.shape) for _ in range(n)]
    finite = np.ones(zero.lo.shape, bool)
    for i, k in pairs:
        row = zero
        for j, l in pairs:
            entry = h[min(i, j), max(i, j)]
            finite &= np.isfinite(entry.value.lo + entry.value.hi)
            second = entry.second.get((min(k, l), max(k, l)))
            if second is None:
                continue
            finite &= np.isfinite(second.lo + second.hi)
            squares += second.sqr()
            row += second if (i, k) == (j, l) else of(second.magnitude())
        along[k] = np.maximum(along[k], row.hi)
    total = along[0]
    for m in along[1:]:
        total = add_up(total, m)
    bound = np.minimum(up(squares.sqrt().hi * n), total)
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
