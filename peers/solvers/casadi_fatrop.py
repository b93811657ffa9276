"""CasADi with FATROP: an optimal control problem, whose stages are the points.

The state of stage k is the point x_k, its control the chord u_k to the next point.
"""

from __future__ import annotations

from typing import Callable

import casadi as ca
import numpy as np

from measurement import Solution
from problems import Problem
from solvers import casadi_energy


def version() -> str:
    """CasADi with its bundled FATROP."""
    return f"casadi {ca.__version__}"


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Builds the program, in the order of its stages, and its derivatives."""
    d = problem.dimension
    chord = casadi_energy.chord_energy(problem, n).map(n)
    stages, last = ca.MX.sym("z", 2 * d, n), ca.MX.sym("last", d)
    states, chords = stages[:d, :], stages[d:, :]
    following = ca.horzcat(states[:, 1:], last)
    gaps = following - states - chords
    # The constraints of a stage come after its gap; only the first and the last have any.
    if problem.first_set is None or problem.last_set is None:
        at_first, at_last = states[:, 0], last
        limits = [(value, value) for value in (*problem.start, *problem.stop)]
    else:
        at_first = ca.sumsqr(states[:, 0] - ca.DM(problem.first_set.centre))
        at_last = last[problem.last_set.axis]
        limits = [(-np.inf, problem.first_set.radius ** 2), (problem.last_set.bound, np.inf)]
    count = at_first.numel()
    constraints = ca.vertcat(gaps[:, 0], at_first, ca.vec(gaps[:, 1:]), at_last)
    zeros = [(0.0, 0.0)]
    limits = zeros * d + limits[:count] + zeros * (d * (n - 1)) + limits[count:]
    low, high = map(np.array, zip(*limits))
    program = {
        "x": ca.vertcat(ca.vec(stages), last),
        "f": ca.sum2(chord(states, states + chords)),
        "g": constraints,
    }
    options = {
        "print_time": False,
        "structure_detection": "manual",
        "N": n,
        "nx": [d] * (n + 1),
        "nu": [d] * n + [0],
        "ng": [count] + [0] * (n - 1) + [count],
        "equality": (low == high).tolist(),
        "fatrop": {"print_level": 0, "tol": tolerance},
    }
    solver = ca.nlpsol("solver", "fatrop", program, options)
    line = problem.line(n)
    start = np.append(np.hstack([line[:-1], np.diff(line, axis=0)]).ravel(), line[-1])

    def solve() -> Solution:
        found = solver(x0=start, lbg=low, ubg=high)
        statistics = solver.stats()
        values = found["x"].full().ravel()
        inner = values[:-d].reshape(n, 2 * d)[:, :d]
        result = np.vstack([inner, values[-d:]])
        return Solution(statistics["iter_count"], statistics["unified_return_status"], result)

    return solve
