"""The problems P1 to P6, their discrete energy, and the rule by which a result is judged.

A metric is one formula in a module ``m`` that has ``sin``, ``cos`` and ``exp``: NumPy, JAX,
autograd or CasADi.  Its coordinates are numbers or arrays, its entries are too.

The discrete energy of N + 1 points is that of the paper's trapezoidal rule,

    E(x_0, ..., x_N) = N sum_n (x_{n+1} - x_n)^T H((x_n + x_{n+1}) / 2) (x_{n+1} - x_n).
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from types import ModuleType
from typing import Any, Callable, Sequence

import numpy as np

Gram = Callable[[Sequence[Any], Any], list[list[Any]]]


@dataclass(frozen=True)
class Ball:
    """The points at most ``radius`` from ``centre``."""

    centre: tuple[float, ...]
    radius: float


@dataclass(frozen=True)
class HalfSpace:
    """The points whose coordinate ``axis`` is at least ``bound``."""

    axis: int
    bound: float


@dataclass(frozen=True)
class Problem:
    """A metric, the line to start from, and the sets if the ends are not fixed."""

    name: str
    gram: Gram
    start: tuple[float, ...]
    stop: tuple[float, ...]
    # The square of the distance, and (E_N - d^2) N^2 for the minimum E_N of the discrete energy:
    # closed forms for P1 and P6, otherwise extrapolated and known to the digits that are given.
    distance_squared: float
    discretisation: float
    first_set: Ball | None = None
    last_set: HalfSpace | None = None

    @property
    def dimension(self) -> int:
        """The number of coordinates."""
        return len(self.start)

    @property
    def fixed_ends(self) -> bool:
        """Whether the curve joins two points."""
        return self.first_set is None

    def line(self, n: int) -> np.ndarray:
        """The straight line from which everybody starts, as N + 1 rows."""
        t = np.linspace(0.0, 1.0, n + 1)[:, None]
        return (1.0 - t) * np.array(self.start) + t * np.array(self.stop)


def isotropic(factor: Callable[[Sequence[Any], Any], Any], dimension: int) -> Gram:
    """The metric ``factor(x) I``."""

    def gram(x: Sequence[Any], m: ModuleType) -> list[list[Any]]:
        f = factor(x, m)
        return [[f if i == j else 0.0 * f for j in range(dimension)] for i in range(dimension)]

    return gram


def squared_norm(x: Sequence[Any]) -> Any:
    """The square of the Euclidean norm in the plane."""
    return x[0] * x[0] + x[1] * x[1]


def coupled_cosines(x: Sequence[Any], m: ModuleType) -> list[list[Any]]:
    """diag(1, 3/2, 2) + (2/5) cos(x_i - x_j) / (1 + |i - j|)."""
    diagonal = (1.0, 1.5, 2.0)
    return [
        [
            0.4 * m.cos(x[i] - x[j]) / (1 + abs(i - j)) + (diagonal[i] if i == j else 0.0)
            for j in range(3)
        ]
        for i in range(3)
    ]


WAVES = [[math.sin(0.7 * k + i) for i in range(1, 9)] for k in range(1, 9)]
DIRECTIONS = [[math.cos(1.3 * k * i) / 2 for i in range(1, 9)] for k in range(1, 9)]


def sine_projections(x: Sequence[Any], m: ModuleType) -> list[list[Any]]:
    """I + (1/2) sum_k sin(w_k . x)^2 a_k a_k^T in eight dimensions."""
    weights = [0.5 * m.sin(sum(w[i] * x[i] for i in range(8))) ** 2 for w in WAVES]
    return [
        [
            sum(weights[k] * (a[i] * a[j]) for k, a in enumerate(DIRECTIONS)) + float(i == j)
            for j in range(8)
        ]
        for i in range(8)
    ]


BUMP = isotropic(lambda x, m: (1.0 + 4.0 * m.exp(-2.0 * squared_norm(x))) ** 2, 2)

PROBLEMS = {
    problem.name: problem
    for problem in [
        Problem(
            "P1",
            isotropic(lambda x, m: (2.0 - m.cos(x[0])) ** 2, 2),
            (0.0, 0.0),
            (4 * math.pi, 0.0),
            64 * math.pi**2,
            -3.2e3,
        ),
        Problem("P2", BUMP, (-1.5, 0.05), (1.5, -0.1), 21.858160535, 23.2),
        Problem("P3", coupled_cosines, (0.0,) * 3, (3.0, 2.0, -2.0), 32.3618178235026, 0.55),
        Problem(
            "P4",
            BUMP,
            (-1.6, 0.3),
            (2.0, 0.3),
            17.476778558,
            3.3,
            Ball((-2.0, 0.0), 0.5),
            HalfSpace(0, 2.0),
        ),
        Problem("P5", sine_projections, (0.0,) * 8, (1.0,) * 8, 8.849588854249, 0.24),
        Problem(
            "P6",
            isotropic(lambda x, m: 4.0 / (1.0 + squared_norm(x)) ** 2, 2),
            (-0.8, 0.3),
            (1.1, 0.6),
            5.278323900279761,
            5.0,
        ),
    ]
}


def gram_array(problem: Problem, x: np.ndarray) -> np.ndarray:
    """H at each row of ``x``, of the shape (rows, D, D)."""
    rows = problem.gram(x.T, np)
    return np.stack([np.stack(row, axis=-1) for row in rows], axis=-2)


def energy(problem: Problem, points: np.ndarray) -> float:
    """The discrete energy."""
    chords = np.diff(points, axis=0)
    gram = gram_array(problem, (points[1:] + points[:-1]) / 2)
    return len(chords) * math.fsum(np.einsum("ni,nij,nj->n", chords, gram, chords))


def gradient(problem: Problem, points: np.ndarray) -> np.ndarray:
    """The gradient of the discrete energy in all N + 1 points.

    The metric is differentiated by a complex step: no difference of close numbers, so that the
    result is exact to rounding.
    """
    n = len(points) - 1
    chords, middles = np.diff(points, axis=0), (points[1:] + points[:-1]) / 2
    momenta = 2 * n * np.einsum("nij,nj->ni", gram_array(problem, middles), chords)
    forces = np.empty_like(chords)
    for k in range(problem.dimension):
        moved = middles.astype(complex)
        moved[:, k] += 1e-30j
        slope = gram_array(problem, moved).imag / 1e-30
        forces[:, k] = n / 2 * np.einsum("ni,nij,nj->n", chords, slope, chords)
    total = np.zeros_like(points)
    total[:-1] += forces - momenta
    total[1:] += forces + momenta
    return total


def residual(problem: Problem, points: np.ndarray) -> float:
    """The largest component of the gradient in all directions that are free to move in.

    In a set at its boundary, which is where the ends of P4 belong, these are the tangents.
    """
    total = gradient(problem, points)
    if problem.first_set is None or problem.last_set is None:
        total[0] = total[-1] = 0.0
    else:
        normal = points[0] - np.array(problem.first_set.centre)
        normal /= np.linalg.norm(normal)
        total[0] -= (total[0] @ normal) * normal
        total[-1, problem.last_set.axis] = 0.0
    return float(np.abs(total).max())


def tolerance(problem: Problem, n: int) -> float:
    """The residual at which a solver may stop.

    10^-10 of that of the straight line, or what the rounding of the points makes of it, where
    that is more: a relative error eps of x changes the gradient by up to 8 eps N |H| |x|.
    """
    line = problem.line(n)
    largest = np.abs(gram_array(problem, line)).max() * np.abs(line).max()
    return max(1e-10 * residual(problem, line), 8 * np.finfo(float).eps * n * float(largest))


def is_minimum(problem: Problem, n: int, value: float, on_grid: bool) -> bool:
    """Whether an energy is that of the minimum, and not of another geodesic.

    The discretisation error may be three times what its leading term says, and a relative 10^-4
    is granted besides: other geodesics differ by much more.
    """
    error = abs(problem.discretisation) / n**2 if on_grid else 0.0
    return abs(value - problem.distance_squared) <= 3 * error + 1e-4 * problem.distance_squared
