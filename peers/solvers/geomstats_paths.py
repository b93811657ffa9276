"""Geomstats: discrete path straightening under a custom metric.

Its own path energy reads the metric at the beginning of each chord; here it reads it at the
middle, so that it minimises the discrete energy that the others minimise, up to a factor 1/2.
"""

from __future__ import annotations

import os
from typing import Any, Callable

# Before it is loaded: the default backend cannot differentiate.
os.environ["GEOMSTATS_BACKEND"] = "autograd"

import geomstats
import geomstats.backend as gs
import numpy as np
from geomstats.geometry.euclidean import Euclidean
from geomstats.geometry.riemannian_metric import RiemannianMetric
from geomstats.numerics.finite_differences import forward_difference
from geomstats.numerics.geodesic import PathStraightening
from geomstats.numerics.optimization import ScipyMinimize
from geomstats.numerics.path import UniformlySampledPathEnergy

from measurement import NotApplicable, Solution
from problems import Problem


class Metric(RiemannianMetric):
    """The metric of a problem."""

    def __init__(self, space: Any, problem: Problem) -> None:
        super().__init__(space)
        self.problem = problem

    def squared_norm(self, vector: Any, base_point: Any = None) -> Any:
        """The square speed at many points: all that path straightening needs of a metric."""
        coordinates_first = (gs.transpose(array) for array in (base_point, vector))
        return self.problem.square_speed(*coordinates_first, gs)


class MidpointEnergy(UniformlySampledPathEnergy):
    """Half the discrete energy."""

    def energy_per_time(self, path: Any) -> Any:
        """The term of each chord."""
        velocity = forward_difference(path, axis=-2)
        middles = (path[..., 1:, :] + path[..., :-1, :]) / 2
        return self._space.metric.squared_norm(velocity, middles) / (2 * (path.shape[-2] - 1))


def version() -> str:
    """Geomstats."""
    return f"geomstats {geomstats.__version__}"


def prepare(problem: Problem, n: int, tolerance: float) -> Callable[[], Solution]:
    """Makes the space."""
    if not problem.fixed_ends:
        raise NotApplicable("joins points, not sets")
    space = Euclidean(problem.dimension, equip=False)
    space.equip_with_metric(Metric, problem=problem)
    # Half the energy has half the gradient.
    options = {"gtol": tolerance / 2, "ftol": 0.0, "maxiter": 10**7, "maxfun": 10**8}
    optimizer = ScipyMinimize(
        method="L-BFGS-B", autodiff_jac=True, options=options, save_result=True
    )
    solver = PathStraightening(
        space, path_energy=MidpointEnergy(space), n_nodes=n + 1, optimizer=optimizer
    )
    start, stop = gs.array(problem.start), gs.array(problem.stop)

    def solve() -> Solution:
        path = solver.discrete_geodesic_bvp(stop, start)
        found = optimizer.result_
        return Solution(found.nit, found.message, np.asarray(path))

    return solve
