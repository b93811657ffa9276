"""SciPy's solve_bvp for the geodesic equation, with its derivatives by JAX.

It discretises the continuous problem on a mesh of its own, so that its energy is an
approximation of d^2 and not of the discrete minimum.
"""

from __future__ import annotations

from typing import Any, Callable

import jax
import jax.numpy as jnp
import numpy as np
import scipy
from scipy.integrate import solve_bvp

from measurement import Solution
from problems import Problem

# Set before any array is made; JAX computes in single precision otherwise.
jax.config.update("jax_enable_x64", True)

# The points of the first mesh, a straight line, and the most of any mesh.
FIRST_MESH, LARGEST_MESH = 101, 100_000

# From loose to strict; the first that is as accurate as the grid of N chords is timed.
TOLERANCES = (1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9)


def version() -> str:
    """SciPy and JAX."""
    return f"scipy {scipy.__version__}, jax {jax.__version__}"


def equation(problem: Problem) -> tuple[Callable, Callable]:
    """The geodesic equation as a system of first order, and its Jacobian."""
    d = problem.dimension

    def momentum(x: jax.Array, v: jax.Array) -> jax.Array:
        # H v, of which d/dt (2 H v) = grad_x (v^T H v) is the geodesic equation.
        return jax.grad(lambda v: problem.square_speed(x, v, jnp))(v) / 2

    def slope(y: jax.Array) -> jax.Array:
        x, v = y[:d], y[d:]
        force = jax.grad(lambda x: problem.square_speed(x, v, jnp))(x) / 2
        _, turning = jax.jvp(lambda x: momentum(x, v), (x,), (v,))
        gram = jax.jacfwd(lambda v: momentum(x, v))(v)
        return jnp.concatenate([v, jnp.linalg.solve(gram, force - turning)])

    right = jax.jit(jax.vmap(slope, in_axes=1, out_axes=1))
    jacobian = jax.jit(jax.vmap(jax.jacfwd(slope), in_axes=1, out_axes=2))
    return (lambda _, y: np.asarray(right(y))), (lambda _, y: np.asarray(jacobian(y)))


def boundary(problem: Problem) -> Callable[[np.ndarray, np.ndarray], np.ndarray]:
    """The conditions at both ends; where an end is free, it leaves its set orthogonally."""
    d = problem.dimension
    if problem.first_set is None or problem.last_set is None:
        start, stop = np.array(problem.start), np.array(problem.stop)
        return lambda a, b: np.concatenate([a[:d] - start, b[:d] - stop])
    ball, half_space = problem.first_set, problem.last_set
    momentum = jax.jit(jax.grad(lambda x, v: problem.square_speed(x, v, jnp), argnums=1))

    def free(a: np.ndarray, b: np.ndarray) -> np.ndarray:
        offset = a[:2] - np.array(ball.centre)
        momenta = [momentum(y[:2], y[2:]) for y in (a, b)]
        return np.array(
            [
                offset @ offset - ball.radius**2,
                offset[0] * momenta[0][1] - offset[1] * momenta[0][0],
                b[0] - half_space.bound,
                momenta[1][1],
            ]
        )

    return free


def curve_energy(problem: Problem, found: Any) -> float:
    """The energy of the curve, by eight nodes of Gauss on each interval of its mesh."""
    nodes, weights = np.polynomial.legendre.leggauss(8)
    half = np.diff(found.x) / 2
    t = (found.x[:-1] + half)[:, None] + half[:, None] * nodes
    y = found.sol(t.ravel())
    speeds = problem.square_speed(y[: problem.dimension], y[problem.dimension :], np)
    return float((half[:, None] * weights).ravel() @ speeds)


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Compiles, and finds the loosest tolerance that is as accurate as N chords."""
    right, jacobian = equation(problem)
    ends = boundary(problem)
    t = np.linspace(0.0, 1.0, FIRST_MESH)
    line = problem.line(FIRST_MESH - 1).T
    guess = np.vstack([line, np.gradient(line, t, axis=1)])

    def solve(setting: float) -> Solution:
        found = solve_bvp(
            right, ends, t, guess, fun_jac=jacobian, tol=setting, max_nodes=LARGEST_MESH
        )
        stop = f"{found.message} tol {setting:.0e}, {found.x.size} nodes"
        value = curve_energy(problem, found)
        return Solution(found.niter, stop, energy=value, success=found.success)

    wanted = abs(problem.discretisation) / n**2
    for setting in TOLERANCES:
        solution = solve(setting)
        if solution.success and abs(solution.energy - problem.distance_squared) <= wanted:
            return lambda: solve(setting)
        # Another geodesic does not become the right one when it is computed more accurately.
        if abs(solution.energy / problem.distance_squared - 1.0) > 0.1 and solution.success:
            break
    return lambda: solve(setting)
