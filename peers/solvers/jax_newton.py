"""JAX and a banded solver: a fast solver written by hand.

Newton's method with the Hessians of the chords by JAX and a banded Cholesky factorisation by
LAPACK; the Hessian is shifted until it is positive definite, and steps are shortened until the
energy falls.
"""

from __future__ import annotations

from typing import Callable

import jax
import jax.numpy as jnp
import numpy as np
import scipy
from scipy.linalg import LinAlgError, solveh_banded

from measurement import Solution
from problems import Problem
from solvers import jax_energy


def version() -> str:
    """JAX and SciPy."""
    return f"jax {jax.__version__}, scipy {scipy.__version__}"


def derivatives(problem: Problem, n: int) -> tuple[Callable, Callable]:
    """The energy; and the gradient with the upper band of the Hessian, both compiled."""
    d = problem.dimension
    chord = jax_energy.chord_energy(problem, n)
    first, last = jax_energy.first_point(problem), jax_energy.last_point(problem)
    # The first and the last chord depend on the coordinates of the ends, the others on points.
    opening, closing = (lambda a, b: chord(first(a), b)), (lambda a, b: chord(a, last(b)))

    def per_chord(z: jax.Array, transform: Callable) -> jax.Array:
        inner = jax.vmap(transform(chord))(z[1:-2], z[2:-1])
        opened, closed = transform(opening)(z[0], z[1]), transform(closing)(z[-2], z[-1])
        join = lambda *parts: jnp.concatenate([parts[0][None], parts[1], parts[2][None]])
        return jax.tree.map(join, opened, inner, closed)

    @jax.jit
    def energy(z: jax.Array) -> jax.Array:
        return per_chord(z, lambda f: f).sum()

    @jax.jit
    def slopes(z: jax.Array) -> tuple[jax.Array, jax.Array]:
        to_first, to_last = per_chord(z, lambda f: jax.grad(f, argnums=(0, 1)))
        gradient = jnp.zeros_like(z).at[:-1].add(to_first).at[1:].add(to_last)
        (aa, ab), (_, bb) = per_chord(z, lambda f: jax.hessian(f, argnums=(0, 1)))
        diagonal = jnp.zeros((n + 1, d, d)).at[:-1].add(aa).at[1:].add(bb)
        at_first, at_last = jax_energy.idle(problem)
        diagonal = diagonal.at[0].add(jnp.diag(at_first)).at[-1].add(jnp.diag(at_last))
        beside = jnp.concatenate([jnp.zeros((1, d, d)), ab])
        # Column c of block column k, and k rows above the diagonal: in the block of the diagonal,
        # in the one above it, or outside of the band.
        entry = lambda k, c: (
            diagonal[:, c - k, c]
            if k <= c
            else beside[:, c - k + d, c] if k <= c + d else jnp.zeros(n + 1)
        )
        rows = [
            jnp.stack([entry(k, c) for c in range(d)], axis=1).ravel()
            for k in range(2 * d - 1, -1, -1)
        ]
        return gradient, jnp.stack(rows)

    return energy, slopes


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Compiles both functions."""
    start = jax_energy.start(problem, n)
    energy, slopes = derivatives(problem, n)
    jax.block_until_ready((energy(start), slopes(start)))
    return lambda: newton(problem, energy, slopes, start, tolerance)


def newton(
    problem: Problem, energy: Callable, slopes: Callable, start: np.ndarray, tolerance: float
) -> Solution:
    """Newton's method from the straight line."""
    z, value, shift, stop = start, float(energy(start)), 0.0, "iteration limit"
    noise = 1e-16 * len(start)
    for iteration in range(200):
        gradient, band = map(np.asarray, slopes(z))
        if np.abs(gradient).max() <= tolerance:
            stop = "gradient small"
            break
        # The lowest eigenvalues are about 1/N^2 of the entries on the diagonal.
        least = np.abs(band[-1]).mean() / len(start) ** 2
        while True:
            try:
                shifted = band.copy()
                shifted[-1] += shift
                step = -solveh_banded(
                    shifted, gradient.ravel(), overwrite_ab=True, check_finite=False
                ).reshape(z.shape)
                break
            except LinAlgError:
                shift = max(4 * shift, least)
        slope, length = float((gradient * step).sum()), 1.0
        # Rounding of the points, about 10^-16 of them, is N times that of a chord, and so of the
        # energy: below that every step may be taken.
        while True:
            trial = z + length * step
            new = float(energy(trial))
            if new <= value + 1e-4 * length * slope + noise * abs(value) or length < 1e-10:
                break
            length /= 2
        z, value = trial, new
        shift = shift / 8 if shift > least else 0.0
    return Solution(iteration, stop, jax_energy.points(problem, z))
