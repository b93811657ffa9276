"""SciPy's L-BFGS-B, with the gradient by JAX."""

from __future__ import annotations

from typing import Callable

import jax
import jax.numpy as jnp
import numpy as np
import scipy
from scipy.optimize import minimize

from measurement import Solution
from problems import Problem
from solvers import jax_energy


def version() -> str:
    """SciPy and JAX."""
    return f"scipy {scipy.__version__}, jax {jax.__version__}"


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Compiles energy and gradient."""
    start = jax_energy.start(problem, n)
    chords = jax.vmap(jax_energy.chord_energy(problem, n))
    first, last = jax_energy.first_point(problem), jax_energy.last_point(problem)

    def energy(flat: jax.Array) -> jax.Array:
        z = flat.reshape(start.shape)
        points = jnp.concatenate([first(z[0])[None], z[1:-1], last(z[-1])[None]])
        return chords(points[:-1], points[1:]).sum()

    both = jax.jit(jax.value_and_grad(energy))
    jax.block_until_ready(both(start.ravel()))

    def value_and_gradient(flat: np.ndarray) -> tuple[float, np.ndarray]:
        value, gradient = both(flat)
        return float(value), np.asarray(gradient)

    # `gtol` is the rule of the comparison: the largest component of the gradient.
    options = {"gtol": tolerance, "ftol": 0.0, "maxiter": 10**7, "maxfun": 10**8, "maxcor": 20}

    def solve() -> Solution:
        found = minimize(
            value_and_gradient, start.ravel(), jac=True, method="L-BFGS-B", options=options
        )
        z = found.x.reshape(start.shape)
        return Solution(found.nit, found.message, jax_energy.points(problem, z))

    return solve
