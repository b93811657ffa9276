"""CasADi with IPOPT: all points as unknowns, exact sparse Hessian, sets as constraints."""

from __future__ import annotations

from typing import Callable

import casadi as ca
import numpy as np

from measurement import Solution
from problems import Problem
from solvers import casadi_energy


def version() -> str:
    """CasADi with its bundled IPOPT."""
    return f"casadi {ca.__version__}"


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Builds the program and its derivatives."""
    points = ca.MX.sym("x", problem.dimension, n + 1)
    chord = casadi_energy.chord_energy(problem, n).map(n)
    program = {"x": ca.vec(points), "f": ca.sum2(chord(points[:, :-1], points[:, 1:]))}
    line = problem.line(n)
    low, high = np.full_like(line, -np.inf), np.full_like(line, np.inf)
    bounds = {}
    if problem.first_set is None or problem.last_set is None:
        # IPOPT removes variables with equal bounds from the problem.
        for end in (0, -1):
            low[end] = high[end] = line[end]
    else:
        offset = points[:, 0] - ca.DM(problem.first_set.centre)
        program["g"] = ca.sumsqr(offset)
        bounds = {"lbg": -np.inf, "ubg": problem.first_set.radius ** 2}
        low[-1, problem.last_set.axis] = problem.last_set.bound
    options = {
        "print_time": False,
        "ipopt": {
            "print_level": 0,
            "sb": "yes",
            # Without scaling the tolerance is that of the comparison.
            "nlp_scaling_method": "none",
            "tol": tolerance,
            "acceptable_iter": 0,
        },
    }
    solver = ca.nlpsol("solver", "ipopt", program, options)

    def solve() -> Solution:
        found = solver(x0=line.ravel(), lbx=low.ravel(), ubx=high.ravel(), **bounds)
        statistics = solver.stats()
        result = found["x"].full().reshape(line.shape)
        return Solution(statistics["iter_count"], statistics["return_status"], result)

    return solve
