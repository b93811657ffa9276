"""The discrete energy in CasADi, shared by the peers that use it."""

from __future__ import annotations

import casadi as ca

from problems import Problem


def chord_energy(problem: Problem, n: int) -> ca.Function:
    """The term of one of n chords in the discrete energy, from both of its ends."""
    a, b = ca.SX.sym("a", problem.dimension), ca.SX.sym("b", problem.dimension)
    return ca.Function("chord", [a, b], [n * problem.square_speed((a + b) / 2, b - a, ca)])
