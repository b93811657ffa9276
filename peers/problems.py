"""The problems P1 to P6, their discrete energy, and the rule by which a result is judged.

A metric is given by its square speed u^T H(x) u, as one writes it by hand, in a module ``m`` that
has ``sin``, ``cos`` and ``exp``: NumPy, JAX, autograd or CasADi.  Coordinates come first: ``x[0]``
is a number or the array of all first coordinates.

The discrete energy of N + 1 points is that of the paper's trapezoidal rule,

    E(x_0, ..., x_N) = N sum_n (x_{n+1} - x_n)^T H((x_n + x_{n+1}) / 2) (x_{n+1} - x_n).
"""

from __future__ import annotations

import math
import sys
from dataclasses import dataclass
from typing import Any, Callable

import numpy as np

# Of x, u and the module.
SquareSpeed = Callable[[Any, Any, Any], Any]


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
    square_speed: SquareSpeed
    start: tuple[float, ...]
    stop: tuple[float, ...]
    # The square of the distance, and (E_N - d^2) N^2 for the minimum E_N of the discrete energy:
    # closed forms for P1 and P6, by shooting (DOP853, to rounding) for P2, P3 and P5, extrapolated
    # for P4; known to the given digits.
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
        """The straight line from which every peer starts, as N + 1 rows."""
        t = np.linspace(0.0, 1.0, n + 1)[:, None]
        return (1.0 - t) * np.array(self.start) + t * np.array(self.stop)


def square(x: Any) -> Any:
    """The square of the Euclidean norm in the plane."""
    return x[0] * x[0] + x[1] * x[1]


def coupled_cosines(x: Any, u: Any, m: Any) -> Any:
    """H = diag(1, 3/2, 2) + (2/5) cos(x_i - x_j) / (1 + |i - j|)."""
    diagonal = 1.4 * u[0] ** 2 + 1.9 * u[1] ** 2 + 2.4 * u[2] ** 2
    beside = m.cos(x[0] - x[1]) * u[0] * u[1] + m.cos(x[1] - x[2]) * u[1] * u[2]
    return diagonal + 0.4 * beside + 0.8 / 3 * m.cos(x[0] - x[2]) * u[0] * u[2]


WAVES = np.array([[math.sin(0.7 * k + i) for i in range(1, 9)] for k in range(1, 9)])
DIRECTIONS = np.array([[math.cos(1.3 * k * i) / 2 for i in range(1, 9)] for k in range(1, 9)])
ONES = np.ones((1, 8))


def sine_projections(x: Any, u: Any, m: Any) -> Any:
    """H = I + (1/2) sum_k sin(w_k . x)^2 a_k a_k^T in eight dimensions."""
    return (ONES @ (u * u + 0.5 * (m.sin(WAVES @ x) * (DIRECTIONS @ u)) ** 2))[0]


def bump(x: Any, u: Any, m: Any) -> Any:
    """H = (1 + 4 exp(-2 |x|^2))^2 I."""
    return (1.0 + 4.0 * m.exp(-2.0 * square(x))) ** 2 * square(u)


PROBLEMS = {
    problem.name: problem
    for problem in [
        Problem(
            "P1",
            lambda x, u, m: (2.0 - m.cos(x[0])) ** 2 * square(u),
            (0.0, 0.0),
            (4 * math.pi, 0.0),
            64 * math.pi**2,
            -3.2e3,
        ),
        Problem("P2", bump, (-1.5, 0.05), (1.5, -0.1), 21.8581605353264, 23.2),
        Problem("P3", coupled_cosines, (0.0,) * 3, (3.0, 2.0, -2.0), 32.361817823503, 0.55),
        Problem(
            "P4",
            bump,
            (-1.6, 0.3),
            (2.0, 0.3),
            17.476778558,
            3.3,
            Ball((-2.0, 0.0), 0.5),
            HalfSpace(0, 2.0),
        ),
        Problem("P5", sine_projections, (0.0,) * 8, (1.0,) * 8, 8.8495888542492, 0.24),
        Problem(
            "P6",
            lambda x, u, m: 4.0 * square(u) / (1.0 + square(x)) ** 2,
            (-0.8, 0.3),
            (1.1, 0.6),
            5.278323900279761,
            5.0,
        ),
    ]
}


def energy(problem: Problem, points: np.ndarray) -> float:
    """The discrete energy."""
    chords, middles = np.diff(points, axis=0), (points[1:] + points[:-1]) / 2
    return len(chords) * math.fsum(problem.square_speed(middles.T, chords.T, np))


def slopes(function: Callable[[np.ndarray], np.ndarray], x: np.ndarray) -> np.ndarray:
    """The partial derivatives of a function of many points, one row each.

    By a complex step: no difference of close numbers, so that they are exact to rounding.
    """
    found = np.empty_like(x)
    for k in range(x.shape[1]):
        moved = x.astype(complex)
        moved[:, k] += 1e-30j
        found[:, k] = function(moved.T).imag / 1e-30
    return found


def gradient(problem: Problem, points: np.ndarray) -> np.ndarray:
    """The gradient of the discrete energy in all N + 1 points."""
    n = len(points) - 1
    chords, middles = np.diff(points, axis=0), (points[1:] + points[:-1]) / 2
    forces = n / 2 * slopes(lambda x: problem.square_speed(x, chords.T, np), middles)
    momenta = n * slopes(lambda u: problem.square_speed(middles.T, u, np), chords)
    total = np.zeros_like(points)
    total[:-1] += forces - momenta
    total[1:] += forces + momenta
    return total


def residual(problem: Problem, points: np.ndarray) -> float:
    """The largest component of the gradient in all free directions.

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
    # The largest entry of a positive definite matrix is on its diagonal.
    units = (np.repeat(unit[:, None], n + 1, axis=1) for unit in np.eye(problem.dimension))
    entries = max(float(problem.square_speed(line.T, unit, np).max()) for unit in units)
    largest = entries * float(np.abs(line).max())
    return max(1e-10 * residual(problem, line), 8 * sys.float_info.epsilon * n * largest)


def is_minimum(problem: Problem, n: int, value: float, on_grid: bool) -> bool:
    """Whether an energy belongs to the minimum, and not to another geodesic.

    The discretisation error may be three times what its leading term says, and a relative 10^-4
    is granted besides: other geodesics differ by much more.
    """
    error = abs(problem.discretisation) / n**2 if on_grid else 0.0
    return abs(value - problem.distance_squared) <= 3 * error + 1e-4 * problem.distance_squared
