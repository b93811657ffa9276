"""The discrete energy in JAX, shared by the peers that differentiate it."""

from __future__ import annotations

from typing import Callable

import jax
import jax.numpy as jnp
import numpy as np

from problems import Problem

# Set before any array is made; JAX computes in single precision otherwise.
jax.config.update("jax_enable_x64", True)


def chord_energy(problem: Problem, n: int) -> Callable[[jax.Array, jax.Array], jax.Array]:
    """The term of one of n chords in the discrete energy."""
    return lambda a, b: n * problem.square_speed((a + b) / 2, b - a, jnp)


# A free end has its own coordinates, in place of the D of an inner point.  P4 has
# its ends at the boundaries of both sets: the angle on the circle, the height on the line.  Which
# boundary is active is put in by hand.


def first_point(problem: Problem) -> Callable[[jax.Array], jax.Array]:
    """The first point as a function of its coordinates."""
    if problem.first_set is None:
        return lambda z: jnp.array(problem.start)
    ball = problem.first_set
    turn = lambda angle: jnp.stack([jnp.cos(angle), jnp.sin(angle)])
    return lambda z: jnp.array(ball.centre) + ball.radius * turn(z[0])


def last_point(problem: Problem) -> Callable[[jax.Array], jax.Array]:
    """The last point as a function of its coordinates."""
    if problem.last_set is None:
        return lambda z: jnp.array(problem.stop)
    bound = problem.last_set.bound
    return lambda z: jnp.stack([bound, z[1]])


def idle(problem: Problem) -> tuple[np.ndarray, np.ndarray]:
    """Ones for the unused coordinates of the first and the last point."""
    if problem.fixed_ends:
        return np.ones(problem.dimension), np.ones(problem.dimension)
    return np.array([0.0, 1.0]), np.array([1.0, 0.0])


def start(problem: Problem, n: int) -> np.ndarray:
    """The straight line, its ends in their coordinates."""
    z = problem.line(n)
    if problem.first_set is not None:
        offset = z[0] - np.array(problem.first_set.centre)
        z[0] = np.arctan2(offset[1], offset[0]), 0.0
    return z


def points(problem: Problem, z: np.ndarray) -> np.ndarray:
    """The points of a solution."""
    ends = first_point(problem)(z[0])[None], last_point(problem)(z[-1])[None]
    return np.concatenate([ends[0], z[1:-1], ends[1]])
