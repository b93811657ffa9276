"""The discrete energy in CasADi, shared by the peers that use it."""

from __future__ import annotations

import casadi as ca

from problems import Problem


def chord_energy(problem: Problem, n: int) -> ca.Function:
    """What one of n chords adds to the discrete energy, from both of its ends."""
    a, b = ca.SX.sym("a", problem.dimension), ca.SX.sym("b", problem.dimension)
    rows = problem.gram(ca.vertsplit((a + b) / 2), ca)
    gram = ca.vertcat(*[ca.horzcat(*row) for row in rows])
    return ca.Function("chord", [a, b], [n * ca.bilin(gram, b - a, b - a)])
