"""Tautline from Python: the same solver as in the first row, with a metric that is given as a text."""

from __future__ import annotations

from typing import Callable

import numpy as np
import tautline_geodesics as tautline

from measurement import Solution
from problems import DIRECTIONS, WAVES, Ball, HalfSpace, Problem

BUMP = "cost(1 + 4*exp(-2*(x1^2 + x2^2)))"
TEXTS = {
    "P1": "cost(2 - cos(x1))",
    "P2": BUMP,
    "P3": """
        a = 0.2*cos(x1 - x2);
        b = 0.2*cos(x2 - x3);
        c = 0.4/3*cos(x1 - x3);
        [1.4, a, c; a, 1.9, b; c, b, 2.4]
    """,
    "P4": BUMP,
    "P6": "phi(4/(1 + x1^2 + x2^2)^2)",
}


def version() -> str:
    """Tautline and NumPy."""
    return f"tautline {tautline.__version__}, numpy {np.__version__}"


def sine_projections(x: np.ndarray) -> np.ndarray:
    """The matrix of P5."""
    waves = np.sin(WAVES @ x)
    return np.eye(8) + 0.5 * (DIRECTIONS.T * waves**2) @ DIRECTIONS


def metric(problem: Problem) -> tautline.Metric:
    """The metric: a text, or for P5 a function that is traced."""
    what = TEXTS.get(problem.name, sine_projections)
    return tautline.Metric(what, problem.dimension)


def set_of(given: Ball | HalfSpace | None, point: tuple[float, ...]) -> tautline.Set:
    """An end, as a set."""
    if isinstance(given, Ball):
        return tautline.ball(given.centre, given.radius)
    if isinstance(given, HalfSpace):
        normal = [0.0] * len(point)
        normal[given.axis] = 1.0
        return tautline.half_space(normal, at_least=given.bound)
    return tautline.point(point)


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Parses the metric. It starts from the straight line, and stops by its own rule."""
    given = metric(problem)
    first = set_of(problem.first_set, problem.start)
    last = set_of(problem.last_set, problem.stop)
    line = [problem.line(1)]

    def solve() -> Solution:
        curve = tautline.solve(
            given, first, last, n=n, starts=line, only_these_starts=True, threads=1
        )
        return Solution(curve.newton_steps, f"{curve.stop}, {curve.hessian}", curve.points)

    return solve
